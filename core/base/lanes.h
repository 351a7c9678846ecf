// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Packs of numbers for sums over neighbours: eight at once on a CPU, in threads side by side on a GPU. The lanes of a pack are
// added in one order, whatever the processor's width.
#pragma once

#include "core/base/portable.h"

#include <cmath>
#ifdef __x86_64__
#include <xmmintrin.h>
#endif

namespace hygroloom::inline HL_PRECISION {

/// Four numbers that are fetched together: a place and what is known there.
struct alignas(4 * sizeof(Real)) Quad {
    Real x = 0, y = 0, z = 0, w = 0;
};

/// Slots name places by their distance from the first, in bytes: nothing is left to multiply where they are gathered.
HL_FN constexpr int slot_of(int index) { return index * static_cast<int>(sizeof(Quad)); }
HL_FN const Quad* at_slot(const Quad* first, int slot)
{
    return reinterpret_cast<const Quad*>(reinterpret_cast<const char*>(first) + slot);
}

// A list's packs lie between those of the elements that a warp works on beside it, so that the warp reads them together.
/// Of the list of an element; all have the same number of slots, whole packs.
HL_FN std::int64_t begin_of_list(int element, int room)
{
    return std::int64_t(element / elements_beside) * elements_beside * room + element % elements_beside * lanes;
}
HL_FN int place_in_list(int number) { return (number & -lanes) * elements_beside + (number & (lanes - 1)); }

/// A list of slots that grows. What there is no room for is left out.
struct SlotList {
    int* slots;
    int most; ///< whole packs
    int count = 0;
    HL_FN bool has_room() const { return count <= most - lanes; }
};

/// Copies for all threads that share an element, each a part of it.
template <typename T> HL_FN void copy_together(T& to, const T& from)
{
#ifdef __CUDA_ARCH__
    static_assert(sizeof(T) % sizeof(int) == 0);
    for (int k = own_lane(); k < static_cast<int>(sizeof(T) / sizeof(int)); k += lanes)
        reinterpret_cast<int*>(&to)[k] = reinterpret_cast<const int*>(&from)[k];
#else
    to = from;
#endif
}

/// Has memory brought that is read soon.
HL_FN void bring(const void* memory)
{
#ifndef __CUDA_ARCH__
    __builtin_prefetch(memory);
#endif
}

#if HL_LANE_IS_THREAD
HL_FN Real root(Real value) { return plain_root(value); }
HL_FN Real inverse_root(Real value) { return plain_inverse_root(value); }
HL_FN Real inverse(Real value) { return plain_inverse(value); }
HL_FN Real quotient(Real a, Real b) { return plain_quotient(a, b); }
/// Root of what the inverse root is known of. A CPU has found it on the way there, and need not wait for the division.
HL_FN Real root_beside(Real value, Real inverse_root) { return value * inverse_root; }
#else
template <typename T> inline T inverse(const T& value) { return Real(1) / value; }
template <typename T> inline T quotient(const T& a, const T& b) { return a / b; }
inline Real root(Real value) { return std::sqrt(value); }
inline Real inverse_root(Real value) { return Real(1) / root(value); }
#endif
HL_FN Real positive(Real value) { return value > 0 ? value : Real(0); }

// What is written once for a single number and, on a CPU, for a pack of them.
HL_FN Real size_of(Real value) { return value < 0 ? -value : value; }
HL_FN int whole(Real value) { return static_cast<int>(value); }
HL_FN Real real(int value) { return static_cast<Real>(value); }
HL_FN bool any(bool condition) { return condition; }
HL_FN Real choose(bool condition, Real a, Real b) { return condition ? a : b; }
HL_FN int choose(bool condition, int a, int b) { return condition ? a : b; }
HL_FN Quad quad_at(const Quad* first, int index) { return first[index]; }

#if HL_LANE_IS_THREAD

using Pack = Real; // of which each thread has its lane
struct Quads {
    Pack x, y, z, w;
};
HL_FN Real sum_of(Pack pack)
{
    wait_for_warp();
    for (int bit = lanes / 2; bit > 0; bit /= 2) pack += of_other_lane(pack, bit);
    return pack;
}
/// Of all elements of the warp, to which they have all added.
HL_FN Real sum_beside(Pack pack)
{
    for (int bit = 16; bit > 0; bit /= 2) pack += of_other_lane(pack, bit);
    return pack;
}
HL_FN Quads fetch(const Quad* at)
{
    Quads quad;
    fetch_four(&at->x, quad.x, quad.y, quad.z, quad.w);
    return quad;
}
HL_FN Quads load(const Quad* at) { return fetch(at + own_lane()); }
HL_FN Quads gather(const Quad* at, const int* slots) { return fetch(at_slot(at, slots[own_lane()])); }
HL_FN Pack load(const Real* at) { return at[own_lane()]; }
HL_FN void store(Real* at, Pack pack) { at[own_lane()] = pack; }
HL_FN bool lanes_below(int count) { return own_lane() < count; }
HL_FN bool lanes_but(int lane) { return own_lane() != lane; }
HL_FN Pack first_lanes(int count) { return own_lane() < count ? Real(1) : Real(0); }
/// Lists each lane's own for at most one of two lists.
HL_FN void list_lanes(bool for_a, bool for_b, int own, SlotList& a, SlotList& b)
{
    for_a = for_a && a.has_room();
    for_b = for_b && b.has_room();
    const unsigned lanes_a = lanes_where(for_a), lanes_b = lanes_where(for_b);
    const int number = (for_a ? a.count : b.count) + bits_in(before_own(for_a ? lanes_a : lanes_b));
    if (for_a || for_b) (for_a ? a.slots : b.slots)[place_in_list(number)] = slot_of(own);
    a.count += bits_in(lanes_a);
    b.count += bits_in(lanes_b);
}
/// To whole packs.
HL_FN void fill_up(SlotList& list, int slot)
{
    const int begun = list.count & (lanes - 1);
    if (begun == 0) return;
    if (own_lane() >= begun) list.slots[place_in_list(list.count - begun + own_lane())] = slot;
    list.count += lanes - begun;
}

#else

using Pack = Real __attribute__((vector_size(lanes * sizeof(Real))));
struct Quads {
    Pack x, y, z, w;
};
inline Real sum_of(const Pack& p)
{
    const auto four = __builtin_shufflevector(p, p, 0, 1, 2, 3) + __builtin_shufflevector(p, p, 4, 5, 6, 7);
    const auto two = four + __builtin_shufflevector(four, four, 2, 3, 2, 3);
    return two[0] + two[1];
}
inline Real sum_beside(const Pack& p) { return sum_of(p); }
inline unsigned elements_where(bool condition) { return condition ? 1 : 0; }
inline Real of_element(Real value, int) { return value; }
inline int lowest_bit(unsigned bits) { return __builtin_ctz(bits); }
inline Pack root(const Pack& values)
{
    Pack roots;
    for (int i = 0; i < lanes; ++i) roots[i] = std::sqrt(values[i]);
    return roots;
}
inline Pack inverse_root(const Pack& values) { return Real(1) / root(values); }
inline Pack root_beside(const Pack& values, const Pack&) { return root(values); }
/// Zeros, but not a constant: with what GCC knows to be zero it compares and masks in two steps, in place of taking the larger.
inline Pack zeros{};
inline Pack positive(const Pack& values) { return values < zeros ? zeros : values; }

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
    const Quad* const rows[lanes] = {at_slot(at, slots[0]), at_slot(at, slots[1]), at_slot(at, slots[2]), at_slot(at, slots[3]),
                                     at_slot(at, slots[4]), at_slot(at, slots[5]), at_slot(at, slots[6]), at_slot(at, slots[7])};
    return transposed(rows);
}
/// Of places side by side.
inline Quads load(const Quad* at)
{
    const Quad* const rows[lanes] = {at, at + 1, at + 2, at + 3, at + 4, at + 5, at + 6, at + 7};
    return transposed(rows);
}
/// At any address. A packed struct is so for every compiler; clang takes no smaller alignment for the vector itself.
template <typename Vector> struct [[gnu::packed, gnu::may_alias]] Loose { Vector value; };
inline Pack load(const Real* at) { return reinterpret_cast<const Loose<Pack>*>(at)->value; }
inline void store(Real* at, const Pack& pack) { reinterpret_cast<Loose<Pack>*>(at)->value = pack; }

