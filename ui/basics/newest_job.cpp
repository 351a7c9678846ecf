// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/newest_job.h"

#include <new>

namespace hygroloom {

namespace {

std::function<void(const QString&)>& reporter()
{
    static std::function<void(const QString&)> who;
    return who;
}

} // namespace

void NewestJob::Turn::deliver(std::function<void()> delivery) const
{
    QMetaObject::invokeMethod(owner_, std::move(delivery), Qt::QueuedConnection);
}

NewestJob::NewestJob(QObject* parent) : QObject(parent) {}

NewestJob::~NewestJob()
{
    drop();
    if (thread_.joinable()) {
        thread_.request_stop();
        thread_.join();
    }
}

void NewestJob::run(Job job)
{
    {
        std::lock_guard lock(mutex_);
        waiting_ = std::move(job);
        ++generation_;
    }
    if (!thread_.joinable()) {
        thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
    }
    wake_.notify_one();
}

void NewestJob::drop()
{
    std::lock_guard lock(mutex_);
    waiting_ = nullptr;
    ++generation_;
}

bool NewestJob::busy() const
{
    std::lock_guard lock(mutex_);
    return working_ || waiting_;
}

void NewestJob::reportTo(std::function<void(const QString&)> report) { reporter() = std::move(report); }

void NewestJob::report(const QString& why)
{
    const QString sentence = tr("Work in the background ended early: %1").arg(why);
    QMetaObject::invokeMethod(
        this,
        [sentence] {
            if (reporter()) {
                reporter()(sentence);
            } else {
                qWarning("%s", qPrintable(sentence));
            }
        },
        Qt::QueuedConnection);
}

void NewestJob::work(const std::stop_token& stop)
{
    while (true) {
        Job job;
        Turn turn;
        {
            std::unique_lock lock(mutex_);
            working_ = false;
            if (!wake_.wait(lock, stop, [this] { return static_cast<bool>(waiting_); })) { return; }
            job = std::exchange(waiting_, nullptr);
            working_ = true;
            turn.owner_ = this;
            turn.generation_ = &generation_;
            turn.own_ = generation_;
        }
        try {
            job(turn);
        } catch (const std::bad_alloc&) { // this keeps the window and its edits alive
            report(tr("the memory did not suffice"));
        } catch (const std::exception& error) {
            report(QString::fromUtf8(error.what()));
        }
    }
}

} // namespace hygroloom
