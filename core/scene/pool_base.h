// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How narrow a pool that is fed may be.
#pragma once

#include <algorithm>

namespace hygroloom {

/// m3: it covers at least the base of a half ball of so much, its first drop, or what hangs before it falls. drops: 0 for an even feed.
inline double least_pool(double volume, int drops, double hangs) { return std::min(volume, drops > 0 ? volume / drops : hangs); }

} // namespace hygroloom
