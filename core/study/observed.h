// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the analyses are made from: the numbers of a study by point, and its points as places in a cube.
#pragma once

#include "core/study/points.h"
#include "core/study/results.h"

namespace hygroloom {

/// The mean of a metric over the replicates of each point that has it; NaN where none does.
std::vector<double> means_by_point(const StudyTable& table, std::size_t points, const std::string& metric, const std::string& fabric,
                                   const std::string& experiment);

/// Factors as coordinates: a number from 0 to 1 between its ends, a word as one of several coordinates that is 1.
class FactorCube {
public:
    explicit FactorCube(const std::vector<Factor>& factors);
    /// Throws Error where a value lies outside of the study.
    std::vector<double> place(const std::vector<FactorValue>& values) const;
    std::vector<double> place(const StudyPoints& points, std::size_t point) const;

private:
    struct Axis {
        double low = 0, high = 1;       ///< ends of the coordinate
        double lowest = 0, highest = 1; ///< that may be asked for
        bool logarithmic = false;
        std::vector<std::string> words; ///< of a factor that is not a number
    };
    void add(std::vector<double>& place, std::size_t factor, const FactorValue& value) const;
    void require_inside(std::size_t factor, const FactorValue& value) const;

    std::vector<Factor> factors_;
    std::vector<Axis> axes_;
};

} // namespace hygroloom
