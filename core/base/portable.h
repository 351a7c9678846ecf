// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The one place that knows whether this file is being compiled for a CUDA device as well as for the host.
#pragma once

#include <cstdint>

#ifdef __CUDACC__
#define HL_FN __host__ __device__ inline
#define HL_LANES 1
#else
#define HL_FN inline
#define HL_LANES 8
#endif

namespace hygroloom {

/// Number type of the liquid's particles; everything on the yarns is double.
#ifdef HYGROLOOM_DOUBLE
using Real = double;
#else
using Real = float;
#endif

/// Adds to a counter that several elements may share. Integers only, so the order cannot matter.
HL_FN void atomic_add(std::int64_t* target, std::int64_t value)
{
#ifdef __CUDA_ARCH__
    atomicAdd(reinterpret_cast<unsigned long long*>(target), static_cast<unsigned long long>(value));
#else
    __atomic_fetch_add(target, value, __ATOMIC_RELAXED);
#endif
}

HL_FN void atomic_add(int* target, int value)
{
#ifdef __CUDA_ARCH__
    atomicAdd(target, value);
#else
    __atomic_fetch_add(target, value, __ATOMIC_RELAXED);
#endif
}

/// Raises a shared value to the largest one offered.
HL_FN void atomic_max(int* target, int value)
{
#ifdef __CUDA_ARCH__
    atomicMax(target, value);
#else
    int seen = __atomic_load_n(target, __ATOMIC_RELAXED);
    while (value > seen && !__atomic_compare_exchange_n(target, &seen, value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {}
#endif
}

/// Lowers a shared value to the smallest one offered.
HL_FN void atomic_min(int* target, int value)
{
#ifdef __CUDA_ARCH__
    atomicMin(target, value);
#else
    int seen = __atomic_load_n(target, __ATOMIC_RELAXED);
    while (value < seen && !__atomic_compare_exchange_n(target, &seen, value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {}
#endif
}

} // namespace hygroloom
