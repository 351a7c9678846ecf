// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Goes through an order of stages within one kernel, whose blocks meet after each stage: neither host nor scheduler decides what comes
// next. Such kernels are launched cooperatively, so all blocks of one run at a time, and several scenes' share the GPU.
#pragma once

#include "core/solver/order.h"
#include "gpu/cuda_stages.cuh"

#include <cub/block/block_reduce.cuh>
#include <cub/block/block_scan.cuh>
#include <cuda/atomic>

namespace hygroloom {

/// Of each block: many take turns while others wait for memory, where there is much to do for each; few have more registers and are sooner
/// done with little.
constexpr int many_grid_threads = 1024, few_grid_threads = 512;

/// In the GPU's memory, one for each scene.
struct GridMeeting {
    unsigned came = 0;  ///< blocks, since the last meeting
    unsigned times = 0; ///< that all have met
};

/// What stages within a kernel share.
struct GridMemory {
    GridMeeting* meeting;
    int* sums; ///< of each block
    SortMemory sort;
};

template <int grid_threads> class GridExecutor {
public:
    __device__ explicit GridExecutor(const GridMemory& memory) : memory_(memory), met_(memory.meeting->times) {}

    template <typename Stage, typename Next = Nothing>
    __device__ void for_each(const char*, const Counted& counted, const Stage& stage, const Next& next = {})
    {
        constexpr int threads = threads_each<Stage>(), together = grid_threads / threads;
        const Part part = own_part(counted.count ? *counted.count : counted.most);
        std::int64_t sum = 0;
        if constexpr (collects<Stage>) {
            const int rounds = (part.end - part.first + together - 1) / together, times = rounds < lanes ? rounds : lanes;
            const int first_of_warp = part.first + static_cast<int>(threadIdx.x) / 32 * elements_beside * times;
            for (int first = 0; part.first + first < part.end; first += together * times)
                sum += call_collecting(stage, first_of_warp + first, times, part.end);
        } else {
            const int own = static_cast<int>(threadIdx.x) / threads;
            for (int first = part.first; first < part.end; first += together) sum += call_stage(stage, first + own, part.end);
        }
        if constexpr (!std::is_void_v<decltype(stage(0))>) {
            __syncwarp();
            if (stage.total != nullptr) add_from_warp(stage.total, sum, collects<Stage> ? 1 : threads);
        }
        meet(next);
    }
    template <typename Stage, typename Next = Nothing>
    __device__ void for_each(const char* name, int count, const Stage& stage, const Next& next = {})
    {
        for_each(name, Counted{nullptr, count}, stage, next);
    }
    template <typename Body> __device__ void loop(const Flag* flag, const Body& body)
    {
        while (flag->on) body();
    }
    template <typename Body> __device__ void when(const Flag* flag, const Body& body)
    {
        if (flag->on) body();
    }
    /// See CpuExecutor.
    template <typename FindKey>
    __device__ void sort_into_cells(const FindKey& find_key, const int* key, int* order, int* start, const Counted& counted,
                                    const int* largest)
    {
        const SortMemory& m = memory_.sort;
        for_each("find cell", counted, InTurn<FindKey, CountCells>{find_key, {key, m.many, m.number}});
        add_up(start, *largest + 3);
        for_each("list members", counted, ListMembers{key, start, m.number, m.many, m.member});
        for_each("order members", counted, OrderMembers{key, start, m.number, m.member, largest, order});
    }

private:
    struct Part {
        int first, end;
    };
    /// Elements are side by side, because neighbours read the same.
    __device__ Part own_part(int count) const
    {
        constexpr int least = 32 / lanes; // of a warp
        const int blocks = static_cast<int>(gridDim.x), each = ((count + blocks - 1) / blocks + least - 1) / least * least;
        const int first = static_cast<int>(blockIdx.x) * each;
        return {first, first + each < count ? first + each : count};
    }
    /// Waits until all blocks are there; one thread of the last does what comes next before the others go on.
    template <typename Next> __device__ void meet(const Next& next)
    {
        using Shared = cuda::atomic_ref<unsigned, cuda::thread_scope_device>;
        __syncthreads();
        if (threadIdx.x == 0) {
            const Shared came(memory_.meeting->came), times(memory_.meeting->times);
            ++met_;
            if (came.fetch_add(1, cuda::memory_order_acq_rel) + 1 == gridDim.x) {
                next(0);
                came.store(0, cuda::memory_order_relaxed);
                times.store(met_, cuda::memory_order_release);
            } else {
                while (times.load(cuda::memory_order_acquire) != met_) {}
            }
        }
        __syncthreads();
    }
    /// start[k] = many[0] + ... + many[k - 1] for k below end: each block its part, from the sums of those before.
    __device__ void add_up(int* start, int end)
    {
        using Reduce = cub::BlockReduce<int, grid_threads>;
        using Scan = cub::BlockScan<int, grid_threads>;
        __shared__ union {
            Reduce::TempStorage reduce;
            Scan::TempStorage scan;
        } scratch;
        __shared__ int before_all;
        const int* many = memory_.sort.many;
        const int own = static_cast<int>(threadIdx.x), blocks_before = static_cast<int>(blockIdx.x);
        const Part part = own_part(end);
        int sum = 0;
        for (int k = part.first + own; k < part.end; k += grid_threads) sum += many[k];
        sum = Reduce(scratch.reduce).Sum(sum);
        if (own == 0) memory_.sums[blockIdx.x] = sum;
        meet(Nothing{});
        sum = 0;
        for (int b = own; b < blocks_before; b += grid_threads) sum += memory_.sums[b];
        sum = Reduce(scratch.reduce).Sum(sum);
        if (own == 0) before_all = sum;
        __syncthreads();
        for (int first = part.first, before = before_all; first < part.end; first += grid_threads) {
            const int k = first + own;
            int value = k < part.end ? many[k] : 0, all = 0;
            Scan(scratch.scan).ExclusiveSum(value, value, all);
            if (k < part.end) start[k] = before + value;
            before += all;
            __syncthreads();
        }
        meet(Nothing{});
    }

    const GridMemory& memory_;
    unsigned met_; ///< times that this block has met the others; of its first thread only
};

template <typename Order, int grid_threads>
__global__ void __launch_bounds__(grid_threads)
    go_through_in_grid(const __grid_constant__ Order order, const __grid_constant__ GridMemory memory)
{
    GridExecutor<grid_threads> executor(memory);
    order(executor);
}

} // namespace hygroloom
