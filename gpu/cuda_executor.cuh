// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs stages on a GPU: each stage is one kernel over its elements. The simplest form; the host waits only where it reads.
#pragma once

#include "core/base/error.h"

#include <cub/device/device_radix_sort.cuh>
#include <cuda_runtime.h>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace hygroloom {

inline void check_cuda(cudaError_t result, const char* what)
{
    if (result != cudaSuccess) throw DeviceError(std::string("The GPU failed (") + what + "): " + cudaGetErrorString(result) + ".");
}

template <typename Stage> __global__ void run_stage(int count, Stage stage)
{
    const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    if (i < count) stage(i);
}

/// The same with a stage that returns something to be added up.
template <typename Stage> __global__ void run_summed(int count, Stage stage, std::int64_t* sum)
{
    const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    std::int64_t part = i < count ? stage(i) : 0;
    for (int apart = 16; apart > 0; apart /= 2) part += __shfl_down_sync(0xffffffffu, part, apart);
    if (threadIdx.x % 32 == 0 && part != 0) atomic_add(sum, part);
}

template <typename T> struct FillStage {
    T* values;
    T value;
    HL_FN void operator()(int i) const { values[i] = value; }
};

struct CountUpStage {
    int* values;
    HL_FN void operator()(int i) const { values[i] = i; }
};

class CudaExecutor {
public:
    /// An array on the GPU; resizing does not keep its values.
    template <typename T> class Buffer {
    public:
        Buffer() = default;
        ~Buffer() { cudaFree(data_); }
        Buffer(const Buffer&) = delete;
        Buffer& operator=(const Buffer&) = delete;

        void resize(std::size_t count)
        {
            if (count == size_) return;
            check_cuda(cudaFree(data_), "freeing memory");
            data_ = nullptr;
            size_ = 0;
            if (count > 0) check_cuda(cudaMalloc(&data_, count * sizeof(T)), "taking memory");
            size_ = count;
            if (count > 0) check_cuda(cudaMemset(data_, 0, count * sizeof(T)), "clearing memory");
        }
        void fill(T value)
        {
            if (size_ > 0)
                run_stage<<<static_cast<unsigned>((size_ + 255) / 256), 256>>>(static_cast<int>(size_), FillStage<T>{data_, value});
            check_cuda(cudaGetLastError(), "filling memory");
        }
        void upload(const std::vector<T>& values)
        {
            resize(values.size());
            write_range(0, values);
        }
        void write_range(std::size_t first, const std::vector<T>& values)
        {
            check_cuda(cudaMemcpy(data_ + first, values.data(), values.size() * sizeof(T), cudaMemcpyHostToDevice), "copying to the GPU");
        }
        std::vector<T> download() const
        {
            std::vector<T> values(size_);
            check_cuda(cudaMemcpy(values.data(), data_, size_ * sizeof(T), cudaMemcpyDeviceToHost), "copying from the GPU");
            return values;
        }
        T read(std::size_t index) const
        {
            T value;
            check_cuda(cudaMemcpy(&value, data_ + index, sizeof(T), cudaMemcpyDeviceToHost), "copying from the GPU");
            return value;
        }
        void write(std::size_t index, T value)
        {
            check_cuda(cudaMemcpy(data_ + index, &value, sizeof(T), cudaMemcpyHostToDevice), "copying to the GPU");
        }
        T* data() { return data_; }
        std::size_t size() const { return size_; }
        void swap(Buffer& other)
        {
            std::swap(data_, other.data_);
            std::swap(size_, other.size_);
        }

    private:
        T* data_ = nullptr;
        std::size_t size_ = 0;
    };

    void set_threads(int) {}

    /// Calls stage(i) for 0 <= i < count and returns the sum of what the stage returns, if anything.
    template <typename Stage> std::int64_t for_each(const char* name, int count, const Stage& stage)
    {
        if (count <= 0) return 0;
        constexpr int block = 128;
        const auto blocks = static_cast<unsigned>((count + block - 1) / block);
        if constexpr (std::is_void_v<decltype(stage(0))>) {
            run_stage<<<blocks, block>>>(count, stage);
            check_cuda(cudaGetLastError(), name);
            return 0;
        } else {
            sum_.resize(1);
            sum_.write(0, 0);
            run_summed<<<blocks, block>>>(count, stage, sum_.data());
            check_cuda(cudaGetLastError(), name);
            return sum_.read(0);
        }
    }

    /// Sorts keys (0 <= key <= largest) keeping equal ones in order; order[i] is where the new i-th came from.
    void sort_by_key(Buffer<int>& keys, Buffer<int>& order, int count, int largest)
    {
        if (count <= 0) return;
        if (count_up_.size() < static_cast<std::size_t>(count)) {
            count_up_.resize(keys.size());
            sorted_.resize(keys.size());
        }
        for_each("count up", count, CountUpStage{count_up_.data()});
        int bits = 1;
        while (bits < 31 && (largest >> bits) != 0) ++bits;
        std::size_t bytes = 0;
        check_cuda(
            cub::DeviceRadixSort::SortPairs(nullptr, bytes, keys.data(), sorted_.data(), count_up_.data(), order.data(), count, 0, bits),
            "sorting");
        if (scratch_.size() < bytes) scratch_.resize(bytes);
        check_cuda(cub::DeviceRadixSort::SortPairs(scratch_.data(), bytes, keys.data(), sorted_.data(), count_up_.data(), order.data(),
                                                   count, 0, bits),
                   "sorting");
        check_cuda(cudaMemcpy(keys.data(), sorted_.data(), static_cast<std::size_t>(count) * sizeof(int), cudaMemcpyDeviceToDevice),
                   "sorting");
    }

private:
    Buffer<int> count_up_, sorted_;
    Buffer<std::int64_t> sum_;
    Buffer<unsigned char> scratch_;
};

} // namespace hygroloom
