// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The liquid's part of Solver: releasing drops and one step of the pressure loop. Included by solver.h.
#pragma once

#include "core/sim/solver.h"

#include <limits>

namespace hygroloom {

constexpr Real support_in_spacings = Real(2.0);
constexpr Real touching_in_spacings = Real(0.1); // to a skin; the cloth's field keeps most particles farther off
constexpr Real friction_coefficient = Real(0.2); // of water sliding on yarn, per normal impulse
constexpr double grain_viscosity = 0.015;        // numerical: calms motion from particle to particle, times sqrt(gamma spacing / rho)
constexpr double drip_distance = 5e-3;           // m below the fabric at which a particle counts as dripped off
constexpr double pressure_relaxation = 0.5;      // of a pressure correction; whole ones overshoot between close particles
constexpr int most_cells = 200000;               // of the grid that finds neighbours, if particles are not many more
constexpr Real skin_in_spacings = Real(0.2);     // by which neighbours are listed too far, to last for several steps
/// Of sqrt(gamma / (rho spacing)), at which a swing at a particle's own frequency would carry it a twentieth of the spacing.
constexpr double resting_speed = 0.05;         // root of the mean square
constexpr double fastest_resting_speed = 0.25; // of any particle away from the cloth: a drip gets faster
constexpr double most_hurry = 8;               // how much faster liquid creeps that was woken than it would have unasked
constexpr int steps_between_drinks = 8;        // of the liquid
constexpr int fewest_pressure_rounds = 3;
constexpr int most_pressure_rounds = 8;

template <typename Executor> void Solver<Executor>::load_liquid()
{
    double volume = 0, smallest = 1, highest = scene_.half_thickness;
    for (const SceneDroplet& d : scene_.droplets) {
        volume += d.volume;
        smallest = std::min(smallest, d.volume);
        highest = std::max(highest, d.centre.z + std::cbrt(d.volume));
    }
    const std::size_t drops = scene_.droplets.size(), standing = scene_.liquid.places.size();
    if (drops + standing == 0) return;
    for (const Vec3d& place : scene_.liquid.places) highest = std::max(highest, place.z);
    std::vector<float> profiles;
    shapes_.upload(yarn_shapes(scene_, profiles));
    profiles_.upload(profiles);
    // All particles weigh the same; a drop's number of them goes with its volume.
    const double particle_volume = standing > 0 ? scene_.liquid.particle_volume
                                                : volume / (static_cast<double>(scene_.particles_per_droplet) * static_cast<double>(drops));
    particle_mass_ = static_cast<Real>(particle_volume * scene_.climate.density);
    const double spacing = std::cbrt(particle_volume);
    spacing_ = static_cast<Real>(spacing);
    support_ = support_in_spacings * spacing_;
    reach_of_surface_ = static_cast<Real>(surface_support_in_spacings) * spacing_;
    stiffness_ = pressure_relaxation * pressure_stiffness(spacing, support_);
    capillary_dt_ =
        0.25 * std::sqrt(scene_.climate.density * std::pow(static_cast<double>(support_), 3) / (2.0 * pi * scene_.climate.surface_tension));
    liquid_dt_ = capillary_dt_;

    std::size_t capacity = standing;
    for (const SceneDroplet& d : scene_.droplets) capacity += particles_of(d.volume);
    if (scene_.swelling > 0) capacity += capacity / 2; // for what swollen yarns give back
    for (auto* b : {&place_, &sorted_place_, &motion_, &predicted_, &surface_}) {
        b->resize(capacity + lanes); // whole packs are read
        b->fill(far_away());
    }
    for (auto* b :
         {&position_, &velocity_, &force_, &pressure_force_, &wall_normal_, &sorted_position_, &sorted_velocity_, &sorted_normal_})
        b->resize(capacity);
    for (auto* b : {&allowed_, &wall_distance_, &sorted_distance_}) b->resize(capacity);
    for (auto* b : {&stress_, &sorted_stress_}) b->resize(scene_.shows_pressure ? capacity : 0);
    stress_.fill(0);
    stress_since_ = 0;
    for (auto* b : {&wall_segment_, &sorted_segment_, &key_, &order_, &near_count_, &distant_count_}) b->resize(capacity);
    for (auto* b : {&content_, &sorted_content_}) b->resize(capacity);
    near_.resize(capacity * most_near);
    slope_.resize(capacity * most_near);
    distant_.resize(capacity * most_distant);
    for (auto* b : {&listed_x_, &listed_y_, &listed_z_}) b->resize(capacity + lanes);
    moved_.resize(6);
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
    grid_.size = static_cast<Real>(size);
    grid_.origin = {static_cast<Real>(-0.5 * width - 2 * size), static_cast<Real>(-0.5 * height - 2 * size), static_cast<Real>(lowest)};
    const auto cells = [&](double extent) { return static_cast<int>(extent / size) + 5; };
    grid_.whole_x = cells(width);
    grid_.whole_y = cells(height);
    grid_.whole_z = cells(highest - lowest);
    box_.resize(6);
    if (standing > 0) load_particles();
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
    count_ = static_cast<int>(n);
    landing_ = std::numeric_limits<double>::infinity(); // what begins as it is may be about to move
    double fastest = 0;
    for (const Vec3d& v : scene_.liquid.velocities) fastest = std::max(fastest, length(v));
    liquid_dt_ = std::min(capillary_dt_, advective_step(fastest));
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
        if (count_ == 0 || asleep_) begin_anew();
        const auto added = static_cast<int>(particles_of(drop.volume));
        const std::vector<Vec3d> places = droplet_lattice(added, static_cast<double>(spacing_));
        const double radius = std::cbrt(drop.volume * 3.0 / (4.0 * pi));
        drop.centre.z = height_clear_of(living_particles(position_, alive_, count_), drop.centre, radius, static_cast<double>(spacing_));
        std::vector<Vec3> x;
        for (const Vec3d& place : places) {
            const Vec3d p = drop.centre + place;
            x.push_back({static_cast<Real>(p.x), static_cast<Real>(p.y), static_cast<Real>(p.z)});
        }
        const auto at = static_cast<std::size_t>(count_);
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
        count_ += added;
        listed_for_ = 0;
        const double fall = drop.centre.z - radius - scene_.half_thickness;
        const double landed =
            (std::sqrt(drop.speed * drop.speed + 2.0 * gravity_acceleration * std::max(0.0, fall)) - drop.speed) / gravity_acceleration;
        landing_ = std::max(landing_, drop.time + landed);
        settling_ = std::max(settling_, capillary_time(drop.volume));
        asleep_ = false;
        hurry_ = 1;
        delivered_ += static_cast<double>(water) * water_quantum;
        liquid_dt_ = std::min(next_droplet_ == 1 ? capillary_dt_ : liquid_dt_, advective_step(drop.speed));
    }
}

