// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// After the HDF5 File Format Specification Version 3.0, section IV.A.2.
#include "core/run/hdf5_messages.h"

#include <algorithm>

namespace hygroloom::hdf5 {
namespace {

using Block = std::span<const unsigned char>;

constexpr std::uint64_t most_rank = 32;

std::uint64_t in_eights(std::uint64_t count) { return (count + 7) / 8 * 8; }

/// The number of values, where it is a dataspace.
std::optional<std::uint64_t> values_in_space(Block block)
{
    Cursor cursor(block);
    const std::uint64_t version = cursor.number(1), rank = cursor.number(1), flags = cursor.number(1);
    cursor.take(version == 1 ? 5 : 1);
    if (version < 1 || version > 2 || rank > most_rank || flags > 1) return std::nullopt;
    std::uint64_t count = 1;
    for (std::uint64_t i = 0; i < rank; ++i) {
        const std::uint64_t extent = cursor.number(8);
        if (extent != 0 && count > INT64_MAX / extent) return std::nullopt;
        count *= extent;
    }
    if (flags == 1) cursor.take(8 * rank); // the largest extents
    return cursor.held() ? std::optional(count) : std::nullopt;
}

/// The bytes of one value, where it is a type of whole numbers, floats or texts.
std::optional<std::uint64_t> bytes_of_type(Block block)
{
    Cursor cursor(block);
    const std::uint64_t head = cursor.number(1), kind = head % 16, version = head / 16;
    cursor.take(3);
    const std::uint64_t size = cursor.number(4);
    constexpr std::uint64_t whole = 0, floating = 1, text = 3;
    if (version < 1 || version > 3 || size == 0) return std::nullopt;
    if (kind != whole && kind != floating && kind != text) return std::nullopt;
    if (kind != text && size > 16) return std::nullopt;
    cursor.take(kind == whole ? 4 : kind == floating ? 12 : 0);
    return cursor.held() ? std::optional(size) : std::nullopt;
}

/// size: -1 where none is defined.
void note_fill_value(std::uint64_t size, Cursor& cursor, Messages& found)
{
    if (size > INT32_MAX) return;
    cursor.take(size);
    if (size > 0) found.fill_bytes.push_back(size);
}

bool is_fill_value(Block block, Messages& found)
{
    Cursor cursor(block);
    const std::uint64_t version = cursor.number(1);
    if (version < 1 || version > 3) return false;
    const std::uint64_t flags = version == 3 ? cursor.number(1) : 0;
    if (version < 3) cursor.take(2);
    const bool has_size = version == 1 || (version == 2 ? cursor.number(1) != 0 : (flags & 0x20) != 0);
    if (version == 1) cursor.take(1);
    if (has_size) note_fill_value(cursor.number(4), cursor, found);
    return cursor.held();
}

bool is_old_fill_value(Block block, Messages& found)
{
    Cursor cursor(block);
    note_fill_value(cursor.number(4), cursor, found);
    return cursor.held();
}

bool is_layout(Block block, Messages& found)
{
    Cursor cursor(block);
    constexpr std::uint64_t compact = 0, contiguous = 1, chunked = 2;
    const std::uint64_t version = cursor.number(1), kind = cursor.number(1);
    if (version != 3 || kind > chunked) return false;
    if (kind == compact) cursor.take(cursor.number(2));
    if (kind == contiguous) {
        const std::uint64_t at = cursor.number(8);
        found.whole = {at, cursor.number(8)};
    }
    if (kind == chunked) {
        const std::uint64_t rank = cursor.number(1); // one more than the set's
        if (rank < 2 || rank > most_rank + 1) return false;
        Chunks chunks{cursor.number(8), rank, 0, 1};
        for (std::uint64_t i = 0; i < rank; ++i) {
            chunks.value_bytes = cursor.number(4); // the last
            if (chunks.value_bytes == 0 || chunks.bytes > UINT32_MAX / chunks.value_bytes) return false;
            chunks.bytes *= chunks.value_bytes;
        }
        found.chunks = chunks;
    }
    return cursor.held();
}

/// Shuffle and deflate.
bool are_filters(Block block, Messages& found)
{
    Cursor cursor(block);
    const std::uint64_t version = cursor.number(1), count = cursor.number(1);
    found.is_packed = count > 0;
    if (version < 1 || version > 2 || count > 2) return false;
    if (version == 1) cursor.take(6);
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t filter = cursor.number(2);
        if (filter < 1 || filter > 2) return false;
        const std::uint64_t name = version == 1 ? cursor.number(2) : 0;
        cursor.take(2);
        const std::uint64_t values = cursor.number(2);
        cursor.take(in_eights(name) + 4 * values + (version == 1 && values % 2 == 1 ? 4 : 0));
    }
    return cursor.held();
}

bool is_attribute(Block block)
{
    Cursor cursor(block);
    const std::uint64_t version = cursor.number(1), flags = cursor.number(1), name = cursor.number(2), type = cursor.number(2),
                        space = cursor.number(2);
    if (version < 1 || version > 3 || (version > 1 && flags != 0) || name == 0) return false;
    if (version == 3) cursor.take(1);
    const auto padded = [&](std::uint64_t size) { return version == 1 ? in_eights(size) : size; };
    const Block name_bytes = cursor.take(padded(name)), type_bytes = cursor.take(padded(type)), space_bytes = cursor.take(padded(space));
    if (!cursor.held() || name_bytes[name - 1] != 0) return false;
    const auto bytes = bytes_of_type(type_bytes.first(type)), count = values_in_space(space_bytes.first(space));
    if (!bytes || !count || *count > cursor.left()) return false;
    return *bytes * *count <= cursor.left();
}

bool is_message(std::uint64_t kind, Block block, Messages& found)
{
    const bool is_single = kind == 0x01 || kind == 0x03 || kind == 0x04 || kind == 0x05 || kind == 0x08 || kind == 0x0B;
    if (is_single && !found.kinds.insert(kind).second) return false;
    switch (kind) {
    case 0x00: return true; // nothing
    case 0x01: return values_in_space(block).has_value();
    case 0x03: return (found.type_bytes = bytes_of_type(block)).has_value();
    case 0x04: return is_old_fill_value(block, found);
    case 0x05: return is_fill_value(block, found);
    case 0x08: return is_layout(block, found);
    case 0x0B: return are_filters(block, found);
    case 0x0C: return is_attribute(block);
    case 0x10: // goes on elsewhere
    case 0x11: // a group's tree and heap
        return block.size() >= 16;
    case 0x12: return block.size() >= 8; // a time
    default: return false;
    }
}

} // namespace

