// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Liquid between two classes of pores that are no neighbours along a yarn: an implicit Euler step of the pair alone. Which way liquid goes,
// and how readily, follows from the step's start and stays, as along yarns.
#pragma once

#include "core/solver/steps/bracket.h"
#include "core/solver/steps/pore_line.h"

namespace hygroloom {

struct PairFlow {
    Segments s;
    ClimateParameters climate;
    double dt;

    /// One of a pair: a segment's pores, or the room at a crossing.
    struct Side {
        int segment; ///< whose temperature its liquid has
        bool is_room;
        bool fed; ///< stands in a bath
        PoresFound pores;
        double gate, across; ///< see PoreLines::End

        HL_FN PoreLines::End end() const
        {
            return {suction(), pores.saturation, pores.retention.threshold, pores.retention.entry, pores.capacity,
                    gate,      across,           pores.retention.is_room()};
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
    /// What a pair passes.
    struct Way {
        double conductance; ///< m3/(Pa s), of full pores
        int power;          ///< of the permeability, see PoreLines::End
        double lift;        ///< Pa, by which suction rises from the first to the second in liquid at rest
        bool across = true; ///< the fibres of segments, or along them
    };

    HL_FN Side side(int i) const
    {
        const YarnParameters& yarn = s.yarn_of(i);
        const int face = s.face_of(s.crossing_of(i), s.is_warp(i));
        const bool fed = s.fed != nullptr && s.fed[i] != 0;
        return {i, false, fed, FindPores{s, climate.density}.segment(i, yarn, face), yarn.on_face[face].gate, yarn.on_face[face].across};
    }
    HL_FN Side room_side(int crossing) const
    {
        const FindPores find{s, climate.density};
        const BetweenParameters& at = s.crossing_at(crossing / s.picks, crossing % s.picks).between;
        const int condition = find.condition_of_room(crossing, at, false);
        return {crossing, true, false, find.between(crossing, at, condition), (condition & both_wet) != 0 ? 1.0 : 0.0, 1.0};
    }

    HL_FN void flow(const Side& first, const Side& second, const Way& way) const
    {
        const double difference = second.suction() - first.suction() - way.lift;
        if (difference > 0)
            flow(first, second, way, difference, way.lift);
        else
            flow(second, first, way, -difference, -way.lift);
    }

private:
    /// By a difference, Pa, which is more than nothing.
    HL_FN void flow(const Side& from, const Side& to, const Way& way, double difference, double lift) const
    {
        if (from.fed && to.fed) return;
        const double lets_in = way.across ? to.end().lets_in_across() : to.end().lets_in();
        const double conductance = climate.density * way.conductance * lets_in * from.end().permeability(way.power);
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
        const double enough = 1e-14 * most;
        for (int round = 0; round < 200 && bracket.high - bracket.low > enough; ++round) {
            const double trial = bracket.next(), open = over(trial);
            if (open <= enough && open >= -enough) return trial; // as near to the solution, since the balance rises with the mass at least
            bracket.narrow(trial, open);
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
            const double heat =
                heat_capacity(s.yarn_of(to.segment), s.fibre_length(to.segment, s.yarn_of(to.segment)), s.warm_water(to.segment));
            s.warmth[to.segment] = (heat * s.warmth[to.segment] + carried * warmth) * plain_inverse(heat + carried);
        }
        settle(from, -mass);
        settle(to, mass);
    }
    HL_FN void settle(const Side& side, double gained) const
    {
        if (side.fed) {
            s.supplied[side.segment] -= gained;
            return;
        }
        double& liquid = side.is_room ? s.between[side.segment] : s.liquid[side.segment];
        const double now = liquid + gained;
        liquid = now > 0 ? now : 0.0;
    }
};

} // namespace hygroloom
