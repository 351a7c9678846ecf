// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What passes between crossing yarns, and between a yarn, its fibres and the air: implicit solves local to a crossing or a segment.
#pragma once

#include "core/sim/steps/yarn_lines.h"

namespace hygroloom::inline HL_PRECISION {

/// Liquid, heat and vapour between the two segments of a crossing, each an implicit step of its own.
struct ExchangeAtCrossing {
    Segments s;
    ClimateParameters climate;
    double dt;
    bool move_liquid;
    bool move_heat;
    bool move_vapour;

    HL_FN void operator()(int index) const
    {
        const auto [end, pick] = s.visited_place(index);
        const int a = s.warp_of(end, pick), b = s.weft_of(end, pick);
        const YarnParameters& warp = s.parameters[s.type_of_end(end)];
        const YarnParameters& weft = s.parameters[s.type_of_pick(pick)];
        const CrossingParameters& crossing = s.crossing_at(end, pick);
        const bool warm = move_heat && (s.warmth[a] != 0 || s.warmth[b] != 0);
        const double capacity_a = warm ? heat_capacity(warp, s.length[a], s.liquid[a] + bound_water(s, warp, a)) : 0.0;
        const double capacity_b = warm ? heat_capacity(weft, s.length[b], s.liquid[b] + bound_water(s, weft, b)) : 0.0;
        double moved = 0;
        if (move_liquid && (s.liquid[a] > 0 || s.liquid[b] > 0)) moved = wick(a, b, warp, weft, crossing.liquid_conductance);
        if (warm) conduct(a, b, capacity_a, capacity_b, crossing.heat_conductance, moved);
        if (move_vapour) diffuse(a, b, crossing.vapour_conductance);
    }

    /// Moves liquid from a to b (less than nothing: back) until the step's end pressures agree with what flowed. Yarns of finer or
    /// better wetted pores suck harder: saturations are compared after scaling with the pore a pressure fills (radius ~ s^(1/3)).
    HL_FN double wick(int a, int b, const YarnParameters& warp, const YarnParameters& weft, double liquid_conductance) const
    {
        if (liquid_conductance <= 0) return 0;
        const double cap_a = climate.density * s.pores[a];
        const double cap_b = climate.density * s.pores[b];
        const double finest = warp.suction_radius < weft.suction_radius ? warp.suction_radius : weft.suction_radius;
        const double ratio_a = warp.suction_radius / finest, ratio_b = weft.suction_radius / finest;
        const double scale_a = ratio_a * ratio_a * ratio_a / cap_a, scale_b = ratio_b * ratio_b * ratio_b / cap_b;
        const double conductance = dt * liquid_conductance;
        const double exponent = warp.exponent;

        double low = -(s.liquid[b] < cap_a - s.liquid[a] ? s.liquid[b] : cap_a - s.liquid[a]);
        double high = s.liquid[a] < cap_b - s.liquid[b] ? s.liquid[a] : cap_b - s.liquid[b];
        if (low > 0) low = 0;
        if (high < 0) high = 0;
        double x = 0;
        for (int round = 0; round < 60; ++round) {
            const double sa = (s.liquid[a] - x) * scale_a, sb = (s.liquid[b] + x) * scale_b;
            const double residual = x - conductance * (spreading_potential(sa, exponent) - spreading_potential(sb, exponent));
            if (residual > 0)
                high = x;
            else
                low = x;
            const double slope = 1.0 + conductance * (saturation_power(sa, exponent) * scale_a + saturation_power(sb, exponent) * scale_b);
            double next = x - residual / slope;
            const bool inside = next > low && next < high;
            if (!inside) next = 0.5 * (low + high);
            const double change = next > x ? next - x : x - next;
            x = next;
            if (change <= (inside ? 1e-9 : 1e-13) * (cap_a + cap_b)) break; // what a Newton step leaves goes with its square
        }
        s.liquid[a] -= x;
        s.liquid[b] += x;
        return x;
    }

    HL_FN void conduct(int a, int b, double capacity_a, double capacity_b, double heat_conductance, double moved) const
    {
        // The liquid carries its warmth, then both sides share heat.
        const double carried = water_specific_heat * moved * (moved > 0 ? s.warmth[a] : s.warmth[b]);
        const double new_a = capacity_a - water_specific_heat * moved, new_b = capacity_b + water_specific_heat * moved;
        double heat_a = capacity_a * s.warmth[a] - carried, heat_b = capacity_b * s.warmth[b] + carried;
        const double conductance = dt * heat_conductance;
        const double passed = conductance * (heat_a / new_a - heat_b / new_b) / (1.0 + conductance * (1.0 / new_a + 1.0 / new_b));
        s.warmth[a] = (heat_a - passed) / new_a;
        s.warmth[b] = (heat_b + passed) / new_b;
    }

