// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/command_palette.h"

#include <QAction>
#include <QCoreApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPointer>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

class AllWords : public QSortFilterProxyModel {
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;
    void setWords(const QString& words)
    {
        words_ = words.split(' ', Qt::SkipEmptyParts);
        invalidateFilter();
    }

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override
    {
        const QString name = sourceModel()->index(row, 0, parent).data().toString();
        return std::all_of(words_.begin(), words_.end(), [&](const QString& word) { return name.contains(word, Qt::CaseInsensitive); });
    }

private:
    QStringList words_;
};

/// As it is read: without the marks of the keys.
QString readText(QString text)
{
    const QString meant(QChar(1)); // "&&"
    return text.replace("&&", meant).remove('&').replace(meant, "&");
}

/// All that is in a menu and in its menus, with the way there.
void addCommands(const QList<QAction*>& actions, const QString& way, QStandardItemModel& commands)
{
    for (QAction* action : actions) {
        const QStringList text = readText(action->text()).split('\t');
        if (action->isSeparator() || !action->isVisible() || text.first().isEmpty()) { continue; }
        if (action->menu()) {
            addCommands(action->menu()->actions(), way + text.first() + QStringLiteral(" ▸ "), commands);
            continue;
        }
        auto* name = new QStandardItem(way + text.first() + (action->isChecked() ? QStringLiteral(" ✓") : QString()));
        auto* keys = new QStandardItem(text.size() > 1 ? text.last() : action->shortcut().toString(QKeySequence::NativeText));
        name->setData(QVariant::fromValue(QPointer<QAction>(action)), Qt::UserRole); // menus change while this is open
        name->setToolTip(action->statusTip());
        for (QStandardItem* item : {name, keys}) {
            item->setEnabled(action->isEnabled());
            item->setEditable(false);
        }
        keys->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        commands.appendRow({name, keys});
    }
}

/// Commands that read the same say what they do, too; those that still do are numbered.
void tellApart(QStandardItemModel& commands)
{
    const auto alike = [&commands](const QString& text) { return commands.findItems(text); };
    for (int row = 0; row < commands.rowCount(); ++row) {
        const QString text = commands.item(row)->text();
        const QList<QStandardItem*> same = alike(text);
        if (same.size() < 2) { continue; }
        for (QStandardItem* item : same) {
            if (!item->toolTip().isEmpty()) { item->setText(CommandPalette::tr("%1: %2").arg(text, item->toolTip())); }
        }
        int number = 0;
        const QList<QStandardItem*> still = alike(commands.item(row)->text());
        for (QStandardItem* item : still) {
            if (still.size() > 1) { item->setText(CommandPalette::tr("%1 (%2)").arg(item->text()).arg(++number)); }
        }
    }
}

} // namespace

CommandPalette::CommandPalette(const QMenuBar& menus, QWidget* parent)
    : QDialog(parent), words_(new QLineEdit), list_(new QTreeView), found_(new AllWords(this)), none_(new QLabel(tr("No command matches.")))
{
    setWindowTitle(tr("Find Command"));
    auto* commands = new QStandardItemModel(this);
    addCommands(menus.actions(), {}, *commands);
    tellApart(*commands);
    found_->setSourceModel(commands);
    list_->setModel(found_);
    list_->setAccessibleName(tr("Commands"));
    list_->setRootIsDecorated(false);
    list_->setHeaderHidden(true);
    list_->setTextElideMode(Qt::ElideMiddle); // the menu and the command stay
    list_->setUniformRowHeights(true);
    list_->setAllColumnsShowFocus(true);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    none_->setAlignment(Qt::AlignCenter);
    none_->setForegroundRole(QPalette::PlaceholderText);
    words_->setAccessibleName(tr("Words of the command"));
    words_->setPlaceholderText(tr("Type letters of a command"));
    words_->setClearButtonEnabled(true);
    words_->installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(8);
    layout->addWidget(words_);
    layout->addWidget(list_);
    layout->addWidget(none_, 1);
    resize(640, 400);
    connect(words_, &QLineEdit::textChanged, this, &CommandPalette::filter);
    const auto take = [this] {
        if (chosen()) { accept(); }
    };
    connect(words_, &QLineEdit::returnPressed, this, take);
    connect(list_, &QTreeView::activated, this, take);
    connect(list_, &QTreeView::clicked, this, take);
    filter({});
}

void CommandPalette::search(const QString& words) { words_->setText(words); }

void CommandPalette::filter(const QString& words)
{
    static_cast<AllWords*>(found_)->setWords(words);
    // The first that can be done.
    QModelIndex first = found_->index(0, 0);
    while (first.isValid() && !(first.flags() & Qt::ItemIsEnabled)) { first = first.siblingAtRow(first.row() + 1); }
    list_->setCurrentIndex(first);
    list_->setVisible(shown() > 0);
    none_->setVisible(shown() == 0);
}

int CommandPalette::shown() const { return found_->rowCount(); }

QAction* CommandPalette::chosen() const
{
    const QModelIndex index = list_->currentIndex().siblingAtColumn(0);
    return index.flags() & Qt::ItemIsEnabled ? index.data(Qt::UserRole).value<QPointer<QAction>>().data() : nullptr;
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == words_ && event->type() == QEvent::KeyPress) {
        // One types and goes up and down without leaving the field.
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown) {
            QCoreApplication::sendEvent(list_, event);
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

} // namespace hygroloom
