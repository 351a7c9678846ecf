// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/examples.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace hygroloom {

QString examplesFolder()
{
    const QDir program(QCoreApplication::applicationDirPath());
    for (const QString& folder : {program.filePath("../share/hygroloom/examples"), QString(HYGROLOOM_EXAMPLES_DIR)}) {
        if (QFileInfo(folder).isDir()) { return QDir(folder).canonicalPath(); }
    }
    return {};
}

QString shippedExample()
{
    const QString name = "one-drop-on-cotton.hygro";
    for (const QString& path : {examplesFolder() + "/" + name, ":/examples/" + name}) {
        if (QFileInfo(path).isFile()) { return path; }
    }
    return {};
}

} // namespace hygroloom
