// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The middle of the Garment workspace: the garment in its fabrics or with its water, a run kept as A beside it, and their difference.
#pragma once

#include "ui/garment/garment_choice.h"
#include "ui/garment/garment_pane.h"
#include "ui/garment/wear_playback.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QSettings;
class QStackedWidget;

namespace hygroloom {

class QuantityEdit;
class StepLegend;
class StepsDialog;

class GarmentView : public QWidget {
    Q_OBJECT
public:
    enum class Colors { fabrics, water, share };
    enum class Compared { newest, both, difference };

    GarmentView(GarmentChoice& choice, WearPlayback& playback, QWidget* parent = nullptr);

    FlatView& flat() { return newest_->flat(); }
    GarmentPane& newest() { return *newest_; }
    GarmentPane& kept() { return *kept_; }
    GarmentPane& difference() { return *difference_; }
    StepLegend& legend() { return *legend_; }
    /// The window in which the ends of the steps are typed; nullptr before its first use.
    StepsDialog* steps() { return steps_; }
    void editSteps();
    /// The ends of the steps that the user has set.
    void saveSteps(QSettings& settings) const;
    void restoreSteps(const QSettings& settings);
    void setColors(Colors colors);
    void setCompared(Compared compared);
    void setChosenPanel(int panel);
    void fit();
    /// False: the key means nothing here.
    bool pressKey(int key);
    QImage picture();
    /// What is said of the place under the pointer, or of the pin.
    QString probeText() const;

    /// Lets a zone be outlined on a flat panel of the chosen garment.
    void setOutlining(bool outlining);
    /// That the run on screen is none of the project's; empty: it is, or none is shown.
    QString noticeText() const;
    /// A sentence about a run that can be shown, with the words of a link to it; empty: there is none, or it is on screen.
    void setOffer(const QString& sentence, const QString& link);

Q_SIGNALS:
    void panelClicked(int panel);
    void outliningEnded();
    /// The project of the run on screen shall be edited.
    void designRequested();
    /// The run that is offered shall be shown.
    void offerTaken();

private:
    QWidget* makeEmpty();
    QWidget* makeBar();
    QWidget* makeNotice();
    QWidget* makeOffer();
    QWidget* makePanes();
    QString whenOfA() const;
    GarmentSpot spotOfNewest(const GarmentPane* pane, const GarmentSpot& spot) const;
    void showPin();
    std::string panelOver(const std::string& layer) const;
    void connectPane(GarmentPane* pane);
    std::vector<GarmentPane*> panes() const { return {kept_, newest_, difference_}; }
    void showChosen();
    void refresh();
    void refreshRun();
    void refreshBar();
    void refreshLegend(bool exceeded, double differenceMost);
    void showProbe(const GarmentSpot& spot);
    void pinMiddle();
    QString spotText(const GarmentSpot& spot) const;
    QString whyStale() const;
    bool isForeign() const;
    void refreshNotice();
    void refreshZones();
    void addZone(int panel, const std::vector<FlatPlace>& outline);
    bool showsRun() const { return colors_ != Colors::fabrics && playback_.run(); }

    GarmentChoice& choice_;
    WearPlayback& playback_;
    Colors colors_ = Colors::fabrics;
    std::optional<Colors> left_; ///< the colours of the run, while another garment is shown in its fabrics
    Compared compared_ = Compared::newest;
    GarmentSpot hovered_;
    QStackedWidget* pages_;
    QLabel* problem_;
    QWidget* garment_page_;
    QWidget* notice_ = nullptr;
    QLabel* notice_text_ = nullptr;
    QLabel* offer_ = nullptr;
    GarmentPane* kept_;
    GarmentPane* newest_;
    GarmentPane* difference_;
    QComboBox* colors_box_ = nullptr;
    QComboBox* sides_box_ = nullptr;
    QComboBox* compared_box_ = nullptr;
    QStackedWidget* most_ = nullptr;
    QuantityEdit* most_water_ = nullptr;
    QuantityEdit* most_share_ = nullptr;
    QPushButton* keep_ = nullptr;
    QPushButton* edit_steps_ = nullptr;
    StepsDialog* steps_ = nullptr;
    StepLegend* legend_;
    StepLegend* difference_legend_;
    QLabel* probe_;
};

} // namespace hygroloom
