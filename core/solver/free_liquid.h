// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The free liquid: its particles, the drops that release them, and its steps up to the time at which it meets the yarns.
#pragma once

#include "core/solver/droplet.h"
#include "core/solver/host_cloth.h"
#include "core/solver/liquid_start.h"
#include "core/solver/state_archive.h"
#include "core/solver/steps/drop_supply.h"
#include "core/solver/steps/liquid_flow.h"
#include "core/solver/stock.h"
#include "core/solver/yarn_network.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom::inline HL_PRECISION {

constexpr int most_flow_steps = 1000; // without a look at the clock
/// Before a drop lands, in which its lattice of particles comes to rest as a drop.
constexpr double capillary_times_to_land = 5;
constexpr double spacings_to_land = 8; ///< from the cloth, farther than its loops, hairs and kernels reach

/// The scene must outlive it. What it gives to the yarns and takes back from them passes as WaterAbsorbed and WaterGivenBack.
template <typename Executor> class FreeLiquid {
public:
    template <typename T> using Buffer = typename Executor::template Buffer<T>;

    explicit FreeLiquid(Executor& executor) : exec_(executor) {}

    void load(const Scene& scene);
    int count() const { return flow_.count; }
    std::int64_t steps() const { return flow_.steps; }
    std::int64_t pressure_rounds() const { return flow_.rounds; }
    std::int64_t listings() const { return flow_.listings; } ///< of neighbours
    /// Whether there is none or it sleeps.
    bool rests() const { return flow_.count == 0 || flow_.asleep; }
    /// Whether it may soon come to the yarns: not while it sleeps on cloth that does not absorb it.
    bool is_about() const { return flow_.count > 0 && !(flow_.asleep && !absorbed_); }
    /// Whether it is seen on the cloth; where yarns do not draw in their own step, whether there is any.
    bool is_on_top() const { return flow_.count > 0 && (flow_.above > flow_.unseen || !offers_); }

    /// When the next drop is released, s.
    double next_drop() const
    {
        return next_droplet_ < scene_->supply.droplets.size() && !scene_->caps.on ? scene_->supply.droplets[next_droplet_].time
                                                                                  : std::numeric_limits<double>::infinity();
    }
    /// The next drop; returns its water, kg.
    double release_drop();

    /// Takes the liquid from a time (s), which it brings up to date, towards the time when it meets the yarns, for about the given wall
    /// time; whether it is there.
    bool flow(double& time, double sync_time, double wall_seconds, const WaterAbsorbed& absorbed);

    /// Offers yarns the particles that they touch now, where they draw as their liquid flows; whether it does.
    bool offer(double time, const WaterAbsorbed& absorbed);
    void take_payment(const Segments& segments); ///< of what they drew in their step

    /// Drops that have landed, for the air: each shares in the liquid and in the face that is touched by what it brought.
    std::vector<CapOnFace> standing(double time);
    /// Takes quanta off that the air has taken from them.
    void evaporate(std::int64_t quanta);

    /// Of what swollen yarns give back, by how many particles at most and from what surplus (kg) on.
    double least_given_back() const
    {
        constexpr double least_part = 0.25; // of a particle
        return least_part * static_cast<double>(start_.mass);
    }
    std::size_t room_for_given_back() const;
    /// Returns whether it wakes the liquid.
    bool take_back(const WaterGivenBack& given, const Segments& segments, double time);

    void take_stock(Stock& stock);
    /// From this time (s) on, leaving out what they were before.
    void sum_stresses_from(double time)
    {
        if (scene_->rules.shows_pressure) particles_.stress.fill(0);
        stress_since_ = time;
    }
    template <typename LookAt> void show(const LookAt& look_at, Stock& stock);

    template <typename Archive> void pass_state(Archive& archive);

private:
    std::size_t count_of(ParticleCount count) const;
    double falls_for(const SceneDroplet& drop) const;
    void take_off(const SceneDroplet& drop, double landed, bool alone);
    void fall(double& time, double until);
    void make_room();
    void load_cloth();
    void load_standing();
    void add_particles(const std::vector<Vec3>& places, const std::vector<Vec3>& velocities, const std::vector<std::int64_t>& contents);
    std::vector<Vec3> living();
    LiquidFlow liquid_flow(const WaterAbsorbed& absorbed);
    /// What sorting brought to the other side is where particles are from then on.
    void change_sides()
    {
        SortedParticles::each([](const auto&, auto& here, auto& there) { here.swap(there); }, particles_, sorted_);
    }
    Particles particle_views();
    TextileShape shape(const Segments& segments);

    Executor& exec_;
    const Scene* scene_ = nullptr;
    LiquidStart start_;
    LiquidRules rules_;
    Room about_sample_;
    LiquidControl flow_;            ///< as it was when last looked at
    Buffer<LiquidControl> control_; ///< where stages change it
    bool absorbed_ = false;         ///< whether any yarn absorbs liquid from drops
    bool offers_ = false;           ///< whether they draw it as their liquid flows: see particles_offer()
    bool offered_ = false;          ///< before the yarns' step
    std::size_t next_droplet_ = 0;
    double wall_per_step_ = 0; ///< s
    double stress_since_ = 0;  ///< s, when the stresses began to be summed

    ParticleFields<Buffer> particles_;
    SortedFields<Buffer> sorted_;
    Buffer<int> key_, order_, cell_start_;
    Buffer<int> from_;              ///< segments that give back liquid
    Buffer<std::int64_t> touched_;  ///< see SumTouching: water, width
    std::int64_t in_particles_ = 0; ///< quanta, of standing()
    ManyQuanta evaporated_;

    TextileShape textile_; ///< its numbers; the pointers come with shape()
    Buffer<YarnShape> shapes_;
    Buffer<Quad> profiles_, paths_, bead_;
    Buffer<float> shift_;
    Beads beads_;             ///< their counts; the pointers come with liquid_flow()
    Buffer<int> first_beads_; ///< see Beads
    Buffer<BeadType> bead_types_;
};

