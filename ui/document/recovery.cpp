// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/document/recovery.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "core/project/project_file.h"
#include "ui/basics/preferences.h"
#include "ui/document/run_folder.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>
#include <utility>

namespace hygroloom {

namespace {

constexpr int shortest_delay = 1000; // ms from an edit to its writing

int preferredDelay() { return std::max(shortest_delay, 60000 * preferences().autosave_minutes); }

QString lockOf(const QString& file) { return file + ".lock"; }

/// Where the project has its file, what it is called, and "saved" where the copy is kept for its runs alone, in three lines.
QString originOf(const QString& file) { return file + ".origin"; }

void removeKept(const QString& file)
{
    for (const QString& each : {file, originOf(file)}) { QFile::remove(each); }
}

std::unique_ptr<QLockFile> lockFor(const QString& file)
{
    auto lock = std::make_unique<QLockFile>(lockOf(file));
    lock->setStaleLockTime(0); // only the end of its process frees it
    return lock;
}

} // namespace

Recovery::Recovery(Document& document, QString folder, QObject* parent)
    : QObject(parent), document_(document), folder_(std::move(folder)),
      file_(QDir(folder_).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + ".hygro")), writer_(std::make_unique<NewestJob>())
{
    wait_.setSingleShot(true);
    wait_.setInterval(preferredDelay());
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, [this] { // a timer that runs begins anew
        if (wait_.interval() != preferredDelay()) { wait_.setInterval(preferredDelay()); }
    });
    connect(&wait_, &QTimer::timeout, this, &Recovery::keep);
    connect(&document_, &Document::designChanged, this, &Recovery::follow);
    connect(&document_, &Document::modifiedChanged, this, &Recovery::follow);
}

Recovery::~Recovery()
{
    writer_.reset(); // what it is writing is written first
    if (lock_) {
        if (!holdsRuns(runFolder())) { removeKept(file_); }
        lock_.reset();
    }
}

QString Recovery::runFolder() const { return runFolderOf(file_); }

bool Recovery::isDue() const { return document_.modified() || holdsRuns(runFolder()); }

QString Recovery::standardFolder() { return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/recovery"; }

void Recovery::follow()
{
    if (isDue()) {
        if (!wait_.isActive()) { wait_.start(); }
    } else {
        forget();
    }
}

void Recovery::keep()
{
    if (!lock_) {
        QDir().mkpath(folder_);
        auto lock = lockFor(file_);
        if (!lock->tryLock(0)) { // tried again at the next edit
            sayFailed(tr("%1 cannot be locked. Check that the folder can be written to.").arg(file_));
            return;
        }
        lock_ = std::move(lock);
    }
    const QString origin = document_.path() + "\n" + document_.title() + "\n" + (document_.modified() ? "" : "saved") + "\n" +
                           document_.savedHash().toHex() + "\n";
    writer_->run([this, design = document_.design(), file = file_, origin](const NewestJob::Turn& turn) {
        try {
            write_file(originOf(file).toStdString(), origin.toStdString());
            write_file(file.toStdString(), format_project(*design));
            turn.deliver([this] {
                has_failed_ = false;
                removeOpened();
                Q_EMIT kept();
            });
        } catch (const Error& error) { // a full disk must not get in the way of the work itself
            turn.deliver([this, why = QString::fromStdString(error.what())] { sayFailed(why); });
        }
    });
}

void Recovery::sayFailed(const QString& why)
{
    if (!std::exchange(has_failed_, true)) { Q_EMIT failed(tr("Unsaved work cannot be kept for recovery: %1").arg(why)); }
}

void Recovery::forget()
{
    wait_.stop();
    if (lock_) { // after what is being written
        writer_->run([file = file_](const NewestJob::Turn&) { removeKept(file); });
    }
}

std::vector<LeftOver> Recovery::leftOver() const
{
    std::vector<LeftOver> found;
    for (const QFileInfo& info : QDir(folder_).entryInfoList({"*.hygro"}, QDir::Files, QDir::Time)) {
        const QString file = info.absoluteFilePath();
        if (QFileInfo(file) == QFileInfo(file_) || !lockFor(file)->tryLock(0)) {
            continue; // some window works on it
        }
        QFile origin(originOf(file));
        const QStringList lines = origin.open(QIODevice::ReadOnly) ? QString::fromUtf8(origin.readAll()).split('\n') : QStringList();
        clearEmptyRuns(runFolderOf(file));
        if (lines.value(2) == "saved" && !holdsRuns(runFolderOf(file))) {
            removeKept(file);
            continue;
        }
        const QString path = lines.value(0);
        const QByteArray saved = QByteArray::fromHex(lines.value(3).toUtf8()); // none by older versions
        const bool outdated = !path.isEmpty() && QFileInfo::exists(path) &&
                              (QFileInfo(path).lastModified() > info.lastModified() || (!saved.isEmpty() && hashOfFile(path) != saved));
        found.push_back({file, path, lines.value(1), info.lastModified(), outdated, runFolderOf(file)});
    }
    return found;
}

bool Recovery::open(const LeftOver& left)
{
    if (!document_.openUnsaved(left.file, left.outdated ? QString() : left.path, left.title, left.path)) { return false; }
    opened_.push_back(left);
    keep();
    return true;
}

/// Once there is a copy of this window's, and its runs have gone where they belong.
void Recovery::removeOpened()
{
    std::erase_if(opened_, [](const LeftOver& left) {
        if (holdsRuns(left.runs)) { return false; }
        remove(left);
        return true;
    });
}

void Recovery::remove(const LeftOver& left)
{
    removeKept(left.file);
    QFile::remove(lockOf(left.file));
}

void Recovery::discard(const LeftOver& left)
{
    QDir(left.runs).removeRecursively();
    remove(left);
}

} // namespace hygroloom
