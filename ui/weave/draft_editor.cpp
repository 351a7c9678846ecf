// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/weave/draft_editor.h"

#include "core/design/drawdown.h"
#include "ui/basics/design_undo.h"
#include "ui/basics/icon_button.h"
#include "ui/weave/order_editor.h"
#include "ui/weave/weave_edits.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

/// The list with this number in it or not; alone unless others may stay.
void mark(std::vector<int>& list, int number, bool on, bool beside)
{
    if (on && !beside) { list.clear(); }
    std::erase(list, number);
    if (on) { list.insert(std::upper_bound(list.begin(), list.end(), number), number); }
}

void dropFrom(std::vector<std::vector<int>>& lists, int first)
{
    for (std::vector<int>& list : lists) {
        std::erase_if(list, [first](int number) { return number >= first; });
    }
}

/// A larger weave takes too long to check and to draw in 3D while the mouse is down; it goes into the design when the stroke ends.
constexpr int most_live_crossings = 250000;

} // namespace

DraftEditor::DraftEditor(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), paper_(new DraftPaper), order_(new OrderEditor(document))
{
    order_->setMaximumWidth(200);
    order_->setMinimumWidth(150);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(4);
    middle->addWidget(paper_, 1);
    middle->addWidget(order_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(4);
    layout->addWidget(buildBar());
    layout->addLayout(middle, 1);
    layout->addWidget(note_);
    connect(paper_, &DraftPaper::cellPainted, this, [this](DraftPart part, const QPoint& cell, bool fill, bool add) {
        paint({part, cell, fill, add});
    });
    connect(paper_, &DraftPaper::strokeEnded, this, [this] {
        finishStroke();
        document_.endStroke();
    });
    later_.setSingleShot(true);
    connect(&later_, &QTimer::timeout, this, &DraftEditor::sketchStroke);
    connect(&document_, &Document::designChanged, this, [this] {
        if (!stroke_.empty()) { // undone with the mouse down, for example: the stroke continues from there
            sketch_.reset();
            later_.start();
        }
        if (isVisible()) { refresh(); }
    });
    refresh();
}

QWidget* DraftEditor::buildBar()
{
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    shafts_ = addCount(row, tr("Shafts"), &DraftEditor::setShafts);
    treadles_ = addCount(row, tr("Treadles"), &DraftEditor::setTreadles);
    addChoices(row);
    find_ = new QPushButton(tr("Find Draft"));
    find_->setToolTip("<p>" + tr("Find the draft of this weave with the fewest shafts and treadles.") + "</p>");
    connect(find_, &QPushButton::clicked, this, &DraftEditor::findDraft);
    row->addWidget(find_);
    note_ = new QLabel;
    note_->setForegroundRole(QPalette::PlaceholderText);
    note_->setAccessibleName(tr("About the draft"));
    note_->setWordWrap(true);
    QSizePolicy policy = note_->sizePolicy();
    policy.setRetainSizeWhenHidden(true); // the first square that is drawn hides it, and the paper keeps its place
    note_->setSizePolicy(policy);
    row->addStretch();
    const auto button = [&](const char* icon, const QString& name, auto work) {
        QToolButton* made = iconButton(icon, name);
        connect(made, &QToolButton::clicked, this, work);
        row->addWidget(made);
        return made;
    };
    QToolButton* colored = button("palette", tr("Show the cloth in the colours of its yarns"), [this](bool on) { paper_->setColored(on); });
    colored->setCheckable(true);
    colored->setChecked(true);
    button("zoom-in", tr("Zoom into the draft"), [this] { paper_->zoomBy(1.25); });
    button("zoom-out", tr("Zoom out of the draft"), [this] { paper_->zoomBy(0.8); });
    return bar;
}

QSpinBox* DraftEditor::addCount(QHBoxLayout* row, const QString& name, void (DraftEditor::*work)(int))
{
    auto* box = new QSpinBox;
    new DesignUndo(box);
    box->setRange(1, most_shafts);
    box->setKeyboardTracking(false);
    box->setAccessibleName(name);
    row->addWidget(new QLabel(name));
    row->addWidget(box);
    connect(box, &QSpinBox::valueChanged, this, work);
    return box;
}

/// Tie-up and treadling or liftplan, rising or sinking shed.
void DraftEditor::addChoices(QHBoxLayout* row)
{
    const auto choice = [&](const QString& name, const QStringList& items, const QString& tip) {
        auto* box = new QComboBox;
        box->addItems(items);
        box->setAccessibleName(name);
        box->setToolTip("<p>" + tip + "</p>");
        row->addWidget(box);
        return box;
    };
    plan_ = choice(tr("Treadling or liftplan"), {tr("Tie-up and treadling"), tr("Liftplan")},
                   tr("A treadle lifts the shafts tied to it. A liftplan lists the shafts of each pick. Both weave the same cloth."));
    shed_ = choice(tr("Shed"), {tr("Rising shed"), tr("Sinking shed")},
                   tr("Whether the marked shafts rise or sink. The marks stay; the cloth turns over."));
    connect(plan_, &QComboBox::activated, this, [this](int index) {
        setDraft(index == 0 ? tr("tie-up and treadling") : tr("liftplan"), {}, index == 0 ? with_tie_up(draft()) : with_liftplan(draft()));
    });
    connect(shed_, &QComboBox::activated, this, [this](int index) {
        Draft draft = this->draft();
        draft.rising_shed = index == 0;
        setDraft(index == 0 ? tr("rising shed") : tr("sinking shed"), {}, std::move(draft));
    });
}

void DraftEditor::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    refresh();
}

