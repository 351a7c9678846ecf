// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Cheap bounds on what an experiment can do to a textile. Each is a number that people can check.
#pragma once

#include "core/geometry/textile.h"
#include "core/physics/liquid.h"

#include <limits>

namespace hygroloom {

struct Bounds {
    double delivered = 0;           ///< kg that come as liquid
    double at_stake = 0;            ///< kg that what is left out is compared with
    double capacity = 0;            ///< kg/m2 that the wicking yarns' pores hold, at least, where liquid is
    double wet_area = 0;            ///< m2 that can get wet, or that the air works on
    double sorbable = 0;            ///< kg the fibres of that area can take or give
    double evaporated = 0;          ///< kg from both its faces in the duration, or condensed on all of the sample
    double temperature_rise = 0;    ///< K if all sorbed at once and nothing escaped
    double wet_bulb_depression = 0; ///< K, at most, by evaporation; or by how much condensation warms
    double slowed = 0;              ///< share of the evaporation that this holds back
    double finest = 0;              ///< m, height of the thinnest yarn
    std::size_t drops = 0;          ///< that fall
    double smallest_angle = 180;    ///< degrees, of contact
    double suction = 0;             ///< its cosine; 0: no yarn wicks
    double uptake = 0;              ///< m3/s: see SceneCounts
    double pores = 0;               ///< m: see SceneCounts
    double cover = 0;               ///< share of the area under yarns
    double advancing_deg = 0;       ///< that a drop shows on the upper face while it spreads
    LiquidAt liquid{};
    double holes_hold = std::numeric_limits<double>::infinity(); ///< Pa that each hole between yarns bears
    bool wicks = false;
    bool condenses = false; ///< vapour of air that is more than saturated, on all of the cloth
};

Bounds find_bounds(const Design& design, const Textile& textile, const Experiment& experiment);

} // namespace hygroloom
