// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/cli_run.h"

#include "core/base/text.h"
#include "gpu/backends.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <set>

namespace hygroloom {

RunBar::RunBar(bool quiet, std::size_t runs) : quiet_(quiet), shown_(!quiet && isatty(STDERR_FILENO)), runs_(runs) {}

void RunBar::expect(double seconds)
{
    const std::lock_guard lock(mutex_);
    expected_ = seconds;
}

void RunBar::say_if_late(double share, double wall)
{
    constexpr double least = 2; // s, below which nobody waits
    if (expected_ <= 0 || wall < std::max(least, 3 * expected_)) return;
    if (shown_) draw_line("");
    const std::optional<double> to_go = time_left(share, wall);
    print_note("This takes longer than the {} s that were expected{}.\n", rounded_text(expected_, 2),
               to_go ? fmt::format("; by its progress, about {} s in all", rounded_text(wall + *to_go, 2)) : "");
    expected_ = 0;
}

void RunBar::show(std::size_t run, const RunProgress& progress)
{
    if (quiet_) return;
    const std::lock_guard lock(mutex_);
    runs_[run] = progress;
    const auto now = std::chrono::steady_clock::now();
    if (now - drawn_ < std::chrono::milliseconds(90)) return;
    drawn_ = now;

    double share = 0;
    std::size_t done = 0;
    long particles = 0;
    for (const RunProgress& p : runs_) {
        share += p.duration > 0 ? p.simulated / p.duration / static_cast<double>(runs_.size()) : 0;
        done += p.duration > 0 && p.simulated >= p.duration ? 1 : 0;
        particles += p.particles;
    }
    constexpr int width = 30;
    const int full = static_cast<int>(share * width);
    const double wall = std::chrono::duration<double>(now - start_).count();
    say_if_late(share, wall);
    if (!shown_) return;
    const std::optional<double> to_go = time_left(share, wall);
    const std::string left = to_go ? fmt::format(", about {:.0f} s left", *to_go) : std::string();
    const int decimals = decimals_of_moments(progress.duration);
    const std::string far = runs_.size() == 1
                                ? fmt::format("{:.{}f} of {:.{}f} s", progress.simulated, decimals, progress.duration, decimals)
                                : fmt::format("{} of {} runs", done, runs_.size());
    draw_line(fmt::format("[{}{}] {}, {:.0f} s{}, {} particles", std::string(static_cast<std::size_t>(full), '#'),
                          std::string(static_cast<std::size_t>(width - full), '.'), far, wall, left, particles));
}

void RunBar::end(std::size_t run)
{
    const std::lock_guard lock(mutex_);
    runs_[run].simulated = runs_[run].duration = 1;
    runs_[run].particles = 0;
}

void RunBar::say(const std::string& sentence)
{
    clear();
    const std::lock_guard lock(mutex_);
    print_note("{}\n", sentence);
}

void RunBar::note(const std::string& sentence)
{
    if (!quiet_) say(sentence);
}

void RunBar::clear()
{
    if (!shown_) return;
    const std::lock_guard lock(mutex_);
    draw_line("");
}

void add_physics_option(CLI::App& verb, RunVerbOptions& options)
{
    verb.add_option("--physics", options.physics, "Switch parts of the physics on or off, e.g. heat=off,vapour=on");
}

void add_machine_options(CLI::App& verb, RunVerbOptions& options)
{
    verb.add_option("--backend", options.backend, "Backend: auto, cpu or cuda")->check(CLI::IsMember({"auto", "cpu", "cuda"}));
    verb.add_option("--threads", options.threads, "CPU threads; 0: all. Results do not depend on it")->check(CLI::Range(0, 1024));
    verb.add_option("--seed", options.seed,
                    "Seed of random numbers: the unevenness of yarns, the places of the particles in a falling drop")
        ->check(seed_validator());
    add_force_option(verb, options);
}

void add_force_option(CLI::App& verb, RunVerbOptions& options)
{
    verb.add_flag("--force", options.force, "Start even if the run is expected to need more memory than is free");
}

MemoryRule memory_rule(const RunVerbOptions& options, const char* smaller)
{
    return {options.force, fmt::format("Take {} or a lower fidelity, or begin all the same with --force.", smaller)};
}

RunOptions run_options(const RunVerbOptions& options)
{
    RunOptions run;
    run.forced = as_usage([&] { return parse_forced_parts(options.physics); });
    run.knobs = knob_settings(options);
    run.seed = options.seed;
    run.threads = options.threads;
    run.memory = memory_rule(options);
    return run;
}

std::string backend_of(const RunVerbOptions& options)
{
    return as_usage([&] { return backend_for(options.backend, knob_settings(options)); });
}

namespace {

std::vector<std::unique_ptr<Backend>> open_backends(const RunVerbOptions& options, int at_once, int scenes, std::size_t bytes_each)
try {
    return make_backends(backend_of(options), at_once, scenes, bytes_each);
} catch (const DeviceError& error) {
    throw Stop(exit_no_device, std::string(error.what()) + " Use --backend cpu.");
}

} // namespace

std::unique_ptr<Backend> open_backend(const RunVerbOptions& options) { return std::move(open_backends(options, 1, 1, 0).front()); }

std::shared_ptr<RunPlaces> open_places(const RunVerbOptions& options, int at_once, int scenes, std::size_t bytes_each)
{
    auto places = std::make_shared<RunPlaces>(open_backends(options, at_once, scenes, bytes_each));
    const auto asked = static_cast<std::size_t>(std::min(at_once, scenes));
    if (!options.quiet && at_once > 0 && places->at_once() < asked)
        print_note("{} of the {} runs asked for go on at the same time: each takes about {} of memory.\n", places->at_once(), asked,
                   bytes_text(static_cast<double>(bytes_each)));
    return places;
}

RunCallbacks shown_in(RunBar& bar, std::size_t run, const std::string& name)
{
    RunCallbacks beside;
    beside.progress = [&bar, run](const RunProgress& progress) { bar.show(run, progress); };
    beside.memory_is_short = [&bar](const std::string& sentence) { bar.note(sentence); };
    beside.device_failed = [&bar, name](const std::string& sentence) { bar.say(name + ": " + sentence); };
    return beside;
}

void add_at_once_option(CLI::App& verb, int& at_once)
{
    verb.add_option("--at-once", at_once,
                    "Fabrics that run at the same time; 0: one on a CPU, up to 16 on each GPU. Results do not depend on it")
        ->check(CLI::Range(0, 1024));
}

std::vector<std::string> chosen_fabrics(const Design& design, const std::vector<std::string>& given)
{
    std::vector<std::string> names;
    for (const std::string& one : given) {
        const std::vector<std::string> words = find_fabric(design, one) ? std::vector{one} : words_of(one);
        names.insert(names.end(), words.begin(), words.end());
    }
    if (given.empty())
        for (const Fabric& fabric : design.fabrics) names.push_back(fabric.name);
    std::set<std::string> seen;
    for (const std::string& name : names) {
        if (name.empty()) throw Stop(exit_usage, "--fabrics: One of the names is empty.");
        ProjectOptions one;
        one.fabric = name;
        chosen_fabric(design, one); // throws with the names there are
        if (!seen.insert(name).second) throw Stop(exit_usage, fmt::format("--fabrics: \"{}\" is named twice.", name));
    }
    return names;
}

std::vector<std::string> file_stems(const std::vector<std::string>& fabrics)
{
    std::vector<std::string> stems;
    for (const std::string& fabric : fabrics) {
        std::string stem;
        for (const char c : fabric) stem += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '-';
        const std::string plain = stem;
        for (int k = 2; std::find(stems.begin(), stems.end(), stem) != stems.end(); ++k) stem = fmt::format("{}-{}", plain, k);
        stems.push_back(stem);
    }
    return stems;
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
        throw Stop(exit_usage, folder + ": The folder cannot be created. Check that its parent exists and that you may write to it.");
}

void print_profile(const std::vector<StageTime>& stages, double wall, bool json)
{
    const auto print = [json](const std::string& text) { json ? write_note(text) : write_result(text); };
    if (stages.empty()) {
        print("This backend does not measure the time of its stages.\n");
        return;
    }
    double rest = wall;
    print(fmt::format("{:<28} {:>10} {:>10} {:>7}\n", "stage", "calls", "s", "%"));
    for (const StageTime& stage : stages) {
        rest -= stage.seconds;
        print(fmt::format("{:<28} {:>10} {:>10.4f} {:>7.2f}\n", stage.name, stage.calls, stage.seconds, 100 * stage.seconds / wall));
    }
    print(fmt::format("{:<28} {:>10} {:>10.4f} {:>7.2f}\n", "outside the stages", "", rest, 100 * rest / wall));
}

} // namespace hygroloom
