// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The results of a study as the charts and the table read them: its columns as axes, and what its analysis says.
#pragma once

#include "core/study/analysis.h"

#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace hygroloom {

/// A column as a line on which each row has a place, in the user's unit.
struct StudyAxis {
    QString title;
    std::size_t column = 0;      ///< in the table
    bool is_factor = false;      ///< or which fabric, which experiment
    std::vector<double> numbers; ///< of each row; of words their place in the list; NaN where there is none
    std::vector<QString> words;  ///< of a column that is not numbers
    double low = 0, high = 1;    ///< of those numbers
    bool empty = true;           ///< no row has a number
    double placeOf(double number) const { return high > low ? (number - low) / (high - low) : 0.5; } ///< 0 to 1
    double numberAt(double place) const { return low + place * (high - low); }
    QString text(double number) const;
    /// Round numbers within the axis, or its words.
    std::vector<double> ticks(int most) const;
};

/// The indices of one metric.
struct StudyIndices {
    QString title;
    QString method;
    std::size_t points = 0;
    std::vector<std::pair<QString, SobolIndex>> factors; ///< none: too few runs have the metric
};

struct StudyData {
    QString path;                  ///< folder, or file of a table
    std::optional<StudyFolder> of; ///< none: a table alone
    StudyTable table;
    std::size_t rows = 0, failed = 0; ///< that there should be, as far as that is known; that failed
    std::vector<StudyAxis> axes;      ///< factors, then metrics
    std::vector<StudyIndices> indices;
    bool has_indices = false; ///< a fresh file of them was read
};

/// Which rows a brush keeps; empty: all.
using KeptPoints = std::vector<char>;

/// A folder of a study, or its results.csv or study.sqlite. Throws Error.
std::shared_ptr<const StudyData> readStudyData(const QString& path);

/// "minutes: 12" of each factor and metric of a row, on a line.
QString rowInWords(const StudyData& data, std::size_t row);

/// The rows whose axis lies within a range.
struct AxisBrush {
    std::size_t axis = 0;
    double low = 0, high = 0;
};
KeptPoints keptBy(const StudyData& data, const std::vector<AxisBrush>& brushes);

} // namespace hygroloom
