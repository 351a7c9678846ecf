// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Outcomes as rows of a report.
#pragma once

#include "core/analysis/intervals.h"
#include "core/analysis/page.h"
#include "core/analysis/reader_units.h"

namespace hygroloom {

struct OutcomeRows {
    std::vector<PageRow> rows;
    std::vector<std::string> notes; ///< why numbers are missing, and what limits others, in sentences
};
/// Of those that people read, with the intervals that there are.
OutcomeRows outcome_rows(const std::vector<Outcome>& outcomes, const std::map<std::string, Interval>& intervals, const ReaderUnits& units);

} // namespace hygroloom
