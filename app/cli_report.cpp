// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/cli_report.h"

#include "app/cli.h"

#include "core/project/atomic_file.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>

namespace hygroloom {
namespace {

bool is_pdf(const std::string& file) { return CLI::detail::to_lower(std::filesystem::path(file).extension().string()) == ".pdf"; }

/// Empty: it is not there.
std::filesystem::path program_of_window()
{
    std::error_code none;
    std::vector<std::filesystem::path> folders{std::filesystem::read_symlink("/proc/self/exe", none).parent_path()};
    const char* path = std::getenv("PATH");
    for (const std::string& folder : CLI::detail::split(path ? path : "", ':'))
        if (!folder.empty()) folders.emplace_back(folder);
    for (const std::filesystem::path& folder : folders)
        if (std::filesystem::path program = folder / "hygroloom";
            std::filesystem::is_regular_file(program, none) && access(program.c_str(), X_OK) == 0)
            return program;
    return {};
}

/// A file that goes when this does.
struct PassedPage {
    std::string name = (std::filesystem::temp_directory_path() / "hygroloom-report-XXXXXX").string();
    int file = mkostemp(name.data(), O_CLOEXEC);
    ~PassedPage()
    {
        if (file >= 0) {
            close(file);
            unlink(name.c_str());
        }
    }
};

/// Whether the program came to a good end.
bool run(const std::filesystem::path& program, const std::string& page, const std::string& file)
{
    std::array<std::string, 4> words{program.string(), "--pdf", page, file};
    std::array<char*, 5> arguments{words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
    pid_t child = 0;
    int status = 0;
    if (posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments.data(), environ) != 0) return false;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return false;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace

void check_report_name(const std::string& file)
{
    if (file.empty()) return;
    if (!is_pdf(file) && written_as({}, file).empty())
        throw Stop(exit_usage, "--report: A report is an .html, .pdf, .txt or .json file; given is \"" + file + "\".");
    if (is_pdf(file) && program_of_window().empty())
        throw Stop(exit_usage,
                   "--report: A .pdf is written by the program hygroloom, which is neither beside this one nor in the path. Give "
                   "an .html file; browsers print it.");
}

void write_report_file(const std::string& file, const ReportPage& page)
{
    if (!is_pdf(file)) return write_file(file, written_as(page, file));
    const PassedPage passed;
    if (passed.file < 0) throw Stop(exit_failed, "The temporary file for the report cannot be made: " + passed.name);
    write_file(passed.name, json_of(page));
    if (!run(program_of_window(), passed.name, file)) throw Stop(exit_failed, file + ": The report could not be written as PDF.");
}

} // namespace hygroloom