    /// From what DiffuseVapourAlongYarn foresaw.
    HL_FN void diffuse(int a, int b, double vapour_conductance) const
    {
        const double conductance = dt * vapour_conductance;
        const double passed = conductance * (s.work2[a] - s.work2[b]) / (1.0 + conductance * (1.0 / s.work1[a] + 1.0 / s.work1[b]));
        s.vapour[a] -= passed; // less than nothing is what liquid, fibres and air will give
        s.vapour[b] += passed;
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
        double pore_vapour, evaporated, bound, from_liquid, to_air;
        double reference = 0; ///< humidity at 20 C that the fibre's skin is in equilibrium with
        double skin = 0;      ///< its regain
    };
    /// The fibre's answer to this step: bound water at the end = base + slope x equilibrium regain at its skin.
    struct Fibre {
        double dry_mass, bound, base, slope;
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
        double evaporating;            ///< m3 of pore vapour that all the fibres' surface brings to saturation in the step
        double to_air;                 ///< m3, through the face
        double to_air_heat;            ///< J/K
    };
    /// What a trial's temperature brings.
    struct Warm {
        double warmth, temperature, shift; ///< see isotherm_shift()
        Saturation saturated;
    };

    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        const YarnParameters& yarn = s.yarn_of(i);
        const double air = pore_air(s.pores[i], s.liquid[i], climate.density);
        if (at_rest(i, yarn, air)) return;
        if (!vapour && s.liquid[i] <= 0) return; // a fibre without liquid or vapour keeps what it has

        double base[largest_shell_count], response[largest_shell_count];
        const Start start = start_of(i, yarn, air, base, response);
        Warm now = at_warmth(start.warmth);
        Outcome outcome;
        if (!vapour || !newton(start, i, now, outcome)) {
            now = at_warmth(heat ? find_warmth(start) : start.warmth);
            outcome = pore_balance(start, now);
        }
        accept(i, start, base, response, now, outcome);
        if (vapour && sorption) s.uptake[i] = uptake(start, now, outcome);
    }

    HL_FN Start start_of(int i, const YarnParameters& yarn, double air, double* base, double* response) const
    {
        const Fibre fibre = prepare_fibre(i, yarn, base, response);
        const double full = climate.density * s.pores[i];
        return {yarn,
                fibre,
                s.liquid[i],
                s.vapour[i],
                s.warmth[i],
                air,
                s.liquid[i] / full,
                full - s.liquid[i],
                heat_capacity(yarn, s.length[i], s.liquid[i] + fibre.bound),
                s.pores[i] * phase_change_rate(yarn.fibre_area, yarn.fibre_radius, yarn.pore_area) * dt,
                dt * climate.mass_transfer * face_area,
                dt * climate.heat_transfer * face_area};
    }
    HL_FN Warm at_warmth(double warmth) const
    {
        const double temperature = climate.temperature + warmth;
        return {warmth, temperature, isotherm_shift(temperature), saturation_at(temperature)};
    }

    /// With the warmth it brings, which makes fibres take less.
    HL_FN double uptake(const Start& start, const Warm& now, const Outcome& o) const
    {
        const double taken = fmax_(0.0, bound_response(start, now, o).to_vapour);
        if (!heat) return taken;
        const double humidity = fmin_(1.0, o.pore_vapour / now.saturated.concentration);
        const double less_per_kelvin = taken * humidity * now.saturated.slope; // kg/K
        return taken / (1.0 + less_per_kelvin * heat_of_evaporation(now.temperature) / (start.capacity + start.to_air_heat));
    }

    HL_FN bool at_rest(int i, const YarnParameters& yarn, double air) const
    {
        const double background = climate.vapour;
        const double off = s.vapour[i] / air - background;
        const double warmer = s.warmth[i] - climate.air_warmth;
        const double skin = s.regain[i * s.shells + s.shells - 1] - yarn.resting_regain;
        return s.liquid[i] <= 0 && s.vapour[i] >= 0 && warmer < 1e-7 && warmer > -1e-7 && off < 1e-8 * (background + 1e-6) &&
               off > -1e-8 * (background + 1e-6) && skin < 1e-9 && skin > -1e-9;
    }

