// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The shape of a stain, which a step's length may not give.
#include "core/base/error.h"
#include "core/run/plan_run.h"
#include "core/verify/set_ups.h"
#include "core/verify/verify.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

/// change: of saturation, that steps aim at.
StainShape shape_of(const Design& design, Backend& backend, double change)
{
    const WholeRun run = run_whole(design, Fidelity::draft, backend, {{"saturation_change", change}});
    if (!run.metrics.shape) throw Error("stain_shape: fewer than 12 crossings are wet, which have no shape. A larger volume_ul wets more.");
    return *run.metrics.shape;
}

std::vector<VerifyResult> drop_stain(const VerifyValues& v, Backend& backend)
{
    Experiment experiment = standard_experiment(ExperimentType::droplet);
    const double volume = value(v, "volume_ul"), side = 12 * std::cbrt(volume); // mm, which a stain of as much stays within
    experiment.sample_mm = {side, side};
    experiment.droplets.resize(1);
    experiment.droplets[0].volume_ul = volume;
    experiment.duration_s = value(v, "time_s");
    const Design design = design_of(of_even_yarns(library_fabric(v.at("fabric").word)), experiment);
    const double usual = knobs_of(Fidelity::draft).saturation_change;
    const StainShape coarse = shape_of(design, backend, usual), fine = shape_of(design, backend, 0.5 * usual);
    return {{"aspect", coarse.aspect, fine.aspect, 0.02 * fine.aspect},
            {"armness", coarse.armness, fine.armness, 0.01},
            {"solidity", coarse.solidity, fine.solidity, 0.02}};
}

} // namespace

std::vector<VerifyCase> stain_cases()
{
    return {{"stain_shape",
             "The stain of a drop: how long it is, how far from an ellipse, and how full, against steps half as long.",
             {{"fabric", 0, 0, 0, "Poplin shirting"}, {"volume_ul", 6, 1, 500, ""}, {"time_s", 10, 0.1, 600, ""}},
             drop_stain}};
}

} // namespace hygroloom
