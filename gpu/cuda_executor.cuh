// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs stages on a GPU: each stage is one kernel over its elements, or over lines with a block of threads each; the host waits only where
// it reads. An order of stages that decide loops and branches is gone through within one kernel: see grid_executor.cuh.
// Everything goes through the stream of the calling thread, so scenes that run in threads of their own share the GPU and do not wait for
// each other.
#pragma once

#include "core/solver/order.h"
#include "core/solver/stage_clock.h"
#include "core/solver/team.h"
#include "gpu/cuda_memory.cuh"
#include "gpu/cuda_stages.cuh"
#include "gpu/grid_executor.cuh"

#include <cub/device/device_scan.cuh>
#include <cuda_runtime.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <type_traits>
#include <vector>

namespace hygroloom {

/// Whether this is the last block of a kernel to come here: what all others did can be seen then.
__device__ inline bool is_last_block(unsigned* came)
{
    __syncthreads();
    if (threadIdx.x != 0) return false;
    __threadfence();
    if (atomicAdd(came, 1u) + 1 < gridDim.x) return false;
    *came = 0;
    __threadfence();
    return true;
}

template <typename Stage, typename Next>
__device__ inline void call_for_threads(const Counted& counted, int times, const Stage& stage, const Next& next, unsigned* came)
{
    constexpr int threads = threads_each<Stage>();
    const int own = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x), end = counted.count ? *counted.count : counted.most;
    std::int64_t part = 0;
    if constexpr (collects<Stage>)
        part = call_collecting(stage, own / 32 * elements_beside * times, times, end);
    else
        part = call_stage(stage, own / threads, end);
    if constexpr (!std::is_void_v<decltype(stage(0))>) {
        __syncwarp();
        if (stage.total != nullptr) add_from_warp(stage.total, part, collects<Stage> ? 1 : threads);
    }
    if constexpr (!std::is_same_v<Next, Nothing>)
        if (is_last_block(came)) next(0);
}

template <typename Stage, typename Next> __global__ void run_stage(Counted counted, int times, Stage stage, Next next, unsigned* came)
{
    call_for_threads(counted, times, stage, next, came);
}

constexpr int usual_block = 128; ///< threads

/// With no more registers than leave room for blocks_beside of them.
template <typename Stage, typename Next>
__global__ void __launch_bounds__(usual_block, blocks_beside<Stage>)
    run_bounded_stage(Counted counted, int times, Stage stage, Next next, unsigned* came)
{
    call_for_threads(counted, times, stage, next, came);
}

/// The threads of a block.
struct Block {
    __device__ int size() const { return static_cast<int>(blockDim.x); }
    template <typename F> __device__ void all(const F& f) const
    {
        f(static_cast<int>(threadIdx.x));
        __syncthreads();
    }
    template <typename F> __device__ bool any(const F& f) const { return __syncthreads_or(f(static_cast<int>(threadIdx.x)) ? 1 : 0) != 0; }
    __device__ void add(std::int64_t* total, std::int64_t own) const { add_from_warp(total, own, 1); }
};

constexpr int least_team = 32; ///< threads
/// What solves pairs has so many numbers under way that more threads would have too few registers.
template <typename Stage> constexpr int most_team = columns_of<Stage> > 0 ? 256 : 512;
/// Of the largest teams, on a processor.
template <typename Stage> constexpr int teams_beside = columns_of<Stage> > 0 ? 1 : 2;
/// For a thread to go through. What solves pairs has so much to do at each that a thread for each pays off.
template <typename Stage> constexpr int places_each = columns_of<Stage> > 0 ? 1 : 4;

/// The room of lines that shared memory has no room for; none if it has.
struct LineRoom {
    double* columns; ///< for each block
    int longest;
};

/// A line after the other for each block.
template <typename Stage>
__global__ void __launch_bounds__(most_team<Stage>, teams_beside<Stage>) run_lines(int lines, LineRoom room, Stage stage)
{
    extern __shared__ double shared[];
    using BlockTeam = Team<Block>;
    const LineNumbers numbers = line_numbers_of(stage);
    const auto threads = static_cast<int>(blockDim.x);
    double* columns = shared + BlockTeam::links_room(numbers, threads);
    if (room.columns != nullptr) columns = room.columns + BlockTeam::room(numbers, room.longest, threads) * blockIdx.x;
    const BlockTeam team(Block{}, numbers, columns, room.longest, shared);
    for (int line = static_cast<int>(blockIdx.x); line < lines; line += static_cast<int>(gridDim.x)) stage(team, line);
}

