// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A network of yarns without a scene, for tests of its stages.
#pragma once

#include "core/solver/particles.h"
#include "core/solver/steps/crossing_exchange.h"
#include "core/solver/steps/segment_exchange.h"
#include "core/solver/steps/segment_sums.h"
#include "core/solver/steps/supply.h"

#include <numeric>
#include <type_traits>
#include <vector>

namespace hygroloom {

template <typename T> using HostArray = std::vector<std::remove_const_t<T>>;

/// Arrays behind the views, one line of segments in each system unless said.
struct Network : SegmentFields<HostArray> {
    int ends, picks, shells;
    std::vector<std::uint8_t> type;
    std::vector<YarnParameters> yarns;
    CrossingParameters crossing;

    Network(int ends_, int picks_, const YarnParameters& warp, const YarnParameters& weft, int shells_ = 4)
        : ends(ends_), picks(picks_), shells(shells_), yarns{warp, weft}
    {
        type.assign(static_cast<std::size_t>(ends), 0);
        type.resize(static_cast<std::size_t>(ends + picks), 1);
        const auto n = static_cast<std::size_t>(2 * ends * picks);
        each(
            [&](const auto& field, auto& array) {
                using Count = SegmentCount; // liquid does not flow by suction
                if (field.count == Count::sucking_segments || field.count == Count::sucking_crossings ||
                    field.count == Count::offered_takers || field.count == Count::cap_crossings)
                    return;
                const bool per_shell = field.count == SegmentCount::shells, per_crossing = field.count == SegmentCount::crossings;
                array.assign(per_shell ? n * static_cast<std::size_t>(shells) : per_crossing ? n / 2 : n, {});
            },
            *this);
        fed.clear();
        dry_pores.clear();
        warp_up_share.clear();
        length.assign(n, 3e-4);
        pores.assign(n / 2, warp.pore_area * 3e-4);
        pores.resize(n, weft.pore_area * 3e-4);
        warp_up.assign(n / 2, 1);
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
        each([](const auto&, auto& array, auto& pointer) { pointer = array.empty() ? nullptr : array.data(); }, *this, s);
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

/// The stage on the first line, by one thread.
template <typename Stage> void along(const Stage& stage)
{
    const YarnLine line = stage.s.visited_line(0);
    std::vector<double> room(static_cast<std::size_t>(Alone::per_place<void> * (line.last - line.first)));
    stage(Alone(room.data(), line.last - line.first), 0);
}

inline double total(const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); }

} // namespace hygroloom
