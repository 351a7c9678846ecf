// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/worn_report.h"

#include "ui/results/report_file.h"

namespace hygroloom {

WornState stateOf(const WornRun& run) { return {run.record, run.frames, run.metrics, run.wall > 0}; }

ReportPage reportOf(const WornState& run, WearMapOptions how)
{
    how.units = unitsOfReader();
    std::vector<double> times;
    for (const auto& frame : run.frames) { times.push_back(frame->time); }
    std::vector<std::shared_ptr<const WearFrame>> shown;
    for (const int k : frames_for_report(times, {})) { shown.push_back(run.frames[static_cast<std::size_t>(k)]); }
    return wear_report(*run.record, *run.metrics, pictures_of_panels(run.record->layout, shown, how), run.finished, how.units);
}

} // namespace hygroloom