std::uint64_t Cursor::number(std::size_t bytes)
{
    std::uint64_t value = 0;
    std::size_t shift = 0;
    for (const unsigned char byte : take(bytes)) {
        value |= static_cast<std::uint64_t>(byte) << shift;
        shift += 8;
    }
    return value;
}

std::span<const unsigned char> Cursor::take(std::uint64_t count)
{
    if (count > bytes_.size()) {
        held_ = false;
        bytes_ = {};
        return {};
    }
    const auto taken = bytes_.first(count);
    bytes_ = bytes_.subspan(count);
    return taken;
}

bool are_messages(std::span<const unsigned char> block, Messages& found)
{
    constexpr std::size_t head = 8;
    Cursor cursor(block);
    while (cursor.left() >= head) { // what is shorter is a gap
        const std::uint64_t kind = cursor.number(2), size = cursor.number(2), flags = cursor.number(1);
        cursor.take(3);
        const Block message = cursor.take(size);
        constexpr std::uint64_t constant = 1; // no other flag: none is shared
        if (!cursor.held() || (kind != 0 && flags > constant) || !is_message(kind, message, found)) return false;
        if (kind != 0x10) continue;
        Cursor place(message);
        const std::uint64_t at = place.number(8);
        found.go_on.push_back({at, place.number(8)});
    }
    return true;
}

bool sizes_agree(const Messages& found)
{
    const auto is_of_type = [&](std::uint64_t size) { return size == found.type_bytes; };
    return std::all_of(found.fill_bytes.begin(), found.fill_bytes.end(), is_of_type) &&
           (!found.chunks || is_of_type(found.chunks->value_bytes));
}

} // namespace hygroloom::hdf5