class CudaExecutor {
public:
    template <typename T> using Buffer = CudaBuffer<T>;
    using Snapshot = CudaSnapshot;

    CudaExecutor()
    {
        came_.resize(1);
        check_cuda(cudaGetDevice(&device_), "asking for its properties");
        const auto ask = [this](int& answer, cudaDeviceAttr about) {
            check_cuda(cudaDeviceGetAttribute(&answer, about, device_), "asking for its properties");
        };
        ask(most_shared_, cudaDevAttrMaxSharedMemoryPerBlockOptin);
        ask(processors_, cudaDevAttrMultiProcessorCount);
        ask(cooperates_, cudaDevAttrCooperativeLaunch);
        check_cuda(cudaEventCreateWithFlags(&stepped_, cudaEventBlockingSync | cudaEventDisableTiming), "taking an event");
        meeting_.resize(1);
        sums_.resize(static_cast<std::size_t>(processors_));
        ++scenes_on(device_).loaded;
    }
    ~CudaExecutor()
    {
        --scenes_on(device_).loaded;
        cudaEventDestroy(stepped_);
    }
    CudaExecutor(const CudaExecutor&) = delete;
    CudaExecutor& operator=(const CudaExecutor&) = delete;

    void set_threads(int) {}

    /// From now on each stage is waited for and what it takes is added up; orders are gone through from here.
    void time_stages() { stage_clock_ = std::make_unique<StageClock>(); }
    std::vector<StageTime> stage_times() const { return stage_clock_ ? stage_clock_->times() : std::vector<StageTime>(); }

    /// Calls stage(i) for 0 <= i < count and adds what it returns, if anything, to its total, if it has one; then next(0).
    template <typename Stage, typename Next = Nothing>
    void for_each(const char* name, const Counted& counted, const Stage& stage, const Next& next = {})
    {
        if (counted.most <= 0) return;
        if constexpr (stands_apart<Stage>) {
            for_each(name, counted, stage.first);
            for_each(name, counted, stage.second, next);
        } else {
            constexpr int threads = threads_each<Stage>(), few = 1 << 16, threads_of_processor = 2048;
            // As many times as leave enough to do for all threads at once.
            const int times = collects<Stage> ? std::clamp(counted.most / (processors_ * threads_of_processor / threads), 1, lanes) : 1;
            const int block = threads == 1 && counted.most < few ? 64 : usual_block, elements = block / threads * times;
            const auto blocks = static_cast<unsigned>((counted.most + elements - 1) / elements);
            const Lap lap(stage_clock_.get(), name);
            constexpr auto kernel = [] {
                if constexpr (constexpr int beside = blocks_beside<Stage>; beside > 0)
                    return run_bounded_stage<Stage, Next>;
                else
                    return run_stage<Stage, Next>;
            }();
            kernel<<<blocks, static_cast<unsigned>(block), 0, own_stream>>>(counted, times, stage, next, came_.data());
            check_cuda(cudaGetLastError(), name);
        }
    }
    template <typename Stage, typename Next = Nothing> void for_each(const char* name, int count, const Stage& stage, const Next& next = {})
    {
        for_each(name, Counted{nullptr, count}, stage, next);
    }

    /// Calls stage(team, line) for 0 <= line < lines, none of more places than the longest. A team's threads have few places each;
    /// elimination works in shared memory, or where that is too small, in as much of the GPU's as some blocks need.
    template <typename Stage> void for_each_line(const char* name, int lines, int longest, const Stage& stage)
    {
        if (lines <= 0) return;
        int threads = least_team;
        while (threads < most_team<Stage> && threads * places_each<Stage> < longest) threads *= 2;
        const LineNumbers numbers = line_numbers_of(stage);
        const std::size_t columns = Team<Block>::room(numbers, longest, threads);
        std::size_t bytes = sizeof(double) * static_cast<std::size_t>(Team<Block>::links_room(numbers, threads));
        LineRoom room{nullptr, longest};
        int blocks = lines;
        if (bytes + sizeof(double) * columns <= static_cast<std::size_t>(most_shared_)) {
            bytes += sizeof(double) * columns;
        } else {
            blocks = std::min(lines, teams_beside<Stage> * processors_);
            line_room_.resize(columns * static_cast<std::size_t>(blocks));
            room.columns = line_room_.data();
        }
        check_cuda(cudaFuncSetAttribute(run_lines<Stage>, cudaFuncAttributeMaxDynamicSharedMemorySize, most_shared_), name);
        const Lap lap(stage_clock_.get(), name);
        run_lines<<<static_cast<unsigned>(blocks), static_cast<unsigned>(threads), bytes, own_stream>>>(lines, room, stage);
        check_cuda(cudaGetLastError(), name);
    }

