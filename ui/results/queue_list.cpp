// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/queue_list.h"

#include "ui/basics/appearance.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int id_role = Qt::UserRole;

QString stateOfBatch(const BatchState& batch)
{
    switch (batch.state) {
    case BatchState::State::running: return QueueList::tr("Running");
    case BatchState::State::paused: return QueueList::tr("Paused");
    case BatchState::State::stopping: return QueueList::tr("Stopping");
    case BatchState::State::waiting: break;
    }
    return batch.waits_for == BatchState::WaitsFor::memory ? QueueList::tr("Waits for memory of the device")
                                                           : QueueList::tr("Waits until other runs are done");
}

QString progressOfBatch(const BatchState& batch)
{
    const QString share = QueueList::tr("%1 %").arg(static_cast<int>(100 * batch.share));
    if (batch.count == 1) { return share; }
    QString text = QueueList::tr("%1 of %2 runs, %3").arg(batch.ended).arg(batch.count).arg(share);
    if (batch.failed > 0) { text += QueueList::tr(", %1 failed").arg(batch.failed); }
    return text;
}

/// "Runs: 2 on, 6 waiting, 1 paused"; empty where there are none.
QString queueText(const std::vector<BatchState>& list)
{
    std::size_t on = 0, waiting = 0, paused = 0;
    for (const BatchState& batch : list) {
        on += batch.running;
        const bool waits = batch.state == BatchState::State::waiting || batch.state == BatchState::State::running;
        if (waits) { waiting += batch.count - batch.ended - batch.running; }
        if (batch.state == BatchState::State::paused) { paused += batch.count - batch.ended; }
    }
    QStringList parts;
    if (on > 0) { parts << QueueList::tr("%1 on").arg(on); }
    if (waiting > 0) { parts << QueueList::tr("%1 waiting").arg(waiting); }
    if (paused > 0) { parts << QueueList::tr("%1 paused").arg(paused); }
    return parts.isEmpty() ? QString() : QueueList::tr("Runs: %1").arg(parts.join(", "));
}

} // namespace

QueueList::QueueList(WindowQueue& queue, QWidget* parent)
    : QFrame(parent, Qt::Popup), queue_(queue), tree_(new QTreeWidget), none_(new QLabel(tr("No run is on or waiting."))),
      pause_(new QPushButton(tr("Pause"))), stop_(new QPushButton(themedIcon("stop"), tr("Stop"))),
      earlier_(new QPushButton(tr("Earlier"))), later_(new QPushButton(tr("Later")))
{
    setObjectName("queue list");
    setWindowTitle(tr("Queue of Runs"));
    setAccessibleName(windowTitle());
    setFrameShape(QFrame::StyledPanel);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    tree_->setHeaderLabels({tr("Runs"), tr("State"), tr("Progress")});
    tree_->setRootIsDecorated(false);
    tree_->setUniformRowHeights(true);
    tree_->setAccessibleName(windowTitle());
    tree_->header()->setStretchLastSection(true);
    tree_->setColumnWidth(0, 190);
    tree_->setColumnWidth(1, 200);
    connect(tree_, &QTreeWidget::itemSelectionChanged, this, &QueueList::refreshButtons);
    layout->addWidget(none_);
    layout->addWidget(tree_);
    buildButtons();
    connect(&queue_, &WindowQueue::changed, this, [this] {
        if (isVisible()) { refresh(); }
    });
}

