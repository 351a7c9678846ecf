// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The numbers of the chosen fabric's card, as far as they are there: some at once, some computed in the background, some run.
#pragma once

#include "core/analysis/card.h"
#include "ui/basics/newest_job.h"
#include "ui/document/document.h"
#include "ui/results/window_queue.h"

#include <atomic>
#include <set>
#include <thread>

namespace hygroloom {

class CardNumbers : public QObject {
    Q_OBJECT
public:
    /// Document and queue must outlive it.
    CardNumbers(Document& document, WindowQueue& queue, QObject* parent = nullptr);
    /// Cancels and waits, 0.2 s or so.
    ~CardNumbers() override;

    /// Whether the card keeps up with the chosen fabric; otherwise nothing is computed. Tests that are on go on while
    /// their cloth is in the project.
    void follow(bool on);
    struct Row {
        LaboratoryNumber number;
        bool known = false;
    };
    /// In the order of the card; those that are not ready stand without a value.
    std::vector<Row> rows() const;
    /// As far as it is known; nullptr: it is being computed, or the fabric has an error.
    const std::shared_ptr<const Card>& card() const { return card_; }
    bool computing() const { return job_.busy(); }
    bool running() const { return running_; }
    /// In the queue of runs.
    bool paused() const { return running_ && paused_; }
    /// Whether a test has not been run.
    bool canRun() const;
    /// Runs the tests that were not, at the fidelity live. Precondition: canRun().
    void run();
    void cancel() { cancel_ = true; }

Q_SIGNALS:
    void changed();
    /// Of the runs, 0 to 1.
    void progressed(double share);
    void failed(const QString& sentence);

private:
    void take();
    bool isIn(const Design& design) const;
    void relabel(const std::shared_ptr<const Design>& design, int fabric);
    /// Those that are on, of a cloth that is another now; says so.
    void stopTests();
    /// What is run beside the window.
    struct Task {
        int cloth = 0;
        std::shared_ptr<const Design> design;
        int fabric = 0;
        std::shared_ptr<const Card> card; ///< as far as it is known
        std::vector<std::string> tests;
    };
    /// In the thread. Throws Cancelled and Error.
    void runTests(const Task& task);
    void give(const Task& task, const LaboratoryNumbers& numbers, const std::set<std::string>& tested);
    void post(std::function<void()> work);

    Document& document_;
    WindowQueue& queue_;
    bool follows_ = false;
    std::shared_ptr<const Design> design_; ///< whose fabric the card is of
    int fabric_ = -1;
    int cloth_ = 0; ///< counts the cloths that it was of
    std::shared_ptr<const Card> card_;
    std::vector<Row> before_;      ///< of the card before, while this one is computed
    std::set<std::string> tested_; ///< tests that came to an end
    NewestJob job_;
    std::atomic<bool> cancel_ = false;
    bool running_ = false, paused_ = false;
    std::jthread thread_; // last: it ends before the rest goes
};

} // namespace hygroloom
