// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Cheap bounds before the run decide what it models. Each bound is a number people can check in the reason.
#include "core/plan/model_plan.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/physics/heat_moisture.h"
#include "core/physics/liquid.h"
#include "core/physics/sorption.h"
#include "core/physics/wicking.h"
#include "core/plan/bundles.h"
#include "core/plan/expectation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {
namespace {

constexpr const char* part_names[] = {"liquid", "wicking", "sorption", "vapour", "heat", "growth"};

/// Quantities that the bounds are made of.
struct Bounds {
    double delivered = 0;           // kg that come as liquid
    double at_stake = 0;            // kg that what is left out is compared with
    double capacity = 0;            // kg/m2 that the wicking yarns' pores hold, at least, where liquid is
    double wet_area = 0;            // m2 that can get wet, or that the air works on
    double sorbable = 0;            // kg the fibres of that area can take or give
    double evaporated = 0;          // kg from both its faces in the duration, or condensed on all of the sample
    double temperature_rise = 0;    // K if all sorbed at once and nothing escaped
    double wet_bulb_depression = 0; // K, at most, by evaporation; or by how much condensation warms
    double slowed = 0;              // share of the evaporation that this holds back
    double finest = 0;              // m, height of the thinnest yarn
    std::size_t drops = 0;          // that fall
    double smallest_angle = 180;    // degrees, of contact
    double suction = 0;             // its cosine; 0: no yarn wicks
    double uptake = 0;              // m3/s: see SceneCounts
    double pores = 0;               // m: see SceneCounts
    double cover = 0;               // share of the area under yarns
    LiquidAt liquid{};
    bool wicks = false;
    bool condenses = false; // vapour of air that is more than saturated, on all of the cloth
};

constexpr const char* mixing = "bundles of so many would mix yarns that differ";
constexpr double least_mobile_saturation = 0.2; // below it liquid hardly moves; 0.1 to 0.2 are possible

/// Share of the sample's ends or picks that each type of yarn has.
std::vector<double> shares_of_types(const Textile& textile, YarnKind kind)
{
    const YarnSystem& system = textile.system(kind);
    std::vector<double> shares(system.types.size(), 0.0);
    for (int yarn = 0; yarn < system.count; ++yarn) shares[static_cast<std::size_t>(textile.type_of(kind, yarn))] += 1;
    for (double& share : shares) share /= system.count;
    return shares;
}

/// The driest, windiest and warmest of a course.
Climate hardest_climate(const Experiment& experiment)
{
    Climate hardest = experiment.climate;
    for (const ClimateMoment& moment : experiment.climates) {
        hardest.temperature_c = std::max(hardest.temperature_c, moment.climate.temperature_c);
        hardest.relative_humidity = std::min(hardest.relative_humidity, moment.climate.relative_humidity);
        hardest.air_speed_m_s = std::max(hardest.air_speed_m_s, moment.climate.air_speed_m_s);
    }
    return hardest;
}

/// The moistest air of a course.
double most_humid(const Experiment& experiment)
{
    double most = experiment.climate.relative_humidity;
    for (const ClimateMoment& moment : experiment.climates) most = std::max(most, moment.climate.relative_humidity);
    return most;
}

/// Liquid that the experiment brings, kg; of a strip that hangs in liquid, what all its pores hold.
double delivered_water(const Experiment& experiment, double sample, double capacity, double density)
{
    double volume = 0;
    switch (experiment.type) {
    case ExperimentType::droplet:
        for (const Droplet& d : falling_drops(experiment)) volume += cubic_metre_from_ul(d.volume_ul);
        return volume * density;
    case ExperimentType::moisture_management:
    case ExperimentType::horizontal_wicking: return cubic_metre_from_ul(experiment.volume_ul) * density;
    case ExperimentType::vertical_wicking: return capacity * sample;
    case ExperimentType::drying: return 1e-3 * experiment.initial_water_g_m2 * sample;
    case ExperimentType::sweat: return 1e-3 * experiment.rate_g_m2_h / 3600.0 * experiment.duration_s * sample;
    case ExperimentType::conditioning: break;
    }
    return 0;
}

Bounds find_bounds(const Design& design, const Textile& textile, const Experiment& experiment)
{
    Bounds b;
    b.finest = textile.thickness;
    b.cover = textile.quantities.cover_factor;
    b.drops = falling_drops(experiment).size();
    const Climate air = hardest_climate(experiment);
    const double temperature = kelvin_from_celsius(air.temperature_c);
    const double humidity = air.relative_humidity;
    const Liquid& liquid = *find_liquid(design, experiment.liquid);
    b.liquid = liquid_at(
        {newton_per_metre_from_mn_m(liquid.surface_tension_mn_m), pascal_second_from_mpa_s(liquid.viscosity_mpa_s), liquid.density_kg_m3},
        kelvin_from_celsius(experiment.climate.temperature_c));
    const double density = b.liquid.density;
    const bool conditioning = experiment.type == ExperimentType::conditioning;

    double sorbable = 0, everything = 0; // kg/m2 of fabric: that fibres take, that all pores hold
    double thirst = 0;                   // kg that fibres take per kg of liquid, where liquid barely moves, of the thirstiest wicking yarn
    const auto look_at = [&](const YarnType& type, double along) { // m of yarn per m2, crimp left out
        const double pores = type.area * (1.0 - type.packing) * density, fibres = type.area * type.packing * type.fibre.density_kg_m3;
        const bool wicks = std::cos(type.contact_angle) > 1e-12;
        const Isotherm isotherm{type.fibre.standard_regain, type.fibre.saturation_regain, type.fibre.gab.monolayer_regain, type.fibre.gab.c,
                                type.fibre.gab.k};
        const auto regain = [&](const Climate& climate) {
            return equilibrium_regain(isotherm, climate.relative_humidity, kelvin_from_celsius(climate.temperature_c));
        };
        double gain = equilibrium_regain(isotherm, 1.0, temperature) - regain(air);
        if (conditioning) gain = std::abs(regain(experiment.initial) - regain(experiment.climate));
        for (const ClimateMoment& moment : experiment.climates)
            gain = std::max(gain, std::abs(regain(moment.climate) - regain(experiment.climate)));
        everything += along * pores;
        sorbable += along * fibres * gain;
        const double liquid = conditioning ? 0.0 : least_mobile_saturation * pores;
        if (wicks && liquid > 0) thirst = std::max(thirst, fibres * gain / liquid);
        const double heat = heat_of_sorption(std::min({humidity, conditioning ? experiment.initial.relative_humidity : 1.0, 1.0})) +
                            (conditioning ? heat_of_evaporation(temperature) : 0.0);
        b.temperature_rise =
            std::max(b.temperature_rise, fibres * gain * heat / (fibres * type.fibre.specific_heat_j_kgk + liquid * water_specific_heat));
        b.finest = std::min(b.finest, type.section.height);
        b.smallest_angle = std::min(b.smallest_angle, type.contact_angle * 180.0 / pi);
        b.wicks = b.wicks || wicks;
        if (wicks) b.suction = std::max(b.suction, std::cos(type.contact_angle));
        if (wicks) b.pores += along * pores / density;
        b.uptake += along * pores / density / type.tortuosity *
                    saturated_liquid_diffusivity(b.liquid.surface_tension, type.contact_angle, type.pore_radius, b.liquid.viscosity);
        return wicks ? along * pores : 0.0;
    };
    // Liquid may run along the yarns of one type alone, whichever holds least: bounds are those of the worst type, not of the mean.
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        const YarnSystem& system = textile.system(kind);
        const std::vector<double> shares = shares_of_types(textile, kind);
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t type = 0; type < shares.size(); ++type) {
            if (shares[type] <= 0) continue;
            const double holds = look_at(system.types[type], shares[type] / system.pitch) / shares[type];
            if (holds > 0) least = std::min(least, holds);
        }
        if (std::isfinite(least)) b.capacity += least;
    }
    const auto [width, height] = sample_extent_mm(experiment);
    const double sample = metre_from_mm(width) * metre_from_mm(height);
    b.delivered = delivered_water(experiment, sample, everything, density);
    const bool spot = experiment.type == ExperimentType::droplet || experiment.type == ExperimentType::moisture_management ||
                      experiment.type == ExperimentType::horizontal_wicking;
    b.wet_area = spot && b.capacity > 0 ? std::min(sample, b.delivered / (least_mobile_saturation * b.capacity)) : sample;
    b.sorbable = spot ? std::min(sorbable * sample, thirst * b.delivered) : sorbable * sample;
    b.at_stake = std::max(b.delivered, conditioning ? b.sorbable : 0.0);
    const double convection = convective_heat_transfer(air.air_speed_m_s, metre_from_mm(std::max(width, height)));
    const double dry = 1.0 - humidity, damp = most_humid(experiment) - 1.0;
    b.condenses = damp > 0;
    b.evaporated = 2.0 * std::max(b.wet_area * dry, sample * damp) * experiment.duration_s * mass_transfer(convection, temperature) *
                   saturation_concentration(temperature);
    const double dry_transfer = convection + radiative_heat_transfer(temperature), wet_transfer = mass_transfer(convection, temperature);
    b.wet_bulb_depression = wet_bulb_depression(dry_transfer, wet_transfer, temperature, 1.0 - std::max(dry, damp));
    b.slowed = cooling_slows_evaporation(dry_transfer, wet_transfer, temperature);
    return b;
}

