// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a laboratory measured of one fabric on one experiment: a curve or some metrics, and what a run says of the same.
#pragma once

#include "core/analysis/outcomes.h"
#include "core/design/design.h"

#include <optional>
#include <string>
#include <vector>

namespace hygroloom {

struct MeasuredNumber {
    std::string key;              ///< of a series or a metric
    std::string unit;             ///< as in the key
    double time = 0;              ///< s, on a curve
    double value = 0;             ///< in that unit
    std::optional<double> spread; ///< standard deviation in that unit
};

struct MeasuredData {
    std::string file;
    std::string quantity;                ///< key of the curve's series, or "metrics"
    std::string unit;                    ///< of the curve; empty of metrics
    std::vector<MeasuredNumber> numbers; ///< a curve's by time; all with a spread or none
    bool is_curve() const { return quantity != "metrics"; }
};

/// Keys of the curves that may be measured on a type of experiment: the metrics file's series of water, heights and temperatures, and
/// water_absorbed_g (in yarns and fibres, less what was there before) and water_left_g (what was added and has not evaporated).
std::vector<std::string> measurable_curves(ExperimentType type);

/// From CSV. A curve has the columns time_s, one of measurable_curves() and, if it likes, spread. A table has fabric, metric, value, unit
/// and spread; rows of other fabrics are left out. Throws Error naming the file, the line, what is allowed and what is given.
MeasuredData read_measured_data(const std::string& text, const std::string& file, const Design& design, const Fabric& fabric,
                                const Experiment& experiment);

/// What a run says of each number, of a curve from the frames about its time. Throws Error where it cannot say: a metric could not be
/// determined.
std::vector<double> simulated_of(const MeasuredData& data, const RunRecord& run, const Metrics& metrics);

} // namespace hygroloom
