// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "gpu/missing_gpu.h"

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <unistd.h>
#include <vector>

namespace hygroloom {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file)
{
    std::ifstream stream(file);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::vector<fs::path> entries_of(const fs::path& folder)
{
    std::vector<fs::path> entries;
    std::error_code none;
    for (fs::directory_iterator entry(folder, none), end; entry != end; entry.increment(none)) entries.push_back(entry->path());
    return entries;
}

bool has_card(const fs::path& root)
{
    for (const fs::path& device : entries_of(root / "sys/bus/pci/devices"))
        if (text_of(device / "vendor").starts_with("0x10de") && text_of(device / "class").starts_with("0x03")) return true;
    return false;
}

/// The first word of the form 535.183.01.
std::string version_in(const std::string& text)
{
    std::istringstream words(text);
    for (std::string word; words >> word;)
        if (std::isdigit(static_cast<unsigned char>(word.front())) && word.find('.') != std::string::npos) return word;
    return {};
}

std::string library_version(const fs::path& root)
{
    for (const char* folder : {"usr/lib/x86_64-linux-gnu", "usr/lib/x86_64-linux-gnu/nvidia/current", "usr/lib64", "usr/lib"})
        for (const fs::path& file : entries_of(root / folder)) {
            const std::string name = file.filename().string(), start = "libcuda.so.";
            if (name.starts_with(start) && name.find('.', start.size()) != std::string::npos) return name.substr(start.size());
        }
    return {};
}

std::string dotted(int version) { return std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10); }

} // namespace

GpuSurroundings gpu_surroundings(const fs::path& root)
{
    GpuSurroundings seen;
    std::error_code none;
    seen.card = has_card(root);
    seen.container = fs::exists(root / ".dockerenv", none) || fs::exists(root / "run/.containerenv", none) ||
                     text_of(root / "proc/1/environ").find("container=") != std::string::npos;
    seen.module_version = version_in(text_of(root / "proc/driver/nvidia/version"));
    seen.library_version = library_version(root);
    for (const fs::path& file : entries_of(root / "dev")) {
        const std::string name = file.filename().string();
        const bool numbered = name.size() > 6 && name.starts_with("nvidia") && std::isdigit(static_cast<unsigned char>(name[6]));
        seen.control_file |= name == "nvidiactl";
        seen.memory_file |= name == "nvidia-uvm";
        seen.card_file |= numbered;
        if ((numbered || name == "nvidiactl" || name == "nvidia-uvm") && ::access(file.c_str(), R_OK | W_OK) != 0)
            seen.closed_file = "/dev/" + name;
    }
    if (const char* visible = std::getenv("CUDA_VISIBLE_DEVICES")) seen.visible_devices = visible;
    return seen;
}

std::string missing_gpu_cause(const GpuSurroundings& seen, int driver_cuda, int runtime_cuda)
{
    if (seen.visible_devices && (seen.visible_devices->empty() || seen.visible_devices->starts_with('-')))
        return "CUDA_VISIBLE_DEVICES hides all GPUs. Unset it.";
    if (seen.module_version.empty() && !seen.card) return "This machine shows no NVIDIA GPU.";
    if (seen.module_version.empty())
        return "The NVIDIA driver is not loaded. Install it; after a new kernel, build its module again (nvidia-smi shows when it works).";
    if (!seen.control_file || !seen.card_file)
        return seen.container ? "The container has no device files of a GPU. Start it with them (docker --gpus all, podman --device "
                                "nvidia.com/gpu=all)."
                              : "The device files /dev/nvidiactl and /dev/nvidia0 are missing. Make them with nvidia-modprobe.";
    if (!seen.memory_file)
        return "The kernel module nvidia_uvm is not loaded, or /dev/nvidia-uvm is missing. Run nvidia-modprobe -u -c 0" +
               std::string(seen.container ? " outside the container, and start it again." : ".");
    if (!seen.closed_file.empty()) return seen.closed_file + " may not be opened. Join the group that owns it, usually video or render.";
    if (!seen.library_version.empty() && seen.library_version != seen.module_version)
        return "The driver's kernel module is " + seen.module_version + ", its library libcuda is " + seen.library_version +
               ". Start the machine again after an update of the driver" + (seen.container ? ", and the container, too." : ".");
    if (driver_cuda == 0)
        return seen.container
                   ? "The driver's library libcuda.so.1 is not found. The container needs it (NVIDIA_DRIVER_CAPABILITIES=compute,utility)."
                   : "The driver's library libcuda.so.1 is not found. Install it (libcuda1 in Debian).";
    if (driver_cuda < runtime_cuda)
        return "The driver supports CUDA " + dotted(driver_cuda) + ", this program needs CUDA " + dotted(runtime_cuda) +
               ". Update the driver.";
    return {};
}

} // namespace hygroloom
