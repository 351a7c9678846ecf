// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Counter-based random numbers: the same seed and counter give the same number on any thread and in any order.
#pragma once

#include "core/base/portable.h"

namespace hygroloom {

/// 64 random bits for (seed, stream, index): three rounds of the SplitMix64 finaliser (Steele, Lea, Flood 2014).
HL_FN std::uint64_t random_bits(std::uint64_t seed, std::uint64_t stream, std::uint64_t index)
{
    std::uint64_t z = seed;
    const std::uint64_t inputs[3] = {stream, index, 0};
    for (std::uint64_t input : inputs) {
        z += 0x9e3779b97f4a7c15ULL + input;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        z ^= z >> 31;
    }
    return z;
}

/// Uniform in [0, 1).
HL_FN double random_uniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t index)
{
    return static_cast<double>(random_bits(seed, stream, index) >> 11) * 0x1.0p-53;
}

} // namespace hygroloom
