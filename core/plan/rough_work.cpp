// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a run computes, counted from its plan: steps, particles, segments; the time and memory that these take.
#include "core/plan/expectation.h"

#include "core/physics/liquid.h"
#include "core/physics/particle_steps.h"
#include "core/plan/bundles.h"
#include "core/plan/calm_steps.h"
#include "core/plan/frame_times.h"
#include "core/plan/held_liquid.h"
#include "core/room/drawn_layer.h"
#include "core/room/room_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {
namespace {

/// Segments that are simulated: bundles', where yarns go in bundles.
double cells_of(const ModelPlan& plan)
{
    const Bundling wanted = plan.bundling();
    return wanted.yarns > 1 ? 2.0 * bundles_of(plan.region.ends, wanted).count * bundles_of(plan.region.picks, wanted).count
                            : plan.segments;
}

bool flows_by_suction(const ModelPlan& plan) { return plan.counts.closure == name_of(Closure::pores); }
bool draws_rooms(const ModelPlan& plan) { return plan.on("wicking") && flows_by_suction(plan) && plan.knobs.room_voxels > 0; }

constexpr double moving_swings = 7;  // of a drop, until it rests
constexpr double resting_swings = 5; // of one that no yarn absorbs
constexpr double least_left = 0.15;  // of the particles, on average while the drop is absorbed

bool has_particles(const ModelPlan& plan) { return plan.on("liquid") && !plan.on("cap"); }
bool draws_from_drops(const ModelPlan& plan) { return plan.on("wicking") && plan.counts.uptake > 0; }
/// How often drops fall, one or several at once.
double landings_of(const SceneCounts& scene) { return std::max(1.0, scene.landings > 0 ? scene.landings : scene.drops); }
double particles_of(const ModelPlan& plan) { return std::max(1, plan.particles_per_droplet); }
/// Of particles, m.
double spacing_of(const ModelPlan& plan) { return std::cbrt(std::max(1e-18, plan.counts.drop_volume) / particles_of(plan)); }
/// Of all drops' volume; those that stand as caps have room on the sample.
double share_that_stays(const ModelPlan& plan) { return plan.on("cap") ? 1.0 : share_that_stays(plan.counts, spacing_of(plan)); }

/// Until the air has taken so large a share of all drops' volume from the face that they cover, s. What the plan tells is of both faces of
/// all that can get wet; without end where it tells nothing.
double dries_in(const ModelPlan& plan, double of_drops)
{
    constexpr double never = std::numeric_limits<double>::infinity();
    const SceneCounts& scene = plan.counts;
    const auto vapour = std::find_if(plan.parts.begin(), plan.parts.end(), [](const PlannedPart& part) { return part.name == "vapour"; });
    const double wet = scene.wet_share * scene.sample_area;
    if (vapour == plan.parts.end() || !vapour->on || !(vapour->share > 0) || !(wet > 0)) return never;
    const double covered = std::min(wet, scene.drops * scene.drop_base * std::pow(scene.drop_volume, 2.0 / 3.0));
    return scene.duration * of_drops / (*vapour->share * covered / (2.0 * wet));
}

/// Of the yarns, as long as liquid is about that they may absorb and that has not dried: steps are short then. By suction front places ask
/// for shorter steps; on full cloth some of it lies there until the end. What no yarn absorbs sleeps soon. Under a cap steps follow
/// saturations: the six scenes of tests/data/tradeoff whose cloth draws took 31 to 228 more than frames, the median stands here.
double steps_with_drops(const ModelPlan& plan)
{
    const SceneCounts& scene = plan.counts;
    const double limit = plan.knobs.network_step_limit, stays = share_that_stays(plan), landings = landings_of(scene);
    const auto steps_in = [&](double time) {
        return std::min({scene.duration, landings * time, dries_in(plan, stays > 0 ? stays : clings_of(scene))}) / limit;
    };
    constexpr double of_a_cap = 114;
    if (plan.on("cap")) return draws_from_drops(plan) ? landings * of_a_cap : 0.0;
    if (stays <= 0) return steps_in(plan.on("wicking") ? clings_for(scene) : falls_past_in(scene));
    if (!plan.on("wicking")) return steps_in(resting_swings * swing_of_largest(scene, stays));
    if (scene.uptake <= 0 || share_with_room(scene, stays) < 1) return steps_in(scene.duration);
    if (!flows_by_suction(plan)) return steps_in(absorbed_by_diffusion_in(scene));
    constexpr double of_the_limit = 0.7;
    return steps_in(absorbed_by_suction_in(scene)) / of_the_limit;
}

bool is_strip(const SceneCounts& scene)
{
    return scene.type == name_of(ExperimentType::vertical_wicking) || scene.type == name_of(ExperimentType::horizontal_wicking);
}
bool is_fed_between_sensors(const SceneCounts& scene) { return scene.type == name_of(ExperimentType::moisture_management); }

/// Crossings that a strip's front fills: no farther than the strip is long, than the water reaches, nor than it gets by the end, which goes
/// with the root of time.
double filled_by_front(const ModelPlan& plan)
{
    const SceneCounts& scene = plan.counts;
    constexpr double usual_crossings = 175, usual_time = 120; // s; where an older file does not tell the sample's size
    if (scene.sample_area <= 0) return usual_crossings * std::sqrt(scene.duration / usual_time);
    if (scene.uptake <= 0 || scene.pores <= 0) return 0;
    const double length = scene.sample_area / narrow_side(scene), pitch = std::sqrt(2.0 * scene.sample_area / cells_of(plan));
    const double reaches = std::sqrt(2.0 * scene.uptake / scene.pores * scene.duration);
    return std::min(scene.wet_share * length, reaches) / pitch;
}

/// A front asks for a step for each change of saturation, from dry to full at each crossing on its way: up strips of cotton, linen and a
/// micro-twill of 350, 144 and 313 crossings the yarns took 0.5, 1.1 and 1.5 times as many. Between sensors each drop of the feed asks for
/// its own: cotton took 450, 930 and 1540 steps of a feed of 20 s at live, draft and standard.
double steps_of_fronts(const ModelPlan& plan)
{
    constexpr double of_a_feed = 175, usual_feed = 20; // s
    const SceneCounts& scene = plan.counts;
    double changes = 0; // of saturation, from dry to full
    if (is_strip(scene)) changes = filled_by_front(plan);
    if (is_fed_between_sensors(scene)) changes = of_a_feed * std::min(scene.duration, usual_feed) / usual_feed;
    return changes / plan.knobs.saturation_change;
}

struct NetworkCount {
    double steps = 0, exchanges = 0; ///< of the yarns; with fibres and air
    double segments = 0;             ///< that are visited
    double touched = 0;              ///< steps times particles that lie at the cloth
};

NetworkCount count_network(const ModelPlan& plan)
{
    NetworkCount count;
    const SceneCounts& scene = plan.counts;
    const bool exchanges = plan.on("sorption") || plan.on("vapour");
    if (!plan.on("wicking") && !exchanges) return count;
    constexpr double first_visited = 2.0 * 17 * 17; // the area grows by eight threads on each side at least
    const double cells = cells_of(plan);
    const double wet = plan.on("wicking") && scene.uptake <= 0 ? 0.0 : cells * scene.wet_share; // or only those under a drop
    count.segments = plan.on("growth") ? std::min(cells, std::max(first_visited, wet)) : cells;
    constexpr double standard_error = 5e-4;
    const double finer =
        std::max(1.0, std::sqrt(standard_error / std::max(1e-9, plan.knobs.step_error))); // it falls with the step's square
    // Frames are taken beside steps of the yarns' own, by steps that end there.
    const double calm = finer * calm_steps(plan.knobs, scene.duration);
    count.steps = count.exchanges = frames_of(plan) + calm;
    if (!plan.on("liquid") && plan.on("wicking")) count.steps = frames_of(plan) + std::max(calm, steps_of_fronts(plan));
    if (plan.on("liquid")) {
        constexpr double steps_per_exchange = 4;
        const double more = steps_with_drops(plan);
        count.steps += more;
        count.exchanges += more / steps_per_exchange;
        if (has_particles(plan) && plan.on("wicking"))
            count.touched = more * least_left * share_that_stays(plan) * particles_of(plan) * scene.drops;
    }
    if (!exchanges) count.exchanges = 0;
    return count;
}

/// To set up a scene, however small, s.
double start_on(const std::string& backend) { return backend == "cuda" ? 0.02 : 0.01; }

/// Of a drop's steps, which also end where it meets the yarns.
double step_of(const ModelPlan& plan, double spacing)
{
    constexpr double usual_step = 0.85; // of the longest
    const SceneCounts& scene = plan.counts;
    const LiquidSteps longest =
        longest_steps(scene.capillarity, viscosity_of_particles(scene.viscosity, scene.capillarity, spacing), spacing);
    return std::min(plan.knobs.liquid_step_factor * usual_step * std::min(longest.capillary, longest.viscous),
                    plan.knobs.network_step_limit);
}

/// s, that drops are awake while so large a share of them goes: each time that as much has gone as may while they sleep, they wake, and
/// settle in some swings of what is gone.
double awake_while_it_goes(const ModelPlan& plan, double gone)
{
    constexpr double waking_times = 6; // swings
    const double each = plan.knobs.settle_share, volume = std::max(1e-18, plan.counts.drop_volume);
    return gone / each * waking_times * swing_of(plan.counts, each * volume);
}

/// Of what stays of the drops, after a time (s): what yarns have absorbed, and what has dried.
double share_gone(const ModelPlan& plan, double stays, double until_empty, double time)
{
    const double absorbed = std::min(share_with_room(plan.counts, stays), std::sqrt(std::min(1.0, time / until_empty)));
    return std::min(1.0, absorbed + time / dries_in(plan, stays));
}

/// Drops that fall one after the other, are absorbed as they lie, and sleep for most of that time; where they are absorbed slowly they wake
/// seldom. Shares were set on 59 such drops; swings and flowing time are 0.4 of that, so that measured times of drops and of yarns are
/// alike multiples of their counts. Of the steps that the shipped scenes took 0.24 to 1.09 are counted, which a measured run near by makes
/// up for.
LiquidCount count_by_suction(const ModelPlan& plan, double stays)
{
    constexpr double absorbed_swings = 5.2, flowing_share = 0.068, counted = 0.4;
    constexpr double left = 0.55; // of the particles, on average
    const SceneCounts& scene = plan.counts;
    const double until_empty = absorbed_by_suction_in(scene), of_one = stays * particles_of(plan);
    const double moves = absorbed_swings * swing_of_largest(scene, stays);
    const double absorbing = std::min({until_empty, scene.duration, dries_in(plan, stays)});
    const double gone = share_gone(plan, stays, until_empty, scene.duration);
    const double flows =
        plan.knobs.settle_share > 0 ? std::min(flowing_share * absorbing, counted * awake_while_it_goes(plan, gone)) : absorbing;
    const double landings = landings_of(scene), at_once = scene.drops / landings * of_one;
    const bool empties = share_with_room(scene, stays) >= 1 && landings * until_empty < scene.duration;
    return {std::min(scene.duration, landings * (moves + flows)) / step_of(plan, spacing_of(plan)),
            empties ? left * at_once : 0.5 * (landings + 1) * at_once};
}

/// Drops of which some stays: they move as they land, one after the other, and then as they are absorbed.
LiquidCount count_staying(const ModelPlan& plan, double stays)
{
    if (flows_by_suction(plan) && draws_from_drops(plan)) return count_by_suction(plan, stays);
    const SceneCounts& scene = plan.counts;
    constexpr double usual_particles = 8000, usual_spacing = 85e-6; // m
    constexpr double scarce_pores = 0.13e-3; // m, of pores times the drop's base: so few leave the usual particles all there
    constexpr double most_left = 0.97;       // of the particles, on average while the drop is absorbed
    const double settle_share = plan.knobs.settle_share;
    const double spacing = spacing_of(plan), step = step_of(plan, spacing), landings = landings_of(scene);
    const double on_sample = 0.5 * (landings + 1) / landings * scene.drops * stays * particles_of(plan);
    const double swings = landings * swing_of_largest(scene, stays);
    if (!draws_from_drops(plan)) {
        const double moves =
            settle_share > 0 ? resting_swings * swings + awake_while_it_goes(plan, std::min(1.0, scene.duration / dries_in(plan, stays)))
                             : std::min(scene.duration, dries_in(plan, stays));
        return {std::min(scene.duration, moves) / step, on_sample};
    }
    const double moves = std::min(moving_swings * swings, scene.duration), rest = scene.duration - moves;
    const double until_empty = absorbed_by_diffusion_in(scene), absorbing = std::min({rest, until_empty, dries_in(plan, stays)});
    const double gone = share_gone(plan, stays, until_empty, rest); // in the end
    double flows = absorbing;
    if (settle_share > 0) {
        const double awake_share = 0.12 * std::pow(spacing / usual_spacing, 0.3);
        flows = std::min(awake_share * absorbing, awake_while_it_goes(plan, gone));
    }
    const double under_drop = std::max(1e-12, scene.drop_base * scene.pores);
    const double left = std::clamp(scarce_pores / under_drop * std::cbrt(usual_particles / particles_of(plan)), least_left, most_left);
    const double flowing = 1.0 - (1.0 - left) * gone; // share of the particles
    return {(moves + flows) / step, on_sample * (moves + flows * flowing) / (moves + flows)};
}

/// Drops that go by, one after the other, as fast as they land.
LiquidCount count_falling(const ModelPlan& plan)
{
    constexpr double courant = 0.4; // spacings in a step
    const SceneCounts& scene = plan.counts;
    const double spacing = spacing_of(plan), fast = courant * spacing / std::max(1e-6, scene.landing_speed);
    const double landings = landings_of(scene);
    return {std::min(scene.duration, landings * falls_past_in(scene)) / std::min(fast, step_of(plan, spacing)),
            scene.drops / landings * particles_of(plan)};
}

} // namespace