template <typename Executor> std::size_t FreeLiquid<Executor>::count_of(ParticleCount count) const
{
    const auto room = static_cast<std::size_t>(start_.room);
    const std::size_t lists = (room + elements_beside - 1) / elements_beside * elements_beside;
    switch (count) {
    case ParticleCount::packs: return room + lanes;
    case ParticleCount::near_slots: return lists * most_near;
    case ParticleCount::distant_slots: return lists * most_distant;
    case ParticleCount::vessel_particles: return scene_->liquid.vessel ? room : 0;
    case ParticleCount::shown_pressures: return scene_->rules.shows_pressure ? room : 0;
    case ParticleCount::particles: break;
    }
    return room;
}

template <typename Executor> void FreeLiquid<Executor>::load(const Scene& scene)
{
    scene_ = &scene;
    next_droplet_ = 0;
    flow_ = {};
    rules_ = {};
    evaporated_ = {};
    touched_.resize(2);
    start_ = liquid_start(scene);
    if (start_.room == 0) return;
    rules_ = liquid_rules(scene, start_);
    about_sample_ = room_about_sample(scene);
    flow_.longest_dt = rules_.longest_step();
    absorbed_ = std::any_of(scene.cloth.yarns.begin(), scene.cloth.yarns.end(), [](const auto& yarn) { return yarn.absorbs; });
    offers_ = absorbed_ && particles_offer(scene);
    load_cloth();
    make_room();
    if (!scene.liquid.places.empty()) load_standing();
}

template <typename Executor> void FreeLiquid<Executor>::load_cloth()
{
    const ClothShape cloth(*scene_);
    textile_ = cloth.numbers;
    shapes_.upload(cloth.shapes);
    profiles_.upload(cloth.profiles);
    paths_.upload(cloth.paths);
    shift_.upload(cloth.shift);
    const HostBeads beads = make_beads(*scene_, cloth, start_.lattice_spacing, double(start_.support), double(start_.reach));
    beads_ = beads.view;
    bead_.upload(beads.beads);
    first_beads_.upload(beads.first);
    bead_types_.upload(beads.types);
}

