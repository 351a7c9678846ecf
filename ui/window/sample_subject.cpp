// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/sample_subject.h"

#include "ui/basics/ask.h"
#include "ui/basics/issue_text.h"
#include "ui/panels/droplet_section.h"
#include "ui/panels/experiment_panel.h"
#include "ui/picture/viewport.h"
#include "ui/results/report_file.h"
#include "ui/results/results_panel.h"
#include "ui/results/sample_forecast.h"
#include "ui/results/water_map_view.h"
#include "ui/window/command.h"
#include "ui/window/file_names.h"
#include "ui/window/folder_dialog.h"
#include "ui/window/run_film.h"

#include <QDir>
#include <QFileDialog>
#include <QMainWindow>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr char film_stem[] = "run"; // of the pictures' names

/// Of the project's runs of a sample.
bool canBeShown(const KeptRun& run) { return run.own && !run.worn && run.problem.isEmpty(); }

/// nullptr: there is none.
const KeptRun* newestOf(const RunHistory& history)
{
    const auto& runs = history.runs();
    const auto found = std::find_if(runs.rbegin(), runs.rend(), canBeShown);
    return found == runs.rend() ? nullptr : &*found;
}

} // namespace

SampleSubject::SampleSubject(Document& document, RunHistory& history, Viewport& viewport, QMainWindow& window)
    : document_(document), history_(history), viewport_(viewport), window_(window), experiment_(new ExperimentPanel(document)),
      maps_(new WaterMapView(playback_)), results_(new ResultsPanel(playback_))
{
    connect(&document_, &Document::designChanged, this, &SampleSubject::refreshStale);
    connect(&document_, &Document::designChanged, this, &RunSubject::changed);
    connect(maps_, &WaterMapView::quantityChanged, this, [this] { viewport_.setQuantity(maps_->quantity(), maps_->values()); });
    connect(&history_, &RunHistory::changed, this, &SampleSubject::refreshKept);
    connect(results_, &ResultsPanel::newestRequested, this, [this] {
        if (const KeptRun* newest = newestOf(history_)) { Q_EMIT runWanted(QString(newest->path)); }
    });
    connect(results_, &ResultsPanel::chosenRequested, this, [this] {
        if (const KeptRun* kept = keptOfChosen()) { Q_EMIT runWanted(QString(kept->path)); }
    });
    refreshKept();
    connectDrops();
    connectPlayback();
}

void SampleSubject::connectDrops()
{
    DropletSection& droplets = experiment_->droplets();
    connect(&droplets, &DropletSection::dropletChosen, this, &SampleSubject::refreshDrops);
    connect(&droplets, &DropletSection::placingChanged, this, &SampleSubject::refreshDrops);
    if (TextileCanvas* canvas = viewport_.canvas()) {
        connect(canvas, &TextileCanvas::placed, &droplets, &DropletSection::placeDroplet);
        connect(canvas, &TextileCanvas::placingEnded, &droplets, &DropletSection::endPlacing);
        connect(canvas, &TextileCanvas::dropChosen, &droplets, &DropletSection::choose);
        connect(canvas, &TextileCanvas::dropMoved, &droplets, &DropletSection::moveDroplet);
        connect(canvas, &TextileCanvas::dropAdded, &droplets, &DropletSection::addDropletAt);
        connect(canvas, &TextileCanvas::dropRemoved, &droplets, &DropletSection::deleteDroplet);
    }
}

void SampleSubject::connectPlayback()
{
    connect(&playback_, &Playback::runChanged, this, [this] {
        refreshStale();
        Q_EMIT pictureChanged();
    });
    connect(&playback_, &Playback::frameShown, this, [this] {
        const bool seen = on_screen_ && playback_.frame();
        if (seen) { viewport_.showFrame(playback_.frame(), playback_.maximumSaturation()); }
        for (QAction* save : {save_top_, save_bottom_}) {
            if (save) { save->setEnabled(seen); }
        }
    });
    connect(&playback_, &Playback::metricsChanged, this, [this] {
        if (!playback_.live()) { viewport_.setRunMaximum(playback_.maximumSaturation()); }
    });
}

QWidget* SampleSubject::form() { return experiment_; }

QWidget* SampleSubject::results() { return results_; }

QString SampleSubject::whyNot() const
{
    if (!document_.fabric()) { return tr("Add a fabric to run an experiment on."); }
    if (!document_.experiment()) { return tr("Add an experiment to run."); }
    return firstError(document_.issues());
}

std::pair<QString, QString> SampleSubject::chosen() const
{
    return {QString::fromStdString(document_.fabric()->name), QString::fromStdString(document_.experiment()->name)};
}

std::function<RunForecasts(const NewestJob::Turn&)> SampleSubject::forecast(Fidelity, const std::string& machine) const
{
    return [design = document_.design(), fabric = document_.fabricIndex(), test = document_.experimentIndex(), fitted = document_.fitted(),
            machine](const NewestJob::Turn& turn) {
        return sampleForecasts(*design, design->fabrics[static_cast<std::size_t>(fabric)],
                               design->experiments[static_cast<std::size_t>(test)], fitted.get(), machine, turn);
    };
}

