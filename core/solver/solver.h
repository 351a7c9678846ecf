// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A running scene, written once for every machine. An Executor offers Buffer<T>, for_each, for_each_line, and go_through() for what
// stages decide themselves: see LiquidFlow.
// Liquid and yarns meet at synchronisation points: the liquid takes its small steps up to one, then the yarns take one step.
#pragma once

#include "core/physics/particle_steps.h"
#include "core/scene/frame.h"
#include "core/solver/droplet.h"
#include "core/solver/host_cloth.h"
#include "core/solver/order.h"
#include "core/solver/state_archive.h"
#include "core/solver/steps/cloth_field.h"
#include "core/solver/steps/contact.h"
#include "core/solver/steps/liquid.h"
#include "core/solver/steps/liquid_control.h"
#include "core/solver/steps/liquid_flow.h"
#include "core/solver/steps/supply.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <utility>

namespace hygroloom::inline HL_PRECISION {

constexpr double exchange_steps = 4.0; ///< network steps of full length between exchanges with fibres and air, which are slower
constexpr double first_step = 1e-3;    ///< s, of the yarns after something sudden

/// Quanta of water that may add up to more than 64 bits hold, which is half a kilogram.
struct ManyQuanta {
    static constexpr std::int64_t quarter = std::int64_t(1) << 62; ///< of a kilogram
    std::int64_t quarters = 0, rest = 0;

