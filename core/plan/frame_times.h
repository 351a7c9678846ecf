// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// When a run's frames are taken.
#pragma once

#include "core/design/experiment.h"

#include <vector>

namespace hygroloom {

/// s, from 0 to the end of the experiment: every interval, and every tenth of a second while a pump feeds the cloth between sensors, since
/// a moisture management tester samples so often; a feed of more than 20 s in 200 frames.
std::vector<double> frame_times(const Experiment& experiment, double interval);

} // namespace hygroloom
