// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs that share a device's memory wait here until theirs fits beside those that are on.
#pragma once

#include "core/base/error.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

namespace hygroloom {

class MemoryGate {
public:
    /// room: bytes that all runs together may take; asked when none is on.
    explicit MemoryGate(std::function<double()> room) : room_(std::move(room)) {}

    /// A run's share of the memory, given back at its end. The gate must outlive it.
    class Pass {
    public:
        /// Waits until so many bytes fit beside those of the runs that are on; what would never fit goes alone. Throws Cancelled.
        Pass(MemoryGate& gate, double bytes, const std::atomic<bool>& cancel) : gate_(gate), bytes_(bytes) { gate_.enter(bytes, cancel); }
        Pass(const Pass&) = delete;
        Pass& operator=(const Pass&) = delete;
        ~Pass() { gate_.leave(bytes_); }

    private:
        MemoryGate& gate_;
        double bytes_;
    };

private:
    void enter(double bytes, const std::atomic<bool>& cancel)
    {
        std::unique_lock lock(mutex_);
        while (inside_ > 0 && taken_ + bytes > all_) {
            if (cancel) throw Cancelled();
            changed_.wait_for(lock, std::chrono::milliseconds(50)); // a cancel wakes nobody
        }
        if (inside_ == 0) all_ = room_();
        ++inside_;
        taken_ += bytes;
    }
    void leave(double bytes)
    {
        {
            const std::lock_guard lock(mutex_);
            --inside_;
            taken_ = inside_ == 0 ? 0 : taken_ - bytes;
        }
        changed_.notify_all();
    }

    std::function<double()> room_;
    std::mutex mutex_;
    std::condition_variable changed_;
    int inside_ = 0;
    double all_ = 0, taken_ = 0; ///< bytes
};

} // namespace hygroloom
