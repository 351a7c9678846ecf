// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs from their start to their recording, and the files that are written of them.
#include "core/base/error.h"
#include "core/base/words.h"
#include "ui/basics/ask.h"
#include "ui/basics/language.h"
#include "ui/compare/run_list.h"
#include "ui/document/run_folder.h"
#include "ui/document/sources.h"
#include "ui/garment/garment_view.h"
#include "ui/garment/run_form.h"
#include "ui/garment/worn_report.h"
#include "ui/results/project_runs.h"
#include "ui/results/report_file.h"
#include "ui/results/run_history.h"
#include "ui/results/run_questions.h"
#include "ui/window/file_names.h"
#include "ui/window/folder_dialog.h"
#include "ui/window/garment_workspace.h"

#include <QAction>
#include <QDateTime>
#include <QDir>
#include <QEventLoop>
#include <QFileDialog>
#include <QMainWindow>

#include <utility>

namespace hygroloom {
namespace {

/// A folder of that name that is not there yet, so that no file is overwritten.
QString mapFolder(const QString& above, const QString& wish)
{
    const auto path = [&](const std::string& name) { return QDir(above).filePath(QString::fromStdString(name)); };
    return path(free_name(wish.toStdString(), [&](const std::string& name) { return QFileInfo::exists(path(name)); }));
}

/// The folder from which a recorded design names its files: that of the recording, or the one above, as a project's runs lie; empty: its
/// files are in neither.
QString folderOfSources(const Design& recorded, const QString& recording)
{
    std::vector<std::string> files;
    for (const Garment& garment : recorded.garments) {
        if (!garment.is_built_in()) { files.push_back(garment.source); }
        if (garment.wearer.zones.ends_with(".csv")) { files.push_back(garment.wearer.zones); }
    }
    for (const WearExperiment& wear : recorded.wears) {
        if (!wear.activity_file.empty()) { files.push_back(wear.activity_file); }
    }
    const QString own = QFileInfo(recording).absolutePath();
    for (const QString& folder : {own, QFileInfo(own).absolutePath()}) {
        for (const std::string& file : files) {
            if (QFileInfo::exists(QDir(folder).filePath(QString::fromStdString(file)))) { return folder; }
        }
    }
    return {};
}

/// Whether it is of the design as it is now, its garment cut alike.
bool isAsDesigned(const KeptRun& kept, const Design& design)
{
    return garmentHoldsFor(kept.run->design, kept.run->fabric, kept.run->experiment, design);
}

bool isRecordedWhole(const QString& file, std::size_t frames)
{
    try {
        const WearRecording recording(file.toStdString());
        return recording.finished() && static_cast<std::size_t>(recording.frames()) == frames;
    } catch (const Error&) {
        return false;
    }
}

} // namespace

void GarmentWorkspace::connectRun()
{
    connect(&run_, &GarmentRun::started, &playback_, &WearPlayback::begin);
    connect(&run_, &GarmentRun::memoryIsShort, this, [this] { Q_EMIT messageShown(memoryWarning(), 10000); });
    connect(&run_, &GarmentRun::deviceFailed, this, [this](const QString& sentence) { Q_EMIT messageShown(sentence, 10000); });
    connect(&run_, &GarmentRun::frameArrived, &playback_, &WearPlayback::append);
    connect(&run_, &GarmentRun::ended, this, &GarmentWorkspace::finishRun);
    connect(&run_, &GarmentRun::pausedChanged, this, &GarmentWorkspace::refreshActions);
    form_->setPlace([this] { return reserve(); });
    connect(form_, &RunForm::stopRequested, this, &GarmentWorkspace::stopByHand);
    connect(&runs_, &ProjectRuns::moved, &playback_, &WearPlayback::move);
    connect(list_, &RunList::openRequested, this, &GarmentWorkspace::showEarlierRun);
    connect(list_, &RunList::markRequested, &runs_, &ProjectRuns::setMarked);
    connect(list_, &RunList::forgetRequested, &runs_, &ProjectRuns::forget);
    connect(form_, &RunForm::canRunChanged, this, &GarmentWorkspace::refreshActions);
    connect(&playback_, &WearPlayback::runChanged, this, &GarmentWorkspace::refreshActions);
    connect(&playback_, &WearPlayback::framesChanged, this, &GarmentWorkspace::refreshActions);
    connect(view_, &GarmentView::offerTaken, this, [this] {
        if (const QString path = offered_; !path.isEmpty()) { showEarlierRun(path); }
    });
    connect(&playback_, &WearPlayback::runChanged, this, &GarmentWorkspace::refreshOffer);
    connect(&history_, &RunHistory::changed, this, &GarmentWorkspace::refreshOffer);
    connect(&choice_, &GarmentChoice::changed, this, &GarmentWorkspace::refreshOffer);
}

/// The newest run of the project that shows the chosen garment in the chosen experiment, before others one of the design as it is;
/// nullptr: there is none.
const KeptRun* GarmentWorkspace::keptOfChosen() const
{
    const KeptRun* found = nullptr;
    const auto isOfDesign = [this](const KeptRun& kept) { return isAsDesigned(kept, *document_.design()); };
    if (!choice_.garment() || !choice_.wear()) { return found; }
    for (const KeptRun& kept : history_.runs()) {
        const bool fits = kept.worn && kept.own && kept.problem.isEmpty() && kept.run->fabric == choice_.garment()->name &&
                          kept.run->experiment == choice_.wear()->name;
        if (fits && (!found || isOfDesign(kept) || !isOfDesign(*found))) { found = &kept; }
    }
    return found;
}

/// While no run is on screen, once the project's runs are found.
void GarmentWorkspace::refreshOffer()
{
    const KeptRun* kept = playback_.run() || history_.listing() ? nullptr : keptOfChosen();
    offered_ = kept ? kept->path : QString();
    if (!kept) {
        view_->setOffer({}, {});
        return;
    }
    const QDateTime made = QDateTime::fromString(QString::fromStdString(kept->run->date), Qt::ISODate).toLocalTime();
    const QString when = shortMoment(made);
    view_->setOffer(isAsDesigned(*kept, *document_.design())
                        ? tr("A run of this garment is kept with the project.")
                        : tr("A run of this garment is kept with the project; it is of an older design."),
                    tr("Open the kept run of %1").arg(when));
}

QString GarmentWorkspace::reserve()
{
    try {
        return run_path_ = runs_.reserve();
    } catch (const Error& error) {
        Q_EMIT problemFound(QString::fromUtf8(error.what()));
        return {};
    }
}

void GarmentWorkspace::finishRun(GarmentRun::Outcome outcome, const QString& sentence)
{
    QString at;
    if (!run_path_.isEmpty()) {
        at = runs_.settle(run_path_);
        if (const auto& run = playback_.run(); run && run->file == run_path_) { run->file = at; }
        run_path_.clear();
    }
    playback_.end();
    const bool by_hand = std::exchange(stopped_by_hand_, false) || run_.stoppedInList(outcome);
    const bool asks_to_keep = by_hand && outcome == GarmentRun::Outcome::cancelled && !at.isEmpty();
    if (asks_to_keep && !wantsStoppedRun(&window_, at)) {
        playback_.discard();
        runs_.forget(at);
    }
    if (opening_ && outcome == GarmentRun::Outcome::finished && playback_.run() && playback_.run()->file == to_take_ && mayTakeDesign()) {
        takeDesign();
    }
    to_take_.clear();
    keepRun();
    if (outcome == GarmentRun::Outcome::failed || outcome == GarmentRun::Outcome::device_failed) { Q_EMIT problemFound(sentence); }
    const bool asks = outcome == GarmentRun::Outcome::memory_short;
    opening_ = false;
    refreshActions();
    if (asks && wantsBeyondMemory(&window_, sentence)) { form_->start(true); }
}

void GarmentWorkspace::keepRun()
{
    const std::shared_ptr<WornRun>& run = playback_.run();
    if (!run || run->frames.empty() || !QFileInfo::exists(run->file)) { return; }
    KeptRun kept{run->file, runOfGarment(*run->record, run->wall), nullptr};
    kept.worn = true;
    kept.numbers = numbersOf(*run);
    kept.own = runs_.owns(run->file);
    kept.saved = !kept.own || runs_.isFiled(run->file);
    kept.number = kept.own ? runNumber(run->file) : 0;
    history_.keep(kept);
    if (!kept.own) { Q_EMIT recordingUsed(run->file); }
}

void GarmentWorkspace::chooseRecording()
{
    const QString file =
        QFileDialog::getOpenFileName(&window_, tr("Open Recording of a Garment"), folderOf(document_), tr("Recordings (*.hygrorec)"));
    if (!file.isEmpty()) { openRecording(file); }
}

void GarmentWorkspace::openRecording(const QString& path)
{
    showEarlierRun(path);
    if (opening_) { to_take_ = path; }
}

void GarmentWorkspace::showEarlierRun(const QString& path)
{
    if (run_.running()) {
        Q_EMIT problemFound(opening_ ? tr("Another recording is being opened.")
                                     : tr("A garment is being worn. Stop that run, then open the recording."));
        return;
    }
    opening_ = true;
    to_take_.clear();
    run_.open(path.toStdString());
    refreshActions();
    Q_EMIT wanted();
}

/// A project with changes or runs stays: nobody asked to close it.
bool GarmentWorkspace::mayTakeDesign() const
{
    const auto& runs = history_.runs();
    return !document_.modified() && !runs_.recording() &&
           std::none_of(runs.begin(), runs.end(), [](const KeptRun& run) { return run.own; });
}

void GarmentWorkspace::takeDesign()
{
    const std::shared_ptr<WornRun> run = playback_.run();
    if (!run || run_.running()) { return; }
    const Design& recorded = run->record->design;
    taking_ = true; // the run stays on screen
    document_.take(movedSources(recorded, folderOfSources(recorded, run->file), {}),
                   tr("Design of %1").arg(QFileInfo(run->file).fileName()));
    taking_ = false;
    chooseWhatRan();
}

/// Chooses the garment and the experiment of the run on screen.
void GarmentWorkspace::chooseWhatRan()
{
    const WearLayout& layout = playback_.run()->layout();
    const Design& design = *document_.design();
    for (std::size_t k = 0; k < design.garments.size(); ++k) {
        if (design.garments[k].name == layout.garment) { choice_.setGarmentIndex(static_cast<int>(k)); }
    }
    for (std::size_t k = 0; k < design.wears.size(); ++k) {
        if (design.wears[k].name == layout.experiment) { choice_.setWearIndex(static_cast<int>(k)); }
    }
}

/// The colours as on screen, of single cells.
WearMapOptions GarmentWorkspace::mapOptions() const
{
    WearMapOptions options;
    options.crossings = 1;
    options.scale = playback_.value() == WearValue::water ? WearScale::same : WearScale::capacity;
    options.steps = playback_.steps();
    return options;
}

/// The page is made in the background, and set as PDF by Qt in this thread.
void GarmentWorkspace::saveReport()
{
    const std::shared_ptr<WornRun> run = playback_.run();
    if (!run || !run->metrics || run->frames.empty()) { return; }
    const WearLayout& layout = run->layout();
    const QString file = askForReportFile(&window_, folderOf(document_), QString::fromStdString(layout.garment + ", " + layout.experiment));
    if (file.isEmpty()) { return; }
    Q_EMIT messageShown(tr("Making the report."), 4000);
    reporter_.run([this, state = stateOf(*run), options = mapOptions(), file](const NewestJob::Turn& turn) {
        const ReportPage page = reportOf(state, options);
        turn.deliver([this, page, file] {
            try {
                writeReport(page, file);
                Q_EMIT messageShown(tr("Saved %1.").arg(file), 4000);
            } catch (const std::exception& error) {
                Q_EMIT problemFound(QString::fromUtf8(error.what()));
            }
        });
    });
}

/// In the background: the files of a fine map are large.
void GarmentWorkspace::saveMap()
{
    const auto frame = playback_.frame();
    if (!frame) { return; }
    const QString above = askForFolder(&window_, tr("Save Map in a Folder"), folderOf(document_));
    if (above.isEmpty()) { return; }
    const QString folder =
        mapFolder(above, tr("%1 at %2 s").arg(QString::fromStdString(playback_.run()->layout().garment)).arg(frame->time));
    if (!QDir().mkpath(folder)) {
        Q_EMIT problemFound(tr("%1: The folder cannot be made.").arg(folder));
        return;
    }
    const WearMapOptions options = mapOptions();
    saver_.run([this, run = playback_.run(), record = playback_.run()->record, frame, options, folder](const NewestJob::Turn& turn) {
        QString why;
        std::size_t files = 0;
        try {
            files = write_wear_map(record->layout, *frame, wear_map(record->layout, *frame, options), folder.toStdString()).size();
        } catch (const std::exception& error) {
            why = QString::fromUtf8(error.what());
        }
        turn.deliver([this, why, files, folder] {
            if (why.isEmpty()) {
                Q_EMIT messageShown(tr("Saved %1 files to %2.").arg(files).arg(folder), 4000);
            } else {
                Q_EMIT problemFound(why);
            }
        });
    });
}

void GarmentWorkspace::chooseRunFile()
{
    const QString path =
        QFileDialog::getSaveFileName(&window_, tr("Save Run of a Garment"), folderOf(document_), tr("Recordings (*.hygrorec)"));
    if (!path.isEmpty()) { saveRun(withEnding(path, ".hygrorec")); }
}

void GarmentWorkspace::chooseFileOfA()
{
    const QString path = QFileDialog::getSaveFileName(&window_, tr("Save A"), folderOf(document_), tr("Recordings (*.hygrorec)"));
    if (!path.isEmpty()) { saveA(withEnding(path, ".hygrorec")); }
}

void GarmentWorkspace::saveRun(const QString& path)
{
    if (!run_.running()) { write(playback_.run(), path, recorder_); }
}

/// Also while the next run is computed.
void GarmentWorkspace::saveA(const QString& path) { write(playback_.kept(), path, recorder_of_a_); }

void GarmentWorkspace::write(const std::shared_ptr<WornRun>& run, const QString& path, NewestJob& recorder)
{
    if (!run || QFileInfo(path) == QFileInfo(run->file)) { return; }
    recorder.run([this, run, frames = run->frames, wall = run->wall, path](const NewestJob::Turn& turn) {
        QString why;
        try {
            if (wall > 0 && isRecordedWhole(run->file, frames.size())) {
                copyRecording(run->file, path);
            } else {
                WearWriter writer(path.toStdString(), *run->record);
                for (const auto& frame : frames) { writer.append(*frame); }
                if (wall > 0) { writer.finish(wall); }
            }
        } catch (const std::exception& error) {
            why = QString::fromUtf8(error.what());
        }
        turn.deliver([this, file = run->file, why, path] {
            if (!why.isEmpty()) {
                Q_EMIT problemFound(why);
                return;
            }
            history_.markCopied(file, path);
            history_.forget(path); // an older recording at that place
            Q_EMIT recordingUsed(path);
            Q_EMIT messageShown(tr("Saved the run to %1.").arg(path), 4000);
        });
    });
}

void GarmentWorkspace::stopByHand()
{
    stopped_by_hand_ = run_.computing();
    run_.cancel();
}

bool GarmentWorkspace::agreesToStopRun()
{
    return opening_ || !run_.running() ||
           confirm(&window_, tr("A garment is being worn"), tr("Stop the run of the garment?"),
                   tr("What is recorded up to now is kept with the project's runs."), tr("Stop the Run"));
}

/// Until the run has ended the window is drawn, but takes no input.
void GarmentWorkspace::stopRun()
{
    if (!run_.running()) { return; }
    QEventLoop end;
    connect(&run_, &GarmentRun::ended, &end, &QEventLoop::quit);
    run_.cancel();
    if (run_.running()) { end.exec(QEventLoop::ExcludeUserInputEvents); }
}

void GarmentWorkspace::clearResults()
{
    if (!run_.running() && !taking_) { playback_.clear(); }
}

} // namespace hygroloom
