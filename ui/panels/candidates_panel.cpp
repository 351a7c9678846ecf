// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/panels/candidates_panel.h"

#include "core/base/units.h"

#include "core/base/error.h"
#include "core/base/words.h"
#include "ui/basics/appearance.h"
#include "ui/basics/quantity.h"
#include "ui/panels/preset_gallery.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

/// A small piece of the weave, to recognize fabrics by.
QPixmap weaveSwatch(const Weave& weave, const QPalette& palette, double ratio)
{
    constexpr int squares = 6, size = 3;
    QPixmap pixmap(QSize(squares * size, squares * size) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    const PaperColors colors = paperColors(palette);
    pixmap.fill(colors.paper);
    QPainter painter(&pixmap);
    for (int end = 0; end < squares; ++end) {
        for (int pick = 0; pick < squares; ++pick) {
            if (weave.warp_up(end, pick)) { painter.fillRect(end * size, (squares - 1 - pick) * size, size, size, colors.ink); }
        }
    }
    return pixmap;
}

std::string freeFabricName(const Design& design, const std::string& wish)
{
    return free_name(wish, [&design](const std::string& name) { return find_fabric(design, name) != nullptr; });
}

/// A project with a fabric has an experiment.
void ensureExperiment(Design& design)
{
    if (design.experiments.empty()) {
        design.experiments.push_back(Experiment{});
        design.experiments.front().name = CandidatesPanel::tr("one drop").toStdString();
    }
}

} // namespace

CandidatesPanel::CandidatesPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), list_(new QListWidget),
      empty_(new QLabel(tr("This project has no fabric yet.\nAdd one to begin.")))
{
    list_->setAccessibleName(tr("Fabrics of the project"));
    setFocusProxy(list_);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // the tool tip shows long names in full
    list_->setIconSize({18, 18});
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);

    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(4, 4, 4, 4);
    buttons->setSpacing(4);
    const auto add = [&](const QString& icon, const QString& text, const QString& tip, void (CandidatesPanel::*work)()) {
        auto* action = new QAction(themedIcon(icon), text, this);
        action->setToolTip(tip);
        connect(action, &QAction::triggered, this, work);
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setAccessibleName(tip);
        buttons->addWidget(button);
        actions_ << action;
    };
    add("add", tr("&Add Fabric"), tr("Add a plain-weave cotton fabric"), qOverload<>(&CandidatesPanel::addFabric));
    add("duplicate", tr("D&uplicate Fabric"), tr("Add a copy of the selected fabric"), &CandidatesPanel::duplicateFabric);
    add("rename", tr("&Rename Fabric"), tr("Rename the selected fabric"), &CandidatesPanel::renameFabric);
    add("delete", tr("&Delete Fabric"), tr("Delete the selected fabric"), &CandidatesPanel::deleteFabric);
    add("gallery", tr("From &Preset…"), tr("Add a fabric from the library"), &CandidatesPanel::chooseFromLibrary);
    add("keep", tr("&Save to My Library"), tr("Save the selected fabric to my library"), &CandidatesPanel::keepFabric);
    actions_[2]->setShortcut(Qt::Key_F2);
    actions_[3]->setShortcut(QKeySequence::Delete);
    for (QAction* action : actions_) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        addAction(action);
    }
    buttons->addStretch();

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(list_, 1);
    layout->addWidget(empty_, 1);
    layout->addLayout(buttons);
    connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0) { document_.setFabricIndex(row); }
    });
    connect(list_, &QListWidget::itemChanged, this, &CandidatesPanel::finishRename);
    connect(&document_, &Document::designChanged, this, &CandidatesPanel::refresh);
    refresh();
}