    /// Implicit Euler on shells (see Shells) with the skin held at a regain: two right-hand sides, one elimination.
    HL_FN Fibre prepare_fibre(int i, const YarnParameters& yarn, double* base, double* response) const
    {
        const int n = s.shells;
        const double* regain = s.regain + i * n;
        Fibre fibre{s.length[i] * yarn.fibre_area * yarn.fibre_density, 0, 0, 0};
        fibre.bound = bound_water(s, yarn, i);
        if (!sorption) {
            fibre.base = fibre.bound;
            return fibre;
        }
        const double temperature = climate.temperature + s.warmth[i];
        const double scale = dt / (yarn.fibre_radius * yarn.fibre_radius);
        const bool constant = yarn.diffusivity.law == DiffusionLaw::constant;
        const double everywhere = constant ? fibre_diffusivity(yarn.diffusivity, 0.0, temperature) : 0.0;
        const Shells shells(n);
        double upper[largest_shell_count];
        double inner = 0; // conductance of the shell's inner face
        for (int k = 0; k < n; ++k) {
            const bool skin = k == n - 1;
            const double at_face = skin ? regain[k] : 0.5 * (regain[k] + regain[k + 1]);
            const double diffusivity = constant ? everywhere : fibre_diffusivity(yarn.diffusivity, at_face, temperature);
            const double face = shells.start(k + 1), between = 0.5 * ((skin ? face : shells.start(k + 2)) - shells.start(k));
            const double outer = scale * diffusivity * 2.0 * face / between, share = shells.share(k);
            const double lower = -inner;
            const double pivot = 1.0 / (share + inner + outer - (k > 0 ? lower * upper[k - 1] : 0.0));
            upper[k] = skin ? 0.0 : -outer * pivot;
            base[k] = (share * regain[k] - (k > 0 ? lower * base[k - 1] : 0.0)) * pivot;
            response[k] = ((skin ? outer : 0.0) - (k > 0 ? lower * response[k - 1] : 0.0)) * pivot;
            inner = outer;
        }
        for (int k = n - 2; k >= 0; --k) {
            base[k] -= upper[k] * base[k + 1];
            response[k] -= upper[k] * response[k + 1];
        }
        for (int k = 0; k < n; ++k) {
            fibre.base += base[k] * shells.share(k);
            fibre.slope += response[k] * shells.share(k);
        }
        fibre.base *= fibre.dry_mass;
        fibre.slope *= fibre.dry_mass;
        return fibre;
    }

    /// Humidity that the fibre's skin sees: its wet share sees liquid, the rest the pore's vapour.
    HL_FN static double skin_humidity(double wet, double pore_vapour, double saturated)
    {
        return wet + (1.0 - wet) * fmin_(1.0, pore_vapour / saturated);
    }
    HL_FN static double fmin_(double a, double b) { return a < b ? a : b; }
    HL_FN static double fmax_(double a, double b) { return a > b ? a : b; }

    /// Everything that follows from a trial pore vapour (kg/m3) at a temperature; near: the reference humidity of a trial like it, or 0.
    HL_FN Outcome try_vapour(const Start& start, const Warm& now, double pore_vapour, double near) const
    {
        const Fibre& fibre = start.fibre;
        Outcome o{pore_vapour, 0, fibre.base, 0, 0};
        const double saturated = now.saturated.concentration;
        if (sorption) {
            const Isotherm& isotherm = start.yarn.isotherm;
            const double humidity = skin_humidity(start.wet, pore_vapour, saturated);
            o.reference = isotherm.shifts ? reference_humidity(humidity, now.shift, near) : humidity;
            o.skin = regain_at_reference(isotherm, o.reference);
            o.bound = fibre.base + fibre.slope * o.skin;
        }
        const double taken = o.bound - fibre.bound;
        o.from_liquid = fmax_(fmin_(vapour ? start.wet * taken : taken, start.liquid), -start.room);
        if (vapour) {
            const double excess = saturated - pore_vapour;
            const double share = excess > 0 ? wet_share(start.wet) : 1.0;
            o.evaporated = fmax_(fmin_(start.evaporating * share * excess, start.liquid - o.from_liquid), -start.room - o.from_liquid);
            o.to_air = start.to_air * (pore_vapour - climate.vapour);
        }
        return o;
    }

