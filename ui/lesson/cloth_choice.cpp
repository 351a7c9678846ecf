// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/lesson/cloth_choice.h"

#include "core/lesson/running_cloth.h"
#include "core/project/library.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>

#include <exception>

namespace hygroloom {

namespace {

/// In a sentence; empty: they stand.
std::string whyNoDrops(const LessonCloth& cloth)
try {
    return why_no_drops(cloth.design, Lesson().air);
} catch (const std::exception& error) {
    return error.what();
}

} // namespace

std::vector<LessonCloth> clothsToChoose(const Design& design)
{
    std::vector<LessonCloth> cloths;
    const auto offer = [&](const Design& one) {
        if (why_not_on_table(one).empty()) { cloths.push_back({one.fabrics[0].name, one}); }
    };
    for (const Fabric& fabric : design.fabrics) { offer(preset_of(design, fabric, {}, {}).design); }
    for (const Preset& preset : shipped_presets()) { offer(preset.design); }
    return cloths;
}

ClothChoice::ClothChoice(const Design& design, QWidget* parent)
    : QDialog(parent), offered_(clothsToChoose(design)), list_(new QListWidget), note_(new QLabel),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel))
{
    setWindowTitle(tr("Cloths on the Table"));
    for (const LessonCloth& cloth : offered_) {
        auto* item = new QListWidgetItem(QString::fromStdString(cloth.title), list_);
        if (const std::string reason = whyNoDrops(cloth); !reason.empty()) {
            item->setFlags(Qt::NoItemFlags);
            item->setText(tr("%1 (drops do not stand on it)").arg(item->text()));
            item->setToolTip("<p>" + QString::fromStdString(reason).toHtmlEscaped() + "</p>");
            continue;
        }
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(Qt::Unchecked);
    }
    list_->setAccessibleName(tr("Fabrics"));
    note_->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(list_);
    layout->addWidget(note_);
    layout->addWidget(buttons_);
    resize(360, 460);
    connect(list_, &QListWidget::itemChanged, this, &ClothChoice::refresh);
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    refresh();
}

std::vector<LessonCloth> ClothChoice::chosen() const
{
    std::vector<LessonCloth> cloths;
    for (int row = 0; row < list_->count(); ++row) {
        if (list_->item(row)->checkState() == Qt::Checked) { cloths.push_back(offered_[static_cast<std::size_t>(row)]); }
    }
    return cloths;
}

void ClothChoice::refresh()
{
    const std::size_t count = chosen().size();
    note_->setText(tr("Tick %1 to %2 fabrics (%3 ticked).").arg(fewest_lesson_cloths).arg(most_lesson_cloths).arg(count));
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(count >= fewest_lesson_cloths && count <= most_lesson_cloths);
}

} // namespace hygroloom
