// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/draft_editor.h"

#include "ui/appearance.h"
#include "ui/order_editor.h"
#include "ui/weave_edits.h"

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
    if (on && !beside) {
        list.clear();
    }
    std::erase(list, number);
    if (on) {
        list.insert(std::upper_bound(list.begin(), list.end(), number), number);
    }
}

void dropFrom(std::vector<std::vector<int>>& lists, int first)
{
    for (std::vector<int>& list : lists) {
        std::erase_if(list, [first](int number) { return number >= first; });
    }
}

} // namespace

DraftEditor::DraftEditor(Document& document, QWidget* parent)
    : QWidget(parent)
    , document_(document)
    , paper_(new DraftPaper)
    , order_(new OrderEditor(document))
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
    connect(paper_, &DraftPaper::cellPainted, this, &DraftEditor::paint);
    connect(paper_, &DraftPaper::strokeEnded, this, [this] { document_.endStroke(); });
    connect(&document_, &Document::designChanged, this, [this] {
        if (isVisible()) {
            refresh();
        }
    });
    refresh();
}

QWidget* DraftEditor::buildBar()
{
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    const auto count = [&](const QString& name, void (DraftEditor::*work)(int)) {
        auto* box = new QSpinBox;
        box->setRange(1, most_shafts);
        box->setKeyboardTracking(false);
        box->setAccessibleName(name);
        row->addWidget(new QLabel(name));
        row->addWidget(box);
        connect(box, &QSpinBox::valueChanged, this, work);
        return box;
    };
    shafts_ = count(tr("Shafts"), &DraftEditor::setShafts);
    treadles_ = count(tr("Treadles"), &DraftEditor::setTreadles);
    const auto choice = [&](const QString& name, const QStringList& items, const QString& tip) {
        auto* box = new QComboBox;
        box->addItems(items);
        box->setAccessibleName(name);
        box->setToolTip("<p>" + tip + "</p>");
        row->addWidget(box);
        return box;
    };
    plan_ = choice(tr("Treadling or liftplan"), {tr("Tie-up and treadling"), tr("Liftplan")},
                   tr("Treadles lift the shafts tied to them; a liftplan names the shafts of each pick. The cloth stays the same."));
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
    find_ = new QPushButton(tr("Find Draft"));
    find_->setToolTip("<p>" + tr("Works out the draft of this weave with the fewest shafts and treadles.") + "</p>");
    connect(find_, &QPushButton::clicked, this, &DraftEditor::findDraft);
    row->addWidget(find_);
    note_ = new QLabel;
    note_->setForegroundRole(QPalette::PlaceholderText);
    note_->setAccessibleName(tr("About the draft"));
    note_->setWordWrap(true);
    row->addStretch();
    const auto button = [&](const char* icon, const QString& name, auto work) {
        auto* made = new QToolButton;
        made->setIcon(themedIcon(icon));
        made->setAutoRaise(true);
        made->setAccessibleName(name);
        made->setToolTip(name);
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

void DraftEditor::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    refresh();
}

void DraftEditor::refresh()
{
    const Fabric* fabric = document_.fabric();
    setEnabled(fabric != nullptr);
    if (!fabric || (shown_ && *shown_ == *fabric)) {
        return;
    }
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
    note_->setText(tr("This is the smallest draft of the weave, which has none of its own until you change it here or press Find Draft."));
    note_->setVisible(!weave.draft());
}

void DraftEditor::paint(DraftPart part, const QPoint& cell, bool fill, bool add)
{
    const Fabric* fabric = document_.fabric();
    if (!fabric) {
        return;
    }
    const QPoint at(wrapped(cell.x(), fabric->weave.ends()), wrapped(cell.y(), fabric->weave.picks()));
    if (part == DraftPart::warpBar || part == DraftPart::weftBar) {
        const QSize size = paper_->cells(part);
        const bool warp = part == DraftPart::warpBar;
        order_->paintThread(warp, warp ? cell.x() : cell.y(), warp ? size.width() : size.height());
        return;
    }
    if (part == DraftPart::drawdown) {
        const auto index = static_cast<std::size_t>(document_.fabricIndex());
        const Weave changed = withPainted(fabric->weave, {cell}, fill);
        document_.edit(tr("drawdown"), "drawdown", [&](Design& design) { design.fabrics[index].weave = changed; });
        return;
    }
    Draft draft = this->draft();
    const auto list = [](std::vector<std::vector<int>>& lists, int i) -> std::vector<int>& { return lists[static_cast<std::size_t>(i)]; };
    if (part == DraftPart::threading) {
        mark(list(draft.threading, at.x()), cell.y(), fill, add);
        setDraft(tr("threading"), "threading", std::move(draft));
    } else if (part == DraftPart::tieUp) {
        mark(list(draft.tie_up, cell.x()), cell.y(), fill, true);
        setDraft(tr("tie-up"), "tie-up", std::move(draft));
    } else if (!draft.liftplan.empty()) {
        mark(list(draft.liftplan, at.y()), cell.x(), fill, true);
        setDraft(tr("liftplan"), "liftplan", std::move(draft));
    } else {
        mark(list(draft.treadling, at.y()), cell.x(), fill, add);
        setDraft(tr("treadling"), "treadling", std::move(draft));
    }
}

void DraftEditor::setDraft(const QString& undo, const std::string& field, Draft draft)
{
    if (!document_.fabric() || (document_.fabric()->weave.draft() && *document_.fabric()->weave.draft() == draft) || !fault_in(draft).empty()) {
        return;
    }
    const auto index = static_cast<std::size_t>(document_.fabricIndex());
    const Weave weave = weave_from_draft(std::move(draft));
    document_.edit(undo, field, [&](Design& design) { design.fabrics[index].weave = weave; });
}

void DraftEditor::findDraft()
{
    if (document_.fabric()) {
        setDraft(tr("find draft"), {}, smallest_draft(document_.fabric()->weave));
    }
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
