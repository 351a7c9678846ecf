// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Fidelity, device, and the one big button; progress while it runs.
#pragma once

#include "ui/basics/newest_job.h"
#include "ui/document/document.h"
#include "ui/results/simulation_run.h"

#include <QElapsedTimer>
#include <QWidget>

#include <array>

class QButtonGroup;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace hygroloom {

class SimulationPanel : public QWidget {
    Q_OBJECT
public:
    SimulationPanel(Document& document, SimulationRun& run, QWidget* parent = nullptr);

    Fidelity fidelity() const;
    void setFidelity(Fidelity fidelity);
    std::string backend() const;
    void setBackend(const std::string& name);
    /// Whether a run could start now; else why not, in a sentence.
    bool canRun(QString* reason = nullptr) const;

public Q_SLOTS:
    void showPlan();
    /// What the run is expected to take, anew: runs of this machine correct it.
    void refreshPlans();

Q_SIGNALS:
    void runRequested();
    void stopRequested();
    void canRunChanged();

private:
    void addFidelities();
    void addDevices();
    void showExpectations();
    void showState();
    void showProgress(const RunProgress& progress);
    void showEnd(SimulationRun::Outcome outcome, const QString& sentence);

    struct Expectation {
        std::optional<ModelPlan> plan;
        QString problem;
    };

    Document& document_;
    SimulationRun& run_;
    QButtonGroup* fidelities_;
    std::array<QLabel*, all_fidelities.size()> expected_{};
    std::array<Expectation, all_fidelities.size()> plans_;
    QComboBox* device_;
    QPushButton* start_;
    QPushButton* pause_;
    QPushButton* stop_;
    QPushButton* why_;
    QProgressBar* bar_;
    QLabel* state_;
    NewestJob planner_;
};

} // namespace hygroloom
