// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Positive numbers as integers that order like them, for the largest of many.
#pragma once

#include "core/base/portable.h"

namespace hygroloom::inline HL_PRECISION {

/// Bits of a positive number, which order like integers.
HL_FN int ordered_bits(float positive)
{
    union {
        float value;
        int bits;
    } both;
    both.value = positive;
    return both.bits;
}
HL_FN float from_ordered_bits(int bits)
{
    union {
        int bits;
        float value;
    } both;
    both.bits = bits;
    return both.value;
}

} // namespace hygroloom::inline HL_PRECISION
