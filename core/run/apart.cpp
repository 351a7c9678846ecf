// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The process writes lines to a pipe: "p share" as it goes, then one of "o text", "c", "d sentence" (a device failed) and "e sentence".
#include "core/run/apart.h"

#include "core/base/error.h"
#include "core/base/utf8.h"

#include <fmt/format.h>

#include <csignal>
#include <new>

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace hygroloom {
namespace {

void write_line(int pipe, const std::string& line)
{
    const std::string text = line + "\n";
    for (std::size_t at = 0; at < text.size();) {
        const ssize_t written = write(pipe, text.data() + at, text.size() - at);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return; // nobody reads any more
        at += static_cast<std::size_t>(written);
    }
}

/// All that the new process does.
void work_and_write(const std::string& name, const ApartWork& work, int pipe)
{
    try {
        write_line(pipe, "o " + work([pipe](double share) { write_line(pipe, fmt::format("p {:.4f}", share)); }));
    } catch (const Cancelled&) {
        write_line(pipe, "c ");
    } catch (const DeviceError& error) {
        write_line(pipe, "d " + in_one_line(error.what()));
    } catch (const std::bad_alloc&) {
        write_line(pipe, in_one_line(fmt::format("e The memory does not suffice for {}.", name)));
    } catch (const std::exception& error) {
        write_line(pipe, "e " + in_one_line(error.what()));
    }
}

/// Reads lines until the other end closes, and passes a cancellation on. Returns the last line that is not progress.
std::string last_line_of(pid_t process, int pipe, const std::atomic<bool>& cancel, const std::function<void(double)>& progress)
{
    std::string text, last;
    bool terminated = false;
    char buffer[65536];
    while (true) {
        if (cancel && !terminated) {
            terminated = true;
            kill(process, SIGTERM);
        }
        pollfd waiting{pipe, POLLIN, 0};
        if (poll(&waiting, 1, 100) <= 0) continue;
        const ssize_t count = read(pipe, buffer, sizeof buffer);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return last;
        text.append(buffer, static_cast<std::size_t>(count));
        for (std::size_t end; (end = text.find('\n')) != std::string::npos; text.erase(0, end + 1)) {
            const std::string line = text.substr(0, end);
            if (line.starts_with("p "))
                progress(std::strtod(line.c_str() + 2, nullptr));
            else
                last = line;
        }
    }
}

} // namespace

ApartResult run_apart(const std::string& name, const ApartWork& work, const std::atomic<bool>& cancel,
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
        work_and_write(name, work, ends[1]);
        _exit(0);
    }
    close(ends[1]);
    const std::string line = last_line_of(process, ends[0], cancel, progress);
    close(ends[0]);
    int status = 0;
    rusage used{};
    while (wait4(process, &status, 0, &used) < 0 && errno == EINTR) {}
    if (cancel || line.starts_with("c ")) throw Cancelled();
    if (line.starts_with("d ")) throw DeviceError(line.substr(2));
    if (line.starts_with("e ")) throw Error(line.substr(2));
    if (!line.starts_with("o "))
        throw Error(fmt::format("The run of {} was ended{}; the memory may not suffice.", name,
                                WIFSIGNALED(status) ? fmt::format(" by signal {}", WTERMSIG(status)) : ""));
    return {line.substr(2), 1024.0 * static_cast<double>(used.ru_maxrss)}; // kB on Linux
}

} // namespace hygroloom
