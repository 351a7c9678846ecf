// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The process of a run tells its progress and its outcome in lines through a pipe: "p share", then "o outcome", or "e code sentence".
#include "app/run_apart.h"

#include "app/cli.h"
#include "app/cli_interrupt.h"

#include "gpu/backends.h"

#include <fmt/format.h>

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace hygroloom {
namespace {

void tell(int pipe, const std::string& line)
{
    const std::string text = line + "\n";
    for (std::size_t at = 0; at < text.size();) {
        const ssize_t written = write(pipe, text.data() + at, text.size() - at);
        if (written <= 0) return; // whoever asked is gone
        at += static_cast<std::size_t>(written);
    }
}

TradeoffOutcome run_here(const ApartRun& run, const TradeoffVariant& variant, RunControl& control, int pipe)
{
    RunOptions options = run.options;
    options.fidelity = variant.fidelity;
    options.knobs = variant.settings;
    const std::unique_ptr<Backend> backend = make_backend(backend_for(run.backend, variant.settings));
    if (backend->name() == "cpu") backend->time_stages(); // on a GPU it would keep stages from running on without the host
    OutcomeCollector collector;
    RunCallbacks callbacks;
    callbacks.started = [&](const RunRecord& record) { collector.start(record); };
    callbacks.frame = [&](const std::shared_ptr<const Frame>& frame) { collector.add(*frame); };
    callbacks.progress = [&](const RunProgress& p) {
        tell(pipe, fmt::format("p {:.4f}", p.duration > 0 ? p.simulated / p.duration : 1.0));
    };
    const RunRecord record = run_experiment(run.design, run.fabric, run.experiment, options, *backend, control, callbacks);
    TradeoffOutcome outcome = collector.outcome(record);
    outcome.liquid_steps = backend->liquid_steps();
    outcome.stages = backend->stage_times();
    return outcome;
}

/// All that the new process does.
void run_and_tell(const ApartRun& run, const TradeoffVariant& variant, int pipe)
{
    RunControl control;
    const InterruptCancels cancels(control.cancel);
    try {
        tell(pipe, "o " + outcome_json(run_here(run, variant, control, pipe)));
    } catch (const Cancelled&) {
        tell(pipe, fmt::format("e {} Cancelled.", int(exit_cancelled)));
    } catch (const DeviceError& error) {
        tell(pipe, fmt::format("e {} {} Use --backend cpu.", int(exit_no_device), error.what()));
    } catch (const std::bad_alloc&) {
        tell(pipe, fmt::format("e {} The memory does not suffice for {}.", int(exit_failed), variant.name));
    } catch (const std::exception& error) {
        tell(pipe, fmt::format("e {} {}", int(exit_failed), error.what()));
    }
}

/// Reads lines until the other end closes, and passes a wish to stop on.
std::string last_word_of(pid_t process, int pipe, const std::atomic<bool>& cancel, const std::function<void(double)>& progress)
{
    std::string text, word;
    bool asked_to_stop = false;
    char buffer[65536];
    while (true) {
        if (cancel && !asked_to_stop) {
            asked_to_stop = true;
            kill(process, SIGTERM);
        }
        pollfd waiting{pipe, POLLIN, 0};
        if (poll(&waiting, 1, 100) <= 0) continue;
        const ssize_t count = read(pipe, buffer, sizeof buffer);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return word;
        text.append(buffer, static_cast<std::size_t>(count));
        for (std::size_t end; (end = text.find('\n')) != std::string::npos; text.erase(0, end + 1)) {
            const std::string line = text.substr(0, end);
            if (line.starts_with("p "))
                progress(std::strtod(line.c_str() + 2, nullptr));
            else
                word = line;
        }
    }
}

} // namespace

TradeoffOutcome run_apart(const ApartRun& run, const TradeoffVariant& variant, const std::atomic<bool>& cancel,
                          const std::function<void(double)>& progress)
{
    if (cancel) throw Cancelled();
    std::fflush(nullptr);
    int ends[2];
    if (pipe(ends) != 0) throw Error("A run of its own cannot be started: no pipe.");
    const pid_t process = fork();
    if (process < 0) throw Error("A run of its own cannot be started: no process.");
    if (process == 0) {
        close(ends[0]);
        run_and_tell(run, variant, ends[1]);
        _exit(0);
    }
    close(ends[1]);
    const std::string word = last_word_of(process, ends[0], cancel, progress);
    close(ends[0]);
    int status = 0;
    rusage used{};
    while (wait4(process, &status, 0, &used) < 0 && errno == EINTR) {}
    if (cancel) throw Cancelled();
    if (word.starts_with("e ")) {
        char* sentence = nullptr;
        const auto code = static_cast<ExitCode>(std::strtol(word.c_str() + 2, &sentence, 10));
        if (code == exit_cancelled) throw Cancelled();
        throw Stop(code, sentence + 1);
    }
    if (!word.starts_with("o "))
        throw Error(fmt::format("The run of {} was ended{}; the memory may not suffice.", variant.name,
                                WIFSIGNALED(status) ? fmt::format(" by signal {}", WTERMSIG(status)) : ""));
    TradeoffOutcome outcome = outcome_from_json(word.substr(2));
    outcome.peak_bytes = 1024.0 * static_cast<double>(used.ru_maxrss); // kB on Linux
    return outcome;
}

} // namespace hygroloom