/// Which lanes are meant: all bits of a lane set, or none.
using Mask = decltype(Pack{} < Pack{});
using Slots = int __attribute__((vector_size(lanes * sizeof(int))));
constexpr Mask lane_numbers{0, 1, 2, 3, 4, 5, 6, 7};
inline Mask lanes_below(int count) { return lane_numbers < count; }
inline Mask lanes_but(int lane) { return lane_numbers != lane; }

/// Ones in the first lanes, zeros in the others.
inline Pack first_lanes(int count)
{
    Pack ones{};
    for (int lane = 0; lane < lanes; ++lane) ones[lane] = lane < count ? Real(1) : Real(0);
    return ones;
}

inline Pack size_of(const Pack& values) { return values < 0 ? -values : values; }
inline Slots whole(const Pack& values) { return __builtin_convertvector(values, Slots); }
inline Pack real(const Slots& values) { return __builtin_convertvector(values, Pack); }
inline Pack choose(const Mask& mask, const Pack& a, const Pack& b) { return mask ? a : b; }
inline Slots choose(const Mask& mask, const Slots& a, const Slots& b) { return __builtin_convertvector(mask, Slots) ? a : b; }
inline Quads quad_at(const Quad* first, const Slots& index)
{
    const Quad* const rows[lanes] = {first + index[0], first + index[1], first + index[2], first + index[3],
                                     first + index[4], first + index[5], first + index[6], first + index[7]};
    return transposed(rows);
}

