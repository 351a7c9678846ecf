// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The liquid's part of Solver: releasing drops, and going on to when the liquid meets the yarns. Included by solver.h.
#pragma once

#include "core/solver/solver.h"

#include <limits>

namespace hygroloom::inline HL_PRECISION {

constexpr double drip_distance = 5e-3;      // m below the fabric, or beside it, at which a particle counts as dripped off
constexpr double pressure_relaxation = 0.5; // of a pressure correction; whole ones overshoot between close particles
constexpr int most_flow_steps = 1000;       // without a look at the clock

template <typename Executor> void Solver<Executor>::load_liquid()
{
    double volume = 0, smallest = 1, highest = scene_.half_thickness;
    for (const SceneDroplet& d : scene_.droplets) {
        volume += d.volume;
        smallest = std::min(smallest, d.volume);
        highest = std::max(highest, d.centre.z + std::cbrt(d.volume));
    }
    const std::size_t drops = scene_.droplets.size(), standing = scene_.liquid.places.size();
    room_ = 0;
    if (drops + standing == 0) return;
    for (const Vec3d& place : scene_.liquid.places) highest = std::max(highest, place.z);
    const ClothShape cloth(scene_);
    textile_ = cloth.numbers;
    shapes_.upload(cloth.shapes);
    profiles_.upload(cloth.profiles);
    paths_.upload(cloth.paths);
    shift_.upload(cloth.shift);
    // All particles weigh the same; a drop's number of them goes with its volume.
    const double particle_volume = standing > 0 ? scene_.liquid.particle_volume
                                                : volume / (static_cast<double>(scene_.particles_per_droplet) * static_cast<double>(drops));
    particle_mass_ = static_cast<Real>(particle_volume * scene_.climate.density);
    const double spacing = std::cbrt(particle_volume);
    spacing_ = static_cast<Real>(spacing);
    support_ = Real(support_in_spacings) * spacing_;
    reach_of_surface_ = static_cast<Real>(surface_support_in_spacings) * spacing_;
    static_assert(2 * support_in_spacings >= surface_support_in_spacings); // see DistantPairs
    set_rules(spacing);
    liquid_room_ = room_about_sample();
    flow_.longest_dt = rules_.longest_step();

    std::size_t capacity = standing;
    for (const SceneDroplet& d : scene_.droplets) capacity += particles_of(d.volume);
    if (scene_.swelling > 0) capacity += capacity / 2; // for what swollen yarns give back
    room_ = static_cast<int>(capacity);
    for (auto* b : {&place_, &sorted_place_, &motion_, &standing_, &predicted_, &surface_}) {
        b->resize(capacity + lanes); // whole packs are read
        b->fill(far_away());
    }
    for (auto* b :
         {&position_, &velocity_, &force_, &pressure_force_, &wall_normal_, &sorted_position_, &sorted_velocity_, &sorted_normal_})
        b->resize(capacity);
    for (auto* b : {&allowed_, &wall_distance_, &sorted_distance_}) b->resize(capacity);
    for (auto* b : {&mirrored_, &sorted_mirrored_}) b->resize(scene_.vessel ? capacity : 0);
    mirrored_.fill(0);
    for (auto* b : {&stress_, &sorted_stress_}) b->resize(scene_.shows_pressure ? capacity : 0);
    stress_.fill(0);
    stress_since_ = 0;
    for (auto* b : {&wall_segment_, &sorted_segment_, &key_, &order_, &near_first_, &distant_first_, &near_count_, &distant_count_})
        b->resize(capacity);
    for (auto* b : {&content_, &sorted_content_}) b->resize(capacity);
    const std::size_t lists = (capacity + elements_beside - 1) / elements_beside * elements_beside;
    near_.resize(lists * most_near);
    slope_.resize(lists * most_near);
    distant_.resize(lists * most_distant);
    for (auto* b : {&listed_x_, &listed_y_, &listed_z_}) b->resize(capacity + lanes);
    drinks_ = std::any_of(scene_.yarns.begin(), scene_.yarns.end(), [](const YarnParameters& yarn) { return yarn.intake_flux > 0; });
    cloth_.resize(capacity);
    for (auto* b : {&cloth_from_, &sorted_cloth_from_}) b->resize(capacity);
    const HostBeads beads = make_beads(scene_, spacing, static_cast<double>(support_), static_cast<double>(reach_of_surface_));
    beads_ = beads.view;
    bead_.upload(beads.beads);
    bead_types_.upload(beads.types);
    alive_.resize(capacity);

    double width = scene_.ends * 1.0 * scene_.warp_pitch, height = scene_.picks * 1.0 * scene_.weft_pitch;
    for (const Vec3d& place : scene_.liquid.places) {
        width = std::max(width, 4 * std::abs(place.x)); // with room to spread
        height = std::max(height, 4 * std::abs(place.y));
    }
    const double lowest = scene_.vessel && standing > 0 ? scene_.vessel->low.z : -scene_.half_thickness - drip_distance;
    // Cells of half the reach.
    const double size = std::max(0.5 * static_cast<double>(reach_of_surface_), std::max({width, height, highest - lowest}) * 1e-5);
    CellGrid& grid = flow_.grid;
    grid.size = static_cast<Real>(size);
    grid.per_size = Real(1) / grid.size;
    grid.origin = {static_cast<Real>(-0.5 * width - 2 * size), static_cast<Real>(-0.5 * height - 2 * size), static_cast<Real>(lowest)};
    const auto cells = [&](double extent) { return static_cast<int>(extent / size) + 5; };
    grid.whole_x = narrower * cells(width);
    grid.whole_y = cells(height);
    grid.whole_z = cells(highest - lowest);
    const int most = std::max(most_cells, 2 * room_);
    cell_start_.resize(static_cast<std::size_t>(most) + 3);
    grid.key = key_.data();
    grid.start = cell_start_.data();
    exec_.prepare_sort(room_, most);
    control_.resize(1);
    if (standing > 0) load_particles();
}

/// The liquid's own and the numerical one, m2/s.
template <typename Executor> double Solver<Executor>::viscosity() const
{
    const ClimateParameters& climate = scene_.climate;
    return viscosity_of_particles(climate.viscosity / climate.density, climate.surface_tension / climate.density,
                                  static_cast<double>(spacing_));
}

/// Rounds of pressure press liquid together that stands deep, by its depth x gravity over the square of spacing / step, and longer steps
/// than this have a column bounce: at 0.2 by 5 % of its pressure, at 0.25 by 10 %. Counts what is there from the start; on cloth no drop
/// stands as deep.
template <typename Executor> double Solver<Executor>::weight_step() const
{
    double depth = 0;
    if (scene_.vessel)
        for (const Vec3d& place : scene_.liquid.places) depth = std::max(depth, place.z - scene_.vessel->low.z);
    const double fall = std::sqrt(scene_.gravity * depth);
    return fall > 0 ? 0.09 * static_cast<double>(spacing_) / fall : std::numeric_limits<double>::infinity();
}

/// What stays the same for the liquid's steps.
template <typename Executor> void Solver<Executor>::set_rules(double spacing)
{
    const ClimateParameters& climate = scene_.climate;
    rules_.spacing = spacing_;
    rules_.particle_mass = static_cast<double>(particle_mass_);
    rules_.density = climate.density;
    rules_.surface_tension = climate.surface_tension;
    const LiquidSteps longest = longest_steps(climate.surface_tension / climate.density, viscosity(), static_cast<double>(spacing_));
    const double weight = weight_step();
    rules_.correction_time = std::min(longest.capillary, 4.0 * weight); // over one, what stands is 3 to 7 % too high in pressure
    rules_.capillary_dt = scene_.liquid_step_factor * longest.capillary;
    rules_.viscous_dt = scene_.liquid_step_factor * longest.viscous;
    rules_.weight_dt = scene_.liquid_step_factor * weight;
    rules_.courant = scene_.liquid_step_factor * 0.4;
    rules_.steps_between_drinks = scene_.steps_between_drinks;
    rules_.stiffness = pressure_relaxation * pressure_stiffness(spacing, support_);
    rules_.settle_share = scene_.settle_share;
    rules_.drag = 20.0 * climate.viscosity / climate.density;
    double thinnest = scene_.shapes[0].half_height;
    for (const ContactShape& shape : scene_.shapes) thinnest = std::min(thinnest, shape.half_height);
    rules_.thinnest2 = thinnest * thinnest;
}

/// The liquid that is there from the start.
template <typename Executor> void Solver<Executor>::load_particles()
{
    const auto single = [](const std::vector<Vec3d>& values) {
        std::vector<Vec3> result;
        for (const Vec3d& v : values) result.push_back({static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)});
        return result;
    };
    const std::size_t n = scene_.liquid.places.size();
    position_.write_range(0, single(scene_.liquid.places));
    velocity_.write_range(0, single(scene_.liquid.velocities));
    wall_normal_.write_range(0, std::vector<Vec3>(n));
    wall_distance_.write_range(0, std::vector<Real>(n, Real(0))); // not looked for yet
    wall_segment_.write_range(0, std::vector<int>(n, no_wall));
    cloth_from_.write_range(0, std::vector<ClothExpansion>(n));
    content_.write_range(
        0, std::vector<std::int64_t>(n, std::llround(scene_.liquid.particle_volume * scene_.climate.density / water_quantum)));
    alive_.write_range(0, std::vector<std::uint8_t>(n, 1));
    place_.write_range(0, std::vector<Quad>(n));
    flow_.count = static_cast<int>(n);
    flow_.landing = std::numeric_limits<double>::infinity(); // what begins as it is may be about to move
    double fastest = 0;
    for (const Vec3d& v : scene_.liquid.velocities) fastest = std::max(fastest, length(v));
    flow_.longest_dt = std::min(rules_.longest_step(), rules_.advective_step(fastest));
}

