// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The messages in the headers of HDF5 objects, as far as recordings have them.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
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

/// A part of the file.
struct Part {
    std::uint64_t at, size;
};

/// How a set lies in chunks.
struct Chunks {
    std::uint64_t tree;        ///< where it lies; UINT64_MAX: there is none yet
    std::uint64_t places;      ///< of a chunk, as the tree's keys have them
    std::uint64_t value_bytes; ///< as the layout has it
    std::uint64_t bytes;       ///< of a chunk that is not packed
};

/// What the messages of one header say.
struct Messages {
    std::vector<Part> go_on;       ///< where they go on
    std::set<std::uint64_t> kinds; ///< of those that a header has once
    std::optional<std::uint64_t> type_bytes;
    std::vector<std::uint64_t> fill_bytes; ///< sizes of the values that stand for what is not there
    std::optional<Chunks> chunks;
    std::optional<Part> whole; ///< of a set that lies in one piece; at UINT64_MAX: there is none yet
    bool is_packed = false;
};

/// Whether all messages in a block are such as recordings have, each within its bounds.
bool are_messages(std::span<const unsigned char> block, Messages& found);

/// Whether the sizes that a set's messages say agree: the library copies a fill value, and a chunk's values, without comparing them.
bool sizes_agree(const Messages& found);

} // namespace hygroloom::hdf5