/// Not more particles than a spacing of a tenth of a yarn's height allows: a tiny drop has nothing finer to show. Where no yarn drinks a
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

PlannedPart decide(const char* name, bool on, std::string reason, const ForcedParts& forced)
{
    PlannedPart part{name, on, false, std::move(reason)};
    const auto found = forced.find(name);
    if (found != forced.end()) {
        part.reason = fmt::format("Forced {} by the user; left to itself it would be {}: {}", found->second ? "on" : "off",
                                  on ? "on" : "off", part.reason);
        part.on = found->second;
        part.forced = true;
    }
    return part;
}

/// A part that is left out where it changes less than the neglected share; then, if it can matter at all, the run watches it.
struct Estimate {
    double share;     ///< at most, as far as can be told before the run
    bool can_matter;  ///< not when what it is about is not there
    std::string what; ///< the run watches
};
PlannedPart decide_by(const char* name, const Estimate& estimate, std::string reason, const Knobs& knobs, const ForcedParts& forced)
{
    PlannedPart part = decide(name, estimate.can_matter && estimate.share > knobs.neglected_share, std::move(reason), forced);
    part.share = estimate.share;
    part.watched = !part.on && !part.forced && estimate.can_matter;
    if (part.watched)
        part.reason +=
            fmt::format(" Watched while running: {}; over {:.3g} % the part is switched on.", estimate.what, 100 * knobs.neglected_share);
    return part;
}

