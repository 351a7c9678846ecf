// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What passes between a yarn, its fibres and the air: implicit solves local to a segment.
#pragma once

#include "core/solver/steps/segment_balance.h"

namespace hygroloom {

/// A segment's fibres, pores and face, solved together: sorption into the fibre on annuli, evaporation or condensation in the
/// pores, vapour and heat to the air. Both balances rise monotonically, so a bracketed search always ends.
struct ExchangeInSegment : SegmentBalance {
    StandingLiquid stands{};

    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        if (s.whole()) {
            under_standing(i);
            return;
        }
        ExchangeInSegment here = *this;
        const FaceAir& over = s.air_over(i);
        here.face_area = s.cell_area(i);
        here.climate.air_warmth = over.air_warmth;
        here.climate.vapour = over.vapour;
        here.climate.heat_transfer = over.heat_transfer;
        here.climate.mass_transfer = over.mass_transfer;
        here.exchange(i);
    }
    HL_FN void under_standing(int i) const
    {
        const OverSegment there = stands.sums != nullptr ? stands.over(s, i) : OverSegment{};
        if (!(there.covered > 0)) {
            exchange(i);
            return;
        }
        ExchangeInSegment here = *this;
        here.over = there;
        here.exchange(i);
    }
    HL_FN void exchange(int i) const
    {
        const YarnParameters& yarn = s.yarn_of(i);
        const double air = pore_air(s.pores[i], s.liquid[i], climate.density);
        if (at_rest(i, yarn, air)) return;
        if (!vapour && s.liquid[i] <= 0 && came_to(i) == 0) return; // a fibre without liquid or vapour keeps what it has

        ShellRows rows;
        const Start start = start_of(i, yarn, air, rows);
        Warm now = at_warmth(start.warmth);
        Outcome outcome;
        if (!vapour || !newton(start, i, now, outcome)) {
            now = at_warmth(heat ? find_warmth(start) : start.warmth);
            outcome = pore_balance(start, now);
            outcome.heat = sorbing(start, outcome.bound).value;
        }
        accept(i, start, rows, now, outcome);
        if (vapour && sorption) s.uptake[i] = uptake(start, now, outcome);
    }

    /// With the warmth it brings, which makes fibres take less.
    HL_FN double uptake(const Start& start, const Warm& now, const Outcome& o) const
    {
        const double taken = fmax_(0.0, start.fibre.slope * skin_response(start, now, o).to_vapour);
        if (!heat) return taken;
        const double humidity = fmin_(1.0, o.pore_vapour * now.per_saturation);
        const double less_per_kelvin = taken * humidity * now.saturated.slope; // kg/K
        return taken * near_inverse(1.0 + less_per_kelvin * heat_of_evaporation(now.temperature) *
                                              near_inverse(start.capacity + start.to_air_heat));
    }

    HL_FN bool at_rest(int i, const YarnParameters& yarn, double air) const
    {
        if (climate.humidity > 1 || came_to(i) != 0 || over.covered > 0) return false; // what its air cannot hold condenses
        const double off = s.vapour[i] - climate.vapour * air, little = 1e-8 * (climate.vapour + 1e-6) * air;
        const double warmer = s.warmth[i] - climate.air_warmth;
        const double skin = s.regain[i * s.shells + s.shells - 1] - yarn.resting_regain;
        return s.liquid[i] <= 0 && s.vapour[i] >= 0 && warmer < 1e-7 && warmer > -1e-7 && off < little && off > -little && skin < 1e-9 &&
               skin > -1e-9;
    }

    /// The pore vapour at which half of the liquid evaporates, or half of the room is condensed into.
    HL_FN static double half_way(const Start& start, double saturated, bool evaporating)
    {
        if (evaporating && start.evaporating > 0) return fmax_(0.0, saturated - 0.5 * start.liquid * near_inverse(start.evaporating));
        return evaporating ? saturated : saturated + 0.5 * fmax_(0.0, start.room) * near_inverse(start.condensing);
    }
    /// Where Newton's rounds begin: at the vapour that was foreseen. But where there is liquid enough to saturate pore, fibres and air from
    /// there, not so far from saturation that more than half of it would evaporate; nor that more than half of the room would be filled.
    HL_FN double first_vapour(const Start& start, int i, double saturated) const
    {
        const double foreseen = fmax_(0.0, s.work2[i]), excess = saturated - foreseen;
        const bool lasts = start.liquid > (start.air + start.to_air + s.uptake[i]) * excess;
        if (excess > 0 ? lasts && start.evaporating * excess > 0.5 * start.liquid : -start.condensing * excess > 0.5 * start.room)
            return half_way(start, saturated, excess > 0);
        return foreseen;
    }

