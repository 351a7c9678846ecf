// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A small project for runs: one drop on cotton, quick to simulate.
#pragma once

#include "core/design/design.h"

namespace hygroloom {

inline Design drop_design(double contact_angle = 35, double duration = 0.5)
{
    Design design;
    Fabric fabric;
    fabric.name = "cloth";
    fabric.warp.diameter_mm = fabric.weft.diameter_mm = 0.2;
    fabric.ends_per_cm = fabric.picks_per_cm = 35;
    fabric.contact_angle_deg = contact_angle;
    design.fabrics.push_back(fabric);
    Experiment experiment;
    experiment.name = "drop";
    experiment.duration_s = duration;
    experiment.sample_mm = {8, 8};
    experiment.droplets[0].volume_ul = 2;
    experiment.droplets[0].height_mm = 0.5;
    design.experiments.push_back(experiment);
    return design;
}

} // namespace hygroloom
