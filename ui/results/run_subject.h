// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the workspace Run is of: a sample of a fabric, or a garment. It has the same run, panel, time and history whichever it is.
#pragma once

#include "ui/basics/newest_job.h"
#include "ui/results/queued_run.h"
#include "ui/results/run_history.h"
#include "ui/results/shown_run.h"

#include <array>

class QWidget;

namespace hygroloom {

/// What a run of one fidelity is expected to be.
struct RunForecast {
    QString text, tip;               ///< what it takes, in a few words and as HTML; empty: not known
    QString about;                   ///< a sentence to stand below; empty: there is none
    QString problem;                 ///< why it cannot run, in a sentence; empty: it can
    std::optional<ModelPlan> plan{}; ///< of a sample
};
using RunForecasts = std::array<RunForecast, all_fidelities.size()>;

class RunSubject : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// The run that is on screen.
    virtual ShownRun& shown() = 0;
    /// The fields of its experiment, and the numbers of the run that is shown.
    virtual QWidget* form() = 0;
    virtual QWidget* results() = 0;

    /// Why nothing can be run now, in a sentence; empty: something can.
    virtual QString whyNot() const = 0;
    /// In a few words; empty: there is nothing to say.
    virtual QString aboutFidelity(Fidelity) const { return {}; }
    /// Work for a thread of its own that finds what the runs are expected to be, of dear ones that of the chosen fidelity alone. machine:
    /// "cpu" or "cuda". Precondition: whyNot() is empty.
    virtual std::function<RunForecasts(const NewestJob::Turn&)> forecast(Fidelity chosen, const std::string& machine) const = 0;
    /// As long as the text of a forecast is at most, for which room is kept.
    virtual QString longForecast() const = 0;
    /// Whether forecasts have plans.
    virtual bool hasPlan() const = 0;
    /// The fabric or garment and the experiment that would be run. Precondition: whyNot() is empty.
    virtual std::pair<QString, QString> chosen() const = 0;
    /// Starts it and shows it. Precondition: the run is not running().
    virtual void start(QueuedRun& run, RunOptions how, const std::string& backend) = 0;

    /// What is on screen, for the history; none while its numbers are not whole.
    virtual std::optional<KeptRun> listed() const = 0;
    /// The design of the run on screen, as a project takes it.
    virtual Design recordedDesign() { return *shown().design(); }
    /// Chooses in the project what ran.
    virtual void chooseWhatRan() = 0;
    /// The numbers, maps and curves of the run on screen as PDF or web page; messageShown() or problemFound() follows.
    virtual void saveReport(const QString& file) = 0;
    /// Which commands can be chosen. running: a run is computed. Only what is on screen has commands in the tool bar.
    virtual void refreshActions(bool running, bool on_screen) = 0;

Q_SIGNALS:
    /// What would be run, or whyNot().
    void changed();
    void problemFound(const QString& sentence);
    /// For the status bar, for a time in ms.
    void messageShown(const QString& sentence, int ms);
    /// There is something to see here.
    void wanted();
    /// A run that is kept shall be shown.
    void runWanted(const QString& recording);
    /// The user wants to edit the design of the run on screen.
    void designRequested();
};

} // namespace hygroloom
