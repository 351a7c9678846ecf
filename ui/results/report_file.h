// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Reports as PDF: the pages that core/analysis writes as HTML, set by Qt.
#pragma once

#include <QString>

class QWidget;

namespace hygroloom {

/// Writes a page of report_html(), comparison_report_html() or the like as PDF on A4, with its curves as vectors and numbered pages.
/// The file is whole or, where writing fails, as it was. Throws Error. Precondition: there is a QGuiApplication.
void writePdf(const QString& html, const QString& file);

/// As PDF where the file's name ends so, else as it is. Throws Error.
void writeReport(const QString& html, const QString& file);

/// Asks where a report is to be saved, as PDF or web page; empty: nowhere. suggested: without an ending.
QString askForReportFile(QWidget* parent, const QString& suggested);

} // namespace hygroloom
