// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Liquid by suctions: an implicit Euler step along the yarns of one system, with the room beside each and the yarns that it crosses.
#pragma once

#include "core/solver/steps/pore_rounds.h"

namespace hygroloom {

/// Along all ends or all picks. Leaves in flux what passed each joint, in the yarn and beside it. The liquid between yarns has the
/// temperature of the line's own segment: see Segments::room_with_warp.
struct FlowAlongLines : PoreRounds {
    template <typename Team> HL_FN void operator()(const Team& team, int index) const
    {
        if (!s.whole()) {
            const int chain = of_warp ? index : s.panels.warp_chains + index;
            flow(chain_of(team, chain > 0 ? s.panels.chain_ends[chain - 1] : 0, s.panels.chain_ends[chain]));
            return;
        }
        const YarnLine at = s.visited_line(of_warp ? index : s.visited_warps() + index);
        const int number = s.line_of(at.first);
        flow(line_of(team, at.first, at.last, of_warp ? number : number - s.ends,
                     of_warp ? number * s.picks : s.weft_of(0, number - s.ends)));
    }
    template <typename Team> HL_FN void flow(const Line<Team>& line) const
    {
        const int a = line.first, b = line.last;
        const bool wet = line.team.any_of(a, b, [&](int i) { return is_wet(line, i); });
        if (wet) {
            line.team.each(a, b, [&](int i) { look_at(line, i); });
            if (line.team.each_saying(a, b, [&](int i) { return couple(line, i); }) && solve(line)) {
                accept(line);
                return;
            }
        }
        line.team.each(a, b, [&](int i) {
            s.flux[segment_at(i)] = 0;
            if (wet && settles) stay(line, i);
        });
    }

