// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How near a sett is to the closest that can be woven, by two rules of the trade. Yarns flatten, so real cloth passes 100 %.
#pragma once

#include "core/design/yarn_sections.h"

namespace hygroloom {

constexpr double usual_share_of_ashenhurst = 0.75; ///< three quarters of the limit are usual for a firm cloth

struct JamOfSystem {
    double sett_per_cm = 0;
    double ashenhurst_per_cm = 0; ///< the limit: yarns side by side, with room for the other system's yarn wherever they change sides
    double ashenhurst_percent = 0;
    double peirce_per_cm = 0; ///< the limit: round arcs touching, with the other system at its own sett
    double peirce_percent = 0;
};

struct JamGauge {
    JamOfSystem warp;
    JamOfSystem weft;
};

/// Ashenhurst (1884), T = D r/(r + i), with the diameters of both systems: 10 r / (r own + i other) per cm. Peirce (1937), jammed round
/// yarns: cos a + cos b = 1 for the weave angles a, b of the two systems; carried over to weaves with floats as by Love (1954): where a
/// yarn passes over several, they lie side by side. Diameters are those of the free yarns, in mm.
JamGauge jam_gauge(const Weave& weave, double ends_per_cm, double picks_per_cm, double warp_diameter_mm, double weft_diameter_mm);

/// With the mean diameters of the free yarns, in the order they come in.
JamGauge jam_gauge(const Fabric& fabric, const FittedYarns& yarns);

} // namespace hygroloom