    /// Goes through an order of stages that decide loops and branches; over at most this number of elements. Returns the seconds that took,
    /// without waiting for its turn.
    template <typename Order> double go_through(const Order& order, int most)
    {
        const auto seconds_since = [](auto start) {
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        };
        const int all = blocks_that_fit<Order>(most);
        if (all == 0) {
            const auto start = std::chrono::steady_clock::now();
            order(*this);
            return seconds_since(start);
        }
        Scenes& scenes = scenes_on(device_);
        constexpr int least_blocks = 8; // with fewer, scenes are slower side by side than in turn
        const Turn turn(scenes, std::max(1, all / least_blocks));
        const int together = turn.together();
        const auto start = std::chrono::steady_clock::now();
        const int share = std::max(1, all / together);
        constexpr int several_rounds = 4;
        if (most * lanes > several_rounds * share * few_grid_threads)
            start_in_grid<many_grid_threads>(order, most, share);
        else
            start_in_grid<few_grid_threads>(order, most, share);
        // A copy that waits would stand in the way of other scenes' work, which comes through the same queues. And with several scenes,
        // threads that look again and again would keep each other from the processors.
        check_cuda(cudaEventRecord(stepped_, own_stream), "the liquid's steps");
        check_cuda(together > 1 ? cudaEventSynchronize(stepped_) : cudaStreamSynchronize(own_stream), "the liquid's steps");
        return seconds_since(start);
    }
    /// Within an order gone through from here: goes through the body as long as the flag is set.
    template <typename Body> void loop(const Flag* flag, const Body& body)
    {
        while (is_set(flag)) body();
    }
    /// The same: goes through the body if the flag is set.
    template <typename Body> void when(const Flag* flag, const Body& body)
    {
        if (is_set(flag)) body();
    }

    /// Before the first sort; the most keys that there will be.
    void prepare_sort(int count, int largest)
    {
        many_.resize(static_cast<std::size_t>(largest) + 3);
        many_.fill(0);
        number_.resize(static_cast<std::size_t>(count));
        member_.resize(static_cast<std::size_t>(count));
        std::size_t bytes = 0;
        check_cuda(cub::DeviceScan::ExclusiveSum(nullptr, bytes, many_.data(), many_.data(), static_cast<int>(many_.size())), "sorting");
        scratch_.resize(bytes);
    }
    /// See CpuExecutor.
    template <typename FindKey>
    void sort_into_cells(const FindKey& find_key, const int* key, int* order, int* start, const Counted& counted, const int* largest)
    {
        const SortMemory m = sort_memory();
        for_each("find cell", counted, InTurn<FindKey, CountCells>{find_key, {key, m.many, m.number}});
        {
            const Lap lap(stage_clock_.get(), "add up");
            std::size_t bytes = scratch_.size();
            const auto keys = static_cast<int>(many_.size());
            check_cuda(cub::DeviceScan::ExclusiveSum(scratch_.data(), bytes, m.many, start, keys, own_stream), "sorting");
        }
        for_each("list members", counted, ListMembers{key, start, m.number, m.many, m.member});
        for_each("order members", counted, OrderMembers{key, start, m.number, m.member, largest, order});
    }

private:
    /// The GPU's time between its beginning and its end, for a clock; without one it does nothing.
    class Lap {
    public:
        Lap(StageClock* clock, const char* name) : clock_(clock), name_(name)
        {
            if (clock_ == nullptr) return;
            for (cudaEvent_t& event : events_) check_cuda(cudaEventCreate(&event), "timing");
            check_cuda(cudaEventRecord(events_[0], own_stream), "timing");
        }
        ~Lap()
        {
            if (clock_ == nullptr) return;
            float milliseconds = 0;
            cudaEventRecord(events_[1], own_stream);
            if (cudaEventSynchronize(events_[1]) == cudaSuccess &&
                cudaEventElapsedTime(&milliseconds, events_[0], events_[1]) == cudaSuccess)
                clock_->add(name_, 1e-3 * static_cast<double>(milliseconds));
            for (cudaEvent_t event : events_) cudaEventDestroy(event);
        }
        Lap(const Lap&) = delete;
        Lap& operator=(const Lap&) = delete;

