// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The balances of vapour and heat in a segment, for trials of its pore vapour and its temperature.
#pragma once

#include "core/solver/steps/bracket.h"
#include "core/solver/steps/fibre_exchange.h"
#include "core/solver/steps/standing.h"

namespace hygroloom {

/// What a step brings to all segments, and both balances of one. Unknowns are the pore vapour and the temperature.
struct SegmentBalance {
    Segments s;
    ClimateParameters climate;
    double face_area; ///< m2 of fabric face that a segment answers for
    double dt;
    bool sorption;
    bool vapour;
    bool heat;
    OverSegment over{}; ///< what stands on it

    /// What one trial of temperature and pore vapour leads to.
    struct Outcome {
        double pore_vapour = 0, evaporated = 0, bound = 0, from_liquid = 0, to_air = 0;
        double skin = 0, skin_slope = 0; ///< regain of the fibre's skin, and how it rises with its reference humidity
        ReferenceHumidity reference;     ///< that the skin is in equilibrium with
        double heat = 0;                 ///< J per kg of what fibres take from liquid, see sorbing()
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
        double came;                   ///< J, from other layers
    };
    /// What a trial's temperature brings.
    struct Warm {
        double warmth, temperature, shift; ///< see isotherm_shift()
        Saturation saturated;
        double per_saturation; ///< m3/kg
    };

    /// What fibres hold stays without sorption.
    HL_FN Fibre fibre_of(int i, const YarnParameters& yarn, ShellRows& rows) const
    {
        if (sorption) return prepare_fibre(s, i, yarn, climate.temperature + s.warmth[i], dt, rows);
        const double dry_mass = s.fibre_length(i, yarn) * yarn.fibre_area * yarn.fibre_density;
        return {dry_mass, s.bound[i], s.bound[i], 0, plain_inverse(dry_mass), regain_law(yarn.isotherm)};
    }
    HL_FN Start start_of(int i, const YarnParameters& yarn, double air, ShellRows& rows) const
    {
        const Fibre fibre = fibre_of(i, yarn, rows);
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
                heat_capacity(yarn, s.fibre_length(i, yarn), s.warm_water(i)),
                condensing,
                condensing * wet_share(wet),
                dt * climate.mass_transfer * face_area * (1.0 - over.covered),
                dt * (climate.heat_transfer * face_area * (1.0 - over.covered) + over.heat),
                came_to(i)};
    }
    HL_FN double came_to(int i) const { return s.came != nullptr ? s.came[i] : 0.0; }
    HL_FN Warm at_warmth(double warmth) const
    {
        const double temperature = climate.temperature + warmth;
        const Saturation saturated = saturation_at(temperature);
        return {warmth, temperature, isotherm_shift(temperature), saturated, plain_inverse(saturated.concentration)};
    }

    /// Humidity that the fibre's skin sees: its wet share sees liquid, the rest the pore's vapour.
    HL_FN static double skin_humidity(const Start& start, const Warm& now, double pore_vapour)
    {
        return start.wet + (1.0 - start.wet) * fmin_(1.0, pore_vapour * now.per_saturation);
    }
    HL_FN static double fmin_(double a, double b) { return a < b ? a : b; }
    HL_FN static double fmax_(double a, double b) { return a > b ? a : b; }

    /// Without vapour fibres take what liquid there is, and give none back; kg/kg.
    HL_FN double skin_on_liquid(const Start& start, double skin) const
    {
        const Fibre& fibre = start.fibre;
        if (!(fibre.slope > 0)) return skin;
        const double least = (fibre.bound - fibre.base) / fibre.slope;
        return fmax_(least, fmin_(skin, least + start.liquid / fibre.slope));
    }

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
            o.skin = vapour ? skin.value : skin_on_liquid(start, skin.value);
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

    /// kg that what stands on the segment gives to the air, and its slope with the temperature, kg/K; where the air gives, less than 0.
    HL_FN WithSlope standing_gives(const Warm& now) const
    {
        const double reaches = dt * over.vapour, gives = reaches * (now.saturated.concentration - climate.vapour);
        return gives < over.water ? WithSlope{gives, reaches * now.saturated.slope} : WithSlope{over.water, 0};
    }

    /// Heat released by the outcome, J.
    HL_FN double phase_heat(const Start& start, const Outcome& o, double temperature) const
    {
        const double taken = o.bound - start.fibre.bound;
        return taken * o.heat + heat_of_evaporation(temperature) * (taken - o.from_liquid - o.evaporated);
    }
    HL_FN double surplus(const Start& start, const Outcome& o, const Warm& now) const
    {
        return start.capacity * (now.warmth - start.warmth) + start.to_air_heat * (now.warmth - climate.air_warmth) - start.came -
               phase_heat(start, o, now.temperature) + heat_of_evaporation(now.temperature) * standing_gives(now).value;
    }
    /// Heat that is left over where the pores are balanced at a warmth, J.
    HL_FN double surplus_at(const Start& start, double warmth) const
    {
        const Warm now = at_warmth(warmth);
        Outcome o = pore_balance(start, now);
        o.heat = sorbing(start, o.bound).value;
        return surplus(start, o, now);
    }
};

} // namespace hygroloom
