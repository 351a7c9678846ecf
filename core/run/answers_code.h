// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#pragma once

namespace hygroloom {

/// Digest of the sources and fibre data that the numbers of runs follow from. A run of another digest may have other numbers, though its
/// design is the same.
extern const char answers_code[];

} // namespace hygroloom