/// What is left out where the share is that of the knob, in a clause.
std::string left_out_below(double share)
{
    return share > 0 ? fmt::format("parts below {:.3g} % are left out at this fidelity", 100 * share)
                     : "nothing that has an effect is left out at this fidelity";
}

/// How the experiment brings its water, in words.
std::string supply_in_words(const Experiment& experiment, const Bounds& b)
{
    switch (experiment.type) {
    case ExperimentType::droplet:
        if (b.drops == 0) return "No drop falls in this experiment.";
        return fmt::format("{} {:.4g} mg.", b.drops == 1 ? "One drop brings" : fmt::format("{} drops bring", b.drops), 1e6 * b.delivered);
    case ExperimentType::moisture_management:
        if (b.drops > 0)
            return fmt::format("{} of {:.4g} ul {} {:.4g} mg in {:.4g} s.", b.drops == 1 ? "One drop" : fmt::format("{} drops", b.drops),
                               experiment.volume_ul / static_cast<double>(b.drops), b.drops == 1 ? "brings" : "bring", 1e6 * b.delivered,
                               experiment.feed_s);
        [[fallthrough]];
    case ExperimentType::horizontal_wicking:
        return fmt::format("{:.4g} mg are fed straight into the yarns under a pool; no drop falls.", 1e6 * b.delivered);
    case ExperimentType::vertical_wicking: return "The strip hangs in the liquid; no drop falls.";
    case ExperimentType::drying: return fmt::format("{:.4g} mg are in the cloth at the start; no drop falls.", 1e6 * b.delivered);
    case ExperimentType::sweat: return fmt::format("{:.4g} mg are fed straight into one face; no drop falls.", 1e6 * b.delivered);
    case ExperimentType::conditioning: break;
    }
    return "The cloth meets no liquid in this experiment.";
}

