// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/project/output_file.h"

#include "core/base/error.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace hygroloom {

OutputFile::OutputFile(const std::filesystem::path& path, std::string shown) : shown_(std::move(shown))
{
    file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file_ < 0) throw FileError(fmt::format("{}: The file cannot be written: {}.", shown_, std::strerror(errno)));
}

OutputFile::~OutputFile()
{
    if (file_ >= 0) ::close(file_);
}

void OutputFile::write_at(std::uint64_t place, const char* bytes, std::size_t count)
{
    const std::uint64_t begin = place;
    const std::size_t all = count;
    while (count > 0) {
        const ssize_t written = ::pwrite(file_, bytes, count, static_cast<off_t>(place));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0)
            throw FileError(fmt::format("{}: The file cannot be written: {}.", shown_, std::strerror(written < 0 ? errno : ENOSPC)));
        bytes += written;
        place += static_cast<std::uint64_t>(written);
        count -= static_cast<std::size_t>(written);
    }
#ifdef __linux__
    // On its way to the disk while the next piece is made; without effect on what is written.
    if (all >= 1 << 20) ::sync_file_range(file_, static_cast<off_t>(begin), static_cast<off_t>(all), SYNC_FILE_RANGE_WRITE);
#endif
}

void OutputFile::close()
{
    const int file = file_;
    file_ = -1;
    if (::close(file) != 0) throw FileError(fmt::format("{}: The file cannot be written: {}.", shown_, std::strerror(errno)));
}

void OutputRun::flush()
{
    if (buffer_.empty()) return;
    file_->write_at(begin_, buffer_.data(), buffer_.size());
    begin_ += buffer_.size();
    buffer_.clear();
}

void append_whole(std::string& text, std::uint64_t value)
{
    char digits[24];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

void append_decimal(std::string& text, double value, int decimals)
{
    constexpr std::uint64_t powers[] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000, 1000000000};
    const std::uint64_t power = powers[decimals];
    constexpr double half = 0.5; // of the last place, which is rounded: what is scaled is not negative
    const auto scaled = static_cast<std::uint64_t>(std::abs(value) * static_cast<double>(power) + half);
    if (value < 0 && scaled > 0) text += '-';
    append_whole(text, scaled / power);
    std::uint64_t rest = scaled % power;
    if (rest == 0) return;
    char digits[10];
    int count = decimals;
    while (rest % 10 == 0) {
        rest /= 10;
        --count;
    }
    for (int i = count; i-- > 0; rest /= 10) digits[i] = static_cast<char>('0' + rest % 10);
    text += '.';
    text.append(digits, static_cast<std::size_t>(count));
}

} // namespace hygroloom
