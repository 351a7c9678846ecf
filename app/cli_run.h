// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the verbs that run experiments share.
#pragma once

#include "app/cli.h"

#include "core/queue/run_queue.h"

#include <chrono>
#include <functional>
#include <mutex>

namespace hygroloom {

struct RunVerbOptions : ProjectOptions {
    std::string physics;
    std::string backend = "auto";
    int threads = 0;
    std::uint64_t seed = 1;
    bool force = false; ///< begins runs that take more memory than is free
};

/// An Error of act() is the caller's wrong usage. Throws Stop.
template <typename Act> auto as_usage(Act act)
{
    try {
        return act();
    } catch (const Error& error) {
        throw Stop(exit_usage, error.what());
    }
}

/// --physics, and --backend, --threads, --force and --seed for verbs that run.
void add_physics_option(CLI::App& verb, RunVerbOptions& options);
void add_machine_options(CLI::App& verb, RunVerbOptions& options);
/// --force.
void add_force_option(CLI::App& verb, RunVerbOptions& options);
/// smaller: what of a run takes less memory.
MemoryRule memory_rule(const RunVerbOptions& options, const char* smaller = "a smaller sample");

/// The options but for the fidelity. Throws Stop.
RunOptions run_options(const RunVerbOptions& options);
/// Throws Stop.
std::unique_ptr<Backend> open_backend(const RunVerbOptions& options);
/// For runs side by side: see make_backends(). Says where memory holds fewer than were asked for. Throws Stop.
std::shared_ptr<RunPlaces> open_places(const RunVerbOptions& options, int at_once, int scenes, std::size_t bytes_each);
/// "cpu" or "cuda", where they go. Throws Stop.
std::string backend_of(const RunVerbOptions& options);

/// --at-once.
void add_at_once_option(CLI::App& verb, int& at_once);

/// The named fabrics, separated by commas; all for an empty list. A name that stands alone may hold commas. Throws Stop.
std::vector<std::string> chosen_fabrics(const Design& design, const std::vector<std::string>& given);
/// The fabrics' names as names of files, no two alike.
std::vector<std::string> file_stems(const std::vector<std::string>& fabrics);

/// Progress of runs side by side, as a bar on a terminal. Any thread may call it.
class RunBar {
public:
    RunBar(bool quiet, std::size_t runs);
    ~RunBar() { clear(); }
    RunBar(const RunBar&) = delete;
    RunBar& operator=(const RunBar&) = delete;

    void show(std::size_t run, const RunProgress& progress);
    /// What the runs were expected to take together, s; once they take three times as much, a sentence says so.
    void expect(double seconds);
    /// Of a run that has ended, well or not.
    void end(std::size_t run);
    /// A sentence above the bar, which the next show() draws again.
    void say(const std::string& sentence);
    /// The same, but where the user wants no notes.
    void note(const std::string& sentence);
    void clear();

private:
    void say_if_late(double share, double wall);

    const bool quiet_, shown_;
    double expected_ = 0; ///< 0: not known, or it was said that they are late
    std::mutex mutex_;
    std::vector<RunProgress> runs_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(), drawn_;
};

/// That show a run's progress in the bar, which must outlive it. name: of its cloth.
RunCallbacks shown_in(RunBar& bar, std::size_t run, const std::string& name);

/// "a, b" -> "a", "b", without the spaces around; none of an empty text.
std::vector<std::string> words_of(const std::string& list);

/// Makes a folder for results, unless it has no name. Throws Stop.
void make_folder(const std::string& folder);

/// The wall time of each stage; on stderr when stdout is for JSON alone.
void print_profile(const std::vector<StageTime>& stages, double wall, bool json);

} // namespace hygroloom
