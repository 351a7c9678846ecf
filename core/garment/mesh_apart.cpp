// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Files of strangers whose formats a foreign library reads (FBX, Collada) are read by the program hygroloom-mesh, which limits itself, and
// whose answer is checked.
#include "core/base/error.h"
#include "core/base/shipped_file.h"
#include "core/garment/mesh_bytes.h"
#include "core/garment/mesh_limits.h"
#include "core/garment/readers.h"
#include "core/project/atomic_file.h"

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace hygroloom {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double most_seconds = 60; ///< on a busy machine 20 s of a processor take so long

std::string too_slow(double seconds, const char* of)
{
    return fmt::format("Reading the file takes more than {:g} s{}, which is the most. Export it anew with fewer triangles, as OBJ or GLB.",
                       seconds, of);
}

/// A process that is ended and waited for when it goes out of sight.
class Reader {
public:
    Reader(const std::filesystem::path& program, const std::string& name, const std::string& format, int file);
    ~Reader()
    {
        if (process_ > 0) {
            kill(process_, SIGKILL);
            wait_for(0);
        }
        if (answer_ >= 0) close(answer_);
    }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    int answer() const { return answer_; }
    /// How it ended, when it does within some time; it is ended then.
    int status()
    {
        for (int tries = 0; tries < 200; ++tries) {
            if (wait_for(WNOHANG)) return status_;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        kill(process_, SIGKILL);
        wait_for(0);
        return status_;
    }

private:
    bool wait_for(int options)
    {
        if (process_ <= 0) return true;
        pid_t ended = 0;
        do {
            ended = waitpid(process_, &status_, options);
        } while (ended < 0 && errno == EINTR);
        if (ended == 0) return false;
        if (ended < 0) status_ = 0; // the host takes no notice of its children
        process_ = -1;
        return true;
    }

    pid_t process_ = -1;
    int answer_ = -1, status_ = 0;
};

Reader::Reader(const std::filesystem::path& program, const std::string& name, const std::string& format, int file)
{
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw FileError(fmt::format("{}: No pipe to its reader: {}.", name, std::strerror(errno)));
    answer_ = ends[0];
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, file, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
    posix_spawnattr_t how;
    posix_spawnattr_init(&how);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&how, &none);
    posix_spawnattr_setsigdefault(&how, &all);
    posix_spawnattr_setpgroup(&how, 0); // a terminal's interruption is this process's to pass on
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    std::string words[] = {program.string(), format, name};
    char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
    const int failure = posix_spawn(&process_, program.c_str(), &files, &how, arguments, environ);
    posix_spawnattr_destroy(&how);
    posix_spawn_file_actions_destroy(&files);
    close(ends[1]);
    if (failure == 0) return;
    close(answer_);
    throw FileError(fmt::format("{}: Its reader {} cannot be started: {}.", name, program.string(), std::strerror(failure)));
}

/// All that the reader says. Throws Cancelled, and FileError where it takes too long or says too much.
std::string answer_of(const Reader& reader, const std::string& name, const Asked& cancelled)
{
    const Clock::time_point end = Clock::now() + std::chrono::milliseconds(static_cast<long>(1000 * most_seconds));
    std::string answer;
    std::vector<char> part(1u << 20);
    while (true) {
        if (cancelled && cancelled()) throw Cancelled();
        if (Clock::now() > end) throw FileError(fmt::format("{}: {}", name, too_slow(most_seconds, "")));
        pollfd waiting{reader.answer(), POLLIN, 0};
        if (poll(&waiting, 1, 50) <= 0) continue;
        const ssize_t count = read(reader.answer(), part.data(), part.size());
        if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (count <= 0) return answer;
        answer.append(part.data(), static_cast<std::size_t>(count));
        if (answer.size() > most_answer_bytes) throw FileError(name + ": Its reader says more than the largest mesh has.");
    }
}

} // namespace

FlatMesh mesh_apart(const std::filesystem::path& path, const std::string& format, const Asked& cancelled)
{
    const std::string name = path.string();
    const ReadableFile file(path, largest_mesh_bytes);
    const std::filesystem::path program = shipped_file("hygroloom-mesh");
    if (program.empty())
        throw FileError(name +
                        ": The program hygroloom-mesh, which reads FBX and Collada, is not there: it belongs in the folder lib/hygroloom "
                        "of this installation. Install Hygroloom anew, or export the garment as OBJ or GLB.");
    Reader reader(program, name, format, file.descriptor());
    const std::string answer = answer_of(reader, name, cancelled);
    const int status = reader.status();
    if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL))
        throw FileError(fmt::format("{}: {}", name, too_slow(most_reader_seconds, " of a processor")));
    if (WIFSIGNALED(status))
        throw FileError(
            fmt::format("{}: Its reader broke off (signal {}): the file is damaged, or made to do harm. Export it anew, as OBJ or GLB.",
                        name, WTERMSIG(status)));
    return mesh_from_answer(answer, name);
}

} // namespace hygroloom