template <typename Executor> std::size_t Solver<Executor>::particles_of(double volume) const
{
    return static_cast<std::size_t>(std::max(1LL, std::llround(volume / std::pow(static_cast<double>(spacing_), 3))));
}

/// Where particles are that no yarn has taken up; the last step's dead are still among the count.
template <typename Places, typename Flags> std::vector<Vec3> living_particles(const Places& position, const Flags& alive, int count)
{
    std::vector<Vec3> living;
    if (count == 0) return living;
    const std::vector<Vec3> places = position.download();
    const std::vector<std::uint8_t> lives = alive.download();
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        if (lives[i]) living.push_back(places[i]);
    return living;
}

template <typename Executor> void Solver<Executor>::release_droplets()
{
    while (next_droplet_ < scene_.droplets.size() && scene_.droplets[next_droplet_].time <= time_) {
        SceneDroplet drop = scene_.droplets[next_droplet_++];
        if (flow_.count == 0 || flow_.asleep) begin_anew();
        const auto added = static_cast<int>(particles_of(drop.volume));
        const std::vector<Vec3d> places = droplet_lattice(added, static_cast<double>(spacing_));
        const double radius = std::cbrt(drop.volume * 3.0 / (4.0 * pi));
        drop.centre.z =
            height_clear_of(living_particles(position_, alive_, flow_.count), drop.centre, radius, static_cast<double>(spacing_));
        std::vector<Vec3> x;
        for (const Vec3d& place : places) {
            const Vec3d p = drop.centre + place;
            x.push_back({static_cast<Real>(p.x), static_cast<Real>(p.y), static_cast<Real>(p.z)});
        }
        const auto at = static_cast<std::size_t>(flow_.count);
        const auto n = static_cast<std::size_t>(added);
        position_.write_range(at, x);
        velocity_.write_range(at, std::vector<Vec3>(n, Vec3{0, 0, static_cast<Real>(-drop.speed)}));
        wall_normal_.write_range(at, std::vector<Vec3>(n));
        wall_distance_.write_range(at, std::vector<Real>(n, Real(0))); // not looked for yet
        wall_segment_.write_range(at, std::vector<int>(n, no_wall));
        cloth_from_.write_range(at, std::vector<ClothExpansion>(n));
        // The drop's own water, shared out to the last quantum.
        const std::int64_t water = std::llround(drop.volume * scene_.climate.density / water_quantum);
        std::vector<std::int64_t> content(n, water / added);
        content.back() += water % added;
        content_.write_range(at, content);
        place_.write_range(at, std::vector<Quad>(n));
        alive_.write_range(at, std::vector<std::uint8_t>(n, 1));
        flow_.count += added;
        flow_.listed_for = 0;
        const double fall = drop.centre.z - radius - scene_.half_thickness;
        const double landed =
            (std::sqrt(drop.speed * drop.speed + 2.0 * gravity_acceleration * std::max(0.0, fall)) - drop.speed) / gravity_acceleration;
        flow_.landing = std::max(flow_.landing, drop.time + landed);
        flow_.settling = std::max(flow_.settling, rules_.capillary_time(drop.volume));
        flow_.asleep = 0;
        flow_.hurry = 1;
        delivered_ += static_cast<double>(water) * water_quantum;
        flow_.longest_dt = std::min(next_droplet_ == 1 ? rules_.longest_step() : flow_.longest_dt, rules_.advective_step(drop.speed));
    }
}

