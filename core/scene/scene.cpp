// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/scene/scene.h"

#include "core/base/random.h"
#include "core/geometry/face_angles.h"
#include "core/physics/heat_moisture.h"
#include "core/physics/wicking.h"
#include "core/plan/calm_steps.h"
#include "core/room/kept_tables.h"
#include "core/scene/pool_base.h"
#include "core/scene/unevenness.h"
#include "core/scene/wet_cloth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {
namespace {

/// How warm the air is over a temperature, and what it exchanges with the faces: its own layer and, in series, the still air among the
/// hairs that stand over the yarns.
AirMoment scene_climate(const Climate& climate, double time, double reference, double sample, double hair)
{
    const double temperature = kelvin_from_celsius(climate.temperature_c);
    const double convection = convective_heat_transfer(climate.air_speed_m_s, sample);
    const auto behind = [&](double outside, double inside) { return 1.0 / (1.0 / outside + hair / inside); };
    return {time,
            temperature - reference,
            climate.relative_humidity,
            behind(convection + radiative_heat_transfer(temperature), air_conductivity),
            behind(mass_transfer(convection, temperature), vapour_diffusivity(temperature)),
            climate.air_speed_m_s};
}

void add_climate(Scene& scene, const Textile& textile, const Liquid& liquid, const Experiment& experiment)
{
    ClimateParameters& climate = scene.climate;
    climate.temperature = kelvin_from_celsius(experiment.climate.temperature_c);
    const auto at = [&](const Climate& air, double time) { return air_of(air, time, textile, experiment); };
    const AirMoment start = at(experiment.climate, 0);
    climate.humidity = start.humidity;
    climate.vapour = climate.humidity * saturation_concentration(climate.temperature);
    climate.heat_transfer = start.heat_transfer;
    climate.mass_transfer = start.mass_transfer;
    climate.air_speed = start.air_speed;
    climate.radiation = radiative_heat_transfer(climate.temperature);
    if (!experiment.climates.empty()) scene.climate.course.push_back(start);
    for (const ClimateMoment& moment : experiment.climates) scene.climate.course.push_back(at(moment.climate, moment.time_s));

    const LiquidAt at_20_c{newton_per_metre_from_mn_m(liquid.surface_tension_mn_m), pascal_second_from_mpa_s(liquid.viscosity_mpa_s),
                           liquid.density_kg_m3};
    const LiquidAt here = liquid_at(at_20_c, climate.temperature);
    climate.surface_tension = here.surface_tension;
    climate.viscosity = here.viscosity;
    climate.density = here.density;
    climate.flow = flow_of_warm_liquid(climate.temperature);
}

FibreDiffusivity diffusivity_of(const Material& fibre)
{
    if (!fibre.diffusion.two_stage) return {DiffusionLaw::constant, fibre.diffusion.constant_m2_s};
    return {two_stage_law(fibre) == "wool" ? DiffusionLaw::wool_two_stage : DiffusionLaw::cotton_two_stage, 0};
}

constexpr double paper_pore_radius = 0.2e-3; // m, R_c of the paper's table A1

/// The paper's printed parameters (its table A1, eqs. 12 and 14), with the liquid's surface tension where it has the fibre's.
PoreFlow paper_flow(const YarnType& type, const ClimateParameters& climate)
{
    constexpr double sine_of_beta = 0.34202014332566873; // 20 degrees
    const double full = saturated_liquid_diffusivity(climate.surface_tension, type.contact_angle, paper_pore_radius, climate.viscosity);
    return pore_flow(3.0 * sine_of_beta * sine_of_beta * full / type.tortuosity,
                     capillary_pressure(climate.surface_tension, type.contact_angle, paper_pore_radius), climate.density);
}

/// What the paper's closure makes of a yarn's uptake: the same bundle scaled up to its pores (permeability as their square, suction as
/// their inverse), and as much as the fibre's regain is of cotton's, the fibre of its table A1.
double paper_uptake(const YarnType& type)
{
    return paper_pore_radius / bundle_pore_radius(metre_from_um(type.fibre.fibre_radius_um), type.packing_round_core()) *
           type.fibre.standard_regain / find_library_material("cotton")->standard_regain;
}

/// across: m2, of the bundle.
void flow_by_saturation(YarnParameters& yarn, const YarnType& type, double across, const ClimateParameters& climate)
{
    const PoreFlow flow = paper_flow(type, climate);
    yarn.liquid_diffusivity = flow.diffusivity;
    yarn.fall = flow.fall;
    if (flow.diffusivity <= 0) return;
    yarn.suction_radius = paper_pore_radius / std::cos(type.contact_angle);
    // Darcy flow across the fibres from the skin to half-way to the yarn's middle.
    const double own_radius = bundle_pore_radius(yarn.fibre_radius, type.packing_round_core());
    yarn.intake_flux = climate.density * across * capillary_pressure(climate.surface_tension, type.contact_angle, own_radius) /
                       (climate.viscosity * 0.25 * type.section.height);
    yarn.intake_flux *= paper_uptake(type);
}

YarnParameters make_yarn(const YarnType& type, double crossing_pitch, Closure closure, const ClimateParameters& climate)
{
    const Material& fibre = type.fibre;
    YarnParameters yarn;
    yarn.pore_area = type.area * (1.0 - type.packing);
    yarn.fibre_area = type.area * type.packing;
    yarn.fibre_radius = metre_from_um(fibre.fibre_radius_um);
    yarn.fibre_density = fibre.density_kg_m3;
    yarn.fibre_specific_heat = fibre.specific_heat_j_kgk;
    yarn.fibre_conductivity = fibre.thermal_conductivity_w_mk;
    yarn.isotherm = {fibre.standard_regain, fibre.saturation_regain, fibre.gab.monolayer_regain, fibre.gab.c, fibre.gab.k};
    yarn.diffusivity = diffusivity_of(fibre);
    if (fibre.heat_of_wetting_j_g > 0) {
        const double by_law = heat_of_wetting(yarn.isotherm);
        if (by_law > 0) yarn.sorption_heat_scale = 1e3 * fibre.heat_of_wetting_j_g / by_law;
    }
    yarn.vapour_diffusivity = vapour_diffusivity(climate.temperature) / type.tortuosity;
    yarn.face_area = type.section.width * crossing_pitch;
    yarn.adhesion = work_of_adhesion(climate.surface_tension, type.contact_angle);
    yarn.initial_regain = yarn.resting_regain = equilibrium_regain(yarn.isotherm, climate.humidity, climate.temperature);
    const double across = permeability_across(yarn.fibre_radius, type.packing_round_core());
    yarn.absorbs = wets_pores(climate.surface_tension, type.contact_angle) && across > 0;
    if (closure == Closure::paper) flow_by_saturation(yarn, type, across, climate);
    return yarn;
}

/// A prism between the two axes, as wide as the yarns overlap: liquid and vapour pass across the fibres of each, half the way in each.
CrossingParameters make_crossing(const YarnType& warp_type, const YarnType& weft_type, const YarnParameters& warp,
                                 const YarnParameters& weft, const ClimateParameters& climate)
{
    const double area = warp_type.section.width * weft_type.section.width;
    const double half_warp = 0.5 * warp_type.section.height, half_weft = 0.5 * weft_type.section.height;
    const auto in_series = [&](double a, double b) { return a > 0 && b > 0 ? area / (half_warp / a + half_weft / b) : 0.0; };
    // The obstruction of the crossing: how much less permeable a bundle is across its fibres than along them (Gebart).
    const auto across = [](const YarnType& type, const YarnParameters& yarn) {
        const double obstruction = permeability_across(yarn.fibre_radius, type.packing_round_core()) /
                                   permeability_along(yarn.fibre_radius, type.packing_round_core());
        return yarn.liquid_diffusivity * obstruction * (1.0 - type.packing);
    };
    CrossingParameters crossing;
    crossing.liquid_conductance = climate.density * in_series(across(warp_type, warp), across(weft_type, weft));
    crossing.heat_conductance = in_series(mean_conductivity(warp_type.packing, warp.fibre_conductivity, 0),
                                          mean_conductivity(weft_type.packing, weft.fibre_conductivity, 0));
    crossing.vapour_conductance =
        in_series(warp.vapour_diffusivity * (1.0 - warp_type.packing), weft.vapour_diffusivity * (1.0 - weft_type.packing));
    return crossing;
}

ContactShape make_shape(const YarnSystem& system, std::size_t own)
{
    const YarnType& type = system.types[own];
    ContactShape shape{0.5 * type.section.height, 0.5 * type.section.width, {}};
    const std::size_t paths = system.paths.size() / system.types.size();
    for (std::size_t p = own * paths; p < (own + 1) * paths; ++p) {
        const YarnPath& path = system.paths[p];
        for (std::size_t i = 0; i < path.height.size(); ++i)
            for (double value : {path.height[i], path.slope[i], path.half_height[i], path.half_width[i]})
                shape.profiles.push_back(static_cast<float>(value));
    }
    return shape;
}

double mean_area(const YarnSystem& system)
{
    double area = 0;
    for (int yarn = 0; yarn < system.count; ++yarn)
        area += system.types[system.order[static_cast<std::size_t>(yarn) % system.order.size()]].area;
    return area / system.count;
}

/// The types of yarn, what they are like where they cross, and which each end and pick is of.
void add_yarns(Scene& scene, const Textile& textile, const Experiment& experiment)
{
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        const YarnSystem& system = textile.system(kind);
        const auto before = static_cast<int>(scene.cloth.yarns.size());
        for (std::size_t type = 0; type < system.types.size(); ++type) {
            scene.cloth.yarns.push_back(
                make_yarn(system.types[type], textile.system(other_kind(kind)).pitch, experiment.closure, scene.climate));
            scene.cloth.shapes.push_back(make_shape(system, type));
        }
        for (int yarn = 0; yarn < system.count; ++yarn)
            scene.cloth.type.push_back(static_cast<std::uint8_t>(before + textile.type_of(kind, yarn)));
    }
    const std::size_t warps = textile.warp.types.size(), wefts = textile.weft.types.size();
    scene.cloth.warp_types = static_cast<int>(warps);
    for (std::size_t warp = 0; warp < warps; ++warp)
        for (std::size_t weft = 0; weft < wefts; ++weft) {
            const YarnType &over = textile.warp.types[warp], &under = textile.weft.types[weft];
            scene.cloth.crossing.push_back(
                make_crossing(over, under, scene.cloth.yarns[warp], scene.cloth.yarns[warps + weft], scene.climate));
            scene.cloth.crossing.back().warp_rise = over.rise[weft];
            scene.cloth.crossing.back().weft_rise = under.rise[warp];
        }
    // The open space between the yarns of the layer serves the vapour of both systems, each in its own direction.
    const double open = std::max(0.0, 1.0 - (mean_area(textile.warp) / textile.warp.pitch + mean_area(textile.weft) / textile.weft.pitch) /
                                                textile.thickness);
    for (std::size_t type = 0; type < scene.cloth.yarns.size(); ++type) {
        const double pitch = type < warps ? textile.warp.pitch : textile.weft.pitch;
        scene.cloth.yarns[type].open_vapour = vapour_diffusivity_between(scene.climate.temperature, open) * pitch * textile.thickness;
    }
    scene.cloth.warp_pitch = textile.warp.pitch;
    scene.cloth.weft_pitch = textile.weft.pitch;
    scene.cloth.profile_samples = static_cast<int>(textile.warp.paths[0].height.size());
}

