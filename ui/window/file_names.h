// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where a file dialog starts, and how the file it returns ends.
#pragma once

#include "ui/document/document.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QStandardPaths>

namespace hygroloom {

/// The project's folder; the user's documents until it has one.
inline QString folderOf(const Document& document)
{
    return document.path().isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                                     : QFileInfo(document.path()).absolutePath();
}

inline QString withEnding(const QString& path, const QString& ending)
{
    return path.endsWith(ending, Qt::CaseInsensitive) ? path : path + ending;
}

/// Asks where a report is to be saved, as PDF or HTML; empty: nowhere.
inline QString askForReport(QWidget* parent, const QString& suggested)
{
    const QString pdf = QObject::tr("PDF (*.pdf)"), html = QObject::tr("Web page (*.html)");
    QString filter = pdf;
    const QString chosen = QFileDialog::getSaveFileName(parent, QObject::tr("Save Report"), suggested + ".pdf", pdf + ";;" + html, &filter);
    if (chosen.isEmpty() || chosen.endsWith(".html", Qt::CaseInsensitive)) return chosen;
    return withEnding(chosen, filter == html ? ".html" : ".pdf");
}

} // namespace hygroloom
