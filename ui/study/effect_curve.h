// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a factor does to a metric, whatever the other factors are: the mean of the metric over the factor, with its interval.
#pragma once

#include "ui/study/study_data.h"

namespace hygroloom {

struct EffectPoint {
    double at = 0;        ///< on the factor's axis
    double mean = 0;      ///< of the metric
    double off = 0;       ///< half the interval that holds the mean with 90 %; NaN where one row says nothing of it
    std::size_t rows = 0; ///< of a level; of a curve all
};

struct EffectCurve {
    bool smooth = false; ///< a curve over the range; else a point for each level that the factor has
    std::vector<EffectPoint> points;
};

constexpr std::size_t most_effect_levels = 12; ///< of a factor of numbers; more are taken for a range
constexpr std::size_t fewest_effect_rows = 8;  ///< below, a range gets no curve: its rows alone are shown

/// Levels: means, intervals by Student's law. A range: lines fitted to the rows near each place (local linear regression, Cleveland 1979;
/// Gaussian weights, width by Silverman's rule), the interval from the rows' scatter about the curve.
EffectCurve effectCurve(const StudyAxis& factor, const StudyAxis& metric);

} // namespace hygroloom
