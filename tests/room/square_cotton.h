// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Cloths whose rooms are drawn in tests.
#pragma once

#include "core/verify/set_ups.h"

#include <cmath>

namespace hygroloom {

struct SquareCotton {
    double warp_tex = 20, weft_tex = 20;
    double threads_per_cm = 24;
    double scale = 1; ///< of all lengths
};
inline Textile patch_of(const Fabric& fabric)
{
    Design design;
    design.fabrics = {fabric};
    return build_textile(design, design.fabrics[0], {0, 0, 20, 20});
}
inline Textile square_cotton(const Weave& weave, const SquareCotton& like = {})
{
    Fabric fabric;
    fabric.name = "Square";
    for (Yarn* yarn : {&fabric.warp, &fabric.weft}) {
        *yarn = Yarn{};
        yarn->material = {{"cotton"}};
        yarn->linear_density_tex = (yarn == &fabric.warp ? like.warp_tex : like.weft_tex) * like.scale * like.scale;
        yarn->packing_factor = 0.5;
        yarn->diameter_mm.reset();
    }
    fabric.ends_per_cm = fabric.picks_per_cm = like.threads_per_cm / like.scale;
    fabric.weave = weave;
    return patch_of(fabric);
}
inline Textile square_cotton(const std::string& weave, const SquareCotton& like = {})
{
    return square_cotton(weave_from_pattern(weave), like);
}

inline bool near_to(double a, double b, double share) { return std::abs(a - b) <= share * std::abs(b); }

} // namespace hygroloom