void SampleSubject::start(QueuedRun& run, RunOptions how, const std::string& backend)
{
    experiment_->droplets().endPlacing();
    const QString path = QString::fromStdString(how.recording.string());
    how.textile = std::make_shared<const Textile>(
        textile_of_run(*document_.design(), *document_.fabric(), *document_.experiment(), document_.fitted().get()));
    RunJob job{document_.design(), document_.experiment()->name, document_.fabric()->name, {}, how};
    job.beside.started = [this, &run, path](const RunRecord& record) {
        run.post([this, path, begun = std::make_shared<const RunRecord>(record)] { playback_.begin(begun, path); });
    };
    job.measured = [this, &run](const std::shared_ptr<const Frame>& frame, const std::shared_ptr<const MetricsCollector>& so_far) {
        run.post([this, frame, metrics = std::make_shared<const Metrics>(so_far->metrics())] { playback_.append(frame, metrics); });
    };
    run.start(std::move(job), backend, tr("Choose a smaller sample or a lower fidelity."), [this, &run](RunResult& result) {
        run.post([this, whole = std::make_shared<const RunRecord>(result.sample->run)] { playback_.complete(whole); });
    });
}

std::optional<KeptRun> SampleSubject::listed() const
{
    if (!playback_.run() || !playback_.metrics() || !playback_.whole()) { return {}; }
    return KeptRun{playback_.path(), playback_.run(), playback_.metrics()};
}

void SampleSubject::fillFileMenu(QMenu* menu)
{
    save_top_ = addCommand(menu, {}, tr("Save Map of the Top &Face…"), {},
                           tr("Save the map of the top face at the time shown, as picture or table."));
    connect(save_top_, &QAction::triggered, this, [this] { saveMap(MapSide::top); });
    save_bottom_ = addCommand(menu, {}, tr("Save Map of the &Bottom Face…"), {},
                              tr("Save the map of the bottom face at the time shown, as picture or table."));
    connect(save_bottom_, &QAction::triggered, this, [this] { saveMap(MapSide::bottom); });
    maps_->offerSaving(save_top_, save_bottom_);
    save_pictures_ = addCommand(menu, {}, tr("Save Picture Se&quence…"), {},
                                tr("Save the picture at each time of the run that is shown, as numbered PNG files."));
    connect(save_pictures_, &QAction::triggered, this, &SampleSubject::savePictures);
    save_film_ = addCommand(menu, {}, tr("Save Fil&m (MP4)…"), {}, tr("Save the pictures of the run that is shown as a film."));
    connect(save_film_, &QAction::triggered, this, &SampleSubject::saveFilm);
}

void SampleSubject::fillExperimentMenu(QMenu* menu)
{
    shown_plan_ =
        addCommand(menu, {}, tr("What W&as Modelled, and Why…"), {}, tr("Which physics the run on screen modelled, and the reasons."));
    connect(shown_plan_, &QAction::triggered, results_, &ResultsPanel::showPlan);
    connect(addCommand(menu, "add", tr("&Add Droplet"), {}, tr("Add a droplet to the experiment.")), &QAction::triggered,
            &experiment_->droplets(), &DropletSection::addDroplet);
    connect(addCommand(menu, {}, tr("Add &Experiment"), {}, tr("Add a copy of the experiment.")), &QAction::triggered, experiment_,
            &ExperimentPanel::addExperiment);
}

void SampleSubject::refreshActions(bool, bool on_screen)
{
    if (!shown_plan_) { return; }
    const bool any = playback_.run() != nullptr;
    shown_plan_->setEnabled(any);
    for (QAction* save : {save_top_, save_bottom_}) { save->setEnabled(any && on_screen && playback_.frame()); }
    const bool filmable = any && !playback_.live() && viewport_.canvas();
    save_pictures_->setEnabled(filmable);
    const bool encoder = Film::whyNoMovie().isEmpty();
    save_film_->setEnabled(filmable && encoder);
    save_film_->setText(encoder ? tr("Save Fil&m (MP4)…") : tr("Save Fil&m (MP4): ffmpeg Is Not Installed"));
}

bool SampleSubject::drawRun()
{
    if (!playback_.run()) { return false; }
    viewport_.showRun(playback_.run());
    if (playback_.frame()) { viewport_.showFrame(playback_.frame(), playback_.maximumSaturation()); }
    viewport_.setNotice(stale_ ? whyStale() : QString());
    return true;
}

bool SampleSubject::drawSample()
{
    if (!document_.experiment() || document_.hasError()) { return false; }
    viewport_.showSample(document_.design(), document_.fabricIndex(), *document_.experiment());
    return true;
}

