// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One run from project to recording. Runs in the calling thread; the window calls it from a thread of its own. Frames that a GPU gives late
// are published from another thread while the next steps run.
#pragma once

#include "core/run/run_record.h"
#include "core/scene/frame.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>

namespace hygroloom {

class Backend;

struct RunOptions {
    Fidelity fidelity = Fidelity::standard;
    std::string fidelity_reason; ///< for the plan
    ForcedParts forced;
    KnobSettings knobs; ///< on top of the fidelity's
    std::uint64_t seed = 1;
    int threads = 0;                  ///< 0: all the machine has
    bool may_go_on_on_cpu = false;    ///< when the device fails
    std::mutex* one_on_cpu = nullptr; ///< of runs side by side that go on there: held by the one that does
    std::filesystem::path recording;  ///< empty: none is written
};

/// What a caller may do to a run from another thread.
struct RunControl {
    std::atomic<bool> cancel{false};
    std::atomic<bool> pause{false};
};

struct RunProgress {
    double simulated = 0; ///< s
    double duration = 0;  ///< s
    double wall = 0;      ///< s
    long steps = 0;       ///< of the liquid
    int particles = 0;    ///< still free
};

/// Frames may come from a thread of the run's own, but never two calls at a time.
struct RunCallbacks {
    std::function<void(const RunRecord&)> started;
    std::function<void(std::shared_ptr<const Frame>)> frame; ///< each recorded frame, the first at time 0
    std::function<void(const RunProgress&)> progress;        ///< several times a second
    std::function<void(const SwitchedPart&)> switched_on;    ///< after the frame of its time; before it if that is the last
    std::function<void(const std::string&)> device_failed;   ///< the run is about to go on on the CPU; a sentence
};

/// Runs to the end. Throws Cancelled when asked to stop (within 0.2 s; the recording so far is complete and readable),
/// DeviceError, FileError or Error. Precondition: validate() found no error.
RunRecord run_experiment(const Design& design, const std::string& fabric, const std::string& experiment, const RunOptions& options,
                         Backend& backend, RunControl& control, const RunCallbacks& callbacks);

} // namespace hygroloom
