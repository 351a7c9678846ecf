// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Why no GPU can be used, by what the system shows: driver, kernel modules, device files, container.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hygroloom {

struct GpuSurroundings {
    bool card = false;                          ///< an NVIDIA display controller on the PCI bus
    bool container = false;                     ///< this runs in one
    std::string module_version;                 ///< of the driver's kernel module; empty: not loaded
    std::string library_version;                ///< of the driver's libcuda; empty: not found
    bool control_file = false;                  ///< /dev/nvidiactl
    bool card_file = false;                     ///< /dev/nvidia0 or another number
    bool memory_file = false;                   ///< /dev/nvidia-uvm
    std::string closed_file;                    ///< one of them that may not be opened for reading and writing
    std::optional<std::string> visible_devices; ///< CUDA_VISIBLE_DEVICES
};

/// Looks below a root folder, "/" but in tests, and at the environment.
GpuSurroundings gpu_surroundings(const std::filesystem::path& root);
/// The likeliest cause and what to do, as one or two sentences; empty where nothing is amiss. Versions as CUDA gives them, 12040 for 12.4;
/// the driver's is the newest CUDA that it supports, 0 without one.
std::string missing_gpu_cause(const GpuSurroundings& seen, int driver_cuda, int runtime_cuda);

} // namespace hygroloom
