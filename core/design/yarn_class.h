// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How a yarn is made, and what of it follows where nobody says: how close its fibres are packed and how far they stand out of the cloth.
#pragma once

#include "core/design/design.h"

#include <array>

namespace hygroloom {

struct YarnClassInfo {
    const char* name;  ///< in project files
    const char* title; ///< in sentences
    double packing;    ///< in the yarn, where none is given; of ring spun yarn at a twist factor of 3800
    double surface_mm; ///< of fibres that stand out, both faces together, under 1 kPa; an assumption
};

/// In the order of YarnClass. Packings and surfaces are assumptions of usual yarns.
constexpr std::array<YarnClassInfo, yarn_classes> yarn_class_infos{{
    {"ring", "ring spun", 0.60, 0.02},
    {"rotor", "rotor or air-jet spun", 0.55, 0.03},
    {"plied", "plied", 0.58, 0.02},
    {"flat", "flat filament", 0.70, 0},
    {"textured", "textured filament", 0.50, 0.02},
    {"monofilament", "monofilament", 0.99, 0}, // the closest that is allowed
}};
constexpr const YarnClassInfo& info_of(YarnClass kind) { return yarn_class_infos[static_cast<std::size_t>(kind)]; }

/// As the yarn says; else one of filaments is flat from a packing of 0.6 on, given or assumed, and textured below; of staple yarns several
/// plies make a plied one, and one a ring spun one.
YarnClass yarn_class_of(const Design& design, const Yarn& yarn);

/// As given; of a yarn of given diameter default_packing_factor; else that of its class: of ring spun yarn 0.60 (t/3800)^1/4 from 0.45 to
/// 0.68, t its twist times the root of its tex, an assumption; of flat silk 0.65. Trilobal fibres are packed 0.75 times as close,
/// channelled ones 0.65 times.
double packing_of(const Design& design, const Yarn& yarn);

} // namespace hygroloom
