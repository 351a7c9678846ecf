// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#pragma once

#include <cstdint>
#include <vector>

namespace hygroloom {

/// A picture of the command line and of reports.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb; ///< rows from the top, three bytes per pixel
};

} // namespace hygroloom
