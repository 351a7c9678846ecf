// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/verify/drop_set_ups.h"

#include "core/base/random.h"
#include "core/solver/droplet.h"
#include "core/verify/set_ups.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

Scene scene_with(const std::vector<Vec3d>& places, double particle_volume, double temperature)
{
    Scene scene = bare_scene(1, 1, 2e-3, temperature);
    scene.rules.network_step = scene.rules.calm_network_step = 1.0;
    scene.rules.step_share = 0;
    scene.liquid.places = places;
    scene.liquid.velocities.assign(places.size(), Vec3d{});
    scene.liquid.particle_volume = particle_volume;
    scene.liquid.gravity = 0;
    return scene;
}

void put_on_plate(Scene& scene, double angle)
{
    scene.liquid.vessel = SceneVessel{{-1, -1, plate_height}, {1, 1, 1}, scene.climate.surface_tension * (1.0 + std::cos(angle))};
}

void disturb(std::vector<Vec3d>& places, double spacing, std::uint64_t seed)
{
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto off = [&](std::uint64_t axis) { return 0.5 * spacing * (random_uniform(seed, axis, i) - 0.5); };
        places[i] += Vec3d{off(0), off(1), off(2)};
    }
}

Scene ball(int particles, double radius, double temperature, std::uint64_t seed)
{
    const double particle_volume = 4.0 / 3.0 * pi * radius * radius * radius / particles, spacing = std::cbrt(particle_volume);
    std::vector<Vec3d> places = droplet_lattice(particles, spacing);
    disturb(places, spacing, seed);
    for (Vec3d& p : places) p += Vec3d{0, 0, plate_height + 2 * radius};
    return scene_with(places, particle_volume, temperature);
}

Scene cap_on_plate(int particles, const PlateCap& cap, double temperature)
{
    const double particle_volume = cap.volume / particles, spacing = std::cbrt(particle_volume), start_angle = cap.start_angle;
    const DropOnPlate shape = drop_of_volume(cap.volume, start_angle, 0);
    const Vec3d middle{0, 0, -shape.base_radius / std::tan(start_angle)}; // of the ball that the cap is cut from
    const int across = static_cast<int>(std::ceil(shape.base_radius / std::sin(start_angle) / spacing)) + 2;
    std::vector<Vec3d> places;
    for (int k = 0; k < static_cast<int>(shape.height / spacing) + 3; ++k)
        for (int j = -across; j < across; ++j)
            for (int i = -across; i < across; ++i) places.push_back(spacing * Vec3d{i + 0.5, j + 0.5, k + 0.5});
    std::stable_sort(places.begin(), places.end(), [&](const Vec3d& a, const Vec3d& b) { return length(a - middle) < length(b - middle); });
    places.resize(static_cast<std::size_t>(particles));
    disturb(places, spacing);
    for (Vec3d& p : places) p.z += plate_height;
    Scene scene = scene_with(places, particle_volume, temperature);
    put_on_plate(scene, cap.contact_angle);
    return scene;
}

Vec3d place(const Frame& f, std::size_t i)
{
    return {static_cast<double>(f.positions[i][0]), static_cast<double>(f.positions[i][1]), static_cast<double>(f.positions[i][2])};
}

Vec3d velocity(const Frame& f, std::size_t i)
{
    return {static_cast<double>(f.velocities[i][0]), static_cast<double>(f.velocities[i][1]), static_cast<double>(f.velocities[i][2])};
}

Vec3d middle(const Frame& f)
{
    Vec3d sum;
    for (std::size_t i = 0; i < f.positions.size(); ++i) sum += place(f, i);
    return (1.0 / static_cast<double>(f.positions.size())) * sum;
}

Vec3d mean_velocity(const Frame& f)
{
    Vec3d sum;
    for (std::size_t i = 0; i < f.velocities.size(); ++i) sum += velocity(f, i);
    return (1.0 / static_cast<double>(f.velocities.size())) * sum;
}

double agitation(const Frame& f)
{
    const Vec3d mean = mean_velocity(f);
    double sum = 0;
    for (std::size_t i = 0; i < f.velocities.size(); ++i) sum += dot(velocity(f, i) - mean, velocity(f, i) - mean);
    return std::sqrt(sum / static_cast<double>(f.velocities.size()));
}

DropOnPlate shape_over(double floor, const std::vector<Frame>& frames, double weight)
{
    double up = 0, square = 0;
    for (const Frame& f : frames) {
        const Vec3d m = middle(f);
        up += (m.z - floor) / static_cast<double>(frames.size());
        for (std::size_t i = 0; i < f.positions.size(); ++i) {
            const Vec3d d = place(f, i) - m;
            square += (d.x * d.x + d.y * d.y) / static_cast<double>(f.positions.size() * frames.size());
        }
    }
    return up > 0 ? drop_like(up, square, weight) : DropOnPlate{};
}

std::vector<double> times_between(double first, double last, int count)
{
    std::vector<double> times;
    times.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) times.push_back(first + (last - first) * k / (count - 1));
    return times;
}

} // namespace hygroloom
