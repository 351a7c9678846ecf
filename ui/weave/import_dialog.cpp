// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/weave/import_dialog.h"

#include "core/design/draft.h"
#include "ui/basics/appearance.h"
#include "ui/basics/quantity.h"
#include "ui/weave/cloth_picture.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int preview_side = 260; // pixels

} // namespace

ImportDialog::ImportDialog(DraftImport draft, QWidget* parent)
    : QDialog(parent), draft_(std::move(draft)), name_(new QLineEdit(QString::fromStdString(draft_.fabric.name)))
{
    setWindowTitle(tr("Import Draft"));
    name_->setAccessibleName(tr("Name of the fabric"));
    auto* naming = new QHBoxLayout;
    auto* label = new QLabel(tr("&Name"));
    label->setBuddy(name_);
    naming->addWidget(label);
    naming->addWidget(name_, 1);

    auto* left = new QVBoxLayout;
    left->addLayout(naming);
    auto* heading = new QLabel(tr("What was understood, and what was repaired"));
    QFont font = heading->font();
    font.setBold(true);
    heading->setFont(font);
    left->addWidget(heading);
    left->addWidget(buildReport(), 1);
    if (!draft_.numbers_are_ours) {
        ends_ = addSuggestion(tr("Ends"), tr("per cm"), draft_.ends_per_cm);
        picks_ = addSuggestion(tr("Picks"), tr("per cm"), draft_.picks_per_cm);
        warp_ = addSuggestion(tr("Warp diameter"), tr("mm"), draft_.warp_diameter_mm);
        weft_ = addSuggestion(tr("Weft diameter"), tr("mm"), draft_.weft_diameter_mm);
        const bool any = ends_ || picks_ || warp_ || weft_;
        auto* note = new QLabel(any ? tr("Use these values from the file:")
                                    : tr("The file contains neither sett nor thickness. Set them in the Fabric panel."));
        note->setWordWrap(true);
        left->addWidget(note);
        for (QCheckBox* box : {ends_, picks_, warp_, weft_}) {
            if (box) { left->addWidget(box); }
        }
    }
    auto* middle = new QHBoxLayout;
    middle->setSpacing(16);
    middle->addLayout(left, 1);
    middle->addWidget(buildPreview(), 0, Qt::AlignTop);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Add Fabric"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(name_, &QLineEdit::textChanged, this,
            [buttons](const QString& text) { buttons->button(QDialogButtonBox::Ok)->setEnabled(!text.trimmed().isEmpty()); });
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(middle, 1);
    layout->addWidget(buttons);
    resize(760, 480);
}

QWidget* ImportDialog::buildReport()
{
    auto* list = new QListWidget;
    list->setAccessibleName(tr("Report of the import"));
    list->setWordWrap(true);
    list->setIconSize({16, 16});
    list->setSelectionMode(QAbstractItemView::NoSelection);
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    for (const ImportLine& line : draft_.report) {
        const QString word = line.severity == Severity::note      ? tr("Understood")
                             : line.severity == Severity::warning ? tr("Repaired")
                                                                  : tr("Error");
        list->addItem(new QListWidgetItem(severityIcon(line.severity), tr("%1: %2").arg(word, QString::fromStdString(line.text))));
    }
    return list;
}

QWidget* ImportDialog::buildPreview()
{
    const Fabric& fabric = draft_.fabric;
    auto* preview = new QWidget;
    auto* layout = new QVBoxLayout(preview);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* picture = new QLabel;
    picture->setAccessibleName(tr("The cloth in the colours of its yarns"));
    picture->setFixedSize(preview_side, preview_side);
    const int threads = std::clamp(2 * std::max(fabric.weave.ends(), fabric.weave.picks()), 24, preview_side);
    const int side = preview_side / threads * threads;
    QPixmap pixmap = QPixmap::fromImage(clothPicture(fabric, threads, threads).scaled(QSize(side, side) * devicePixelRatioF()));
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    picture->setPixmap(pixmap);
    layout->addWidget(picture);
    QString about = tr("%1 × %2 crossings in one repeat").arg(fabric.weave.ends()).arg(fabric.weave.picks());
    if (fabric.weave.draft()) { about += "\n" + tr("%1 shafts").arg(fabric.weave.draft()->shafts); }
    if (!fabric.extra_yarns.empty()) { about += "\n" + tr("%1 more yarns in stripes").arg(fabric.extra_yarns.size()); }
    auto* text = new QLabel(about);
    text->setWordWrap(true);
    layout->addWidget(text);
    return preview;
}

QCheckBox* ImportDialog::addSuggestion(const QString& label, const QString& unit, const Suggestion& suggestion)
{
    if (!suggestion.value) { return nullptr; }
    QString text = tr("%1: %2 %3").arg(label, shownNumber(*suggestion.value, 3), unit);
    if (!suggestion.plausible) { text += tr(" – doubtful"); }
    auto* box = new QCheckBox(text);
    box->setChecked(suggestion.plausible);
    if (!suggestion.why.empty()) {
        const QString why = QString::fromStdString(suggestion.why);
        box->setToolTip("<p>" + why.toHtmlEscaped() + "</p>");
        box->setAccessibleDescription(why);
        box->setIcon(severityIcon(Severity::warning));
    }
    return box;
}

Fabric ImportDialog::fabric() const
{
    DraftImport chosen = draft_;
    const auto take = [](Suggestion& suggestion, const QCheckBox* box) { suggestion.plausible = box && box->isChecked(); };
    take(chosen.ends_per_cm, ends_);
    take(chosen.picks_per_cm, picks_);
    take(chosen.warp_diameter_mm, warp_);
    take(chosen.weft_diameter_mm, weft_);
    if (!chosen.numbers_are_ours) { take_suggestions(chosen); }
    chosen.fabric.name = name_->text().trimmed().toStdString();
    return chosen.fabric;
}

} // namespace hygroloom
