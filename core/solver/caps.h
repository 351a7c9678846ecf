// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Drops that stand on the upper face as caps with a contact line, instead of as particles: where they are, how they spread, and what
// is left of them. What yarns draw from them, and the air, is found by stages: see core/solver/steps/cap_supply.h and standing.h.
#pragma once

#include "core/scene/frame.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <vector>

namespace hygroloom {

/// A drop after its release: it falls, then stands.
struct Cap {
    double x = 0, y = 0;    ///< m, from the cloth's middle
    std::int64_t water = 0; ///< quanta
    double base = 0;        ///< m, radius of the face under it; 0: it falls
    double lands = 0;       ///< s
    double ball = 0;        ///< m, radius of the ball it came as
    double speed = 0;       ///< m/s, with which it lands

    bool stands() const { return base > 0 && water > 0; }
};

/// As stages see one.
struct CapOnFace {
    double x = 0, y = 0, base = 0; ///< m
    double pressure = 0;           ///< Pa over the air's, at the face
    std::int64_t water = 0;        ///< quanta
    double angle = 0;              ///< rad, that it shows
    double vapour = 0;             ///< m3/s, to the air: times the difference of concentrations
    double heat = 0;               ///< W/K, from the air
};

/// What stages count of each in a step of the yarns, in quanta but for the places.
struct CapSums {
    std::int64_t wanted = 0, drawn = 0, evaporated = 0;
    std::int64_t places = 0; ///< that it covers: see FedFace
};

/// Finds what a drop of this base and angle exchanges with the air.
void expose(CapOnFace& cap, const ClimateParameters& climate);

/// Lines of contact go by viscosity or inertia, whichever is slower, until a drop shows its advancing angle, by inertia alone where an
/// impact throws them farther; they stay until it shows its receding one, at which they go back at once. Caps that touch become one of
/// their volume about their common middle.
class Caps {
public:
    void load(const Scene& scene);

    /// s, when the next drop is released or lands; infinite where none will.
    double next_event(double time) const;
    /// Those that were due before a time fall; returns their water, quanta.
    std::int64_t release(double time);
    /// Lands those that are due and lets lines of contact go on for dt, s. Returns whether any landed, or is released now.
    bool spread(double time, double dt);
    /// Those that stood before the step that ends at a time, in order; what lands at its end gives nothing in it.
    std::vector<CapOnFace> on_face(double time);
    /// What yarns have drawn of each of those.
    void take(const std::vector<CapSums>& sums);
    /// Quanta of one of those.
    std::int64_t& water_of(std::size_t on_face) { return caps_[on_face_[on_face]].water; }
    /// Those that stand leave the cloth; returns their water, quanta.
    std::int64_t wipe_off();
    std::vector<FrameCap> shown(double time) const;
    std::int64_t water() const;

    template <typename Archive> void pass_state(Archive& archive)
    {
        archive.value(next_);
        std::size_t count = caps_.size();
        archive.value(count);
        if constexpr (Archive::reads) caps_.resize(count < next_ ? count : next_);
        archive.values(caps_, "drops");
    }

private:
    Cap released(const SceneDroplet& drop) const;
    double volume(const Cap& cap) const;
    double base_at(const Cap& cap, double angle) const;
    void spread(Cap& cap, double dt) const;
    void join();

    const Scene* scene_ = nullptr;
    double weight_ = 0;    ///< 1/m2, see drop_of_top()
    std::size_t next_ = 0; ///< of the scene's drops
    std::vector<Cap> caps_;
    std::vector<std::size_t> on_face_; ///< places of those in on_face()
};

} // namespace hygroloom
