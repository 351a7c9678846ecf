// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the solver's steps begin with, and plans count with.
#pragma once

namespace hygroloom {

constexpr double first_step = 1e-3; ///< s, of the yarns after something sudden

} // namespace hygroloom