    private:
        StageClock* clock_;
        const char* name_;
        cudaEvent_t events_[2] = {};
    };
    /// That share a GPU.
    struct Scenes {
        std::atomic<int> loaded = 0;
        std::mutex mutex;
        std::condition_variable one_less;
        int running = 0; ///< whose steps are in one kernel
    };
    /// To run beside at most this number, or as many as there are.
    class Turn {
    public:
        Turn(Scenes& scenes, int most) : scenes_(scenes)
        {
            std::unique_lock lock(scenes.mutex);
            scenes.one_less.wait(lock, [&] { return scenes.running < (together_ = std::min(most, scenes.loaded.load())); });
            ++scenes.running;
        }
        ~Turn()
        {
            {
                const std::lock_guard lock(scenes_.mutex);
                --scenes_.running;
            }
            scenes_.one_less.notify_all();
        }
        Turn(const Turn&) = delete;
        Turn& operator=(const Turn&) = delete;

        int together() const { return together_; }

    private:
        Scenes& scenes_;
        int together_ = 1; ///< scenes that run side by side
    };
    /// Of more than 64 GPUs some count together.
    static Scenes& scenes_on(int device)
    {
        static Scenes scenes[64];
        return scenes[device % 64];
    }
    /// Of a kernel that goes through an order, on the whole GPU; 0: its stages are better started one by one.
    template <typename Order> int blocks_that_fit(int most) const
    {
        constexpr int many = 50000; // with as many threads as each stage can have
        if (stage_clock_ || !cooperates_ || most > many) return 0;
        return fits_in_grid<Order, few_grid_threads>() && fits_in_grid<Order, many_grid_threads>() ? processors_
                                                                                                   : 0; // one on each fills it
    }
    template <typename Order, int threads> static bool fits_in_grid()
    {
        int fit = 0;
        check_cuda(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&fit, go_through_in_grid<Order, threads>, threads, 0),
                   "asking for its room");
        return fit > 0;
    }
    template <int threads, typename Order> void start_in_grid(const Order& order, int most, int share)
    {
        GridMemory memory{meeting_.data(), sums_.data(), sort_memory()};
        void* arguments[] = {const_cast<Order*>(&order), &memory};
        const dim3 grid(static_cast<unsigned>(std::min(share, (most * lanes + threads - 1) / threads))), block(threads);
        check_cuda(cudaLaunchCooperativeKernel(go_through_in_grid<Order, threads>, grid, block, arguments, 0, own_stream),
                   "starting the steps");
    }
    SortMemory sort_memory() { return {many_.data(), number_.data(), member_.data()}; }
    static bool is_set(const Flag* flag)
    {
        int on = 0;
        copy_from_gpu(&on, &flag->on, sizeof on);
        return on != 0;
    }

    int device_ = 0;
    int most_shared_ = 0;                     ///< bytes of shared memory for a block
    int processors_ = 0;                      ///< that blocks run on
    int cooperates_ = 0;                      ///< whether all blocks of a kernel can be had at a time
    Buffer<unsigned> came_;                   ///< blocks of the kernel that runs: see is_last_block()
    std::unique_ptr<StageClock> stage_clock_; ///< none: nothing is timed
    Buffer<double> line_room_;                ///< see LineRoom
    cudaEvent_t stepped_ = nullptr;           ///< the end of a kernel that goes through an order
    Buffer<GridMeeting> meeting_;             ///< see GridMemory
    Buffer<int> sums_;                        ///< the same
    Buffer<int> many_, number_, member_;      ///< see SortMemory
    Buffer<unsigned char> scratch_;           ///< to add up with
};

} // namespace hygroloom
