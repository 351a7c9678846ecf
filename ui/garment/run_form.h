// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The dock that runs the experiment: fidelity, device, Run, Pause and Stop, progress, recording.
#pragma once

#include "ui/garment/garment_choice.h"
#include "ui/garment/garment_run.h"

#include <QWidget>

class QButtonGroup;
class QCheckBox;
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
    /// Starts the chosen experiment.
    void start();
    /// Where the next run is recorded; empty: nowhere.
    void setRecording(const QString& file);

Q_SIGNALS:
    void canRunChanged();

private:
    void addFidelities();
    void addDevices();
    void chooseRecording(bool record);
    void estimate();
    void showState();
    void showProgress(const RunProgress& progress);
    void showEnd(GarmentRun::Outcome outcome, const QString& sentence);

    GarmentChoice& choice_;
    GarmentRun& run_;
    QButtonGroup* fidelities_;
    QLabel* expected_;
    QComboBox* device_;
    QCheckBox* record_;
    QString recording_;
    QPushButton* start_;
    QPushButton* pause_;
    QPushButton* stop_;
    QProgressBar* bar_;
    QLabel* state_;
    bool blocked_ = false; ///< the state says why nothing can run
    NewestJob planner_;
};

} // namespace hygroloom
