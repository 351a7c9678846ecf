// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/laboratory/air_permeability.h"

#include "core/base/units.h"
#include "core/physics/laboratory.h"
#include "core/physics/wicking.h"
#include "core/room/room_tables.h"

#include <tbb/parallel_for.h>

#include <array>

namespace hygroloom {
namespace {

const YarnQuantities& quantities(const Textile& textile, YarnKind kind)
{
    return kind == YarnKind::warp ? textile.quantities.warp : textile.quantities.weft;
}
bool is_spun(const YarnQuantities& yarn)
{
    return yarn.yarn_class == YarnClass::ring || yarn.yarn_class == YarnClass::rotor || yarn.yarn_class == YarnClass::plied;
}

struct Wider {
    double usual = 0, off = 0; ///< m on either side
};
Wider wider(const Textile& textile, YarnKind kind, bool thickness_given)
{
    const double width = textile.system(kind).types[0].section.width, half_gap = 0.5 * std::max(0.0, textile.system(kind).pitch - width);
    const YarnQuantities& yarn = quantities(textile, kind);
    if (is_spun(yarn)) return {spread_of_spun * half_gap, spread_off * half_gap};
    if (yarn.yarn_class == YarnClass::monofilament) return {};
    constexpr double share_of_width = 0.15;
    return {0, 0.5 * share_of_width * (thickness_given ? 0.5 : 1.0) * width};
}

/// m of yarn in a square metre.
double length_of(const Textile& textile, YarnKind kind)
{
    return textile.system(kind).types[0].length_per_pitch[0] / textile.system(kind).pitch;
}
/// m of fibre that stands out of a metre of yarn.
double hairs_of(const Textile& textile, YarnKind kind)
{
    const Flyaway& given = textile.flyaway;
    const double length = given.hair_density_per_mm * given.hair_length_mm + 2 * given.loop_density_per_mm * given.loop_height_mm;
    if (length > 0) return length;
    const YarnQuantities& yarn = quantities(textile, kind);
    constexpr double per_root_of_tex = 1.1;
    return is_spun(yarn) ? per_root_of_tex * std::sqrt(yarn.linear_density_tex) : 0.0;
}

/// Speed times viscosity over pressure, 1/m: where both systems lie over each other their resistances add; beside, each has its own.
double through_yarns(const Textile& textile, const Widening& wider)
{
    struct System {
        double cover = 0, resistance = 0; ///< m/m2
    };
    const auto system = [&](YarnKind kind) {
        const YarnType& type = textile.system(kind).types[0];
        const double k = permeability_across(metre_from_um(type.fibre.fibre_radius_um) / type.perimeter_factor, type.packing_round_core());
        const double width = type.section.width + 2 * (kind == YarnKind::warp ? wider.warp : wider.weft);
        return System{std::min(1.0, width / textile.system(kind).pitch), k > 0 ? type.area / type.section.width / k : 1e30};
    };
    const System a = system(YarnKind::warp), b = system(YarnKind::weft);
    return a.cover * (1 - b.cover) / a.resistance + b.cover * (1 - a.cover) / b.resistance +
           a.cover * b.cover / (a.resistance + b.resistance);
}

} // namespace

double AirWays::speed(double pressure) const
{
    const double viscous = air_viscosity_20 * holes.resistance, inertial = 0.5 * air_density(kelvin_from_celsius(20)) * holes.loss;
    return (viscous > 0 ? speed_of_air(pressure, viscous, inertial) : 0.0) + yarns * pressure / air_viscosity_20;
}

double AirWays::pressure(double speed_wanted) const
{
    double low = 0, high = 1;
    while (speed(high) < speed_wanted && high < 1e12) high *= 2;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (speed(middle) < speed_wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

AirWays AirWays::in_series(int cloths) const { return {{cloths * holes.resistance, cloths * holes.loss}, yarns / cloths}; }

AirInputs air_inputs(const Textile& textile, bool thickness_given)
{
    const Wider warp = wider(textile, YarnKind::warp, thickness_given), weft = wider(textile, YarnKind::weft, thickness_given);
    AirInputs inputs;
    inputs.wider = {warp.usual, weft.usual};
    inputs.wider_off = {warp.off, weft.off};
    double hairs = 0;
    for (const YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        const double fibre = metre_from_um(textile.system(kind).types[0].fibre.fibre_radius_um);
        hairs += length_of(textile, kind) * hairs_of(textile, kind) * pi * fibre * fibre;
        inputs.hair_radius += 0.5 * fibre;
    }
    const double solid = 1e-3 * textile.quantities.areal_density_g_m2 / textile.warp.types[0].fibre.density_kg_m3 /
                         (0.5 * (textile.warp.types[0].packing + textile.weft.types[0].packing)); // m of yarns
    const double room = std::max(0.05 * textile.thickness, textile.thickness - solid);
    constexpr double in_room = 0.5, most = 0.2; // of the hairs; of the room
    inputs.hair_share = std::min(most, in_room * hairs / room);
    return inputs;
}

AirWays air_ways(const Textile& textile, const AirInputs& inputs, int voxels)
{
    const DrawnRepeat repeat = drawn_repeat(textile, voxels, inputs.wider);
    const double drag = inputs.hair_share > 0 ? 1 / permeability_of_hairs(inputs.hair_radius, inputs.hair_share) : 0.0;
    return {flow_through(repeat.layer, repeat.growth, drag), through_yarns(textile, inputs.wider)};
}

AirPermeability::AirPermeability(const Textile& textile, bool thickness_given)
{
    const AirInputs given = air_inputs(textile, thickness_given);
    const auto with = [&](double wider, double hairs) {
        AirInputs inputs = given;
        inputs.wider.warp += wider * given.wider_off.warp;
        inputs.wider.weft += wider * given.wider_off.weft;
        inputs.hair_share = std::min(0.2, hairs * given.hair_share);
        return inputs;
    };
    struct Job {
        AirWays* ways;
        AirInputs inputs;
        int voxels;
    };
    const std::array<Job, 6> jobs{{{&as_given_, given, voxels},
                                   {&coarse_, given, coarse_voxels},
                                   {&wide_, with(1, 1), coarse_voxels},
                                   {&narrow_, with(-1, 1), coarse_voxels},
                                   {&hairy_, with(0, 2), coarse_voxels},
                                   {&bare_, with(0, 0.5), coarse_voxels}}};
    tbb::parallel_for(std::size_t{0}, jobs.size(),
                      [&](std::size_t i) { *jobs[i].ways = air_ways(textile, jobs[i].inputs, jobs[i].voxels); });
}

template <typename Of> Estimate AirPermeability::estimate(const Of& of) const
{
    const double given = of(as_given_), coarse = of(coarse_);
    const auto over = [&](const AirWays& ways) { return given * of(ways) / coarse; };
    return estimate_of(given, {{coarse, given * given / coarse}, {over(narrow_), over(wide_)}, {over(bare_), over(hairy_)}});
}
Estimate AirPermeability::speed(double pressure) const
{
    return estimate([&](const AirWays& ways) { return ways.speed(pressure); });
}
Estimate AirPermeability::pressure(double speed) const
{
    return estimate([&](const AirWays& ways) { return ways.pressure(speed); });
}

} // namespace hygroloom
