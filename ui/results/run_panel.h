// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Fidelity, device, and the one big button; progress while it runs.
#pragma once

#include "ui/results/run_subject.h"

#include <QWidget>

class QButtonGroup;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace hygroloom {

class RunPanel : public QWidget {
    Q_OBJECT
public:
    RunPanel(QueuedRun& run, RunSubject& subject, QWidget* parent = nullptr);

    void setSubject(RunSubject& subject);
    Fidelity fidelity() const { return all_fidelities[chosen()]; }
    void setFidelity(Fidelity fidelity);
    std::string backend() const;
    void setBackend(const std::string& name);
    /// Whether a run could start now; else why not, in a sentence.
    bool canRun(QString* reason = nullptr) const;

public Q_SLOTS:
    void showPlan();
    /// What the runs are expected to take, anew: runs of this machine correct it.
    void refreshForecasts();

Q_SIGNALS:
    void runRequested();
    void stopRequested();
    void canRunChanged();

private:
    void addFidelities();
    void addDevices();
    void addButtons();
    void addProgress();
    std::size_t chosen() const;
    void showForecasts();
    void showState();
    void showProgress(const RunProgress& progress);
    void showEnd(QueuedRun::Outcome outcome, const QString& sentence);

    RunSubject* subject_ = nullptr;
    RunSubject* running_ = nullptr; ///< of the last run
    QueuedRun& run_;
    QButtonGroup* fidelities_;
    std::array<QLabel*, all_fidelities.size()> expected_{};
    RunForecasts forecasts_;
    QComboBox* device_;
    QPushButton* start_;
    QPushButton* pause_;
    QPushButton* stop_;
    QPushButton* why_;
    QProgressBar* bar_;
    QLabel* state_;
    bool idle_ = true; ///< the state tells of no run
    int asked_ = 0;    ///< forecasts, so far
    NewestJob forecaster_;
};

} // namespace hygroloom