/// Whether liquid spreads by suction from where it falls or is poured. Then warp and weft flow at once: one after the other they carry
/// it along both too far and between them too little, which shows as a cross. Elsewhere it goes one way, or evenly.
bool spreads_from_a_spot(const Scene& scene)
{
    return scene.cloth.by_suction && (!scene.supply.droplets.empty() || !scene.supply.pools.empty());
}

void flow_by_suction(Scene& scene, const Textile& textile, const ModelPlan& plan)
{
    scene.cloth.by_suction = true;
    const LiquidInPores liquid{scene.climate.surface_tension, scene.climate.viscosity};
    scene.cloth.touching = contacts_of(textile, liquid);
    const int room_voxels = plan.on("wicking") ? static_cast<int>(plan.knobs.room_voxels) : 0;
    const auto drawn = room_voxels > 0 ? room_tables(textile, room_voxels) : std::make_shared<const RoomTables>();
    const std::size_t warps = textile.warp.types.size(), wefts = textile.weft.types.size();
    for (std::size_t type = 0; type < warps + wefts; ++type) {
        const bool is_warp = type < warps;
        const YarnBySuction found = yarn_by_suction(is_warp ? textile.warp.types[type] : textile.weft.types[type - warps], textile,
                                                    is_warp ? YarnKind::warp : YarnKind::weft, liquid);
        YarnParameters& yarn = scene.cloth.yarns[type];
        yarn.on_face[0] = found.at_bottom;
        yarn.on_face[1] = found.on_top;
        if (!plan.on("wicking")) // air fills the pores in a finish, too
            for (WettedPores& pores : yarn.on_face) pores.finish.holds = 1;
        yarn.flow_along = found.flow_along;
        yarn.face_conductance = found.face_conductance;
    }
    for (std::size_t warp = 0; warp < warps; ++warp)
        for (std::size_t weft = 0; weft < wefts; ++weft)
            scene.cloth.crossing[warp * wefts + weft].between = room_of_crossing(textile, warp, weft, liquid, *drawn);
    scene.cloth.room_along = room_along_of(textile, *drawn);
}

