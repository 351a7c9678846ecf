// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/redo_log.h"

#include <algorithm>
#include <cstring>

namespace hygroloom {
namespace {

constexpr std::string_view mark = "hygroloom redo.."; // 16 bytes
constexpr std::uint64_t longest_log = 64 << 20;       // bytes; a frame changes some kilobytes

void put(std::string& log, std::uint64_t number) { log.append(reinterpret_cast<const char*>(&number), sizeof number); }

std::uint64_t number_at(std::string_view bytes, std::size_t at)
{
    std::uint64_t number = 0;
    std::memcpy(&number, bytes.data() + at, sizeof number);
    return number;
}

/// FNV-1a: tells a log that was cut from a whole one.
std::uint64_t checksum(std::string_view bytes)
{
    std::uint64_t sum = 0xCBF29CE484222325;
    for (const char byte : bytes) sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001B3;
    return sum;
}

} // namespace

void stage(Changes& changes, std::uint64_t at, std::string_view bytes)
{
    if (bytes.empty()) return;
    std::uint64_t begin = at, end = at + bytes.size();
    auto first = changes.lower_bound(at);
    if (first != changes.begin())
        if (const auto before = std::prev(first); before->first + before->second.size() > at) first = before;
    auto last = first;
    for (; last != changes.end() && last->first < end; ++last) begin = std::min(begin, last->first);
    if (last != first) end = std::max(end, std::prev(last)->first + std::prev(last)->second.size());
    std::string merged(end - begin, '\0');
    for (auto entry = first; entry != last; ++entry)
        std::copy(entry->second.begin(), entry->second.end(), merged.begin() + static_cast<std::ptrdiff_t>(entry->first - begin));
    std::copy(bytes.begin(), bytes.end(), merged.begin() + static_cast<std::ptrdiff_t>(at - begin));
    changes.erase(first, last);
    changes.emplace(begin, std::move(merged));
}

bool touches(const Changes& changes, std::uint64_t at, std::size_t count)
{
    const auto after = changes.lower_bound(at + count);
    if (after == changes.begin()) return false;
    const auto& [last, bytes] = *std::prev(after);
    return last + bytes.size() > at;
}

void apply(const Changes& changes, std::uint64_t at, char* bytes, std::size_t count)
{
    auto entry = changes.upper_bound(at);
    if (entry != changes.begin()) --entry;
    for (; entry != changes.end() && entry->first < at + count; ++entry) {
        const std::uint64_t from = std::max(entry->first, at), to = std::min(entry->first + entry->second.size(), at + count);
        if (from < to) std::memcpy(bytes + (from - at), entry->second.data() + (from - entry->first), to - from);
    }
}

std::string redo_log(const Changes& changes)
{
    std::string log;
    for (const auto& [at, bytes] : changes) {
        put(log, at);
        put(log, bytes.size());
        log += bytes;
    }
    const std::uint64_t sum = checksum(log), length = log.size() + log_foot_bytes;
    put(log, sum);
    put(log, length);
    return log += mark;
}

std::uint64_t length_of_log(std::string_view foot)
{
    if (foot.size() != log_foot_bytes || !foot.ends_with(mark)) return 0;
    const std::uint64_t length = number_at(foot, 8);
    return length >= log_foot_bytes && length <= longest_log ? length : 0;
}

Changes changes_in_log(std::string_view end_of_file, std::uint64_t file_size)
{
    if (end_of_file.size() < log_foot_bytes) return {};
    const std::string_view foot = end_of_file.substr(end_of_file.size() - log_foot_bytes);
    const std::uint64_t length = length_of_log(foot);
    if (length == 0 || length > end_of_file.size()) return {};
    std::string_view log = end_of_file.substr(end_of_file.size() - length, length - log_foot_bytes);
    if (checksum(log) != number_at(foot, 0)) return {};
    const std::uint64_t most = file_size - length;
    Changes changes;
    std::uint64_t end = 0; // of the last
    while (!log.empty()) {
        constexpr std::size_t head = 16;
        if (log.size() < head) return {};
        const std::uint64_t at = number_at(log, 0), count = number_at(log, 8);
        if (count == 0 || count > log.size() - head || at < end || at > most || count > most - at) return {};
        changes.emplace_hint(changes.end(), at, log.substr(head, count));
        end = at + count;
        log.remove_prefix(head + count);
    }
    return changes;
}

} // namespace hygroloom
