// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs that take a moment, a drop that stands as a cap, and one that takes its time.
#pragma once

#include "core/queue/run_job.h"
#include "tests/support/drop_design.h"

#include <thread>

namespace hygroloom {

inline RunJob quick_job(double duration = 0.01)
{
    Design design = drop_design(35, duration);
    design.experiments[0].closure = Closure::pores;
    RunJob job{std::make_shared<const Design>(std::move(design)), "drop", "cloth"};
    job.how.fidelity = Fidelity::live;
    job.how.threads = 1;
    return job;
}

/// Some 20 s: each of its frames waits.
inline RunJob slow_job()
{
    RunJob job = quick_job(50);
    job.how.frame_interval = 0.05;
    job.beside.frame = [](const std::shared_ptr<const Frame>&) { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
    return job;
}

} // namespace hygroloom
