// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A woven fabric as a designer gives it: two yarns, a weave, a sett.
#pragma once

#include "core/design/weave.h"
#include "core/design/yarn.h"

namespace hygroloom {

struct Flyaway {
    double loop_density_per_mm = 0;
    double hair_density_per_mm = 0;
    double loop_height_mm = 0;
    double hair_length_mm = 0;
    bool operator==(const Flyaway&) const = default;
};

/// Values a laboratory measured, which replace the derived ones.
struct Measured {
    std::optional<double> porosity;
    std::optional<double> areal_density_g_m2;
    std::optional<double> capillary_radius_um;
    std::optional<double> tortuosity;
    std::optional<double> crimp_percent;
    bool operator==(const Measured&) const = default;
};

struct YarnRun {
    int yarn = 0;  ///< 0: the fabric's own warp (weft) yarn, n: extra_yarns[n - 1]
    int count = 1;
    bool operator==(const YarnRun&) const = default;
};

struct Fabric {
    std::string name;
    Yarn warp;
    Yarn weft;
    std::vector<Yarn> extra_yarns;
    std::vector<YarnRun> warp_order, weft_order; ///< empty: all alike; repeats
    Weave weave;
    double ends_per_cm = 20;
    double picks_per_cm = 20;
    std::optional<double> thickness_mm;
    Flyaway flyaway;
    std::optional<double> contact_angle_deg;   ///< of the finish; without it, each yarn's fibres
    Measured measured;
    bool operator==(const Fabric&) const = default;
};

} // namespace hygroloom
