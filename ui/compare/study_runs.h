// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs what is missing of a comparison, in the window's queue.
#pragma once

#include "core/analysis/run_trace.h"
#include "ui/compare/replicate_store.h"
#include "ui/compare/study.h"
#include "ui/compare/time_of_runs.h"
#include "ui/results/window_queue.h"

#include <QElapsedTimer>

#include <tuple>

namespace hygroloom {

/// Each first run is recorded as an ordinary run of the project; of the other replicates the numbers, curves and a few maps are stored.
/// What was started runs on the design as it was then.
class StudyRuns : public QObject {
    Q_OBJECT
public:
    StudyRuns(Document& document, ProjectRuns& runs, RunHistory& history, WindowQueue& queue, QObject* parent = nullptr);
    /// Cancels and waits, 0.2 s or so.
    ~StudyRuns() override;

    /// A run and the time that it is expected to take; 0: not known.
    struct Expected {
        StudyJob job;
        double seconds = 0;
        std::shared_ptr<const Design> design{}; ///< of a mixture; nullptr: the document's
    };
    enum class State { none, waiting, running };

    const ReplicateStore& store() const { return store_; }
    /// Adds those that are neither waiting nor running. Precondition: validate() finds no error in the design.
    /// false: it takes none, because a cancel is just ending.
    bool start(const std::vector<Expected>& jobs);
    bool running() const { return !works_.empty(); }
    /// What is done is kept.
    void cancel();
    State stateOf(const StudyJob& job) const;
    /// Of all runs since the first of them started, by their expected times.
    double share() const;
    /// s; none: too early to say.
    std::optional<double> timeLeft() const;
    /// "3 of 8 runs done"
    QString progressText() const;
    /// The same as a sentence, with the time that is left, or that they are paused.
    QString stateText() const;
    /// In the list of runs; none goes on.
    bool paused() const;
    /// Why the last run of this kind failed, in a sentence; empty: it did not.
    QString failureOf(const StudyJob& job) const;

Q_SIGNALS:
    /// A run began or ended, or numbers came.
    void changed();
    void progressed();
    /// A mixture's run gave this, or failed; it is kept nowhere.
    void mixtureEnded(const hygroloom::StudyJob& job, const hygroloom::Candidate& candidate);
    /// All are done or cancelled.
    void ended();
    void failed(const QString& sentence);

private:
    /// A run that waits or is on.
    struct Work {
        Expected expected;
        std::shared_ptr<const Design> design;
        std::filesystem::path base; ///< the project's folder, which files of garments are named from
        int batch = 0;              ///< in the queue
        State state = State::waiting;
        bool paused = false;
        QString recording{}; ///< of a run that is recorded
        double share = 0, wall = 0;
        TimeOfRuns::Course course{}; ///< so far
        MapTracer tracer{};          ///< of a run that is not recorded; in its thread
    };
    using WorkPtr = std::shared_ptr<Work>;

    void post(std::function<void()> work);
    RunJob jobOf(const WorkPtr& work);
    QString reserved(const WorkPtr& work);
    void showProgress(const WorkPtr& work, const RunProgress& progress);
    static Candidate candidateOf(const RunResult& result);
    void end(const WorkPtr& work, const std::shared_ptr<RunResult>& result);
    void setPaused(int batch, bool paused);
    void endBatch(int batch);
    void keepRecorded(const Work& work, const RunResult& result, const QString& failure);
    void keepNumbers(Work& work, const RunResult& result);
    void handOver(const StudyJob& job, const RunResult& result, const QString& failure);

    Document& document_;
    ProjectRuns& runs_;
    RunHistory& history_;
    WindowQueue& queue_;
    ReplicateStore store_;
    std::atomic<bool> stopping_ = false;
    std::vector<WorkPtr> works_;                                 ///< in order
    using Kind = std::tuple<std::string, std::string, Fidelity>; ///< fabric, experiment
    static Kind kindOf(const StudyJob& job) { return {job.fabric, job.experiment, job.fidelity}; }
    std::map<Kind, QString> failures_;
    QElapsedTimer clock_;
    TimeOfRuns times_;
    double all_seconds_ = 0, done_seconds_ = 0; ///< expected
    int all_ = 0, done_ = 0;
};

/// s, that a run of the project in that folder is expected to take; 0: it cannot be known.
double secondsToRun(const Design& design, const std::filesystem::path& base, const StudyJob& job);

} // namespace hygroloom
