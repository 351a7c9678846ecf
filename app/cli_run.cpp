// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/cli_run.h"

#include "gpu/backends.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace hygroloom {
namespace {

void draw_progress(const std::string& about, const RunProgress& progress)
{
    constexpr int width = 30;
    const double share = progress.duration > 0 ? progress.simulated / progress.duration : 0;
    const int full = static_cast<int>(share * width);
    const std::string left = share > 0.01 ? fmt::format(", about {:.0f} s left", progress.wall * (1 - share) / share) : std::string();
    fmt::print(stderr, "\r\033[K{}[{}{}] {:.3g} of {:.3g} s, {:.0f} s taken{}, {} particles", about,
               std::string(static_cast<std::size_t>(full), '#'), std::string(static_cast<std::size_t>(width - full), '.'),
               progress.simulated, progress.duration, progress.wall, left, progress.particles);
    std::fflush(stderr);
}

} // namespace

void add_physics_option(CLI::App& verb, RunVerbOptions& options)
{
    verb.add_option("--physics", options.physics, "Force parts on or off, e.g. heat=off,vapour=on");
}

void add_machine_options(CLI::App& verb, RunVerbOptions& options)
{
    verb.add_option("--backend", options.backend, "auto, cpu or cuda")->check(CLI::IsMember({"auto", "cpu", "cuda"}));
    verb.add_option("--threads", options.threads, "CPU threads; 0 takes all. Results do not depend on it")->check(CLI::Range(0, 1024));
    verb.add_option("--seed", options.seed, "Seed of the random numbers");
}

RunOptions run_options(const RunVerbOptions& options)
{
    RunOptions run;
    run.forced = as_usage([&] { return parse_forced_parts(options.physics); });
    run.knobs = knob_settings(options);
    run.seed = options.seed;
    run.threads = options.threads;
    return run;
}

std::unique_ptr<Backend> open_backend(const RunVerbOptions& options)
{
    try {
        return make_backend(options.backend);
    } catch (const DeviceError& error) {
        throw Stop(exit_no_device, std::string(error.what()) + " Use --backend cpu.");
    }
}

FinishedRun run_with_bar(const Design& design, const std::string& fabric, const std::string& experiment, const RunOptions& options,
                         Backend& backend, RunControl& control, bool quiet, const std::string& about,
                         const std::function<void(const std::shared_ptr<const Frame>&)>& see)
{
    const bool bar = !quiet && isatty(STDERR_FILENO);
    MetricsCollector collector;
    RunCallbacks callbacks;
    callbacks.started = [&](const RunRecord& run) { collector.start(run); };
    callbacks.frame = [&](const std::shared_ptr<const Frame>& frame) {
        collector.add(*frame);
        if (see) see(frame);
    };
    if (bar) callbacks.progress = [&](const RunProgress& progress) { draw_progress(about, progress); };
    const auto clear_bar = [&] {
        if (bar) fmt::print(stderr, "\r\033[K");
    };
    try {
        FinishedRun finished;
        finished.run = run_experiment(design, fabric, experiment, options, backend, control, callbacks);
        clear_bar();
        finished.metrics = collector.metrics();
        return finished;
    } catch (const DeviceError& error) {
        clear_bar();
        throw Stop(exit_failed, std::string(error.what()) + " Run again with --backend cpu.");
    } catch (...) {
        clear_bar();
        throw;
    }
}

std::vector<std::string> words_of(const std::string& list)
{
    std::vector<std::string> words;
    for (std::size_t at = 0; at < list.size();) {
        const std::size_t comma = std::min(list.find(',', at), list.size());
        const std::size_t first = std::min(list.find_first_not_of(' ', at), comma);
        const std::size_t last = list.find_last_not_of(' ', comma - (comma > first ? 1 : 0));
        words.push_back(first == comma ? "" : list.substr(first, last + 1 - first));
        at = comma + 1;
    }
    return words;
}

void make_folder(const std::string& folder)
{
    if (folder.empty()) return;
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure || !std::filesystem::is_directory(folder))
        throw Stop(exit_usage, folder + ": This folder cannot be made. Check that its parent exists and can be written to.");
}

} // namespace hygroloom
