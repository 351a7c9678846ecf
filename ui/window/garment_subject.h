// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A garment in the workspace Run: how it is cut from fabrics, how it is worn, its picture in 3D and flat, numbers of its parts.
#pragma once

#include "ui/garment/garment_choice.h"
#include "ui/garment/wear_playback.h"
#include "ui/results/run_subject.h"

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;

namespace hygroloom {

class FitForm;
class GarmentPanel;
class GarmentView;
class PartsTable;
class WearForm;

class GarmentSubject : public RunSubject {
    Q_OBJECT
public:
    GarmentSubject(Document& document, RunHistory& history, QMainWindow& window);

    GarmentChoice& choice() { return choice_; }
    WearPlayback& playback() { return playback_; }
    GarmentPanel& panel() { return *garment_; }
    FitForm& fit() { return *fit_; }
    WearForm& wear() { return *wear_; }
    PartsTable& parts() { return *parts_; }
    GarmentView& view() { return *view_; }
    void fillMenu(QMenu* menu);
    bool pressKey(int key);
    /// Chooses the garment or the experiment of an issue.
    void chooseIssue(bool of_garment, int index);

    ShownRun& shown() override { return playback_; }
    QWidget* form() override;
    QWidget* results() override;
    QString whyNot() const override;
    QString aboutFidelity(Fidelity fidelity) const override;
    std::function<RunForecasts(const NewestJob::Turn&)> forecast(Fidelity chosen, const std::string& machine) const override;
    QString longForecast() const override { return tr("about 4 min, 38 MB"); }
    bool hasPlan() const override { return false; }
    std::pair<QString, QString> chosen() const override;
    void start(QueuedRun& run, RunOptions how, const std::string& backend) override;
    std::optional<KeptRun> listed() const override;
    Design recordedDesign() override;
    void chooseWhatRan() override;
    void saveReport(const QString& file) override;
    void refreshActions(bool running, bool on_screen) override;

Q_SIGNALS:
    /// The run that is kept as A shall be saved.
    void saveOfAWanted(const QString& recording);

private:
    void connectParts();
    WearMapOptions mapOptions() const;
    void saveMap();
    const KeptRun* keptOfChosen() const;
    void refreshOffer();

    Document& document_;
    RunHistory& history_;
    QMainWindow& window_;
    GarmentChoice choice_;
    WearPlayback playback_;
    NewestJob saver_;
    NewestJob reporter_;
    GarmentPanel* garment_;
    FitForm* fit_;
    WearForm* wear_;
    PartsTable* parts_;
    GarmentView* view_;
    QString offered_; ///< the run that the line over the garment offers
    QAction* remove_ = nullptr;
    QAction* save_a_ = nullptr;
    QAction* save_map_ = nullptr;
    QAction* copy_ = nullptr;
    QAction* steps_ = nullptr;
    QAction* keep_ = nullptr;
    QAction* drop_ = nullptr;
};

} // namespace hygroloom
