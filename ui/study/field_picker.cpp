// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/field_picker.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int field_role = Qt::UserRole;

} // namespace

FieldPicker::FieldPicker(const Design& design, const Study& study, const QStringList& taken, QWidget* parent)
    : QDialog(parent), fields_(studyFields(design)), letters_(new QLineEdit), tree_(new QTreeWidget),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel))
{
    setWindowTitle(tr("Add Factors"));
    letters_->setPlaceholderText(tr("Letters of a name, such as “angle” or “weft twist”"));
    letters_->setClearButtonEnabled(true);
    letters_->setAccessibleName(tr("Find a field"));
    tree_->setAccessibleName(tr("Fields of the project"));
    tree_->setHeaderLabels({tr("Field"), tr("Now"), tr("Unit"), tr("Path")});
    tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    tree_->setUniformRowHeights(true);
    fill(design, study, taken);
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("&Add"));
    auto* about = new QLabel(tr("A study changes these. Hold Ctrl to choose several."));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(about);
    layout->addWidget(letters_);
    layout->addWidget(tree_, 1);
    layout->addWidget(buttons_);
    connect(letters_, &QLineEdit::textChanged, this, &FieldPicker::filter);
    connect(tree_, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item) {
        if (item->parent() && !item->isDisabled()) { accept(); }
    });
    connect(tree_, &QTreeWidget::itemSelectionChanged, this,
            [this] { buttons_->button(QDialogButtonBox::Ok)->setEnabled(!chosen().empty()); });
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(false);
    letters_->setFocus();
    resize(640, 520);
}

void FieldPicker::fill(const Design& design, const Study& study, const QStringList& taken)
{
    QTreeWidgetItem *group = nullptr, *first = nullptr; // of those that can be chosen
    QString name;
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const StudyField field = inReadersUnit(fields_[i]);
        if (!group || name != field.group) {
            name = field.group;
            group = new QTreeWidgetItem(tree_, {field.group});
            group->setFlags(Qt::ItemIsEnabled);
            group->setFirstColumnSpanned(true);
            QFont bold = group->font(0);
            bold.setBold(true);
            group->setFont(0, bold);
        }
        const QString path = QString::fromStdString(field.path);
        auto* item = new QTreeWidgetItem(group, {field.name, field.value ? studyNumber(*field.value) : tr("not set"), field.unit, path});
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        item->setData(0, field_role, static_cast<int>(i));
        const bool is_taken = taken.contains(path);
        const bool is_run = !out_of_reach(study, design, field.path);
        item->setDisabled(is_taken || !is_run);
        if (item->isDisabled()) { item->setToolTip(0, is_taken ? tr("It is a factor already.") : tr("The study does not run this one.")); }
        if (is_run && !first) { first = item; }
    }
    tree_->expandAll();
    if (first) {
        QMetaObject::invokeMethod(
            this, [this, first] { tree_->scrollToItem(first->parent(), QTreeWidget::PositionAtTop); }, Qt::QueuedConnection);
    }
    tree_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    tree_->header()->setStretchLastSection(true);
}

void FieldPicker::setFilter(const QString& letters) { letters_->setText(letters); }

/// Each word must be in the name, the group or the path.
void FieldPicker::filter()
{
    const QStringList words = letters_->text().split(' ', Qt::SkipEmptyParts);
    for (int g = 0; g < tree_->topLevelItemCount(); ++g) {
        QTreeWidgetItem* group = tree_->topLevelItem(g);
        bool any = false;
        for (int i = 0; i < group->childCount(); ++i) {
            QTreeWidgetItem* item = group->child(i);
            const QString all = group->text(0) + ' ' + item->text(0) + ' ' + item->text(3);
            const bool fits =
                std::all_of(words.begin(), words.end(), [&all](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
            item->setHidden(!fits);
            if (!fits) { item->setSelected(false); }
            any = any || fits;
        }
        group->setHidden(!any);
    }
}

QStringList FieldPicker::shownPaths() const
{
    QStringList paths;
    for (int g = 0; g < tree_->topLevelItemCount(); ++g) {
        const QTreeWidgetItem* group = tree_->topLevelItem(g);
        for (int i = 0; i < group->childCount(); ++i) {
            if (!group->child(i)->isHidden()) { paths << group->child(i)->text(3); }
        }
    }
    return paths;
}

void FieldPicker::select(const QStringList& paths)
{
    for (int g = 0; g < tree_->topLevelItemCount(); ++g) {
        QTreeWidgetItem* group = tree_->topLevelItem(g);
        for (int i = 0; i < group->childCount(); ++i) { group->child(i)->setSelected(paths.contains(group->child(i)->text(3))); }
    }
}

std::vector<StudyField> FieldPicker::chosen() const
{
    std::vector<StudyField> fields;
    for (const QTreeWidgetItem* item : tree_->selectedItems()) {
        if (item->parent() && !item->isDisabled()) { fields.push_back(fields_[item->data(0, field_role).toUInt()]); }
    }
    return fields;
}

} // namespace hygroloom
