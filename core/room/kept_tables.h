// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Tables of rooms that were found before, by all that they follow from: those of this process, and those that other programs left on the
// disk. One that another version of the code found counts as unknown.
#pragma once

#include "core/room/room_tables.h"

#include <filesystem>
#include <memory>

namespace hygroloom {

/// The user's: rooms in cache_folder(); empty where there is none.
std::filesystem::path usual_kept_tables();

/// Which folder holds them for later programs; empty, as at the start: none is kept on the disk. A file that cannot be read counts as
/// missing, one that cannot be written changes nothing. Of more than 2 000 files the oldest half goes.
void keep_tables_in(const std::filesystem::path& folder);

/// As find_room_tables() finds them, or found them before.
std::shared_ptr<const RoomTables> room_tables(const Textile& textile, int voxels);
/// Whether the disk has them: neither need the next program find them.
bool room_tables_are_kept(const Textile& textile, int voxels);

} // namespace hygroloom