    /// Masses move by the solution's fluxes; at the end of a step each class notes the suction at which it settles.
    template <typename Team> HL_FN void accept(const Line<Team>& line) const
    {
        const int a = line.first, b = line.last;
        if (!s.whole()) line.team.each(a, b, [&](int i) { s.flux[segment_at(i)] = 0; });
        const bool overflows = line.team.each_saying(a, b, [&](int i) {
            note_flux(line, i);
            return pass(line, i);
        });
        if (!s.whole()) {
            line.team.each(a, b, [&](int i) { line(left, i) = warmth_over_seams(line, i); });
            line.team.each(a, b, [&](int i) { s.warmth[segment_at(i)] = line(left, i); });
        }
        if (overflows) carry_rounding(line);
        if (settles) line.team.each(a, b, [&](int i) { settle(line, i); });
    }
    template <typename Team> HL_FN double flux_after(const Line<Team>& line, int i) const // kg on to the next place
    {
        return place_after(line, i) != none ? flux_along(line, 0, i) + flux_along(line, 1, i) : 0.0;
    }
    /// For what goes along the yarn with the liquid: of each segment, to the next one on its yarn.
    template <typename Team> HL_FN void note_flux(const Line<Team>& line, int i) const
    {
        if (s.whole()) {
            s.flux[i] = flux_after(line, i);
            return;
        }
        if (i + 1 >= line.last || is_seam(i)) return;
        const int here = s.panels.order[i], next = s.panels.order[i + 1];
        if (next > here)
            s.flux[here] = flux_after(line, i);
        else
            s.flux[next] = -flux_after(line, i);
    }
    /// K, of a segment with the warmth that came through seams. What the liquid carries along the yarn comes later.
    template <typename Team> HL_FN double warmth_over_seams(const Line<Team>& line, int i) const
    {
        const int own = s.panels.order[i];
        const int last = place_before(line, i), next = place_after(line, i);
        const bool seam_before = last != none && is_seam(last), seam_after = next != none && is_seam(i);
        if (!seam_before && !seam_after) return s.warmth[own];
        double in = 0, from_before = 0, from_next = 0; // kg
        if (last != none) (seam_before ? from_before : in) += flux_after(line, last);
        if (next != none) (seam_after ? from_next : in) -= flux_after(line, i);
        const double now =
            heat_capacity(s.yarn_of(own), s.fibre_length(own, s.yarn_of(own)), s.warm_water(own)) - water_specific_heat * in; // J/K
        double heat = 0, came = 0;
        const auto add = [&](double mass, int from) {
            if (mass <= 0) return;
            came += water_specific_heat * mass;
            heat += water_specific_heat * mass * s.warmth[s.panels.order[from]];
        };
        add(from_before, last);
        add(from_next, next);
        return came > 0 && now > came ? ((now - came) * s.warmth[own] + heat) * plain_inverse(now) : s.warmth[own];
    }
    /// Along each piece of a yarn.
    template <typename Team> HL_FN void carry_rounding(const Line<Team>& line) const
    {
        const WickAlongYarn wick{s, climate, dt, 0, 0};
        const auto carry = [&](int first, int last) {
            wick.carry_rounding(line.team, {s.yarn_of(first), first, last, of_warp, true, true});
        };
        if (s.whole()) {
            carry(line.first, line.last);
            return;
        }
        for (int first = line.first; first < line.last;) {
            int last = first + 1;
            while (last < line.last && !is_seam(last - 1)) ++last;
            const int low = s.panels.order[first], high = s.panels.order[last - 1];
            carry(low < high ? low : high, (low < high ? high : low) + 1);
            first = last;
        }
    }
    /// Returns whether the own pores are left with more than they hold, or less than nothing.
    template <typename Team> HL_FN bool pass(const Line<Team>& line, int i) const
    {
        const double along_own = inflow_along(line, 0, i), along_room = inflow_along(line, 1, i);
        if (is_fed(i)) {
            s.supplied[i] -= along_own + along_room;
            return false;
        }
        const Place p = place(line, i);
        std::int64_t drew[3] = {};
        if (pool.stands) {
            take_from_pool(line, p, i, drew);
            shed_through_hole(line, p, i);
        }
        const double ax = from_room(line, i), ab = from_crossed(line, i), bx = from_crossed_to_room(line, i);
        double mass[3] = {liquid(p, own_pores) + along_own + ax + ab, liquid(p, room_pores) + along_room - ax + bx,
                          liquid(p, crossed_pores) - ab - bx};
        const bool overflows = keep_in_bounds(p, mass, drew);
        warm(p, liquid(p, crossed_pores) - mass[crossed_pores]);
        for (int which = 0; which < 3; ++which) liquid(p, which) = mass[which];
        return overflows;
    }
    /// What rounds have left open goes to another class of the crossing, so that neither bound nor the total is touched. Returns whether
    /// the own pores are left with what no class has room for.
    HL_FN bool keep_in_bounds(const Place& p, double (&mass)[3], const std::int64_t (&drew)[3]) const
    {
        double over = 0;
        for (int which = 0; which < 3; ++which) over += put(mass[which], 0, capacity(p, which));
        for (int which = 0; which < 3 && over != 0; ++which) over = put(mass[which], over, capacity(p, which));
        if (over > 0) over -= hand_back(p, drew, over);
        mass[own_pores] += over;
        return over != 0;
    }
    /// Adds as much of what comes as the bounds let, and takes off what lies outside them; returns the rest.
    HL_FN static double put(double& mass, double comes, double capacity)
    {
        const double wanted = mass + comes;
        mass = wanted < 0 ? 0.0 : wanted > capacity ? capacity : wanted;
        return wanted - mass;
    }
    template <typename Places> HL_FN void take_from_pool(const Places& line, const Place& p, int i, std::int64_t (&drew)[3]) const
    {
        for (int which = 0; which < 3; ++which) {
            drew[which] = static_cast<std::int64_t>(from_pool(line, which, i) / water_quantum);
            if (drew[which] == 0) continue;
            settle_with_pool(p, which, drew[which]);
            liquid(p, which) += static_cast<double>(drew[which]) * water_quantum;
        }
    }
    /// Charges the pool for quanta that it gives to a class, and the class's segment for the heat that they bring.
    HL_FN void settle_with_pool(const Place& p, int which, std::int64_t quanta) const
    {
        const double mass = static_cast<double>(quanta) * water_quantum;
        const int segment = which == crossed_pores ? p.crossed : p.own;
        if (s.warmth[segment] != 0) {
            const double heat = heat_capacity(yarn_of(p, which == crossed_pores ? crossed_pores : own_pores),
                                              s.fibre_length(segment, yarn_of(p, which == crossed_pores ? crossed_pores : own_pores)),
                                              s.warm_water(segment));
            if (quanta > 0)
                s.warmth[segment] *= heat * plain_inverse(heat + water_specific_heat * mass);
            else
                s.lost[segment] -= water_specific_heat * mass * s.warmth[segment];
        }
        s.offered[taker(p, which)] -= quanta;
        atomic_add(pool.caps == nullptr ? drawn : &pool.sums[s.cap_over[p.crossing]].drawn, quanta);
    }
    /// What no class of a full crossing can hold, where rounds have left it open, goes back to the pool as far as it came from there; kg.
    HL_FN double hand_back(const Place& p, const std::int64_t (&drew)[3], double over) const
    {
        double back = 0;
        for (int which = 0; which < 3 && back < over; ++which) {
            if (drew[which] <= 0) continue;
            const auto wanted = static_cast<std::int64_t>((over - back) / water_quantum) + 1;
            const std::int64_t quanta = wanted < drew[which] ? wanted : drew[which];
            settle_with_pool(p, which, -quanta);
            back += static_cast<double>(quanta) * water_quantum;
        }
        return back;
    }
    template <typename Places> HL_FN void shed_through_hole(const Places& line, const Place& p, int i) const
    {
        const double passes = through_hole(line, room(p), i);
        const auto quanta = static_cast<std::int64_t>(passes / water_quantum);
        if (quanta == 0) return;
        const double mass = static_cast<double>(quanta) * water_quantum;
        liquid(p, room_pores) -= mass;
        s.lost[p.own] += water_specific_heat * mass * s.warmth[p.own];
        atomic_add(shed, quanta);
    }
    /// Liquid that comes from the crossed yarn, or goes there, carries its warmth.
    HL_FN void warm(const Place& p, double came) const
    {
        if (s.warmth[p.own] == 0 && s.warmth[p.crossed] == 0) return;
        const double carried = water_specific_heat * (came > 0 ? came : -came);
        const int to = came > 0 ? p.own : p.crossed, from = came > 0 ? p.crossed : p.own;
        const double heat = heat_capacity(yarn(p, came > 0), s.fibre_length(to, yarn(p, came > 0)), s.warm_water(to));
        s.warmth[to] = (heat * s.warmth[to] + carried * s.warmth[from]) * plain_inverse(heat + carried);
    }
    template <typename Places> HL_FN void settle(const Places& line, int i) const
    {
        constexpr double most = 1e9; // Pa, by far more than any pores suck
        const Place p = place(line, i);
        if (is_fed(p.own)) return;
        for (int which = 0; which < 3; ++which) {
            const double found = line(suction + which, i);
            const double sucks = found > -most && found < most ? found : line(before + which, i);
            const double holds = liquid(p, which) * plain_inverse(capacity(p, which));
            settle_at(p, which, {holds, sucks});
        }
    }
    /// Where nothing flows, notes what the step's other stages have left.
    template <typename Places> HL_FN void stay(const Places& line, int i) const
    {
        const Place p = place(line, i);
        if (is_fed(p.own)) return;
        for (int which = 0; which < 3; ++which) {
            const HeldBefore now{line(held_before + which, i), line(before + which, i)};
            if (now.saturation != settled(p, which).saturation) settle_at(p, which, now);
        }
    }
};

} // namespace hygroloom
