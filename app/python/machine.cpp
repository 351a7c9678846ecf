// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/python/machine.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "gpu/backends.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <numeric>

namespace hygroloom::python {

RunArguments run_arguments(const py::dict& given)
{
    RunArguments arguments;
    const auto take = [&](const char* key, auto& value) {
        if (given.contains(key)) value = py::cast<std::decay_t<decltype(value)>>(given[key]);
    };
    take("fidelity", arguments.fidelity);
    take("backend", arguments.backend);
    take("physics", arguments.physics);
    take("recording", arguments.recording);
    take("knobs", arguments.knobs);
    take("seed", arguments.seed);
    take("threads", arguments.threads);
    take("at_once", arguments.at_once);
    take("force", arguments.force);
    take("cell_mm", arguments.cell_mm);
    take("shown_mm", arguments.shown_mm);
    take("detail", arguments.detail);
    return arguments;
}

MemoryRule memory_rule(const RunArguments& arguments, const char* smaller)
{
    return {arguments.force, fmt::format("Take {} or a lower fidelity, or begin all the same with force=True.", smaller)};
}

RunOptions run_options(const RunArguments& arguments)
{
    RunOptions run;
    run.fidelity = fidelity_from_name(arguments.fidelity);
    run.forced = parse_forced_parts(arguments.physics);
    for (const auto& [name, value] : arguments.knobs) set_knob(run.knobs, name, value);
    run.seed = arguments.seed;
    run.threads = arguments.threads;
    run.may_go_on_on_cpu = true;
    run.recording = arguments.recording;
    run.memory = memory_rule(arguments);
    return run;
}

RunOptions garment_options(const RunArguments& arguments)
{
    RunOptions run = run_options(arguments);
    run.cell_side = metre_from_mm(arguments.cell_mm);
    run.shown_side = metre_from_mm(arguments.shown_mm);
    run.detail = arguments.detail;
    run.memory = memory_rule(arguments, "larger cells");
    return run;
}

namespace {

std::vector<std::unique_ptr<Backend>> open_backends(const RunArguments& arguments, int at_once, int scenes, std::size_t bytes_each)
try {
    return make_backends(backend_for(arguments.backend, run_options(arguments).knobs), at_once, scenes, bytes_each);
} catch (const DeviceError& error) {
    throw DeviceError(std::string(error.what()) + " Use backend=\"cpu\".");
}

} // namespace

std::shared_ptr<RunPlaces> open_places(const RunArguments& arguments, int at_once, int scenes, std::size_t bytes_each)
{
    return std::make_shared<RunPlaces>(open_backends(arguments, at_once, scenes, bytes_each));
}

std::string backend_of(const RunArguments& arguments)
{
    return expected_backend(backend_for(arguments.backend, run_options(arguments).knobs));
}

std::unique_ptr<Backend> open_backend(const RunArguments& arguments)
{
    std::unique_ptr<Backend> backend = std::move(open_backends(arguments, 1, 1, 0).front());
    backend->set_threads(arguments.threads);
    return backend;
}

std::string in_words(const RunProgress& progress)
{
    const int decimals = decimals_of_moments(progress.duration);
    return fmt::format("{:.{}f} of {:.{}f} s", progress.simulated, decimals, progress.duration, decimals);
}

double share_of(const RunProgress& progress) { return progress.duration > 0 ? std::min(1.0, progress.simulated / progress.duration) : 0; }

void ManyRuns::tell(std::size_t run, double share)
{
    const std::lock_guard lock(mutex_);
    shares_[run] = share;
    const auto done = std::count_if(shares_.begin(), shares_.end(), [](double s) { return s >= 1; });
    const double all = std::accumulate(shares_.begin(), shares_.end(), 0.0) / static_cast<double>(shares_.size());
    watch_.tell(all, fmt::format("{} of {} runs", done, shares_.size()));
}

} // namespace hygroloom::python
