// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The report of a run that the window holds.
#pragma once

#include "core/wear/wear_report.h"
#include "ui/garment/worn_run.h"

namespace hygroloom {

/// A copy of what a run holds now, for another thread; its frames are shared.
struct WornState {
    std::shared_ptr<const WearRecord> record;
    std::vector<std::shared_ptr<const WearFrame>> frames;
    std::shared_ptr<const WearMetrics> metrics;
    bool finished = false;
};
WornState stateOf(const WornRun& run);

/// The page that `garment map --report` writes, with maps at each quarter of the run. Precondition: there are frames. Takes seconds.
ReportPage reportOf(const WornState& run, WearMapOptions how);

} // namespace hygroloom
