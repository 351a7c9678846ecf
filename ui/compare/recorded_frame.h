// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Frames of a run that is compared, from its recording.
#pragma once

#include "core/run/recording.h"
#include "ui/results/run_history.h"

namespace hygroloom {

/// The run's recording. Throws Error where the file at the run's path holds another run now, or no frame.
Recording recordingOf(const KeptRun& run);
/// Of the last recorded time not after a time.
int frameIndexAt(const Recording& recording, double time);
/// Of its experiment, s.
double durationOf(const KeptRun& run);

} // namespace hygroloom