void decide_parts(ModelPlan& plan, const Bounds& b, const Experiment& experiment, const Knobs& knobs, const ForcedParts& forced)
{
    const bool drops = experiment.type == ExperimentType::droplet || b.drops > 0;
    const bool conditioning = experiment.type == ExperimentType::conditioning;
    plan.parts.push_back(decide("liquid", b.drops > 0, supply_in_words(experiment, b), forced));
    const bool wet = drops ? plan.parts.back().on : b.delivered > 0;
    const std::string angle = fmt::format("The smallest contact angle of a yarn is {:g} degrees", b.smallest_angle);
    plan.parts.push_back(decide("wicking", wet && b.wicks,
                                !wet      ? std::string("No liquid comes to the yarns.")
                                : b.wicks ? angle + ", under 90: its pores draw liquid."
                                          : angle + ", 90 or more: no pores draw liquid.",
                                forced));
    const bool wicking = plan.parts.back().on;
    const bool moist = wicking || conditioning || (wet && !drops) || b.condenses; // water can get to the fibres
    plan.water_at_stake = std::max(b.at_stake, 1e-30);
    const std::string left_out = left_out_below(knobs.neglected_share);
    const auto share_reason = [&](const char* what, double share) {
        return share < 1 ? fmt::format("{} at most {:.3g} % of the water delivered; {}.", what, 100 * share, left_out)
                         : fmt::format("{} at most all of the water delivered; {}.", what, left_out);
    };
    const double sorbed = b.sorbable / plan.water_at_stake;
    plan.parts.push_back(
        decide_by("sorption", {sorbed, moist && b.sorbable > 0, "what the fibres can take up wherever the cloth has really got wet"},
                  conditioning ? fmt::format("The fibres exchange {}.", b.sorbable > 0 ? "all the water there is" : "no water")
                               : share_reason("The fibres of the area that can get wet take up", sorbed),
                  knobs, forced));
    const bool sorption = plan.parts.back().on;
    // A sample in a new climate exchanges what its fibres do; without liquid that is all.
    const bool new_climate = conditioning || !experiment.climates.empty();
    const double evaporated = b.evaporated / plan.water_at_stake;
    plan.parts.push_back(
        b.condenses ? decide("vapour", true, "The air has more vapour than it can hold, which condenses on the cloth.", forced)
        : new_climate && (sorption || b.delivered <= 0)
            ? decide("vapour", moist && sorption, "What fibres exchange comes and goes as vapour.", forced)
            : decide_by("vapour",
                        {evaporated, moist && evaporated > 0, "what would evaporate until the end wherever the cloth has really got wet"},
                        share_reason("Evaporation from both faces of the area that can get wet takes", evaporated), knobs, forced));
    const bool vapour = plan.parts.back().on;
    const bool changes_phase = vapour && (b.delivered > 0 || b.condenses);
    const double warming = sorption ? b.temperature_rise : 0.0, cooling = changes_phase ? b.wet_bulb_depression : 0.0;
    double change = conditioning ? std::abs(experiment.initial.temperature_c - experiment.climate.temperature_c) : 0.0;
    for (const ClimateMoment& moment : experiment.climates)
        change = std::max(change, std::abs(moment.climate.temperature_c - experiment.climate.temperature_c));
    const double slowed = changes_phase ? b.slowed * std::min(1.0, evaporated) : 0.0;
    const double rates = change_per_kelvin * std::max({warming, cooling, change}), effect = std::max(rates, slowed);
    const bool may_follow = std::any_of(plan.parts.begin(), plan.parts.end(), [](const PlannedPart& part) { return part.watched; });
    plan.parts.push_back(decide_by(
        "heat",
        {effect, moist && (effect > 0 || may_follow),
         "how far what fibres have really taken up and what evaporates change the temperature"},
        fmt::format("Sorption warms the wet area by at most {:.3g} K, {} it by at most {:.3g} K and the climate "
                    "changes by {:.3g} K; at 2 % a kelvin that changes rates by {}. The cooling holds back at most {:.3g} % of the "
                    "water from evaporating; {}.",
                    warming, b.condenses ? "condensation warms" : "evaporation cools", cooling, change,
                    rates < 1 ? fmt::format("{:.3g} %", 100 * rates) : "more than 100 %", 100 * slowed, left_out),
        knobs, forced));
}

