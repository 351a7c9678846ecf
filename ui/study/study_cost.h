// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a study will cost, from the plans of its runs.
#pragma once

#include "core/study/study_run.h"

#include <QString>

#include <functional>

namespace hygroloom {

struct StudyCost {
    std::size_t points = 0, runs = 0;
    double seconds = 0;    ///< of all runs together, as far as known
    double bytes_each = 0; ///< of the largest
    int at_once = 1;       ///< runs side by side
    QString missing;       ///< why time and memory are not known; empty: they are
};

/// Takes a moment for each fabric and experiment. outdated: ends it early. Preconditions: validate() found no error in both; files of
/// garments are named in full.
StudyCost foretellCost(const Design& design, const Study& study, const std::function<bool()>& outdated);

/// "96 runs (96 points), about 3 min, 2 at a time with 40 MB each."
QString costText(const StudyCost& cost);

/// With the threads that the user prefers.
StudyShares sharesOf(const Study& study, std::size_t runs, double bytes_each);

} // namespace hygroloom