/// The grid's box about the particles there are; wider cells where they lie so far apart that going through the cells would cost more.
template <typename Executor> void Solver<Executor>::fit_grid()
{
    constexpr int nothing = std::numeric_limits<int>::min();
    box_.fill(nothing);
    each_particle("find box", FindBox{particle_views(), grid(), box_.data()});
    const std::vector<int> box = box_.download();
    const auto lowest = [&](int axis) { return box[static_cast<std::size_t>(axis)] == nothing ? 0 : -box[static_cast<std::size_t>(axis)]; };
    const auto highest = [&](int axis) { return std::max(0, box[static_cast<std::size_t>(axis) + 3]); };
    const auto cells = [&](int axis) { return std::int64_t((highest(axis) >> grid_.shift) - (lowest(axis) >> grid_.shift) + 1); };
    const std::int64_t most = std::max(most_cells, 2 * count_);
    grid_.shift = 0;
    while (cells(0) * cells(1) * cells(2) > most) ++grid_.shift;
    grid_.first_x = lowest(0) >> grid_.shift;
    grid_.first_y = lowest(1) >> grid_.shift;
    grid_.first_z = lowest(2) >> grid_.shift;
    grid_.nx = static_cast<int>(cells(0));
    grid_.ny = static_cast<int>(cells(1));
    grid_.nz = static_cast<int>(cells(2));
    if (const auto needed = static_cast<std::size_t>(grid_.cells()) + 2; cell_start_.size() < needed)
        cell_start_.resize(needed + needed / 2);
}