/// Whether only the cloth near the water is visited, a region that grows.
void decide_growth(ModelPlan& plan, const Bounds& b, const Experiment& experiment, const Knobs& knobs, const ForcedParts& forced)
{
    const auto [width, height] = sample_extent_mm(experiment);
    const bool everywhere = experiment.type == ExperimentType::drying || experiment.type == ExperimentType::conditioning ||
                            experiment.type == ExperimentType::sweat || !experiment.climates.empty() || b.condenses;
    const double wet = 1e6 * b.wet_area / (width * height);
    plan.parts.push_back(
        decide("growth", !everywhere,
               everywhere ? std::string("All of the sample changes from the start.")
                          : fmt::format("Only the cloth near the liquid is visited: it can wet {} of the sample. What is visited grows "
                                        "before the air in its pores changes by {:.3g} % humidity at its border.",
                                        wet < 1 ? fmt::format("at most {:.3g} %", 100 * wet) : "all", 100 * knobs.rest_tolerance),
               forced));
    plan.rest_tolerance = plan.on("growth") ? knobs.rest_tolerance : 0;
}

TextileRegion decide_region(ModelPlan& plan, const Fabric& fabric, const Experiment& experiment, const Bounds& b)
{
    const auto [width, height] = sample_extent_mm(experiment);
    const TextileRegion sample = region_of_sample(fabric, width, height);
    plan.region_reason = fmt::format("The whole sample: {} ends and {} picks. The liquid can wet {} mm² of its {} mm².", sample.ends,
                                     sample.picks, rounded_text(1e6 * b.wet_area, 3), rounded_text(width * height, 3));
    return sample;
}

/// Whether each bundle's yarns are of one type.
bool bundles_are_alike(const Textile& textile, YarnKind kind, const Bundles& bundles)
{
    for (int yarn = 0; yarn < bundles.yarns; ++yarn)
        for (int bundle : {bundles.first_of(yarn), bundles.last_of(yarn)})
            if (textile.type_of(kind, yarn) != textile.type_of(kind, bundles.middle_of(bundle))) return false;
    return true;
}

/// Whether all of the cloth but its edges is alike.
bool is_even(ExperimentType type) { return type == ExperimentType::drying || type == ExperimentType::conditioning; }

/// Ends, and picks, of a bundle where only the edges differ from the rest: as many as leave some bundles between.
int wanted_where_even(const Knobs& knobs, const Textile& textile)
{
    constexpr int least_bundles = 8;
    return std::min(static_cast<int>(knobs.crossings_per_even_cell), std::min(textile.ends(), textile.picks()) / least_bundles);
}

/// Ends, and picks, that the fidelity puts into a bundle.
int wanted_in_bundle(const Knobs& knobs, const Textile& textile, ExperimentType type)
{
    const int at_fronts = static_cast<int>(knobs.crossings_per_cell);
    return is_even(type) ? std::max(at_fronts, wanted_where_even(knobs, textile)) : at_fronts;
}

/// Why each yarn is simulated alone whatever the fidelity asks for; nullptr: it need not be.
const char* why_single(const ModelPlan& plan, ExperimentType type)
{
    return plan.on("liquid")               ? "free liquid meets single yarns"
           : type == ExperimentType::sweat ? "sweat wets yarns where they lie on one face"
                                           : nullptr;
}

/// How many crossings a cell has, told in a sentence where they are or might have been several.
std::string decide_cells(ModelPlan& plan, const Textile& textile, const Experiment& experiment)
{
    const int wanted = wanted_in_bundle(plan.knobs, textile, experiment.type);
    plan.crossings_per_cell = 1;
    if (wanted <= 1) return "";
    const auto alike = [&](int of) {
        return bundles_are_alike(textile, YarnKind::warp, bundles_of(textile.ends(), of)) &&
               bundles_are_alike(textile, YarnKind::weft, bundles_of(textile.picks(), of));
    };
    int most = wanted;
    while (most > 1 && !alike(most)) --most;
    const char* why_not = why_single(plan, experiment.type);
    if (!why_not && most == 1) why_not = mixing;
    if (why_not)
        return fmt::format(" Each crossing stays a cell of its own, although the fidelity would put {} ends and picks into one: {}.",
                           wanted, why_not);
    const Bundles ends = bundles_of(textile.ends(), most), picks = bundles_of(textile.picks(), most);
    plan.crossings_per_cell = most;
    return fmt::format(" The {} ends and {} picks are simulated as {} and {} bundles; what a frame shows of a yarn is its bundle's.",
                       ends.yarns, picks.yarns, ends.count, picks.count);
}