    /// One round's balances about a trial: what they leave open, which kinks lie between, and how the parts answer to more pore vapour
    /// (_p, m3) and to warmth (_t, kg/K).
    struct Linear {
        double mass, joules;  ///< left open: kg, J
        WithSlope heat_taken; ///< see sorbing()
        Response skin;
        bool absorbs, dries; ///< whether liquid still gives to fibres and to the pores
        double share;        ///< m3, see Start::evaporating and condensing
        double bound_p, bound_t, liquid_p, liquid_t, vapour_p, vapour_t;
        double mass_p;

        HL_FN int side(bool under) const { return (dries ? 1 : 0) + (absorbs ? 2 : 0) + (under ? 4 : 0); } ///< of the kinks
    };
    HL_FN Linear balances_at(const Start& start, const Warm& now, Outcome& o) const
    {
        Linear l;
        l.heat_taken = heat && sorption ? sorbing(start, o.bound) : WithSlope{0, 0};
        o.heat = l.heat_taken.value;
        l.mass = missing(start, o);
        l.joules = heat ? surplus(start, o, now) : 0.0;
        return l;
    }
    HL_FN void find_slopes(const Start& start, const Warm& now, double pore, const Outcome& o, Linear& l) const
    {
        const auto [saturated, saturated_slope] = now.saturated;
        l.skin = sorption ? skin_response(start, now, o) : Response{};
        l.bound_p = start.fibre.slope * l.skin.to_vapour;
        l.bound_t = start.fibre.slope * l.skin.to_warmth;
        l.absorbs = o.from_liquid < start.liquid && o.from_liquid > -start.room;
        l.liquid_p = l.absorbs ? start.wet * l.bound_p : 0.0;
        l.liquid_t = l.absorbs ? start.wet * l.bound_t : 0.0;
        l.dries = o.evaporated < start.liquid - o.from_liquid && o.evaporated > -start.room - o.from_liquid;
        l.share = saturated > pore ? start.evaporating : start.condensing;
        l.vapour_p = l.dries ? -l.share : -l.liquid_p;
        l.vapour_t = l.dries ? l.share * saturated_slope : -l.liquid_t;
        l.mass_p = start.air - l.vapour_p + start.to_air + l.bound_p - l.liquid_p;
    }
    HL_FN bool closes(const Start& start, const Warm& now, const Linear& l) const
    {
        const double little = now.saturated.concentration * (1e-8 * start.air + 1e-13 * start.condensing);
        return l.mass > -little && l.mass < little && l.joules > -1e-8 * start.capacity && l.joules < 1e-8 * start.capacity;
    }
    /// Of pore vapour (kg/m3) and warmth (K), to be taken off.
    struct NewtonStep {
        double p = 0, t = 0;
    };
    /// Returns false where the balances do not turn as they must.
    HL_FN bool newton_step(const Start& start, const Warm& now, const Outcome& o, const Linear& l, NewtonStep& step) const
    {
        if (!heat) {
            step.p = l.mass * near_inverse(l.mass_p);
            return true;
        }
        const double latent = heat_of_evaporation(now.temperature), taken = o.bound - start.fibre.bound;
        const double given = o.heat + taken * l.heat_taken.slope;
        const double mass_t = -l.vapour_t + l.bound_t - l.liquid_t;
        const WithSlope standing = standing_gives(now);
        const double joules_p = -given * l.bound_p - latent * (l.bound_p - l.liquid_p - l.vapour_p);
        const double joules_t = start.capacity + start.to_air_heat - given * l.bound_t - latent * (l.bound_t - l.liquid_t - l.vapour_t) +
                                latent * standing.slope +
                                2361.0 * (taken - o.from_liquid - o.evaporated - standing.value); // the latent heat falls with temperature
        const double determinant = l.mass_p * joules_t - mass_t * joules_p;
        if (!(determinant > 0)) return false;
        const double scale = near_inverse(determinant);
        step.p = (l.mass * joules_t - mass_t * l.joules) * scale;
        step.t = (l.mass_p * l.joules - l.mass * joules_p) * scale;
        return true;
    }
    /// The last round: along the straight lines about the trial.
    HL_FN void step_straight(const Start& start, double pore, const Linear& l, const NewtonStep& step, Warm& now, Outcome& o) const
    {
        const double skin_step = l.skin.to_vapour * step.p + l.skin.to_warmth * step.t;
        const double bound_step = start.fibre.slope * skin_step;
        o.pore_vapour = fmax_(0.0, pore - step.p);
        o.skin = fmax_(0.0, fmin_(o.skin - skin_step, start.yarn.isotherm.saturation_regain));
        if (sorption) o.bound = start.fibre.base + start.fibre.slope * o.skin;
        o.heat -= l.heat_taken.slope * bound_step;
        o.evaporated -= l.vapour_p * step.p + l.vapour_t * step.t;
        o.to_air = start.to_air * (o.pore_vapour - climate.vapour);
        limit(start, o);
        now.warmth -= step.t;
        now.temperature -= step.t;
        now.saturated.concentration -= now.saturated.slope * step.t;
    }
    /// The next trial's pore vapour, and warmth.
    HL_FN double next_trial(const Start& start, double pore, const Linear& l, const NewtonStep& step, const Outcome& o, Warm& now) const
    {
        const auto [saturated, saturated_slope] = now.saturated;
        const double most = 5.0 * near_inverse(fmax_(5.0, std::abs(step.t)));
        double next = pore - most * step.p > 0 ? pore - most * step.p : 0.1 * pore;
        if (heat) {
            now = at_warmth(now.warmth - most * step.t);
            // The balance of vapour is as straight in saturation as in the pore's vapour, but saturation bends with warmth.
            const double bend = now.saturated.concentration - (saturated - most * saturated_slope * step.t);
            if (l.dries) next += l.share * bend * near_inverse(l.mass_p);
        }
        // Not from where all the liquid evaporates, or all the room is filled, past where part of it does.
        const bool was_under = saturated > o.pore_vapour, is_under = now.saturated.concentration > next;
        if (!l.dries && was_under != is_under) next = half_way(start, now.saturated.concentration, was_under);
        return next;
    }

