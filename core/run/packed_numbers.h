// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Numbers of 4 or 8 bytes as the bytes of a field in a recording: how many bytes they are, in 8 bytes, and then themselves; where that is
// shorter, packed by zlib, all first bytes of the numbers before all second ones.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct z_stream_s;

namespace hygroloom {

/// Packs one field after another with the same memory.
class NumberPacker {
public:
    NumberPacker();
    ~NumberPacker();
    /// Until the next one. level: zlib's, 1 to 9.
    template <typename Number> std::string_view packed(std::span<const Number> numbers, int level = usual_level)
    {
        return packed(numbers.data(), numbers.size_bytes(), sizeof(Number), level);
    }
    static constexpr int usual_level = 4;

private:
    std::string_view packed(const void* numbers, std::size_t bytes, std::size_t size, int level);

    std::unique_ptr<z_stream_s> stream_;
    std::string shuffled_, packed_;
};

/// How many bytes the numbers of a field claim to be; 0 where it is too short to say.
std::uint64_t unpacked_bytes(std::string_view field);

/// Throws FileError with what is wrong, to stand behind the field's name. Precondition: unpacked_bytes() is no more than there is room for.
template <typename Number> std::vector<Number> unpacked(std::string_view field);
extern template std::vector<float> unpacked(std::string_view);
extern template std::vector<std::uint32_t> unpacked(std::string_view);

} // namespace hygroloom
