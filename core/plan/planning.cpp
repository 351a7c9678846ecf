// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/planning.h"

#include "core/base/text.h"
#include "core/physics/wetting.h"
#include "core/plan/bundling.h"
#include "core/plan/frame_times.h"
#include "core/plan/parts.h"
#include "core/room/kept_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace hygroloom {
namespace {

/// Not more particles than a spacing of a tenth of a yarn's height allows: a tiny drop has nothing finer to show. Where no yarn absorbs a
/// quarter, unless the liquid may never sleep: how finely the drop meets the pores then changes no water.
int particles_for(const Knobs& knobs, const Bounds& b)
{
    constexpr double most_in_all = 4e6; // half of particle_numbers: swollen yarns may give back more
    constexpr double share_without_drinking = 0.25;
    const double finest = 0.1 * b.finest, drops = static_cast<double>(std::max<std::size_t>(1, b.drops));
    const double volume = b.delivered / b.liquid.density / drops;
    const double share = b.wicks || knobs.settle_share <= 0 ? 1.0 : share_without_drinking;
    const double most = std::max(1.0, std::min(most_in_all / drops, share * knobs.particles_per_droplet));
    return static_cast<int>(std::clamp(volume / (finest * finest * finest), 1.0, most));
}

/// Of the sample, why it is simulated whole.
std::string region_in_words(const Textile& textile, const Experiment& experiment, const Bounds& b)
{
    const auto [width, height] = sample_extent_mm(experiment);
    return fmt::format("The whole sample: {} ends and {} picks. The liquid can wet {} mm² of its {} mm².", textile.ends(), textile.picks(),
                       rounded_text(1e6 * b.wet_area, 3), rounded_text(width * height, 3));
}

/// Fills in which knobs change nothing in the scene, and why. When all else is decided.
void find_idle_knobs(ModelPlan& plan, const Textile& textile, const Experiment& experiment, const Bounds& b)
{
    const auto idle = [&](bool is, const char* knob, const char* why) {
        if (is) plan.idle_knobs[knob] = why;
    };
    const bool liquid = plan.on("liquid");
    const bool particles = liquid && !plan.on("cap");
    for (const char* knob : {"particles_per_droplet", "network_step_limit_s", "liquid_step_factor", "steps_between_absorption",
                             "density_tolerance", "settle_share", "double_precision"})
        idle(!particles, knob, liquid ? "drops are caps" : b.drops > 0 ? "the free liquid is left out" : "no drop falls");
    idle(!liquid, "free_liquid", b.drops > 0 ? "the free liquid is left out" : "no drop falls");
    idle(particles && !b.wicks, "steps_between_absorption", "no yarn draws liquid");
    idle(particles && b.wicks && experiment.closure == Closure::pores && plan.on("wicking"), "steps_between_absorption",
         "yarns draw from drops as their liquid flows");
    idle(!liquid && info_of(experiment.type).source != WaterSource::pool, "saturation_change", "there is neither a drop nor a pool");
    const auto may_be_on = [&](const char* part) { return plan.on(part) || plan.watches(part); };
    idle(!may_be_on("sorption"), "fibre_shells", "sorption is left out");
    idle(!plan.on("wicking") && !may_be_on("sorption") && !may_be_on("vapour"), "step_error", "the yarns stay dry");
    idle(!plan.on("growth"), "rest_tolerance", "all of the sample is computed");
    const bool estimated = std::any_of(plan.parts.begin(), plan.parts.end(),
                                       [](const PlannedPart& part) { return part.share && !part.forced && (part.on || part.watched); });
    idle(!estimated, "neglected_share", "no part is left to an estimate");
    find_idle_bundle_knobs(plan, textile, experiment.type);
    std::erase_if(plan.idle_knobs, [](const auto& knob) { return knob.second.empty(); });
}

SceneCounts counts_of(const Experiment& experiment, const Bounds& b)
{
    const auto [width, height] = sample_extent_mm(experiment);
    SceneCounts counts;
    counts.type = name_of(experiment.type);
    counts.closure = name_of(experiment.closure);
    counts.drops = static_cast<double>(b.drops);
    if (b.drops > 0) counts.drop_volume = b.delivered / b.liquid.density / counts.drops;
    std::set<double> moments;
    for (const Droplet& drop : falling_drops(experiment)) {
        moments.insert(drop.time_s);
        const double volume = cubic_metre_from_ul(drop.volume_ul);
        if (volume <= counts.largest_drop) continue;
        counts.largest_drop = volume;
        counts.landing_speed = std::sqrt(drop.speed_m_s * drop.speed_m_s + 2.0 * gravity_acceleration * metre_from_mm(drop.height_mm));
    }
    counts.landings = static_cast<double>(moments.size());
    counts.sample_area = metre_from_mm(width) * metre_from_mm(height);
    counts.sample_edge = 2.0 * (metre_from_mm(width) + metre_from_mm(height));
    counts.duration = experiment.duration_s;
    counts.wet_share = std::min(1.0, b.wet_area / counts.sample_area);
    if (uses_field(experiment.type, "feed_s")) // not all may have come by the end
        counts.wet_share *= std::min(1.0, experiment.duration_s / experiment.feed_s);
    counts.suction = b.suction;
    counts.uptake = b.uptake;
    counts.pores = b.pores;
    constexpr double farthest = 0.98; // |cosine| at most: a drop's base is neither a point nor without end
    counts.drop_base = base_of_drop(std::clamp(cosine_on_fabric(b.smallest_angle * pi / 180.0, b.cover), -farthest, farthest));
    counts.capillarity = b.liquid.surface_tension / b.liquid.density;
    counts.viscosity = b.liquid.viscosity / b.liquid.density;
    return counts;
}

/// Of what is in the scene.
std::string resolution_in_words(const ModelPlan& plan, bool set_by_user)
{
    const Knobs& knobs = plan.knobs;
    const bool liquid = plan.on("liquid") && !plan.on("cap");
    std::string text = fmt::format("{} fidelity{}: ", name_of(plan.fidelity), set_by_user ? " with knobs set by the user" : "");
    if (liquid) text += fmt::format("{} particles a drop, ", plan.particles_per_droplet);
    text += fmt::format("one cell per {} and crossing, ", plan.crossings_per_cell > 1 ? "bundle" : "yarn");
    if (plan.on("sorption")) text += fmt::format("{} shells in a fibre, ", plan.fibre_shells);
    if (plan.on("cap"))
        return text +
               fmt::format("steps that change no saturation by more than about {:.2g}; drops stand as caps.", knobs.saturation_change);
    if (!liquid)
        return text + fmt::format("steps with an error of at most {:.2g} % of the water and heat at stake.", 100 * knobs.step_error);
    text += fmt::format("network steps of at most {:.3g} ms that change no saturation by more than about {:.2g}; ",
                        1e3 * knobs.network_step_limit, knobs.saturation_change);
    return text + (knobs.settle_share > 0
                       ? fmt::format("liquid at rest takes no steps until {:g} % of it is absorbed.", 100 * knobs.settle_share)
                       : std::string("liquid at rest is never skipped."));
}

} // namespace

