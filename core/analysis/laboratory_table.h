// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Numbers that a laboratory measured on fabrics, read from a table, to stand beside the simulated ones.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace hygroloom {

struct LaboratoryValue {
    std::string fabric, metric;   ///< metric: a key of the metrics file
    double value = 0;             ///< in the metric's unit
    std::optional<double> spread; ///< standard deviation in that unit
};
using LaboratoryTable = std::vector<LaboratoryValue>;

/// From CSV with the columns fabric, metric, value, unit and, if it likes, spread, in any order. The unit must be the metric's, the fabrics
/// and metrics must be among those named, and no pair may come twice; rows are at most 10 000. Throws Error naming the file, the line, what
/// is allowed and what is given.
LaboratoryTable read_laboratory_table(const std::string& text, const std::string& file, const std::vector<std::string>& fabrics,
                                      const std::vector<std::pair<std::string, std::string>>& metrics_and_units);

} // namespace hygroloom
