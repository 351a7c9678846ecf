// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The numbers of a project that a study may change, with their paths, names, units and present values.
#pragma once

#include "core/design/design.h"
#include "ui/basics/quantity.h"

#include <QString>

#include <optional>
#include <vector>

namespace hygroloom {

struct StudyField {
    std::string path;            ///< as a factor has it
    QString group;               ///< "Textile F", "one drop", "Fidelity"
    QString name;                ///< "warp, twist"
    QString unit;                ///< empty for a plain number
    std::optional<double> value; ///< none: the project leaves it out
};

/// Fabrics first, then experiments, garments, materials, liquids and the knobs of the fidelity.
std::vector<StudyField> studyFields(const Design& design);

/// Of any path; where the project has no such member the group is the path's own.
StudyField fieldAt(const Design& design, const std::string& path);
/// The reader's unit of a factor's numbers. A count stays in tex: a range of it would turn round.
UserUnit unitOfFactor(const QString& unit);
/// With unit and value as the reader has them.
StudyField inReadersUnit(StudyField field);
/// "ends (/cm)"; with the group before it where a study has factors of several.
QString fieldTitle(const StudyField& field, bool with_group);

/// "maximum wetted radius, top (mm)"; of a garment's part "most water, panel front (g)".
QString metricTitle(const std::string& key);
/// The same apart.
struct MetricName {
    QString title, unit; ///< the unit may be empty
};
MetricName metricName(const std::string& key);
/// "title (unit)"
QString titleWithUnit(const QString& title, const QString& unit);

/// A number as it is read in tables and on axes, at most 4 digits.
QString studyNumber(double number);

} // namespace hygroloom
