// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The form of the file: https://www.sqlite.org/fileformat2.html, "The Write-Ahead Log".
#include "core/run/wal_pages.h"

#include <fcntl.h>
#include <string>
#include <string_view>
#include <unistd.h>

namespace hygroloom {
namespace {

constexpr std::size_t file_head = 32, page_head = 24, size_at = 8, salt_of_file_at = 16, salt_of_page_at = 8, salt_bytes = 8;

std::uint32_t number_at(std::string_view bytes, std::size_t at)
{
    std::uint32_t number = 0;
    for (const char byte : bytes.substr(at, 4)) number = number << 8U | static_cast<unsigned char>(byte);
    return number;
}

bool read_whole(int file, std::string& bytes, std::size_t at)
{
    return ::pread(file, bytes.data(), bytes.size(), static_cast<off_t>(at)) == static_cast<ssize_t>(bytes.size());
}

bool write_from(int wal, int database, std::uint32_t size)
{
    std::string head(file_head, '\0');
    if (!read_whole(wal, head, 0)) return true; // there are none
    const std::size_t page = number_at(head, size_at);
    std::string entry(page_head + page, '\0');
    for (std::size_t at = file_head; read_whole(wal, entry, at); at += entry.size()) {
        const std::string_view bytes = entry;
        if (bytes.substr(salt_of_page_at, salt_bytes) != std::string_view(head).substr(salt_of_file_at, salt_bytes)) break; // of before
        const std::uint32_t number = number_at(bytes, 0);
        if (number <= size) continue;
        const auto place = static_cast<off_t>(page) * (number - 1);
        if (::pwrite(database, bytes.data() + page_head, page, place) != static_cast<ssize_t>(page)) return false;
    }
    return true;
}

} // namespace

bool write_new_pages(const std::filesystem::path& wal, int database, std::uint32_t size)
{
    const int file = ::open(wal.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return true;
    const bool done = write_from(file, database, size);
    ::close(file);
    return done;
}

} // namespace hygroloom
