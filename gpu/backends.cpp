// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "gpu/backends.h"

#include "core/base/error.h"
#include "core/base/free_memory.h"
#include "gpu/cuda_backend.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace hygroloom {
namespace {

constexpr std::size_t most_scenes_of_a_gpu = 16; // more of them would wait for their turn, and take memory
constexpr double share_of_memory = 0.8;          // of a GPU's, that scenes may take

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

/// How many scenes of this size (bytes) a GPU has room for, at least one; none, and why, if it cannot be asked.
std::size_t room_for_scenes(int gpu, bool threads_sleep, std::size_t bytes_each, std::string& reason)
try {
    const double free = share_of_memory * static_cast<double>(prepare_cuda_device(gpu, threads_sleep));
    return static_cast<std::size_t>(std::clamp(free / std::max(1.0, static_cast<double>(bytes_each)), 1.0, 1e6));
} catch (const DeviceError& error) {
    reason = error.what();
    return 0;
}

} // namespace

std::vector<BackendInfo> find_backends()
{
    std::vector<BackendInfo> found{{"cpu", make_cpu_backend()->device(), true, ""}};
    for (BackendInfo& info : find_cuda_devices()) found.push_back(std::move(info));
    return found;
}

std::string backend_for(const std::string& name, const KnobSettings& knobs)
{
    const auto found = knobs.find("double_precision");
    if (found == knobs.end() || found->second == 0) return name;
    if (name == "cuda") throw Error("fidelity.double_precision: Only a CPU has it; the backend must be auto or cpu, \"cuda\" was given.");
    return "cpu";
}

std::string expected_backend(const std::string& name)
{
    if (name == "cuda") return name;
    return chosen_gpus(name).empty() ? "cpu" : "cuda";
}

std::unique_ptr<Backend> make_backend(const std::string& name)
{
    const std::vector<int> gpus = chosen_gpus(name);
    return gpus.empty() ? make_cpu_backend() : make_cuda_backend(gpus.front());
}

double memory_for_scenes(const std::string& name)
try {
    const std::vector<int> gpus = chosen_gpus(name);
    return gpus.empty() ? 0 : share_of_memory * static_cast<double>(prepare_cuda_device(gpus.front(), false));
} catch (const DeviceError&) {
    return 0;
}

void announce_scenes(int asked, int scenes)
{
    constexpr int usual_queues = 8; // to make more takes a tenth of a second
    if ((asked > 0 ? std::min(asked, scenes) : scenes) > usual_queues)
        setenv("CUDA_DEVICE_MAX_CONNECTIONS", std::to_string(most_scenes_of_a_gpu).c_str(), 0);
}

std::vector<std::unique_ptr<Backend>> make_backends(const std::string& name, int asked, int scenes, std::size_t bytes_each)
{
    const std::vector<int> gpus = chosen_gpus(name);
    const int wanted = asked > 0 ? std::min(asked, scenes) : gpus.empty() ? 1 : scenes;
    const auto most = static_cast<std::size_t>(jobs_that_fit(wanted, static_cast<double>(bytes_each)));
    std::vector<std::unique_ptr<Backend>> backends;
    if (gpus.empty() || most == 1) {
        while (backends.size() < most) backends.push_back(make_backend(name));
        return backends;
    }
    const std::size_t side_by_side = asked > 0 ? most : std::min(most, gpus.size() * most_scenes_of_a_gpu);
    const bool threads_sleep = side_by_side > static_cast<std::size_t>(usable_threads());
    std::vector<std::size_t> room; // of each GPU
    std::string reason;
    for (const int gpu : gpus) {
        room.push_back(room_for_scenes(gpu, threads_sleep, bytes_each, reason));
        if (asked == 0) room.back() = std::min(room.back(), most_scenes_of_a_gpu);
    }
    // In turn, so that all GPUs have about as many.
    for (bool any = true; any && backends.size() < most;) {
        any = false;
        for (std::size_t k = 0; k < gpus.size() && backends.size() < most; ++k) {
            if (room[k] == 0) continue;
            --room[k];
            any = true;
            backends.push_back(make_cuda_backend(gpus[k]));
        }
    }
    if (backends.empty() && name == "cuda") throw DeviceError(reason);
    if (backends.empty()) backends.push_back(make_cpu_backend());
    return backends;
}

} // namespace hygroloom
