// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Takes a session to the CPU when its device fails.
#pragma once

#include "core/run/run_options.h"
#include "core/run/session.h"

#include <chrono>

namespace hygroloom {

struct DeviceError;

/// Keeps what a session has come to, now and then, and goes on from there. Without RunOptions::may_go_on_on_cpu it keeps nothing by itself.
class Failover {
public:
    Failover(Session& session, const RunOptions& options) : session_(session), options_(options) {}

    /// The frame that was kept last; 0: the start.
    long kept_frame() const { return frame_; }
    /// Whether the session's state is to be kept at this frame: every 2 s of wall time, and so that keeping takes 5 % at most.
    bool is_due(long frame) const;
    /// Keeps the state where the memory suffices; else the frame before stays kept.
    void keep(long frame);
    /// Keeps the state. Throws std::bad_alloc.
    void hold(long frame);
    /// Goes on from what is kept with the parts that the plan has on.
    void go_on_with(const ModelPlan& plan);
    /// Goes on from what is kept on the CPU. Throws the error again where that is not allowed, or the CPU has already taken over.
    void go_on_on_cpu(const DeviceError& error);

private:
    static constexpr double least_pause = 2; // s of wall time

    bool may_fail_over() const { return options_.may_go_on_on_cpu && !session_.has_moved() && session_.backend().name() != "cpu"; }

    Session& session_;
    const RunOptions& options_;
    std::unique_lock<std::mutex> turn_; ///< on the CPU
    std::vector<std::byte> state_;
    long frame_ = 0;
    double pause_ = least_pause;
    std::chrono::steady_clock::time_point kept_ = std::chrono::steady_clock::now();
};

} // namespace hygroloom
