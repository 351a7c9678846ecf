// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Tables of a running scene's arrays. Each state (segments, particles) is one struct template over the kind of array, with one table,
// each(), that visits every array: buffers are sized, seen by stages, sorted, saved and shown by it.
#pragma once

#include <span>

namespace hygroloom {

/// What a table says of an array, beside its elements' type. Count: how many elements there are, by a rule of the state's own.
template <typename Count> struct Field {
    const char* name;
    const char* unit; ///< SI; "1" for numbers without one
    Count count;
    bool saved = false; ///< the next step needs it and does not find it anew: part of the state that another solver goes on from
    bool shown = false; ///< frames and ledgers are made from it
};

// Kinds of array, beside an executor's buffers.
template <typename T> using Pointer = T*;               ///< as stages see it
template <typename T> using Shown = std::span<const T>; ///< as frames are made from it; empty where it is not shown

} // namespace hygroloom
