// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The one place that knows whether this file is being compiled for a CUDA device as well as for the host.
#pragma once

#include <cmath>
#include <cstdint>

#ifdef __CUDACC__
#define HL_FN __host__ __device__ inline
#define HL_SELDOM __host__ __device__ __noinline__ // called so seldom that its registers should cost nobody else
#define HL_LANE_IS_THREAD 1
#define HL_PRAGMA(text) _Pragma(#text)
#define HL_UNROLL(times) HL_PRAGMA(unroll times) // of a loop whose loads are better under way together
#define HL_UNROLL_WHOLE
#else
#define HL_FN inline
#define HL_SELDOM [[gnu::noinline]]
#define HL_LANE_IS_THREAD 0
#define HL_UNROLL(times)
#define HL_UNROLL_WHOLE _Pragma("GCC unroll 16") // of a short loop: -O2 would leave it, and keep what it goes through in memory
#endif

// What depends on Real is compiled for both number types and stands in a namespace for each, so that both fit into one program.
#ifdef HYGROLOOM_DOUBLE
#define HL_PRECISION in_double
#else
#define HL_PRECISION in_single
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
    if (value > *static_cast<volatile int*>(target)) atomicMax(target, value); // most come too late to matter
#else
    int seen = __atomic_load_n(target, __ATOMIC_RELAXED);
    while (value > seen && !__atomic_compare_exchange_n(target, &seen, value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {}
#endif
}

/// The same, for a target that very many elements share: reading it would be the bottleneck, so a warp reads it once, from its
/// processor's cache.
HL_FN void atomic_max_of_many(int* target, int value)
{
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ >= 800
    const unsigned together = __activemask();
    const int most = __reduce_max_sync(together, value);
    if (static_cast<int>(threadIdx.x % 32) == __ffs(static_cast<int>(together)) - 1 && most > __ldca(target)) atomicMax(target, most);
#else
    atomic_max(target, value);
#endif
}

/// The same, where all elements share the target.
HL_FN void atomic_max_of_all(int* target, int value)
{
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ >= 800
    const unsigned together = __activemask();
    const int most = __reduce_max_sync(together, value);
    if (static_cast<int>(threadIdx.x % 32) != __ffs(static_cast<int>(together)) - 1) return;
    constexpr unsigned many_blocks = 1024; // among which most come too late to matter, so that waiting for the value pays
    if (gridDim.x < many_blocks || most > *static_cast<volatile int*>(target)) atomicMax(target, most);
#else
    atomic_max(target, value);
#endif
}

/// The same for several targets side by side.
template <int count> HL_FN void atomic_max_of_all(int* targets, const int (&values)[count])
{
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ >= 800
    const unsigned together = __activemask(), before = (1u << threadIdx.x % 32) - 1;
    const int own = __popc(together & before);
    if (__popc(together) >= count) { // a target for each thread
        int most = 0;
        for (int k = 0; k < count; ++k) {
            const int most_of_all = __reduce_max_sync(together, values[k]);
            if (own == k) most = most_of_all;
        }
        if (own < count && most > __ldca(targets + own)) atomicMax(targets + own, most); // at what its processor has last seen there
        return;
    }
#endif
    for (int k = 0; k < count; ++k) atomic_max(targets + k, values[k]);
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

/// Reciprocal and square root of doubles that are neither tiny nor huge; on a GPU to some 2^-52 of them, without the
/// branch for the others and the last rounding, which take half of the time.
HL_FN double plain_inverse(double value)
{
#ifdef __CUDA_ARCH__
    double close;
    asm("rcp.approx.ftz.f64 %0, %1;" : "=d"(close) : "d"(value));
    const double error = __fma_rn(-value, close, 1.0);
    return __fma_rn(close, __fma_rn(error, error, error), close); // what is left goes with the error's cube
#else
    return 1.0 / value;
#endif
}
HL_FN double plain_root(double value)
{
#ifdef __CUDA_ARCH__
    double inverse;
    asm("rsqrt.approx.ftz.f64 %0, %1;" : "=d"(inverse) : "d"(value));
    const double close = value > 0 ? value * inverse : 0.0, error = __fma_rn(-close, inverse, 1.0);
    return value > 0 ? __fma_rn(close, error * __fma_rn(0.375, error, 0.5), close) : 0.0;
#else
    return std::sqrt(value);
#endif
}
/// Reciprocal for slopes, by which an iteration only goes on: on a GPU to some 2^-20.
HL_FN double near_inverse(double value)
{
#ifdef __CUDA_ARCH__
    double close;
    asm("rcp.approx.ftz.f64 %0, %1;" : "=d"(close) : "d"(value));
    return close;
#else
    return 1.0 / value;
#endif
}

/// Lanes of a pack: see lanes.h. On a GPU as many threads side by side share an element, a lane each.
constexpr int lanes = 8;

HL_FN int own_lane()
{
#ifdef __CUDA_ARCH__
    return static_cast<int>(threadIdx.x % lanes);
#else
    return 0;
#endif
}

/// Elements that a warp works on at once.
constexpr int elements_beside = HL_LANE_IS_THREAD ? 32 / lanes : 1;

HL_FN int own_element()
{
#ifdef __CUDA_ARCH__
    return static_cast<int>(threadIdx.x % 32) / lanes;
#else
    return 0;
#endif
}

#if HL_LANE_IS_THREAD

HL_FN void fetch_four(const float* at, float& x, float& y, float& z, float& w)
{
#ifdef __CUDA_ARCH__
    const float4 four = *reinterpret_cast<const float4*>(at);
    x = four.x, y = four.y, z = four.z, w = four.w;
#else
    x = at[0], y = at[1], z = at[2], w = at[3];
#endif
}
HL_FN void fetch_four(const double* at, double& x, double& y, double& z, double& w) { x = at[0], y = at[1], z = at[2], w = at[3]; }

/// Square root, reciprocal and quotient as IEEE rounds them, for numbers that are neither tiny nor huge, and 0. Without the branch for the
/// others, which keeps a GPU from having several under way.
HL_FN float plain_root(float value)
{
#ifdef __CUDA_ARCH__
    float inverse;
    asm("rsqrt.approx.ftz.f32 %0, %1;" : "=f"(inverse) : "f"(value));
    const float close = value * inverse, error = __fmaf_rn(-close, close, value);
    return value > 0 ? __fmaf_rn(error, 0.5f * inverse, close) : 0.0f;
#else
    return std::sqrt(value);
#endif
}
HL_FN float plain_inverse(float value)
{
#ifdef __CUDA_ARCH__
    float close;
    asm("rcp.approx.ftz.f32 %0, %1;" : "=f"(close) : "f"(value));
    return __fmaf_rn(close, __fmaf_rn(-value, close, 1.0f), close);
#else
    return 1.0f / value;
#endif
}
HL_FN float plain_quotient(float a, float b)
{
#ifdef __CUDA_ARCH__
    const float inverse = plain_inverse(b), close = a * inverse;
    return __fmaf_rn(inverse, __fmaf_rn(-b, close, a), close);
#else
    return a / b;
#endif
}
/// 1 / root; on a GPU to 2^-22.9 of it, about twice what a product is rounded to.
HL_FN float plain_inverse_root(float value)
{
#ifdef __CUDA_ARCH__
    float inverse;
    asm("rsqrt.approx.ftz.f32 %0, %1;" : "=f"(inverse) : "f"(value));
    return inverse;
#else
    return 1.0f / std::sqrt(value);
#endif
}
HL_FN double plain_inverse_root(double value) { return 1.0 / std::sqrt(value); }
HL_FN double plain_quotient(double a, double b) { return a / b; }

// Warp shuffles. All 32 lanes must reach each shuffle: stages that work on packs are called by whole warps and use no shuffle on a branch
// that only some of the lanes take.
#ifdef __CUDA_ARCH__
constexpr unsigned whole_warp = 0xffffffffu;
#endif

/// What any of a warp's threads has read before is what stood there before any writes on.
HL_FN void wait_for_warp()
{
#ifdef __CUDA_ARCH__
    __syncwarp();
#endif
}

/// What the lane has whose number differs in the given bit.
template <typename T> HL_FN T of_other_lane(T value, int bit)
{
#ifdef __CUDA_ARCH__
    return __shfl_xor_sync(whole_warp, value, bit);
#else
    return bit > 0 ? value : T{};
#endif
}

HL_FN int of_lane(int value, int lane)
{
#ifdef __CUDA_ARCH__
    return __shfl_sync(whole_warp, value, lane, lanes);
#else
    return lane >= 0 ? value : 0;
#endif
}

/// Of the values of this lane and those before it.
HL_FN int sum_up_to_lane(int value)
{
#ifdef __CUDA_ARCH__
    for (int apart = 1; apart < lanes; apart *= 2) {
        const int before = __shfl_up_sync(whole_warp, value, apart, lanes);
        if (own_lane() >= apart) value += before;
    }
#endif
    return value;
}

/// One bit per thread of the warp, of those that share the element.
HL_FN unsigned lanes_where(bool condition)
{
#ifdef __CUDA_ARCH__
    return __ballot_sync(whole_warp, condition) & (((1u << lanes) - 1u) << (threadIdx.x % 32 / lanes * lanes));
#else
    return condition ? 1u : 0u;
#endif
}
/// Of such bits, those of lanes before the own one.
HL_FN unsigned before_own(unsigned bits)
{
#ifdef __CUDA_ARCH__
    return bits & ((1u << threadIdx.x % 32) - 1u);
#else
    return bits & 0u;
#endif
}

/// What the threads of an element of the same warp have.
HL_FN Real of_element(Real value, int element)
{
#ifdef __CUDA_ARCH__
    return __shfl_sync(whole_warp, value, element * lanes);
#else
    return element >= 0 ? value : Real(0);
#endif
}

/// One bit per element of the warp.
HL_FN unsigned elements_where(bool condition)
{
#ifdef __CUDA_ARCH__
    const unsigned all = __ballot_sync(whole_warp, condition);
    unsigned bits = 0;
    for (int element = 0; element < elements_beside; ++element) bits |= (all >> (element * lanes) & 1u) << element;
    return bits;
#else
    return condition ? 1u : 0u;
#endif
}

/// Of what all elements of a warp have.
HL_FN int largest_beside(int value)
{
#ifdef __CUDA_ARCH__
    for (int apart = 16; apart >= lanes; apart /= 2) {
        const int other = __shfl_xor_sync(whole_warp, value, apart);
        value = other > value ? other : value;
    }
#endif
    return value;
}

HL_FN int lowest_bit(unsigned bits)
{
#ifdef __CUDA_ARCH__
    return __ffs(static_cast<int>(bits)) - 1;
#else
    return __builtin_ctz(bits);
#endif
}
HL_FN int bits_in(unsigned bits)
{
#ifdef __CUDA_ARCH__
    return __popc(bits);
#else
    return __builtin_popcount(bits);
#endif
}
#endif

/// What a stage decides and a loop or a branch in the order of stages obeys.
struct Flag {
    int on = 0;
};

} // namespace hygroloom
