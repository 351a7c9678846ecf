// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Which backends this build and this machine have.
#pragma once

#include "core/sim/backend.h"

namespace hygroloom {

/// The CPU first, then every GPU, usable or not.
std::vector<BackendInfo> find_backends();

/// "auto", "cpu" or "cuda". Throws DeviceError with the reason when it is not there.
std::unique_ptr<Backend> make_backend(const std::string& name);

} // namespace hygroloom