    /// Pore vapour and warmth together by Newton's rounds, from the vapour that was foreseen; false when they do not close in, which kinks
    /// can cause, and the bracketed searches are to do it. Ends where 1e-8 of the pore's vapour at saturation and 1e-8 K are left open, or
    /// with a round that leaves less than some 1e-5 of saturation: as rounds on one side of all kinks go on as the square of the last one.
    HL_FN bool newton(const Start& start, int i, Warm& now, Outcome& o) const
    {
        double pore = first_vapour(start, i, now.saturated.concentration);
        double near = 0, before = 0;
        int side_before = -1;
        for (int round = 0; round < 12; ++round) {
            o = try_vapour(start, now, pore, near);
            near = o.reference.rise;
            Linear l = balances_at(start, now, o);
            if (closes(start, now, l)) return true;
            find_slopes(start, now, pore, o, l);
            NewtonStep step;
            if (!newton_step(start, now, o, l, step)) return false;
            const auto [saturated, saturated_slope] = now.saturated;
            const double size = (std::abs(step.p) + saturated_slope * std::abs(step.t)) * now.per_saturation;
            const int side = l.side(saturated > pore);
            const bool stays = side == side_before && (saturated - saturated_slope * step.t > pore - step.p) == (saturated > pore);
            if (stays && size * size < 1e-6 * fmin_(before, 1.0)) {
                step_straight(start, pore, l, step, now, o);
                return true;
            }
            before = size;
            side_before = side;
            pore = next_trial(start, pore, l, step, o, now);
        }
        return false;
    }

