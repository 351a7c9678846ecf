// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "gpu/backends.h"

#include "core/base/error.h"
#include "gpu/cuda_backend.h"

#include <algorithm>
#include <thread>

namespace hygroloom {
namespace {

constexpr int most_scenes_of_a_gpu = 16; // more of them are slower: see the benchmarks
constexpr double share_of_memory = 0.8;  // of a GPU's, that scenes may take

/// The numbers of the GPUs that can be used; none means the CPU. Throws as make_backend().
std::vector<int> chosen_gpus(const std::string& name)
{
    if (name != "auto" && name != "cpu" && name != "cuda")
        throw Error("The backend must be auto, cpu or cuda; \"" + name + "\" was given.");
    if (name == "cpu") return {};
    std::vector<int> usable;
    const std::vector<BackendInfo> all = find_cuda_devices();
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].usable) usable.push_back(static_cast<int>(i));
    if (name == "cuda" && usable.empty()) throw DeviceError("No GPU can be used: " + all.back().reason);
    return usable;
}

} // namespace

std::vector<BackendInfo> find_backends()
{
    std::vector<BackendInfo> found{{"cpu", make_cpu_backend()->device(), true, ""}};
    for (BackendInfo& info : find_cuda_devices()) found.push_back(std::move(info));
    return found;
}

std::unique_ptr<Backend> make_backend(const std::string& name)
{
    const std::vector<int> gpus = chosen_gpus(name);
    return gpus.empty() ? make_cpu_backend() : make_cuda_backend(gpus.front());
}

std::vector<std::unique_ptr<Backend>> make_backends(const std::string& name, int asked, int scenes, std::size_t bytes_each)
{
    const std::vector<int> gpus = chosen_gpus(name);
    const auto most = static_cast<std::size_t>(asked > 0 ? std::min(asked, scenes) : gpus.empty() ? 1 : scenes);
    std::vector<std::unique_ptr<Backend>> backends;
    if (gpus.empty() || most == 1) {
        while (backends.size() < most) backends.push_back(make_backend(name));
        return backends;
    }
    const bool threads_sleep = std::min(most, gpus.size() * most_scenes_of_a_gpu) > std::thread::hardware_concurrency();
    std::vector<int> room;
    for (const int gpu : gpus) {
        const double held = share_of_memory * static_cast<double>(share_cuda_device(gpu, threads_sleep)) /
                            static_cast<double>(std::max<std::size_t>(1, bytes_each));
        room.push_back(static_cast<int>(std::clamp(held, 1.0, double(most_scenes_of_a_gpu))));
    }
    // In turn, so that all GPUs have about as many.
    for (int turn = 0; turn < most_scenes_of_a_gpu; ++turn)
        for (std::size_t k = 0; k < gpus.size(); ++k)
            if (turn < room[k] && backends.size() < most) backends.push_back(make_cuda_backend(gpus[k]));
    return backends;
}

} // namespace hygroloom
