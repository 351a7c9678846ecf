// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "gpu/backends.h"

#include "core/base/error.h"
#include "gpu/cuda_backend.h"

namespace hygroloom {

std::vector<BackendInfo> find_backends()
{
    std::vector<BackendInfo> found{{"cpu", make_cpu_backend()->device(), true, ""}};
    for (BackendInfo& info : find_cuda_devices()) found.push_back(std::move(info));
    return found;
}

std::unique_ptr<Backend> make_backend(const std::string& name)
{
    if (name == "cpu") return make_cpu_backend();
    if (name != "auto" && name != "cuda") throw Error("The backend must be auto, cpu or cuda; \"" + name + "\" was given.");
    std::string reason;
    for (const BackendInfo& info : find_cuda_devices()) {
        if (info.usable) return make_cuda_backend();
        reason = info.reason;
    }
    if (name == "auto") return make_cpu_backend();
    throw DeviceError("No GPU can be used: " + reason);
}

} // namespace hygroloom
