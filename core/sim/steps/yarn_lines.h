// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Transport along a yarn: implicit Euler on the line of its segments, one functor call per yarn.
// Matrices are M-matrices: positive and conservative at any step; the masses moved are the fluxes of the converged solution.
#pragma once

#include "core/physics/heat_moisture.h"
#include "core/physics/wicking.h"
#include "core/sim/state.h"

namespace hygroloom {

constexpr int most_newton_rounds = 40;

/// Liquid along each yarn: d(m)/dt = d/dx(rho A D0 s^p ds/dx). Leaves the mass that passed each joint in flux.
struct WickAlongYarn {
    Segments s;
    double dt;
    double density;   ///< of the liquid
    int fed = 0;      ///< segments at the start of every end that hang in liquid and stay full

    HL_FN double capacity(const YarnParameters& yarn, int i) const { return density * yarn.pore_area * s.length[i]; }
    HL_FN double joint(const YarnParameters& yarn, int i) const // kg per unit of potential, between i and i + 1
    {
        return dt * density * yarn.pore_area * yarn.liquid_diffusivity / (0.5 * (s.length[i] + s.length[i + 1]));
    }
    HL_FN static double potential(const YarnParameters& yarn, double saturation) { return spreading_potential(saturation, yarn.exponent); }

    HL_FN void operator()(int index) const
    {
        const YarnLine line = s.line(index);
        const YarnParameters& yarn = line.yarn;
        const int a = line.first, b = line.last;
        const int unfed = a + (index < s.ends ? fed : 0); // the first that does not hang in liquid
        double held = 0;
        for (int i = a; i < b; ++i) {
            s.flux[i] = 0;
            if (i < unfed) s.liquid[i] = capacity(yarn, i);
            held += s.liquid[i];
        }
        if (held <= 0 || yarn.liquid_diffusivity <= 0) return;

        double* saturation = s.work0;
        for (int i = a; i < b; ++i) saturation[i] = s.liquid[i] / capacity(yarn, i);
        for (int round = 0; round < most_newton_rounds; ++round)
            if (newton_round(line, unfed) < 1e-13) break;

        for (int i = a; i < b - 1; ++i) s.flux[i] = joint(yarn, i) * (potential(yarn, saturation[i]) - potential(yarn, saturation[i + 1]));
        for (int i = a; i < b; ++i)
            if (i >= unfed) s.liquid[i] += (i > a ? s.flux[i - 1] : 0.0) - s.flux[i];
        carry_rounding(line);
    }

    /// One Newton round by elimination; returns the largest change of saturation.
    HL_FN double newton_round(const YarnLine& line, int unfed) const
    {
        const YarnParameters& yarn = line.yarn;
        const int a = line.first, b = line.last;
        double* saturation = s.work0;
        double* upper = s.work1;
        double* right = s.work2;
        double before = 0, before_slope = 0, before_joint = 0;
        double own = potential(yarn, saturation[a]);
        double own_slope = saturation_power(saturation[a], yarn.exponent);
        for (int i = a; i < b; ++i) {
            const bool last = i == b - 1;
            const double next = last ? 0.0 : potential(yarn, saturation[i + 1]);
            const double next_slope = last ? 0.0 : saturation_power(saturation[i + 1], yarn.exponent);
            const double next_joint = last ? 0.0 : joint(yarn, i);
            const double cap = i < unfed ? 1e30 : capacity(yarn, i); // a segment that hangs in liquid cannot change
            const double residual =
                i < unfed ? 0.0 : cap * saturation[i] - s.liquid[i] + before_joint * (own - before) + next_joint * (own - next);
            const double lower = -before_joint * before_slope;
            const double pivot = cap + (before_joint + next_joint) * own_slope - (i > a ? lower * upper[i - 1] : 0.0);
            upper[i] = -next_joint * next_slope / pivot;
            right[i] = (-residual - (i > a ? lower * right[i - 1] : 0.0)) / pivot;
            before = own;
            before_slope = own_slope;
            before_joint = next_joint;
            own = next;
            own_slope = next_slope;
        }
        double largest = 0, change = 0;
        for (int i = b - 1; i >= a; --i) {
            change = right[i] - (i < b - 1 ? upper[i] * change : 0.0);
            double updated = saturation[i] + change;
            updated = updated < 0 ? 0.0 : updated > 1 ? 1.0 : updated;
            const double moved = updated > saturation[i] ? updated - saturation[i] : saturation[i] - updated;
            if (moved > largest) largest = moved;
            saturation[i] = updated;
        }
        return largest;
    }