std::vector<SceneDroplet> make_droplets(const Textile& textile, const Experiment& experiment)
{
    std::vector<SceneDroplet> droplets;
    for (const Droplet& d : falling_drops(experiment)) {
        SceneDroplet drop;
        drop.time = d.time_s;
        drop.volume = cubic_metre_from_ul(d.volume_ul);
        drop.speed = d.speed_m_s;
        const double radius = std::cbrt(3.0 * drop.volume / (4.0 * pi));
        drop.centre = {metre_from_mm(d.at_mm[0]), metre_from_mm(d.at_mm[1]),
                       textile.half_thickness() + metre_from_mm(d.height_mm) + radius};
        droplets.push_back(drop);
    }
    std::stable_sort(droplets.begin(), droplets.end(), [](const SceneDroplet& a, const SceneDroplet& b) { return a.time < b.time; });
    return droplets;
}

/// Another seed places the particles of each drop in another way; with the first, 1, lattices lie along the yarns.
void turn_lattices(std::vector<SceneDroplet>& droplets, std::uint64_t seed)
{
    constexpr std::uint64_t first = 1, stream = 0xd209; // apart from the yarns' own
    for (std::size_t i = 0; i < droplets.size() && seed != first; ++i)
        droplets[i].turn = 0.5 * pi * random_uniform(seed, stream, static_cast<std::uint64_t>(i));
}

