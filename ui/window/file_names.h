// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where a file dialog starts, and how the file it returns ends.
#pragma once

#include "ui/document/document.h"

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

} // namespace hygroloom