    void add(std::int64_t more) ///< up to a quarter at once
    {
        rest += more;
        if (rest < quarter) return;
        rest -= quarter;
        ++quarters;
    }
    double mass() const { return 0.25 * static_cast<double>(quarters) + static_cast<double>(rest) * water_quantum; } ///< kg
};

/// What a frame and its ledger are made from: numbers of one moment, and the arrays as they were then (see Executor::Snapshot).
struct Stock {
    double time = 0;           ///< s
    double delivered = 0;      ///< kg, but for what is supplied
    std::int64_t standing = 0; ///< quanta, in pools
    double dripped = 0;        ///< kg, fallen or run off
    double stressed = 0;       ///< s for which stresses were summed
    Unvisited unvisited;
    // Segments: kg, m3, regain of each shell, and K and J over the climate's temperature.
    std::span<const double> liquid, vapour, warmth, bound, stored, pores, supplied, evaporated, released, lost, regain;
    // Particles, also those that yarns have taken up.
    std::span<const Vec3> position, velocity;
    std::span<const std::int64_t> content;
    std::span<const std::uint8_t> alive;
    std::vector<Real> stress;
};

template <typename Executor> class Solver {
public:
    template <typename T> using Buffer = typename Executor::template Buffer<T>;

    Executor& executor() { return exec_; }
    /// From now on what each stage takes is added up, which waits for each, and for frames too.
    void time_stages()
    {
        exec_.time_stages();
        if constexpr (requires { snapshot_.fetch_at_once(); }) snapshot_.fetch_at_once();
    }
    long liquid_steps() const { return static_cast<long>(flow_.steps); }
    long pressure_rounds() const { return static_cast<long>(flow_.rounds); }
    /// How often neighbours have been listed.
    long listings() const { return static_cast<long>(flow_.listings); }
    int particles() const { return flow_.count; }
    /// Segments that steps go through now.
    int visited_segments() { return yarns().visited_segments(); }

    void load(const Scene& scene)
    {
        scene_ = scene;
        time_ = network_time_ = exchange_time_ = 0;
        sync_time_ = -1;
        wicking_watch_ = exchange_watch_ = {};
        next_droplet_ = 0;
        flow_ = {};
        rules_ = {};
        delivered_ = 0;
        pool_.assign(scene.pools.size(), 0);
        pumped_ = ran_off_ = {};
        load_segments();
        load_liquid();
        const Stock stock = take_stock();
        snapshot_.fetch();
        const Ledger start = ledger(stock);
        initial_ = start.water_bound + start.water_vapour - scene.initial_bound;
        delivered_ = start.water_liquid + start.water_free + scene.initial_bound;
        initial_energy_ = start.energy_stored;
        begin_anew();
    }

    /// Towards until, for about the given wall time; what is reached never depends on where a call ends.
    double advance(double until, double wall_seconds)
    {
        const auto start = std::chrono::steady_clock::now();
        while (time_ < until) {
            if (sync_time_ < 0) {
                release_droplets();
                const double target = std::min(until, next_event());
                const double steps = LiquidRules::steps_to(target - time_, std::min(network_dt_, exchange_dt_));
                sync_time_ = steps == 1.0 ? target : time_ + (target - time_) / steps;
            }
            may_have_absorbed_ = may_have_absorbed_ || flow_.count > 0;
            while (!flow(wall_seconds))
                if (elapsed(start) > wall_seconds) return time_;
            time_ = sync_time_;
            sync_time_ = -1;
            step_network(time_ - network_time_, time_ >= until);
            network_time_ = time_;
            if (elapsed(start) > wall_seconds) break;
        }
        return time_;
    }

    Frame frame() { return frame_of(take_stock()); }
    /// What frame_of() needs to show how things are now. Stresses are summed anew from here on.
    Stock take_stock();
    /// May be called from another thread while advance() goes on, until stock is taken again.
    Frame frame_of(const Stock& stock);

    /// All that the scene has come to, between calls of advance() that reached what they were asked for.
    std::vector<std::byte> state()
    {
        StateSize size;
        pass_state(size);
        StateWriter writer(size.bytes());
        pass_state(writer);
        return writer.take();
    }
    /// After load() of the same scene, or of one with more parts on (see set_parts()), goes on from there. Throws Error if it is another
    /// one's.
    void go_on_from(const std::vector<std::byte>& state)
    {
        StateReader reader(state);
        pass_state(reader);
        may_have_absorbed_ = true;
    }

private:
    static double elapsed(std::chrono::steady_clock::time_point start)
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    template <typename Stage> void each_segment(const char* name, const Stage& stage)
    {
        exec_.for_each(name, yarns().visited_segments(), stage);
    }
    template <typename Stage> void each_crossing(const char* name, const Stage& stage)
    {
        exec_.for_each(name, yarns().visited_crossings(), stage);
    }
    template <typename Stage> void each_line(const char* name, const Stage& stage)
    {
        exec_.for_each_line(name, yarns().visited_lines(), std::max(yarns().visited_ends(), yarns().visited_picks()), stage);
    }

    template <typename Archive> void pass_state(Archive& archive);
    template <typename Archive> void pass_regain(Archive& archive);
    void load_segments();
    void sum_shells();
    void note_start(std::vector<double>& regain);
    double largest_change(const YarnParameters& yarn) const;
    void set_climate();
    void visit_from_start();
    void visit_around(double radius);
    void visit_what_changed(std::span<const int> reach);
    int threads_near();
    void visit_what_drank();
    double next_event() const;
    /// Short steps again: something sudden has happened.
    void begin_anew()
    {
        network_dt_ = std::min(first_step, step_limit());
        exchange_dt_ = scene_.step_error > 0 ? std::min(first_step, exchange_limit()) : exchange_limit();
    }
    /// Whether free liquid may soon come to the yarns: not while it sleeps on cloth that does not drink.
    bool drops_about() const { return flow_.count > 0 && !(flow_.asleep && !drinks_); }
    double step_limit() const
    {
        const double longest = drops_about() || scene_.calm_network_step <= 0 ? scene_.network_step : scene_.calm_network_step;
        return scene_.sweat > 0 ? std::min(longest, most_sweat / sweat_rate()) : longest;
    }
    static constexpr double most_sweat = 0.2; ///< kg in a step, whose quanta are counted; see ManyQuanta
    double sweat_rate() const { return scene_.sweat * scene_.cell_area * scene_.crossings() * scene_.climate.density; } ///< kg/s
    double exchange_limit() const
    {
        return drops_about() || scene_.calm_network_step <= 0 ? exchange_steps * scene_.network_step : scene_.calm_network_step;
    }
    void supply(double dt);
    void drink(double dt);
    void sweat(double dt);
    /// How changes compare with those of the step before.
    struct Watch {
        double dt = 0;      ///< of the step before
        bool known = false; ///< whether there was one
    };
    double growth(double error) const { return std::clamp(0.9 / std::sqrt(std::max(1e-12, error / scene_.step_error)), 0.3, 1.5); }
    /// What tells how long the network's next step may be.
    struct Signs {
        bool error; ///< of the last one
        bool pools; ///< that stand: the change of saturation counts, too

        bool change() const { return !error || pools; }
    };
    bool pools_stand() const;
    void move_liquid_and_heat(double dt, const Signs& signs);
    void choose_network_step(double dt, const Signs& signs, const YarnTotals& found);
    void choose_exchange_step(double dt, const YarnTotals& found);
    double water_at_stake() const;
    void load_liquid();
    void load_particles();
    void set_rules(double spacing);
    double viscosity() const;
    Room room_about_sample() const;
    std::size_t particles_of(double volume) const;
    void release_droplets();
    void step_network(double dt, bool frame_due);
    bool exchanges() const { return scene_.sorption || scene_.vapour; }
    bool exchange(double dt);
    bool swell();
    bool flow(double wall_seconds);
    LiquidFlow liquid_flow();
    /// What sorting brought to the other side is where particles are from then on.
    void change_sides();
    Ledger ledger(const Stock& stock) const;
    void show_particles(const Stock& stock, Frame& frame) const;
    Yarns yarns();
    Yarns yarns_on_host() const;
    Segments segments();
    Segments fibres_on_host(std::vector<double>& regain) const;
    Particles particle_views();
    TextileShape shape();
    Beads beads();
    Vessel vessel() const;
    double weight_step() const;
    LiquidParameters liquid();

    Executor exec_;
    Scene scene_;
    double time_ = 0, sync_time_ = -1, network_time_ = 0, exchange_time_ = 0;
    double network_dt_ = 0;
    bool drinks_ = false; ///< whether any yarn takes up liquid from drops
    std::size_t next_droplet_ = 0;
    double delivered_ = 0, initial_ = 0, initial_energy_ = 0;
    double exchange_dt_ = 0;
    Watch wicking_watch_, exchange_watch_;
    double heat_scale_ = 0;          ///< J that an error of a step is compared with
    double water_scale_ = 0;         ///< kg
    std::vector<std::int64_t> pool_; ///< quanta that stand in each pool
    ManyQuanta pumped_;              ///< into pools and as sweat
    ManyQuanta ran_off_;             ///< of sweat that found no room

    // Yarns.
    Buffer<double> length_, liquid_, vapour_, warmth_, regain_, evaporated_, released_, lost_, work0_, work1_, work2_, flux_, before_;
    Buffer<double> fibre_water_;     ///< kg
    bool may_have_absorbed_ = false; ///< some segment, from particles or a pool, since the yarns' last step
    typename Executor::Snapshot snapshot_;
    Unvisited unvisited_;
    Buffer<int> from_;  ///< segments that give back liquid
    Buffer<int> reach_; ///< see Reach: where particles gave liquid since the last step
    Buffer<double> pores_, supplied_, uptake_, liquid_rate_, bound_, bound_rate_, heat_, heat_rate_;
    Buffer<std::uint8_t> fed_;
    Buffer<std::uint8_t> warp_up_, type_;
    Buffer<YarnParameters> yarns_;
    Buffer<CrossingParameters> crossing_;
    Buffer<std::int64_t> absorbed_;
    Buffer<int> contact_;
    TextileShape textile_; ///< its numbers; the pointers come with shape()
    Buffer<YarnShape> shapes_;
    Buffer<Quad> profiles_, paths_;
    Buffer<float> shift_, warp_up_share_;

    // Liquid.
    LiquidControl flow_;            ///< as it was when last looked at
    Buffer<LiquidControl> control_; ///< where stages change it
    LiquidRules rules_;
    Room liquid_room_;
    double wall_per_step_ = 0; ///< s
    int room_ = 0;             ///< for so many particles
    Real particle_mass_ = 0, spacing_ = 0, support_ = 0, reach_of_surface_ = 0;
    double stress_since_ = 0; ///< s, when the stresses began to be summed
    Buffer<Quad> place_, sorted_place_, motion_, standing_, predicted_, surface_;
    Buffer<Vec3> position_, velocity_, force_, pressure_force_, wall_normal_;
    Buffer<Vec3> sorted_position_, sorted_velocity_, sorted_normal_;
    Buffer<Real> allowed_, mirrored_, sorted_mirrored_, stress_, sorted_stress_, wall_distance_, sorted_distance_, slope_, listed_x_,
        listed_y_, listed_z_;
    Buffer<int> wall_segment_, sorted_segment_, key_, order_, cell_start_, near_, distant_;
    Buffer<int> near_first_, distant_first_, near_count_, distant_count_;
    Buffer<std::uint8_t> alive_;
    Buffer<std::int64_t> content_, sorted_content_;
    Buffer<YarnTotals> totals_; ///< one, of this step
    Buffer<ClothField> cloth_;
    Buffer<ClothExpansion> cloth_from_, sorted_cloth_from_;
    Buffer<Quad> bead_;
    Buffer<BeadType> bead_types_;
    Beads beads_; ///< their counts; the pointers come with beads()
};

} // namespace hygroloom::inline HL_PRECISION

#include "core/solver/solver_liquid.h"
#include "core/solver/solver_state.h"
#include "core/solver/solver_yarns.h"
