// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A run that takes a moment: a drop that stands as a cap.
#pragma once

#include "core/queue/run_job.h"
#include "tests/support/drop_design.h"

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

} // namespace hygroloom
