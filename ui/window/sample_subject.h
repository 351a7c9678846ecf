// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A sample of a fabric in the workspace Run: its experiment, its picture from near, maps of its faces, its numbers.
#pragma once

#include "ui/document/document.h"
#include "ui/results/playback.h"
#include "ui/results/run_subject.h"

class QAction;
class QMainWindow;
class QMenu;

namespace hygroloom {

class ExperimentPanel;
class Place;
class ResultsPanel;
class RunFilm;
class Viewport;
class WaterMapView;
enum class MapSide;

class SampleSubject : public RunSubject {
    Q_OBJECT
public:
    SampleSubject(Document& document, RunHistory& history, Viewport& viewport, QMainWindow& window);

    Playback& playback() { return playback_; }
    ExperimentPanel& experiment() { return *experiment_; }
    WaterMapView& maps() { return *maps_; }
    ResultsPanel& resultsPanel() { return *results_; }
    void fillFileMenu(QMenu* menu);
    void fillExperimentMenu(QMenu* menu);

    ShownRun& shown() override { return playback_; }
    QWidget* form() override;
    QWidget* results() override;
    QString whyNot() const override;
    std::function<RunForecasts(const NewestJob::Turn&)> forecast(Fidelity chosen, const std::string& machine) const override;
    QString longForecast() const override { return tr("about 4 min, 38 MB, error ≈ 14 %"); }
    bool hasPlan() const override { return true; }
    std::pair<QString, QString> chosen() const override;
    void start(QueuedRun& run, RunOptions how, const std::string& backend) override;
    std::optional<KeptRun> listed() const override;
    void chooseWhatRan() override;
    void saveReport(const QString& file) override;
    void refreshActions(bool running, bool on_screen) override;

    /// Whether it is on screen.
    void setOnScreen(bool on_screen) { on_screen_ = on_screen; }
    /// Draws the run that is shown; false when there is none.
    bool drawRun();
    /// Draws the dry sample of the experiment; false when the project has an error or no experiment.
    bool drawSample();
    /// Marks where drops fall; the markers can be dragged.
    void refreshDrops();
    bool resultsAreStale() const { return stale_; }

Q_SIGNALS:
    void pictureChanged();

private:
    void connectDrops();
    void connectPlayback();
    void refreshStale();
    void refreshKept();
    const KeptRun* keptOfChosen() const;
    QString whyStale() const;
    void saveMap(MapSide side);
    void savePictures();
    void saveFilm();
    /// In the picture's window, frame by frame.
    RunFilm* makeFilm();

    Document& document_;
    RunHistory& history_;
    Viewport& viewport_;
    QMainWindow& window_;
    Playback playback_;
    bool on_screen_ = false;
    bool stale_ = false;

    ExperimentPanel* experiment_;
    WaterMapView* maps_;
    ResultsPanel* results_;
    QAction* shown_plan_ = nullptr;
    QAction* save_top_ = nullptr;
    QAction* save_bottom_ = nullptr;
    QAction* save_pictures_ = nullptr;
    QAction* save_film_ = nullptr;
};

} // namespace hygroloom
