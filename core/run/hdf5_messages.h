// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The messages in the headers of HDF5 objects, as far as recordings have them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hygroloom::hdf5 {

/// Bytes from a file, read in order; what lies beyond the end reads as 0 and is remembered.
class Cursor {
public:
    explicit Cursor(std::span<const unsigned char> bytes) : bytes_(bytes) {}
    /// Little-endian, of 1, 2, 4 or 8 bytes.
    std::uint64_t number(std::size_t bytes);
    std::span<const unsigned char> take(std::uint64_t count);
    std::size_t left() const { return bytes_.size(); }
    bool held() const { return held_; }

private:
    std::span<const unsigned char> bytes_;
    bool held_ = true;
};

/// Where the messages of a header go on.
struct Continuation {
    std::uint64_t at, size;
};

/// The tree of the chunks of a set of data, by the number of places that its keys have.
struct ChunkTree {
    std::uint64_t at, places;
};

/// What messages refer to.
struct Messages {
    std::vector<Continuation> go_on;
    std::vector<ChunkTree> trees;
};

/// Whether all messages in a block are such as recordings have, each within its bounds.
bool are_messages(std::span<const unsigned char> block, Messages& found);

} // namespace hygroloom::hdf5
