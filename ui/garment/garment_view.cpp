// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is drawn, and with which colours. The bar over it: garment_view_bar.cpp; what it has to do with the project:
// garment_view_project.cpp.
#include "ui/garment/garment_view.h"

#include "ui/basics/color_map.h"
#include "ui/basics/core_words.h"
#include "ui/basics/quantity_edit.h"
#include "ui/garment/flat_view.h"
#include "ui/garment/garment_edits.h"
#include "ui/garment/shape_view.h"
#include "ui/garment/step_legend.h"
#include "ui/garment/steps_dialog.h"
#include "ui/results/run_history.h"

#include <QComboBox>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

enum Page { empty_page, problem_page, garment_page };

QString captionOf(const WornRun& run)
{
    const WearLayout& layout = run.layout();
    const QString words = GarmentView::tr("%1, %2: %3, %4")
                              .arg(QString::fromStdString(layout.garment), QString::fromStdString(layout.experiment),
                                   coreWord(run.record->fidelity), cellsText(layout.cells_in_words));
    const bool stopped = !run.live && run.wall <= 0 && !run.frames.empty();
    return stopped ? GarmentView::tr("%1, stopped at %2").arg(words, momentText(run.frames.back()->time, run.duration)) : words;
}

bool anyAbove(const std::vector<double>& values, double most)
{
    return std::any_of(values.begin(), values.end(), [most](double value) { return std::abs(value) > most * (1 + 1e-9); });
}

} // namespace

GarmentView::GarmentView(GarmentChoice& choice, WearPlayback& playback, QWidget* parent)
    : QWidget(parent), choice_(choice), playback_(playback), pages_(new QStackedWidget), problem_(new QLabel), garment_page_(new QWidget),
      kept_(new GarmentPane), newest_(new GarmentPane), difference_(new GarmentPane), legend_(new StepLegend),
      difference_legend_(new StepLegend), probe_(new QLabel)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    problem_->setAlignment(Qt::AlignCenter);
    problem_->setWordWrap(true);
    problem_->setTextFormat(Qt::PlainText); // names of files
    problem_->setMargin(24);
    auto* page = new QVBoxLayout(garment_page_);
    page->setContentsMargins(0, 0, 0, 0);
    page->setSpacing(0);
    page->addWidget(makeBar());
    page->addWidget(makeNotice());
    page->addWidget(makeOffer());
    page->addWidget(makePanes(), 1);
    page->addWidget(probe_);
    probe_->setMargin(4);
    probe_->setTextFormat(Qt::PlainText);
    probe_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    probe_->setAccessibleName(tr("Place under the pointer"));
    pages_->addWidget(makeEmpty());
    pages_->addWidget(problem_);
    pages_->addWidget(garment_page_);
    layout->addWidget(pages_);
    for (GarmentPane* pane : panes()) { connectPane(pane); }
    connect(&newest_->flat(), &FlatView::outliningEnded, this, &GarmentView::outliningEnded);
    connect(&newest_->flat(), &FlatView::zoneOutlined, this, &GarmentView::addZone);
    connect(&choice_, &GarmentChoice::changed, this, &GarmentView::refresh);
    connect(&choice_, &GarmentChoice::garmentChosen, this, &GarmentView::showChosen);
    connect(&choice_, &GarmentChoice::drawingChanged, this, &GarmentView::refresh);
    connect(&playback_, &WearPlayback::runChanged, this, [this] {
        if (playback_.run() && colors_ == Colors::fabrics) {
            setColors(playback_.value() == WearValue::water ? Colors::water : Colors::share);
        }
        if (!playback_.kept()) { compared_ = Compared::newest; }
        refresh();
    });
    connect(&playback_, &WearPlayback::framesChanged, this, &GarmentView::refreshBar);
    connect(&playback_, &WearPlayback::frameShown, this, &GarmentView::refreshRun);
    connect(&playback_, &WearPlayback::scaleChanged, this, &GarmentView::refresh);
    connect(&playback_, &WearPlayback::pinChanged, this, [this] {
        showPin();
        showProbe(hovered_);
    });
    refresh();
}

QWidget* GarmentView::makeEmpty()
{
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    auto* words = new QLabel(tr("This project has no garment yet."));
    words->setAlignment(Qt::AlignCenter);
    auto* add = new QPushButton(tr("Add the built-in tee"));
    add->setMinimumHeight(36);
    add->setToolTip(tr("Adds a tee, cut from the project's first fabric, and an experiment in which it is worn."));
    connect(add, &QPushButton::clicked, this, [this] { choice_.setGarmentIndex(addBuiltInGarment(choice_.document(), "tee")); });
    layout->addStretch();
    layout->addWidget(words);
    layout->addWidget(add, 0, Qt::AlignCenter);
    layout->addStretch();
    return page;
}

