// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What writing and reading a recording agree on.
#pragma once

#include <array>
#include <utility>

namespace hygroloom {

/// What a file says that it is.
constexpr const char* recording_format = "hygroloom-recording";
constexpr const char* wear_format = "hygroloom-wear-recording";

/// Of the acts of a RunRecord: name in the file, and time.
template <typename Acts> auto stored_acts(Acts& acts)
{
    return std::array{std::pair{"provenance/hand_tilted_s", &acts.tilted}, std::pair{"provenance/hand_squeezed_s", &acts.squeezed},
                      std::pair{"provenance/hand_wiped_s", &acts.wiped}};
}

} // namespace hygroloom