/// Everything of the strip's end that hangs in the liquid; the strip's lowest yarn is its first.
void hang_in_liquid(Scene& scene, const Textile& textile, const Experiment& experiment)
{
    scene.supply.fed.assign(static_cast<std::size_t>(scene.cloth.segments()), 0);
    const double pitch = experiment.along_weft ? textile.warp.pitch : textile.weft.pitch;
    const int deep = std::max(1, static_cast<int>(std::lround(metre_from_mm(experiment.immersion_mm) / pitch)));
    for (int end = 0; end < scene.cloth.ends; ++end)
        for (int pick = 0; pick < scene.cloth.picks; ++pick)
            if ((experiment.along_weft ? end : pick) < deep)
                for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
                    scene.supply.fed[static_cast<std::size_t>(textile.segment(kind, end, pick))] = 1;
    (experiment.along_weft ? scene.cloth.gravity_along_weft : scene.cloth.gravity_along_warp) = gravity_acceleration;
}

/// In equilibrium with another climate.
void start_in(Scene& scene, const Climate& initial)
{
    const double temperature = kelvin_from_celsius(initial.temperature_c);
    scene.cloth.start.warmth = temperature - scene.climate.temperature;
    scene.cloth.start.humidity = initial.relative_humidity;
    for (YarnParameters& yarn : scene.cloth.yarns)
        yarn.initial_regain = equilibrium_regain(yarn.isotherm, initial.relative_humidity, temperature);
}

