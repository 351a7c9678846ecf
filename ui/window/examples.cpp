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

bool isInstalled(const QString& path)
{
    const QString file = QFileInfo(path).canonicalFilePath();
    const QString beside = QDir(QCoreApplication::applicationDirPath()).filePath("../share/hygroloom/examples");
    for (const QString& folder : {QString("/usr/share"), QString("/usr/local/share"), QFileInfo(beside).canonicalFilePath()}) {
        if (!folder.isEmpty() && file.startsWith(folder + '/')) { return true; }
    }
    return file.contains("/share/hygroloom/examples/"); // of another installation
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