QWidget* GarmentView::makePanes()
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    for (GarmentPane* pane : panes()) { layout->addWidget(pane, 1); }
    kept_->hide();
    difference_->hide();
    auto* legends = new QVBoxLayout;
    legends->addWidget(legend_);
    edit_steps_ = new QPushButton(tr("Steps…"));
    edit_steps_->setToolTip(tr("Set where each of the eight colours ends."));
    connect(edit_steps_, &QPushButton::clicked, this, &GarmentView::editSteps);
    auto* below = new QHBoxLayout;
    below->setContentsMargins(8, 0, 0, 0); // under the colours
    below->addWidget(edit_steps_);
    below->addStretch();
    legends->addLayout(below);
    legends->addWidget(difference_legend_);
    legends->addStretch();
    QSizePolicy policy = legend_->sizePolicy();
    policy.setRetainSizeWhenHidden(true); // the pictures keep their place
    legend_->setSizePolicy(policy);
    layout->addLayout(legends);
    return row;
}

void GarmentView::editSteps()
{
    if (!showsRun()) { return; }
    if (!steps_) { steps_ = new StepsDialog(playback_, this); }
    steps_->show();
    steps_->raise();
    steps_->activateWindow();
}

/// A place in a pane as the place in the run that is compared with A.
GarmentSpot GarmentView::spotOfNewest(const GarmentPane* pane, const GarmentSpot& spot) const
{
    const bool of_kept = pane == kept_ && playback_.kept() && playback_.run();
    return of_kept ? sameSpot(playback_.kept()->layout(), playback_.run()->layout(), spot) : spot;
}

/// In each pane on the panel of the same name.
void GarmentView::showPin()
{
    newest_->setPin(playback_.pin());
    difference_->setPin(playback_.pin());
    const bool both = playback_.kept() && playback_.run();
    kept_->setPin(both ? sameSpot(playback_.run()->layout(), playback_.kept()->layout(), playback_.pin()) : GarmentSpot{});
}

/// The panel of the garment that a further layer in a run lies under; empty: it is no such layer.
std::string GarmentView::panelOver(const std::string& layer) const
{
    if (!choice_.drawing()) { return {}; }
    for (const DrawnPanel& panel : choice_.drawing()->panels) {
        if (layer.rfind(layer_prefix(panel.name), 0) == 0) { return panel.name; }
    }
    return {};
}

void GarmentView::connectPane(GarmentPane* pane)
{
    connect(pane, &GarmentPane::hovered, this, [this, pane](const GarmentSpot& spot) { showProbe(spotOfNewest(pane, spot)); });
    connect(pane, &GarmentPane::clicked, this, [this, pane](const GarmentSpot& at) {
        const GarmentSpot spot = spotOfNewest(pane, at);
        Q_EMIT panelClicked(spot.panel);
        if (showsRun()) { playback_.setPin(spot); }
    });
    connect(pane, &GarmentPane::fabricDropped, this, [this](const QString& panel, const QString& fabric) {
        if (!choice_.garment() || (showsRun() && playback_.run()->layout().garment != choice_.garment()->name)) { return; }
        const std::string name = panel.toStdString(), under = panelOver(name);
        editCut(choice_.document(), tr("cut %1 from %2").arg(panel, fabric), choice_.garmentIndex(), under.empty() ? name : under, {},
                [&](PanelCut& cut) { (under.empty() ? cut.fabric : cut.lining) = fabric.toStdString(); });
    });
    if (ShapeView* shape = pane->shape()) { // one camera for all
        connect(shape, &ShapeView::cameraMoved, this, [this, shape](const Camera& camera) {
            for (GarmentPane* other : panes()) {
                if (other->shape() != shape) { other->shape()->setCamera(camera); }
            }
        });
    }
}

/// The chosen garment instead of a run of another; the run again with its own garment.
void GarmentView::showChosen()
{
    if (!choice_.garment() || !playback_.run()) { return; }
    if (choice_.garment()->name != playback_.run()->layout().garment) {
        if (showsRun()) {
            const Colors before = colors_;
            setColors(Colors::fabrics);
            left_ = before;
        }
    } else if (left_) {
        setColors(*left_);
    }
}

