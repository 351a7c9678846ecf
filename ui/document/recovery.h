// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Unsaved work on the disk, so that it outlives a crash: a copy of the project, and beside it the runs of one that has no file of its own.
// What is left over is what no running window holds the lock of.
#pragma once

#include "ui/basics/newest_job.h"
#include "ui/document/document.h"

#include <QDateTime>
#include <QLockFile>
#include <QTimer>

#include <memory>
#include <vector>

namespace hygroloom {

/// What a window that is gone had not saved.
struct LeftOver {
    QString file; ///< the kept project
    QString path; ///< where the project was saved before; empty: nowhere
    QString title;
    QDateTime when;
    bool outdated = false; ///< what is at its path is not what it was made from, or was saved later
    QString runs;          ///< the folder with its runs; need not exist
};

/// Writes the design beside other work after it changed, at once or as seldom as the user prefers, and removes the copy once it is saved or
/// discarded and no runs lie beside it.
class Recovery : public QObject {
    Q_OBJECT
public:
    explicit Recovery(Document& document, QString folder = standardFolder(), QObject* parent = nullptr);
    /// A regular end: no copy stays, but where runs lie beside it.
    ~Recovery() override;

    static QString standardFolder();
    /// For runs of this window that cannot lie beside their project.
    QString runFolder() const;
    /// Writes or removes the copy, whichever is due: runs have come or gone.
    void follow();
    /// Newest first. What holds neither changes nor recorded runs is cleared away.
    std::vector<LeftOver> leftOver() const;
    /// Opens it as unsaved work; as untitled where it is outdated, so that the later file is not overwritten. False after the document
    /// said why not; the file is then still there.
    bool open(const LeftOver& left);
    /// Deletes it, with its runs.
    static void discard(const LeftOver& left);

Q_SIGNALS:
    void kept();
    /// Said once, until a copy can be written again.
    void failed(const QString& sentence);

private:
    static void remove(const LeftOver& left);
    void removeOpened();
    bool isDue() const;
    void keep();
    void sayFailed(const QString& why);
    void forget();

    Document& document_;
    const QString folder_;
    const QString file_; ///< this window's
    std::unique_ptr<QLockFile> lock_;
    std::vector<LeftOver> opened_; ///< whose files are not needed soon
    bool has_failed_ = false;
    QTimer wait_;
    std::unique_ptr<NewestJob> writer_;
};

} // namespace hygroloom
