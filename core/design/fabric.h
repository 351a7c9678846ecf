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

/// Consecutive ends or picks of one yarn. Yarn 0 is the fabric's own warp or weft, n is extra_yarns[n - 1].
struct YarnRun {
    int yarn = 0;
    int count = 1;
    bool operator==(const YarnRun&) const = default;
};

constexpr std::size_t most_extra_yarns = 250;
constexpr int largest_yarn_order = 100000; ///< ends or picks of one period

/// Values a laboratory measured, which replace the derived ones.
struct Measured {
    std::optional<double> porosity;
    std::optional<double> areal_density_g_m2;
    std::optional<double> tortuosity;
    std::optional<double> crimp_percent;
    bool operator==(const Measured&) const = default;
};

/// By how much an input may be off either way, as the user knows it; 0: it is known. Without it the range is a typical one, see
/// unknown_inputs().
struct Uncertainty {
    std::optional<double> contact_angle_deg;
    std::optional<double> receding_angle_deg;
    std::optional<double> packing_factor;
    bool operator==(const Uncertainty&) const = default;
};

/// Which measurement a fabric's fitted inputs come from, see core/analysis/calibration.h. It acts on nothing.
struct Calibrated {
    /// The inputs that were fitted, as they were before.
    struct Before {
        std::optional<double> contact_angle_deg;
        std::optional<double> receding_angle_deg;
        std::optional<double> packing_factor;
        bool operator==(const Before&) const = default;
    };
    std::string file, experiment, fidelity;
    std::string quantity;    ///< key of the series, or "metrics"
    double residual_rms = 0; ///< in the quantity's unit; of metrics in their spreads
    Before before;
    bool operator==(const Calibrated&) const = default;
};

/// The cloth as the loom makes it; the fabric's own setts are the finished cloth's. What is missing follows: see
/// core/laboratory/technical.h.
struct Loom {
    std::optional<double> ends_per_cm, picks_per_cm;
    std::optional<double> reed_width_cm;
    std::optional<int> ends_per_dent;
    bool operator==(const Loom&) const = default;
};

constexpr double default_finish_depth = 0.10; ///< of the thickness, as foam and print reach; an assumption

struct Fabric {
    std::string name;
    Yarn warp;
    Yarn weft;
    Weave weave;
    double ends_per_cm = 20;
    double picks_per_cm = 20;
    std::vector<Yarn> extra_yarns;   ///< for stripes and checks
    std::vector<YarnRun> warp_order; ///< one period, from end 0; empty: all ends alike
    std::vector<YarnRun> weft_order;
    std::optional<double> thickness_mm;
    std::optional<double> warp_crimp_percent; ///< set; without it warp and weft share the crimp: see fit_yarns()
    std::optional<double> weft_crimp_percent;
    Flyaway flyaway;
    std::optional<double> contact_angle_deg; ///< of the finish; without it, each yarn's fibres
    std::optional<double> finish_face;       ///< contact angle, degrees, of what lies on the upper face; without it, the yarns' own
    std::optional<double> finish_back;       ///< the same of the lower face
    std::optional<double> finish_depth;      ///< of both, share of the thickness; without it default_finish_depth
    std::optional<double> finish_holes;      ///< share of the crowns and hairs under them that is untreated; without it none
    Measured measured;
    Uncertainty uncertainty;
    Loom loom;
    std::optional<Calibrated> calibrated;
    bool operator==(const Fabric&) const = default;
};

/// A fabric's warp, its weft, then its extra yarns.
inline std::vector<Yarn*> yarns_of(Fabric& fabric)
{
    std::vector<Yarn*> yarns{&fabric.warp, &fabric.weft};
    for (Yarn& yarn : fabric.extra_yarns) yarns.push_back(&yarn);
    return yarns;
}

/// The fabric's own warp or weft, or an extra yarn. Precondition: 0 <= yarn <= extra_yarns.size().
inline const Yarn& yarn_in(const Fabric& fabric, bool warp, int yarn)
{
    if (yarn > 0) return fabric.extra_yarns[static_cast<std::size_t>(yarn - 1)];
    return warp ? fabric.warp : fabric.weft;
}

} // namespace hygroloom
