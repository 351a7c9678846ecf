// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The bar over the garment: sides, colours, scale, what is compared.
#include "core/base/error.h"
#include "ui/basics/quantity_edit.h"
#include "ui/garment/garment_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QStackedWidget>

namespace hygroloom {

namespace {

QComboBox* choiceOf(const QString& name, const QStringList& texts)
{
    auto* box = new QComboBox;
    box->setAccessibleName(name);
    box->setToolTip(name);
    box->addItems(texts);
    return box;
}

constexpr std::pair<const char*, WearValue> step_keys[] = {{"garment/water steps", WearValue::water},
                                                           {"garment/share steps", WearValue::share}};

} // namespace

QWidget* GarmentView::makeBar()
{
    sides_box_ = choiceOf(tr("What is drawn"), {tr("3D and flat"), tr("3D"), tr("Flat")});
    colors_box_ = choiceOf(tr("What the colours show"), {tr("Fabrics"), tr("Water, g/m²"), tr("Share of capacity")});
    compared_box_ = choiceOf(tr("Which runs are drawn"), {tr("Newest run"), tr("A | B"), tr("A | B | B − A")});
    most_water_ = new QuantityEdit(Quantity::arealDensity(100000));
    most_share_ = new QuantityEdit(Quantity::percent(0.001, 100));
    for (QuantityEdit* edit : {most_water_, most_share_}) {
        edit->setOptional(true);
        edit->setFixedWidth(edit->fontMetrics().horizontalAdvance("auto 1000 g/m²") + 12);
        edit->setAccessibleName(tr("End of the scale"));
        connect(edit, &QuantityEdit::edited, this,
                [this](std::optional<double> value) { playback_.setMost(value && *value > 0 ? value : std::nullopt); });
    }
    keep_ = new QPushButton(tr("Keep as A"));
    keep_->setToolTip(tr("Keeps this run, to compare the next ones with it."));
    connect(keep_, &QPushButton::clicked, &playback_, &WearPlayback::keepAsA);
    connect(sides_box_, &QComboBox::activated, this, [this](int index) {
        for (GarmentPane* pane : panes()) { pane->setSides(static_cast<GarmentPane::Sides>(index)); }
    });
    connect(colors_box_, &QComboBox::activated, this, [this](int index) { setColors(static_cast<Colors>(index)); });
    connect(compared_box_, &QComboBox::activated, this, [this](int index) { setCompared(static_cast<Compared>(index)); });
    auto* fit = new QPushButton(tr("Fit"));
    fit->setToolTip(tr("Show the whole garment (Home)."));
    connect(fit, &QPushButton::clicked, this, &GarmentView::fit);
    most_ = new QStackedWidget; // in one place, so that nothing moves
    most_->addWidget(most_water_);
    most_->addWidget(most_share_);
    most_->setFixedSize(most_water_->minimumWidth(), most_water_->sizeHint().height());
    auto* bar = new QWidget;
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(6, 4, 6, 4);
    layout->setSpacing(6);
    for (QWidget* part : {static_cast<QWidget*>(sides_box_), static_cast<QWidget*>(fit), static_cast<QWidget*>(colors_box_),
                          static_cast<QWidget*>(most_)}) {
        layout->addWidget(part);
    }
    layout->addStretch();
    layout->addWidget(keep_);
    layout->addWidget(compared_box_);
    return bar;
}

void GarmentView::setColors(Colors colors)
{
    colors_ = colors;
    left_.reset();
    if (colors != Colors::fabrics) { playback_.setValue(colors == Colors::water ? WearValue::water : WearValue::share); }
    refresh();
}

void GarmentView::setCompared(Compared compared)
{
    compared_ = playback_.kept() ? compared : Compared::newest;
    if (compared_ != Compared::newest && colors_ == Colors::fabrics) {
        setColors(Colors::water);
    } else {
        refresh();
    }
}

void GarmentView::saveSteps(QSettings& settings) const
{
    for (const auto& [key, value] : step_keys) {
        QStringList ends;
        if (const auto& steps = playback_.ownSteps(value)) {
            for (const double end : *steps) { ends << QString::number(end, 'g', 17); }
        }
        settings.setValue(key, ends);
    }
}

void GarmentView::restoreSteps(const QSettings& settings)
{
    for (const auto& [key, value] : step_keys) {
        const QStringList ends = settings.value(key).toStringList();
        WearSteps steps;
        if (ends.size() != static_cast<qsizetype>(steps.size())) { continue; }
        for (std::size_t k = 0; k < steps.size(); ++k) { steps[k] = ends[static_cast<qsizetype>(k)].toDouble(); }
        try {
            require_ascending(steps);
            playback_.setSteps(value, steps);
        } catch (const Error&) { // written by something else
        }
    }
}

void GarmentView::refreshBar()
{
    const bool any = playback_.run() != nullptr;
    const QSignalBlocker quiet_colors(colors_box_), quiet_compared(compared_box_);
    colors_box_->setCurrentIndex(static_cast<int>(showsRun() ? colors_ : Colors::fabrics));
    colors_box_->setEnabled(any);
    compared_box_->setCurrentIndex(static_cast<int>(compared_));
    compared_box_->setEnabled(playback_.kept() != nullptr);
    keep_->setEnabled(any && !playback_.run()->live && playback_.frames() > 0);
    const bool share = playback_.value() == WearValue::share;
    most_->setCurrentIndex(share ? 1 : 0);
    most_->setEnabled(showsRun() && !playback_.ownSteps());
    edit_steps_->setEnabled(showsRun());
    QuantityEdit* edit = share ? most_share_ : most_water_;
    edit->setHelp(playback_.ownSteps() ? tr("The steps have ends of their own; Steps… under the legend edits and resets them.")
                                       : tr("Where the eight steps of the colours end. Empty: at a round number over the most that the "
                                            "runs hold; while a run goes on, over the most that it is expected to hold."));
    edit->setValue(playback_.ownSteps() ? std::nullopt : playback_.setMost());
    edit->setDerived(playback_.most());
}

} // namespace hygroloom