template <typename Executor> void FreeLiquid<Executor>::make_room()
{
    const auto resize = [&](const auto& field, auto& buffer) {
        buffer.resize(count_of(field.count));
        if constexpr (requires { buffer.fill(far_away()); }) buffer.fill(far_away());
    };
    Particles::each(resize, particles_);
    SortedParticles::each(resize, sorted_);
    particles_.mirrored.fill(0);
    particles_.stress.fill(0);
    stress_since_ = 0;
    const auto room = static_cast<std::size_t>(start_.room);
    key_.resize(room);
    order_.resize(room);
    const int most = std::max(most_cells, 2 * start_.room);
    cell_start_.resize(static_cast<std::size_t>(most) + 3);
    flow_.grid = grid_about(*scene_, start_);
    flow_.grid.key = key_.data();
    flow_.grid.start = cell_start_.data();
    exec_.prepare_sort(start_.room, most);
    control_.resize(1);
}

/// The liquid that is there from the start.
template <typename Executor> void FreeLiquid<Executor>::load_standing()
{
    const FreeLiquidStart& liquid = scene_->liquid;
    const std::int64_t content = std::llround(liquid.particle_volume * scene_->climate.density / water_quantum);
    add_particles(rounded(liquid.places), rounded(liquid.velocities), std::vector<std::int64_t>(liquid.places.size(), content));
    flow_.landing = std::numeric_limits<double>::infinity(); // what begins as it is may be about to move
    double fastest = 0;
    for (const Vec3d& v : liquid.velocities) fastest = std::max(fastest, length(v));
    flow_.longest_dt = std::min(rules_.longest_step(), rules_.advective_step(fastest));
}

template <typename Executor>
void FreeLiquid<Executor>::add_particles(const std::vector<Vec3>& places, const std::vector<Vec3>& velocities,
                                         const std::vector<std::int64_t>& contents)
{
    const std::size_t at = static_cast<std::size_t>(flow_.count), n = places.size();
    particles_.position.write_range(at, places);
    particles_.velocity.write_range(at, velocities);
    particles_.wall_normal.write_range(at, std::vector<Vec3>(n));
    particles_.wall_distance.write_range(at, std::vector<Real>(n, Real(0))); // not looked for yet
    particles_.wall_segment.write_range(at, std::vector<int>(n, no_wall));
    particles_.cloth_from.write_range(at, std::vector<ClothExpansion>(n));
    particles_.content.write_range(at, contents);
    particles_.place.write_range(at, std::vector<Quad>(n));
    particles_.alive.write_range(at, std::vector<std::uint8_t>(n, 1));
    flow_.count += static_cast<int>(n);
    flow_.listed_for = 0;
}

/// Where particles are that no yarn has absorbed; the last step's dead are still among the count.
template <typename Executor> std::vector<Vec3> FreeLiquid<Executor>::living()
{
    std::vector<Vec3> found;
    if (flow_.count == 0) return found;
    const std::vector<Vec3> places = particles_.position.download();
    const std::vector<std::uint8_t> lives = particles_.alive.download();
    for (std::size_t i = 0; i < static_cast<std::size_t>(flow_.count); ++i)
        if (lives[i]) found.push_back(places[i]);
    return found;
}

