// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Liquid between parallel yarns that touch: each pair of neighbours for itself; pairs after even yarns and after odd
// ones go one after the other, the other way round in the next step.
#pragma once

#include "core/solver/steps/bracket.h"
#include "core/solver/steps/pore_line.h"

namespace hygroloom::inline HL_PRECISION {

/// An implicit Euler step of each pair. Which way liquid goes, and how readily, follows from the step's start and stays, as along yarns.
struct FlowBetweenTouching {
    Segments s;
    ClimateParameters climate;
    double dt;
    bool of_odd;                         ///< pairs whose first yarn is odd
    double warp_lift = 0, weft_lift = 0; ///< Pa, by which suction rises from an end, or pick, to the next in liquid at rest

    /// One of a pair.
    struct Side {
        int segment;
        bool fed; ///< stands in a bath
        PoresFound pores;
        double gate;

        HL_FN PoreLines::End end() const
        {
            return {suction(), pores.saturation, pores.retention.threshold, pores.retention.entry, pores.capacity, gate};
        }
        HL_FN double suction() const { return fed ? 0.0 : pores.suction; }
        HL_FN double held() const { return pores.saturation * pores.capacity; } // kg
        HL_FN double room() const { return pores.capacity - held(); }
        /// With kg more.
        HL_FN double suction_with(double mass) const
        {
            const double saturation = pores.saturation + mass * plain_inverse(pores.capacity);
            return fed ? 0.0 : suction_after(pores.retention, pores.settled, saturation);
        }
    };
    HL_FN Side side(int i) const
    {
        const YarnParameters& yarn = s.yarn_of(i);
        const int face = s.face_of(s.crossing_of(i), s.is_warp(i));
        return {i, s.fed != nullptr && s.fed[i] != 0, FindPores{s, climate.density}.segment(i, yarn, face), yarn.on_face[face].gate};
    }

    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        if (!(s.touching[i] > 0)) return;
        const bool is_warp = s.is_warp(i);
        const int line = is_warp ? s.line_of(i) : s.line_of(i) - s.ends;
        const int visited = is_warp ? s.ends - s.unvisited.ends_after : s.picks - s.unvisited.picks_after;
        if ((line % 2 != 0) != of_odd || line + 1 >= visited) return;
        const int j = i + (is_warp ? s.picks : s.ends);
        if (s.liquid[i] <= 0 && s.liquid[j] <= 0) return;
        const Side here = side(i), next = side(j);
        const double lift = is_warp ? warp_lift : weft_lift, difference = next.suction() - here.suction() - lift;
        if (difference > 0)
            flow(here, next, difference, lift);
        else
            flow(next, here, -difference, -lift);
    }
    /// By a difference, Pa, which is more than nothing.
    HL_FN void flow(const Side& from, const Side& to, double difference, double lift) const
    {
        if ((from.fed && to.fed) || (!to.end().is_connected() && to.gate <= 0)) return;
        double conductance = climate.density * s.touching[from.segment < to.segment ? from.segment : to.segment] *
                             share_of_permeability(from.pores.saturation, from.pores.retention.threshold, 7);
        if (!to.end().is_connected()) conductance *= to.gate;
        bool moves = false;
        const double coupling = PoreLines::coupling(conductance, difference, from.end(), to.end(), dt, moves);
        if (moves) pass(from, to, passing(from, to, coupling, lift));
    }
    /// kg that pass; what drives them falls as they do.
    HL_FN double passing(const Side& from, const Side& to, double coupling, double lift) const
    {
        const double gives = from.fed ? to.room() : from.held(), takes = to.fed ? gives : to.room();
        const double most = gives < takes ? gives : takes;
        const auto over = [&](double mass) { return mass - coupling * (to.suction_with(mass) - from.suction_with(-mass) - lift); };
        if (!(most > 0)) return 0;
        Bracket bracket{0, most, over(0), over(most)};
        if (bracket.at_high <= 0) return most;
        for (int round = 0; round < 200 && bracket.high - bracket.low > 1e-14 * most; ++round) {
            const double trial = bracket.next();
            bracket.narrow(trial, over(trial));
        }
        return bracket.low;
    }
    /// Liquid carries the warmth of where it comes from.
    HL_FN void pass(const Side& from, const Side& to, double mass) const
    {
        const double carried = water_specific_heat * mass, warmth = from.fed ? 0.0 : s.warmth[from.segment];
        if (to.fed) {
            s.lost[from.segment] += carried * warmth;
        } else if (warmth != s.warmth[to.segment]) {
            const double heat = heat_capacity(s.yarn_of(to.segment), s.length[to.segment], s.warm_water(to.segment));
            s.warmth[to.segment] = (heat * s.warmth[to.segment] + carried * warmth) * plain_inverse(heat + carried);
        }
        settle(from, -mass);
        settle(to, mass);
    }
    HL_FN void settle(const Side& side, double gained) const
    {
        const int i = side.segment;
        if (side.fed) {
            s.supplied[i] -= gained;
            return;
        }
        const double liquid = s.liquid[i] + gained;
        s.liquid[i] = liquid > 0 ? liquid : 0.0;
    }
};

} // namespace hygroloom::inline HL_PRECISION
