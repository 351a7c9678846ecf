// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A background thread for work of which only the newest request matters: meshes, maps, plans, frames.
#pragma once

#include <QObject>
#include <QString>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace hygroloom {

/// Runs the newest job offered; one that still waits when a newer comes is dropped, one that runs can see that it is outdated.
/// Deliveries run in the thread of this object, in order, and never after its destruction.
class NewestJob : public QObject {
    Q_OBJECT
public:
    /// What a running job may read and do.
    class Turn {
    public:
        bool outdated() const { return *generation_ != own_; }
        void deliver(std::function<void()> delivery) const;

    private:
        friend class NewestJob;
        NewestJob* owner_ = nullptr;
        const std::atomic<long>* generation_ = nullptr;
        long own_ = 0;
    };
    using Job = std::function<void(const Turn&)>;

    explicit NewestJob(QObject* parent = nullptr);
    ~NewestJob() override;

    void run(Job job);
    /// Drops what waits and outdates what runs.
    void drop();
    bool busy() const;

    /// Who shows what ended a job early: called in the thread of the job's owner, with a sentence. Jobs that know more catch it themselves.
    static void reportTo(std::function<void(const QString&)> report);

private:
    void report(const QString& why);
    void work(const std::stop_token& stop);

    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    Job waiting_;
    bool working_ = false;
    std::atomic<long> generation_{0};
    std::jthread thread_; // last: joined before the rest goes
};

} // namespace hygroloom
