// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The comparison on screen as a page, and a laboratory's numbers beside it.
#pragma once

#include "core/analysis/comparison.h"
#include "core/analysis/page.h"

#include <QString>

namespace hygroloom {

/// HTML as the command line's compare writes it, with maps at the end of those runs that have a recording (by fabric). Reads the
/// recordings, which takes a while. Throws Error.
ReportPage studyReport(const Comparison& comparison, const std::map<std::string, QString>& recordings);

/// A laboratory's numbers of the fabrics, also of those that have not been run; see read_laboratory_table(). Throws Error.
LaboratoryTable readMeasured(const std::vector<OutcomeInfo>& criteria, const std::vector<std::string>& fabrics, const QString& file);

/// Which file had the numbers of an experiment of this project; empty: none had.
QString measuredFile(const QString& project, const std::string& experiment);
void rememberMeasured(const QString& project, const std::string& experiment, const QString& file);

} // namespace hygroloom
