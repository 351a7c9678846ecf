// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One run of a trade-off, in a process of its own: core/run/apart.h.
#pragma once

#include "core/analysis/tradeoff.h"

#include <atomic>
#include <functional>

namespace hygroloom {

/// What all variants of one scene share.
struct ApartRun {
    Design design;
    std::string fabric, experiment;
    std::string backend;
    RunOptions options; ///< without fidelity and knobs
};

/// Runs one variant; progress gets its share, 0 to 1. Throws Cancelled when cancelled, Stop with the exit code when the device is
/// missing, else Error, also when the process was killed. Precondition: this process has started no thread yet.
TradeoffOutcome run_apart(const ApartRun& run, const TradeoffVariant& variant, const std::atomic<bool>& cancel,
                          const std::function<void(double)>& progress);

} // namespace hygroloom