template <typename Executor> void Solver<Executor>::sort_particles()
{
    fit_grid();
    each_particle("find cell", FindCell{particle_views(), grid()});
    exec_.sort_by_key(key_, order_, count_, grid_.cells());
    Particles to = particle_views();
    to.position = sorted_position_.data();
    to.velocity = sorted_velocity_.data();
    to.wall_normal = sorted_normal_.data();
    to.wall_distance = sorted_distance_.data();
    to.wall_segment = sorted_segment_.data();
    to.content = sorted_content_.data();
    to.cloth_from = sorted_cloth_from_.data();
    to.place = sorted_place_.data();
    to.stress = sorted_stress_.data();
    each_particle("reorder", Reorder{order_.data(), position_.data(), velocity_.data(), wall_normal_.data(), wall_distance_.data(),
                                     wall_segment_.data(), place_.data(), scene_.shows_pressure ? stress_.data() : nullptr, content_.data(),
                                     cloth_from_.data(), key_.data(), grid_.cells(), to});
    position_.swap(sorted_position_);
    velocity_.swap(sorted_velocity_);
    wall_normal_.swap(sorted_normal_);
    wall_distance_.swap(sorted_distance_);
    wall_segment_.swap(sorted_segment_);
    content_.swap(sorted_content_);
    cloth_from_.swap(sorted_cloth_from_);
    place_.swap(sorted_place_);
    stress_.swap(sorted_stress_);
    exec_.for_each("cell starts", count_ + 1, FindCellStarts{grid(), count_});
    count_ = cell_start_.read(static_cast<std::size_t>(grid_.cells())); // the dead sort last
}

/// Whether all that count are still listed: no two particles have come nearer to each other than by the skin, and few are dead.
template <typename Executor> bool Solver<Executor>::neighbours_hold(std::int64_t dead)
{
    if (listed_for_ == 0) {
        skin_ = skin_in_spacings * spacing_;
        return false;
    }
    const std::vector<int> moved = moved_.download();
    const auto middle = [&](std::size_t axis) {
        return static_cast<Real>(0.5 * (moved[axis] - moved[axis + 3]) / parts_of_spacing) * spacing_;
    };
    maxima_.write(0, 0);
    each_particle("farthest moved", FindFarthestMoved{particle_views(), {middle(0), middle(1), middle(2)}, maxima_.data()});
    const double apart = 2.0 * std::sqrt(static_cast<double>(from_ordered_bits(maxima_.read(0)))) * static_cast<double>(spacing_);
    if (apart < 0.999 * static_cast<double>(skin_) && 16 * dead < count_) return true;
    skin_ = 2 * apart / listed_for_ < skin_in_spacings * spacing_ ? skin_in_spacings * spacing_ : Real(0); // none if it would not last
    return false;
}

/// Lists neighbours and brings particles into the order of cells, unless what is listed still holds.
template <typename Executor> void Solver<Executor>::list_neighbours()
{
    moved_.fill(std::numeric_limits<int>::min() / 2);
    if (!neighbours_hold(each_particle("begin step", BeginStep{particle_views(), moved_.data()}))) {
        sort_particles();
        each_particle("neighbours", FindNeighbours{particle_views(), grid(), skin_});
        listed_for_ = 0;
        ++listings_;
    }
    ++listed_for_;
}

