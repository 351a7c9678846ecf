// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The CUDA backend; cuda_absent.cpp answers where the program was built without CUDA.
#pragma once

#include "core/solver/backend.h"

namespace hygroloom {

/// At least one entry: every GPU, or one that says why there is none.
std::vector<BackendInfo> find_cuda_devices();

/// On the GPU of that place among find_cuda_devices(). Throws DeviceError.
std::unique_ptr<Backend> make_cuda_backend(int device);

/// Before anything else is asked of that GPU: says whether threads that wait for it sleep, and returns how many bytes are free there.
/// Throws DeviceError.
std::size_t prepare_cuda_device(int device, bool threads_sleep);

} // namespace hygroloom
