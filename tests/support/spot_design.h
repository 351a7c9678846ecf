// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Cloth with a spot of water on it, for tests.
#pragma once

#include "tests/support/drop_design.h"

#include <string>

namespace hygroloom {

/// A pool of 1 ul in the middle of a small sample of one fibre, as the experiment "drop"; in still air of 21 C.
inline Design spot_design(const char* fibre, double humidity, double duration)
{
    Design design = drop_design(fibre == std::string("cotton") ? 35 : 20);
    design.fabrics[0].warp.material = design.fabrics[0].weft.material = {{fibre, 1.0}};
    Experiment experiment = standard_experiment(ExperimentType::horizontal_wicking);
    experiment.closure = Closure::paper; // its stain goes on growing
    experiment.name = "drop";
    experiment.volume_ul = 1;
    experiment.sample_mm = {16, 16};
    experiment.duration_s = duration;
    experiment.climate = {21, humidity, 0};
    design.experiments = {experiment};
    return design;
}

} // namespace hygroloom
