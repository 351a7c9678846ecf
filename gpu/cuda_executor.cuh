// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs stages on a GPU: each stage is one kernel over its elements, or over lines with a block of threads each; the host waits only where
// it reads. A sequence of stages is recorded once as a CUDA graph, with its loops and branches as conditional nodes, and replayed.
// Everything goes through the stream of the calling thread, so scenes that run in threads of their own share the GPU and do not wait for
// each other.
#pragma once

#include "core/base/error.h"
#include "core/sim/order.h"
#include "core/sim/stage_clock.h"
#include "core/sim/team.h"

#include <cub/block/block_scan.cuh>
#include <cub/device/device_scan.cuh>
#include <cuda_runtime.h>

#include <algorithm>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace hygroloom {

inline void check_cuda(cudaError_t result, const char* what)
{
    if (result == cudaSuccess) return;
    cudaGetLastError(); // or the next who asks would hear of it again
    throw DeviceError(std::string("The GPU failed (") + what + "): " + cudaGetErrorString(result) + ".");
}

/// Of the calling thread, beside those of all others.
inline const cudaStream_t own_stream = cudaStreamPerThread;

/// What is copied may go at once: memory that is not pinned has been read when the call returns.
inline void copy_to_gpu(void* to, const void* from, std::size_t bytes)
{
    check_cuda(cudaMemcpyAsync(to, from, bytes, cudaMemcpyHostToDevice, own_stream), "copying to the GPU");
}

/// Waits for what the stream has been asked for.
inline void copy_from_gpu(void* to, const void* from, std::size_t bytes)
{
    check_cuda(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToHost, own_stream), "copying from the GPU");
    check_cuda(cudaStreamSynchronize(own_stream), "copying from the GPU");
}

/// Threads that share an element.
template <typename Stage> constexpr int threads_each() { return is_wide<Stage> ? lanes : 1; }

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

template <typename Stage, typename Next> __global__ void run_stage(Counted counted, Stage stage, Next next, unsigned* came)
{
    constexpr int each = threads_each<Stage>();
    const int i = static_cast<int>((blockIdx.x * blockDim.x + threadIdx.x) / each);
    const bool meant = i < (counted.count ? *counted.count : counted.most);
    if constexpr (std::is_void_v<decltype(stage(0))>) {
        if (meant) stage(i);
    } else {
        std::int64_t part = meant ? stage(i) : 0;
        if (stage.total != nullptr) {
            for (int apart = 16; apart >= each; apart /= 2) part += __shfl_down_sync(0xffffffffu, part, apart);
            if (threadIdx.x % 32 == 0 && part != 0) atomic_add(stage.total, part);
        }
    }
    if constexpr (!std::is_same_v<Next, Nothing>)
        if (is_last_block(came)) next(0);
}

/// The threads of a block.
struct Block {
    __device__ int size() const { return static_cast<int>(blockDim.x); }
    template <typename F> __device__ void all(const F& f) const
    {
        f(static_cast<int>(threadIdx.x));
        __syncthreads();
    }
    __device__ bool any(bool own) const { return __syncthreads_or(own ? 1 : 0) != 0; }
    __device__ void add(std::int64_t* total, std::int64_t own) const
    {
        for (int apart = 16; apart > 0; apart /= 2) own += __shfl_down_sync(0xffffffffu, own, apart);
        if (threadIdx.x % 32 == 0 && own != 0) atomic_add(total, own);
    }
};

constexpr int least_team = 32, most_team = 512; ///< threads

/// The room of lines that shared memory has no room for; none if it has.
struct LineRoom {
    double* columns; ///< for each block
    int longest;
};

/// A line after the other for each block.
template <typename Stage> __global__ void __launch_bounds__(most_team) run_lines(int lines, LineRoom room, Stage stage)
{
    extern __shared__ double shared[];
    using BlockTeam = Team<Block>;
    double* columns = shared + BlockTeam::per_thread * blockDim.x;
    if (room.columns != nullptr) columns = room.columns + static_cast<std::size_t>(BlockTeam::per_place) * room.longest * blockIdx.x;
    const BlockTeam team(Block{}, columns, room.longest, shared);
    for (int line = static_cast<int>(blockIdx.x); line < lines; line += static_cast<int>(gridDim.x)) stage(team, line);
}

