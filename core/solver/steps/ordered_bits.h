// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Positive numbers as integers that order like them, for the largest of many.
#pragma once

#include "core/base/portable.h"

#include <bit>

namespace hygroloom {

/// Bits of a positive number, which order like integers.
HL_FN int ordered_bits(float positive) { return std::bit_cast<int>(positive); }
HL_FN float from_ordered_bits(int bits) { return std::bit_cast<float>(bits); }

} // namespace hygroloom
