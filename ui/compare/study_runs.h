// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs what is missing of a study in the background, one after the other on a CPU, several at a time on a GPU.
#pragma once

#include "core/analysis/run_trace.h"
#include "core/analysis/sweep.h"
#include "core/run/memory_gate.h"
#include "core/wear/garment_jobs.h"
#include "ui/compare/replicate_store.h"
#include "ui/compare/study.h"
#include "ui/compare/time_of_runs.h"

#include <QElapsedTimer>

#include <deque>
#include <thread>
#include <tuple>

namespace hygroloom {

/// Each first run is recorded as an ordinary run of the project; of the other replicates the numbers, curves and a few maps are stored.
/// What was started runs on the design as it was then.
class StudyRuns : public QObject {
    Q_OBJECT
public:
    StudyRuns(Document& document, ProjectRuns& runs, RunHistory& history, QObject* parent = nullptr);
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
    bool running() const { return !slots_.empty(); }
    /// What is done is kept.
    void cancel();
    State stateOf(const StudyJob& job) const;
    /// Of all runs since the first of them started, by their expected times.
    double share() const;
    /// s; none: too early to say.
    std::optional<double> timeLeft() const;
    /// "3 of 8 runs"
    QString progressText() const;
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
    struct Waiting {
        Expected expected;
        std::shared_ptr<const Design> design;
        std::filesystem::path base; ///< the project's folder, which files of garments are named from
    };
    struct Slot {
        Waiting work;
        QString recording; ///< of a run that is recorded
        double share = 0;
        QElapsedTimer clock;       ///< since it began; not while it waits for memory
        TimeOfRuns::Course course; ///< so far
        std::jthread thread;
        double seconds() const { return clock.isValid() ? 1e-3 * static_cast<double>(clock.elapsed()) : 0; }
    };
    struct Result {
        std::optional<FinishedRun> finished;   ///< of a sample
        std::optional<FinishedGarment> worn{}; ///< of a garment
        Drawn drawn;
        std::vector<TracedMap> maps; ///< of a run that is not recorded
        QString failure;
        bool ended() const { return finished || worn; }
    };
    void startNext();
    void post(std::function<void()> work);
    /// The same, unless the slot's end comes first.
    void postOf(Slot* slot, std::function<void()> work);
    Result run(const Waiting& work, const QString& recording, Slot* slot);
    void runSample(const Waiting& work, const QString& recording, Slot* slot, Result& result);
    void runGarment(const Waiting& work, const QString& recording, Slot* slot, Result& result);
    /// Starts the slot's clock once a GPU has room for so many bytes.
    void waitForRoom(Slot* slot, std::optional<MemoryGate::Pass>& pass, const std::function<std::size_t()>& bytes);
    void showProgress(Slot* slot, const RunProgress& progress);
    static Candidate candidateOf(const Result& result);
    void end(Slot* slot, const std::shared_ptr<Result>& result);
    void keepRecorded(Slot& slot, const Result& result);
    void keepNumbers(const Slot& slot, const Result& result);
    void handOver(const StudyJob& job, const Result& result);

    Document& document_;
    ProjectRuns& runs_;
    RunHistory& history_;
    ReplicateStore store_;
    RunControl control_;
    std::mutex one_on_cpu_;
    MemoryGate gate_;
    std::deque<Waiting> queue_;
    using Kind = std::tuple<std::string, std::string, Fidelity>; ///< fabric, experiment
    static Kind kindOf(const StudyJob& job) { return {job.fabric, job.experiment, job.fidelity}; }
    std::map<Kind, QString> failures_;
    QElapsedTimer clock_;
    TimeOfRuns times_;
    double all_seconds_ = 0, done_seconds_ = 0; ///< expected
    int all_ = 0, done_ = 0;
    std::vector<std::unique_ptr<Slot>> slots_; // last: their threads are joined before the rest goes
};

/// s, that a run of the project in that folder is expected to take; 0: it cannot be known.
double secondsToRun(const Design& design, const std::filesystem::path& base, const StudyJob& job);

} // namespace hygroloom