/// Takes the liquid towards the moment when it meets the yarns, for about the given wall time; whether it is there.
template <typename Executor> bool Solver<Executor>::flow(double wall_seconds)
{
    if (flow_.count == 0 || time_ >= sync_time_) return true;
    flow_.time = time_;
    flow_.sync_time = sync_time_;
    const double budget = 0.25 * wall_seconds / std::max(1e-9, wall_per_step_);
    flow_.budget = wall_per_step_ > 0 ? static_cast<int>(std::clamp(budget, 1.0, double(most_flow_steps))) : 1;
    const std::int64_t steps = flow_.steps;
    control_.write(0, flow_);
    const double seconds = exec_.go_through(liquid_flow(), room_);
    flow_ = control_.read(0);
    if (flow_.side == 1) change_sides();
    time_ = flow_.time;
    if (flow_.steps > steps) wall_per_step_ = seconds / static_cast<double>(flow_.steps - steps);
    return time_ >= sync_time_ || flow_.count == 0 || flow_.drains.on;
}

template <typename Executor> void Solver<Executor>::change_sides()
{
    position_.swap(sorted_position_);
    velocity_.swap(sorted_velocity_);
    wall_normal_.swap(sorted_normal_);
    wall_distance_.swap(sorted_distance_);
    wall_segment_.swap(sorted_segment_);
    content_.swap(sorted_content_);
    cloth_from_.swap(sorted_cloth_from_);
    place_.swap(sorted_place_);
    mirrored_.swap(sorted_mirrored_);
    stress_.swap(sorted_stress_);
}