    /// Passes on what rounding left outside 0..capacity, so that neither bound nor the total is touched.
    HL_FN void carry_rounding(const YarnLine& line) const
    {
        for (int i = line.first; i < line.last - 1; ++i) pass(line.yarn, i, i + 1);
        for (int i = line.last - 1; i > line.first; --i) pass(line.yarn, i, i - 1);
    }
    HL_FN void pass(const YarnParameters& yarn, int from, int to) const
    {
        const double cap = capacity(yarn, from);
        const double bounded = s.liquid[from] < 0 ? 0.0 : s.liquid[from] > cap ? cap : s.liquid[from];
        s.liquid[to] += s.liquid[from] - bounded;
        s.liquid[from] = bounded;
    }
};

/// Heat capacity of a segment with its liquid and bound water, J/K. Vapour's is left out; water that turns to vapour takes its
/// warmth along, which the ledger counts as lost.
HL_FN double heat_capacity(const YarnParameters& yarn, double length, double water)
{
    return length * yarn.fibre_area * yarn.fibre_density * yarn.fibre_specific_heat + water * water_specific_heat;
}

/// Water bound in a segment's fibres, kg.
HL_FN double bound_water(const Segments& s, const YarnParameters& yarn, int segment)
{
    double regain = 0;
    for (int k = 0; k < s.shells; ++k) regain += s.regain[segment * s.shells + k] * (2 * k + 1);
    return regain / (s.shells * s.shells) * s.length[segment] * yarn.fibre_area * yarn.fibre_density;
}

/// Heat along each yarn, by conduction and with the liquid that has just moved (flux).
struct ConductAlongYarn {
    Segments s;
    double dt;
    double density;

    HL_FN double joint(const YarnParameters& yarn, int i) const // W/K x s
    {
        const double area = yarn.fibre_area + yarn.pore_area;
        const double distance = 0.5 * (s.length[i] + s.length[i + 1]);
        const double liquid = (s.liquid[i] + s.liquid[i + 1]) / (density * 2.0 * distance * area);
        return dt * parallel_conductivity(yarn.fibre_area / area, yarn.fibre_conductivity, liquid) * area / distance;
    }

    HL_FN void operator()(int index) const
    {
        const YarnLine line = s.line(index);
        const YarnParameters& yarn = line.yarn;
        const int a = line.first, b = line.last;
        bool any = false;
        for (int i = a; i < b && !any; ++i) any = s.warmth[i] != 0;
        if (!any) return;

        double before_joint = 0;
        for (int i = a; i < b; ++i) {
            const double in = i > a ? s.flux[i - 1] : 0.0; // from the segment before
            const double out = s.flux[i];
            const double next_joint = i < b - 1 ? joint(yarn, i) : 0.0;
            const double came = (in > 0 ? in : 0.0) - (out < 0 ? out : 0.0);
            const double now = heat_capacity(yarn, s.length[i], s.liquid[i] + bound_water(s, yarn, i));
            const double then = now - water_specific_heat * (in - out);
            const double lower = -before_joint - water_specific_heat * (in > 0 ? in : 0.0);
            const double higher = -next_joint + water_specific_heat * (out < 0 ? out : 0.0);
            const double pivot = then + water_specific_heat * came + before_joint + next_joint - (i > a ? lower * s.work1[i - 1] : 0.0);
            s.work1[i] = higher / pivot;
            s.work2[i] = (then * s.warmth[i] - (i > a ? lower * s.work2[i - 1] : 0.0)) / pivot;
            before_joint = next_joint;
        }
        for (int i = b - 1; i >= a; --i) s.warmth[i] = s.work2[i] - (i < b - 1 ? s.work1[i] * s.warmth[i + 1] : 0.0);
    }
};

/// Volume of air in a segment's pores, m3; never quite none, so that a full yarn's vapour has a concentration.
HL_FN double pore_air(const YarnParameters& yarn, double length, double liquid, double density)
{
    const double pores = yarn.pore_area * length;
    const double air = pores - liquid / density;
    return air > 1e-3 * pores ? air : 1e-3 * pores;
}

/// Vapour along each yarn; wet segments feed it from their liquid, and take the heat for it.
struct DiffuseVapourAlongYarn {
    Segments s;
    ClimateParameters climate;
    double dt;
    double background; ///< kg/m3, of undisturbed pores
    bool heat;         ///< whether evaporation cools

