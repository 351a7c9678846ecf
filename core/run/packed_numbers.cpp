// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/packed_numbers.h"

#include "core/base/error.h"

#include <zlib.h>

#include <bit>
#include <cstring>
#include <new>

namespace hygroloom {
namespace {

static_assert(std::endian::native == std::endian::little, "recordings hold numbers with their lowest byte first");

constexpr std::size_t head = sizeof(std::uint64_t);
constexpr std::size_t least_packed = 4096; ///< bytes; of fewer little is saved

/// The first byte of each number, then the second of each, and so on; or back.
template <std::size_t size, bool back> void shuffle(const char* from, char* to, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < size; ++k) back ? to[size * i + k] = from[k * count + i] : to[k * count + i] = from[size * i + k];
}

} // namespace

NumberPacker::NumberPacker() : stream_(std::make_unique<z_stream>())
{
    if (deflateInit(stream_.get(), usual_level) != Z_OK) throw std::bad_alloc();
}

NumberPacker::~NumberPacker() { deflateEnd(stream_.get()); }

std::string_view NumberPacker::packed(const void* numbers, std::size_t bytes, std::size_t size, int level)
{
    const auto* const from = static_cast<const char*>(numbers);
    const std::uint64_t told = bytes;
    packed_.resize(head + bytes);
    std::memcpy(packed_.data(), &told, head);
    if (bytes >= least_packed) {
        shuffled_.resize(bytes);
        (size == 4 ? shuffle<4, false> : shuffle<8, false>)(from, shuffled_.data(), bytes / size);
        deflateReset(stream_.get());
        deflateParams(stream_.get(), level, Z_DEFAULT_STRATEGY);
        stream_->next_in = reinterpret_cast<Bytef*>(shuffled_.data());
        stream_->avail_in = static_cast<uInt>(bytes);
        stream_->next_out = reinterpret_cast<Bytef*>(packed_.data() + head);
        stream_->avail_out = static_cast<uInt>(bytes - 1);
        if (deflate(stream_.get(), Z_FINISH) == Z_STREAM_END) return {packed_.data(), head + stream_->total_out};
    }
    if (bytes > 0) std::memcpy(packed_.data() + head, from, bytes);
    return packed_;
}

std::uint64_t unpacked_bytes(std::string_view field)
{
    std::uint64_t bytes = 0;
    if (field.size() >= head) std::memcpy(&bytes, field.data(), head);
    return bytes;
}

template <typename Number> std::vector<Number> unpacked(std::string_view field)
{
    const std::uint64_t bytes = unpacked_bytes(field);
    if (field.size() < head || bytes % sizeof(Number) != 0) throw FileError("holds no numbers.");
    field.remove_prefix(head);
    std::vector<Number> numbers(bytes / sizeof(Number));
    if (field.size() == bytes) {
        if (bytes > 0) std::memcpy(numbers.data(), field.data(), bytes);
        return numbers;
    }
    std::string shuffled(bytes, '\0');
    uLongf size = bytes;
    if (uncompress(reinterpret_cast<Bytef*>(shuffled.data()), &size, reinterpret_cast<const Bytef*>(field.data()), field.size()) != Z_OK ||
        size != bytes)
        throw FileError("cannot be unpacked; the file is damaged.");
    shuffle<sizeof(Number), true>(shuffled.data(), reinterpret_cast<char*>(numbers.data()), numbers.size());
    return numbers;
}

template std::vector<float> unpacked(std::string_view);
template std::vector<std::uint32_t> unpacked(std::string_view);

} // namespace hygroloom
