// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/session.h"

#include "core/base/error.h"
#include "core/scene/coarse_scene.h"
#include "core/solver/liquid_start.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

Session::Session(Backend& backend, Scene scene, const Bundling& bundling)
    : backend_(&backend), bundling_(bundling), scene_(std::move(scene))
{
    if (bundling.yarns <= 1) return;
    single_ = std::move(scene_);
    scene_ = coarsened(*single_, bundling);
}

void Session::load()
{
    backend_->load(scene());
    time_ = until_ = 0;
}

double Session::advance(double until)
{
    until_ = until;
    return time_ = backend_->advance(until);
}

void Session::poke(const PutDrop& put)
{
    if (scene_.rules.particles_per_droplet <= 0 && !scene_.caps.on)
        throw Error("This scene is planned without drops. Plan it with one, or with \"liquid\" on.");
    if (single_ && !scene_.caps.on) throw Error("Drops meet single yarns. Simulate this scene with crossings_per_cell=1.");
    if (!(put.volume > 0)) throw Error("A drop needs a volume over 0.");
    while (time_ < until_) advance(until_);
    if (scene_.liquid.particle_volume <= 0 && !scene_.caps.on) // of the drops so far; from now on it stays
        scene_.liquid.particle_volume =
            scene_.supply.droplets.empty() ? put.volume / scene_.rules.particles_per_droplet : liquid_start(scene_).volume;
    const double radius = std::cbrt(3.0 * put.volume / (4.0 * pi));
    const SceneDroplet drop{time_, put.volume, {put.x, put.y, scene_.cloth.half_thickness + put.height + radius}, put.speed};
    std::vector<SceneDroplet>& drops = scene_.supply.droplets; // those that have been released come first
    drops.insert(
        std::upper_bound(drops.begin(), drops.end(), drop, [](const SceneDroplet& a, const SceneDroplet& b) { return a.time < b.time; }),
        drop);
    go_on_changed();
}

void Session::poke(const AirMoment& air)
{
    while (time_ < until_) advance(until_);
    AirMoment before = air_at(scene_.climate, time_), after = air;
    before.time = after.time = time_;
    std::vector<AirMoment>& course = scene_.climate.course;
    if (course.empty()) course.push_back(air_at(scene_.climate, 0));
    std::erase_if(course, [this](const AirMoment& moment) { return moment.time > time_; });
    if (course.back().time < time_) course.push_back(before);
    course.push_back(after);
    go_on_changed();
}

void Session::poke(const Tilt& tilt)
{
    while (time_ < until_) advance(until_);
    scene_.cloth.gravity_along_warp = tilt.along_warp;
    scene_.cloth.gravity_along_weft = tilt.along_weft;
    go_on_changed();
}

void Session::poke(const Squeeze& squeeze)
{
    if (scene_.rules.particles_per_droplet > 0 && !scene_.caps.on)
        throw Error("Drops of particles cannot be squeezed. Plan this scene with \"cap\" on.");
    if (!(squeeze.share > 0 && squeeze.share <= 1))
        throw Error("The share of the pores that a squeeze leaves is more than 0 and at most 1.");
    while (time_ < until_) advance(until_);
    constexpr double most = 0.25; // kg
    if (const Ledger ledger = take_frame().get().ledger; ledger.water_liquid + ledger.water_free > most)
        throw Error("A cloth with more than 250 g of liquid cannot be squeezed.");
    backend_->squeeze(squeeze.share);
}

void Session::go_on_changed()
{
    backend_->stay();
    const std::vector<std::byte> state = backend_->state();
    backend_->load(scene_);
    backend_->go_on_from(state);
}

void Session::move_to(std::unique_ptr<Backend> backend)
{
    backend_ = backend.get();
    moved_to_ = std::move(backend);
}

Frame Session::of_single_yarns(Frame frame) const
{
    if (!single_ || scene_.cloth.shown_ends > 0) return frame; // a conditional expression would copy it
    return refined(std::move(frame), scene_, *single_, bundling_);
}

void Session::go_on_from(const std::vector<std::byte>& state)
{
    load();
    backend_->go_on_from(state);
}

void Session::go_on_from(const std::vector<std::byte>& state, const ModelPlan& plan)
{
    set_parts(scene_, plan);
    go_on_from(state);
}

} // namespace hygroloom
