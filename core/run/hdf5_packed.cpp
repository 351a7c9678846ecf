// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/hdf5_packed.h"

#include "core/base/error.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>

namespace hygroloom::hdf5 {
namespace {

[[noreturn]] void refuse(const std::string& place, const char* what) { throw FileError(fmt::format("\"{}\" {}", place, what)); }

using Filters = std::vector<H5Z_filter_t>;

/// In the order in which they were applied.
Filters filters_of(hid_t properties, const std::string& place)
{
    Filters filters;
    const int count = H5Pget_nfilters(properties);
    for (int i = 0; i < count; ++i) {
        unsigned flags = 0, what = 0;
        std::size_t values = 0;
        filters.push_back(H5Pget_filter2(properties, static_cast<unsigned>(i), &flags, &values, nullptr, 0, nullptr, &what));
    }
    const Filters known[] = {{H5Z_FILTER_SHUFFLE, H5Z_FILTER_DEFLATE}, {H5Z_FILTER_DEFLATE}, {H5Z_FILTER_SHUFFLE}};
    if (std::find(std::begin(known), std::end(known), filters) == std::end(known))
        refuse(place, "is compressed in a way that is not read.");
    return filters;
}

void unpack(const std::vector<unsigned char>& packed, std::vector<unsigned char>& plain, const std::string& place)
{
    uLongf size = plain.size();
    if (uncompress(plain.data(), &size, packed.data(), packed.size()) != Z_OK || size != plain.size())
        refuse(place, "cannot be unpacked; the file is damaged.");
}

/// size: of a value, bytes.
void unshuffle(std::vector<unsigned char>& bytes, std::size_t size)
{
    const std::vector<unsigned char> shuffled = bytes;
    const std::size_t count = bytes.size() / size;
    if (size == 4) { // twice as quick
        const unsigned char* const from = shuffled.data();
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t k = 0; k < 4; ++k) bytes[4 * i + k] = from[k * count + i];
        return;
    }
    for (std::size_t k = 0; k < size; ++k)
        for (std::size_t i = 0; i < count; ++i) bytes[i * size + k] = shuffled[k * count + i];
}

/// Bytes of the chunk's values.
void read_chunk(hid_t set, const hsize_t* offset, const Filters& filters, std::size_t value_bytes, std::vector<unsigned char>& plain,
                const std::string& place)
{
    hsize_t stored = 0;
    if (H5Dget_chunk_storage_size(set, offset, &stored) < 0 || stored == 0) refuse(place, "lacks a part; the file is damaged.");
    if (stored > 2 * plain.size() + 1024) refuse(place, "cannot be unpacked; the file is damaged."); // deflate adds some bytes at most
    std::vector<unsigned char> bytes(stored);
    std::uint32_t left_out = 0; // filters, by bits
    if (H5Dread_chunk(set, H5P_DEFAULT, offset, &left_out, bytes.data()) < 0) refuse(place, "cannot be read; the file is damaged.");
    for (std::size_t i = filters.size(); i-- > 0;) {
        if (left_out >> i & 1) continue;
        if (filters[i] == H5Z_FILTER_DEFLATE) {
            unpack(bytes, plain, place);
            bytes = plain;
        } else {
            unshuffle(bytes, value_bytes);
        }
    }
    if (bytes.size() != plain.size()) refuse(place, "has a part of the wrong size; the file is damaged.");
    plain = std::move(bytes);
}

} // namespace

void read_packed_rows(hid_t set, hid_t properties, const PackedRows& of, const TakeRows& take, const std::string& place)
{
    const Filters filters = filters_of(properties, place);
    std::vector<unsigned char> plain;
    std::vector<hsize_t> offset(of.dimensions, 0);
    offset[0] = of.first;
    for (hsize_t& row = offset[0]; row < of.rows; row += of.rows_of_chunk) {
        plain.resize(of.rows_of_chunk * of.row_bytes);
        read_chunk(set, offset.data(), filters, of.value_bytes, plain, place);
        take(row, std::min(of.rows_of_chunk, of.rows - row), plain.data());
    }
}

void read_packed(hid_t set, hid_t type, hid_t properties, const std::vector<hsize_t>& sizes, const std::vector<hsize_t>& chunk,
                 float* values, const std::string& place)
{
    const bool whole_rows = chunk.size() == sizes.size() && std::equal(chunk.begin() + 1, chunk.end(), sizes.begin() + 1, sizes.end());
    if (H5Tequal(type, H5T_NATIVE_FLOAT) <= 0 || !whole_rows) refuse(place, "is compressed in a way that is not read.");
    hsize_t columns = 1;
    for (std::size_t i = 1; i < sizes.size(); ++i) columns *= sizes[i];
    const PackedRows rows{sizes[0], chunk[0], sizes.size(), columns * sizeof(float), sizeof(float)};
    const auto take = [&](hsize_t first, hsize_t count, const unsigned char* bytes) {
        std::memcpy(values + first * columns, bytes, count * rows.row_bytes);
    };
    read_packed_rows(set, properties, rows, take, place);
}

} // namespace hygroloom::hdf5
