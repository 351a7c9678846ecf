// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The numbers of the open project's replicates: found when it is opened, saved in the background after each run, taken along when it is
// saved elsewhere.
#pragma once

#include "core/analysis/replicate_file.h"

#include "ui/basics/newest_job.h"

#include <QObject>
#include <QString>

namespace hygroloom {

class Document;
class ProjectRuns;

class ReplicateStore : public QObject {
    Q_OBJECT
public:
    /// After the project's runs have been told of the document: they know the folder.
    ReplicateStore(Document& document, ProjectRuns& runs, QObject* parent = nullptr);
    /// Saves what is not saved yet.
    ~ReplicateStore() override;

    const std::vector<ReplicateSet>& sets() const { return sets_; }
    /// Adds a run to its set, and saves it.
    void add(const ReplicateSet& run);

Q_SIGNALS:
    void changed();
    void failed(const QString& sentence);

private:
    void read();
    void takeAlong(const QString& from);
    void save();
    /// Now, what still waits for it. Returns why it failed.
    QString finishSaving();

    Document& document_;
    ProjectRuns& runs_;
    std::vector<ReplicateSet> sets_;
    QString unsaved_in_;                          ///< folder where sets_ are to be saved; empty: they are
    std::shared_ptr<const Design> unsaved_for_{}; ///< the project's design then
    long saves_ = 0;
    NewestJob writer_;
};

} // namespace hygroloom