/// Tells of the knobs by which bundles are made which have no effect. After decide_cells().
void find_idle_bundle_knobs(ModelPlan& plan, const Textile& textile, ExperimentType type)
{
    auto &at_fronts = plan.idle_knobs["crossings_per_cell"], &where_even = plan.idle_knobs["crossings_per_even_cell"];
    const double fronts = plan.knobs.crossings_per_cell, even = wanted_where_even(plan.knobs, textile);
    if (const char* why = why_single(plan, type))
        at_fronts = where_even = why;
    else if (!is_even(type))
        where_even = "only in drying and conditioning is all of the cloth alike";
    else if (wanted_in_bundle(plan.knobs, textile, type) > 1 && plan.crossings_per_cell == 1)
        at_fronts = where_even = mixing;
    else if (fronts < even)
        at_fronts = "crossings_per_even_cell asks for larger bundles";
    else if (plan.knobs.crossings_per_even_cell > 1 && even <= 1)
        where_even = "the sample has too few yarns for bundles";
    else if (even < fronts)
        where_even = "crossings_per_cell asks for larger bundles";
}

/// Fills in which knobs change nothing in the scene, and why. When all else is decided.
void find_idle_knobs(ModelPlan& plan, const Textile& textile, const Experiment& experiment, const Bounds& b)
{
    const auto idle = [&](bool is, const char* knob, const char* why) {
        if (is) plan.idle_knobs[knob] = why;
    };
    const bool liquid = plan.on("liquid");
    for (const char* knob : {"particles_per_droplet", "network_step_limit_s", "liquid_step_factor", "steps_between_drinks",
                             "density_tolerance", "settle_share", "double_precision"})
        idle(!liquid, knob, b.drops > 0 ? "the free liquid is left out" : "no drop falls");
    idle(liquid && !b.wicks, "steps_between_drinks", "no yarn draws liquid");
    const bool pool = experiment.type == ExperimentType::moisture_management || experiment.type == ExperimentType::horizontal_wicking;
    idle(!liquid && !pool, "saturation_change", "there is neither a drop nor a pool");
    const auto may_be_on = [&](const char* part) { return plan.on(part) || plan.watches(part); };
    idle(!may_be_on("sorption"), "fibre_shells", "sorption is left out");
    idle(!plan.on("wicking") && !may_be_on("sorption") && !may_be_on("vapour"), "step_error", "the yarns stay dry");
    idle(!plan.on("growth"), "rest_tolerance", "all of the sample is visited");
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
    counts.drops = static_cast<double>(b.drops);
    if (b.drops > 0) counts.drop_volume = b.delivered / b.liquid.density / counts.drops;
    counts.duration = experiment.duration_s;
    counts.wet_share = std::min(1.0, b.wet_area / (metre_from_mm(width) * metre_from_mm(height)));
    if (experiment.type == ExperimentType::moisture_management) // not all may have come by the end
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
    const bool liquid = plan.on("liquid");
    std::string text = fmt::format("{} fidelity{}: ", name_of(plan.fidelity), set_by_user ? " with knobs set by the user" : "");
    if (liquid) text += fmt::format("{} particles a drop, ", plan.particles_per_droplet);
    text += fmt::format("one cell per {} and crossing, ", plan.crossings_per_cell > 1 ? "bundle" : "yarn");
    if (plan.on("sorption")) text += fmt::format("{} shells in a fibre, ", plan.fibre_shells);
    if (!liquid) return text + fmt::format("steps that misplace at most {:.2g} % of the water and heat at stake.", 100 * knobs.step_error);
    text += fmt::format("network steps of at most {:.3g} ms that change no saturation by more than about {:.2g}; ",
                        1e3 * knobs.network_step_limit, knobs.saturation_change);
    return text + (knobs.settle_share > 0
                       ? fmt::format("liquid at rest takes no steps until {:g} % of it are drunk.", 100 * knobs.settle_share)
                       : std::string("liquid at rest is never skipped."));
}

} // namespace

