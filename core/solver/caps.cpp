// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/solver/caps.h"

#include "core/physics/caps.h"
#include "core/solver/cap_air.h"
#include "core/solver/cap_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {

void Caps::load(const Scene& scene)
{
    scene_ = &scene;
    weight_ = scene.climate.density * gravity_acceleration / scene.climate.surface_tension;
    next_ = 0;
    caps_.clear();
    on_face_.clear();
}

double Caps::next_event(double time) const
{
    double next = std::numeric_limits<double>::infinity();
    if (!scene_->caps.on) return next;
    for (const SceneDroplet& drop : scene_->supply.droplets)
        for (double event : {drop.time, released(drop).lands})
            if (event > time) next = std::min(next, event);
    return next;
}

Cap Caps::released(const SceneDroplet& drop) const
{
    Cap cap{drop.centre.x, drop.centre.y};
    cap.water = std::llround(drop.volume * scene_->climate.density / water_quantum);
    cap.ball = std::cbrt(3.0 * drop.volume / (4.0 * pi));
    const double falls = std::max(0.0, drop.centre.z - cap.ball - scene_->cloth.half_thickness);
    cap.speed = std::sqrt(drop.speed * drop.speed + 2.0 * gravity_acceleration * falls);
    cap.lands = drop.time + (cap.speed - drop.speed) / gravity_acceleration;
    return cap;
}

std::int64_t Caps::release(double time)
{
    std::int64_t came = 0;
    for (; next_ < scene_->supply.droplets.size() && scene_->supply.droplets[next_].time < time; ++next_) {
        caps_.push_back(released(scene_->supply.droplets[next_]));
        came += caps_.back().water;
    }
    return came;
}

double Caps::volume(const Cap& cap) const { return static_cast<double>(cap.water) * water_quantum / scene_->climate.density; }

double Caps::base_at(const Cap& cap, double angle) const { return CapShapes::table().base(volume(cap), angle, weight_); }

bool Caps::spread(double time, double dt)
{
    constexpr double first_touch = 0.2; // of the ball's radius, where a falling drop begins to stand: an assumption
    for (Cap& cap : caps_)
        if (cap.stands()) spread(cap, dt);
    join();
    bool landed = false;
    for (Cap& cap : caps_) {
        if (cap.base > 0 || cap.lands > time) continue;
        cap.base = first_touch * cap.ball;
        landed = true;
    }
    const auto is_released_now = [time](const SceneDroplet& drop) { return drop.time == time; };
    return landed || std::any_of(scene_->supply.droplets.begin(), scene_->supply.droplets.end(), is_released_now);
}

/// In small steps, none past the place where the line would rest.
void Caps::spread(Cap& cap, double dt) const
{
    constexpr int steps = 32;
    const ClimateParameters& c = scene_->climate;
    const double rest = base_at(cap, scene_->caps.advancing), dry = base_at(cap, scene_->caps.receding);
    const double thrown = std::max(rest, impact_base(c.surface_tension, c.density, cap.ball, cap.speed));
    for (int k = 0; k < steps && cap.base < thrown; ++k) {
        const double inertia = speed_of_inertia(c.surface_tension, c.density, cap.ball, cap.speed, cap.base);
        double speed = inertia;
        if (thrown <= rest) {
            const double angle = CapShapes::table().shape(volume(cap), cap.base, weight_).angle;
            speed = std::min(inertia, speed_of_contact_line(c.surface_tension, c.viscosity, angle, scene_->caps.advancing));
        }
        cap.base = std::min(thrown, cap.base + speed * dt / steps);
    }
    cap.base = std::min(cap.base, std::max(dry, rest));
}

/// Two at a time. One that has moved meets those before it in the next step.
void Caps::join()
{
    for (std::size_t i = 0; i < caps_.size(); ++i)
        for (std::size_t k = i + 1; k < caps_.size(); ++k) {
            Cap &a = caps_[i], &b = caps_[k];
            if (!a.stands() || !b.stands() || std::hypot(a.x - b.x, a.y - b.y) >= a.base + b.base) continue;
            const double all = static_cast<double>(a.water) + static_cast<double>(b.water), share = static_cast<double>(b.water) / all;
            a.x += share * (b.x - a.x);
            a.y += share * (b.y - a.y);
            a.base = std::max(a.base, b.base);
            a.ball = std::cbrt(a.ball * a.ball * a.ball + b.ball * b.ball * b.ball);
            a.speed = 0;
            a.water += b.water;
            b.water = 0;
            k = i;
        }
    std::erase_if(caps_, [](const Cap& cap) { return cap.water == 0; });
}

void expose(CapOnFace& cap, const ClimateParameters& climate)
{
    const double temperature = climate.temperature + climate.air_warmth;
    const double diffusivity = vapour_diffusivity(temperature), factor = evaporation_factor(cap.angle);
    const double widest = cap.angle > 0.5 * pi ? cap.base / std::sin(cap.angle) : cap.base;
    const double height = cap.base * cap_steepness(cap.angle), surface = pi * (cap.base * cap.base + height * height);
    const auto in_wind = [&](double schmidt) { return drop_in_wind(climate.air_speed, 2.0 * widest, schmidt); };
    cap.vapour = diffusion_from_cap(cap.base, diffusivity, factor) * in_wind(air_kinematic_viscosity / diffusivity);
    cap.heat = diffusion_from_cap(cap.base, air_conductivity, factor) * in_wind(air_prandtl) + surface * climate.radiation;
}

void Caps::take(const std::vector<CapSums>& sums)
{
    for (std::size_t k = 0; k < on_face_.size(); ++k) caps_[on_face_[k]].water -= sums[k].drawn;
}

std::vector<CapOnFace> Caps::on_face(double time)
{
    std::vector<CapOnFace> standing;
    on_face_.clear();
    for (std::size_t k = 0; k < caps_.size(); ++k) {
        const Cap& cap = caps_[k];
        if (!cap.stands() || cap.lands >= time) continue;
        on_face_.push_back(k);
        const CapShape shape = CapShapes::table().shape(volume(cap), cap.base, weight_);
        const double pressure = scene_->climate.surface_tension * (2.0 * shape.curvature + weight_ * shape.height);
        standing.push_back({cap.x, cap.y, cap.base, pressure, cap.water, shape.angle});
    }
    return standing;
}

std::vector<FrameCap> Caps::shown(double time) const
{
    std::vector<FrameCap> shown;
    for (const Cap& cap : caps_) {
        const double left = std::max(0.0, cap.lands - time); // s
        const double over = left * (cap.speed - 0.5 * gravity_acceleration * left);
        const double height = cap.stands() ? CapShapes::table().shape(volume(cap), cap.base, weight_).height : over + 2.0 * cap.ball;
        shown.push_back({cap.x, cap.y, cap.base, scene_->cloth.half_thickness, height, volume(cap)});
    }
    return shown;
}

std::int64_t Caps::wipe_off()
{
    std::int64_t all = 0;
    for (const Cap& cap : caps_) all += cap.stands() ? cap.water : 0;
    std::erase_if(caps_, [](const Cap& cap) { return cap.stands(); });
    on_face_.clear();
    return all;
}

std::int64_t Caps::water() const
{
    std::int64_t all = 0;
    for (const Cap& cap : caps_) all += cap.water;
    return all;
}

} // namespace hygroloom