/// One bit per lane.
inline unsigned bits_of(const Mask& mask)
{
#if defined(__x86_64__) && !defined(HYGROLOOM_DOUBLE)
    const auto low = __builtin_shufflevector(mask, mask, 0, 1, 2, 3), high = __builtin_shufflevector(mask, mask, 4, 5, 6, 7);
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(low)) | _mm_movemask_ps(reinterpret_cast<__m128>(high)) << 4);
#else
    unsigned bits = 0;
    for (int lane = 0; lane < lanes; ++lane) bits |= mask[lane] ? 1u << lane : 0u;
    return bits;
#endif
}

inline bool any(const Mask& mask) { return bits_of(mask) != 0; }

/// For all sets of lanes: their slots, side by side, and how many they are.
struct LaneTable {
    Slots slots[1 << lanes] = {};
    std::uint8_t count[1 << lanes] = {};
    constexpr LaneTable()
    {
        for (unsigned set = 0; set < 1u << lanes; ++set) {
            int of_set[lanes] = {};
            for (int lane = 0; lane < lanes; ++lane)
                if (set >> lane & 1u) of_set[count[set]++] = slot_of(lane);
            slots[set] = Slots{of_set[0], of_set[1], of_set[2], of_set[3], of_set[4], of_set[5], of_set[6], of_set[7]};
        }
    }
};
inline constexpr LaneTable lane_table;

/// Lists first + lane for each lane meant, for at most one of two lists; a whole pack of slots is written to.
inline void list_lanes(const Mask& wanted, int first, SlotList& list)
{
    if (!list.has_room()) return;
    const unsigned set = bits_of(wanted);
    reinterpret_cast<Loose<Slots>*>(list.slots + list.count)->value = slot_of(first) + lane_table.slots[set];
    list.count += lane_table.count[set];
}
inline void list_lanes(const Mask& for_a, const Mask& for_b, int first, SlotList& a, SlotList& b)
{
    list_lanes(for_a, first, a);
    list_lanes(for_b, first, b);
}
/// To whole packs.
inline void fill_up(SlotList& list, int slot)
{
    for (; list.count % lanes != 0; ++list.count) list.slots[list.count] = slot;
}

#endif

/// Several sums over neighbours, by lanes.
template <int count> struct PackSums {
    Pack of[count];
};
template <int count> struct Sums {
    Real of[count];
};
template <int count> HL_FN Sums<count> sum_of(const PackSums<count>& packs)
{
    Sums<count> sums;
    HL_UNROLL_WHOLE
    for (int k = 0; k < count; ++k) sums.of[k] = sum_of(packs.of[k]);
    return sums;
}

} // namespace hygroloom::inline HL_PRECISION
