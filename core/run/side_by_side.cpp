// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/side_by_side.h"

#include "core/base/error.h"
#include "core/run/plan_run.h"
#include "core/solver/backend.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace hygroloom {

std::size_t bytes_of_largest(const Design& design, const Experiment& experiment, const std::vector<Textile>& textiles,
                             const RunOptions& how)
{
    double most = 0;
    for (const Textile& textile : textiles) {
        try {
            const ModelPlan plan = plan_run(design, textile, experiment, how.fidelity, how.forced, how.knobs);
            most = std::max(most, plan.expected_bytes);
        } catch (const Error&) {
            // The run reports it.
        }
    }
    return static_cast<std::size_t>(most);
}

void run_side_by_side(const std::vector<std::unique_ptr<Backend>>& backends, std::size_t count, RunControl& control,
                      const std::function<bool(std::size_t, Backend&)>& run)
{
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> working{backends.size()};
    std::mutex mutex;
    std::exception_ptr failure;
    const auto take_turns = [&](Backend& backend) {
        try {
            for (std::size_t i = next++; i < count && !control.cancel; i = next++)
                if (run(i, backend) && --working > 0) break; // others have a device that works
            backend.unload();                                // leaves all of the device to the others
        } catch (const Cancelled&) {
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
            control.cancel = true;
        }
    };
    {
        std::vector<std::jthread> threads;
        threads.reserve(backends.size());
        for (const auto& backend : backends) threads.emplace_back([&take_turns, &backend] { take_turns(*backend); });
    }
    if (failure) std::rethrow_exception(failure);
}

} // namespace hygroloom
