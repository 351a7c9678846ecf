// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The points of a study: for each the value of every factor. They depend on the study and, one at a time, on the project; never on the
// machine.
#pragma once

#include "core/project/migrations.h"
#include "core/study/study.h"

namespace hygroloom {

class StudyPoints {
public:
    StudyPoints(std::vector<Factor> factors, std::vector<double> numbers) : factors_(std::move(factors)), numbers_(std::move(numbers)) {}

    std::size_t size() const { return factors_.empty() ? 1 : numbers_.size() / factors_.size(); }
    const std::vector<Factor>& factors() const { return factors_; }
    FactorValue value(std::size_t point, std::size_t factor) const;

private:
    std::vector<Factor> factors_;
    std::vector<double> numbers_; ///< of each point, each factor: its number, or its place in the factor's list
};

/// The most points that there may be. Counts without making them. Throws Error where they would be too many.
std::size_t count_points(const Study& study);

/// Precondition: validate() found no error. Throws what count_points() throws.
StudyPoints study_points(const Study& study, const Design& design);

/// The value below which the factor lies with this probability (0 to 1), of a list that place of it. Numbers have 10 digits, so that they
/// are the same on any machine.
FactorValue quantile(const Factor& factor, double probability);

/// What the project, or the fidelity's knob, has at the factor's path; none: the project leaves it open.
std::optional<FactorValue> own_value(const Study& study, const Factor& factor, const Design& design);

/// The base samples of a Saltelli design: its points are N of one sample, N of another, and N for each factor where that is from the other.
std::size_t saltelli_base(const Study& study);

/// The design with a point's values, and the knobs that it sets; project: json_from_design(). Throws Error naming the path.
struct PointSetting {
    Design design;
    KnobSettings knobs;
};
PointSetting with_point(const Study& study, const ProjectJson& project, const StudyPoints& points, std::size_t point);

} // namespace hygroloom
