// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Compressed values, unpacked here: the library's own unpacking takes as much memory as a file makes it take, and reads on behind a part
// that has fewer bytes than it should.
#pragma once

#include "core/run/hdf5_file.h"

#include <functional>

namespace hygroloom::hdf5 {

struct PackedRows {
    hsize_t rows, rows_of_chunk;
    std::size_t dimensions; ///< of the set
    std::size_t row_bytes, value_bytes;
    hsize_t first = 0; ///< that is read, at a chunk's beginning
};

using TakeRows = std::function<void(hsize_t first, hsize_t count, const unsigned char* bytes)>;

/// The bytes of a set that lies in chunks of whole rows behind shuffle and deflate, or one of them, chunk by chunk. Preconditions: a chunk
/// has rows; a value has bytes. place: for sentences. Throws FileError.
void read_packed_rows(hid_t set, hid_t properties, const PackedRows& of, const TakeRows& take, const std::string& place);

/// Floats, so packed. sizes: of the set; chunk: of a chunk, which is not empty; place: for sentences. Throws FileError.
void read_packed(hid_t set, hid_t type, hid_t properties, const std::vector<hsize_t>& sizes, const std::vector<hsize_t>& chunk,
                 float* values, const std::string& place);

} // namespace hygroloom::hdf5