template <typename T> struct FillStage {
    T* values;
    T value;
    HL_FN void operator()(int i) const { values[i] = value; }
};

/// Arrays to copy from one place to another, element sizes in bytes.
struct Copies {
    static constexpr int most = 12;
    void* to[most] = {};
    const void* from[most] = {};
    int size[most] = {};
    int count = 0;
};

constexpr int elements_per_block = 128; // so that a block's part of any array begins where four numbers can be read at once

/// Each block copies its part of each array, whatever its elements are, thread by thread side by side.
__global__ inline void copy_arrays(Counted counted, Copies copies)
{
    const int first = static_cast<int>(blockIdx.x) * elements_per_block, left = *counted.count - first;
    const int elements = left < elements_per_block ? left : elements_per_block;
    if (elements <= 0) return;
    for (int k = 0; k < copies.count; ++k) {
        const std::int64_t begin = std::int64_t(first) * copies.size[k];
        const int bytes = elements * copies.size[k], fours = bytes / 16, words = bytes / 4;
        char* to = static_cast<char*>(copies.to[k]) + begin;
        const char* from = static_cast<const char*>(copies.from[k]) + begin;
        for (int i = static_cast<int>(threadIdx.x); i < fours; i += static_cast<int>(blockDim.x))
            reinterpret_cast<int4*>(to)[i] = reinterpret_cast<const int4*>(from)[i];
        for (int i = 4 * fours + static_cast<int>(threadIdx.x); i < words; i += static_cast<int>(blockDim.x))
            reinterpret_cast<int*>(to)[i] = reinterpret_cast<const int*>(from)[i];
    }
}

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

constexpr int threads_adding_up = 1024;

/// start[k] = many[0] + ... + many[k - 1] for k up to the largest key + 2.
__global__ inline void add_up_in_block(const int* many, int* start, const int* largest)
{
    constexpr int each = 4;
    using Scan = cub::BlockScan<int, threads_adding_up>;
    __shared__ Scan::TempStorage scratch;
    const int end = *largest + 3;
    for (int first = 0, before = 0; first < end; first += each * threads_adding_up) {
        const int own = first + each * static_cast<int>(threadIdx.x);
        int values[each], all = 0;
        for (int k = 0; k < each; ++k) values[k] = own + k < end ? many[own + k] : 0;
        Scan(scratch).ExclusiveSum(values, values, all);
        for (int k = 0; k < each; ++k)
            if (own + k < end) start[own + k] = before + values[k];
        before += all;
        __syncthreads();
    }
}

class CudaExecutor {
public:
    /// An array on the GPU; resizing does not keep its values, and gives memory back only to take more: all scenes have to wait for that.
    template <typename T> class Buffer {
    public:
        Buffer() = default;
        ~Buffer() { cudaFree(data_); }
        Buffer(const Buffer&) = delete;
        Buffer& operator=(const Buffer&) = delete;

        void resize(std::size_t count)
        {
            if (count == size_) return;
            if (count > room_) {
                size_ = room_ = 0;
                check_cuda(cudaFree(std::exchange(data_, nullptr)), "freeing memory");
                check_cuda(cudaMalloc(&data_, count * sizeof(T)), "taking memory");
                room_ = count;
            }
            size_ = count;
            if (count > 0) check_cuda(cudaMemsetAsync(data_, 0, count * sizeof(T), own_stream), "clearing memory");
        }
        void fill(T value)
        {
            if (size_ > 0)
                run_stage<<<static_cast<unsigned>((size_ + 255) / 256), 256, 0, own_stream>>>(
                    {nullptr, static_cast<int>(size_)}, FillStage<T>{data_, value}, Nothing{}, nullptr);
            check_cuda(cudaGetLastError(), "filling memory");
        }
        void upload(const std::vector<T>& values)
        {
            resize(values.size());
            write_range(0, values);
        }
        void write_range(std::size_t first, const std::vector<T>& values)
        {
            copy_to_gpu(data_ + first, values.data(), values.size() * sizeof(T));
        }
        std::vector<T> download() const
        {
            std::vector<T> values(size_);
            copy_from_gpu(values.data(), data_, size_ * sizeof(T));
            return values;
        }
        T read(std::size_t index) const
        {
            T value;
            copy_from_gpu(&value, data_ + index, sizeof(T));
            return value;
        }
        void write(std::size_t index, T value)
        {
            copy_to_gpu(data_ + index, &value, sizeof(T));
        }
        T* data() { return data_; }
        std::size_t size() const { return size_; }
        void swap(Buffer& other)
        {
            std::swap(data_, other.data_);
            std::swap(size_, other.size_);
            std::swap(room_, other.room_);
        }

    private:
        T* data_ = nullptr;
        std::size_t size_ = 0;
        std::size_t room_ = 0; ///< for so many
    };