LiquidCount count_liquid(const ModelPlan& plan)
{
    if (!plan.on("liquid") || plan.counts.drops <= 0) return {}; // forced on where no drop falls
    const double stays = share_that_stays(plan);
    const LiquidCount staying = stays > 0 ? count_staying(plan, stays) : LiquidCount{},
                      falling = stays < 1 ? count_falling(plan) : LiquidCount{};
    const double steps = staying.steps + falling.steps;
    return {steps, (staying.steps * staying.particles + falling.steps * falling.particles) / steps};
}

namespace {

/// Voxels in which a period's rooms between yarns are drawn.
double drawn_voxels(const ModelPlan& plan)
{
    return draws_rooms(plan) ? voxels_of_period(plan.counts.drawn_cubes, static_cast<int>(plan.knobs.room_voxels)) : 0.0;
}
/// Of a period's longest side.
double voxels_along(const ModelPlan& plan)
{
    constexpr double usual_cubes = 4; // of a twill's period
    const SceneCounts& scene = plan.counts;
    const double cubes = scene.drawn_longest > 0 ? scene.drawn_longest : usual_cubes;
    return cubes * std::cbrt(drawn_voxels(plan) / std::max(1e-9, scene.drawn_cubes));
}
/// To draw them and find how liquid rests and flows in them, s, on a core. The rounds in which that is found go with the voxels along its
/// way: of ten shipped cloths a voxel took 3 to 8 us where those were less than 70, and 8 to 14 us from 80 to 150. Where Stokes flow sets
/// the level it takes 2 us more. On a GPU's host, too.
double room_seconds(const ModelPlan& plan)
{
    constexpr double drawn = 1e-6, a_round_along = 7e-8, stokes = 2e-6; // of a voxel; the second for each along its way
    const double of_a_voxel = drawn + a_round_along * voxels_along(plan) + (plan.knobs.room_voxels < stokes_voxels ? 0.0 : stokes);
    return plan.counts.drawn_periods * drawn_voxels(plan) * of_a_voxel;
}

} // namespace