void DraftEditor::hideEvent(QHideEvent* event)
{
    finishStroke(); // the release of the button will not arrive here
    QWidget::hideEvent(event);
}

void DraftEditor::refresh()
{
    const Fabric* fabric = document_.fabric();
    setEnabled(fabric != nullptr);
    if (!fabric || (shown_ && *shown_ == *fabric)) { return; }
    const Weave& weave = fabric->weave;
    const bool known = shown_ && shown_->weave == weave;
    shown_ = *fabric;
    paper_->setDraft(*fabric, weave.draft() ? *weave.draft() : known ? Draft(draft()) : smallest_draft(weave));
    const bool liftplan = !draft().liftplan.empty();
    const QSignalBlocker quietShafts(shafts_), quietTreadles(treadles_);
    shafts_->setValue(draft().shafts);
    treadles_->setValue(std::max(1, draft().treadles));
    treadles_->setEnabled(!liftplan);
    plan_->setCurrentIndex(liftplan ? 1 : 0);
    shed_->setCurrentIndex(draft().rising_shed ? 0 : 1);
    note_->setText(tr("The weave has no draft of its own; this is the smallest one. Change it here or press Find Draft to keep it."));
    note_->setVisible(!weave.draft());
}

void DraftEditor::paint(const PaintedCell& painted)
{
    if (!document_.fabric()) { return; }
    stroke_.push_back(painted);
    const Weave& weave = document_.fabric()->weave;
    if (weave.ends() * weave.picks() <= most_live_crossings) {
        finishStroke();
    } else if (!later_.isActive()) {
        later_.start();
    }
}

/// All cells are of one stroke, and so of one part.
void DraftEditor::paintInto(Sketch& sketch, const std::vector<PaintedCell>& cells) const
{
    const auto list = [](std::vector<std::vector<int>>& lists, int i) -> std::vector<int>& { return lists[static_cast<std::size_t>(i)]; };
    Fabric& fabric = sketch.fabric;
    Crossings crossings;
    bool changed = false;
    for (const auto& [part, cell, fill, add] : cells) {
        if (part == DraftPart::drawdown) {
            crossings << cell;
            continue;
        }
        if (part == DraftPart::warpBar || part == DraftPart::weftBar) {
            const bool warp = part == DraftPart::warpBar;
            const QSize size = paper_->cells(part);
            order_->paintThread(fabric, warp, warp ? cell.x() : cell.y(), warp ? size.width() : size.height());
            continue;
        }
        const QPoint at(wrapped(cell.x(), fabric.weave.ends()), wrapped(cell.y(), fabric.weave.picks()));
        Draft draft = sketch.draft;
        if (part == DraftPart::threading) {
            mark(list(draft.threading, at.x()), cell.y(), fill, add);
        } else if (part == DraftPart::tieUp) {
            mark(list(draft.tie_up, cell.x()), cell.y(), fill, true);
        } else if (!draft.liftplan.empty()) {
            mark(list(draft.liftplan, at.y()), cell.x(), fill, true);
        } else {
            mark(list(draft.treadling, at.y()), cell.x(), fill, add);
        }
        if (draft != sketch.draft && fault_in(draft).empty()) {
            sketch.draft = std::move(draft);
            changed = true;
        }
    }
    if (!crossings.isEmpty()) {
        fabric.weave = withPainted(fabric.weave, crossings, cells.front().fill);
    } else if (changed) {
        fabric.weave = weave_from_draft(sketch.draft);
    }
}

