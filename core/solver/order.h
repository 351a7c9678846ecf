// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What every executor understands beside stages: numbers of elements that only stages know, and stages joined to one.
#pragma once

#include "core/base/portable.h"

namespace hygroloom {

/// As many elements as stages find there, up to a most.
struct Counted {
    const int* count;
    int most;
};

/// A stage for executors that have nothing to do.
struct Nothing {
    HL_FN void operator()(int) const {}
};

/// Whether a stage is one of two parts: collect(i) sums over neighbours by lanes, finish(i, sums) does with the sums what takes one lane
/// only, and reads nothing of another lane. What finish() writes no collect() reads, so any order of elements gives the same.
template <typename Stage> constexpr bool collects = requires(const Stage& stage) { stage.collect(0); };

/// One stage after the other on the same element.
template <typename First, typename Second> struct InTurn {
    First first;
    Second second;
    HL_FN void operator()(int i) const
    {
        first(i);
        second(i);
    }
    HL_FN auto collect(int i) const requires collects<Second>
    {
        first(i);
        return second.collect(i);
    }
    template <typename Found> HL_FN void finish(int i, const Found& sums) const { second.finish(i, sums); }
};

/// Whether a stage works on packs of numbers: see lanes.h.
template <typename Stage> constexpr bool is_wide = requires { Stage::wide; };
template <typename First, typename Second> constexpr bool is_wide<InTurn<First, Second>> = (is_wide<First>)&&(is_wide<Second>);

} // namespace hygroloom