/// On the top face. drops: 0 for an even feed.
ScenePool pool_of(double volume, double feed, int drops)
{
    const double drop = drops > 0 ? volume / drops : 0.0;
    return {0, feed, volume / feed, true, drop, least_pool(volume, drops, cubic_metre_from_ul(hanging_drop_ul))};
}

void set_up(Scene& scene, const Textile& textile, const Experiment& experiment, const ModelPlan& plan)
{
    const double volume = cubic_metre_from_ul(experiment.volume_ul);
    constexpr double pouring = 5; // s, to dispense the liquid of a horizontal test
    if (plan.on("liquid")) scene.supply.droplets = make_droplets(textile, experiment);
    if (plan.on("cap")) {
        const FaceAngles angles = angles_on_face(textile);
        scene.caps = {true, angles.advancing, angles.receding};
    }
    switch (experiment.type) {
    case ExperimentType::droplet: break;
    case ExperimentType::moisture_management:
        scene.supply.pools.push_back(pool_of(volume, experiment.feed_s, drops_of_feed(experiment)));
        break;
    case ExperimentType::horizontal_wicking: scene.supply.pools.push_back(pool_of(volume, pouring, 0)); break;
    case ExperimentType::vertical_wicking: hang_in_liquid(scene, textile, experiment); break;
    case ExperimentType::drying: wet_evenly(scene, 1e-3 * experiment.initial_water_g_m2); break;
    case ExperimentType::conditioning: start_in(scene, experiment.initial); break;
    case ExperimentType::sweat:
        scene.supply.sweat = 1e-3 * experiment.rate_g_m2_h / 3600.0 / scene.climate.density;
        scene.supply.sweat_on_top = experiment.from_top;
        break;
    }
}

constexpr double rounding = 1e-9; // of the time from drop to drop

} // namespace

double ScenePool::delivered(double time) const
{
    const double running = std::clamp(time, start, end) - start;
    if (drop <= 0) return rate * running;
    const double came = std::ceil(rate * (time - start) / drop - rounding) - 1.0;
    return drop * std::clamp(came, 0.0, std::round(rate * (end - start) / drop));
}

double ScenePool::next_change(double time) const
{
    double next = time < start ? start : time < end ? end : std::numeric_limits<double>::infinity();
    if (drop > 0 && time >= start && time < end)
        next = std::min(next, start + (std::floor(rate * (time - start) / drop + rounding) + 1.0) * drop / rate);
    return next;
}

AirMoment air_of(const Climate& air, double time, const Textile& textile, const Experiment& experiment)
{
    const auto [width, height] = sample_extent_mm(experiment);
    const double sample = metre_from_mm(std::max(width, height));
    const double hair = std::max(0.0, 0.5 * (metre_from_mm(textile.quantities.thickness_mm) - textile.thickness));
    return scene_climate(air, time, kelvin_from_celsius(experiment.climate.temperature_c), sample, hair);
}

AirMoment air_at(const SceneClimate& climate, double time)
{
    if (climate.course.empty())
        return {time, climate.air_warmth, climate.humidity, climate.heat_transfer, climate.mass_transfer, climate.air_speed};
    const auto after = std::upper_bound(climate.course.begin(), climate.course.end(), time,
                                        [](double at, const AirMoment& moment) { return at < moment.time; });
    const AirMoment& last = *(after - 1);
    AirMoment now = last;
    if (after == climate.course.end()) return now;
    const double share = (time - last.time) / (after->time - last.time);
    const auto between = [&](double AirMoment::*value) { now.*value += share * (*after.*value - last.*value); };
    between(&AirMoment::air_warmth);
    between(&AirMoment::humidity);
    between(&AirMoment::heat_transfer);
    between(&AirMoment::mass_transfer);
    between(&AirMoment::air_speed);
    return now;
}