void GarmentView::refresh()
{
    refreshNotice();
    refreshZones();
    if (showsRun()) {
        pages_->setCurrentWidget(garment_page_);
        refreshBar();
        refreshRun();
        return;
    }
    const bool none = !choice_.garment();
    if (none || !choice_.drawing()) {
        problem_->setText(choice_.reading() ? tr("Reading the garment.") : choice_.problem());
        pages_->setCurrentIndex(none ? empty_page : problem_page);
        return;
    }
    pages_->setCurrentIndex(garment_page);
    kept_->hide();
    difference_->hide();
    newest_->setStacked(false);
    newest_->setCaption(tr("%1 in its fabrics").arg(QString::fromStdString(choice_.garment()->name)));
    newest_->show(choice_.drawing(),
                  std::make_shared<GarmentPaint>(fabricPaint(*choice_.document().design(), *choice_.garment(), *choice_.drawing())));
    for (GarmentPane* pane : panes()) { pane->setPin({}); }
    legend_->hide();
    difference_legend_->hide();
    refreshBar();
    showProbe(hovered_);
}

/// What is to be said of the run on screen and the project as it is now; empty where they agree.
QString GarmentView::whyStale() const
{
    const Design &now = *choice_.document().design(), &then = playback_.run()->record->design;
    const WearLayout& layout = playback_.run()->layout();
    if (isForeign()) { return tr(". Not an experiment of this project."); }
    if (!holdsFor(*runOfGarment(*playback_.run()->record, 0), now)) {
        return tr(". Out of date: the design or the program has changed. Run again.");
    }
    return garmentHoldsFor(then, layout.garment, layout.experiment, now)
               ? QString()
               : tr(". Cut from another fabric than the project's garment, as Compare does.");
}

void GarmentView::refreshRun()
{
    if (!showsRun()) { return; }
    const WornRun& run = *playback_.run();
    const auto frame = playback_.frame(), kept_frame = playback_.keptFrame();
    const bool both = playback_.kept() && compared_ != Compared::newest, differs = playback_.kept() && compared_ == Compared::difference;
    const WearSteps steps = playback_.steps();
    const double most = steps.back();
    bool exceeded = false;
    const WearValue what = playback_.value();
    std::vector<double> values, kept_values;
    if (frame) {
        values = cellValues(run.layout(), *frame, what);
        exceeded = anyAbove(values, most);
        newest_->show(run.drawing, waterPaint(run, values, steps));
    } else {
        newest_->show(run.drawing, nullptr);
    }
    newest_->setCaption((both ? "B: " : QString()) + captionOf(run) + whyStale());
    if (both && !kept_frame) { kept_->show(playback_.kept()->drawing, nullptr); }
    if (both) { kept_->setCaption("A: " + captionOf(*playback_.kept()) + whenOfA()); }
    if (both && kept_frame) {
        const WornRun& kept = *playback_.kept();
        kept_values = cellValues(kept.layout(), *kept_frame, what);
        exceeded = exceeded || anyAbove(kept_values, most);
        kept_->show(kept.drawing, waterPaint(kept, kept_values, steps));
    }
    if (differs && !(frame && kept_frame)) { difference_->show(run.drawing, nullptr); }
    if (differs && frame && kept_frame) {
        difference_->show(run.drawing, differencePaint(run, playback_.difference(), playback_.mostDifference()));
        difference_->setCaption(tr("Difference B − A"));
    }
    for (GarmentPane* pane : panes()) { pane->setStacked(both); }
    kept_->setVisible(both);
    difference_->setVisible(differs);
    showPin();
    refreshLegend(exceeded, differs ? playback_.mostDifference() : 0);
    showProbe(hovered_);
}

/// Where A has no frame at the time shown: which one is shown instead.
QString GarmentView::whenOfA() const
{
    const auto kept = playback_.keptFrame();
    if (!kept) { return tr(", ended before this time"); }
    return std::abs(kept->time - playback_.time()) < 1e-3 ? QString() : tr(", at %1").arg(momentText(kept->time, playback_.duration()));
}

void GarmentView::refreshLegend(bool exceeded, double differenceMost)
{
    const bool share = playback_.value() == WearValue::share;
    legend_->setSteps(share ? tr("Share of capacity, %") : tr("Water, g/m²"), playback_.steps(), share, exceeded);
    legend_->show();
    difference_legend_->setDifference(share ? tr("Difference B − A, %") : tr("Difference B − A, g/m²"), differenceMost, share, false);
    difference_legend_->setVisible(differenceMost > 0);
}

