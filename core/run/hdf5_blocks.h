// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Looks at each block of metadata before the HDF5 library does. The library trusts what it reads: trees that lead back to themselves,
// counts and lengths beyond a block's end. Only what recordings are made of passes: the format of superblock 0 with its groups and headers.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <vector>

namespace hygroloom::hdf5 {

struct Messages;

enum class BlockKind { superblock, header, tree, heap, data, other };

class BlockCheck {
public:
    /// Reads bytes of the file; returns whether it could.
    using Read = std::function<bool(std::uint64_t at, void* bytes, std::size_t count)>;
    BlockCheck() = default;
    BlockCheck(Read read, std::uint64_t file_size) : read_(std::move(read)), file_size_(file_size) {}

    /// Whether the library may read there. Blocks are read from their beginning.
    bool allows(std::uint64_t at, std::size_t count, BlockKind kind);

private:
    using Bytes = std::vector<unsigned char>;
    struct ChunkTree {
        std::uint64_t places; ///< in its keys
        std::uint64_t bytes;  ///< that each chunk has; 0 where they are packed
        bool operator==(const ChunkTree&) const = default;
    };
    Bytes bytes_at(std::uint64_t at, std::uint64_t count) const; ///< empty where the file does not have them
    bool is_superblock() const;
    bool is_header(std::uint64_t at);
    bool is_apart(std::uint64_t at, std::uint64_t size);
    bool holds_whole(const Messages& found) const;
    bool is_tree_or_node(std::uint64_t at);
    bool is_tree(std::uint64_t at, const Bytes& head);
    bool are_whole(std::uint64_t at, const ChunkTree& tree, std::uint64_t entries);
    bool is_heap(std::uint64_t at);
    bool note_chunk_tree(std::uint64_t at, const ChunkTree& tree, std::uint64_t named_at);
    bool is_named_once(std::uint64_t at, std::uint64_t named_at, std::uint64_t bytes);

    Read read_;
    std::uint64_t file_size_ = 0;
    std::set<std::uint64_t> headers_, heaps_;         ///< that were checked, with where they go on
    std::map<std::uint64_t, ChunkTree> chunk_trees_;  ///< by their place
    std::map<std::uint64_t, std::uint64_t> named_at_; ///< of chunks and their trees: where the file has the number of their place
    std::map<std::uint64_t, std::uint64_t> taken_;    ///< by headers and heaps: begin and end
    std::uint64_t chunk_bytes_ = 0;                   ///< of those that are named
};

} // namespace hygroloom::hdf5
