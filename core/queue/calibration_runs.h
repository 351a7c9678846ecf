// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Calibrations by real runs.
#pragma once

#include "core/analysis/calibration.h"
#include "core/queue/run_queue.h"

namespace hygroloom {

/// A model of real runs, side by side in a queue. started() is called before the runs of some points, progress() from the threads of the
/// runs. Throws Cancelled and Error.
struct CalibrationRuns {
    const Design& design;
    std::string fabric, experiment;
    const MeasuredData& data;
    const std::vector<FreeInput>& inputs;
    RunOptions how;
    RunQueue& queue;
    std::shared_ptr<RunPlaces> places;
    std::string backend; ///< "cpu" or "cuda", where they go
    const std::atomic<bool>& cancel;
    std::string name = {}; ///< of the batches
    std::function<void(std::size_t points)> started = {};
    std::function<void(std::size_t point, const RunProgress&)> progress = {};

    std::vector<std::vector<double>> operator()(const std::vector<std::vector<double>>& points) const;
    /// By what the plan of such a run expects: of a metric its own, of a curve that of the metric which is read from it.
    std::vector<NumberError> errors_of(const std::vector<double>& simulated) const;
};

/// calibrate() by real runs, with what was fitted to what.
Calibration calibrate(const CalibrationRuns& runs);

} // namespace hygroloom