    /// How the water that fibres hold at the step's end answers to more pore vapour (m3) and to warmth (kg/K).
    struct BoundResponse {
        double to_vapour = 0, to_warmth = 0;
    };
    HL_FN BoundResponse bound_response(const Start& start, const Warm& now, const Outcome& o) const
    {
        const auto [saturated, saturated_slope] = now.saturated;
        const Isotherm& isotherm = start.yarn.isotherm;
        const double answer = start.fibre.slope * regain_slope_at_reference(isotherm, o.reference, o.skin);
        const double per_saturation = 1.0 / saturated;
        if (o.reference <= 0) return {answer * per_saturation, 0};
        const SorptionHeat held = sorption_heat_at(o.reference);
        // d ln humidity = d ln reference x stiffness + heat of sorption x d shift
        const double stiffness = 1.0 + o.reference * held.slope * (isotherm.shifts ? now.shift : 0.0);
        const double per_share = answer * o.reference / stiffness;
        const double seen = skin_humidity(start.wet, o.pore_vapour, saturated);
        const double per_vapour = o.pore_vapour < saturated ? per_share * (1.0 - start.wet) / seen * per_saturation : 0.0;
        BoundResponse response{per_vapour, -per_vapour * o.pore_vapour * per_saturation * saturated_slope};
        if (isotherm.shifts)
            response.to_warmth -= per_share * held.heat * (water_molar_mass / gas_constant) / (now.temperature * now.temperature);
        return response;
    }

    HL_FN double missing(const Start& start, const Outcome& o) const
    {
        return start.air * o.pore_vapour - start.vapour - o.evaporated + o.to_air + (o.bound - start.fibre.bound - o.from_liquid);
    }

    HL_FN Outcome pore_balance(const Start& start, const Warm& now) const
    {
        const double air = start.air, met = start.vapour / air;
        if (!vapour) return try_vapour(start, now, met, 0.0);
        // Rising in the trial: more vapour means less evaporation, more sorption, more loss.
        double low = 0, high = fmax_(now.saturated.concentration, fmax_(climate.vapour, met)) * 1.0001;
        double low_missing = missing(start, try_vapour(start, now, low, 0.0));
        Outcome o = try_vapour(start, now, high, 0.0);
        double high_missing = missing(start, o);
        while (high_missing < 0 && high < 1e3) { // a drying fibre may push its pore over saturation
            high *= 2;
            o = try_vapour(start, now, high, 0.0);
            high_missing = missing(start, o);
        }
        if (low_missing >= 0) return try_vapour(start, now, 0.0, 0.0);
        int side = 0;
        for (int round = 0; round < 80 && high - low > 1e-14 * high; ++round) { // Illinois
            double trial = (low * high_missing - high * low_missing) / (high_missing - low_missing);
            if (!(trial > low && trial < high)) trial = 0.5 * (low + high);
            o = try_vapour(start, now, trial, o.reference);
            const double m = missing(start, o);
            if (m > -1e-9 * air * high && m < 1e-9 * air * high) break;
            if (m > 0) {
                high = trial;
                high_missing = m;
                if (side == 1) low_missing *= 0.5;
                side = 1;
            } else {
                low = trial;
                low_missing = m;
                if (side == -1) high_missing *= 0.5;
                side = -1;
            }
        }
        return o;
    }

    /// The fibre's own humidity half-way through the step: what the heat of the water it took goes by.
    HL_FN static double half_way(const Start& start, const Outcome& o)
    {
        return humidity_at_reference(start.yarn.isotherm, 0.5 * (start.fibre.bound + o.bound) / start.fibre.dry_mass);
    }

    /// Heat released by the outcome, J; held: half_way().
    HL_FN double phase_heat(const Start& start, const Outcome& o, double held, double temperature) const
    {
        const double taken = o.bound - start.fibre.bound;
        return taken * start.yarn.sorption_heat_scale * heat_of_sorption(held) +
               heat_of_evaporation(temperature) * (taken - o.from_liquid - o.evaporated);
    }
    HL_FN double surplus(const Start& start, const Outcome& o, double held, const Warm& now) const
    {
        return start.capacity * (now.warmth - start.warmth) + start.to_air_heat * (now.warmth - climate.air_warmth) -
               phase_heat(start, o, held, now.temperature);
    }
    /// Heat that is left over where the pores are balanced at a warmth, J.
    HL_FN double surplus_at(const Start& start, double warmth) const
    {
        const Warm now = at_warmth(warmth);
        const Outcome o = pore_balance(start, now);
        return surplus(start, o, half_way(start, o), now);
    }

