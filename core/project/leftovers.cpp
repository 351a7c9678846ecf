// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/project/leftovers.h"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <map>
#include <mutex>
#include <unistd.h>
#include <vector>

namespace hygroloom {
namespace {

namespace fs = std::filesystem;

/// Before the process's number.
std::string beginning_for(const fs::path& target) { return fmt::format(".{}.", target.stem().string().substr(0, 100)); }

/// The number of the process that made it; 0: this is no name of a temporary file for the target.
pid_t maker_of(const std::string& name, const fs::path& target)
{
    const std::string begin = beginning_for(target), end = target.extension().string();
    if (name.size() < begin.size() + end.size() || !name.starts_with(begin) || !name.ends_with(end)) return 0;
    const char* const first = name.data() + begin.size();
    const char* const last = name.data() + name.size() - end.size();
    pid_t process = 0;
    unsigned count = 0;
    const auto [dash, no_process] = std::from_chars(first, last, process);
    if (no_process != std::errc() || dash == last || *dash != '-') return 0;
    const auto [rest, no_count] = std::from_chars(dash + 1, last, count);
    return no_count == std::errc() && rest == last && process > 0 ? process : 0;
}

bool is_gone(pid_t process) { return ::kill(process, 0) != 0 && errno == ESRCH; }

bool is_old(const fs::path& file)
{
    std::error_code failure;
    const auto written = fs::last_write_time(file, failure);
    return !failure && fs::file_time_type::clock::now() - written > std::chrono::minutes(1);
}

/// Hidden files of a folder, listed once: exports to ParaView write thousands of files into one.
const std::vector<fs::path>& hidden_files(const fs::path& folder)
{
    static std::map<fs::path, std::vector<fs::path>> listed;
    const auto [place, is_new] = listed.try_emplace(folder);
    std::error_code failure;
    if (is_new)
        for (const auto& entry : fs::directory_iterator(folder.empty() ? fs::path(".") : folder, failure))
            if (entry.path().filename().string().starts_with(".")) place->second.push_back(entry.path());
    return place->second;
}

} // namespace

fs::path temporary_beside(const fs::path& target)
{
    static std::atomic<unsigned> counter{0};
    auto path = target;
    std::error_code ignored;
    do // a process of the same number may have left one: in a container every program may be the first
        path.replace_filename(fmt::format("{}{}-{}{}", beginning_for(target), ::getpid(), counter++, target.extension().string()));
    while (fs::exists(fs::symlink_status(path, ignored)));
    return path;
}

void remove_leftovers(const fs::path& target)
{
    static std::mutex listing;
    const std::scoped_lock alone(listing);
    for (const fs::path& file : hidden_files(target.parent_path())) {
        const pid_t maker = maker_of(file.filename().string(), target);
        std::error_code ignored;
        if (maker > 0 && is_gone(maker) && is_old(file)) fs::remove(file, ignored);
    }
}

} // namespace hygroloom
