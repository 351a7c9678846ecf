// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Memory of a GPU: arrays, and copies of them as they are at one time. Everything goes through the stream of the calling thread.
#pragma once

#include "core/base/error.h"

#include <cuda_runtime.h>

#include <span>
#include <string>
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

template <typename T> __global__ void fill_values(T* values, std::size_t count, T value)
{
    const std::size_t i = std::size_t(blockIdx.x) * blockDim.x + threadIdx.x;
    if (i < count) values[i] = value;
}

/// An array on the GPU; resizing does not keep its values, and gives memory back only to take more: all scenes have to wait for that.
template <typename T> class CudaBuffer {
public:
    CudaBuffer() = default;
    ~CudaBuffer() { cudaFree(data_); }
    CudaBuffer(const CudaBuffer&) = delete;
    CudaBuffer& operator=(const CudaBuffer&) = delete;

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
        if (size_ > 0) fill_values<<<static_cast<unsigned>((size_ + 255) / 256), 256, 0, own_stream>>>(data_, size_, value);
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
    void write(std::size_t index, T value) { copy_to_gpu(data_ + index, &value, sizeof(T)); }
    T* data() { return data_; }
    const T* data() const { return data_; }
    std::size_t size() const { return size_; }
    void swap(CudaBuffer& other)
    {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(room_, other.room_);
    }

private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t room_ = 0; ///< elements that fit
};

/// Arrays as they are at one moment, for the host to read while stages go on: copied on the GPU, which takes next to no time, and
/// fetched from there by who reads them. Where the GPU has no room for that they are fetched at once.
class CudaSnapshot {
public:
    CudaSnapshot() = default;
    ~CudaSnapshot()
    {
        if (pinned_ != nullptr) cudaFreeHost(pinned_);
        if (copied_ != nullptr) cudaEventDestroy(copied_);
        if (stream_ != nullptr) cudaStreamDestroy(stream_);
    }
    CudaSnapshot(const CudaSnapshot&) = delete;
    CudaSnapshot& operator=(const CudaSnapshot&) = delete;

    /// Calls list(look_at), where look_at(array, count) says where the array's first values can be read after fetch(), until the next
    /// call. The list is gone through twice.
    template <typename List> void take(const List& list)
    {
        std::size_t bytes = 0;
        list([&bytes]<typename T>(const CudaBuffer<T>& array, std::size_t count) {
            if (count > 0) bytes += whole_words(array.size() * sizeof(T)); // more of it may be asked for next time
            return std::span<const T>();
        });
        if (bytes > room_) make_room(bytes);
        bytes_ = 0;
        list([this]<typename T>(const CudaBuffer<T>& array, std::size_t count) {
            std::byte* host = on_host() + bytes_;
            if (count > 0) {
                void* to = waits_on_gpu_ ? static_cast<void*>(on_gpu_.data() + bytes_) : host;
                const auto way = waits_on_gpu_ ? cudaMemcpyDeviceToDevice : cudaMemcpyDeviceToHost;
                check_cuda(cudaMemcpyAsync(to, array.data(), count * sizeof(T), way, own_stream), "copying for a frame");
            }
            bytes_ += whole_words(count * sizeof(T));
            return std::span<const T>(reinterpret_cast<const T*>(host), count);
        });
        check_cuda(waits_on_gpu_ ? cudaEventRecord(copied_, own_stream) : cudaStreamSynchronize(own_stream), "copying for a frame");
    }
    /// From now on take() waits for all that it copies.
    void fetch_at_once() { at_once_ = true; }
    /// From any thread. Waits first and copies then: a copy that waits would stand in the way of other scenes' work.
    void fetch()
    {
        if (!waits_on_gpu_) return;
        check_cuda(cudaSetDevice(device_), "choosing it");
        check_cuda(cudaEventSynchronize(copied_), "copying for a frame");
        check_cuda(cudaMemcpyAsync(on_host(), on_gpu_.data(), bytes_, cudaMemcpyDeviceToHost, stream_), "copying a frame");
        check_cuda(cudaStreamSynchronize(stream_), "copying a frame");
    }

private:
    static std::size_t whole_words(std::size_t bytes) { return (bytes + 15) / 16 * 16; }
    std::byte* on_host() { return pinned_ != nullptr ? pinned_ : plain_.data(); }
    void make_room(std::size_t bytes)
    {
        if (stream_ == nullptr) {
            check_cuda(cudaGetDevice(&device_), "asking for its number");
            check_cuda(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "taking a stream");
            check_cuda(cudaEventCreateWithFlags(&copied_, cudaEventBlockingSync | cudaEventDisableTiming), "taking an event");
        }
        room_ = 0;
        plain_ = {};
        if (pinned_ != nullptr) check_cuda(cudaFreeHost(std::exchange(pinned_, nullptr)), "freeing memory");
        if (cudaMallocHost(&pinned_, bytes) != cudaSuccess) {
            cudaGetLastError();
            pinned_ = nullptr;
            plain_.resize(bytes);
        }
        constexpr std::size_t times = 4; // as much has to be free, for what steps may yet need
        std::size_t left = 0, all = 0;
        check_cuda(cudaMemGetInfo(&left, &all), "asking for its memory");
        waits_on_gpu_ = false;
        try {
            if (!at_once_ && left / times > bytes) {
                on_gpu_.resize(bytes);
                waits_on_gpu_ = true;
            }
        } catch (const DeviceError&) { // somebody else took the memory
        }
        room_ = bytes;
    }

    int device_ = 0;
    cudaStream_t stream_ = nullptr; ///< of those who fetch
    cudaEvent_t copied_ = nullptr;  ///< on the GPU
    CudaBuffer<unsigned char> on_gpu_;
    std::byte* pinned_ = nullptr;
    std::vector<std::byte> plain_; ///< where no memory could be pinned
    std::size_t room_ = 0;         ///< bytes
    std::size_t bytes_ = 0;        ///< of what was taken
    bool waits_on_gpu_ = false;    ///< until it is fetched
    bool at_once_ = false;
};

} // namespace hygroloom
