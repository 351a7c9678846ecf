// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A machine that can run the physics: the CPU, or a GPU.
#pragma once

#include "core/scene/frame.h"
#include "core/solver/stage_clock.h"

#include <cstddef>
#include <future>
#include <memory>
#include <string>
#include <vector>

namespace hygroloom {

struct Scene;

/// One way to run scenes. advance() and frame() belong to the scene loaded last.
class Backend {
public:
    virtual ~Backend() = default;
    virtual std::string name() const = 0;   ///< "cpu", "cuda"
    virtual std::string device() const = 0; ///< in words
    /// 0 for all that this process may use, of which no more are taken. Results do not depend on it.
    virtual void set_threads(int threads) = 0;
    virtual void load(const Scene& scene) = 0;
    /// Gives back the memory that the scene takes, where the backend can.
    virtual void unload() {}
    /// Advances towards the given time, by at least one step and by about 0.05 s of wall time at most; returns the time reached.
    virtual double advance(double until) = 0;
    virtual Frame frame() = 0;
    /// The same as frame() gives now, to be had later: from any thread, while advance() goes on, but before the next frame is taken or
    /// another scene is loaded. Where there is nothing to wait for it is there at once.
    virtual std::future<Frame> take_frame()
    {
        std::promise<Frame> now;
        now.set_value(frame());
        return now.get_future();
    }
    /// Where the scene is changed now: what follows begins here, not at the last end of a step before.
    virtual void stay() = 0;
    /// All that its scene has come to at a frame, on whatever machine it is to go on. Steps have ends of their own (see StepRules): unless
    /// stay() was called the state is that of the last one, and so are frames from then on until advance().
    virtual std::vector<std::byte> state() = 0;
    /// After load() of the same scene: goes on from what a backend had come to. Parts that were off may be on now (see set_parts()); fibres
    /// then begin with the regain they had. Drops to come and the air from then on may differ. Throws Error if it was another scene.
    virtual void go_on_from(const std::vector<std::byte>& state) = 0;
    /// Squeezes the cloth where it is now, between calls of advance() that reached what they were asked for: its pores keep a share of
    /// their volume for a moment, and what has no place runs off, as does what stands on the cloth. Drops of particles stay.
    virtual void squeeze(double share) = 0;
    virtual long liquid_steps() const = 0;
    virtual int particles() const = 0;
    /// From now on adds up what each stage takes, where the backend can.
    virtual void time_stages() {}
    /// The longest first; none when not asked for, or when the backend does not measure them.
    virtual std::vector<StageTime> stage_times() { return {}; }
};

std::unique_ptr<Backend> make_cpu_backend();

/// How many threads can run at once: of the machine's cores those that this process may use. 1 at least.
int usable_threads();

/// A backend that this build or machine may have.
struct BackendInfo {
    std::string name;
    std::string device;
    bool usable = false;
    std::string reason; ///< why not, in a sentence
};

} // namespace hygroloom