template <typename Executor> void Solver<Executor>::correct_pressure(double dt)
{
    const Real stiffness = static_cast<Real>(stiffness_ / (dt * dt));
    for (int round = 0; round < most_pressure_rounds; ++round) {
        const std::int64_t error = each_particle("pressure", CorrectPressure{particle_views(), liquid(dt), stiffness});
        each_particle("pressure force", FindPressureForce{particle_views(), liquid(dt)});
        ++pressure_rounds_;
        if (round + 1 >= fewest_pressure_rounds && static_cast<double>(error) * 1e-6 < scene_.density_tolerance * count_) break;
    }
}

template <typename Executor> void Solver<Executor>::step_liquid(double dt)
{
    list_neighbours();
    if (count_ == 0) return;
    const Real step = static_cast<Real>(dt);
    each_particle("cloth", FeelCloth{particle_views(), shape(), beads()});
    each_particle("surface", FindSurface{particle_views(), liquid(dt)});
    each_particle("forces", FindForces{particle_views(), liquid(dt)});
    correct_pressure(dt);
    if (scene_.shows_pressure) each_particle("stress", FindStress{particle_views(), liquid(dt), step});
    maxima_.write(0, 0);
    each_particle("move", MoveParticles{particle_views(), step, maxima_.data()});
    const Real half_spacing = Real(0.5) * spacing_;
    double radius = scene_.shapes[0].half_height;
    for (const ContactShape& shape : scene_.shapes) radius = std::min(radius, shape.half_height);
    const double drag = 20.0 * scene_.climate.viscosity / scene_.climate.density * dt / (radius * radius) / hurry_;
    each_particle("meet yarns",
                  MeetYarns{particle_views(), shape(), vessel(), scene_.vessel ? reach_of_surface_ : 2 * spacing_,
                            touching_in_spacings * spacing_, half_spacing, static_cast<Real>(friction_coefficient / hurry_),
                            static_cast<Real>(drag), static_cast<Real>(-scene_.half_thickness - drip_distance), sums_.data()});
    choose_liquid_step();
    ++liquid_steps_;
}

/// Yarns drink from drops once in several steps, if any may be left out; and whenever now is set.
template <typename Executor> void Solver<Executor>::drink_drops(double dt, bool now)
{
    thirst_ += dt;
    if (!now && ++thirsty_steps_ < (scene_.settle_share > 0 ? steps_between_drinks : 1)) return;
    give_to_segments(thirst_);
    thirst_ = 0;
    thirsty_steps_ = 0;
}

template <typename Executor> void Solver<Executor>::give_to_segments(double dt)
{
    each_particle("touch", TouchSegments{particle_views(), shape(), contact_.data()});
    each_particle("give",
                  GiveToSegments{particle_views(), shape(), segments(), scene_.climate.density, dt, {reach_.data()}, sums_.data() + 2});
    each_particle("forget", ForgetContact{particle_views(), shape(), contact_.data()});
}

/// In which a volume of liquid finds its shape, s.
template <typename Executor> double Solver<Executor>::capillary_time(double volume) const
{
    return std::sqrt(scene_.climate.density * volume / scene_.climate.surface_tension);
}

/// Whether the liquid has come to rest: it falls asleep, takes no steps and only drains.
template <typename Executor> void Solver<Executor>::watch_motion(double dt)
{
    if (scene_.settle_share <= 0 || count_ == 0) return;
    sums_.write(1, 0);
    maxima_.write(2, 0);
    const SumSpeeds sum{particle_views(), sums_.data() + 1, maxima_.data() + 2};
    exec_.for_each("speeds", sum.parts(), sum);
    const double square = static_cast<double>(sums_.read(1)) * SumSpeeds::quantum / count_;
    const double unit = scene_.climate.surface_tension / (scene_.climate.density * static_cast<double>(spacing_));
    const double share = std::min(1.0, dt / std::max(settling_, dt)); // means over the time of settling: a kick is no motion
    mean_square_ += share * (square - mean_square_);
    largest_square_ += share * (static_cast<double>(from_ordered_bits(maxima_.read(2))) - largest_square_);
    if (time_ < landing_) roused_ = time_;
    const bool moves = mean_square_ > resting_speed * resting_speed * unit * hurry_ * hurry_ ||
                       largest_square_ > fastest_resting_speed * fastest_resting_speed * unit;
    asleep_ = !moves && time_ - roused_ >= settling_;
    if (asleep_) {
        sums_.write(2, 0);
        fell_asleep_ = time_;
        hurry_ = 1;
    }
}

