// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Free liquid as points that pictures and files draw.
#pragma once

#include "core/scene/frame.h"

namespace hygroloom {

/// m; each stands for as much liquid as any other. Particles are themselves, caps are filled with some thousand points.
std::vector<std::array<float, 3>> liquid_points(const Frame& frame);

} // namespace hygroloom
