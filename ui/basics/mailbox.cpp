// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/mailbox.h"

#include <QElapsedTimer>
#include <QPointer>

#include <utility>

namespace hygroloom {

Mailbox::Mailbox(QObject* parent) : QObject(parent)
{
    next_.setSingleShot(true);
    connect(&next_, &QTimer::timeout, this, &Mailbox::deliver);
}

void Mailbox::post(std::function<void()> work)
{
    const std::lock_guard lock(mutex_);
    works_.push_back(std::move(work));
    if (!std::exchange(awake_, true)) { QMetaObject::invokeMethod(this, &Mailbox::wake, Qt::QueuedConnection); }
}

/// A timer of no time waits for all other events.
void Mailbox::wake() { next_.start(0); }

void Mailbox::deliver()
{
    constexpr qint64 longest = 10; // ms
    const QPointer<Mailbox> still(this);
    QElapsedTimer time;
    time.start();
    do {
        std::function<void()> work;
        {
            const std::lock_guard lock(mutex_);
            if (works_.empty()) {
                awake_ = false;
                next_.stop();
                return;
            }
            work = std::move(works_.front());
            works_.pop_front();
        }
        next_.start(0); // also for an event loop that the work opens, as a question does
        work();
    } while (still && time.elapsed() < longest);
}

} // namespace hygroloom