bool ModelPlan::on(const std::string& part) const
{
    return std::any_of(parts.begin(), parts.end(), [&](const PlannedPart& p) { return p.name == part && p.on; });
}

bool ModelPlan::watches(const std::string& part) const
{
    return std::any_of(parts.begin(), parts.end(), [&](const PlannedPart& p) { return p.name == part && p.watched; });
}

std::vector<std::string> notes_of(const ModelPlan& plan)
{
    std::vector<std::string> notes;
    if (plan.crossings_per_cell > 1)
        notes.push_back(fmt::format("Yarns side by side went in bundles: {} ends and {} picks as {} and {}.", plan.region.ends,
                                    plan.region.picks, bundles_of(plan.region.ends, plan.crossings_per_cell).count,
                                    bundles_of(plan.region.picks, plan.crossings_per_cell).count));
    for (const KnobInfo* knob : changed_knobs(knobs_of(plan.fidelity), plan.knobs))
        if (const auto idle = plan.idle_knobs.find(knob->name); idle != plan.idle_knobs.end())
            notes.push_back(fmt::format("{} was set and had no effect: {}.", knob->name, idle->second));
    return notes;
}

ModelPlan with_part(ModelPlan plan, const std::string& part)
{
    for (PlannedPart& planned : plan.parts)
        if (planned.name == part) planned.on = true;
    if (part == "sorption") plan.fibre_shells = static_cast<int>(plan.knobs.fibre_shells);
    return plan;
}

ForcedParts parse_forced_parts(const std::string& text)
{
    ForcedParts forced;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        const std::string item = text.substr(at, comma - at);
        at = comma + 1;
        const std::size_t equals = std::min(item.find('='), item.size());
        const std::string name = item.substr(0, equals), value = equals < item.size() ? item.substr(equals + 1) : "";
        if (std::find(std::begin(part_names), std::end(part_names), name) == std::end(part_names) || (value != "on" && value != "off"))
            throw Error("Each part of the physics is given as name=on or name=off, with the names liquid, wicking, sorption, vapour, heat "
                        "and growth; \"" +
                        item + "\" was given.");
        forced[name] = value == "on";
    }
    return forced;
}

Textile textile_of_run(const Design& design, const Fabric& fabric, const Experiment& experiment, const TextileRegion& region)
{
    if (experiment.closure != Closure::paper || fabric.contact_angle_deg) return build_textile(design, fabric, region);
    Fabric alike = fabric;
    alike.contact_angle_deg = find_library_material("cotton")->contact_angle_deg;
    return build_textile(design, alike, region);
}

ModelPlan plan_model(const Design& design, const Fabric& fabric, const Experiment& experiment, Fidelity fidelity, const ForcedParts& forced,
                     const KnobSettings& settings)
{
    const auto [width, height] = sample_extent_mm(experiment);
    const TextileRegion sample = region_of_sample(fabric, width, height);
    const Textile textile = textile_of_run(design, fabric, experiment, sample);
    const Bounds bounds = find_bounds(design, textile, experiment);

    ModelPlan plan;
    plan.fidelity = fidelity;
    plan.knobs = with_settings(knobs_of(fidelity), settings);
    decide_parts(plan, bounds, experiment, plan.knobs, forced);
    decide_growth(plan, bounds, experiment, plan.knobs, forced);
    plan.region = decide_region(plan, fabric, experiment, bounds);
    plan.segments = 2 * plan.region.ends * plan.region.picks;
    plan.particles_per_droplet = plan.on("liquid") ? particles_for(plan.knobs, bounds) : 0;
    plan.fibre_shells = plan.on("sorption") ? static_cast<int>(plan.knobs.fibre_shells) : 1;
    const std::string cells = decide_cells(plan, textile, experiment);
    find_idle_knobs(plan, textile, experiment, bounds);
    plan.frame_interval = std::clamp(experiment.duration_s / 100.0, 1e-6, 60.0);
    plan.resolution_reason = resolution_in_words(plan, !settings.empty()) + cells;
    plan.counts = counts_of(experiment, bounds);
    expect(plan, shipped_measurements("cpu"));
    return plan;
}

} // namespace hygroloom
