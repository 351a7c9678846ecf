// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where the runs of the open project lie: in the folder beside its file, until it has one beside the window's unsaved work.
#pragma once

#include "ui/basics/newest_job.h"
#include "ui/document/run_folder.h"

#include <QObject>
#include <QStringList>

#include <vector>

namespace hygroloom {

class Document;
class Recovery;
class RunHistory;
struct KeptRun;

/// What a killed run left beside its recording goes into it, before that is copied or moved.
void makeOneFile(const QString& recording);

/// A run of the project without its frames; of one that cannot be read the reason.
KeptRun listedRun(const QString& path);

/// Finds the runs of a project when it is opened, and takes them along when it is saved elsewhere: at once where they can share their
/// bytes, else copied in the background. Deletes none but by forget() and leave().
class ProjectRuns : public QObject {
    Q_OBJECT
public:
    ProjectRuns(Document& document, Recovery& recovery, RunHistory& history, QObject* parent = nullptr);

    /// Where its runs lie now.
    QString folder() const;
    /// The path for the next run's recording. Where the project's folder cannot be written, messageShown() says so, and it lies beside
    /// unsaved work. Throws Error when neither can be.
    QString reserve();
    /// The run that was recorded there is over. Returns where its recording lies now; empty when nothing was recorded. moved() may follow.
    QString settle(const QString& recording);

    /// Whether a run is being recorded.
    bool recording() const { return !live_.isEmpty(); }
    /// Whether a recording is a run of the open project.
    bool owns(const QString& recording) const;
    /// Whether it lies with the project's file.
    bool isFiled(const QString& recording) const;
    /// Runs that lie nowhere but beside unsaved work, with the one in progress where it will stay there.
    QStringList unfiled() const;
    /// unfiled() may be deleted with leave(): its deletion was agreed to, or none is the only one.
    void agreeToLeave();
    /// Nobody leaves after all.
    void stay() { agreed_.clear(); }
    /// Another project follows, or the end.
    void leave();

    /// Adds the runs of work that was recovered.
    void takeFrom(const QString& folder);
    /// The oldest runs that are not marked, as many as must go so that the project's take no more than this; empty where they do not.
    QStringList beyond(double bytes) const;
    /// Deletes a run of the project; a recording that the list has as opened only leaves the list, as nobody was asked about its deletion.
    void forget(const QString& recording);
    void setMarked(const QString& recording, bool marked);
    /// Whether the frames of the runs are needed for their numbers; the list needs none.
    void setCompared(bool compared);
    /// Whether runs are still being copied.
    bool copying() const { return !waiting_.empty(); }

Q_SIGNALS:
    /// A run was added to the project's folder.
    void grown();
    /// The runs of that folder are about to come to this project's.
    void following(const QString& from);
    void moved(const QString& from, const QString& to);
    /// Of the recording that is being copied, the share that is.
    void copied(double share);
    void copiesEnded();
    void failed(const QString& sentence);
    /// For the status bar, for a time in ms.
    void messageShown(const QString& sentence, int ms);

private:
    QStringList unsaved() const;
    void openProject();
    void followProject();
    void bring(const QStringList& recordings);
    void copyNext();
    void takeMoved(const QString& from, const QString& to);
    bool isWaiting(const QString& recording) const;
    void read();
    void add(KeptRun run);
    void readNumbers();

    Document& document_;
    Recovery& recovery_;
    RunHistory& history_;
    QString known_;      ///< the folder of the project as it was last seen
    QStringList live_;   ///< what is being recorded
    QStringList agreed_; ///< what leave() deletes
    struct Waiting {
        QString from, folder;
        Bring how;
    };
    std::vector<Waiting> waiting_; ///< to be copied, the first is under way
    bool compared_ = false;
    NewestJob loader_;  ///< of the list
    NewestJob numbers_; ///< of frames
    NewestJob copier_;
};

} // namespace hygroloom