    /// The warmth at which the heat balance closes; it rises with warmth.
    HL_FN double find_warmth(const Start& start) const
    {
        double width = 0.05;
        const double first = surplus_at(start, start.warmth);
        Bracket bracket{start.warmth, start.warmth, first, first};
        while (bracket.at_low > 0 && bracket.low > -80) {
            bracket.high = bracket.low;
            bracket.at_high = bracket.at_low;
            bracket.low -= width;
            width *= 3;
            bracket.at_low = surplus_at(start, bracket.low);
        }
        while (bracket.at_high < 0 && bracket.high < 80) {
            bracket.low = bracket.high;
            bracket.at_low = bracket.at_high;
            bracket.high += width;
            width *= 3;
            bracket.at_high = surplus_at(start, bracket.high);
        }
        double trial = bracket.low;
        for (int round = 0; round < 160 && bracket.high - bracket.low > 1e-7; ++round) {
            trial = bracket.next();
            const double m = surplus_at(start, trial);
            if (m > -1e-7 * start.capacity && m < 1e-7 * start.capacity) break;
            bracket.narrow(trial, m);
        }
        return trial;
    }

    /// Saturation at a warmth that is mostly the trial's own, kg/m3: by its slope where that is right to 1e-9.
    HL_FN double saturated_near(const Warm& now, double warmth) const
    {
        const double further = warmth - now.warmth;
        if (std::abs(further) < 5e-4) return now.saturated.concentration + further * now.saturated.slope;
        return saturation_concentration(climate.temperature + warmth);
    }

    /// How much of a pore's vapour condenses until its air is saturated, kg: less air is left by what has condensed, but never quite none
    /// (air_beside()), it is warmer by then, and no more condenses than there is room for. Saturation in kg/m3, its rise per kg that has
    /// condensed.
    HL_FN double condensing_at_once(int i, double pore, double liquid, double saturated, double rise) const
    {
        const double per_density = plain_inverse(climate.density);
        const double room = climate.density * s.pores[i] - liquid, air = room * per_density, least = air_beside(s.pores[i], s.pores[i]);
        const double over = pore - saturated * air, shrinks = 1.0 - saturated * per_density;
        const double left = fmax_(0.0, air - over * plain_inverse(shrinks) * per_density); // in the cold, a little less than is left
        const double shrinking = over * plain_inverse(shrinks + rise * left);
        const double at_last = (pore - saturated * least) * plain_inverse(1.0 + rise * least);
        return fmax_(0.0, fmin_(fmin_(shrinking, at_last), room));
    }

