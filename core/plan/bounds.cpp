// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/bounds.h"

#include "core/geometry/face_angles.h"
#include "core/physics/between_yarns.h"
#include "core/physics/heat_moisture.h"
#include "core/physics/pores.h"
#include "core/physics/scattered_gate.h"
#include "core/physics/sorption.h"
#include "core/physics/wicking.h"
#include "core/plan/supply.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {
namespace {

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

double regain_in(const Isotherm& isotherm, const Climate& climate)
{
    return equilibrium_regain(isotherm, climate.relative_humidity, kelvin_from_celsius(climate.temperature_c));
}

/// Goes through the types of yarn and adds up what the cloth can hold and take up.
class YarnBounds {
public:
    YarnBounds(Bounds& bounds, const Experiment& experiment, const Climate& air)
        : b_(bounds), experiment_(experiment), air_(air), temperature_(kelvin_from_celsius(air.temperature_c)),
          new_climate_(info_of(experiment.type).source == WaterSource::air)
    {
    }

    /// Liquid may run along the yarns of one type alone, whichever holds least: bounds are those of the worst type, not of the mean.
    void look_at(const Textile& textile)
    {
        for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
            const YarnSystem& system = textile.system(kind);
            const std::vector<double> shares = shares_of_types(textile, kind);
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t type = 0; type < shares.size(); ++type) {
                if (shares[type] <= 0) continue;
                const double holds =
                    look_at(system.types[type], angle_on(textile, system.types[type]), shares[type] / system.pitch) / shares[type];
                if (holds > 0) least = std::min(least, holds);
            }
            if (std::isfinite(least)) b_.capacity += least;
        }
        if (experiment_.closure == Closure::pores) look_at_holes(textile);
        if (experiment_.closure == Closure::pores && b_.uptake > 0) look_between(textile); // dry yarns that take in nothing close it, too
    }

    double sorbable = 0;   ///< kg/m2 of fabric that fibres take
    double everything = 0; ///< kg/m2 that all pores hold
    double thirst = 0;     ///< kg that fibres take per kg of liquid, where liquid barely moves, of the most absorbent wicking yarn

private:
    /// Regain that fibres gain, or lose, at most.
    double gain_of(const Isotherm& isotherm) const
    {
        double gain = equilibrium_regain(isotherm, 1.0, temperature_) - regain_in(isotherm, air_);
        if (new_climate_) gain = std::abs(regain_in(isotherm, experiment_.initial) - regain_in(isotherm, experiment_.climate));
        for (const ClimateMoment& moment : experiment_.climates)
            gain = std::max(gain, std::abs(regain_in(isotherm, moment.climate) - regain_in(isotherm, experiment_.climate)));
        return gain;
    }
    /// The smallest contact angle of the type's pores, with the finishes of faces where they go through the yarns.
    double angle_on(const Textile& textile, const YarnType& type) const
    {
        if (experiment_.closure != Closure::pores) return type.contact_angle;
        return std::min(angle_under_finish(textile, type, textile.face_angle), angle_under_finish(textile, type, textile.back_angle));
    }
    /// along: m of yarn per m2, crimp left out. Returns kg/m2 that the type's pores hold; 0 when it does not wick.
    double look_at(const YarnType& type, double contact_angle, double along)
    {
        const double density = b_.liquid.density;
        const double pores = type.area * (1.0 - type.packing) * density, fibres = type.area * type.packing * type.fibre.density_kg_m3;
        const bool wicks = std::cos(contact_angle) > 1e-12;
        const double gain = gain_of({type.fibre.standard_regain, type.fibre.saturation_regain, type.fibre.gab.monolayer_regain,
                                     type.fibre.gab.c, type.fibre.gab.k});
        everything += along * pores;
        sorbable += along * fibres * gain;
        const double liquid = new_climate_ ? 0.0 : least_mobile_saturation * pores;
        if (wicks && liquid > 0) thirst = std::max(thirst, fibres * gain / liquid);
        const double heat =
            heat_of_sorption(std::min({air_.relative_humidity, new_climate_ ? experiment_.initial.relative_humidity : 1.0, 1.0})) +
            (new_climate_ ? heat_of_evaporation(temperature_) : 0.0);
        b_.temperature_rise =
            std::max(b_.temperature_rise, fibres * gain * heat / (fibres * type.fibre.specific_heat_j_kgk + liquid * water_specific_heat));
        b_.finest = std::min(b_.finest, type.section.height);
        b_.smallest_angle = std::min(b_.smallest_angle, contact_angle * 180.0 / pi);
        b_.wicks = b_.wicks || wicks;
        if (wicks) b_.suction = std::max(b_.suction, std::cos(contact_angle));
        if (wicks) b_.pores += along * pores / density;
        b_.uptake +=
            along * (experiment_.closure == Closure::pores ? drawn_by_suction(type, contact_angle)
                                                           : pores / density / type.tortuosity *
                                                                 saturated_liquid_diffusivity(b_.liquid.surface_tension, contact_angle,
                                                                                              type.pore_radius, b_.liquid.viscosity));
        return wicks ? along * pores : 0.0;
    }
    /// m4/s: what a yarn conducts, times the suction of its pores.
    double drawn_by_suction(const YarnType& type, double contact_angle) const
    {
        const double radius = metre_from_um(type.fibre.fibre_radius_um) / type.perimeter_factor;
        const PoreClosure pores = pores_of_bundle(type.packing_round_core(), radius, b_.liquid.surface_tension, contact_angle,
                                                  std::min(type.receding_angle, contact_angle));
        return gate_of_dry_fibres(type.packing_round_core(), contact_angle) * permeability_along_random(radius, type.packing_round_core()) *
               (type.area - type.core_area()) * pores.entry_suction / (b_.liquid.viscosity * type.helix_tortuosity);
    }
    /// Between yarns of any two types, as the scene's holes are.
    void look_at_holes(const Textile& textile)
    {
        const std::vector<double> ends = shares_of_types(textile, YarnKind::warp), picks = shares_of_types(textile, YarnKind::weft);
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t k = 0; k < picks.size(); ++k) {
                const YarnType &warp = textile.warp.types[i], &weft = textile.weft.types[k];
                const double wide = textile.warp.pitch - warp.section.width, high = textile.weft.pitch - weft.section.width;
                if (ends[i] <= 0 || picks[k] <= 0 || wide <= 0 || high <= 0) continue;
                const double angle =
                    0.5 * (textile.back_angle.value_or(warp.contact_angle) + textile.back_angle.value_or(weft.contact_angle));
                b_.holes_hold = std::min(b_.holes_hold, breakthrough_pressure(b_.liquid.surface_tension, angle, 0.5 * warp.section.height,
                                                                              0.5 * wide, 0.5 * weft.section.height, 0.5 * high));
            }
    }
    /// The room between the yarns, of the first of either system.
    void look_between(const Textile& textile)
    {
        const auto yarn = [&](const YarnSystem& system, const YarnSystem& crossed) {
            const YarnType& type = system.types.front();
            const double angle = angle_on(textile, type);
            return CrossingYarn{type.section.width, type.section.height,       type.area, crossed.pitch * type.length_per_pitch.front(),
                                crossed.pitch,      type.packing_round_core(), angle,     std::min(type.receding_angle, angle)};
        };
        const CrossingYarn warp = yarn(textile.warp, textile.weft), weft = yarn(textile.weft, textile.warp);
        const RoomBetweenYarns room = room_between(warp, weft, textile.thickness);
        b_.pores += room.volume / (textile.warp.pitch * textile.weft.pitch);
        const RoomSuctions filling =
            room_suctions(warp, weft, states_by_formula(room), b_.liquid.surface_tension, both_wet, &CrossingYarn::advancing);
        b_.uptake += (room.along_warp + room.along_weft) * textile.thickness * std::max(0.0, filling.low) / b_.liquid.viscosity;
    }

    Bounds& b_;
    const Experiment& experiment_;
    const Climate& air_;
    const double temperature_; // K
    const bool new_climate_;
};

