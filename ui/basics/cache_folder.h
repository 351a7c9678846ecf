// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where what can be made anew is kept: pictures of the start page, and how long runs took.
#pragma once

#include <QCoreApplication>
#include <QDir>
#include <QStandardPaths>

namespace hygroloom {

/// The one in which core/run keeps learned times.
inline QString cacheFolder()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation)).filePath(QCoreApplication::applicationName());
}

} // namespace hygroloom
