// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs from their start to their recording.
#include "core/base/error.h"
#include "ui/basics/ask.h"
#include "ui/basics/preferences.h"
#include "ui/basics/typed_value.h"
#include "ui/document/document.h"
#include "ui/document/run_folder.h"
#include "ui/panels/droplet_section.h"
#include "ui/panels/experiment_panel.h"
#include "ui/picture/viewport.h"
#include "ui/results/project_runs.h"
#include "ui/results/report_file.h"
#include "ui/results/results_panel.h"
#include "ui/results/run_history.h"
#include "ui/results/run_questions.h"
#include "ui/results/simulation_panel.h"
#include "ui/results/water_map_view.h"
#include "ui/window/file_names.h"
#include "ui/window/folder_dialog.h"
#include "ui/window/run_film.h"
#include "ui/window/simulate_workspace.h"

#include <QDir>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QScopedValueRollback>

#include <algorithm>
#include <utility>

namespace hygroloom {

namespace {

constexpr char film_stem[] = "run"; // of the pictures' names

} // namespace

void SimulateWorkspace::connectRun()
{
    connect(&run_, &SimulationRun::started, this, [this](const std::shared_ptr<const RunRecord>& run) { playback_.begin(run, run_path_); });
    connect(&run_, &SimulationRun::memoryIsShort, this, [this] { Q_EMIT messageShown(memoryWarning(), 10000); });
    connect(&run_, &SimulationRun::frameArrived, &playback_, &Playback::append);
    connect(&run_, &SimulationRun::completed, &playback_, &Playback::complete);
    connect(&run_, &SimulationRun::pausedChanged, this, &SimulateWorkspace::refreshActions);
    connect(&run_, &SimulationRun::ended, this, &SimulateWorkspace::showRunEnd);
    connect(&runs_, &ProjectRuns::moved, &playback_, &Playback::move);
    connect(&runs_, &ProjectRuns::copied, this, [this](double share) {
        Q_EMIT messageShown(tr("Copying runs to the project: %1 %").arg(static_cast<int>(100 * share)), 4000);
    });
    connect(&runs_, &ProjectRuns::failed, this, &SimulateWorkspace::problemFound);
    connect(&runs_, &ProjectRuns::messageShown, this, &SimulateWorkspace::messageShown);
}

void SimulateWorkspace::connectPlayback()
{
    connect(&playback_, &Playback::failed, this, &SimulateWorkspace::problemFound);
    connect(&playback_, &Playback::runChanged, this, [this] {
        refreshStale();
        Q_EMIT pictureChanged();
        refreshActions();
    });
    connect(&playback_, &Playback::frameShown, this, [this] {
        if (shown_ && playback_.frame()) { viewport_.showFrame(playback_.frame(), playback_.maximumSaturation()); }
        for (QAction* save : {actions_.save_top, actions_.save_bottom}) { save->setEnabled(shown_ && playback_.frame()); }
    });
    connect(&playback_, &Playback::metricsChanged, this, [this] {
        if (!playback_.live()) { viewport_.setRunMaximum(playback_.maximumSaturation()); }
        keepRun();
    });
    connect(&playback_, &Playback::opened, this, &SimulateWorkspace::takeOpened);
}

void SimulateWorkspace::startRun(bool beyond_memory)
{
    commitTypedValue(window_);
    if (!simulation_->canRun()) { return; }
    Q_EMIT wanted();
    experiment_->droplets().endPlacing();
    RunOptions options;
    options.fidelity = simulation_->fidelity();
    options.may_go_on_on_cpu = true;
    options.memory.force = beyond_memory;
    options.threads = preferences().threads;
    options.textile = std::make_shared<const Textile>(
        textile_of_run(*document_.design(), *document_.fabric(), *document_.experiment(), document_.fitted().get()));
    try {
        run_path_ = runs_.reserve();
    } catch (const Error& error) {
        Q_EMIT problemFound(QString::fromStdString(error.what()));
        return;
    }
    opening_.clear();
    playback_.stopOpening();
    options.recording = run_path_.toStdString();
    run_.start(document_.design(), document_.fabric()->name, document_.experiment()->name, options, simulation_->backend());
    refreshActions();
}

void SimulateWorkspace::showRunEnd(SimulationRun::Outcome outcome, const QString& sentence)
{
    run_path_ = runs_.settle(run_path_);
    playback_.end();
    refreshActions();
    const bool by_hand = std::exchange(stopped_by_hand_, false) || run_.stoppedInList(outcome);
    const bool asks = by_hand && outcome == SimulationRun::Outcome::cancelled && !run_path_.isEmpty();
    if (asks && !wantsStoppedRun(&window_, run_path_)) {
        playback_.clear();
        runs_.forget(run_path_);
        return;
    }
    if (!stopping_ && outcome == SimulationRun::Outcome::device_failed && simulation_->backend() != "cpu") {
        const Question question{tr("The device failed"),
                                tr("%1\n\nRun on the CPU instead?").arg(sentence),
                                {},
                                {{Reply::act, tr("&Run on the CPU")}, {Reply::cancel, tr("&Do Not Run")}},
                                Reply::act};
        if (ask(&window_, question) == Reply::act) {
            simulation_->setBackend("cpu");
            startRun();
        }
    } else if (!stopping_ && outcome == SimulationRun::Outcome::memory_short) {
        if (wantsBeyondMemory(&window_, sentence)) { startRun(true); }
    } else if (!sentence.isEmpty()) {
        Q_EMIT problemFound(sentence);
    }
}

void SimulateWorkspace::stopByHand()
{
    stopped_by_hand_ = run_.running();
    run_.cancel();
}

bool SimulateWorkspace::mayStopRun()
{
    if (!agreesToStopRun()) { return false; }
    stopRun();
    return true;
}

bool SimulateWorkspace::agreesToStopRun()
{
    if (!run_.running()) { return true; }
    const QString what =
        playback_.live() ? QString::fromStdString(playback_.run()->fabric + ", " + playback_.run()->experiment) : tr("the experiment");
    const Question question{tr("A run is in progress"),
                            tr("Stop the run of “%1”?").arg(what),
                            tr("What is recorded up to now is kept with the project's runs."),
                            {{Reply::act, tr("&Stop and Keep What Is Recorded")}, {Reply::cancel, tr("&Let It Run")}}};
    return ask(&window_, question) == Reply::act;
}

/// Until the run has ended, 0.2 s or so, the window is drawn, but takes no input.
void SimulateWorkspace::stopRun()
{
    if (!run_.running()) { return; } // it may have ended while questions were open
    const QScopedValueRollback stopping(stopping_, true);
    QEventLoop end;
    connect(&run_, &SimulationRun::ended, &end, &QEventLoop::quit);
    run_.cancel();
    if (run_.running()) { end.exec(QEventLoop::ExcludeUserInputEvents); }
}

void SimulateWorkspace::clearResults()
{
    if (!run_.running()) { playback_.clear(); }
}

bool SimulateWorkspace::openRecording(const QString& path)
{
    if (!mayStopRun()) { return false; }
    const QFileInfo info(path);
    opening_ = QDir(oneSpelling(info.absolutePath())).filePath(info.fileName());
    playback_.open(opening_);
    return true;
}

void SimulateWorkspace::showEarlierRun(const QString& recording)
{
    if (!mayStopRun()) { return; }
    opening_.clear();
    playback_.open(recording);
}

/// A project with changes or runs stays: nobody asked to close it.
bool SimulateWorkspace::mayTakeDesign() const
{
    const auto& runs = history_.runs();
    return !document_.modified() && !runs_.recording() &&
           std::none_of(runs.begin(), runs.end(), [](const KeptRun& run) { return run.own; });
}

void SimulateWorkspace::takeOpened(const QString& path)
{
    if (!runs_.owns(path)) { Q_EMIT recordingUsed(path); }
    if (path == opening_ && mayTakeDesign()) {
        document_.take(playback_.run()->design, tr("Design of %1").arg(QFileInfo(path).fileName()));
    }
    if (path != opening_ || mayTakeDesign()) { chooseWhatRan(); }
    Q_EMIT wanted();
}

/// Adds the run on screen to the history once it is complete.
void SimulateWorkspace::keepRun()
{
    const QString& path = playback_.path();
    if (!playback_.run() || !playback_.metrics() || !playback_.whole() || !QFileInfo::exists(path)) { return; }
    KeptRun kept{path, playback_.run(), playback_.metrics()};
    kept.own = runs_.owns(path);
    kept.saved = !kept.own || runs_.isFiled(path);
    kept.number = kept.own ? runNumber(path) : 0;
    history_.keep(kept);
}

void SimulateWorkspace::saveRecordingAs()
{
    if (!playback_.run() || playback_.live()) { return; }
    if (copier_.busy()) {
        Q_EMIT problemFound(tr("Another recording is still being saved. Save this one when that is done."));
        return;
    }
    const QString name = QString::fromStdString(playback_.run()->fabric + ", " + playback_.run()->experiment) + ".hygrorec";
    const QString chosen = QFileDialog::getSaveFileName(&window_, tr("Save Recording"), QDir(folderOf(document_)).filePath(name),
                                                        tr("Recordings (*.hygrorec)"));
    if (chosen.isEmpty()) { return; }
    const QString to = withEnding(chosen, ".hygrorec");
    if (QFileInfo(playback_.path()) != QFileInfo(to)) { copyRecording(playback_.path(), to); }
}

void SimulateWorkspace::saveReport()
{
    if (!playback_.run()) { return; }
    const QString name = QString::fromStdString(playback_.run()->fabric + ", " + playback_.run()->experiment);
    const QString file = askForReportFile(&window_, folderOf(document_), name);
    if (file.isEmpty()) { return; }
    try {
        writeReport(results_->report(), file);
        Q_EMIT messageShown(tr("Saved %1.").arg(file), 4000);
    } catch (const std::exception& error) {
        Q_EMIT problemFound(QString::fromStdString(error.what()));
    }
}

void SimulateWorkspace::saveMap(MapSide side)
{
    if (!playback_.run() || !playback_.frame()) { return; }
    const bool top = side == MapSide::top;
    const QString name = QString::fromStdString(playback_.run()->fabric + ", " + playback_.run()->experiment);
    const QString file =
        askForFile(&window_, top ? tr("Save Map of the Top Face") : tr("Save Map of the Bottom Face"), folderOf(document_),
                   top ? tr("%1, top").arg(name) : tr("%1, bottom").arg(name), {tr("Picture"), "png"}, {tr("Table of the cells"), "csv"});
    if (file.isEmpty()) { return; }
    try {
        maps_->save(side, file);
        Q_EMIT messageShown(tr("Saved %1.").arg(file), 4000);
    } catch (const std::exception& error) {
        Q_EMIT problemFound(QString::fromStdString(error.what()));
    }
}

RunFilm* SimulateWorkspace::makeFilm()
{
    Q_EMIT wanted(); // what is filmed is on screen
    auto* film = new RunFilm(
        playback_, [this](const QString& clock) { return viewport_.picture(clock); }, film_stem, &window_);
    connect(film, &RunFilm::saved, this, [this](const QString& sentence) { Q_EMIT messageShown(sentence, 8000); });
    connect(film, &RunFilm::failed, this, &SimulateWorkspace::problemFound);
    return film;
}

void SimulateWorkspace::savePictures()
{
    if (!playback_.run() || playback_.live()) { return; }
    const QString folder = askForFolder(&window_, tr("Folder for the Pictures"), folderOf(document_));
    if (folder.isEmpty()) { return; }
    QDir there(folder);
    const QStringList older = there.entryList({QString("%1-??????.png").arg(film_stem)}, QDir::Files);
    if (!older.isEmpty() &&
        !confirm(&window_, tr("The folder has pictures of a run"), tr("Write the pictures of this run over those in %1?").arg(folder),
                 tr("%1 pictures with such names are there.").arg(older.size()), tr("&Replace"))) {
        return;
    }
    for (const QString& name : older) { there.remove(name); } // a longer run before would leave its end
    makeFilm()->savePictures(folder);
}

void SimulateWorkspace::saveFilm()
{
    if (!playback_.run() || playback_.live()) { return; }
    const QString name = QString::fromStdString(playback_.run()->fabric + ", " + playback_.run()->experiment) + ".mp4";
    const QString chosen =
        QFileDialog::getSaveFileName(&window_, tr("Save Film"), QDir(folderOf(document_)).filePath(name), tr("Films (*.mp4)"));
    if (!chosen.isEmpty()) { makeFilm()->saveMovie(withEnding(chosen, ".mp4")); }
}

/// In the background: recordings may be large.
void SimulateWorkspace::copyRecording(const QString& from, const QString& to)
{
    copier_.run([this, from, to](const NewestJob::Turn& turn) {
        QString why;
        try {
            makeOneFile(from);
            hygroloom::copyRecording(from, to, [&](double share) {
                const int percent = static_cast<int>(100 * share);
                turn.deliver([this, to, percent] { Q_EMIT messageShown(tr("Saving %1: %2 %").arg(to).arg(percent), 4000); });
                return !turn.outdated();
            });
        } catch (const std::exception& error) {
            why = QString::fromStdString(error.what());
        }
        turn.deliver([this, from, to, why] {
            if (why.isEmpty()) {
                history_.markCopied(from, to);
                history_.forget(to); // an older recording at that place
                Q_EMIT recordingUsed(to);
                Q_EMIT messageShown(tr("Saved %1.").arg(to), 4000);
            } else {
                Q_EMIT problemFound(tr("The recording cannot be written to %1: %2").arg(to, why));
            }
        });
    });
}

} // namespace hygroloom