template <typename Executor> double FreeLiquid<Executor>::release_drop()
{
    SceneDroplet drop = scene_->supply.droplets[next_droplet_++];
    const auto spacing = static_cast<double>(start_.spacing);
    const double radius = std::cbrt(drop.volume * 3.0 / (4.0 * pi));
    drop.centre.z = height_clear_of(living(), drop.centre, radius, spacing);
    std::vector<Vec3d> places = droplet_lattice(static_cast<int>(start_.particles_of(drop.volume)), spacing);
    const double along = std::cos(drop.turn), across = std::sin(drop.turn);
    for (Vec3d& place : places)
        place = drop.centre + Vec3d{along * place.x - across * place.y, across * place.x + along * place.y, place.z};
    const bool alone = flow_.count == 0;
    // The drop's own water, shared out to the last quantum.
    const std::size_t n = places.size();
    const std::int64_t water = std::llround(drop.volume * scene_->climate.density / water_quantum), parts = static_cast<std::int64_t>(n);
    std::vector<std::int64_t> content(n, water / parts);
    content.back() += water % parts;
    add_particles(rounded(places), std::vector<Vec3>(n, Vec3{0, 0, static_cast<Real>(-drop.speed)}), content);

    const double landed = falls_for(drop);
    take_off(drop, landed, alone);
    flow_.landing = std::max(flow_.landing, drop.time + landed);
    flow_.settling = std::max(flow_.settling, rules_.capillary_time(drop.volume));
    count_drop(flow_, water);
    flow_.longest_dt = std::min(next_droplet_ == 1 ? rules_.longest_step() : flow_.longest_dt, rules_.advective_step(drop.speed));
    return static_cast<double>(water) * water_quantum;
}

/// s, from its release to the cloth.
template <typename Executor> double FreeLiquid<Executor>::falls_for(const SceneDroplet& drop) const
{
    const double radius = std::cbrt(drop.volume * 3.0 / (4.0 * pi)), fall = drop.centre.z - radius - scene_->cloth.half_thickness;
    return (std::sqrt(drop.speed * drop.speed + 2.0 * gravity_acceleration * std::max(0.0, fall)) - drop.speed) / gravity_acceleration;
}

/// A drop that was released into the air after so long a flight to come (s) that its particles need not be followed from its start. Drops
/// released together fall side by side; with any other liquid about, steps begin at once.
template <typename Executor> void FreeLiquid<Executor>::take_off(const SceneDroplet& drop, double landed, bool alone)
{
    const double speed = drop.speed + gravity_acceleration * landed; // at the cloth
    const double last = capillary_times_to_land * rules_.capillary_time(drop.volume) +
                        spacings_to_land * static_cast<double>(start_.spacing) / std::max(speed, 1e-6);
    const double end = scene_->liquid.gravity == gravity_acceleration ? drop.time + landed - last : 0.0;
    const bool beside = flow_.flight_end > 0 && flow_.flight_start == drop.time && flow_.flight_speed == drop.speed;
    flow_.flight_end = alone ? std::max(0.0, end) : beside ? std::min(flow_.flight_end, std::max(0.0, end)) : 0.0;
    flow_.flight_start = drop.time;
    flow_.flight_speed = drop.speed;
}

template <typename Executor> void FreeLiquid<Executor>::fall(double& time, double until)
{
    const double dt = until - time, gained = gravity_acceleration * dt;
    exec_.for_each("fall", flow_.count, Fall{particle_views(), static_cast<Real>(dt), static_cast<Real>(gained)});
    time = until;
    flow_.flight_speed += gained;
    flow_.longest_dt = std::min(rules_.longest_step(), rules_.advective_step(flow_.flight_speed));
}

template <typename Executor>
bool FreeLiquid<Executor>::flow(double& time, double sync_time, double wall_seconds, const WaterAbsorbed& absorbed)
{
    if (flow_.count == 0 || time >= sync_time) return true;
    if (time < flow_.flight_end) {
        fall(time, std::min(sync_time, flow_.flight_end));
        if (time >= sync_time) return true;
    }
    flow_.time = time;
    flow_.sync_time = sync_time;
    const double budget = 0.25 * wall_seconds / std::max(1e-9, wall_per_step_);
    flow_.budget = wall_per_step_ > 0 ? static_cast<int>(std::clamp(budget, 1.0, double(most_flow_steps))) : 1;
    const std::int64_t steps = flow_.steps;
    control_.write(0, flow_);
    const double seconds = exec_.go_through(liquid_flow(absorbed), start_.room);
    flow_ = control_.read(0);
    if (flow_.count > 0 && !(flow_.longest_dt > 0))
        throw Error("The flow of the drops became unstable. With fidelity.free_liquid=cap drops stand as caps, which do not flow.");
    if (flow_.side == 1) change_sides();
    time = flow_.time;
    if (flow_.steps > steps) wall_per_step_ = seconds / static_cast<double>(flow_.steps - steps);
    return time >= sync_time || flow_.count == 0 || flow_.drains.on;
}