    CudaExecutor()
    {
        for (cudaStream_t& stream : inner_streams_)
            check_cuda(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), "making a stream");
        came_.resize(1);
        int device = 0;
        check_cuda(cudaGetDevice(&device), "asking for its properties");
        check_cuda(cudaDeviceGetAttribute(&most_shared_, cudaDevAttrMaxSharedMemoryPerBlockOptin, device), "asking for its properties");
        check_cuda(cudaDeviceGetAttribute(&processors_, cudaDevAttrMultiProcessorCount, device), "asking for its properties");
    }
    ~CudaExecutor()
    {
        for (cudaStream_t stream : inner_streams_) cudaStreamDestroy(stream);
    }
    CudaExecutor(const CudaExecutor&) = delete;
    CudaExecutor& operator=(const CudaExecutor&) = delete;

    void set_threads(int) {}

    /// From now on each stage is waited for and what it takes is added up; loops and branches are decided here, and nothing is recorded.
    void time_stages() { stage_clock_ = std::make_unique<StageClock>(); }
    std::vector<StageTime> stage_times() const { return stage_clock_ ? stage_clock_->times() : std::vector<StageTime>(); }

    /// Calls stage(i) for 0 <= i < count and adds what it returns, if anything, to its total, if it has one; then next(0).
    template <typename Stage, typename Next = Nothing>
    void for_each(const char* name, const Counted& counted, const Stage& stage, const Next& next = {})
    {
        if (counted.most <= 0) return;
        constexpr int each = threads_each<Stage>(), few = 1 << 16;
        const int block = each == 1 && counted.most < few ? 64 : 128, elements = block / each;
        const auto blocks = static_cast<unsigned>((counted.most + elements - 1) / elements);
        const Lap lap(stage_clock_.get(), name);
        run_stage<<<blocks, static_cast<unsigned>(block), 0, stream()>>>(counted, stage, next, came_.data());
        check_cuda(cudaGetLastError(), name);
    }
    template <typename Stage, typename Next = Nothing> void for_each(const char* name, int count, const Stage& stage, const Next& next = {})
    {
        for_each(name, Counted{nullptr, count}, stage, next);
    }

    /// Calls stage(team, line) for 0 <= line < lines, none of more than so many places. A team's threads have few places each; elimination
    /// works in shared memory, or where that is too small, in as much of the GPU's as some blocks need.
    template <typename Stage> void for_each_line(const char* name, int lines, int longest, const Stage& stage)
    {
        if (lines <= 0) return;
        constexpr int places_each = 4, blocks_each = 2; // for a thread, for a processor
        int threads = least_team;
        while (threads < most_team && threads * places_each < longest) threads *= 2;
        const std::size_t columns = static_cast<std::size_t>(Team<Block>::per_place) * static_cast<std::size_t>(longest);
        std::size_t bytes = sizeof(double) * static_cast<std::size_t>(Team<Block>::per_thread * threads);
        LineRoom room{nullptr, longest};
        int blocks = lines;
        if (bytes + sizeof(double) * columns <= static_cast<std::size_t>(most_shared_)) {
            bytes += sizeof(double) * columns;
            check_cuda(cudaFuncSetAttribute(run_lines<Stage>, cudaFuncAttributeMaxDynamicSharedMemorySize, most_shared_), name);
        } else {
            blocks = std::min(lines, blocks_each * processors_);
            line_room_.resize(columns * static_cast<std::size_t>(blocks));
            room.columns = line_room_.data();
        }
        const Lap lap(stage_clock_.get(), name);
        run_lines<<<static_cast<unsigned>(blocks), static_cast<unsigned>(threads), bytes, stream()>>>(lines, room, stage);
        check_cuda(cudaGetLastError(), name);
    }

    /// Stages in an order that never changes but by loop() and when().
    class Sequence {
    public:
        Sequence() = default;
        ~Sequence() { forget(); }
        Sequence(const Sequence&) = delete;
        Sequence& operator=(const Sequence&) = delete;
        void forget()
        {
            if (graph_ != nullptr) cudaGraphExecDestroy(graph_);
            graph_ = nullptr;
        }

    private:
        friend class CudaExecutor;
        cudaGraphExec_t graph_ = nullptr;
    };
    /// Does what the body does, which is gone through only the first time.
    template <typename Body> void run(Sequence& sequence, const Body& body)
    {
        if (stage_clock_) return body();
        if (sequence.graph_ == nullptr) record(sequence, body);
        check_cuda(cudaGraphLaunch(sequence.graph_, stream()), "starting the liquid's steps");
    }
    /// Within a sequence: goes through the body as long as the flag is set.
    template <typename Body> void loop(Flag* flag, const Body& body)
    {
        if (!stage_clock_) return add_condition(flag, cudaGraphCondTypeWhile, body);
        while (is_set(flag)) body();
    }
    /// Within a sequence: goes through the body if the flag is set.
    template <typename Body> void when(Flag* flag, const Body& body)
    {
        if (!stage_clock_) return add_condition(flag, cudaGraphCondTypeIf, body);
        if (is_set(flag)) body();
    }

    /// The first of each two buffers gets the values of the second, which is left with anything.
    template <typename... Buffers> void take_over(const Counted& counted, Buffers&... buffers)
    {
        static_assert(sizeof...(buffers) <= 2 * Copies::most);
        Copies copies;
        add_copies(copies, buffers...);
        const Lap lap(stage_clock_.get(), "take over");
        const auto blocks = static_cast<unsigned>((counted.most + elements_per_block - 1) / elements_per_block);
        copy_arrays<<<blocks, 256, 0, stream()>>>(counted, copies);
        check_cuda(cudaGetLastError(), "take over");
    }

    /// Before the first sort of so many keys.
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
    /// The order in which keys (0 <= key <= largest), which a stage finds, rise, equal ones as they stand but for those of the largest:
    /// order[i] is the place of the i-th, and start[key] is where a key begins. start has room for three more.
    template <typename FindKey>
    void sort_into_cells(const FindKey& find_key, Buffer<int>& keys, Buffer<int>& order, Buffer<int>& start, const Counted& counted,
                         const int* largest)
    {
        for_each("find cell", counted, InTurn<FindKey, CountCells>{find_key, {keys.data(), many_.data(), number_.data()}});
        add_up(start, largest);
        for_each("list members", counted, ListMembers{keys.data(), start.data(), number_.data(), many_.data(), member_.data()});
        for_each("order members", counted, OrderMembers{keys.data(), start.data(), number_.data(), member_.data(), largest, order.data()});
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
            if (cudaEventSynchronize(events_[1]) == cudaSuccess && cudaEventElapsedTime(&milliseconds, events_[0], events_[1]) == cudaSuccess)
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
    /// A condition that a graph asks for, and where stages find it.
    struct Condition {
        Flag* flag;
        cudaGraphConditionalHandle handle;
    };

    cudaStream_t stream() const { return depth_ == 0 ? own_stream : inner_streams_[depth_ - 1]; }

    /// Where each key begins, from how many there are of each.
    void add_up(Buffer<int>& start, const int* largest)
    {
        const Lap lap(stage_clock_.get(), "add up");
        constexpr std::size_t few = 1 << 18; // a single block is there first
        if (many_.size() <= few) {
            add_up_in_block<<<1, threads_adding_up, 0, stream()>>>(many_.data(), start.data(), largest);
            return check_cuda(cudaGetLastError(), "sorting");
        }
        std::size_t bytes = scratch_.size();
        check_cuda(
            cub::DeviceScan::ExclusiveSum(scratch_.data(), bytes, many_.data(), start.data(), static_cast<int>(many_.size()), stream()),
            "sorting");
    }
    static bool is_set(const Flag* flag)
    {
        int on = 0;
        copy_from_gpu(&on, &flag->on, sizeof on);
        return on != 0;
    }
    template <typename Body> void record(Sequence& sequence, const Body& body)
    {
        conditions_.clear();
        cudaGraph_t graph = nullptr;
        check_cuda(cudaStreamBeginCapture(stream(), cudaStreamCaptureModeRelaxed), "recording");
        try {
            body();
        } catch (...) {
            for (cudaGraph_t inside = nullptr; depth_ > 0; --depth_) cudaStreamEndCapture(stream(), &inside);
            cudaStreamEndCapture(stream(), &graph);
            if (graph != nullptr) cudaGraphDestroy(graph);
            cudaGetLastError();
            throw;
        }
        check_cuda(cudaStreamEndCapture(stream(), &graph), "recording");
        const cudaError_t prepared = cudaGraphInstantiate(&sequence.graph_, graph, 0);
        cudaGraphDestroy(graph);
        check_cuda(prepared, "preparing what was recorded");
        for (const Condition& condition : conditions_)
            copy_to_gpu(&condition.flag->handle, &condition.handle, sizeof condition.handle);
    }
    /// Puts a condition behind what was recorded last, and records its body in a stream of its own.
    template <typename Body> void add_condition(Flag* flag, cudaGraphConditionalNodeType type, const Body& body)
    {
        cudaStreamCaptureStatus status;
        cudaGraph_t graph = nullptr, inside = nullptr;
        const cudaGraphNode_t* before = nullptr;
        const cudaGraphEdgeData* edges = nullptr;
        std::size_t count = 0;
        check_cuda(cudaStreamGetCaptureInfo(stream(), &status, nullptr, &graph, &before, &edges, &count), "recording");
        cudaGraphNodeParams parameters{};
        parameters.type = cudaGraphNodeTypeConditional;
        parameters.conditional.type = type;
        parameters.conditional.size = 1;
        check_cuda(cudaGraphConditionalHandleCreate(&parameters.conditional.handle, graph), "recording a condition");
        cudaGraphNode_t node = nullptr;
        check_cuda(cudaGraphAddNode(&node, graph, before, edges, count, &parameters), "recording a condition");
        check_cuda(cudaStreamUpdateCaptureDependencies(stream(), &node, nullptr, 1, cudaStreamSetCaptureDependencies), "recording");
        conditions_.push_back({flag, parameters.conditional.handle});
        ++depth_;
        check_cuda(cudaStreamBeginCaptureToGraph(stream(), parameters.conditional.phGraph_out[0], nullptr, nullptr, 0,
                                                 cudaStreamCaptureModeRelaxed),
                   "recording");
        body();
        check_cuda(cudaStreamEndCapture(stream(), &inside), "recording");
        --depth_;
    }

    template <typename T, typename... Others> static void add_copies(Copies& copies, Buffer<T>& to, Buffer<T>& from, Others&... others)
    {
        static_assert(sizeof(T) % 4 == 0);
        if (from.size() > 0) {
            copies.to[copies.count] = to.data();
            copies.from[copies.count] = from.data();
            copies.size[copies.count++] = sizeof(T);
        }
        if constexpr (sizeof...(others) > 0) add_copies(copies, others...);
    }

    static constexpr int most_depth = 3;
    cudaStream_t inner_streams_[most_depth] = {}; ///< to record in, one for each depth of loops and branches
    int depth_ = 0;
    std::vector<Condition> conditions_;
    Buffer<unsigned> came_; ///< blocks of the kernel that runs: see is_last_block()
    std::unique_ptr<StageClock> stage_clock_; ///< none: nothing is timed
    int most_shared_ = 0, processors_ = 0; ///< bytes of shared memory for a block; what blocks run on
    Buffer<double> line_room_;             ///< see LineRoom
    // To sort with.
    Buffer<int> many_;   ///< elements of each key; nothing between sorts
    Buffer<int> number_; ///< of each element among those of its key, as they came
    Buffer<int> member_; ///< elements by keys
    Buffer<unsigned char> scratch_;
};

} // namespace hygroloom
