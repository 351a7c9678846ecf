// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/document/sources.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace hygroloom {

namespace {

/// Without links where the folder is there: ".." leads out of what a link points to.
QString realFolder(const QString& folder)
{
    const QString real = QFileInfo(folder).canonicalFilePath();
    return real.isEmpty() ? QDir::cleanPath(QDir::current().absoluteFilePath(folder)) : real;
}

/// The file's own name stays, be it a link: other files of its name lie beside it.
QString realFile(const QString& file)
{
    const QFileInfo info(file);
    return QDir(realFolder(info.absolutePath())).filePath(info.fileName());
}

bool isFile(const std::string& zones)
{
    const auto& shipped = sweat_tables();
    return std::find(shipped.begin(), shipped.end(), zones) == shipped.end();
}

} // namespace

QString sourceFrom(const QString& folder, const QString& file)
{
    if (folder.isEmpty()) { return QDir::cleanPath(QFileInfo(file).absoluteFilePath()); }
    return QDir(realFolder(folder)).relativeFilePath(realFile(file));
}

Design movedSources(Design design, const QString& from, const QString& to)
{
    if (from.isEmpty() || (!to.isEmpty() && realFolder(from) == realFolder(to))) { return design; }
    const auto move = [&](std::string& source) {
        const QString file = QString::fromStdString(source);
        if (!source.empty() && QFileInfo(file).isRelative()) { source = sourceFrom(to, QDir(from).filePath(file)).toStdString(); }
    };
    for (Garment& garment : design.garments) {
        move(garment.source);
        if (isFile(garment.wearer.zones)) { move(garment.wearer.zones); }
    }
    for (WearExperiment& wear : design.wears) { move(wear.activity_file); }
    return design;
}

} // namespace hygroloom
