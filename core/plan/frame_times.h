// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// When a run's frames are taken.
#pragma once

#include "core/design/experiment.h"
#include "core/plan/model_plan.h"

#include <vector>

namespace hygroloom {

/// s, from 0 to the end of the experiment: every interval, and every tenth of a second while a pump feeds the cloth between sensors, since
/// a moisture management tester samples so often; a feed of more than 20 s in 200 frames. Where the last drop fell more than 0.6 s before
/// little changes: there they lie half a second apart, or an interval if that is shorter.
std::vector<double> frame_times(const Experiment& experiment, double interval);

/// How many there are; of plans that do not tell, as of older versions, a tester's are taken to have its usual feed.
double frames_of(const ModelPlan& plan);
/// Segments, or cells, that each shows.
double shown_segments(const ModelPlan& plan);
/// What it takes beside the run to record them, s, on a core as rough_work() has it.
double recording_seconds(const ModelPlan& plan);
/// What the user waits for, s: the run and, where it is recorded, its recording. Precondition: expect().
double seconds_to_wait(const ModelPlan& plan, bool recorded);

} // namespace hygroloom
