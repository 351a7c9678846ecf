// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What writing and reading a recording agree on. Frames are written whole before the ledger's row that counts them.
#pragma once

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>

namespace hygroloom {

constexpr int recording_version = 4;         ///< of recordings with frames that hold changes
constexpr int recording_version_bundles = 3; ///< of others whose frames are those of bundles
constexpr int recording_version_cells = 2;   ///< of others whose frames show cells
constexpr int recording_version_plain = 1;   ///< of others, which older programs read, too
constexpr const char* recording_format = "hygroloom-recording";

/// Of the acts of a RunRecord: name in the provenance, and time.
template <typename Acts> auto stored_acts(Acts& acts)
{
    return std::array{std::pair{"hand_tilted_s", &acts.tilted}, std::pair{"hand_squeezed_s", &acts.squeezed},
                      std::pair{"hand_wiped_s", &acts.wiped}};
}

inline std::string frame_name(int index) { return fmt::format("{:06d}", index); }

} // namespace hygroloom