    HL_FN double air(const YarnParameters& yarn, int i) const { return pore_air(yarn, s.length[i], s.liquid[i], climate.density); }
    HL_FN double joint(const YarnParameters& yarn, int i, double own_air, double next_air) const // m3
    {
        const double distance = 0.5 * (s.length[i] + s.length[i + 1]);
        const double narrow = own_air / s.length[i] < next_air / s.length[i + 1] ? own_air / s.length[i] : next_air / s.length[i + 1];
        return dt * yarn.vapour_diffusivity * narrow / distance;
    }
    /// m3 of air that the segment's liquid can bring to saturation in this step, never more than the liquid lasts for.
    HL_FN double supply(const YarnParameters& yarn, int i, double own_air, double saturated) const
    {
        if (s.liquid[i] <= 0) return 0;
        const double fibre_share = yarn.fibre_area / (yarn.fibre_area + yarn.pore_area);
        const double rate = phase_change_rate(fibre_share, yarn.fibre_radius, 1.0 - fibre_share);
        const double wanted = own_air * rate * dt * wet_share(s.liquid[i] / (climate.density * yarn.pore_area * s.length[i]));
        const double lasting = s.liquid[i] / saturated;
        return wanted < lasting ? wanted : lasting;
    }

    HL_FN void operator()(int index) const
    {
        const YarnLine line = s.line(index);
        const YarnParameters& yarn = line.yarn;
        const int a = line.first, b = line.last;
        bool disturbed = false;
        for (int i = a; i < b && !disturbed; ++i) {
            const double difference = s.vapour[i] / air(yarn, i) - background;
            disturbed = s.liquid[i] > 0 || difference > 1e-9 * background || difference < -1e-9 * background;
        }
        if (!disturbed) return;

        double before_joint = 0;
        double own_air = air(yarn, a);
        for (int i = a; i < b; ++i) {
            const double next_air = i < b - 1 ? air(yarn, i + 1) : 0.0;
            const double next_joint = i < b - 1 ? joint(yarn, i, own_air, next_air) : 0.0;
            const double saturated = saturation_concentration(climate.temperature + s.warmth[i]);
            const double fed = supply(yarn, i, own_air, saturated);
            const double lower = -before_joint;
            const double pivot = own_air + fed + before_joint + next_joint - (i > a ? lower * s.work1[i - 1] : 0.0);
            s.work1[i] = -next_joint / pivot;
            s.work2[i] = (s.vapour[i] + fed * saturated - (i > a ? lower * s.work2[i - 1] : 0.0)) / pivot;
            before_joint = next_joint;
            own_air = next_air;
        }
        for (int i = b - 1; i >= a; --i) s.work2[i] -= i < b - 1 ? s.work1[i] * s.work2[i + 1] : 0.0;
        // Masses follow from the fluxes of the solution, so vapour is neither made nor lost.
        double arriving = 0;
        own_air = air(yarn, a);
        for (int i = a; i < b; ++i) {
            const double next_air = i < b - 1 ? air(yarn, i + 1) : 0.0;
            const double leaving = i < b - 1 ? joint(yarn, i, own_air, next_air) * (s.work2[i] - s.work2[i + 1]) : 0.0;
            const double temperature = climate.temperature + s.warmth[i];
            const double saturated = saturation_concentration(temperature);
            const double evaporated = supply(yarn, i, own_air, saturated) * (saturated - s.work2[i]);
            s.vapour[i] += arriving - leaving + evaporated;
            if (heat && evaporated != 0) {
                const double released = -heat_of_evaporation(temperature) * evaporated;
                s.warmth[i] += released / heat_capacity(yarn, s.length[i], s.liquid[i] + bound_water(s, yarn, i));
                s.released[i] += released;
                s.lost[i] += water_specific_heat * evaporated * s.warmth[i];
            }
            s.liquid[i] -= evaporated;
            if (s.vapour[i] < 0) s.vapour[i] = 0;
            arriving = leaving;
            own_air = next_air;
        }
    }
};

} // namespace hygroloom