/// Shows what was painted since it was last called.
void DraftEditor::sketchStroke()
{
    const Fabric* fabric = document_.fabric();
    if (!fabric || stroke_.empty()) { return; }
    if (!sketch_) {
        sketch_ = Sketch{*fabric, fabric->weave.draft() ? *fabric->weave.draft() : Draft(draft())};
        sketched_ = 0;
    }
    paintInto(*sketch_, {stroke_.begin() + static_cast<std::ptrdiff_t>(sketched_), stroke_.end()});
    sketched_ = stroke_.size();
    paper_->setDraft(sketch_->fabric, sketch_->draft);
}

void DraftEditor::finishStroke()
{
    later_.stop();
    const Fabric* fabric = document_.fabric();
    if (!fabric || stroke_.empty()) {
        stroke_.clear();
        return;
    }
    if (!sketch_ || sketched_ < stroke_.size()) { sketchStroke(); }
    const DraftPart part = stroke_.front().part;
    const Fabric painted = sketch_->fabric;
    const bool liftplan = !sketch_->draft.liftplan.empty();
    stroke_.clear();
    sketch_.reset();
    if (painted == *fabric) { return; }
    const QString undo = part == DraftPart::drawdown    ? tr("drawdown")
                         : part == DraftPart::threading ? tr("threading")
                         : part == DraftPart::tieUp     ? tr("tie-up")
                         : part == DraftPart::warpBar   ? tr("order of the ends")
                         : part == DraftPart::weftBar   ? tr("order of the picks")
                         : liftplan                     ? tr("liftplan")
                                                        : tr("treadling");
    const auto index = static_cast<std::size_t>(document_.fabricIndex());
    document_.edit(undo, "draft part " + std::to_string(static_cast<int>(part)), [&](Design& design) { design.fabrics[index] = painted; });
}

void DraftEditor::setDraft(const QString& undo, const std::string& field, Draft draft)
{
    if (!document_.fabric() || (document_.fabric()->weave.draft() && *document_.fabric()->weave.draft() == draft) ||
        !fault_in(draft).empty()) {
        return;
    }
    const auto index = static_cast<std::size_t>(document_.fabricIndex());
    const Weave weave = weave_from_draft(std::move(draft));
    document_.edit(undo, field, [&](Design& design) { design.fabrics[index].weave = weave; });
}

void DraftEditor::findDraft()
{
    if (document_.fabric()) { setDraft(tr("find draft"), {}, smallest_draft(document_.fabric()->weave)); }
}

void DraftEditor::setShafts(int shafts)
{
    Draft draft = this->draft();
    draft.shafts = shafts;
    dropFrom(draft.threading, shafts);
    dropFrom(draft.tie_up, shafts);
    dropFrom(draft.liftplan, shafts);
    setDraft(tr("number of shafts"), "shafts", std::move(draft));
}

void DraftEditor::setTreadles(int treadles)
{
    Draft draft = this->draft();
    draft.treadles = treadles;
    draft.tie_up.resize(static_cast<std::size_t>(treadles));
    dropFrom(draft.treadling, treadles);
    setDraft(tr("number of treadles"), "treadles", std::move(draft));
}

} // namespace hygroloom