void set_parts(Scene& scene, const ModelPlan& plan)
{
    scene.rules.wicking = plan.on("wicking");
    scene.rules.sorption = plan.on("sorption");
    scene.rules.vapour = plan.on("vapour");
    scene.rules.heat = plan.on("heat");
    scene.rules.fibre_shells = plan.fibre_shells;
    scene.rules.shows_wet_sums = std::any_of(plan.parts.begin(), plan.parts.end(), [](const PlannedPart& part) { return part.watched; });
}

Scene build_scene(const Design& design, const Textile& textile, const Experiment& experiment, const ModelPlan& plan, std::uint64_t seed)
{
    Scene scene;
    scene.cloth.ends = textile.ends();
    scene.cloth.picks = textile.picks();
    scene.cloth.length.resize(static_cast<std::size_t>(scene.cloth.segments()));
    scene.cloth.shift.resize(static_cast<std::size_t>(scene.cloth.segments()));
    scene.cloth.warp_up.resize(static_cast<std::size_t>(scene.cloth.crossings()));
    for (int end = 0; end < scene.cloth.ends; ++end)
        for (int pick = 0; pick < scene.cloth.picks; ++pick) {
            for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
                const auto segment = static_cast<std::size_t>(textile.segment(kind, end, pick));
                scene.cloth.length[segment] = textile.segment_length(kind, end, pick);
                scene.cloth.shift[segment] = static_cast<float>(textile.shift_at_crossing(kind, end, pick));
            }
            scene.cloth.warp_up[static_cast<std::size_t>(end * scene.cloth.picks + pick)] = textile.warp_up(end, pick);
        }
    scene.cloth.cell_area = textile.warp.pitch * textile.weft.pitch;
    scene.cloth.half_thickness = textile.half_thickness();
    scene.cloth.shown_ends = plan.shown_ends;
    scene.cloth.shown_picks = plan.shown_picks;
    add_climate(scene, textile, *find_liquid(design, experiment.liquid), experiment);
    add_yarns(scene, textile, experiment);
    if (experiment.closure == Closure::pores) {
        flow_by_suction(scene, textile, plan);
        scene.cloth.pores = uneven_pores(textile, scene.cloth.length, seed);
    }
    scene.rules.particles_per_droplet = plan.particles_per_droplet;
    set_parts(scene, plan);
    scene.cloth.swelling = experiment.swelling ? 1e-3 : 0.0; // m3 per kg: bound water takes as much room as liquid
    set_up(scene, textile, experiment, plan);
    turn_lattices(scene.supply.droplets, seed);
    if (!scene.rules.heat) scene.cloth.start.warmth = 0; // as warm as the air from the start
    scene.rules.network_step = plan.knobs.network_step_limit;
    scene.rules.calm_network_step = longest_calm_step;
    scene.rules.step_share = calm_step_share(plan.knobs);
    scene.rules.step_error = plan.knobs.step_error;
    scene.rules.rest_tolerance = plan.rest_tolerance;
    constexpr double bears = 2.0, left_open = 5e-4; // changes of saturation in whole flow; of a change, in what suctions leave open
    scene.rules.whole_flow = spreads_from_a_spot(scene);
    scene.rules.saturation_change = (scene.rules.whole_flow ? bears : 1.0) * plan.knobs.saturation_change;
    scene.rules.suction_error = left_open * plan.knobs.saturation_change;
    scene.rules.liquid_step_factor = plan.knobs.liquid_step_factor;
    scene.rules.steps_between_absorption = static_cast<int>(plan.knobs.steps_between_absorption);
    scene.rules.density_tolerance = plan.knobs.density_tolerance;
    scene.rules.settle_share = plan.knobs.settle_share;
    scene.rules.double_precision = plan.knobs.double_precision != 0;
    return scene;
}

} // namespace hygroloom
