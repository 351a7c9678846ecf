// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What passes between the two segments of a crossing: implicit solves local to it.
#pragma once

#include "core/solver/steps/yarn_lines.h"

namespace hygroloom {

/// Liquid and heat between the two segments of a crossing, each an implicit step of its own.
struct ExchangeAtCrossing {
    Segments s;
    ClimateParameters climate;
    double dt;
    bool move_liquid;
    bool move_heat;

    /// A segment as the step finds it.
    struct Side {
        double liquid = 0;   ///< kg
        double warmth = 0;   ///< K
        double capacity = 0; ///< J/K
    };

    HL_FN void operator()(int index) const
    {
        const auto [end, pick] = s.visited_place(index);
        const int a = s.warp_of(end, pick), b = s.weft_of(end, pick);
        const YarnParameters& warp = s.parameters[s.type_of_end(end, pick)];
        const YarnParameters& weft = s.parameters[s.type_of_pick(pick)];
        const CrossingParameters& crossing = s.crossing_at(end, pick);
        Side at_a{s.liquid[a]}, at_b{s.liquid[b]};
        const bool warm = move_heat && take_warmth(a, warp, at_a) | take_warmth(b, weft, at_b);
        double moved = 0;
        if (move_liquid && (at_a.liquid > 0 || at_b.liquid > 0)) {
            moved = wick(climate.density * s.pores[a], climate.density * s.pores[b], at_a.liquid, at_b.liquid, warp, weft,
                         crossing.liquid_conductance);
            s.liquid[a] = at_a.liquid - moved;
            s.liquid[b] = at_b.liquid + moved;
        }
        if (warm) conduct(a, b, at_a, at_b, crossing.heat_conductance, moved);
    }
    /// Returns whether there is any.
    HL_FN bool take_warmth(int i, const YarnParameters& yarn, Side& side) const
    {
        side.warmth = s.warmth[i];
        side.capacity = heat_capacity(yarn, s.fibre_length(i, yarn), s.warm_water(i));
        return side.warmth != 0;
    }

    /// How much liquid moves from a to b (less than nothing: back) so that the step's end pressures agree with what flowed. Yarns of finer
    /// or better wetted pores suck harder: saturations are compared after scaling with the pore a pressure fills (radius ~ s^(1/3)).
    HL_FN double wick(double cap_a, double cap_b, double liquid_a, double liquid_b, const YarnParameters& warp, const YarnParameters& weft,
                      double liquid_conductance) const
    {
        if (liquid_conductance <= 0) return 0;
        const double finest = warp.suction_radius < weft.suction_radius ? warp.suction_radius : weft.suction_radius;
        const double per_finest = plain_inverse(finest), ratio_a = warp.suction_radius * per_finest,
                     ratio_b = weft.suction_radius * per_finest;
        const double scale_a = ratio_a * ratio_a * ratio_a * plain_inverse(cap_a),
                     scale_b = ratio_b * ratio_b * ratio_b * plain_inverse(cap_b);
        const double conductance = dt * liquid_conductance;

        double low = -(liquid_b < cap_a - liquid_a ? liquid_b : cap_a - liquid_a);
        double high = liquid_a < cap_b - liquid_b ? liquid_a : cap_b - liquid_b;
        if (low > 0) low = 0;
        if (high < 0) high = 0;
        double x = 0;
        for (int round = 0; round < 60; ++round) {
            const double sa = (liquid_a - x) * scale_a, sb = (liquid_b + x) * scale_b;
            const double residual = x - conductance * (spreading_potential(sa) - spreading_potential(sb));
            if (residual > 0)
                high = x;
            else
                low = x;
            const double slope = 1.0 + conductance * (sa * scale_a + sb * scale_b);
            double next = x - residual * near_inverse(slope);
            const bool inside = next > low && next < high;
            if (!inside) next = 0.5 * (low + high);
            const double change = next > x ? next - x : x - next;
            x = next;
            if (change <= (inside ? 3e-6 : 1e-13) * (cap_a + cap_b)) break; // what a Newton step leaves goes with its square
        }
        return x;
    }

    HL_FN void conduct(int a, int b, const Side& at_a, const Side& at_b, double heat_conductance, double moved) const
    {
        // The liquid carries its warmth, then both sides share heat.
        const double carried = water_specific_heat * moved * (moved > 0 ? at_a.warmth : at_b.warmth);
        const double per_a = plain_inverse(at_a.capacity - water_specific_heat * moved),
                     per_b = plain_inverse(at_b.capacity + water_specific_heat * moved);
        const double heat_a = at_a.capacity * at_a.warmth - carried, heat_b = at_b.capacity * at_b.warmth + carried;
        const double conductance = dt * heat_conductance;
        const double passed = conductance * (heat_a * per_a - heat_b * per_b) * plain_inverse(1.0 + conductance * (per_a + per_b));
        s.warmth[a] = (heat_a - passed) * per_a;
        s.warmth[b] = (heat_b + passed) * per_b;
    }
};

/// The liquid between the yarns of a crossing goes over to the weft, whose temperature it has from then on, or back to the warp.
struct HandRoomOver {
    Segments s;
    bool to_weft;

    HL_FN void operator()(int index) const
    {
        const auto [end, pick] = s.visited_place(index);
        const int warp = s.warp_of(end, pick), weft = s.weft_of(end, pick), to = to_weft ? weft : warp, from = to_weft ? warp : weft;
        const double handed = water_specific_heat * s.between[warp];
        if (handed == 0 || s.warmth[to] == s.warmth[from]) return;
        const double own = heat_capacity(s.yarn_of(to), s.fibre_length(to, s.yarn_of(to)), s.liquid[to] + s.bound[to]);
        s.warmth[to] = (own * s.warmth[to] + handed * s.warmth[from]) * plain_inverse(own + handed);
    }
};

/// Vapour between the two segments of a crossing, from what DiffuseVapourAlongYarn foresaw.
struct DiffuseAtCrossing {
    Segments s;
    double dt;

    HL_FN void operator()(int index) const
    {
        const auto [end, pick] = s.visited_place(index);
        const int a = s.warp_of(end, pick), b = s.weft_of(end, pick);
        const double conductance = dt * s.crossing_at(end, pick).vapour_conductance, pivot_a = s.work1[a], pivot_b = s.work1[b];
        const double both = pivot_a * pivot_b; // x (1 + conductance (1 / pivot_a + 1 / pivot_b)) is what divides
        const double passed = conductance * (s.work2[a] - s.work2[b]) * both * plain_inverse(both + conductance * (pivot_a + pivot_b));
        s.vapour[a] -= passed; // less than nothing is what liquid, fibres and air will give
        s.vapour[b] += passed;
    }
};

} // namespace hygroloom
