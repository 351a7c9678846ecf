// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/weave/weave_editor.h"

#include "core/base/error.h"
#include "ui/basics/appearance.h"
#include "ui/basics/core_words.h"
#include "ui/basics/design_undo.h"
#include "ui/weave/point_paper.h"
#include "ui/weave/weave_notes.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QToolButton>
#include <QVBoxLayout>

namespace hygroloom {

namespace {

QSpinBox* countBox(const QString& name)
{
    auto* box = new QSpinBox;
    box->setRange(1, largest_repeat);
    box->setKeyboardTracking(false);
    new DesignUndo(box);
    box->setAccessibleName(name);
    box->setToolTip(name);
    return box;
}

} // namespace

WeaveEditor::WeaveEditor(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), pattern_(new QComboBox), ends_(countBox(tr("Ends of the repeat"))),
      picks_(countBox(tr("Picks of the repeat"))), paper_(new PointPaper), notes_(new WeaveNotes(document))
{
    pattern_->setEditable(true);
    new DesignUndo(pattern_);
    pattern_->setInsertPolicy(QComboBox::NoInsert);
    pattern_->setAccessibleName(tr("Weave pattern"));
    pattern_->setToolTip(tr("Choose a weave, or type one such as “twill 3/1 S” or “satin 8/3”."));
    pattern_->lineEdit()->setPlaceholderText(tr("free weave"));
    pattern_->setMinimumContentsLength(10);
    pattern_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    addPatterns();

    auto* size = new QHBoxLayout;
    size->setSpacing(4);
    size->addWidget(new QLabel(tr("Repeat")));
    size->addWidget(ends_);
    size->addWidget(new QLabel(QStringLiteral("×")));
    size->addWidget(picks_);
    size->addStretch();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    auto* draft = new QToolButton;
    draft->setIcon(themedIcon("draft"));
    draft->setAutoRaise(true);
    draft->setAccessibleName(tr("Edit the draft"));
    draft->setToolTip(tr("Edit threading, tie-up, treadling and the order of the yarns."));
    connect(draft, &QToolButton::clicked, this, &WeaveEditor::draftRequested);
    auto* top = new QHBoxLayout;
    top->setSpacing(4);
    top->addWidget(pattern_, 1);
    top->addWidget(draft);
    layout->addLayout(top);
    layout->addWidget(buildTools());
    layout->addWidget(paper_, 1);
    layout->addLayout(size);
    layout->addWidget(notes_);

    connect(pattern_, &QComboBox::textActivated, this, &WeaveEditor::choosePattern);
    connect(pattern_->lineEdit(), &QLineEdit::editingFinished, this, &WeaveEditor::choosePattern);
    connect(ends_, &QSpinBox::valueChanged, this, &WeaveEditor::resizeRepeat);
    connect(picks_, &QSpinBox::valueChanged, this, &WeaveEditor::resizeRepeat);
    connect(paper_, &PointPaper::painted, this, [this](const Crossings& crossings, bool up) {
        setWeave(tr("weave"), "weave drawn", withPainted(document_.fabric()->weave, crossings, up));
    });
    connect(paper_, &PointPaper::strokeEnded, this, [this] { document_.endStroke(); });
    connect(&document_, &Document::designChanged, this, &WeaveEditor::refresh);
    refresh();
}

void WeaveEditor::addPatterns()
{
    auto* items = new QStandardItemModel(pattern_);
    for (const WeaveGroup& group : weave_catalogue()) {
        auto* heading = new QStandardItem(coreWord(group.name));
        heading->setFlags(Qt::NoItemFlags);
        QFont font = heading->font();
        font.setBold(true);
        heading->setFont(font);
        items->appendRow(heading);
        for (const std::string& name : group.patterns) { items->appendRow(new QStandardItem(QString::fromStdString(name))); }
    }
    pattern_->setModel(items);
    pattern_->setMaxVisibleItems(24);
}

void WeaveEditor::refresh()
{
    const Fabric* fabric = document_.fabric();
    setEnabled(fabric != nullptr);
    const QSignalBlocker quietEnds(ends_);
    const QSignalBlocker quietPicks(picks_);
    const Weave weave = fabric ? fabric->weave : Weave();
    paper_->setWeave(weave);
    ends_->setValue(weave.ends());
    picks_->setValue(weave.picks());
    const QString pattern = fabric ? QString::fromStdString(weave.pattern()) : QString();
    pattern_->setCurrentIndex(pattern_->findText(pattern));
    pattern_->setEditText(pattern);
    pattern_->lineEdit()->setCursorPosition(0);
}

void WeaveEditor::choosePattern()
{
    const std::string name = pattern_->currentText().trimmed().toStdString();
    if (!document_.fabric() || name.empty() || name == document_.fabric()->weave.pattern()) { return; }
    try {
        setWeave(tr("weave pattern"), {}, weave_from_pattern(name));
    } catch (const Error& error) {
        complain(pattern_, QString::fromStdString(error.what()));
        refresh();
    }
}

void WeaveEditor::resizeRepeat()
{
    const Fabric* fabric = document_.fabric();
    if (!fabric) { return; }
    setWeave(tr("size of the repeat"), "weave size", resized(fabric->weave, ends_->value(), picks_->value()));
}

void WeaveEditor::setWeave(const QString& undo, const std::string& field, const Weave& weave)
{
    if (weave == document_.fabric()->weave) { return; }
    const int index = document_.fabricIndex();
    document_.edit(undo, field, [&](Design& design) { design.fabrics[static_cast<std::size_t>(index)].weave = weave; });
}

} // namespace hygroloom
