// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Work that other threads hand to that of the window, in their order, between which the window is painted and takes input.
#pragma once

#include <QObject>
#include <QTimer>

#include <deque>
#include <functional>
#include <mutex>

namespace hygroloom {

/// Events that are posted go before painting, however many come: frames that come faster than they are shown would leave menus black.
class Mailbox : public QObject {
    Q_OBJECT
public:
    explicit Mailbox(QObject* parent = nullptr);

    /// From any thread.
    void post(std::function<void()> work);

private:
    void wake();
    void deliver();

    std::mutex mutex_;
    std::deque<std::function<void()>> works_;
    bool awake_ = false; ///< deliver() will be called
    QTimer next_;
};

} // namespace hygroloom