void QueueList::buildButtons()
{
    auto* buttons = new QHBoxLayout;
    const auto add = [&](QPushButton* button, const QKeySequence& key, const QString& tip, const std::function<void()>& act) {
        button->setAutoDefault(false);
        button->setToolTip(tr("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
        connect(button, &QPushButton::clicked, this, act);
        connect(new QShortcut(key, this), &QShortcut::activated, button, &QPushButton::click);
        buttons->addWidget(button);
    };
    add(pause_, Qt::Key_P, tr("Pause the selected runs, or let them go on when it is their turn. Others may take theirs meanwhile."),
        [this] { pause(); });
    add(stop_, Qt::Key_Delete, tr("Stop the selected runs. What has ended is kept."), [this] { queue_.runs().cancel(chosen()); });
    buttons->addStretch();
    add(earlier_, QKeySequence(Qt::ALT | Qt::Key_Up), tr("Let the selected runs take their turn before those above."),
        [this] { shift(-1); });
    add(later_, QKeySequence(Qt::ALT | Qt::Key_Down), tr("Let those below take their turn first."), [this] { shift(1); });
    static_cast<QVBoxLayout*>(layout())->addLayout(buttons);
}

void QueueList::showAt(const QPoint& corner)
{
    constexpr QSize size(560, 220);
    refresh();
    if (chosen() == 0) { tree_->setCurrentItem(tree_->topLevelItem(0)); }
    resize(size);
    move(corner - QPoint(size.width(), size.height()));
    show();
    tree_->setFocus();
}

/// What has the focus alone is not chosen: it goes to another row when a batch ends.
int QueueList::chosen() const
{
    const QList<QTreeWidgetItem*> items = tree_->selectedItems();
    return items.isEmpty() ? 0 : items.front()->data(0, id_role).toInt();
}

void QueueList::refresh()
{
    const int before = chosen();
    shown_ = queue_.list();
    {
        const QSignalBlocker quiet(tree_);
        tree_->clear();
        for (const BatchState& batch : shown_) {
            auto* item = new QTreeWidgetItem(tree_, {QString::fromStdString(batch.name), stateOfBatch(batch), progressOfBatch(batch)});
            item->setData(0, id_role, batch.id);
            item->setToolTip(0, item->text(0));
            if (batch.id == before) { tree_->setCurrentItem(item); }
        }
    }
    none_->setVisible(shown_.empty());
    tree_->setVisible(!shown_.empty());
    for (QPushButton* button : {pause_, stop_, earlier_, later_}) { button->setVisible(!shown_.empty()); }
    refreshButtons();
}

void QueueList::refreshButtons()
{
    const int id = chosen();
    const auto at = std::find_if(shown_.begin(), shown_.end(), [id](const BatchState& batch) { return batch.id == id; });
    const bool any = at != shown_.end() && at->state != BatchState::State::stopping;
    const bool paused = any && at->state == BatchState::State::paused;
    pause_->setText(paused ? tr("Resume") : tr("Pause"));
    pause_->setIcon(themedIcon(paused ? "run" : "pause"));
    pause_->setEnabled(any);
    stop_->setEnabled(any);
    earlier_->setEnabled(any && at != shown_.begin());
    later_->setEnabled(any && std::next(at) != shown_.end());
}

void QueueList::pause()
{
    const int id = chosen();
    for (const BatchState& batch : shown_) {
        if (batch.id == id) { queue_.runs().set_paused(id, batch.state != BatchState::State::paused); }
    }
    refresh();
}

void QueueList::shift(int by)
{
    queue_.runs().move(chosen(), by);
    refresh();
}

QueueButton::QueueButton(WindowQueue& queue, QWidget* parent) : QToolButton(parent), queue_(queue), list_(new QueueList(queue, this))
{
    setAutoRaise(true);
    setIcon(themedIcon("run"));
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setToolTip(tr("Show the runs that are on, waiting or paused; pause, stop or reorder them."));
    connect(this, &QToolButton::clicked, this, &QueueButton::openList);
    connect(&queue_, &WindowQueue::changed, this, &QueueButton::refresh);
    refresh();
}

void QueueButton::refresh()
{
    const QString text = queueText(queue_.list());
    setText(text);
    setAccessibleName(text.isEmpty() ? list_->windowTitle() : text);
    setVisible(!text.isEmpty());
}

/// Above the button, or where it would stand.
void QueueButton::openList()
{
    const QWidget* const place = isVisible() ? this : parentWidget();
    list_->showAt(place->mapToGlobal(QPoint(place->width(), 0)));
}

} // namespace hygroloom
