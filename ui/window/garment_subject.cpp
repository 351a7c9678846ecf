// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/garment_subject.h"

#include "core/base/error.h"
#include "core/base/words.h"
#include "ui/basics/core_words.h"
#include "ui/basics/issue_text.h"
#include "ui/basics/language.h"
#include "ui/document/sources.h"
#include "ui/garment/fit_form.h"
#include "ui/garment/garment_edits.h"
#include "ui/garment/garment_forecast.h"
#include "ui/garment/garment_panel.h"
#include "ui/garment/garment_view.h"
#include "ui/garment/panel_table.h"
#include "ui/garment/parts_table.h"
#include "ui/garment/wear_form.h"
#include "ui/garment/worn_report.h"
#include "ui/garment/zones_form.h"
#include "ui/results/report_file.h"
#include "ui/window/command.h"
#include "ui/window/file_names.h"
#include "ui/window/folder_dialog.h"

#include <QDateTime>
#include <QDir>
#include <QMainWindow>

namespace hygroloom {
namespace {

/// A folder of that name that is not there yet, so that no file is overwritten.
QString mapFolder(const QString& above, const QString& wish)
{
    const auto path = [&](const std::string& name) { return QDir(above).filePath(QString::fromStdString(name)); };
    return path(free_name(wish.toStdString(), [&](const std::string& name) { return QFileInfo::exists(path(name)); }));
}

/// Whether it is of the design as it is now, its garment cut alike.
bool isAsDesigned(const KeptRun& kept, const Design& design)
{
    return kept.current && garmentHoldsFor(kept.run->design, kept.run->fabric, kept.run->experiment, design);
}

} // namespace

GarmentSubject::GarmentSubject(Document& document, RunHistory& history, QMainWindow& window)
    : document_(document), history_(history), window_(window), choice_(document), garment_(new GarmentPanel(choice_)),
      fit_(new FitForm(choice_)), wear_(new WearForm(choice_)), parts_(new PartsTable(playback_)),
      view_(new GarmentView(choice_, playback_))
{
    connectParts();
    connect(&choice_, &GarmentChoice::changed, this, &RunSubject::changed);
    connect(&choice_, &GarmentChoice::drawingChanged, this, &RunSubject::changed);
    connect(&playback_, &WearPlayback::runChanged, this, &GarmentSubject::refreshOffer);
    connect(&history_, &RunHistory::changed, this, &GarmentSubject::refreshOffer);
    connect(&choice_, &GarmentChoice::changed, this, &GarmentSubject::refreshOffer);
}

void GarmentSubject::connectParts()
{
    connect(view_, &GarmentView::panelClicked, this, [this](int panel) {
        view_->setChosenPanel(panel);
        garment_->panels().choosePanel(panel);
    });
    connect(&fit_->ownZones(), &ZonesForm::drawingWanted, view_, &GarmentView::setOutlining);
    connect(view_, &GarmentView::outliningEnded, &fit_->ownZones(), [this] { fit_->ownZones().setDrawing(false); });
    connect(view_, &GarmentView::designRequested, this, &RunSubject::designRequested);
    connect(view_, &GarmentView::offerTaken, this, [this] {
        if (const QString path = offered_; !path.isEmpty()) { Q_EMIT runWanted(path); }
    });
    connect(&garment_->panels(), &PanelTable::panelChosen, view_, &GarmentView::setChosenPanel);
    connect(garment_, &GarmentPanel::problemFound, this, &RunSubject::problemFound);
}

void GarmentSubject::fillMenu(QMenu* menu)
{
    for (const std::string& kind : built_in_garments()) {
        const QString name = coreWord(kind);
        connect(
            addCommand(menu, "add", tr("Add Built-in %1").arg(name), {}, tr("Add a %1 and an experiment in which it is worn.").arg(name)),
            &QAction::triggered, this, [this, kind] { choice_.setGarmentIndex(addBuiltInGarment(document_, kind)); });
    }
    connect(addCommand(menu, {}, tr("Add Garment from a &File…"), {}, tr("Add a sewing pattern, or a mesh with flat coordinates.")),
            &QAction::triggered, garment_, &GarmentPanel::addFile);
    remove_ = addCommand(menu, "delete", tr("Remove &Garment"), {}, {});
    connect(remove_, &QAction::triggered, garment_, &GarmentPanel::removeChosen);
    menu->addSeparator();
    menu->setToolTipsVisible(true); // why a command cannot be chosen
    keep_ = addCommand(menu, {}, tr("&Keep This Run as A"), {}, tr("Compare the next runs with this one."));
    connect(keep_, &QAction::triggered, &playback_, &WearPlayback::keepAsA);
    drop_ = addCommand(menu, {}, tr("&Drop A"), {}, tr("Show the newest run alone."));
    connect(drop_, &QAction::triggered, &playback_, &WearPlayback::dropA);
    steps_ = addCommand(menu, {}, tr("S&teps of the Colours…"), {}, tr("Set where each of the eight colours ends."));
    connect(steps_, &QAction::triggered, view_, &GarmentView::editSteps);
    menu->addSeparator();
    save_a_ = addCommand(menu, {}, tr("Save &A As…"), {},
                         tr("Write the run that is kept as A to another recording, and beside it the files of its garment."));
    connect(save_a_, &QAction::triggered, this, [this] { Q_EMIT saveOfAWanted(playback_.kept()->file); });
    save_map_ = addCommand(menu, {}, tr("Save &Map…"), {},
                           tr("Write pictures and textures of the panels, a table of cells, OBJ and GLB of the time shown to a folder."));
    connect(save_map_, &QAction::triggered, this, &GarmentSubject::saveMap);
    copy_ = addCommand(menu, "copy", tr("&Copy Numbers as CSV"), {}, tr("Copy the numbers per panel and zone."));
    connect(copy_, &QAction::triggered, parts_, &PartsTable::copy);
}

QWidget* GarmentSubject::form() { return wear_; }

QWidget* GarmentSubject::results() { return parts_; }

QString GarmentSubject::whyNot() const
{
    if (!choice_.garment()) { return tr("Add a garment."); }
    if (!choice_.wear()) { return tr("Add an experiment on this garment."); }
    if (!choice_.problem().isEmpty()) { return choice_.problem(); }
    const QString error = firstError(document_.issues());
    return error.isEmpty() && !choice_.drawing() ? tr("The garment's pattern is being read.") : error;
}

QString GarmentSubject::aboutFidelity(Fidelity fidelity) const
{
    const QString widths[] = {tr("Cells about 12 mm wide."), tr("Cells about 6 mm wide."), tr("Cells about 3 mm wide."),
                              tr("Cells about 1.5 mm wide.")};
    return widths[static_cast<std::size_t>(fidelity)];
}

std::pair<QString, QString> GarmentSubject::chosen() const
{
    return {QString::fromStdString(choice_.garment()->name), QString::fromStdString(choice_.wear()->name)};
}

std::function<RunForecasts(const NewestJob::Turn&)> GarmentSubject::forecast(Fidelity chosen, const std::string& machine) const
{
    return [design = document_.design(), wear = choice_.wear()->name, base = choice_.base(), chosen, machine](const NewestJob::Turn& turn) {
        RunForecasts forecasts;
        forecasts[static_cast<std::size_t>(chosen)] = garmentForecast(*design, wear, base, chosen, machine, turn);
        return forecasts;
    };
}

void GarmentSubject::start(QueuedRun& run, RunOptions how, const std::string& backend)
{
    const auto worn = std::make_shared<std::shared_ptr<WornRun>>(); // once it has begun
    RunJob job{document_.design(), choice_.wear()->name, {}, choice_.base(), how};
    job.worn.started = [this, &run, worn, file = how.recording](const std::shared_ptr<const WearRecord>& record) {
        *worn = newWornRun(record);
        (*worn)->file = QString::fromStdString(file.string());
        (*worn)->live = true;
        run.post([this, begun = *worn] { playback_.begin(begun); });
    };
    job.worn.frame = [this, &run, worn](const std::shared_ptr<const WearFrame>& frame, const WearMetrics& metrics) {
        run.post([this, frame, most = mostWater((*worn)->layout(), *frame), now = std::make_shared<const WearMetrics>(metrics)] {
            playback_.append(frame, now, most);
        });
    };
    run.start(std::move(job), backend, tr("Choose a lower fidelity."),
              [&run, worn](RunResult& result) { run.post([worn, wall = result.garment->wall] { (*worn)->wall = wall; }); });
}

std::optional<KeptRun> GarmentSubject::listed() const
{
    const std::shared_ptr<WornRun>& run = playback_.run();
    if (!run || run->frames.empty() || !playback_.whole()) { return {}; }
    KeptRun kept{run->file, runOfGarment(*run->record, run->wall), nullptr};
    kept.worn = true;
    kept.numbers = numbersOf(*run);
    return kept;
}

void GarmentSubject::refreshActions(bool running, bool)
{
    if (!remove_) { return; }
    const bool any = playback_.frame() != nullptr;
    offerCommand(remove_, choice_.garment() != nullptr, tr("Remove the chosen garment and its experiments."),
                 tr("There is no garment to remove."));
    save_map_->setEnabled(any);
    steps_->setEnabled(any);
    copy_->setEnabled(any);
    keep_->setEnabled(any && !(running && playback_.live()));
    save_a_->setEnabled(playback_.kept() != nullptr);
    drop_->setEnabled(playback_.kept() != nullptr);
}

/// Of its view: the time is the workspace's.
bool GarmentSubject::pressKey(int key) { return view_->pressKey(key); }

void GarmentSubject::chooseIssue(bool of_garment, int index)
{
    if (of_garment) {
        choice_.setGarmentIndex(index);
        return;
    }
    const Design& design = *document_.design();
    for (std::size_t k = 0; k < design.garments.size(); ++k) {
        if (design.garments[k].name == design.wears[static_cast<std::size_t>(index)].garment) {
            choice_.setGarmentIndex(static_cast<int>(k));
        }
    }
    choice_.setWearIndex(index);
}

/// The newest run of the project that shows the chosen garment in the chosen experiment, before others one of the design as it is;
/// nullptr: there is none.
const KeptRun* GarmentSubject::keptOfChosen() const
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
void GarmentSubject::refreshOffer()
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

Design GarmentSubject::recordedDesign()
{
    const Design& recorded = playback_.run()->record->design;
    return movedSources(recorded, folderOfSources(recorded, playback_.run()->file), {});
}

/// Chooses the garment and the experiment of the run on screen.
void GarmentSubject::chooseWhatRan()
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
WearMapOptions GarmentSubject::mapOptions() const
{
    WearMapOptions options;
    options.crossings = 1;
    options.scale = playback_.value() == WearValue::water ? WearScale::same : WearScale::capacity;
    options.steps = playback_.steps();
    return options;
}

/// The page is made in the background, and set as PDF by Qt in this thread.
void GarmentSubject::saveReport(const QString& file)
{
    const std::shared_ptr<WornRun> run = playback_.run();
    if (!run->metrics) { return; }
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
void GarmentSubject::saveMap()
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

} // namespace hygroloom
