// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A large file written at several places in turn, each through a buffer of its own, so that it need not be made in order.
#pragma once

#include <bit>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hygroloom {

static_assert(std::endian::native == std::endian::little, "Numbers go into files as they lie in memory.");

/// Throws FileError, which names the file as shown.
class OutputFile {
public:
    /// Creates the file, or empties it. A link there is an error.
    OutputFile(const std::filesystem::path& path, std::string shown);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write_at(std::uint64_t place, const char* bytes, std::size_t count);
    /// A file that was not closed may be incomplete.
    void close();

private:
    int file_ = -1;
    std::string shown_;
};

/// Bytes one after the other from a place of a file on. What flush() has not written is lost.
class OutputRun {
public:
    OutputRun(OutputFile& file, std::uint64_t place) : file_(&file), begin_(place) {}

    void add(std::string_view bytes)
    {
        buffer_.append(bytes);
        spill();
    }
    /// A number or a plain struct without padding.
    template <typename Value> void put(const Value& value)
    {
        buffer_.append(reinterpret_cast<const char*>(&value), sizeof value);
        spill();
    }
    /// Room for a number of bytes, which the caller fills at once.
    char* room(std::size_t count)
    {
        spill();
        buffer_.resize(buffer_.size() + count);
        return buffer_.data() + buffer_.size() - count;
    }
    void flush();
    /// Where the next byte goes.
    std::uint64_t place() const { return begin_ + buffer_.size(); }
    /// Goes on elsewhere.
    void move_to(std::uint64_t place)
    {
        flush();
        begin_ = place;
    }

private:
    static constexpr std::size_t most = std::size_t(4) << 20;
    void spill()
    {
        if (buffer_.size() >= most) flush();
    }
    OutputFile* file_;
    std::uint64_t begin_;
    std::string buffer_;
};

/// Appends a number with a fixed number of decimals; much faster than printf. Precondition: |value| < 1e9, decimals <= 9.
void append_decimal(std::string& text, double value, int decimals);
void append_whole(std::string& text, std::uint64_t value);

} // namespace hygroloom
