// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Metrics on stdout, for simulate and measure.
#pragma once

#include "core/analysis/metrics.h"

namespace hygroloom {

/// As JSON, or as a table for people.
void print_metrics(const RunRecord& run, const Metrics& metrics, bool json);

} // namespace hygroloom
