// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/weave_editor.h"

#include "core/base/error.h"
#include "ui/design_undo.h"
#include "ui/point_paper.h"
#include "ui/quantity.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int largest_drawn_repeat = 64; // larger ones come from files


QSpinBox* countBox(const QString& name)
{
    auto* box = new QSpinBox;
    box->setRange(1, largest_drawn_repeat);
    box->setKeyboardTracking(false);
    box->setAccessibleName(name);
    box->setToolTip(name);
    return box;
}

/// Interlacings of one repeat: how often a yarn changes sides, per yarn and crossing.
double interlacingShare(const Weave& weave)
{
    int changes = 0;
    for (int end = 0; end < weave.ends(); ++end) {
        for (int pick = 0; pick < weave.picks(); ++pick) {
            changes += weave.warp_up(end, pick) != weave.warp_up(end, pick + 1);
            changes += weave.warp_up(end, pick) != weave.warp_up(end + 1, pick);
        }
    }
    return changes / (2.0 * weave.ends() * weave.picks());
}

} // namespace

WeaveEditor::WeaveEditor(Document& document, QWidget* parent)
    : QWidget(parent)
    , document_(document)
    , pattern_(new QComboBox)
    , ends_(countBox(tr("Ends of the repeat")))
    , picks_(countBox(tr("Picks of the repeat")))
    , paper_(new PointPaper)
    , summary_(new QLabel)
{
    pattern_->setEditable(true);
    new DesignUndo(pattern_->lineEdit());
    pattern_->setInsertPolicy(QComboBox::NoInsert);
    pattern_->setAccessibleName(tr("Weave pattern"));
    pattern_->setToolTip(tr("Choose a weave, or type one such as “twill 3/1 S” or “satin 8/3”."));
    pattern_->lineEdit()->setPlaceholderText(tr("free weave"));
    pattern_->setMinimumContentsLength(10);
    pattern_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const std::string& name : common_weave_patterns()) {
        pattern_->addItem(QString::fromStdString(name));
    }
    summary_->setForegroundRole(QPalette::PlaceholderText);
    summary_->setWordWrap(true);
    summary_->setAccessibleName(tr("About the weave"));

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
    layout->addWidget(pattern_);
    layout->addWidget(paper_, 1);
    layout->addLayout(size);
    layout->addWidget(summary_);

    connect(pattern_, &QComboBox::textActivated, this, &WeaveEditor::choosePattern);
    connect(pattern_->lineEdit(), &QLineEdit::returnPressed, this, &WeaveEditor::choosePattern);
    connect(ends_, &QSpinBox::valueChanged, this, &WeaveEditor::resizeRepeat);
    connect(picks_, &QSpinBox::valueChanged, this, &WeaveEditor::resizeRepeat);
    connect(paper_, &PointPaper::crossingPainted, this, [this](int end, int pick, bool) {
        setWeave(tr("weave"), "weave drawn", document_.fabric()->weave.toggled(end, pick));
    });
    connect(paper_, &PointPaper::strokeEnded, this, [this] { document_.endStroke(); });
    connect(&document_, &Document::designChanged, this, &WeaveEditor::refresh);
    refresh();
}

void WeaveEditor::refresh()
{
    const Fabric* fabric = document_.fabric();
    setEnabled(fabric != nullptr);
    if (!fabric) {
        summary_->setText(tr("Add a fabric to draw its weave."));
        return;
    }
    const QSignalBlocker quietEnds(ends_);
    const QSignalBlocker quietPicks(picks_);
    const Weave& weave = fabric->weave;
    paper_->setWeave(weave);
    ends_->setMaximum(std::max(largest_drawn_repeat, weave.ends()));
    picks_->setMaximum(std::max(largest_drawn_repeat, weave.picks()));
    ends_->setValue(weave.ends());
    picks_->setValue(weave.picks());
    pattern_->setCurrentIndex(pattern_->findText(QString::fromStdString(weave.pattern())));
    pattern_->setEditText(QString::fromStdString(weave.pattern()));
    pattern_->lineEdit()->setCursorPosition(0);
    summary_->setText(tr("%1 % of the crossings interlace").arg(shownNumber(100 * interlacingShare(weave), 0)));
    summary_->setToolTip("<p>" + tr("How often a yarn changes sides from one crossing to the next; 100 % is plain weave.") + "</p>");
}

void WeaveEditor::choosePattern()
{
    const std::string name = pattern_->currentText().trimmed().toStdString();
    if (!document_.fabric() || name.empty() || name == document_.fabric()->weave.pattern()) {
        return;
    }
    try {
        setWeave(tr("weave pattern"), {}, weave_from_pattern(name));
    } catch (const Error& error) {
        QToolTip::showText(pattern_->mapToGlobal(QPoint(0, pattern_->height())), "<p>" + QString::fromStdString(error.what()).toHtmlEscaped() + "</p>",
                           pattern_);
        refresh();
    }
}

void WeaveEditor::resizeRepeat()
{
    const Fabric* fabric = document_.fabric();
    if (!fabric) {
        return;
    }
    const int ends = ends_->value();
    const int picks = picks_->value();
    std::vector<std::uint8_t> up;
    for (int pick = 0; pick < picks; ++pick) {
        for (int end = 0; end < ends; ++end) {
            up.push_back(fabric->weave.warp_up(end, pick) ? 1 : 0);
        }
    }
    setWeave(tr("size of the repeat"), "weave size", Weave(ends, picks, std::move(up)));
}

void WeaveEditor::setWeave(const QString& undo, const std::string& field, const Weave& weave)
{
    const int index = document_.fabricIndex();
    document_.edit(undo, field, [&](Design& design) { design.fabrics[static_cast<std::size_t>(index)].weave = weave; });
}

} // namespace hygroloom
