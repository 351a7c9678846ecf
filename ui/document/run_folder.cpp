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
    fs::remove(temporary, error); // of a window that was killed
    fs::create_hard_link(from.toStdString(), temporary, error);
    if (error) { return false; }
    fs::rename(temporary, to.toStdString(), error);
    if (error) { QFile::remove(QString::fromStdString(temporary.string())); }
    return !error;
}

/// What a killed run left beside a recording that is gone.
void removeBeside(const QString& recording)
{
    for (const char* ending : {"-wal", "-shm"}) { QFile::remove(recording + ending); }
}

void removeIfEmpty(const QString& folder)
{
    if (!holdsRuns(folder)) {
        QFile::remove(markList(folder));
        QFile::remove(replicatesIn(folder));
        QDir().rmdir(folder);
    }
}

/// Under the next free number; put(to) says whether it could. Empty where not.
template <typename Put> QString bring(const QString& recording, const QString& folder, Bring how, const Put& put)
{
    QString to = reserveRun(folder);
    try {
        if (!put(to)) {
            releaseRun(to);
            return {};
        }
        if (isMarked(recording)) { setMarked(to, true); }
    } catch (const std::exception& error) {
        QFile::remove(to);
        removeIfEmpty(folder);
        throw Error(QObject::tr("%1 cannot be put into %2: %3").arg(recording, folder, QString::fromStdString(error.what())).toStdString());
    }
    if (how == Bring::move) {
        try {
            deleteRun(recording);
        } catch (const Error&) { // it lies in both folders
        }
    }
    return to;
}

} // namespace

QString oneSpelling(const QString& folder)
{
    const QFileInfo info(folder);
    std::error_code error;
    const fs::path parent = fs::weakly_canonical(info.absolutePath().toStdString(), error);
    return error ? info.absoluteFilePath() : QDir(QString::fromStdString(parent.string())).filePath(info.fileName());
}

QString replicatesIn(const QString& folder) { return QDir(folder).filePath("replicates.json"); }

QString runFolderOf(const QString& project) { return oneSpelling(project + "-runs"); }

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

void copyRecording(const QString& from, const QString& to, const CopyStep& step)
{
    constexpr qint64 piece = 4 << 20;
    write_file_with(to.toStdString(), [&](const fs::path& temporary) {
        QFile source(from), copy(QString::fromStdString(temporary.string()));
        if (!source.open(QIODevice::ReadOnly)) { throw Error(source.errorString().toStdString()); }
        if (!copy.open(QIODevice::WriteOnly)) { throw Error(copy.errorString().toStdString()); }
        while (true) {
            const QByteArray bytes = source.read(piece);
            if (bytes.isEmpty()) { break; }
            if (copy.write(bytes) != bytes.size()) { throw Error(copy.errorString().toStdString()); }
            if (step && !step(static_cast<double>(source.pos()) / static_cast<double>(std::max<qint64>(source.size(), 1)))) {
                throw Cancelled();
            }
        }
        if (source.error() != QFile::NoError) { throw Error(source.errorString().toStdString()); }
        if (!copy.flush()) { throw Error(copy.errorString().toStdString()); }
        removeBeside(to);
    });
}

QString linkRun(const QString& recording, const QString& folder, Bring how)
{
    return bring(recording, folder, how, [&recording](const QString& to) { return linkOver(recording, to); });
}

QString bringRun(const QString& recording, const QString& folder, Bring how, const CopyStep& step)
{
    return bring(recording, folder, how, [&](const QString& to) {
        if (!linkOver(recording, to)) { copyRecording(recording, to, step); }
        return true;
    });
}

void deleteRun(const QString& recording)
{
    const bool marked = isMarked(recording);
    if (marked) { setMarked(recording, false); } // first: a later run may get its name
    QFile file(recording);
    if (file.exists() && !file.remove()) {
        if (marked) { setMarked(recording, true); }
        throw Error(QObject::tr("%1 cannot be deleted: %2.").arg(recording, file.errorString()).toStdString());
    }
    removeBeside(recording);
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
    const ChangeLock alone(markList(info.absolutePath()).toStdString());
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
