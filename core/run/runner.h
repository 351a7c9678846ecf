// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One run from project to recording. Runs in the calling thread; the window calls it from a thread of its own. Frames that a GPU gives late
// are published from another thread while the next steps run.
#pragma once

#include "core/run/run_options.h"

namespace hygroloom {

class Backend;

/// Runs to the end. Throws Cancelled when asked to stop (within 0.2 s; the recording so far is complete and readable),
/// NotEnoughMemory before anything
/// is built, DeviceError, FileError or Error. Precondition: validate() found no error.
RunRecord run_experiment(const Design& design, const std::string& fabric, const std::string& experiment, const RunOptions& options,
                         Backend& backend, RunControl& control, const RunCallbacks& callbacks);

} // namespace hygroloom
