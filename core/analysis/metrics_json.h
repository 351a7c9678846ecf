// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The metrics file of a run.
#pragma once

#include "core/analysis/intervals.h"
#include "core/analysis/metrics.h"

#include <nlohmann/json_fwd.hpp>

namespace hygroloom {

/// Format "hygroloom-metrics", version 1: provenance, metrics, series and ledger. A metric that could not be determined is null, and a note
/// says why.
/// intervals: of metrics by key, beside them; see intervals_value(). Those that are not given have their numerical part alone.
nlohmann::ordered_json metrics_value(const RunRecord& run, const Metrics& metrics, const std::map<std::string, Interval>& intervals = {});
/// Of each its centre, its ends and its parts.
nlohmann::ordered_json intervals_value(const std::map<std::string, Interval>& intervals);
std::string metrics_json(const RunRecord& run, const Metrics& metrics, const std::map<std::string, Interval>& intervals = {});

} // namespace hygroloom