    /// Pore vapour and warmth together by Newton's rounds, from the vapour that was foreseen; false when they do not close in, which kinks
    /// can cause, and the bracketed searches are to do it. What is left open is 1e-8 of the pore's vapour at saturation, and 1e-8 K.
    HL_FN bool newton(const Start& start, int i, Warm& now, Outcome& o) const
    {
        double pore = fmax_(0.0, s.work2[i]);
        double near = 0;
        for (int round = 0; round < 12; ++round) {
            const auto [saturated, saturated_slope] = now.saturated;
            o = try_vapour(start, now, pore, near);
            near = o.reference;
            const double held = heat && sorption ? half_way(start, o) : 0.0;
            const double mass = missing(start, o);
            const double joules = heat ? surplus(start, o, held, now) : 0.0;
            const double little = saturated * (1e-8 * start.air + 1e-13 * start.evaporating);
            if (mass > -little && mass < little && joules > -1e-8 * start.capacity && joules < 1e-8 * start.capacity) return true;

            const BoundResponse bound = sorption ? bound_response(start, now, o) : BoundResponse{};
            const double bound_p = bound.to_vapour, bound_t = bound.to_warmth;
            const bool drinks = o.from_liquid < start.liquid && o.from_liquid > -start.room;
            const double liquid_p = drinks ? start.wet * bound_p : 0.0, liquid_t = drinks ? start.wet * bound_t : 0.0;
            const bool dries = o.evaporated < start.liquid - o.from_liquid && o.evaporated > -start.room - o.from_liquid;
            const double share = start.evaporating * (saturated > pore ? wet_share(start.wet) : 1.0);
            const double vapour_p = dries ? -share : -liquid_p, vapour_t = dries ? share * saturated_slope : -liquid_t;

            const double mass_p = start.air - vapour_p + start.to_air + bound_p - liquid_p;
            double step_p = 0, step_t = 0;
            if (heat) {
                const double latent = heat_of_evaporation(now.temperature), taken = o.bound - start.fibre.bound;
                const SorptionHeat sorbed = sorption_heat_at(held);
                double sorbing = sorbed.heat;
                const double rise =
                    regain_slope_at_reference(start.yarn.isotherm, held, 0.5 * (start.fibre.bound + o.bound) / start.fibre.dry_mass);
                if (rise > 0) sorbing += 0.5 * taken * sorbed.slope / (start.fibre.dry_mass * rise);
                sorbing *= start.yarn.sorption_heat_scale;
                const double mass_t = -vapour_t + bound_t - liquid_t;
                const double joules_p = -sorbing * bound_p - latent * (bound_p - liquid_p - vapour_p);
                const double joules_t = start.capacity + start.to_air_heat - sorbing * bound_t - latent * (bound_t - liquid_t - vapour_t) +
                                        2361.0 * (taken - o.from_liquid - o.evaporated); // the latent heat falls with temperature
                const double determinant = mass_p * joules_t - mass_t * joules_p;
                if (!(determinant > 0)) return false;
                const double scale = 1.0 / determinant;
                step_p = (mass * joules_t - mass_t * joules) * scale;
                step_t = (mass_p * joules - mass * joules_p) * scale;
            } else {
                step_p = mass / mass_p;
            }
            if (step_t > 5.0) step_t = 5.0;
            if (step_t < -5.0) step_t = -5.0;
            pore = pore - step_p > 0 ? pore - step_p : 0.1 * pore;
            if (heat) now = at_warmth(now.warmth - step_t);
        }
        return false;
    }

    /// The warmth at which the heat balance closes; it rises with warmth.
    HL_FN double find_warmth(const Start& start) const
    {
        double width = 0.05;
        double low = start.warmth, high = start.warmth;
        double low_surplus = surplus_at(start, low);
        double high_surplus = low_surplus;
        while (low_surplus > 0 && low > -80) {
            high = low;
            high_surplus = low_surplus;
            low -= width;
            width *= 3;
            low_surplus = surplus_at(start, low);
        }
        while (high_surplus < 0 && high < 80) {
            low = high;
            low_surplus = high_surplus;
            high += width;
            width *= 3;
            high_surplus = surplus_at(start, high);
        }
        int side = 0;
        double trial = high_surplus == low_surplus ? low : low - low_surplus * (high - low) / (high_surplus - low_surplus);
        for (int round = 0; round < 40 && high - low > 1e-7; ++round) {
            if (!(trial >= low && trial <= high)) trial = 0.5 * (low + high);
            const double m = surplus_at(start, trial);
            if (m > -1e-7 * start.capacity && m < 1e-7 * start.capacity) break;
            if (m > 0) {
                high = trial;
                high_surplus = m;
                if (side == 1) low_surplus *= 0.5;
                side = 1;
            } else {
                low = trial;
                low_surplus = m;
                if (side == -1) high_surplus *= 0.5;
                side = -1;
            }
            trial = low - low_surplus * (high - low) / (high_surplus - low_surplus);
        }
        return trial;
    }

