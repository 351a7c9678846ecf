// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// After the HDF5 File Format Specification Version 3.0, sections II to IV.
#include "core/run/hdf5_blocks.h"

#include "core/run/hdf5_messages.h"

#include <algorithm>
#include <string_view>

namespace hygroloom::hdf5 {
namespace {

constexpr std::uint64_t group_tree_half = 16, node_half = 4, chunk_tree_half = 32; // entries; what the library takes by default
constexpr std::uint64_t largest_block = 1 << 20;                                   // bytes, of a header's part
constexpr std::uint64_t largest_heap = 16 << 20; // bytes; of a million frames. The library keeps 32 MB at hand, and reads the rest anew
constexpr std::size_t most_parts = 64;           // of a header

bool begins_with(std::span<const unsigned char> bytes, std::string_view signature)
{
    return bytes.size() >= signature.size() && std::equal(signature.begin(), signature.end(), bytes.begin(),
                                                          [](char a, unsigned char b) { return static_cast<unsigned char>(a) == b; });
}

} // namespace

BlockCheck::Bytes BlockCheck::bytes_at(std::uint64_t at, std::uint64_t count) const
{
    if (at > file_size_ || count > file_size_ - at) return {};
    Bytes bytes(count);
    return read_(at, bytes.data(), count) ? bytes : Bytes();
}

bool BlockCheck::allows(std::uint64_t at, std::size_t count, BlockKind kind)
{
    switch (kind) {
    case BlockKind::data: return true;
    case BlockKind::superblock: return at + count <= 512 && is_superblock();
    case BlockKind::tree: return is_tree_or_node(at);
    case BlockKind::header: return headers_.contains(at) || is_header(at);
    case BlockKind::heap: return heaps_.contains(at) || is_heap(at);
    case BlockKind::other: return false;
    }
    return false;
}

bool BlockCheck::is_superblock() const
{
    const Bytes bytes = bytes_at(0, 96);
    if (!begins_with(bytes, "\x89HDF\r\n\x1a\n")) return false;
    Cursor cursor(bytes);
    cursor.take(8);
    const std::uint64_t versions = cursor.number(4);
    cursor.take(1);
    const std::uint64_t address = cursor.number(1), length = cursor.number(1);
    cursor.take(1);
    const std::uint64_t leaf = cursor.number(2), tree = cursor.number(2);
    cursor.take(4);
    const std::uint64_t base = cursor.number(8), free_space = cursor.number(8);
    cursor.take(8);
    const std::uint64_t driver = cursor.number(8);
    return versions % 256 == 0 && address == 8 && length == 8 && leaf == node_half && tree == group_tree_half && base == 0 &&
           free_space == UINT64_MAX && driver == UINT64_MAX;
}

/// With all of its parts, none of which lies in two headers.
bool BlockCheck::is_header(std::uint64_t at)
{
    constexpr std::uint64_t prefix = 16;
    const Bytes head = bytes_at(at, prefix);
    Cursor cursor(head);
    const std::uint64_t version = cursor.number(1);
    cursor.take(7);
    const std::uint64_t size = cursor.number(4);
    if (version != 1 || size > largest_block) return false;
    Messages found;
    found.go_on.push_back({at + prefix, size});
    std::set<std::uint64_t> places{at};
    for (std::size_t i = 0; i < found.go_on.size(); ++i) {
        const Part part = found.go_on[i];
        if (i > 0 && (headers_.contains(part.at) || !places.insert(part.at).second)) return false;
        if (part.size > largest_block || found.go_on.size() > most_parts) return false;
        const Bytes block = bytes_at(part.at, part.size);
        if (block.size() != part.size || !are_messages(block, found)) return false;
        if (i > 0 && (block.empty() || block[0] == version)) return false; // it could be taken for a header
        if (!(i > 0 ? is_apart(part.at, part.size) : is_apart(at, prefix + size))) return false;
    }
    if (!sizes_agree(found) || !holds_whole(found)) return false;
    if (const auto& chunks = found.chunks;
        chunks && chunks->tree != UINT64_MAX && !note_chunk_tree(chunks->tree, {chunks->places, found.is_packed ? 0 : chunks->bytes}, at))
        return false;
    headers_.merge(places);
    return true;
}

/// From the headers and heaps before it: what lies in many would be read as often.
bool BlockCheck::is_apart(std::uint64_t at, std::uint64_t size)
{
    const auto next = taken_.lower_bound(at);
    if (next != taken_.end() && next->first < at + size) return false;
    if (next != taken_.begin() && std::prev(next)->second > at) return false;
    taken_.emplace_hint(next, at, at + size);
    return true;
}

/// The library makes room for as many bytes as the layout says.
bool BlockCheck::holds_whole(const Messages& found) const
{
    if (!found.whole || found.whole->at == UINT64_MAX) return true;
    return found.whole->at <= file_size_ && found.whole->size <= file_size_ - found.whole->at;
}

/// One tree has keys of one length, for chunks of one size, and is the child of one other, or of one set.
bool BlockCheck::note_chunk_tree(std::uint64_t at, const ChunkTree& tree, std::uint64_t named_at)
{
    return is_named_once(at, named_at, 0) && chunk_trees_.emplace(at, tree).first->second == tree;
}

/// What is named twice would be walked twice, by trees of trees any number of times. All chunks together fit the file.
bool BlockCheck::is_named_once(std::uint64_t at, std::uint64_t named_at, std::uint64_t bytes)
{
    const auto [known, is_new] = named_at_.emplace(at, named_at);
    if (!is_new) return known->second == named_at;
    chunk_bytes_ += bytes;
    return chunk_bytes_ <= file_size_;
}

bool BlockCheck::is_tree_or_node(std::uint64_t at)
{
    const Bytes head = bytes_at(at, 8);
    if (begins_with(head, "TREE")) return is_tree(at, head);
    constexpr std::uint64_t symbol_bytes = 40, soft_link = 2;
    if (!begins_with(head, "SNOD") || head[4] != 1) return false;
    const std::uint64_t symbols = head[6] + 256U * head[7];
    if (symbols > 2 * node_half) return false;
    const Bytes table = bytes_at(at + 8, symbol_bytes * symbols);
    Cursor cursor(table);
    for (std::uint64_t i = 0; i < symbols; ++i) {
        cursor.take(16);
        if (cursor.number(4) > soft_link) return false;
        cursor.take(20);
    }
    return cursor.held();
}

/// The chunks of a tree's lowest level: the library makes room for as many bytes as a key says, and takes as many as the layout says.
bool BlockCheck::are_whole(std::uint64_t at, const ChunkTree& tree, std::uint64_t entries)
{
    const std::uint64_t key = 8 + 8 * tree.places;
    const Bytes table = bytes_at(at, (key + 8) * entries);
    Cursor cursor(table);
    for (std::uint64_t i = 0; i < entries; ++i) {
        const std::uint64_t size = cursor.number(4);
        cursor.take(key - 4);
        const std::uint64_t place = cursor.number(8);
        if (size == 0 || place > file_size_ || size > file_size_ - place || (tree.bytes != 0 && size != tree.bytes)) return false;
        if (!is_named_once(place, at + key + (key + 8) * i, size)) return false;
    }
    return cursor.held();
}

/// Levels fall by one from a tree to its children, so that none leads back.
bool BlockCheck::is_tree(std::uint64_t at, const Bytes& head)
{
    constexpr unsigned of_group = 0, of_chunks = 1;
    const unsigned kind = head[4], level = head[5];
    const std::uint64_t entries = head[6] + 256U * head[7];
    if (kind > of_chunks || entries > 2 * (kind == of_group ? group_tree_half : chunk_tree_half)) return false;
    const auto tree = chunk_trees_.find(at);
    if (kind == of_chunks && tree == chunk_trees_.end()) return false;
    if (kind == of_chunks && level == 0) return are_whole(at + 24, tree->second, entries);
    const std::uint64_t key = kind == of_group ? 8 : 8 + 8 * tree->second.places;
    for (std::uint64_t i = 0; i < entries; ++i) {
        const std::uint64_t named_at = at + 24 + key + (key + 8) * i;
        const Bytes place = bytes_at(named_at, 8);
        Cursor cursor(place);
        const std::uint64_t child_at = cursor.number(8);
        const Bytes child = bytes_at(child_at, 8);
        if (!cursor.held() || child.empty()) return false;
        const bool is_below =
            level == 0 ? begins_with(child, "SNOD") : begins_with(child, "TREE") && child[4] == kind && child[5] + 1U == level;
        if (!is_below || (kind == of_chunks && !note_chunk_tree(child_at, tree->second, named_at))) return false;
    }
    return true;
}

/// The list of free room ends, and the names do, too.
bool BlockCheck::is_heap(std::uint64_t at)
{
    constexpr std::uint64_t none = 1, free_bytes = 16;
    const Bytes head = bytes_at(at, 32);
    if (!begins_with(head, "HEAP") || head[4] != 0) return false;
    Cursor cursor(head);
    cursor.take(8);
    const std::uint64_t size = cursor.number(8);
    std::uint64_t free = cursor.number(8);
    const std::uint64_t names_at = cursor.number(8);
    if (size > largest_heap) return false;
    const Bytes names = bytes_at(names_at, size);
    if (names.empty() || names.front() != 0 || names.back() != 0) return false;
    for (std::uint64_t steps = 0; free != none; ++steps) {
        if (steps > size / free_bytes || free > size || size - free < free_bytes) return false;
        Cursor room(std::span<const unsigned char>(names).subspan(free));
        free = room.number(8);
        if (room.number(8) > size) return false;
    }
    if (!is_apart(at, head.size()) || !is_apart(names_at, size)) return false;
    heaps_.insert(at);
    heaps_.insert(names_at);
    return true;
}

} // namespace hygroloom::hdf5
