// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Lets the HDF5 library read and write through an object of this program, not a file that it opens by name: no locks of the library's own,
// and the writer decides when what is written takes effect.
#pragma once

#include "core/run/hdf5_blocks.h"
#include "core/run/hdf5_file.h"

#include <cstdint>

namespace hygroloom::hdf5 {

/// The bytes of a file. Must outlive the library's handle on it. Each function returns false when it fails.
class Storage {
public:
    virtual ~Storage() = default;
    virtual std::uint64_t size() const = 0;
    virtual bool read(std::uint64_t at, void* bytes, std::size_t count, BlockKind kind) = 0;
    /// Else each block of metadata is read from its beginning.
    virtual bool is_written() const = 0;
    /// What is metadata may be written anywhere; what is not, only where nothing that is in use was written before.
    virtual bool write(std::uint64_t at, const void* bytes, std::size_t count, bool is_metadata) = 0;
    virtual void resize(std::uint64_t size) = 0;
};

/// Both throw FileError with the given words when the library refuses.
Handle create_file(Storage& storage, const std::string& what);
Handle open_file(Storage& storage, const std::string& what);

} // namespace hygroloom::hdf5
