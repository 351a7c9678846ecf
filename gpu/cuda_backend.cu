// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The solver on a GPU. The one file that pulls in CUB and instantiates every stage for the device.
#include "core/sim/solver.h"
#include "gpu/cuda_backend.h"
#include "gpu/cuda_executor.cuh"

namespace hygroloom {
namespace {

class CudaBackend : public Backend {
public:
    CudaBackend()
    {
        cudaDeviceProp properties;
        check_cuda(cudaGetDeviceProperties(&properties, 0), "asking for its properties");
        device_ = properties.name;
    }
    std::string name() const override { return "cuda"; }
    std::string device() const override { return device_; }
    void set_threads(int) override {}
    void load(const Scene& scene) override { solver_.load(scene); }
    double advance(double until) override { return solver_.advance(until, 0.05); }
    Frame frame() override { return solver_.frame(); }
    long liquid_steps() const override { return solver_.liquid_steps(); }
    int particles() const override { return solver_.particles(); }

private:
    std::string device_;
    Solver<CudaExecutor> solver_;
};

} // namespace

std::vector<BackendInfo> find_cuda_devices()
{
    int count = 0;
    const cudaError_t result = cudaGetDeviceCount(&count);
    if (result != cudaSuccess) return {{"cuda", "", false, std::string("No GPU can be reached: ") + cudaGetErrorString(result) + "."}};
    std::vector<BackendInfo> found;
    for (int i = 0; i < count; ++i) {
        cudaDeviceProp properties;
        if (cudaGetDeviceProperties(&properties, i) != cudaSuccess) continue;
        BackendInfo info{"cuda", properties.name, properties.major * 10 + properties.minor >= 75, ""};
        if (!info.usable) info.reason = "It is older than compute capability 7.5.";
        found.push_back(std::move(info));
    }
    if (found.empty()) found.push_back({"cuda", "", false, "No GPU was found."});
    return found;
}

std::unique_ptr<Backend> make_cuda_backend() { return std::make_unique<CudaBackend>(); }

} // namespace hygroloom
