// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/panels/droplet_section.h"

#include "ui/basics/icon_button.h"
#include "ui/basics/preferences.h"

#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace hygroloom {

namespace {

/// Drops must land on the sample.
std::array<double, 2> onSample(const Experiment& experiment, const QPointF& at)
{
    const auto within = [](double place, double side) { return std::clamp(place, -0.5 * std::abs(side), 0.5 * std::abs(side)); };
    return {within(at.x(), experiment.sample_mm[0]), within(at.y(), experiment.sample_mm[1])};
}

} // namespace

DropletSection::DropletSection(DesignForm& form, QObject* parent) : QObject(parent), form_(form)
{
    addList();
    addFields();
    form_.onRefresh([this] { refresh(); });
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, &DropletSection::refresh);
}

void DropletSection::addList()
{
    list_ = new QListWidget;
    list_->setAccessibleName(tr("Droplets"));
    list_->setFixedHeight(90); // as three buttons
    auto* buttons = new QVBoxLayout;
    QToolButton* add = iconButton("add", tr("Add a droplet"));
    remove_ = iconButton("remove", tr("Remove the droplet"));
    place_ = iconButton("drop", tr("Place the droplet: click on the fabric"));
    place_->setCheckable(true);
    connect(place_, &QToolButton::toggled, this, &DropletSection::placingChanged);
    buttons->setSpacing(4);
    buttons->addWidget(add);
    buttons->addWidget(remove_);
    buttons->addWidget(place_);
    buttons->addStretch();
    auto* line = new QWidget;
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(list_, 1);
    layout->addLayout(buttons);
    form_.addWide(line);
    none_ = new QLabel(tr("No droplet yet. Add one to wet the fabric."));
    none_->setWordWrap(true);
    form_.addWide(none_);
    connect(add, &QToolButton::clicked, this, &DropletSection::addDroplet);
    connect(remove_, &QToolButton::clicked, this, &DropletSection::removeDroplet);
    connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0 && row != droplet_) {
            droplet_ = row;
            form_.refresh();
            Q_EMIT dropletChosen();
        }
    });
}

void DropletSection::addFields()
{
    const FormOwner<Droplet> drop{
        [this] {
            return "experiments[" + std::to_string(form_.document().experimentIndex()) + "].droplets[" + std::to_string(droplet_) + "].";
        },
        [this]() -> const Droplet* {
            const Experiment* e = experiment();
            return e && droplet_ < static_cast<int>(e->droplets.size()) ? &e->droplets[static_cast<std::size_t>(droplet_)] : nullptr;
        },
        [this](Design& design, const std::function<void(Droplet&)>& change) {
            auto& drops = design.experiments[static_cast<std::size_t>(form_.document().experimentIndex())].droplets;
            if (droplet_ < static_cast<int>(drops.size())) { change(drops[static_cast<std::size_t>(droplet_)]); }
        },
        tr("droplet")};
    for (const char* key : {"volume_ul", "time_s"}) { fields_.push_back(form_.addNumber(drop, key)); }
    for (const std::size_t axis : {0, 1}) {
        const DesignField place{axis == 0 ? tr("Position along weft") : tr("Position along warp"),
                                tr("droplet position"),
                                [drop, axis] { return drop.path() + "at_mm[" + std::to_string(axis) + "]"; },
                                [drop, axis] { return drop.shown() ? std::optional(drop.shown()->at_mm[axis]) : std::nullopt; },
                                [drop, axis](Design& design, std::optional<double> value) {
                                    drop.change(design, [&](Droplet& d) { d.at_mm[axis] = value.value_or(d.at_mm[axis]); });
                                },
                                tr("Distance from the sample's centre.")};
        fields_.push_back(form_.addQuantity(Quantity::length(-1000, 1000), place));
    }
    for (const char* key : {"height_mm", "speed_m_s"}) { fields_.push_back(form_.addNumber(drop, key)); }
}

