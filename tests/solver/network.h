// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A network of yarns without a scene, for tests of its stages.
#pragma once

#include "core/solver/steps/supply.h"

#include <vector>

namespace hygroloom {

/// Arrays behind the views, one line of segments in each system unless said.
struct Network {
    int ends, picks, shells;
    std::vector<double> length, liquid, vapour, warmth, regain, evaporated, released, lost, work0, work1, work2, flux, pores, uptake,
        supplied, bound;
    std::vector<std::uint8_t> warp_up, type, fed;
    std::vector<YarnParameters> yarns;
    CrossingParameters crossing;
    std::vector<std::int64_t> absorbed;
    std::vector<int> contact;

    Network(int ends_, int picks_, const YarnParameters& warp, const YarnParameters& weft, int shells_ = 4)
        : ends(ends_), picks(picks_), shells(shells_), yarns{warp, weft}
    {
        type.assign(static_cast<std::size_t>(ends), 0);
        type.resize(static_cast<std::size_t>(ends + picks), 1);
        const auto n = static_cast<std::size_t>(2 * ends * picks);
        for (auto* v :
             {&liquid, &vapour, &warmth, &evaporated, &released, &lost, &work0, &work1, &work2, &flux, &uptake, &supplied, &bound})
            v->assign(n, 0.0);
        length.assign(n, 3e-4);
        pores.assign(n / 2, warp.pore_area * 3e-4);
        pores.resize(n, weft.pore_area * 3e-4);
        regain.assign(n * static_cast<std::size_t>(shells), 0.0);
        warp_up.assign(n / 2, 1);
        absorbed.assign(n, 0);
        contact.assign(n, no_particle);
    }
    Segments views()
    {
        Segments s;
        s.ends = ends;
        s.picks = picks;
        s.type = type.data();
        s.parameters = yarns.data();
        s.crossing = &crossing;
        s.shells = shells;
        s.length = length.data();
        s.warp_up = warp_up.data();
        s.fed = fed.empty() ? nullptr : fed.data();
        s.pores = pores.data();
        s.uptake = uptake.data();
        s.supplied = supplied.data();
        s.liquid = liquid.data();
        s.vapour = vapour.data();
        s.warmth = warmth.data();
        s.regain = regain.data();
        s.bound = bound.data();
        s.absorbed = absorbed.data();
        s.contact = contact.data();
        s.evaporated = evaporated.data();
        s.released = released.data();
        s.lost = lost.data();
        s.work0 = work0.data();
        s.work1 = work1.data();
        s.work2 = work2.data();
        s.flux = flux.data();
        for (int i = 0; i < s.visited_segments(); ++i) SumShells{s}(i);
        return s;
    }
};

inline YarnParameters cotton()
{
    YarnParameters y;
    y.pore_area = 1.6e-8;
    y.fibre_area = 1.6e-8;
    y.fibre_radius = 8e-6;
    y.fibre_density = 1550;
    y.fibre_specific_heat = 1250;
    y.fibre_conductivity = 0.35;
    y.isotherm = {0.071, 0.24, 0.03331, 10.48, 0.8627};
    y.diffusivity = {DiffusionLaw::constant, 5e-14};
    y.liquid_diffusivity = 2e-5;
    y.exponent = 2;
    y.vapour_diffusivity = 2e-5;
    y.suction_radius = 1e-5;
    return y;
}

inline ClimateParameters room()
{
    ClimateParameters c;
    c.temperature = 298.15;
    c.humidity = 0.65;
    c.vapour = 0.65 * saturation_concentration(c.temperature);
    c.heat_transfer = 9;
    c.mass_transfer = 3.2e-3;
    c.surface_tension = 0.072;
    c.viscosity = 0.9e-3;
    c.density = 997;
    return c;
}

} // namespace hygroloom
