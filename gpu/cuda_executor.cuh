// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs stages on a GPU: each stage is one kernel over its elements, or over lines with a block of threads each; the host waits only where
// it reads. A sequence of stages is recorded once as a CUDA graph, with its loops and branches as conditional nodes, and replayed.
// Everything goes through the stream of the calling thread, so scenes that run in threads of their own share the GPU and do not wait for
// each other.
#pragma once

#include "core/base/error.h"
#include "core/sim/order.h"
#include "core/sim/team.h"

#include <cub/device/device_radix_sort.cuh>
#include <cuda_runtime.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace hygroloom {

inline void check_cuda(cudaError_t result, const char* what)
{
    if (result != cudaSuccess) throw DeviceError(std::string("The GPU failed (") + what + "): " + cudaGetErrorString(result) + ".");
}

/// Of the calling thread, beside those of all others.
inline const cudaStream_t own_stream = cudaStreamPerThread;

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

template <typename T> struct CopyStage {
    T* to;
    const T* from; ///< null: nothing to copy
    HL_FN void operator()(int i) const
    {
        if (from != nullptr) to[i] = from[i];
    }
};

/// Numbers places before they are sorted; keys that are not meant sort last.
struct PrepareKeys {
    const int* count;
    int* places;
    int* keys;
    int beyond;
    HL_FN void operator()(int i) const
    {
        places[i] = i;
        if (i >= *count) keys[i] = beyond;
    }
};

/// Finds the place of one key in the order of all by counting those before it: the quickest way for few keys, as nothing waits.
struct FindOrder {
    const int* keys;
    const int* count;
    int* order;
    static constexpr bool wide = true;

    HL_FN void operator()(int i) const
    {
        const int own = keys[i], end = *count;
        int before = 0, j = own_lane();
#pragma unroll 8
        for (; j < i; j += lanes) before += keys[j] <= own ? 1 : 0;
#pragma unroll 8
        for (; j < end; j += lanes) before += keys[j] < own ? 1 : 0;
        for (int bit = lanes / 2; bit > 0; bit /= 2) before += of_other_lane(before, bit);
        order[before] = i;
    }
};

class CudaExecutor {
public:
    /// An array on the GPU; resizing does not keep its values, and never gives memory back, for which all scenes would have to wait.
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

    /// Calls stage(i) for 0 <= i < count and adds what it returns, if anything, to its total, if it has one; then next(0).
    template <typename Stage, typename Next = Nothing>
    void for_each(const char* name, const Counted& counted, const Stage& stage, const Next& next = {})
    {
        if (counted.most <= 0) return;
        constexpr int each = threads_each<Stage>(), few = 1 << 16;
        const int block = each == 1 && counted.most < few ? 64 : 128, elements = block / each;
        const auto blocks = static_cast<unsigned>((counted.most + elements - 1) / elements);
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
        if (sequence.graph_ == nullptr) record(sequence, body);
        check_cuda(cudaGraphLaunch(sequence.graph_, stream()), "starting the liquid's steps");
    }
    /// Within a sequence: goes through the body as long as the flag is set.
    template <typename Body> void loop(Flag* flag, const Body& body) { add_condition(flag, cudaGraphCondTypeWhile, body); }
    /// Within a sequence: goes through the body if the flag is set.
    template <typename Body> void when(Flag* flag, const Body& body) { add_condition(flag, cudaGraphCondTypeIf, body); }

    /// The first of each two buffers gets the values of the second, which is left with anything.
    template <typename... Buffers> void take_over(const Counted& counted, Buffers&... buffers)
    {
        for_each("take over", counted, copies(buffers...));
    }

    /// Before the first sort of so many keys.
    void prepare_sort(int count, int largest)
    {
        key_bits_ = 1;
        while (key_bits_ < 31 && ((largest + 1) >> key_bits_) != 0) ++key_bits_;
        places_.resize(static_cast<std::size_t>(count));
        sorted_.resize(static_cast<std::size_t>(count));
        std::size_t bytes = 0;
        check_cuda(cub::DeviceRadixSort::SortPairs(nullptr, bytes, sorted_.data(), sorted_.data(), places_.data(), places_.data(), count, 0,
                                                   key_bits_),
                   "sorting");
        scratch_.resize(bytes);
    }
    /// The order in which keys (0 <= key <= largest) rise, equal ones as they stand: order[i] is the place of the i-th.
    void sort_by_key(Buffer<int>& keys, Buffer<int>& order, const Counted& counted, const int*)
    {
        constexpr int few = 16384;
        if (counted.most <= few) {
            for_each("sort", counted, FindOrder{keys.data(), counted.count, order.data()});
            return;
        }
        for_each("number places", counted.most, PrepareKeys{counted.count, places_.data(), keys.data(), (1 << key_bits_) - 1});
        std::size_t bytes = scratch_.size();
        check_cuda(cub::DeviceRadixSort::SortPairs(scratch_.data(), bytes, keys.data(), sorted_.data(), places_.data(), order.data(),
                                                   counted.most, 0, key_bits_, stream()),
                   "sorting");
    }

private:
    /// A condition that a graph asks for, and where stages find it.
    struct Condition {
        Flag* flag;
        cudaGraphConditionalHandle handle;
    };

    cudaStream_t stream() const { return depth_ == 0 ? own_stream : inner_streams_[depth_ - 1]; }

    template <typename Body> void record(Sequence& sequence, const Body& body)
    {
        conditions_.clear();
        cudaGraph_t graph = nullptr;
        check_cuda(cudaStreamBeginCapture(stream(), cudaStreamCaptureModeRelaxed), "recording");
        body();
        check_cuda(cudaStreamEndCapture(stream(), &graph), "recording");
        check_cuda(cudaGraphInstantiate(&sequence.graph_, graph, 0), "preparing what was recorded");
        check_cuda(cudaGraphDestroy(graph), "recording");
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

    template <typename T, typename... Others> static auto copies(Buffer<T>& to, Buffer<T>& from, Others&... others)
    {
        const CopyStage<T> first{to.data(), from.data()};
        if constexpr (sizeof...(others) == 0)
            return first;
        else
            return InTurn<CopyStage<T>, decltype(copies(others...))>{first, copies(others...)};
    }

    static constexpr int most_depth = 3;
    cudaStream_t inner_streams_[most_depth] = {}; ///< to record in, one for each depth of loops and branches
    int depth_ = 0;
    std::vector<Condition> conditions_;
    Buffer<unsigned> came_; ///< blocks of the kernel that runs: see is_last_block()
    int most_shared_ = 0, processors_ = 0; ///< bytes of shared memory for a block; what blocks run on
    Buffer<double> line_room_;             ///< see LineRoom
    int key_bits_ = 1;
    Buffer<int> places_, sorted_;
    Buffer<unsigned char> scratch_;
};

} // namespace hygroloom