void DropletSection::refresh()
{
    const QSignalBlocker quiet(list_);
    const Experiment* experiment = this->experiment();
    const int count = experiment ? static_cast<int>(experiment->droplets.size()) : 0;
    const int chosen = std::clamp(droplet_, 0, std::max(0, count - 1));
    if (chosen != droplet_) {
        droplet_ = chosen;
        form_.refresh();
        return;
    }
    list_->clear();
    const UserUnit user = userUnit("mm");
    for (int i = 0; i < count; ++i) {
        const Droplet& drop = experiment->droplets[static_cast<std::size_t>(i)];
        list_->addItem(tr("%1: %2 µl at %3 s, at (%4, %5) %6")
                           .arg(i + 1)
                           .arg(shownNumber(drop.volume_ul, 2), shownNumber(drop.time_s, 2), significant(user.of(drop.at_mm[0])),
                                significant(user.of(drop.at_mm[1])), user.unit));
    }
    list_->setCurrentRow(count > 0 ? droplet_ : -1);
    remove_->setEnabled(count > 0);
    place_->setEnabled(count > 0);
    if (count == 0 || !uses_field(experiment->type, "droplets")) { place_->setChecked(false); }
    none_->setVisible(count == 0);
    for (QWidget* widget : fields_) { widget->setEnabled(count > 0); }
}

const Experiment* DropletSection::experiment() const { return form_.document().experiment(); }

void DropletSection::edit(const QString& undo, const std::function<void(Experiment&)>& change)
{
    const auto index = static_cast<std::size_t>(form_.document().experimentIndex());
    form_.document().edit(undo, {}, [&](Design& design) { change(design.experiments[index]); });
}

void DropletSection::choose(int droplet)
{
    if (droplet == droplet_) { return; }
    droplet_ = droplet;
    form_.refresh();
    Q_EMIT dropletChosen();
}

void DropletSection::addDroplet()
{
    const Experiment* experiment = this->experiment();
    if (!experiment) { return; }
    // After the last one by default: two drops in one place at one time would overlap.
    Droplet drop = experiment->droplets.empty() ? Droplet{} : experiment->droplets.back();
    if (!experiment->droplets.empty()) { drop.time_s += std::min(1.0, std::max(0.0, experiment->duration_s - drop.time_s) / 2); }
    droplet_ = static_cast<int>(experiment->droplets.size());
    edit(tr("add droplet"), [&](Experiment& e) { e.droplets.push_back(drop); });
}

void DropletSection::addDropletAt(const QPointF& at)
{
    const Experiment* experiment = this->experiment();
    if (!experiment || !uses_field(experiment->type, "droplets")) { return; }
    const auto& droplets = experiment->droplets;
    Droplet drop = droplet_ < static_cast<int>(droplets.size()) ? droplets[static_cast<std::size_t>(droplet_)] : Droplet{};
    drop.at_mm = onSample(*experiment, at);
    droplet_ = static_cast<int>(droplets.size());
    edit(tr("add droplet"), [&](Experiment& e) { e.droplets.push_back(drop); });
}

void DropletSection::moveDroplet(int droplet, const QPointF& at)
{
    choose(droplet);
    const Experiment* experiment = this->experiment();
    if (!experiment || droplet >= static_cast<int>(experiment->droplets.size())) { return; }
    edit(tr("droplet position"), [&](Experiment& e) { e.droplets[static_cast<std::size_t>(droplet)].at_mm = onSample(e, at); });
}

void DropletSection::deleteDroplet(int droplet)
{
    choose(droplet);
    removeDroplet();
}

void DropletSection::placeDroplet(const QPointF& at)
{
    const auto rounded = [](double mm) { return std::round(10 * mm) / 10; };
    const Experiment* experiment = this->experiment();
    if (experiment && droplet_ < static_cast<int>(experiment->droplets.size())) {
        edit(tr("droplet position"), [&](Experiment& e) {
            e.droplets[static_cast<std::size_t>(droplet_)].at_mm = onSample(e, {rounded(at.x()), rounded(at.y())});
        });
        form_.document().endStroke();
    }
}

bool DropletSection::placing() const { return place_->isChecked(); }

void DropletSection::endPlacing() { place_->setChecked(false); }

void DropletSection::removeDroplet()
{
    const Experiment* experiment = this->experiment();
    if (experiment && droplet_ < static_cast<int>(experiment->droplets.size())) {
        edit(tr("remove droplet"), [&](Experiment& e) { e.droplets.erase(e.droplets.begin() + droplet_); });
    }
}

} // namespace hygroloom