double set_up_seconds(const ModelPlan& plan, const std::string& backend) { return start_on(backend) + room_seconds(plan); }

double rough_work(const ModelPlan& plan, const std::string& backend)
{
    const LiquidCount liquid = has_particles(plan) ? count_liquid(plan) : LiquidCount{};
    const NetworkCount network = count_network(plan);
    constexpr double shown = 3e-8; // s, for a segment in a frame and its metrics
    constexpr double built =
        1e-6; // s, for a segment, from its textile to the solver's arrays: 1.19 million took 1.2 s more than 0.01 million
    const double frames = shown * shown_segments(plan) * frames_of(plan) + built * plan.segments;
    if (backend == "cuda") {
        // Seconds on an H100: a step takes a while however little there is to do. Start and network step were the best of eight pairs on
        // the GPU's runs of tests/data/tradeoff, which test them no more. A step of the liquid is 2.5 times what one took there, as
        // count_by_suction() counts so few.
        constexpr double liquid_step = 3e-4, particle = 7.5e-9, network_step = 4e-4, segment = 1e-9;
        return set_up_seconds(plan, backend) + frames + liquid.steps * (liquid_step + particle * liquid.particles) +
               network.steps * (network_step + segment * network.segments);
    }
    // Seconds on one core of an AMD EPYC, medians of the stages' times in 47 runs of random designs: a step of the liquid lists neighbours
    // in a grid of many cells, however few its particles are; a step of the yarns touches the particles that lie on them.
    constexpr double listing = 5e-5, particle = 1.35e-6, offered = 4e-8, touched = 1.4e-7;
    constexpr double network_step = 3e-6, flows = 5e-7, wicks = 1.5e-7, conducts = 6e-8, exchange = 2e-7, shell = 1.2e-7; // for a segment
    const bool wicking = plan.on("wicking"), by_suction = wicking && flows_by_suction(plan);
    const double wider = plan.knobs.double_precision != 0 ? 2.6 : 1.0; // measured with 2 000 particles
    const bool flowing = !plan.on("liquid") || plan.counts.uptake > 0;
    const double segment = by_suction && flowing ? flows : wicking && flowing ? wicks : conducts;
    return set_up_seconds(plan, backend) + frames + liquid.steps * (listing + liquid.particles * particle * wider) +
           network.steps * (network_step + network.segments * segment) +
           network.exchanges * network.segments * (exchange + shell * plan.fibre_shells) +
           network.touched * (by_suction ? offered : touched);
}

