// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What stages on a GPU have in common, wherever they are started from: threads that share an element, sums, sorting by counting.
#pragma once

#include "core/base/lanes.h"
#include "core/solver/order.h"
#include "core/solver/steps/liquid.h"
#include "core/solver/steps/segment_exchange.h"

#include <type_traits>

namespace hygroloom {

/// Threads that share an element.
template <typename Stage> constexpr int threads_each() { return is_wide<Stage> ? lanes : 1; }

/// Whether two stages in turn are better two kernels, where there are kernels: each with as many threads at once as its registers allow.
template <typename Stage> constexpr bool stands_apart = false;
template <typename First, typename Second> constexpr bool stands_apart<InTurn<First, Second>> = is_wide<First>&& is_wide<Second>;

/// Blocks that a processor is to have room for side by side, where a stage waits for its own arithmetic so long that others' beside it are
/// worth numbers that go to memory and back; 0: as many as its registers allow.
template <typename Stage> constexpr int blocks_beside = 0;
template <> inline constexpr int blocks_beside<ExchangeInSegment> = 4;
template <> inline constexpr int blocks_beside<FindForces> = 8;
template <> inline constexpr int blocks_beside<FindSurface> = 16;
template <> inline constexpr int blocks_beside<FindPressureForce> = 16;

/// Calls a stage for an element below end, if there is one, or with those beside it in the warp for the last once more: to the same result,
/// so that all 32 lanes reach each shuffle. What it returns counts once; 0 if it returns nothing.
template <typename Stage> __device__ std::int64_t call_stage(const Stage& stage, int i, int end)
{
    constexpr bool has_result = !std::is_void_v<decltype(stage(0))>;
    const bool meant = i < end;
    if constexpr (is_wide<Stage>) {
        if (i - static_cast<int>(threadIdx.x % 32) / lanes >= end) return 0; // none of the warp's is meant
        const int own = meant ? i : end - 1;
        if constexpr (has_result) {
            const std::int64_t part = stage(own);
            return meant ? part : 0;
        } else {
            stage(own);
        }
    } else if (meant) {
        if constexpr (has_result)
            return stage(i);
        else
            stage(i);
    }
    return 0;
}

/// Calls a stage that collects for some times as many elements side by side as a warp works on at once, below end; at most as many times as
/// there are lanes: all lanes collect for one after the other, and then each finishes one, which takes the warp no longer than one alone.
/// Returns the own one's result.
template <typename Stage> __device__ std::int64_t call_collecting(const Stage& stage, int first_of_warp, int times, int end)
{
    static_assert(is_wide<Stage>);
    if (first_of_warp >= end) return 0;
    const auto element = [&](int k) { return first_of_warp + k * elements_beside + own_element(); }; // side by side: they read the same
    decltype(sum_of(stage.collect(0))) own;
    for (int k = 0; k < times; ++k) {
        const int i = element(k);
        const auto sums = sum_of(stage.collect(i < end ? i : end - 1));
        if (own_lane() == k) own = sums;
    }
    const int i = element(own_lane());
    if (own_lane() >= times || i >= end) return 0;
    if constexpr (std::is_void_v<decltype(stage(0))>)
        stage.finish(i, own);
    else
        return stage.finish(i, own);
    return 0;
}

/// Adds up what the threads of a warp have found, of which groups share an element; the first of each counts.
__device__ inline void add_from_warp(std::int64_t* total, std::int64_t part, int each)
{
    for (int apart = 16; apart >= each; apart /= 2) part += __shfl_down_sync(0xffffffffu, part, apart);
    if (threadIdx.x % 32 == 0 && part != 0) atomic_add(total, part);
}

/// To sort with.
struct SortMemory {
    int* many;   ///< elements of each key; nothing between sorts
    int* number; ///< of each element among those of its key, as they came
    int* member; ///< elements by keys
};

/// Gives each element a place among those of its cell, as they come.
struct CountCells {
    const int* key;
    int* many; ///< of each cell
    int* place;
    HL_FN void operator()(int i) const { place[i] = take_number(many + key[i]); }
    HL_FN static int take_number(int* many)
    {
#ifdef __CUDA_ARCH__
        return atomicAdd(many, 1);
#else
        return (*many)++;
#endif
    }
};

/// Lists the members of each cell, as they came, and leaves the counts at nothing.
struct ListMembers {
    const int* key;
    const int* start;
    const int* place;
    int* many;
    int* member;
    HL_FN void operator()(int i) const
    {
        member[start[key[i]] + place[i]] = i;
        many[key[i]] = 0;
    }
};

/// Brings the members of each cell but the last into their order, which does not depend on who came first.
struct OrderMembers {
    const int* key;
    const int* start;
    const int* place;
    const int* member;
    const int* last;
    int* order;
    HL_FN void operator()(int i) const
    {
        const int cell = key[i], first = start[cell];
        int before = 0;
        if (cell == *last)
            before = place[i];
        else
            for (int k = first, end = start[cell + 1]; k < end; ++k) before += member[k] < i ? 1 : 0;
        order[first + before] = i;
    }
};

} // namespace hygroloom
