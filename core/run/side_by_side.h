// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs that go on at the same time, each on a backend of its own.
#pragma once

#include "core/run/runner.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace hygroloom {

/// The memory (bytes) that the largest of the runs takes, by its plan; of the textiles of the experiment: see textile_of_run().
std::size_t bytes_of_largest(const Design& design, const Experiment& experiment, const std::vector<Textile>& textiles,
                             const RunOptions& how);

/// Calls run(i, backend) for each i below count, in one thread per backend, which takes the next until none is left or all is cancelled.
/// run() returns whether its device has failed; that thread then ends unless it is the last. What run() throws cancels the others and is
/// thrown here once they have ended, but for Cancelled.
void run_side_by_side(const std::vector<std::unique_ptr<Backend>>& backends, std::size_t count, RunControl& control,
                      const std::function<bool(std::size_t, Backend&)>& run);

} // namespace hygroloom
