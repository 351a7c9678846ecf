// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Unsaved work on the disk, so that it outlives a crash. What is left over is what no running window holds the lock of.
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
    bool outdated = false; ///< what is at its path was saved later
};

/// Writes the design beside other work shortly after it changed, and removes the copy once it is saved or discarded.
class Recovery : public QObject {
    Q_OBJECT
public:
    explicit Recovery(Document& document, QString folder = standardFolder(), QObject* parent = nullptr);
    /// A regular end: no copy stays.
    ~Recovery() override;

    static QString standardFolder();
    /// Newest first.
    std::vector<LeftOver> leftOver() const;
    /// Opens it as unsaved work; as untitled where it is outdated, so that the later file is not overwritten. False after the document
    /// said why not; the file is then still there.
    bool open(const LeftOver& left);
    static void discard(const LeftOver& left);

Q_SIGNALS:
    void kept();

private:
    void follow();
    void keep();
    void forget();

    Document& document_;
    const QString folder_;
    const QString file_; ///< this window's
    std::unique_ptr<QLockFile> lock_;
    QTimer wait_;
    std::unique_ptr<NewestJob> writer_;
};

} // namespace hygroloom
