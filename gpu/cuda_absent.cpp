// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Stands in where this build has no CUDA.
#include "core/base/error.h"
#include "gpu/cuda_backend.h"

namespace hygroloom {

std::vector<BackendInfo> find_cuda_devices() { return {{"cuda", "", false, "This build has no CUDA."}}; }

std::unique_ptr<Backend> make_cuda_backend(int) { throw DeviceError("This build has no CUDA."); }

std::size_t prepare_cuda_device(int, bool) { throw DeviceError("This build has no CUDA."); }

} // namespace hygroloom
