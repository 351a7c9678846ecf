// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/document/run_folder.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QObject>
#include <QRegularExpression>

#include <algorithm>

namespace hygroloom {

namespace {

namespace fs = std::filesystem;

QString markList(const QString& folder) { return QDir(folder).filePath("keep"); }

QStringList marksOf(const QString& folder)
{
    QFile file(markList(folder));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts) : QStringList();
}

/// The least number above all that are in use, also by recordings that are just beginning.
int nextNumber(const QString& folder)
{
    int last = 0;
    for (const QString& name : QDir(folder).entryList({"*run-*"}, QDir::Files | QDir::Hidden)) { last = std::max(last, runNumber(name)); }
    return last + 1;
}

QString numbered(const QString& folder, int number) { return QDir(folder).filePath(QString("run-%1.hygrorec").arg(number)); }

/// False where the file system cannot.
bool linkOver(const QString& from, const QString& to)
{
    const fs::path temporary = fs::path(to.toStdString()).replace_extension(".link");
    std::error_code error;
    fs::create_hard_link(from.toStdString(), temporary, error);
    if (!error) { fs::rename(temporary, to.toStdString(), error); }
    return !error;
}

void copyOver(const QString& from, const QString& to)
{
    write_file_with(to.toStdString(), [&from](const fs::path& temporary) {
        std::error_code error;
        fs::copy_file(from.toStdString(), temporary, fs::copy_options::overwrite_existing, error);
        if (error) { throw Error(error.message()); }
    });
}

void removeIfEmpty(const QString& folder)
{
    if (!holdsRuns(folder)) {
        QFile::remove(markList(folder));
        QDir().rmdir(folder);
    }
}

} // namespace

QString runFolderOf(const QString& project) { return project + "-runs"; }

int runNumber(const QString& recording)
{
    static const QRegularExpression form("run-(\\d{1,8})\\.hygrorec");
    return form.match(QFileInfo(recording).fileName()).captured(1).toInt();
}

QStringList recordingsIn(const QString& folder)
{
    QStringList found;
    for (const QFileInfo& info : QDir(folder).entryInfoList({"*.hygrorec"}, QDir::Files, QDir::Name)) {
        if (info.size() > 0) { found << info.absoluteFilePath(); }
    }
    std::stable_sort(found.begin(), found.end(), [](const QString& a, const QString& b) { return runNumber(a) < runNumber(b); });
    return found;
}

bool holdsRuns(const QString& folder) { return !QDir(folder).entryList({"*.hygrorec*"}, QDir::Files | QDir::Hidden).isEmpty(); }

void clearEmptyRuns(const QString& folder)
{
    for (const QFileInfo& info : QDir(folder).entryInfoList({"run-*.hygrorec", ".run-*.hygrorec.part"}, QDir::Files | QDir::Hidden)) {
        if (info.size() == 0 || info.suffix() == "part") { QFile::remove(info.absoluteFilePath()); }
    }
    removeIfEmpty(folder);
}

QString reserveRun(const QString& folder)
{
    QString why = QObject::tr("the folder cannot be made");
    if (QDir().mkpath(folder)) {
        for (int number = nextNumber(folder);; ++number) {
            QFile file(numbered(folder, number));
            if (file.open(QIODevice::WriteOnly | QIODevice::NewOnly)) { return file.fileName(); }
            if (!file.exists()) {
                why = file.errorString();
                break;
            }
        }
    }
    throw Error(QObject::tr("Runs cannot be recorded in %1: %2.").arg(folder, why).toStdString());
}

void releaseRun(const QString& recording)
{
    const QFileInfo info(recording);
    if (info.exists() && info.size() == 0) {
        QFile::remove(recording);
        removeIfEmpty(info.absolutePath());
    }
}

QString bringRun(const QString& recording, const QString& folder, Bring how)
{
    const QString to = reserveRun(folder);
    try {
        if (!linkOver(recording, to)) { copyOver(recording, to); }
        if (isMarked(recording)) { setMarked(to, true); }
    } catch (const std::exception& error) {
        QFile::remove(to);
        removeIfEmpty(folder);
        throw Error(QObject::tr("%1 cannot be put into %2: %3").arg(recording, folder, QString::fromStdString(error.what())).toStdString());
    }
    if (how == Bring::move) {
        QFile::remove(recording);
        removeIfEmpty(QFileInfo(recording).absolutePath());
    }
    return to;
}

void deleteRun(const QString& recording)
{
    QFile file(recording);
    if (file.exists() && !file.remove()) {
        throw Error(QObject::tr("%1 cannot be deleted: %2.").arg(recording, file.errorString()).toStdString());
    }
    if (isMarked(recording)) { setMarked(recording, false); }
    removeIfEmpty(QFileInfo(recording).absolutePath());
}

bool isMarked(const QString& recording)
{
    const QFileInfo info(recording);
    return marksOf(info.absolutePath()).contains(info.fileName());
}

void setMarked(const QString& recording, bool marked)
{
    const QFileInfo info(recording);
    QStringList names = marksOf(info.absolutePath());
    names.removeAll(info.fileName());
    if (marked) { names << info.fileName(); }
    if (names.isEmpty()) {
        QFile::remove(markList(info.absolutePath()));
    } else {
        write_file(markList(info.absolutePath()).toStdString(), (names.join('\n') + "\n").toStdString());
    }
}

} // namespace hygroloom
