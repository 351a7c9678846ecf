// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a run gave, on one page that needs nothing else: results, maps, curves, where the water is, and all that went in.
#pragma once

#include "core/analysis/page.h"
#include "core/analysis/reader_units.h"
#include "core/analysis/run_metrics.h"
#include "core/run/run_record.h"

namespace hygroloom {

/// finished: the run came to its end. units: of results, curves and quantities; inputs stand as the project has them.
ReportPage report_of(const RunRecord& run, const Metrics& metrics, const std::vector<ReportPicture>& pictures, bool finished,
                     const ReaderUnits& units = {});

} // namespace hygroloom