    /// Writes the outcome; what the search left open goes to the pore vapour, so that no water is made or lost.
    HL_FN void accept(int i, const Start& start, const double* base, const double* response, const Warm& now, const Outcome& o) const
    {
        const Fibre& fibre = start.fibre;
        const double capacity = start.capacity, temperature = now.temperature;
        double taken = 0;
        if (sorption) {
            // A yarn that holds neither liquid nor vapour enough gives its fibres what there is.
            const double offered = fmax_(0.0, s.liquid[i] + (vapour ? s.vapour[i] + fmax_(0.0, -o.to_air) : 0.0));
            const double wanted = o.bound - fibre.bound;
            const double share = wanted > offered ? offered / wanted : 1.0;
            for (int k = 0; k < s.shells; ++k) {
                double& regain = s.regain[i * s.shells + k];
                regain += share * (base[k] + response[k] * o.skin - regain);
            }
            taken = bound_water(s, start.yarn, i) - fibre.bound;
        }
        double from_liquid = fmin_(o.from_liquid, s.liquid[i]);
        double evaporated = vapour ? fmin_(o.evaporated, s.liquid[i] - from_liquid) : 0.0;
        double pore = s.vapour[i] + evaporated - o.to_air - (taken - from_liquid);
        if (pore < 0) {                          // rounding, or a fibre that drank the pore dry: the liquid makes up for it
            constexpr double most_cooling = 3.0; // K
            const double bearable = heat ? capacity * most_cooling / heat_of_evaporation(temperature) : -pore;
            const double made_up = fmin_(fmin_(-pore, bearable), s.liquid[i] - from_liquid - evaporated);
            evaporated += made_up;
            pore += made_up;
        }
        double to_air = o.to_air + (pore < 0 ? pore : 0.0); // the air gives the rest
        if (pore < 0) pore = 0;
        Outcome final = o;
        final.bound = fibre.bound + taken;
        final.from_liquid = from_liquid;
        final.evaporated = evaporated;
        double released = heat ? phase_heat(start, final, half_way(start, final), temperature) : 0.0;
        const double lost = heat ? start.to_air_heat * (now.warmth - climate.air_warmth) : 0.0;
        double reached = s.warmth[i] + (released - lost) / capacity;
        // What the air that is left cannot hold condenses, or leaves where there is no room for it.
        const double left = s.liquid[i] - from_liquid - evaporated;
        const double holds = saturation_concentration(climate.temperature + reached) * pore_air(s.pores[i], left, climate.density);
        if (vapour && pore > holds) {
            const double condensed = fmax_(0.0, fmin_(pore - holds, climate.density * s.pores[i] - left));
            evaporated -= condensed;
            to_air += pore - holds - condensed;
            pore = holds;
            if (heat) {
                const double more = heat_of_evaporation(temperature) * condensed;
                released += more;
                reached += more / capacity;
            }
        }
        s.liquid[i] = fmax_(0.0, s.liquid[i] - from_liquid - evaporated);
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
        const double capacity = heat_capacity(yarn, s.length[i], s.liquid[i] + bound_water(s, yarn, i));
        s.warmth[i] *= capacity / (capacity + water_specific_heat * added);
        s.liquid[i] += added;
        s.absorbed[i] = 0;
    }
};

/// What each segment's fibres hold and what heat it stores, for those who sum up.
struct TakeStock {
    Segments s;
    double* bound;  ///< kg
    double* stored; ///< J over the climate's temperature
    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        const YarnParameters& yarn = s.yarn_of(i);
        bound[i] = bound_water(s, yarn, i);
        stored[i] = heat_capacity(yarn, s.length[i], s.liquid[i] + bound[i]) * s.warmth[i];
    }
};

} // namespace hygroloom::inline HL_PRECISION
