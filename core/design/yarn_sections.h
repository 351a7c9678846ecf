// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How thick the yarns are, free and in the fabric: linear density is kept, the fabric's thickness limits the height of the sections,
// the sett their width. Lengths in mm.
#pragma once

#include "core/design/design.h"
#include "core/design/interlacing.h"

namespace hygroloom {

constexpr double widest_share_of_pitch = 0.98; ///< neighbours leave this much of the pitch to one yarn at most
constexpr double densest_packing = 0.85;       ///< fibre volume / yarn volume that a squeezed yarn can reach

/// A free yarn, all three values in agreement.
struct FreeYarn {
    double diameter = 0; ///< mm
    double linear_density_tex = 0;
    double packing_factor = 0;
};

/// The missing values from the given ones: tex = packing x density x pi d2 / 4. Precondition: a diameter or a linear density is given.
FreeYarn free_yarn(const Yarn& yarn, double fibre_density_kg_m3);

struct FittedYarn {
    Section section;           ///< mm, in the fabric
    double packing_factor = 0; ///< in the fabric; above densest_packing the fabric cannot be woven
    bool flattened = false;    ///< by the thickness
    bool narrowed = false;     ///< by the neighbours
};

/// warp and weft as they lie in the fabric.
struct FittedYarns {
    FittedYarn warp;
    FittedYarn weft;
    double available_height = 0; ///< mm, thickness less the loops on both faces; 0 when no thickness is given
};
FittedYarns fit_yarns(const Fabric& fabric, const FreeYarn& warp, const FreeYarn& weft);

} // namespace hygroloom
