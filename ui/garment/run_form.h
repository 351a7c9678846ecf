// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The dock that runs the experiment: fidelity, device, Run, Pause and Stop, progress.
#pragma once

#include "ui/garment/garment_choice.h"
#include "ui/garment/garment_run.h"

#include <QWidget>

class QButtonGroup;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace hygroloom {

class RunForm : public QWidget {
    Q_OBJECT
public:
    RunForm(GarmentChoice& choice, GarmentRun& run, QWidget* parent = nullptr);

    Fidelity fidelity() const;
    void setFidelity(Fidelity fidelity);
    std::string backend() const;
    /// Whether a run could start now; else why not, in a sentence.
    bool canRun(QString* reason = nullptr) const;
    /// Starts the chosen experiment. beyond_memory: also where it takes more than is free.
    void start(bool beyond_memory = false);
    /// Who says where a run is recorded; empty: it cannot be, and the run does not start. Without, runs are not recorded.
    void setPlace(std::function<QString()> place) { place_ = std::move(place); }

Q_SIGNALS:
    void canRunChanged();
    void stopRequested();

private:
    void addFidelities();
    void addDevices();
    void estimate();
    void showState();
    void showProgress(const RunProgress& progress);
    void showEnd(GarmentRun::Outcome outcome, const QString& sentence);

    GarmentChoice& choice_;
    GarmentRun& run_;
    QButtonGroup* fidelities_;
    QLabel* expected_;
    QComboBox* device_;
    std::function<QString()> place_;
    QPushButton* start_;
    QPushButton* pause_;
    QPushButton* stop_;
    QProgressBar* bar_;
    QLabel* state_;
    bool blocked_ = false; ///< the state says why nothing can run
    NewestJob planner_;
};

} // namespace hygroloom
