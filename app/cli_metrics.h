// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Metrics on stdout.
#pragma once

#include "core/analysis/intervals.h"

namespace hygroloom {

/// As JSON, or as a table for people. intervals: of replicates, by key; without them those of the run alone.
void print_metrics(const RunRecord& run, const Metrics& metrics, bool json, const std::map<std::string, Interval>& intervals = {});

/// A row of each, for people.
void print_outcomes(const std::vector<Outcome>& outcomes, const std::map<std::string, Interval>& intervals);

} // namespace hygroloom
