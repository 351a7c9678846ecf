// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Which backends this build and this machine have.
#pragma once

#include "core/plan/fidelity.h"
#include "core/solver/backend.h"

namespace hygroloom {

/// The CPU first, then every GPU, usable or not.
std::vector<BackendInfo> find_backends();

/// What "auto", "cpu" or "cuda" means with these knobs: a CPU where particles are in double precision. Throws Error when it was a GPU
/// that was asked for.
std::string backend_for(const std::string& name, const KnobSettings& knobs);

/// Where a run on "auto", "cpu" or "cuda" is expected to go: "cpu" or "cuda", which need not be there. Throws Error for another word.
std::string expected_backend(const std::string& name);

/// "auto", "cpu" or "cuda". Throws DeviceError with the reason when it is not there.
std::unique_ptr<Backend> make_backend(const std::string& name);

/// Bytes that scenes may take together on the device that make_backend() gives; 0: a CPU, or it cannot be asked.
double memory_for_scenes(const std::string& name);

/// That as many scenes will run side by side as make_backends() is asked for: lets the streams of up to 16 come through queues of their
/// own, without which they hold each other up. To be said before anything is asked of GPUs and before there are other threads, for it is
/// said in the environment (CUDA_DEVICE_MAX_CONNECTIONS, which counts as it is where the user has set it).
void announce_scenes(int asked, int scenes);

/// For scenes that run side by side, each in a thread of its own: as many backends as are asked for, or for 0 as many as pay (one scene
/// fills a CPU, 16 a GPU), and no more than there are scenes or than the GPUs' memory
/// and that of the machine hold, one at least. Throws as make_backend().
std::vector<std::unique_ptr<Backend>> make_backends(const std::string& name, int asked, int scenes, std::size_t bytes_each);

} // namespace hygroloom