template <typename Executor> LiquidFlow Solver<Executor>::liquid_flow()
{
    LiquidFlow flow;
    flow.control = control_.data();
    flow.rules = rules_;
    flow.particles = particle_views();
    change_sides();
    const Particles other = particle_views();
    change_sides();
    flow.sorted = {other.position,     other.velocity, other.place,  other.wall_normal, other.wall_distance,
                   other.wall_segment, other.mirrored, other.stress, other.cloth_from,  other.content};
    flow.textile = shape();
    flow.beads = beads();
    flow.liquid = liquid();
    flow.segments = segments();
    flow.wall_reach = scene_.vessel ? reach_of_surface_ : 2 * spacing_;
    flow.room = liquid_room_;
    flow.density_tolerance = scene_.density_tolerance;
    flow.drinks = drinks_;
    flow.reach = reach_.data();
    flow.order = order_.data();
    flow.key = key_.data();
    flow.start = cell_start_.data();
    return flow;
}

/// As far as drops reach while they fall, and a little farther. Liquid that is there from the start may be anywhere beside the sample.
template <typename Executor> Room Solver<Executor>::room_about_sample() const
{
    double half_x = 0.5 * scene_.ends * scene_.warp_pitch, half_y = 0.5 * scene_.picks * scene_.weft_pitch;
    for (const SceneDroplet& drop : scene_.droplets) {
        const double radius = std::cbrt(drop.volume * 3.0 / (4.0 * pi));
        half_x = std::max(half_x, std::abs(drop.centre.x) + radius);
        half_y = std::max(half_y, std::abs(drop.centre.y) + radius);
    }
    const double beside = scene_.liquid.places.empty() ? drip_distance : std::numeric_limits<float>::max();
    return {static_cast<Real>(half_x + beside), static_cast<Real>(half_y + beside),
            static_cast<Real>(-scene_.half_thickness - drip_distance)};
}