    /// What is left of the segment's water and heat when a step is over.
    struct Balance {
        double taken = 0;       ///< kg, by fibres
        double from_liquid = 0; ///< kg of that
        double evaporated = 0;  ///< kg
        double to_air = 0;      ///< kg
        double pore = 0;        ///< kg of vapour
        double released = 0;    ///< J
        double warmth = 0;      ///< K
    };
    /// Brings the shells to the step's end; returns what they have taken, kg. A yarn that holds neither liquid nor vapour enough gives its
    /// fibres what there is.
    HL_FN double fill_shells(int i, const Start& start, const ShellRows& rows, Outcome& o) const
    {
        const Fibre& fibre = start.fibre;
        const double offered = fmax_(0.0, start.liquid + (vapour ? start.vapour + fmax_(0.0, -o.to_air) : 0.0));
        const double wanted = o.bound - fibre.bound;
        const double share = wanted > offered ? offered / wanted : 1.0;
        ShellWalk walk = from_the_skin(s.shells);
        double outer = o.skin, held = 0, taken = 0;
        for (int k = s.shells - 1; k >= 0; --k) {
            double& regain = s.regain[i * s.shells + k];
            const double before = regain, part = walk.inwards();
            outer = rows.known[k] + rows.follows[k] * outer;
            const double now_held = before + share * (outer - before);
            regain = now_held;
            taken += part * (now_held - before);
            held += part * now_held;
        }
        taken *= fibre.dry_mass;
        s.bound[i] = held * fibre.dry_mass;
        if (share < 1.0) o.heat = sorbing(start, fibre.bound + taken).value;
        return taken;
    }
    /// What the search left open goes to the pore vapour, so that no water is made or lost. Where that is less than nothing, by rounding or
    /// since a fibre absorbed all of the pore's, the liquid makes up for it, and then the air.
    HL_FN Balance balance_of(const Start& start, const Outcome& o, double taken, double temperature) const
    {
        Balance b;
        b.taken = taken;
        b.from_liquid = fmin_(o.from_liquid, start.liquid);
        b.evaporated = vapour ? fmin_(o.evaporated, start.liquid - b.from_liquid) : 0.0;
        b.pore = start.vapour + b.evaporated - o.to_air - (taken - b.from_liquid);
        if (b.pore < 0) {
            constexpr double most_cooling = 3.0; // K
            const double bearable = heat ? start.capacity * most_cooling / heat_of_evaporation(temperature) : -b.pore;
            const double made_up = fmin_(fmin_(-b.pore, bearable), start.liquid - b.from_liquid - b.evaporated);
            b.evaporated += made_up;
            b.pore += made_up;
        }
        b.to_air = o.to_air + (b.pore < 0 ? b.pore : 0.0); // the air gives the rest
        if (b.pore < 0) b.pore = 0;
        return b;
    }
    /// What the air that is left cannot hold condenses, or leaves where there is no room for it.
    HL_FN void condense_rest(int i, const Start& start, const Warm& now, double per_capacity, Balance& b) const
    {
        const double left = start.liquid - b.from_liquid - b.evaporated;
        const double saturated = saturated_near(now, b.warmth);
        if (!vapour || !(b.pore > saturated * pore_air(s.pores[i], left, climate.density))) return;
        const double latent = heat ? heat_of_evaporation(now.temperature) : 0.0, rise = now.saturated.slope * latent * per_capacity;
        const double condensed = condensing_at_once(i, b.pore, left, saturated, rise);
        const double holds =
            fmin_(b.pore - condensed, (saturated + rise * condensed) * pore_air(s.pores[i], left + condensed, climate.density));
        b.evaporated -= condensed;
        b.to_air += b.pore - condensed - holds;
        b.pore = holds;
        if (!heat) return;
        b.released += latent * condensed;
        b.warmth += latent * condensed * per_capacity;
    }

    /// kg, in whole quanta.
    HL_FN double take_from_standing(const Warm& now) const
    {
        if (over.evaporated == nullptr) return 0;
        const auto quanta = static_cast<std::int64_t>(standing_gives(now).value / water_quantum);
        if (quanta != 0) atomic_add(over.evaporated, quanta);
        return static_cast<double>(quanta) * water_quantum;
    }

    /// Writes the outcome.
    HL_FN void accept(int i, const Start& start, const ShellRows& rows, const Warm& now, const Outcome& o) const
    {
        Outcome final = o;
        const double taken = sorption ? fill_shells(i, start, rows, final) : 0.0;
        Balance b = balance_of(start, o, taken, now.temperature);
        final.bound = start.fibre.bound + taken;
        final.from_liquid = b.from_liquid;
        final.evaporated = b.evaporated;
        const double stood = take_from_standing(now);
        b.released = heat ? phase_heat(start, final, now.temperature) - heat_of_evaporation(now.temperature) * stood : 0.0;
        const double lost = heat ? start.to_air_heat * (now.warmth - climate.air_warmth) : 0.0;
        const double per_capacity = plain_inverse(start.capacity);
        b.warmth = start.warmth + (b.released - lost + start.came) * per_capacity;
        condense_rest(i, start, now, per_capacity, b);
        s.liquid[i] = fmax_(0.0, start.liquid - b.from_liquid - b.evaporated);
        s.vapour[i] = b.pore;
        s.evaporated[i] += b.to_air;
        if (!heat) return;
        const double water_change = b.taken - b.from_liquid - b.evaporated; // of liquid and bound water together
        s.released[i] += b.released;
        s.lost[i] += lost - water_specific_heat * water_change * b.warmth;
        s.warmth[i] = b.warmth;
        if (s.came != nullptr) s.came[i] = 0;
    }
};

} // namespace hygroloom
