// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/cli_print.h"

#include "core/base/utf8.h"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace hygroloom {
namespace {

int failure_of_results = 0; ///< an error number

void write_to(std::FILE* stream, const std::string& text) { std::fwrite(text.data(), 1, text.size(), stream); }

} // namespace

void prepare_streams()
{
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
        if (::fcntl(stream, F_GETFD) >= 0) continue;
        // The lowest free number is the stream's. Results are not to vanish: one that can only be read takes none.
        if (::open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY) != stream) return;
    }
}

void write_note(const std::string& text) { write_to(stderr, printable(text)); }

void write_result(const std::string& text)
{
    if (failure_of_results == 0) {
        errno = 0;
        write_to(stdout, printable(text));
        if (std::ferror(stdout) != 0) failure_of_results = errno != 0 ? errno : EIO;
    }
    if (failure_of_results != 0) throw ResultsLost();
}

void print_json(const nlohmann::ordered_json& json)
{
    print_result("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

void flush_results()
{
    if (failure_of_results == 0 && std::fflush(stdout) != 0) failure_of_results = errno != 0 ? errno : EIO;
}

bool results_are_written()
{
    flush_results();
    if (failure_of_results == 0) return true;
    write_note(fmt::format("The results cannot be written to the standard output: {}.\n", std::strerror(failure_of_results)));
    return false;
}

void draw_line(const std::string& text)
{
    write_to(stderr, "\r\033[K" + printable(text));
    std::fflush(stderr);
}

} // namespace hygroloom