void SampleSubject::refreshDrops()
{
    TextileCanvas* canvas = viewport_.canvas();
    if (!canvas) { return; }
    const DropletSection& droplets = experiment_->droplets();
    std::vector<QPointF> places;
    const Experiment* experiment = document_.experiment();
    const bool marked = on_screen_ && experiment && uses_field(experiment->type, "droplets");
    if (marked) {
        for (const Droplet& drop : experiment->droplets) { places.emplace_back(drop.at_mm[0], drop.at_mm[1]); }
    }
    canvas->setDrops(places, droplets.chosen());
    canvas->setDropsEditable(marked);
    canvas->setPlacing(on_screen_ && droplets.placing());
}

void SampleSubject::refreshStale()
{
    stale_ = false;
    if (const auto& run = playback_.run()) {
        const bool chosen = document_.fabric() && document_.experiment() && document_.fabric()->name == run->fabric &&
                            document_.experiment()->name == run->experiment;
        stale_ = !chosen || !holdsFor(*run, *document_.design());
    }
    results_->setChosenKept(stale_ && keptOfChosen());
}

void SampleSubject::refreshKept()
{
    const auto& runs = history_.runs();
    results_->setKept(static_cast<int>(std::count_if(runs.begin(), runs.end(), canBeShown)));
    results_->setChosenKept(stale_ && keptOfChosen());
    if (stale_) { Q_EMIT pictureChanged(); } // whose notice says so
}

/// The newest run of the project that holds for the selected fabric and experiment; nullptr: there is none.
const KeptRun* SampleSubject::keptOfChosen() const
{
    if (!document_.fabric() || !document_.experiment()) { return nullptr; }
    const auto& runs = history_.runs();
    const auto found = std::find_if(runs.rbegin(), runs.rend(), [this](const KeptRun& kept) {
        return canBeShown(kept) && kept.complete() && kept.run->fabric == document_.fabric()->name &&
               kept.run->experiment == document_.experiment()->name && holdsFor(*kept.run, *document_.design());
    });
    return found == runs.rend() ? nullptr : &*found;
}

QString SampleSubject::whyStale() const
{
    const auto& run = playback_.run();
    if (keptOfChosen()) {
        const bool chosen = document_.fabric()->name == run->fabric && document_.experiment()->name == run->experiment;
        return chosen ? tr("Out of date: the design or the program has changed since this run. Results has a link to a run of it.")
                      : tr("These results are for “%1, %2”. Results has a link to the run of what is selected.")
                            .arg(QString::fromStdString(run->fabric), QString::fromStdString(run->experiment));
    }
    if (!document_.fabric() || document_.fabric()->name != run->fabric) {
        return tr("These results are for “%1”. Run the selected fabric.").arg(QString::fromStdString(run->fabric));
    }
    if (!document_.experiment() || document_.experiment()->name != run->experiment) {
        return tr("These results are for “%1”. Run the selected experiment.").arg(QString::fromStdString(run->experiment));
    }
    return tr("Out of date: the design or the program has changed since this run. Run again.");
}

/// Chooses the fabric and the experiment of the run on screen.
void SampleSubject::chooseWhatRan()
{
    const auto& run = playback_.run();
    const Design& design = *document_.design();
    for (std::size_t i = 0; i < design.fabrics.size(); ++i) {
        if (design.fabrics[i].name == run->fabric) { document_.setFabricIndex(static_cast<int>(i)); }
    }
    for (std::size_t i = 0; i < design.experiments.size(); ++i) {
        if (design.experiments[i].name == run->experiment) { document_.setExperimentIndex(static_cast<int>(i)); }
    }
}

void SampleSubject::saveReport(const QString& file)
{
    try {
        writeReport(results_->report(), file);
        Q_EMIT messageShown(tr("Saved %1.").arg(file), 4000);
    } catch (const std::exception& error) {
        Q_EMIT problemFound(QString::fromStdString(error.what()));
    }
}

void SampleSubject::saveMap(MapSide side)
{
    if (!playback_.run() || !playback_.frame()) { return; }
    const bool top = side == MapSide::top;
    const QString name = playback_.title();
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

RunFilm* SampleSubject::makeFilm()
{
    Q_EMIT wanted(); // what is filmed is on screen
    auto* film = new RunFilm(
        playback_, [this](const QString& clock) { return viewport_.picture(clock); }, film_stem, &window_);
    connect(film, &RunFilm::saved, this, [this](const QString& sentence) { Q_EMIT messageShown(sentence, 8000); });
    connect(film, &RunFilm::failed, this, &SampleSubject::problemFound);
    return film;
}

void SampleSubject::savePictures()
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

void SampleSubject::saveFilm()
{
    if (!playback_.run() || playback_.live()) { return; }
    const QString name = playback_.title() + ".mp4";
    const QString chosen =
        QFileDialog::getSaveFileName(&window_, tr("Save Film"), QDir(folderOf(document_)).filePath(name), tr("Films (*.mp4)"));
    if (!chosen.isEmpty()) { makeFilm()->saveMovie(withEnding(chosen, ".mp4")); }
}

} // namespace hygroloom