template <typename Executor> LiquidFlow FreeLiquid<Executor>::liquid_flow(const WaterAbsorbed& absorbed)
{
    LiquidFlow flow;
    flow.control = control_.data();
    flow.rules = rules_;
    flow.particles = particle_views();
    change_sides();
    flow.sorted = SortedParticles{particle_views()};
    change_sides();
    flow.textile = shape(absorbed.segments);
    flow.beads = beads_;
    flow.beads.bead = bead_.data();
    flow.beads.first = first_beads_.data();
    flow.beads.types = bead_types_.data();
    flow.liquid = liquid_parameters(*scene_, start_);
    flow.liquid.step = &control_.data()->step;
    flow.segments = absorbed.segments;
    flow.wall_reach = scene_->liquid.vessel ? start_.reach : 2 * start_.spacing;
    flow.room = about_sample_;
    flow.density_tolerance = scene_->rules.density_tolerance;
    flow.absorbs = absorbed_ && !offers_;
    flow.reach = absorbed.reach;
    flow.order = order_.data();
    flow.key = key_.data();
    flow.start = cell_start_.data();
    return flow;
}

template <typename Executor> Particles FreeLiquid<Executor>::particle_views()
{
    Particles p;
    p.room = start_.room;
    p.mass = start_.mass;
    p.per_quantum = static_cast<Real>(water_quantum / static_cast<double>(start_.mass));
    p.support = start_.support;
    p.reach = start_.reach;
    p.spacing = start_.spacing;
    Particles::each([](const auto&, auto& buffer, auto& pointer) { pointer = buffer.size() > 0 ? buffer.data() : nullptr; }, particles_, p);
    return p;
}

template <typename Executor> TextileShape FreeLiquid<Executor>::shape(const Segments& segments)
{
    TextileShape t = textile_;
    static_cast<Yarns&>(t) = segments;
    t.shapes = shapes_.data();
    t.profiles = profiles_.data();
    t.paths = paths_.data();
    t.warp_up = segments.warp_up;
    t.shift = shift_.data();
    return t;
}

template <typename Executor> void FreeLiquid<Executor>::take_stock(Stock& stock)
{
    stock.dripped += static_cast<double>(flow_.dripped) * water_quantum;
    stock.evaporated += evaporated_.mass();
    if (!scene_->rules.shows_pressure) return;
    stock.stress = particles_.stress.download();
    stock.stressed = stock.time - stress_since_;
    sum_stresses_from(stock.time);
}

template <typename Executor> template <typename LookAt> void FreeLiquid<Executor>::show(const LookAt& look_at, Stock& stock)
{
    const auto count = static_cast<std::size_t>(flow_.count);
    Particles::each([&](const auto& field, const auto& buffer, auto& shown) { shown = look_at(buffer, field.shown ? count : 0); },
                    particles_, stock.particles);
}

template <typename Executor> template <typename Archive> void FreeLiquid<Executor>::pass_state(Archive& archive)
{
    archive.value(next_droplet_);
    archive.value(stress_since_);
    archive.value(evaporated_);
    LiquidControl flow = flow_;
    archive.value(flow);
    Real mass = start_.mass;
    archive.value(mass);
    if constexpr (Archive::reads) {
        if (flow.count > start_.room || (mass > 0 && mass != start_.mass))
            throw Error("The state of a run is of another scene: its particles are larger, smaller or more.");
        flow_ = Archive::stays ? flow : moved_to(flow, flow_);
    }
    const auto count = static_cast<std::size_t>(flow_.count); // there may be room for more drops than before
    Particles::each(
        [&](const auto& field, auto& buffer) {
            if (field.saved)
                archive.first(buffer, count, field.name);
            else if (Archive::stays) // neighbours listed anew would be added up in another order
                archive.buffer(buffer, field.name);
        },
        particles_);
}

} // namespace hygroloom::inline HL_PRECISION
