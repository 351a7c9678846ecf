// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Reports as PDF: the pages that core/analysis writes as HTML, set by Qt.
#pragma once

#include "core/analysis/reader_units.h"

#include <QString>

#include <string>

class QWidget;

namespace hygroloom {

/// The units that the preferences choose.
ReaderUnits unitsOfReader();

/// A page of report_html(), comparison_report_html() or the like as PDF on A4, with its curves as vectors and numbered pages.
/// Precondition: there is a QGuiApplication, and this is its thread.
std::string pdfOf(const QString& html);

/// As PDF where the file's name ends so, else as it is. The file is whole or, where writing fails, as it was. Throws Error.
void writeReport(const QString& html, const QString& file);

struct FileKind {
    QString words;  ///< "PDF"
    QString ending; ///< "pdf"
};
/// Asks where a file of one of two kinds is to be saved; empty: nowhere. name: a suggestion, without an ending.
QString askForFile(QWidget* parent, const QString& title, const QString& folder, const QString& name, const FileKind& first,
                   const FileKind& second);

/// Asks where a report is to be saved, as PDF or web page; empty: nowhere. name: a suggestion, without an ending.
QString askForReportFile(QWidget* parent, const QString& folder, const QString& name);

} // namespace hygroloom
