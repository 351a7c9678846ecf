// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a run is started with, and what passes between it and its caller.
#pragma once

#include "core/base/free_memory.h"
#include "core/run/run_record.h"
#include "core/scene/frame.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace hygroloom {

/// Of a sample or a worn garment; what is left to chance and what is switched on or off counts for samples alone.
struct RunOptions {
    Fidelity fidelity = Fidelity::standard;
    std::string fidelity_reason; ///< for the plan
    ForcedParts forced;
    KnobSettings knobs; ///< on top of the fidelity's
    std::uint64_t seed = 1;
    double frame_interval = 0;              ///< s; 0: the plan's own
    double shown_side = 0;                  ///< m, of the cells in which frames show it; 0: by its size: see decide_shown_cells()
    double cell_side = 0;                   ///< m, of a garment's computed cells, about; 0: by fidelity
    std::vector<std::string> detail;        ///< panels of a garment whose computed cells are all shown: see ShownSize
    int threads = 0;                        ///< 0: all the machine has
    bool may_go_on_on_cpu = false;          ///< when the device fails
    MemoryRule memory;                      ///< asked before the scene is built
    std::mutex* one_on_cpu = nullptr;       ///< of runs side by side that go on there: held by the one that does
    std::filesystem::path recording;        ///< empty: none is written
    std::shared_ptr<const Textile> textile; ///< the run's, see textile_of_run(), where it has been built; nullptr: built from the design
};

/// What a caller may do to a run from another thread.
struct RunControl {
    std::atomic<bool> cancel{false};
    std::atomic<bool> pause{false};
    std::atomic<bool> was_paused{false}; ///< at some time; its caller sets it
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
    std::function<void(const std::string&)> memory_is_short; ///< before the scene is built: it takes much of what is free; a sentence
    std::function<void(const std::string&)> device_failed;   ///< the run is about to go on on the CPU; a sentence
};

} // namespace hygroloom