void GarmentView::showProbe(const GarmentSpot& spot)
{
    hovered_ = spot;
    probe_->setText(spotText(spot.panel >= 0 ? spot : showsRun() ? playback_.pin() : GarmentSpot{}));
}

QString GarmentView::probeText() const { return probe_->text(); }

QString GarmentView::spotText(const GarmentSpot& spot) const
{
    const auto& drawing = newest_->drawing();
    if (!drawing || spot.panel < 0 || spot.panel >= static_cast<int>(drawing->panels.size())) {
        return showsRun() ? tr("Point at a cell to read its value; click to pin it.")
                          : tr("Drag a fabric onto a panel, or choose it in the table.");
    }
    const std::string& panel = drawing->panels[static_cast<std::size_t>(spot.panel)].name;
    const QString name = QString::fromStdString(panel);
    if (!showsRun()) {
        const PanelCut* cut = choice_.garment() ? choice_.garment()->cut_of(panel) : nullptr;
        return cut ? tr("%1: %2, grain %3°").arg(name, clothsOf(*cut), shownNumber(cut->grain_deg, 1)) : tr("%1 has no fabric").arg(name);
    }
    const WornRun& run = *playback_.run();
    const int cell = run.lookup->at(spot);
    const auto frame = playback_.frame();
    if (cell < 0 || !frame) { return name; }
    const auto values = [&](const WornRun& of, const WearFrame& at, int place) {
        const GarmentCell& found = of.layout().cells[static_cast<std::size_t>(place)];
        const double water = at.water(static_cast<std::size_t>(place));
        return tr("%1 g/m², %2 % of capacity").arg(shownNumber(1e3 * water / found.area, 1), shownNumber(100 * water / found.capacity, 1));
    };
    const GarmentCell& here = run.layout().cells[static_cast<std::size_t>(cell)];
    QString text = values(run, *frame, cell);
    if (playback_.kept() && compared_ != Compared::newest && playback_.keptFrame()) {
        const int there = playback_.kept()->lookup->at(sameSpot(run.layout(), playback_.kept()->layout(), spot));
        text = tr("A: %1; B: %2").arg(there < 0 ? QStringLiteral("–") : values(*playback_.kept(), *playback_.keptFrame(), there), text);
    }
    return tr("%1, zone %2: %3; %4")
        .arg(name, coreWord(run.layout().zone_names()[static_cast<std::size_t>(here.zone)]), text, directionWords(run, cell));
}

void GarmentView::setChosenPanel(int panel) { newest_->flat().setChosenPanel(panel); }

void GarmentView::fit()
{
    for (GarmentPane* pane : panes()) {
        pane->flat().fit();
        if (pane->shape()) { pane->shape()->fit(); }
    }
}

/// What lies in the middle of the picture: for the keyboard.
void GarmentView::pinMiddle()
{
    if (!showsRun()) { return; }
    ShapeView* shape = newest_->shape();
    const QWidget* seen = shape && shape->isVisible() ? static_cast<QWidget*>(shape) : &newest_->flat();
    const QPointF middle(0.5 * seen->width(), 0.5 * seen->height());
    playback_.setPin(seen == shape ? shape->spotAt(middle) : newest_->flat().spotAt(middle));
}

bool GarmentView::pressKey(int key)
{
    const auto look = [this](double turn) {
        if (newest_->shape()) { newest_->shape()->lookFrom(turn); }
    };
    const auto zoom = [this](double factor) {
        newest_->flat().zoomBy(factor);
        if (newest_->shape()) { newest_->shape()->zoomBy(factor); }
    };
    switch (key) {
    case Qt::Key_Home:
    case Qt::Key_F: fit(); return true;
    case Qt::Key_1: look(0); return true;
    case Qt::Key_3: look(90); return true;
    case Qt::Key_7: look(180); return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoom(1.25); return true;
    case Qt::Key_Minus: zoom(0.8); return true;
    case Qt::Key_Return:
    case Qt::Key_Enter: pinMiddle(); return true;
    case Qt::Key_Escape: playback_.setPin({}); return true;
    default: return false;
    }
}

QImage GarmentView::picture()
{
    if (pages_->currentWidget() != garment_page_) { return {}; }
    const double ratio = devicePixelRatioF();
    QImage image(size() * ratio, QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    render(&image);
    QPainter painter(&image);
    for (GarmentPane* pane : panes()) {
        if (pane->isVisible()) { painter.drawImage(QRect(pane->mapTo(this, QPoint(0, 0)), pane->size()), pane->picture()); }
    }
    return image;
}

} // namespace hygroloom
