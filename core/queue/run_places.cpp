// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/queue/run_places.h"

namespace hygroloom {

RunPlaces::RunPlaces(std::vector<std::unique_ptr<Backend>> backends)
    : backends_(std::move(backends)), machine_(backends_.front()->name()), at_once_(backends_.size())
{
    for (auto backend = backends_.rbegin(); backend != backends_.rend(); ++backend) free_.push_back(backend->get());
}

Backend* RunPlaces::take()
{
    ++taken_;
    if (open_) return nullptr;
    Backend* const backend = free_.back();
    free_.pop_back();
    return backend;
}

void RunPlaces::give_back(Backend* backend, bool failed)
{
    --taken_;
    if (!backend) return;
    if (failed && at_once_ > 1)
        --at_once_; // others have a device that works
    else
        free_.push_back(backend);
}

} // namespace hygroloom
