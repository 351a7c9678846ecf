// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/document/sources.h"

#include <QDir>
#include <QFile>
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

/// All that a design names by a path from its folder.
QStringList relativeSources(const Design& design)
{
    QStringList files;
    const auto add = [&files](const std::string& name) {
        const QString file = QString::fromStdString(name);
        if (!name.empty() && QFileInfo(file).isRelative() && !files.contains(file)) { files << file; }
    };
    for (const Garment& garment : design.garments) {
        if (!garment.is_built_in()) { add(garment.source); }
        if (isFile(garment.wearer.zones)) { add(garment.wearer.zones); }
    }
    for (const WearExperiment& wear : design.wears) { add(wear.activity_file); }
    return files;
}

bool holdTheSame(const QString& a, const QString& b)
{
    QFile one(a), other(b);
    return one.open(QIODevice::ReadOnly) && other.open(QIODevice::ReadOnly) && one.size() == other.size() &&
           one.readAll() == other.readAll();
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

QString folderOfSources(const Design& recorded, const QString& recording)
{
    const QStringList files = relativeSources(recorded);
    const QString own = QFileInfo(recording).absolutePath();
    for (const QString& folder : {own, QFileInfo(own).absolutePath()}) {
        for (const QString& file : files) {
            if (QFileInfo::exists(QDir(folder).filePath(file))) { return folder; }
        }
    }
    return {};
}

QStringList copySources(const Design& design, const QString& from, const QString& to)
{
    if (from.isEmpty()) { return relativeSources(design); }
    QStringList left;
    for (const QString& file : relativeSources(design)) {
        const QString source = QDir(from).filePath(file), target = QDir(to).filePath(file);
        if (QFileInfo::exists(source) && realFile(source) == realFile(target)) { continue; }
        const bool outside = QDir::cleanPath(file).startsWith("../");
        const bool there = QFileInfo::exists(target);
        const bool copied = there ? holdTheSame(source, target)
                                  : !outside && QDir().mkpath(QFileInfo(target).absolutePath()) && QFile::copy(source, target);
        if (!copied) { left << file; }
    }
    return left;
}

} // namespace hygroloom
