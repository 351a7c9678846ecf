// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Stands in where this build has no CUDA.
#include "core/base/error.h"
#include "gpu/cuda_backend.h"
#include "gpu/missing_gpu.h"

namespace hygroloom {

std::vector<BackendInfo> find_cuda_devices()
{
    const bool card = gpu_surroundings("/").card;
    return {{"cuda", "", false,
             card ? "This build has no CUDA. For this machine's GPU, build it with the CUDA Toolkit." : "This build has no CUDA."}};
}

std::unique_ptr<Backend> make_cuda_backend(int) { throw DeviceError("This build has no CUDA."); }

std::size_t prepare_cuda_device(int, bool) { throw DeviceError("This build has no CUDA."); }

} // namespace hygroloom
