// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/recording_head.h"

#include <cstdint>
#include <fcntl.h>
#include <string>
#include <unistd.h>

namespace hygroloom {
namespace {

int big_endian(std::string_view bytes)
{
    std::uint32_t number = 0;
    for (const char byte : bytes.substr(0, 4)) number = number << 8U | static_cast<unsigned char>(byte);
    return static_cast<int>(number);
}

} // namespace

RecordingHead recording_head(const std::filesystem::path& path)
{
    using enum RecordingHead::Is;
    constexpr std::size_t head_bytes = 100, version_at = 60, application_at = 68;
    std::string bytes(head_bytes, '\0');
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    const ssize_t got = file < 0 ? 0 : ::pread(file, bytes.data(), bytes.size(), 0);
    if (file >= 0) ::close(file);
    bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    if (bytes.empty()) return {empty};
    if (bytes.starts_with("\x89HDF\r\n\x1a\n")) return {older_form};
    if (bytes.size() < head_bytes || !bytes.starts_with(std::string_view("SQLite format 3\0", 16)) ||
        big_endian(std::string_view(bytes).substr(application_at)) != recording_application)
        return {other};
    return {recording, big_endian(std::string_view(bytes).substr(version_at))};
}

std::filesystem::path wal_of(const std::filesystem::path& recording) { return recording.string() + "-wal"; }
std::filesystem::path shm_of(const std::filesystem::path& recording) { return recording.string() + "-shm"; }

} // namespace hygroloom
