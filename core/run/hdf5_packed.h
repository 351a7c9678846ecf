// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Compressed numbers, unpacked here: the library's own unpacking takes as much memory as a file makes it take.
#pragma once

#include "core/run/hdf5_file.h"

namespace hygroloom::hdf5 {

/// Floats in chunks of whole rows behind shuffle and deflate, or one of them. sizes: of the set; chunk: of a chunk, which is not empty;
/// place: for sentences. Throws FileError.
void read_packed(hid_t set, hid_t type, hid_t properties, const std::vector<hsize_t>& sizes, const std::vector<hsize_t>& chunk,
                 float* values, const std::string& place);

} // namespace hygroloom::hdf5