template <typename Executor> Particles Solver<Executor>::particle_views()
{
    Particles p;
    p.room = room_;
    p.mass = particle_mass_;
    p.per_quantum = static_cast<Real>(water_quantum / static_cast<double>(particle_mass_));
    p.support = support_;
    p.reach = reach_of_surface_;
    p.spacing = spacing_;
    p.position = position_.data();
    p.velocity = velocity_.data();
    p.place = place_.data();
    p.motion = motion_.data();
    p.standing = standing_.data();
    p.predicted = predicted_.data();
    p.surface = surface_.data();
    p.force = force_.data();
    p.pressure_force = pressure_force_.data();
    p.wall_normal = wall_normal_.data();
    p.wall_distance = wall_distance_.data();
    p.wall_segment = wall_segment_.data();
    p.cloth = cloth_.data();
    p.cloth_from = cloth_from_.data();
    p.content = content_.data();
    p.alive = alive_.data();
    p.near = near_.data();
    p.distant = distant_.data();
    p.slope = slope_.data();
    p.listed_x = listed_x_.data();
    p.listed_y = listed_y_.data();
    p.listed_z = listed_z_.data();
    p.near_first = near_first_.data();
    p.distant_first = distant_first_.data();
    p.near_count = near_count_.data();
    p.distant_count = distant_count_.data();
    p.allowed = allowed_.data();
    p.mirrored = scene_.vessel ? mirrored_.data() : nullptr;
    p.stress = scene_.shows_pressure ? stress_.data() : nullptr;
    return p;
}

template <typename Executor> TextileShape Solver<Executor>::shape()
{
    TextileShape t = textile_;
    static_cast<Yarns&>(t) = yarns();
    t.shapes = shapes_.data();
    t.profiles = profiles_.data();
    t.paths = paths_.data();
    t.warp_up = warp_up_.data();
    t.shift = shift_.data();
    return t;
}

template <typename Executor> Beads Solver<Executor>::beads()
{
    Beads b = beads_;
    b.bead = bead_.data();
    b.types = bead_types_.data();
    return b;
}

template <typename Executor> Vessel Solver<Executor>::vessel() const
{
    if (!scene_.vessel) return {};
    const auto single = [](const Vec3d& v) { return Vec3{static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)}; };
    return {true, single(scene_.vessel->low), single(scene_.vessel->high),
            static_cast<Real>(scene_.vessel->adhesion / scene_.climate.surface_tension - 1.0)};
}

template <typename Executor> LiquidParameters Solver<Executor>::liquid()
{
    LiquidParameters l;
    l.density = static_cast<Real>(scene_.climate.density);
    l.kinematic_viscosity = static_cast<Real>(viscosity());
    l.surface_tension = static_cast<Real>(scene_.climate.surface_tension);
    l.gravity = static_cast<Real>(scene_.gravity);
    l.surface = surface_energy(l.surface_tension, spacing_);
    l.vessel = vessel();
    l.step = &control_.data()->step;
    return l;
}

} // namespace hygroloom::inline HL_PRECISION
