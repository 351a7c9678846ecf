// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Packs of numbers for sums over neighbours: eight at once on a CPU, one after the other in a thread of a GPU. The lanes of a pack are
// added in one order, so a sum does not depend on the processor's width.
#pragma once

#include "core/base/portable.h"

#include <cmath>

namespace hygroloom {

constexpr int lanes = HL_LANES;

/// Four numbers that are fetched together: a place and what is known there.
struct alignas(4 * sizeof(Real)) Quad {
    Real x = 0, y = 0, z = 0, w = 0;
};

HL_FN Real root(Real value) { return std::sqrt(value); }
HL_FN Real positive(Real value) { return value > 0 ? value : Real(0); }

#if HL_LANES == 1

using Pack = Real;
struct Quads {
    Pack x, y, z, w;
};
HL_FN Real sum_of(Pack pack) { return pack; }
HL_FN Real lane_of(Pack pack, int) { return pack; }
HL_FN Quads gather(const Quad* at, const int* slots) { return {at[*slots].x, at[*slots].y, at[*slots].z, at[*slots].w}; }
HL_FN Quads load(const Quad* at) { return {at->x, at->y, at->z, at->w}; }

#else

using Pack = Real __attribute__((vector_size(lanes * sizeof(Real))));
struct Quads {
    Pack x, y, z, w;
};
inline Real sum_of(const Pack& p) { return ((p[0] + p[4]) + (p[2] + p[6])) + ((p[1] + p[5]) + (p[3] + p[7])); }
inline Real lane_of(const Pack& pack, int lane) { return pack[lane]; }
inline Pack root(const Pack& values)
{
    Pack roots;
    for (int i = 0; i < lanes; ++i) roots[i] = std::sqrt(values[i]);
    return roots;
}
inline Pack positive(const Pack& values) { return values > 0 ? values : Pack{}; }

/// Rows of four to columns of eight.
inline Quads transposed(const Quad* const (&at)[lanes])
{
    using Row = Real __attribute__((vector_size(4 * sizeof(Real)), may_alias));
    const auto both = [&](int i) {
        const Row a = *reinterpret_cast<const Row*>(at[i]), b = *reinterpret_cast<const Row*>(at[i + 4]);
        return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
    };
    const Pack a = both(0), b = both(1), c = both(2), d = both(3);
    const Pack ab = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13),
               ab2 = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
    const Pack cd = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13),
               cd2 = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    return {__builtin_shufflevector(ab, cd, 0, 1, 8, 9, 4, 5, 12, 13), __builtin_shufflevector(ab, cd, 2, 3, 10, 11, 6, 7, 14, 15),
            __builtin_shufflevector(ab2, cd2, 0, 1, 8, 9, 4, 5, 12, 13), __builtin_shufflevector(ab2, cd2, 2, 3, 10, 11, 6, 7, 14, 15)};
}
/// Of the places that the next slots name.
inline Quads gather(const Quad* at, const int* slots)
{
    const Quad* const rows[lanes] = {at + slots[0], at + slots[1], at + slots[2], at + slots[3],
                                     at + slots[4], at + slots[5], at + slots[6], at + slots[7]};
    return transposed(rows);
}
/// Of places side by side.
inline Quads load(const Quad* at)
{
    const Quad* const rows[lanes] = {at, at + 1, at + 2, at + 3, at + 4, at + 5, at + 6, at + 7};
    return transposed(rows);
}

#endif

} // namespace hygroloom
