// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where what can be made anew is kept: pictures of the start page, rooms between yarns, and how long runs took.
#pragma once

#include <QCoreApplication>
#include <QDir>
#include <QStandardPaths>

namespace hygroloom {

/// The one of cache_folder() in core/project.
inline QString cacheFolder()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation)).filePath(QCoreApplication::applicationName());
}

} // namespace hygroloom
