// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What passes between crossing yarns, and between a yarn, its fibres and the air: implicit solves local to a crossing or a segment.
#pragma once

#include "core/solver/steps/yarn_lines.h"

namespace hygroloom::inline HL_PRECISION {

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
        const YarnParameters& warp = s.parameters[s.type_of_end(end)];
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
        side.capacity = heat_capacity(yarn, s.length[i], side.liquid + s.bound[i]);
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
        const double exponent = warp.exponent, integral = conductance * plain_inverse(exponent + 1.0); // see spreading_potential()

        double low = -(liquid_b < cap_a - liquid_a ? liquid_b : cap_a - liquid_a);
        double high = liquid_a < cap_b - liquid_b ? liquid_a : cap_b - liquid_b;
        if (low > 0) low = 0;
        if (high < 0) high = 0;
        double x = 0;
        for (int round = 0; round < 60; ++round) {
            const double sa = (liquid_a - x) * scale_a, sb = (liquid_b + x) * scale_b;
            const double power_a = saturation_power(sa, exponent), power_b = saturation_power(sb, exponent);
            const double residual = x - integral * (sa * power_a - sb * power_b);
            if (residual > 0)
                high = x;
            else
                low = x;
            const double slope = 1.0 + conductance * (power_a * scale_a + power_b * scale_b);
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

/// Where a balance that rises with a trial closes: between low, where it is less than nothing, and high. Illinois' rule; where three trials
/// have not halved what lies between, as on balances that are nearly steps, the next one does.
struct Bracket {
    double low, high, at_low, at_high;
    double wide = high - low; ///< at the last of every four trials
    int side = 0, trials = 0;

    HL_FN double next()
    {
        if (++trials % 4 == 0) {
            const bool slow = high - low > 0.5 * wide;
            wide = slow ? 0.5 * (high - low) : high - low;
            if (slow) return 0.5 * (low + high);
        }
        const double trial = (low * at_high - high * at_low) / (at_high - at_low);
        return trial > low && trial < high ? trial : 0.5 * (low + high);
    }
    HL_FN void narrow(double trial, double balance)
    {
        const int now = balance > 0 ? 1 : -1;
        if (now > 0) {
            high = trial;
            at_high = balance;
            if (side == now) at_low *= 0.5;
        } else {
            low = trial;
            at_low = balance;
            if (side == now) at_high *= 0.5;
        }
        side = now;
    }
};

/// A segment's fibres, pores and face, solved together: sorption into the fibre on annuli, evaporation or condensation in the
/// pores, vapour and heat to the air. Unknowns are the pore vapour and the temperature; both balances rise monotonically, so a
/// bracketed search always ends.
struct ExchangeInSegment {
    Segments s;
    ClimateParameters climate;
    double face_area; ///< m2 of fabric face that a segment answers for
    double dt;
    bool sorption;
    bool vapour;
    bool heat;

    /// What one trial of temperature and pore vapour leads to.
    struct Outcome {
        double pore_vapour = 0, evaporated = 0, bound = 0, from_liquid = 0, to_air = 0;
        double skin = 0, skin_slope = 0; ///< regain of the fibre's skin, and how it rises with its reference humidity
        ReferenceHumidity reference;     ///< that the skin is in equilibrium with
        double heat = 0;                 ///< J per kg of what fibres take from liquid, see sorbing()
    };
    /// The fibre's answer to this step: bound water at the end = base + slope x equilibrium regain at its skin.
    struct Fibre {
        double dry_mass, bound, base, slope;
        double per_mass; ///< 1 / dry_mass
        RegainLaw law;
    };
    /// Shells at the step's end, from the skin inwards: each is known + follows x the regain of the next one outwards, which over the
    /// last one is the skin's.
    struct ShellRows {
        double known[largest_shell_count], follows[largest_shell_count];
    };
    /// What a segment brings to all trials.
    struct Start {
        const YarnParameters& yarn;
        Fibre fibre;
        double liquid, vapour, warmth; ///< kg, kg, K
        double air;                    ///< m3 in the pores
        double wet;                    ///< share of the pores
        double room;                   ///< kg, for more liquid
        double capacity;               ///< J/K
        double condensing;             ///< m3 of pore vapour that all the fibres' surface brings to saturation in the step
        double evaporating;            ///< m3, the same of the surface's wet share
        double to_air;                 ///< m3, through the face
        double to_air_heat;            ///< J/K
    };
    /// What a trial's temperature brings.
    struct Warm {
        double warmth, temperature, shift; ///< see isotherm_shift()
        Saturation saturated;
        double per_saturation; ///< m3/kg
    };

    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        const YarnParameters& yarn = s.yarn_of(i);
        const double air = pore_air(s.pores[i], s.liquid[i], climate.density);
        if (at_rest(i, yarn, air)) return;
        if (!vapour && s.liquid[i] <= 0) return; // a fibre without liquid or vapour keeps what it has

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

    HL_FN Start start_of(int i, const YarnParameters& yarn, double air, ShellRows& rows) const
    {
        const Fibre fibre = prepare_fibre(i, yarn, rows);
        const double full = climate.density * s.pores[i], wet = s.liquid[i] * plain_inverse(full);
        const double condensing = s.pores[i] * phase_change_rate(yarn.fibre_area, yarn.fibre_radius, yarn.pore_area) * dt;
        return {yarn,
                fibre,
                s.liquid[i],
                s.vapour[i],
                s.warmth[i],
                air,
                wet,
                full - s.liquid[i],
                heat_capacity(yarn, s.length[i], s.liquid[i] + fibre.bound),
                condensing,
                condensing * wet_share(wet),
                dt * climate.mass_transfer * face_area,
                dt * climate.heat_transfer * face_area};
    }
    HL_FN Warm at_warmth(double warmth) const
    {
        const double temperature = climate.temperature + warmth;
        const Saturation saturated = saturation_at(temperature);
        return {warmth, temperature, isotherm_shift(temperature), saturated, plain_inverse(saturated.concentration)};
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
        if (climate.humidity > 1) return false; // what its air cannot hold condenses
        const double off = s.vapour[i] - climate.vapour * air, little = 1e-8 * (climate.vapour + 1e-6) * air;
        const double warmer = s.warmth[i] - climate.air_warmth;
        const double skin = s.regain[i * s.shells + s.shells - 1] - yarn.resting_regain;
        return s.liquid[i] <= 0 && s.vapour[i] >= 0 && warmer < 1e-7 && warmer > -1e-7 && off < little && off > -little && skin < 1e-9 &&
               skin > -1e-9;
    }

    /// Implicit Euler on shells (see ShellWalk) with the skin held at a regain, eliminated from the middle outwards.
    HL_FN Fibre prepare_fibre(int i, const YarnParameters& yarn, ShellRows& rows) const
    {
        const int n = s.shells;
        const double* regain = s.regain + i * n;
        const double dry_mass = s.length[i] * yarn.fibre_area * yarn.fibre_density;
        Fibre fibre{dry_mass, s.bound[i], 0, 0, plain_inverse(dry_mass), regain_law(yarn.isotherm)};
        if (!sorption) {
            fibre.base = s.bound[i];
            return fibre;
        }
        const double temperature = climate.temperature + s.warmth[i];
        const double scale = dt * plain_inverse(yarn.fibre_radius * yarn.fibre_radius);
        const bool constant = yarn.diffusivity.law == DiffusionLaw::constant;
        const double everywhere = constant ? fibre_diffusivity(yarn.diffusivity, 0.0, temperature) : 0.0;
        ShellWalk walk = from_the_middle(n);
        double base = 0, slope = 0; // base + slope x the shell's regain: what it and those within hold at the end
        double inner = 0, known = 0, follows = 0;
        double here = regain[0];
        for (int k = 0; k < n; ++k) {
            const bool skin = k == n - 1;
            const double next = skin ? here : regain[k + 1];
            const double diffusivity = constant ? everywhere : fibre_diffusivity(yarn.diffusivity, 0.5 * (here + next), temperature);
            const double share = walk.outwards();
            // Conductance of the outer face: 2 x its radius over the distance of the shells' middles, or of the last one's from the skin.
            const double outer = scale * diffusivity * (skin ? 4.0 * n * n : (1.0 - walk.square) * plain_inverse(walk.width * walk.left));
            const double pivot = plain_inverse(share + inner - inner * follows + outer);
            base += slope * known; // of the shell before
            slope = share + slope * follows;
            known = (share * here + inner * known) * pivot;
            follows = outer * pivot;
            rows.known[k] = known;
            rows.follows[k] = follows;
            inner = outer;
            here = next;
        }
        fibre.base = (base + slope * known) * dry_mass;
        fibre.slope = slope * follows * dry_mass;
        return fibre;
    }

    /// Humidity that the fibre's skin sees: its wet share sees liquid, the rest the pore's vapour.
    HL_FN static double skin_humidity(const Start& start, const Warm& now, double pore_vapour)
    {
        return start.wet + (1.0 - start.wet) * fmin_(1.0, pore_vapour * now.per_saturation);
    }
    HL_FN static double fmin_(double a, double b) { return a < b ? a : b; }
    HL_FN static double fmax_(double a, double b) { return a > b ? a : b; }

    /// Everything that follows from a trial pore vapour (kg/m3) at a temperature; near: the rise of the reference humidity of a trial like
    /// it, or 0.
    HL_FN Outcome try_vapour(const Start& start, const Warm& now, double pore_vapour, double near) const
    {
        const Fibre& fibre = start.fibre;
        Outcome o;
        o.pore_vapour = pore_vapour;
        o.bound = fibre.base;
        if (sorption) {
            const Isotherm& isotherm = start.yarn.isotherm;
            o.reference.humidity = skin_humidity(start, now, pore_vapour);
            if (isotherm.shifts) o.reference = reference_humidity(o.reference.humidity, now.shift, near);
            const WithSlope skin = regain_at_reference(fibre.law, isotherm.saturation_regain, o.reference.humidity);
            o.skin = skin.value;
            o.skin_slope = skin.slope;
            o.bound = fibre.base + fibre.slope * o.skin;
        }
        if (vapour) {
            const double excess = now.saturated.concentration - pore_vapour;
            o.evaporated = (excess > 0 ? start.evaporating : start.condensing) * excess;
            o.to_air = start.to_air * (pore_vapour - climate.vapour);
        }
        limit(start, o);
        return o;
    }
    /// Fibres take the wet share of what they take from liquid; liquid gives what there is, and takes what there is room for.
    HL_FN void limit(const Start& start, Outcome& o) const
    {
        const double taken = o.bound - start.fibre.bound;
        o.from_liquid = fmax_(fmin_(vapour ? start.wet * taken : taken, start.liquid), -start.room);
        if (vapour) o.evaporated = fmax_(fmin_(o.evaporated, start.liquid - o.from_liquid), -start.room - o.from_liquid);
    }

    /// How the regain of the fibres' skin at the step's end answers to more pore vapour (m3/kg) and to warmth (1/K).
    struct Response {
        double to_vapour = 0, to_warmth = 0;
    };
    HL_FN Response skin_response(const Start& start, const Warm& now, const Outcome& o) const
    {
        // d ln humidity = d ln reference x stiffness + heat of sorption x d shift
        const double shift = start.yarn.isotherm.shifts ? now.shift : 0.0;
        const double loose = near_inverse(1.0 + o.reference.humidity * o.reference.held.slope * shift);
        const bool open = o.pore_vapour < now.saturated.concentration;
        const double to_humidity = open ? o.skin_slope * o.reference.ratio * loose * (1.0 - start.wet) : 0.0;
        const double to_vapour = to_humidity * now.per_saturation;
        Response response{to_vapour, -to_vapour * o.pore_vapour * now.per_saturation * now.saturated.slope};
        if (start.yarn.isotherm.shifts) {
            const double shift_slope = (water_molar_mass / gas_constant) * near_inverse(now.temperature * now.temperature);
            response.to_warmth -= o.skin_slope * o.reference.humidity * loose * o.reference.held.heat * shift_slope;
        }
        return response;
    }

    HL_FN double missing(const Start& start, const Outcome& o) const
    {
        return start.air * o.pore_vapour - start.vapour - o.evaporated + o.to_air + (o.bound - start.fibre.bound - o.from_liquid);
    }

    HL_FN Outcome pore_balance(const Start& start, const Warm& now) const
    {
        const double air = start.air, met = start.vapour * plain_inverse(air);
        if (!vapour) return try_vapour(start, now, met, 0.0);
        // Rising in the trial: more vapour means less evaporation, more sorption, more loss.
        const double most = fmax_(now.saturated.concentration, fmax_(climate.vapour, met)) * 1.0001;
        Bracket bracket{0, most, missing(start, try_vapour(start, now, 0.0, 0.0)), 0};
        if (bracket.at_low >= 0) return try_vapour(start, now, 0.0, 0.0);
        Outcome o = try_vapour(start, now, most, 0.0);
        bracket.at_high = missing(start, o);
        while (bracket.at_high < 0 && bracket.high < 1e3) { // a drying fibre may push its pore over saturation
            bracket.high *= 2;
            o = try_vapour(start, now, bracket.high, 0.0);
            bracket.at_high = missing(start, o);
        }
        for (int round = 0; round < 256 && bracket.high - bracket.low > 1e-14 * bracket.high; ++round) {
            const double trial = bracket.next();
            o = try_vapour(start, now, trial, o.reference.rise);
            const double m = missing(start, o);
            if (m > -1e-9 * air * bracket.high && m < 1e-9 * air * bracket.high) break;
            bracket.narrow(trial, m);
        }
        return o;
    }

    /// Heat that fibres give off for a kg that they take from liquid, at their own humidity half-way through the step, J/kg; its slope with
    /// the water that they hold at the end, J/kg2.
    HL_FN WithSlope sorbing(const Start& start, double bound) const
    {
        const double middle = 0.5 * start.fibre.per_mass;
        const WithSlope humidity = humidity_at_reference(start.fibre.law, middle * (start.fibre.bound + bound));
        const SorptionHeat held = sorption_heat_at(humidity.value);
        return {start.yarn.sorption_heat_scale * held.heat, start.yarn.sorption_heat_scale * held.slope * humidity.slope * middle};
    }

    /// Heat released by the outcome, J.
    HL_FN double phase_heat(const Start& start, const Outcome& o, double temperature) const
    {
        const double taken = o.bound - start.fibre.bound;
        return taken * o.heat + heat_of_evaporation(temperature) * (taken - o.from_liquid - o.evaporated);
    }
    HL_FN double surplus(const Start& start, const Outcome& o, const Warm& now) const
    {
        return start.capacity * (now.warmth - start.warmth) + start.to_air_heat * (now.warmth - climate.air_warmth) -
               phase_heat(start, o, now.temperature);
    }
    /// Heat that is left over where the pores are balanced at a warmth, J.
    HL_FN double surplus_at(const Start& start, double warmth) const
    {
        const Warm now = at_warmth(warmth);
        Outcome o = pore_balance(start, now);
        o.heat = sorbing(start, o.bound).value;
        return surplus(start, o, now);
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

    /// Pore vapour and warmth together by Newton's rounds, from the vapour that was foreseen; false when they do not close in, which kinks
    /// can cause, and the bracketed searches are to do it. Ends where 1e-8 of the pore's vapour at saturation and 1e-8 K are left open, or
    /// with a round that leaves less than some 1e-5 of saturation: as rounds on one side of all kinks go on as the square of the last one.
    HL_FN bool newton(const Start& start, int i, Warm& now, Outcome& o) const
    {
        double pore = first_vapour(start, i, now.saturated.concentration);
        double near = 0, before = 0;
        int side_before = -1;
        for (int round = 0; round < 12; ++round) {
            const auto [saturated, saturated_slope] = now.saturated;
            o = try_vapour(start, now, pore, near);
            near = o.reference.rise;
            const WithSlope heat_taken = heat && sorption ? sorbing(start, o.bound) : WithSlope{0, 0};
            o.heat = heat_taken.value;
            const double mass = missing(start, o);
            const double joules = heat ? surplus(start, o, now) : 0.0;
            const double little = saturated * (1e-8 * start.air + 1e-13 * start.condensing);
            if (mass > -little && mass < little && joules > -1e-8 * start.capacity && joules < 1e-8 * start.capacity) return true;

            const Response skin = sorption ? skin_response(start, now, o) : Response{};
            const double bound_p = start.fibre.slope * skin.to_vapour, bound_t = start.fibre.slope * skin.to_warmth;
            const bool drinks = o.from_liquid < start.liquid && o.from_liquid > -start.room;
            const double liquid_p = drinks ? start.wet * bound_p : 0.0, liquid_t = drinks ? start.wet * bound_t : 0.0;
            const bool dries = o.evaporated < start.liquid - o.from_liquid && o.evaporated > -start.room - o.from_liquid;
            const double share = saturated > pore ? start.evaporating : start.condensing;
            const double vapour_p = dries ? -share : -liquid_p, vapour_t = dries ? share * saturated_slope : -liquid_t;

            const double mass_p = start.air - vapour_p + start.to_air + bound_p - liquid_p;
            double step_p = 0, step_t = 0;
            if (heat) {
                const double latent = heat_of_evaporation(now.temperature), taken = o.bound - start.fibre.bound;
                const double given = o.heat + taken * heat_taken.slope;
                const double mass_t = -vapour_t + bound_t - liquid_t;
                const double joules_p = -given * bound_p - latent * (bound_p - liquid_p - vapour_p);
                const double joules_t = start.capacity + start.to_air_heat - given * bound_t - latent * (bound_t - liquid_t - vapour_t) +
                                        2361.0 * (taken - o.from_liquid - o.evaporated); // the latent heat falls with temperature
                const double determinant = mass_p * joules_t - mass_t * joules_p;
                if (!(determinant > 0)) return false;
                const double scale = near_inverse(determinant);
                step_p = (mass * joules_t - mass_t * joules) * scale;
                step_t = (mass_p * joules - mass * joules_p) * scale;
            } else {
                step_p = mass * near_inverse(mass_p);
            }
            const double size = (std::abs(step_p) + saturated_slope * std::abs(step_t)) * now.per_saturation;
            const int side = (dries ? 1 : 0) + (drinks ? 2 : 0) + (saturated > pore ? 4 : 0); // of the kinks
            const bool stays = side == side_before && (saturated - saturated_slope * step_t > pore - step_p) == (saturated > pore);
            if (stays && size * size < 1e-6 * fmin_(before, 1.0)) {
                const double skin_step = skin.to_vapour * step_p + skin.to_warmth * step_t;
                const double bound_step = start.fibre.slope * skin_step;
                o.pore_vapour = fmax_(0.0, pore - step_p);
                o.skin = fmax_(0.0, fmin_(o.skin - skin_step, start.yarn.isotherm.saturation_regain));
                if (sorption) o.bound = start.fibre.base + start.fibre.slope * o.skin;
                o.heat -= heat_taken.slope * bound_step;
                o.evaporated -= vapour_p * step_p + vapour_t * step_t;
                o.to_air = start.to_air * (o.pore_vapour - climate.vapour);
                limit(start, o);
                now.warmth -= step_t;
                now.temperature -= step_t;
                now.saturated.concentration -= saturated_slope * step_t;
                return true;
            }
            before = size;
            side_before = side;
            const double most = 5.0 * near_inverse(fmax_(5.0, std::abs(step_t)));
            pore = pore - most * step_p > 0 ? pore - most * step_p : 0.1 * pore;
            if (heat) {
                now = at_warmth(now.warmth - most * step_t);
                // The balance of vapour is as straight in saturation as in the pore's vapour, but saturation bends with warmth.
                const double bend = now.saturated.concentration - (saturated - most * saturated_slope * step_t);
                if (dries) pore += share * bend * near_inverse(mass_p);
            }
            // Not from where all the liquid evaporates, or all the room is filled, past where part of it does.
            const bool was_under = saturated > o.pore_vapour, is_under = now.saturated.concentration > pore;
            if (!dries && was_under != is_under) pore = half_way(start, now.saturated.concentration, was_under);
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

    /// Writes the outcome; what the search left open goes to the pore vapour, so that no water is made or lost.
    HL_FN void accept(int i, const Start& start, const ShellRows& rows, const Warm& now, const Outcome& o) const
    {
        const Fibre& fibre = start.fibre;
        const double capacity = start.capacity, temperature = now.temperature;
        Outcome final = o;
        double taken = 0;
        if (sorption) {
            // A yarn that holds neither liquid nor vapour enough gives its fibres what there is.
            const double offered = fmax_(0.0, start.liquid + (vapour ? start.vapour + fmax_(0.0, -o.to_air) : 0.0));
            const double wanted = o.bound - fibre.bound;
            const double share = wanted > offered ? offered / wanted : 1.0;
            ShellWalk walk = from_the_skin(s.shells);
            double outer = o.skin, held = 0;
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
            if (share < 1.0) final.heat = sorbing(start, fibre.bound + taken).value;
        }
        double from_liquid = fmin_(o.from_liquid, start.liquid);
        double evaporated = vapour ? fmin_(o.evaporated, start.liquid - from_liquid) : 0.0;
        double pore = start.vapour + evaporated - o.to_air - (taken - from_liquid);
        if (pore < 0) {                          // rounding, or a fibre that drank the pore dry: the liquid makes up for it
            constexpr double most_cooling = 3.0; // K
            const double bearable = heat ? capacity * most_cooling / heat_of_evaporation(temperature) : -pore;
            const double made_up = fmin_(fmin_(-pore, bearable), start.liquid - from_liquid - evaporated);
            evaporated += made_up;
            pore += made_up;
        }
        double to_air = o.to_air + (pore < 0 ? pore : 0.0); // the air gives the rest
        if (pore < 0) pore = 0;
        final.bound = fibre.bound + taken;
        final.from_liquid = from_liquid;
        final.evaporated = evaporated;
        double released = heat ? phase_heat(start, final, temperature) : 0.0;
        const double lost = heat ? start.to_air_heat * (now.warmth - climate.air_warmth) : 0.0;
        const double per_capacity = plain_inverse(capacity);
        double reached = start.warmth + (released - lost) * per_capacity;
        // What the air that is left cannot hold condenses, or leaves where there is no room for it.
        const double left = start.liquid - from_liquid - evaporated;
        const double saturated = saturated_near(now, reached);
        if (vapour && pore > saturated * pore_air(s.pores[i], left, climate.density)) {
            const double latent = heat ? heat_of_evaporation(temperature) : 0.0, rise = now.saturated.slope * latent * per_capacity;
            const double condensed = condensing_at_once(i, pore, left, saturated, rise);
            const double holds =
                fmin_(pore - condensed, (saturated + rise * condensed) * pore_air(s.pores[i], left + condensed, climate.density));
            evaporated -= condensed;
            to_air += pore - condensed - holds;
            pore = holds;
            if (heat) {
                released += latent * condensed;
                reached += latent * condensed * per_capacity;
            }
        }
        s.liquid[i] = fmax_(0.0, start.liquid - from_liquid - evaporated);
        s.vapour[i] = pore;
        s.evaporated[i] += to_air;
        if (!heat) return;
        const double water_change = taken - from_liquid - evaporated; // of liquid and bound water together
        s.released[i] += released;
        s.lost[i] += lost - water_specific_heat * water_change * reached;
        s.warmth[i] = reached;
    }
};

/// Liquid that particles gave since the last step joins the yarn, at the climate's temperature.
struct TakeAbsorbed {
    Segments s;

    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        if (s.absorbed[i] == 0) return;
        const YarnParameters& yarn = s.yarn_of(i);
        const double added = static_cast<double>(s.absorbed[i]) * water_quantum;
        const double capacity = heat_capacity(yarn, s.length[i], s.liquid[i] + s.bound[i]);
        s.warmth[i] *= capacity / (capacity + water_specific_heat * added);
        s.liquid[i] += added;
        s.absorbed[i] = 0;
    }
};

/// What heat each segment stores, for those who sum up.
struct TakeStock {
    Segments s;
    double* stored; ///< J over the climate's temperature
    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        stored[i] = heat_capacity(s.yarn_of(i), s.length[i], s.liquid[i] + s.bound[i]) * s.warmth[i];
    }
};

/// Sums up what the shells of each segment's fibres hold.
struct SumShells {
    Segments s;
    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        s.bound[i] = bound_water(s, s.yarn_of(i), i);
    }
};

} // namespace hygroloom::inline HL_PRECISION