void CandidatesPanel::refresh()
{
    const QSignalBlocker quiet(list_);
    const auto& fabrics = document_.design()->fabrics;
    const int count = static_cast<int>(fabrics.size());
    while (list_->count() > count) { delete list_->takeItem(list_->count() - 1); }
    while (list_->count() < count) {
        auto* item = new QListWidgetItem(list_);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    for (int row = 0; row < count; ++row) {
        const Fabric& fabric = fabrics[static_cast<std::size_t>(row)];
        QListWidgetItem* item = list_->item(row);
        item->setText(QString::fromStdString(fabric.name));
        item->setIcon(weaveSwatch(fabric.weave, palette(), devicePixelRatioF()));
        const QString about = tr("%1: %2, %3 × %4 per cm")
                                  .arg(QString::fromStdString(fabric.name),
                                       fabric.weave.pattern().empty() ? tr("free weave") : QString::fromStdString(fabric.weave.pattern()),
                                       shownNumber(fabric.ends_per_cm, 1), shownNumber(fabric.picks_per_cm, 1));
        item->setToolTip("<p>" + about.toHtmlEscaped() + "</p>");
    }
    list_->setCurrentRow(count > 0 ? document_.fabricIndex() : -1);
    list_->setVisible(count > 0);
    empty_->setVisible(count == 0);
    for (const int i : {1, 2, 3, 5}) { // all that need a fabric
        actions_[i]->setEnabled(count > 0);
    }
}

void CandidatesPanel::addFabric()
{
    Fabric fabric;
    fabric.name = tr("New fabric").toStdString();
    fabric.warp.linear_density_tex = fabric.weft.linear_density_tex = tex_from_ne(30); // a sheeting
    fabric.ends_per_cm = fabric.picks_per_cm = 24;
    addFabric(tr("add fabric"), std::move(fabric));
    list_->setFocus(); // F2 names the new one
}

void CandidatesPanel::addFabric(const QString& undo, Fabric fabric)
{
    document_.editState(undo, [&](Design& design, DesignState& state) {
        fabric.name = freeFabricName(design, fabric.name);
        design.fabrics.push_back(std::move(fabric));
        ensureExperiment(design);
        state.fabric = static_cast<int>(design.fabrics.size()) - 1;
    });
}

void CandidatesPanel::chooseFromLibrary()
{
    PresetGallery gallery(userLibraryPath(), this);
    if (gallery.exec() == QDialog::Accepted && gallery.chosen()) { addPreset(*gallery.chosen()); }
}

void CandidatesPanel::addPreset(const Preset& preset)
{
    document_.editState(tr("add %1").arg(QString::fromStdString(preset.fabric().name)), [&](Design& design, DesignState& state) {
        state.fabric = static_cast<int>(add_preset(design, preset));
        ensureExperiment(design);
    });
}

void CandidatesPanel::addShipped(int preset) { addPreset(shipped_presets().at(static_cast<std::size_t>(preset))); }

void CandidatesPanel::keepFabric()
{
    if (!document_.fabric()) { return; }
    try {
        keepInLibrary(*document_.design(), *document_.fabric(), userLibraryPath());
        Q_EMIT reported(tr("Saved %1 to my library.").arg(QString::fromStdString(document_.fabric()->name)), false);
    } catch (const Error& error) {
        Q_EMIT reported(QString::fromStdString(error.what()), true);
    }
}

void CandidatesPanel::duplicateFabric()
{
    if (!document_.fabric()) { return; }
    document_.editState(tr("duplicate fabric"), [this](Design& design, DesignState& state) {
        Fabric fabric = *document_.fabric();
        fabric.name = freeFabricName(design, tr("%1 copy").arg(QString::fromStdString(fabric.name)).toStdString());
        design.fabrics.insert(design.fabrics.begin() + state.fabric + 1, fabric);
        ++state.fabric;
    });
    list_->setFocus(); // F2 names the new one
}

void CandidatesPanel::renameFabric()
{
    if (QListWidgetItem* item = list_->currentItem()) { list_->editItem(item); }
}

void CandidatesPanel::deleteFabric()
{
    if (!document_.fabric()) { return; }
    document_.editState(tr("delete fabric"), [](Design& design, DesignState& state) {
        design.fabrics.erase(design.fabrics.begin() + state.fabric);
        state.fabric = std::max(0, std::min(state.fabric, static_cast<int>(design.fabrics.size()) - 1));
    });
}

void CandidatesPanel::finishRename(QListWidgetItem* item)
{
    const auto row = static_cast<std::size_t>(list_->row(item));
    const std::string name = item->text().trimmed().toStdString();
    if (name.empty() || name == document_.design()->fabrics[row].name) {
        refresh();
        return;
    }
    document_.edit(tr("rename fabric"), {}, [&](Design& design) {
        for (Garment& garment : design.garments) {
            for (auto& [panel, cut] : garment.panels) {
                for (std::string* fabric : {&cut.fabric, &cut.lining}) {
                    if (*fabric == design.fabrics[row].name) { *fabric = name; }
                }
            }
        }
        design.fabrics[row].name = name;
    });
    document_.endStroke();
}

} // namespace hygroloom
