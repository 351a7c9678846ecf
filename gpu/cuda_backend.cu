// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The solver on a GPU. The one file that pulls in CUB and instantiates every stage for the device.
#include "core/solver/solver.h"
#include "gpu/cuda_backend.h"
#include "gpu/cuda_executor.cuh"
#include "gpu/missing_gpu.h"

namespace hygroloom {
namespace {

class CudaBackend : public Backend {
public:
    explicit CudaBackend(int device) : number_(device)
    {
        cudaDeviceProp properties;
        check_cuda(cudaGetDeviceProperties(&properties, device), "asking for its properties");
        device_ = properties.name;
    }
    ~CudaBackend() override { unload(); }
    std::string name() const override { return "cuda"; }
    std::string device() const override { return device_; }
    void set_threads(int) override {}
    /// The thread that loads a scene is the one that advances it and asks for its frames.
    void load(const Scene& scene) override
    {
        if (scene.rules.double_precision) throw DeviceError("Particles in double precision (fidelity.double_precision) run on a CPU only.");
        solver().load(scene);
    }
    void unload() override
    {
        if (!solver_) return;
        cudaSetDevice(number_);
        cudaDeviceSynchronize(); // a thread that is no more may have asked for what still runs
        solver_.reset();
        cudaGetLastError();
    }
    double advance(double until) override { return solver_->advance(until, 0.05); }
    Frame frame() override { return solver_->frame(); }
    /// Whoever gets it fetches it from the GPU and adds up its ledger.
    std::future<Frame> take_frame() override
    {
        return std::async(std::launch::deferred, [this, stock = solver_->take_stock()] { return solver_->frame_of(stock); });
    }
    void stay() override { solver_->stay(); }
    std::vector<std::byte> state() override { return solver_->state(); }
    void go_on_from(const std::vector<std::byte>& state) override { solver_->go_on_from(state); }
    void squeeze(double share) override { solver_->squeeze(share); }
    long liquid_steps() const override { return solver_->liquid_steps(); }
    int particles() const override { return solver_->particles(); }
    void time_stages() override { solver().time_stages(); }
    std::vector<StageTime> stage_times() override { return solver_ ? solver_->executor().stage_times() : std::vector<StageTime>(); }

private:
    /// Makes its GPU the calling thread's.
    Solver<CudaExecutor>& solver()
    {
        check_cuda(cudaSetDevice(number_), "choosing it");
        if (!solver_) solver_ = std::make_unique<Solver<CudaExecutor>>();
        return *solver_;
    }

    int number_;
    std::string device_;
    std::unique_ptr<Solver<CudaExecutor>> solver_; ///< on that GPU
};

/// A sentence that CUDA gives, and the cause that the system shows.
std::string no_gpu(const std::string& sentence)
{
    int driver = 0, runtime = 0;
    cudaDriverGetVersion(&driver);
    cudaRuntimeGetVersion(&runtime);
    const std::string cause = missing_gpu_cause(gpu_surroundings("/"), driver, runtime);
    return cause.empty() ? sentence : sentence + " " + cause;
}

} // namespace

std::vector<BackendInfo> find_cuda_devices()
{
    int count = 0;
    const cudaError_t result = cudaGetDeviceCount(&count);
    if (result != cudaSuccess)
        return {{"cuda", "", false, no_gpu(std::string("No GPU can be reached: ") + cudaGetErrorString(result) + ".")}};
    std::vector<BackendInfo> found;
    for (int i = 0; i < count; ++i) {
        cudaDeviceProp properties;
        if (const cudaError_t refusal = cudaGetDeviceProperties(&properties, i); refusal != cudaSuccess) {
            cudaGetLastError();
            found.push_back({"cuda", "", false, std::string("It does not answer: ") + cudaGetErrorString(refusal) + "."});
            continue;
        }
        BackendInfo info{"cuda", properties.name, properties.major * 10 + properties.minor >= 75, ""};
        if (!info.usable) info.reason = "It is older than compute capability 7.5.";
        found.push_back(std::move(info));
    }
    if (found.empty()) found.push_back({"cuda", "", false, no_gpu("No GPU was found.")});
    return found;
}

std::unique_ptr<Backend> make_cuda_backend(int device) { return std::make_unique<CudaBackend>(device); }

std::size_t prepare_cuda_device(int device, bool threads_sleep)
{
    std::size_t left = 0, all = 0;
    check_cuda(cudaSetDevice(device), "choosing it");
    check_cuda(cudaSetDeviceFlags(threads_sleep ? cudaDeviceScheduleBlockingSync : cudaDeviceScheduleAuto), "asking how threads wait");
    check_cuda(cudaMemGetInfo(&left, &all), "asking for its memory");
    return left;
}

} // namespace hygroloom