/// Wakes the liquid when so much was drunk since it fell asleep that its shape must change. What has changed is as large as that, and so
/// is the time in which it settles.
template <typename Executor> bool Solver<Executor>::asleep()
{
    if (!asleep_) return false;
    const double drunk = static_cast<double>(sums_.read(2)) * water_quantum / static_cast<double>(particle_mass_);
    if (drunk < 1.0 || drunk < scene_.settle_share * count_) return true;
    asleep_ = false;
    roused_ = time_;
    settling_ = capillary_time(drunk * static_cast<double>(particle_mass_) / scene_.climate.density);
    // To move as far as it would have meanwhile, it is less dragged on. Beyond the time a whole drop needs, little is left to move.
    const double slept = time_ - fell_asleep_,
                 whole = capillary_time(count_ * static_cast<double>(particle_mass_) / scene_.climate.density);
    settling_ = std::max(settling_, std::min(slept / (most_hurry - 1), whole));
    hurry_ = std::min(most_hurry, 1 + slept / settling_);
    return false;
}

/// Capillary, advective and viscous limits.
template <typename Executor> void Solver<Executor>::choose_liquid_step()
{
    const double fastest = static_cast<double>(from_ordered_bits(maxima_.read(0)));
    const double viscous = 0.125 * static_cast<double>(support_ * support_) * scene_.climate.density / scene_.climate.viscosity;
    liquid_dt_ = std::min({capillary_dt_, advective_step(fastest), viscous});
}

template <typename Executor> double Solver<Executor>::advective_step(double speed) const
{
    return 0.4 * static_cast<double>(spacing_) / std::max(1e-6, speed);
}

template <typename Executor> Particles Solver<Executor>::particle_views()
{
    Particles p;
    p.count = count_;
    p.mass = particle_mass_;
    p.per_quantum = static_cast<Real>(water_quantum / static_cast<double>(particle_mass_));
    p.support = support_;
    p.reach = reach_of_surface_;
    p.spacing = spacing_;
    p.position = position_.data();
    p.velocity = velocity_.data();
    p.place = place_.data();
    p.motion = motion_.data();
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
    p.near_count = near_count_.data();
    p.distant_count = distant_count_.data();
    p.allowed = allowed_.data();
    p.stress = scene_.shows_pressure ? stress_.data() : nullptr;
    return p;
}

template <typename Executor> CellGrid Solver<Executor>::grid()
{
    CellGrid g = grid_;
    g.key = key_.data();
    g.start = cell_start_.data();
    return g;
}

template <typename Executor> TextileShape Solver<Executor>::shape()
{
    return {yarns(),
            static_cast<Real>(scene_.half_thickness),
            static_cast<Real>(scene_.warp_pitch),
            static_cast<Real>(scene_.weft_pitch),
            scene_.profile_samples,
            shapes_.data(),
            profiles_.data(),
            warp_up_.data(),
            shift_.data()};
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

template <typename Executor> LiquidParameters Solver<Executor>::liquid(double dt) const
{
    LiquidParameters l;
    l.density = static_cast<Real>(scene_.climate.density);
    l.kinematic_viscosity = static_cast<Real>(
        scene_.climate.viscosity / scene_.climate.density +
        grain_viscosity * std::sqrt(scene_.climate.surface_tension * static_cast<double>(spacing_) / scene_.climate.density));
    l.surface_tension = static_cast<Real>(scene_.climate.surface_tension);
    l.gravity = static_cast<Real>(scene_.gravity);
    l.dt = static_cast<Real>(dt);
    l.surface = surface_energy(l.surface_tension, spacing_);
    l.vessel = vessel();
    l.kept_excess = static_cast<Real>(std::max(0.0, 1.0 - dt / capillary_dt_));
    return l;
}

} // namespace hygroloom
