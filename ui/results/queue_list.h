// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The runs of the window that are on or wait: how far each is, why it waits; they can be paused, stopped and put in another order.
#pragma once

#include "ui/results/window_queue.h"

#include <QFrame>
#include <QToolButton>

class QLabel;
class QPushButton;
class QTreeWidget;

namespace hygroloom {

/// A window of its own, which goes when another place is clicked or Escape is pressed.
class QueueList : public QFrame {
    Q_OBJECT
public:
    explicit QueueList(WindowQueue& queue, QWidget* parent = nullptr);

    /// With its lower right corner at a place of the screen.
    void showAt(const QPoint& corner);

private:
    void buildButtons();
    void refresh();
    void refreshButtons();
    int chosen() const;
    void pause();
    void shift(int by);

    WindowQueue& queue_;
    std::vector<BatchState> shown_;
    QTreeWidget* tree_;
    QLabel* none_;
    QPushButton* pause_;
    QPushButton* stop_;
    QPushButton* earlier_;
    QPushButton* later_;
};

/// How many runs are on and wait; it opens the list. Hidden where there are none.
class QueueButton : public QToolButton {
    Q_OBJECT
public:
    explicit QueueButton(WindowQueue& queue, QWidget* parent = nullptr);

    void openList();

private:
    void refresh();

    WindowQueue& queue_;
    QueueList* list_;
};

} // namespace hygroloom
