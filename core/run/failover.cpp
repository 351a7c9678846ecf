// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/failover.h"

#include "core/base/error.h"
#include "core/run/clock.h"

#include <algorithm>
#include <new>

namespace hygroloom {
bool Failover::is_due(long frame) const { return may_fail_over() && frame > 0 && seconds_since(kept_) >= pause_; }

void Failover::keep(long frame)
{
    const auto start = Clock::now();
    try {
        hold(frame);
    } catch (const std::bad_alloc&) { // the run itself is well
    }
    pause_ = std::max(least_pause, 20 * seconds_since(start));
    kept_ = Clock::now();
}

void Failover::hold(long frame)
{
    state_ = session_.state();
    frame_ = frame;
}

void Failover::go_on_with(const ModelPlan& plan)
{
    session_.go_on_from(state_, plan);
    if (!may_fail_over()) state_ = {};
}

void Failover::go_on_on_cpu(const DeviceError& error)
{
    if (!options_.may_go_on_on_cpu || session_.has_moved()) throw DeviceError(error);
    session_.backend().unload();
    if (options_.one_on_cpu) turn_ = std::unique_lock(*options_.one_on_cpu);
    std::unique_ptr<Backend> cpu = make_cpu_backend();
    cpu->set_threads(options_.threads);
    session_.move_to(std::move(cpu));
    if (frame_ > 0)
        session_.go_on_from(state_);
    else
        session_.load();
}

} // namespace hygroloom
