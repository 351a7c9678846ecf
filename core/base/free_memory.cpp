// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Linux tells it in files: proc(5), cgroups(7), Documentation/admin-guide/cgroup-v2.rst and cgroup-v1/memory.rst of the kernel.
#include "core/base/free_memory.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>

namespace hygroloom {
namespace {

namespace fs = std::filesystem;

/// Of a file that is one number; none where it says "max" or is not there.
std::optional<double> number_in(const fs::path& file)
{
    std::ifstream in(file);
    double number = 0;
    return in >> number ? std::optional(number) : std::nullopt;
}

/// The number behind a word at the beginning of a line.
std::optional<double> number_after(const fs::path& file, const std::string& word)
{
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with(word)) continue;
        std::istringstream rest(line.substr(word.size()));
        double number = 0;
        if (rest >> number) return number;
    }
    return std::nullopt;
}

void take_less(FreeMemory& free, double bytes, const char* bound)
{
    if (bytes < free.bytes) free = {std::max(0.0, bytes), bound};
}

/// How the two versions of control groups name the same.
struct GroupFiles {
    const char *limit, *usage, *inactive_file, *active_file;
};
constexpr GroupFiles second{"memory.max", "memory.current", "inactive_file ", "active_file "};
constexpr GroupFiles first{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file ", "total_active_file "};

/// From a group up to the top of its tree, which in a container is not where the path of the group begins.
void look_at_groups(FreeMemory& free, const fs::path& top, const std::string& path, const GroupFiles& files)
{
    for (fs::path group = fs::path(path).lexically_normal().relative_path();; group = group.parent_path()) {
        const fs::path folder = top / group;
        const auto limit = number_in(folder / files.limit), usage = number_in(folder / files.usage);
        if (limit && usage) {
            const double of_files = number_after(folder / "memory.stat", files.inactive_file).value_or(0) +
                                    number_after(folder / "memory.stat", files.active_file).value_or(0);
            take_less(free, *limit - std::max(0.0, *usage - of_files), "under the limit of its control group");
        }
        if (group.empty()) return;
    }
}

/// Lines are "0::/path" of version 2, and "4:memory:/path" of version 1.
void look_at_groups(FreeMemory& free, const fs::path& root)
{
    std::ifstream in(root / "proc/self/cgroup");
    const fs::path mounted = root / "sys/fs/cgroup";
    for (std::string line; std::getline(in, line);) {
        const std::size_t kind = line.find(':'), path = kind == std::string::npos ? kind : line.find(':', kind + 1);
        if (path == std::string::npos) continue;
        const std::string kinds = "," + line.substr(kind + 1, path - kind - 1) + ",";
        if (kinds == ",,") look_at_groups(free, mounted, line.substr(path + 1), second);
        if (kinds.find(",memory,") != std::string::npos) look_at_groups(free, mounted / "memory", line.substr(path + 1), first);
    }
}

} // namespace

FreeMemory free_memory(const fs::path& root)
{
    constexpr double kilo = 1024; // what these files call kB
    FreeMemory free;
    if (const auto available = number_after(root / "proc/meminfo", "MemAvailable:")) take_less(free, kilo * *available, "on this machine");
    look_at_groups(free, root);
    const fs::path limits = root / "proc/self/limits", status = root / "proc/self/status";
    const auto beside = [&](const char* limit, const char* taken, const char* bound) {
        const auto most = number_after(limits, limit);
        if (most) take_less(free, *most - kilo * number_after(status, taken).value_or(0), bound);
    };
    beside("Max address space", "VmSize:", "under this process's limit of address space");
    beside("Max data size", "VmData:", "under this process's limit of data");
    return free;
}

std::string ask_for_memory(const std::string& what, double bytes, const MemoryRule& rule, const FreeMemory& free)
{
    if (rule.force || bytes < much_of_memory * free.bytes) return {};
    const std::string numbers =
        what + " takes about " + bytes_text(bytes) + " of memory; " + bytes_text(free.bytes) + " are free " + free.bound + ".";
    if (bytes <= free.bytes) return numbers + " Other programs may slow down.";
    throw NotEnoughMemory(numbers + " " + rule.else_do, bytes, free.bytes);
}

int jobs_that_fit(int wanted, double bytes_each, const FreeMemory& free)
{
    const double fit = much_of_memory * free.bytes / std::max(1.0, bytes_each);
    return static_cast<int>(std::max(1.0, std::min(std::floor(fit), static_cast<double>(wanted))));
}

} // namespace hygroloom