ModelPlan plan_model(const Design& design, const Textile& textile, const Experiment& experiment, Fidelity fidelity,
                     const ForcedParts& forced, const KnobSettings& settings)
{
    const Bounds bounds = find_bounds(design, textile, experiment);

    ModelPlan plan;
    plan.fidelity = fidelity;
    plan.knobs = with_settings(knobs_of(fidelity), settings);
    decide_parts(plan, bounds, experiment, forced);
    plan.region = {textile.first_end, textile.first_pick, textile.ends(), textile.picks()};
    plan.region_reason = region_in_words(textile, experiment, bounds);
    plan.segments = 2 * plan.region.ends * plan.region.picks;
    plan.particles_per_droplet = plan.on("liquid") && !plan.on("cap") ? particles_for(plan.knobs, bounds) : 0;
    plan.fibre_shells = plan.on("sorption") ? static_cast<int>(plan.knobs.fibre_shells) : 1;
    const std::string bundles = decide_bundles(plan, textile, experiment.type);
    decide_shown_cells(plan, textile, experiment.type);
    find_idle_knobs(plan, textile, experiment, bounds);
    const double frames = fidelity == Fidelity::live && plan.on("cap") ? 25.0 : 100.0;
    plan.frame_interval = std::clamp(experiment.duration_s / frames, 1e-6, 60.0);
    plan.resolution_reason = resolution_in_words(plan, !settings.empty()) + bundles;
    plan.counts = counts_of(experiment, bounds);
    const DrawnVolume drawn = drawn_volume(textile);
    plan.counts.drawn_cubes = drawn.cubes;
    const int room_voxels = static_cast<int>(plan.knobs.room_voxels);
    plan.counts.drawn_periods = room_voxels > 0 && room_tables_are_kept(textile, room_voxels) ? 0 : drawn.periods;
    plan.counts.drawn_longest = drawn.longest;
    plan.counts.frames = static_cast<double>(frame_times(experiment, plan.frame_interval).size());
    return plan;
}

} // namespace hygroloom
