// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A scene on a machine: it is advanced, gives frames and states, and can go on from a state, also on another machine.
#pragma once

#include "core/plan/bundles.h"
#include "core/scene/scene.h"
#include "core/solver/backend.h"

#include <memory>
#include <optional>

namespace hygroloom {

/// A drop that is put over a running scene. SI.
struct PutDrop {
    double x = 0, y = 0; ///< m, from the cloth's middle
    double volume = 0;   ///< m3
    double height = 0;   ///< m, of its lowest point over the cloth
    double speed = 0;    ///< m/s, downwards
};

/// How weight pulls liquid along a tilted cloth, m/s2: towards pick 0 and towards end 0.
struct Tilt {
    double along_warp = 0, along_weft = 0;
};

/// The cloth is squeezed for a moment, so that its pores keep a share of their volume, more than 0 and at most 1.
struct Squeeze {
    double share = 1;
};

class Session {
public:
    /// The scene is that of single yarns; where bundles are of several yarns it is simulated in them. Loads nothing yet.
    Session(Backend& backend, Scene scene, const Bundling& bundling);
    /// The scene stays where it is, and must outlive the session; nothing can be put on it.
    Session(Backend& backend, const Scene* scene) : backend_(&backend), given_(scene) {}

    /// Puts the scene on the machine, at its start.
    void load();
    /// Advances towards a time (s), by at least one step and by about 0.05 s of wall time at most; returns the time reached.
    double advance(double until);
    /// What the scene has come to, as it is simulated; see Backend::take_frame().
    std::future<Frame> take_frame() { return backend_->take_frame(); }
    /// Such a frame with the values of each single yarn, or as it is where it shows cells.
    Frame of_single_yarns(Frame frame) const;
    /// See Backend::stay().
    void stay() { backend_->stay(); }
    /// Everything the scene has come to.
    std::vector<std::byte> state() { return backend_->state(); }
    /// Loads the scene again and goes on from a state of it.
    void go_on_from(const std::vector<std::byte>& state);
    /// The same with the parts that the plan has on.
    void go_on_from(const std::vector<std::byte>& state, const ModelPlan& plan);
    /// Puts a drop over the cloth, which falls from now on. Throws Error where the scene was planned without drops, or in bundles of yarns.
    /// Precondition of all: no frame is on its way, and the session has advanced since it last went on from a state.
    void poke(const PutDrop& put);
    /// The air is another from now on; its own time does not count. See air_of().
    void poke(const AirMoment& air);
    /// The cloth lies tilted from now on.
    void poke(const Tilt& tilt);
    /// What has no place in the pores then runs off, with what stands on the cloth. Throws Error where drops are particles, or where
    /// there are more than 250 g of liquid.
    void poke(const Squeeze& squeeze);
    /// The next load() goes to this machine, which the session keeps.
    void move_to(std::unique_ptr<Backend> backend);
    bool has_moved() const { return moved_to_ != nullptr; }

    Backend& backend() const { return *backend_; }
    /// As it is simulated: of bundles where yarns go in bundles.
    const Scene& scene() const { return given_ ? *given_ : scene_; }

private:
    /// Goes on with what the scene is now.
    void go_on_changed();

    double time_ = 0, until_ = 0; ///< s: reached, and asked for
    std::unique_ptr<Backend> moved_to_;
    Backend* backend_; ///< the one it began on, or moved_to_
    Bundling bundling_;
    const Scene* given_ = nullptr; ///< in place of scene_
    Scene scene_;
    std::optional<Scene> single_; ///< where scene_ has bundles
};

} // namespace hygroloom