/// What the air does to the wet area.
void bound_drying(Bounds& b, const Experiment& experiment, const Climate& air, double sample)
{
    const auto [width, height] = sample_extent_mm(experiment);
    const double temperature = kelvin_from_celsius(air.temperature_c);
    const double convection = convective_heat_transfer(air.air_speed_m_s, metre_from_mm(std::max(width, height)));
    const double dry = 1.0 - air.relative_humidity, damp = most_humid(experiment) - 1.0;
    b.condenses = damp > 0;
    b.evaporated = 2.0 * std::max(b.wet_area * dry, sample * damp) * experiment.duration_s * mass_transfer(convection, temperature) *
                   saturation_concentration(temperature);
    const double dry_transfer = convection + radiative_heat_transfer(temperature), wet_transfer = mass_transfer(convection, temperature);
    b.wet_bulb_depression = wet_bulb_depression(dry_transfer, wet_transfer, temperature, 1.0 - std::max(dry, damp));
    b.slowed = cooling_slows_evaporation(dry_transfer, wet_transfer, temperature);
}

} // namespace

Bounds find_bounds(const Design& design, const Textile& textile, const Experiment& experiment)
{
    Bounds b;
    b.finest = textile.thickness;
    b.cover = textile.quantities.cover_factor;
    b.advancing_deg = angles_on_face(textile).advancing * 180.0 / pi;
    b.drops = falling_drops(experiment).size();
    const Liquid& liquid = *find_liquid(design, experiment.liquid);
    b.liquid = liquid_at(
        {newton_per_metre_from_mn_m(liquid.surface_tension_mn_m), pascal_second_from_mpa_s(liquid.viscosity_mpa_s), liquid.density_kg_m3},
        kelvin_from_celsius(experiment.climate.temperature_c));
    const Climate air = hardest_climate(experiment);
    YarnBounds yarns(b, experiment, air);
    yarns.look_at(textile);

    const auto [width, height] = sample_extent_mm(experiment);
    const double sample = metre_from_mm(width) * metre_from_mm(height);
    const bool spot = wets_a_spot(experiment.type);
    b.delivered = delivered_water(experiment, {sample, yarns.everything, b.liquid.density});
    b.wet_area = spot && b.capacity > 0 ? std::min(sample, b.delivered / (least_mobile_saturation * b.capacity)) : sample;
    b.sorbable = spot ? std::min(yarns.sorbable * sample, yarns.thirst * b.delivered) : yarns.sorbable * sample;
    b.at_stake = std::max(b.delivered, info_of(experiment.type).source == WaterSource::air ? b.sorbable : 0.0);
    bound_drying(b, experiment, air, sample);
    return b;
}

} // namespace hygroloom