namespace {

double shells_of(const ModelPlan& plan)
{
    return plan.watches("sorption") ? plan.knobs.fibre_shells : plan.fibre_shells; // it may come on
}
double particle_bytes(const ModelPlan& plan)
{
    const double wider = plan.knobs.double_precision != 0 ? 1.5 : 1.0;
    return wider * plan.particles_per_droplet * plan.counts.drops * (8.0 * most_near + 4.0 * most_distant + 250.0);
}
/// Of what is kept aside for frames.
double kept_bytes(const ModelPlan& plan) { return cells_of(plan) * (170.0 + 8.0 * shells_of(plan)) + particle_bytes(plan); }

/// Of the equations of warp and weft at once, where liquid spreads by suction from a spot.
double whole_flow_bytes(const ModelPlan& plan)
{
    const SceneCounts& scene = plan.counts;
    const bool poured = is_fed_between_sensors(scene) || scene.type == name_of(ExperimentType::horizontal_wicking);
    const bool whole = flows_by_suction(plan) && plan.on("wicking") && (plan.on("liquid") || poured);
    return whole ? 380.0 * count_network(plan).segments : 0.0; // 76 numbers of a crossing, and a quarter more
}

/// While a period's rooms are drawn; given back before the first step.
double room_bytes(const ModelPlan& plan) { return plan.counts.drawn_periods > 0 ? 120.0 * drawn_voxels(plan) : 0.0; }

} // namespace

double rough_bytes(const ModelPlan& plan)
{
    const double shape = plan.on("liquid") ? 24.0 : 0.0; // of a cell, as particles meet it
    const double steps =
        cells_of(plan) * (220.0 + shape + 8.0 * shells_of(plan)) + particle_bytes(plan) + kept_bytes(plan) + whole_flow_bytes(plan);
    return 180.0 * plan.segments + std::max(steps, room_bytes(plan));
}

} // namespace hygroloom
