// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Processors for the runs of a queue.
#pragma once

#include "core/queue/run_places.h"

namespace hygroloom {

inline std::shared_ptr<RunPlaces> cpu_places(int count = 1)
{
    std::vector<std::unique_ptr<Backend>> backends;
    while (static_cast<int>(backends.size()) < count) backends.push_back(make_cpu_backend());
    return std::make_shared<RunPlaces>(std::move(backends));
}

} // namespace hygroloom
