// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Reports as PDF: the pages of core/analysis, set by Qt.
#pragma once

#include "core/analysis/page.h"
#include "core/analysis/reader_units.h"

#include <QString>

#include <string>

class QWidget;

namespace hygroloom {

/// The units that the preferences choose.
ReaderUnits unitsOfReader();

/// A4, with curves as vectors and numbered pages.
/// Precondition: there is a QGuiApplication, and this is its thread.
std::string pdfOf(const ReportPage& page);

/// As its ending asks: .pdf, or see written_as(). The file is whole or, where writing fails, as it was. Throws Error, also where the
/// ending is none of these.
void writeReport(const ReportPage& page, const QString& file);

struct FileKind {
    QString words;  ///< "PDF"
    QString ending; ///< "pdf"
};
/// The name with the usual ending behind it where it has that of neither kind: of "Poplin v1.2" a dialog believes it had one.
QString withKnownEnding(const QString& file, const QString& usual, const FileKind& first, const FileKind& second);
/// Asks where a file of one of two kinds is to be saved; empty: nowhere. name: a suggestion, without an ending.
QString askForFile(QWidget* parent, const QString& title, const QString& folder, const QString& name, const FileKind& first,
                   const FileKind& second);

/// Asks where a report is to be saved, as PDF or web page; empty: nowhere. name: a suggestion, without an ending.
QString askForReportFile(QWidget* parent, const QString& folder, const QString& name, const QString& title = {});

} // namespace hygroloom
