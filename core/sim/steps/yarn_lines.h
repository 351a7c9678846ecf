// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Transport along a yarn: implicit Euler on the line of its segments, one functor call per yarn.
// Matrices are M-matrices: positive and conservative at any step; the masses moved are the fluxes of the converged solution.
#pragma once

#include "core/physics/heat_moisture.h"
#include "core/physics/wicking.h"
#include "core/sim/state.h"

namespace hygroloom {

constexpr int most_newton_rounds = 40;

/// Liquid along each yarn: d(m)/dt = d/dx(rho A D0 s^p ds/dx + rho A fall g s). Leaves the mass that passed each joint in flux.
struct WickAlongYarn {
    Segments s;
    ClimateParameters climate;
    double dt;
    double gravity_along_warp; ///< m/s2 towards the line's start
    double gravity_along_weft;

    HL_FN double capacity(int i) const { return climate.density * s.pores[i]; }
    HL_FN bool is_fed(int i) const { return s.fed != nullptr && s.fed[i] != 0; }
    HL_FN double area(int i) const { return (s.pores[i] + s.pores[i + 1]) / (s.length[i] + s.length[i + 1]); }
    HL_FN double flow(int i) const // kg/m, liquid that a unit of m2/s would move, times the warm liquid's ease
    {
        double ease = 1.0;
        if (s.warmth[i] != 0 || s.warmth[i + 1] != 0)
            ease = 0.5 * (flow_factor(climate, s.warmth[i]) + flow_factor(climate, s.warmth[i + 1]));
        return dt * climate.density * area(i) * ease;
    }
    HL_FN double joint(const YarnParameters& yarn, int i) const // kg per unit of potential, between i and i + 1
    {
        return flow(i) * yarn.liquid_diffusivity / (0.5 * (s.length[i] + s.length[i + 1]));
    }
    HL_FN double fall(const YarnParameters& yarn, double gravity, int i) const // kg per unit of saturation, from i + 1 down to i
    {
        return gravity > 0 ? flow(i) * yarn.fall * gravity : 0.0;
    }
    HL_FN static double potential(const YarnParameters& yarn, double saturation) { return spreading_potential(saturation, yarn.exponent); }

    HL_FN void operator()(int index) const
    {
        const YarnLine line = s.visited_line(index);
        const YarnParameters& yarn = line.yarn;
        const int a = line.first, b = line.last;
        double held = 0;
        for (int i = a; i < b; ++i) {
            s.flux[i] = 0;
            held += s.liquid[i];
        }
        if (held <= 0 || yarn.liquid_diffusivity <= 0) return;

        const double gravity = line.is_warp ? gravity_along_warp : gravity_along_weft;
        double* saturation = s.work0;
        for (int i = a; i < b; ++i) saturation[i] = is_fed(i) ? 1.0 : s.liquid[i] / capacity(i);
        for (int round = 0; round < most_newton_rounds; ++round)
            if (newton_round(line, gravity) < 1e-13) break;

        for (int i = a; i < b - 1; ++i)
            s.flux[i] = joint(yarn, i) * (potential(yarn, saturation[i]) - potential(yarn, saturation[i + 1])) -
                        fall(yarn, gravity, i) * saturation[i + 1];
        for (int i = a; i < b; ++i) {
            const double gained = (i > a ? s.flux[i - 1] : 0.0) - s.flux[i];
            if (is_fed(i))
                s.supplied[i] -= gained;
            else
                s.liquid[i] += gained;
        }
        carry_rounding(line);
    }

    /// One Newton round by elimination; returns the largest change of saturation.
    HL_FN double newton_round(const YarnLine& line, double gravity) const
    {
        const YarnParameters& yarn = line.yarn;
        const int a = line.first, b = line.last;
        double* saturation = s.work0;
        double* upper = s.work1;
        double* right = s.work2;
        double before = 0, before_slope = 0, before_joint = 0, before_fall = 0;
        double own = potential(yarn, saturation[a]);
        double own_slope = saturation_power(saturation[a], yarn.exponent);
        for (int i = a; i < b; ++i) {
            const bool last = i == b - 1;
            const double next = last ? 0.0 : potential(yarn, saturation[i + 1]);
            const double next_slope = last ? 0.0 : saturation_power(saturation[i + 1], yarn.exponent);
            const double next_joint = last ? 0.0 : joint(yarn, i);
            const double next_fall = last ? 0.0 : fall(yarn, gravity, i);
            if (is_fed(i)) { // cannot change
                upper[i] = right[i] = 0;
            } else {
                const double cap = capacity(i);
                const double residual = cap * saturation[i] - s.liquid[i] + before_joint * (own - before) + next_joint * (own - next) +
                                        before_fall * saturation[i] - (last ? 0.0 : next_fall * saturation[i + 1]);
                const double lower = -before_joint * before_slope;
                const double pivot = cap + (before_joint + next_joint) * own_slope + before_fall - (i > a ? lower * upper[i - 1] : 0.0);
                upper[i] = (-next_joint * next_slope - next_fall) / pivot;
                right[i] = (-residual - (i > a ? lower * right[i - 1] : 0.0)) / pivot;
            }
            before = own;
            before_slope = own_slope;
            before_joint = next_joint;
            before_fall = next_fall;
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

    /// Passes on what rounding, or a full place below, left outside 0..capacity, so that neither bound nor the total is touched.
    HL_FN void carry_rounding(const YarnLine& line) const
    {
        for (int i = line.first; i < line.last - 1; ++i) s.flux[i] += pass(i, i + 1);
        for (int i = line.last - 1; i > line.first; --i) s.flux[i - 1] -= pass(i, i - 1);
    }
    HL_FN double pass(int from, int to) const
    {
        const double cap = capacity(from);
        const double bounded = s.liquid[from] < 0 ? 0.0 : s.liquid[from] > cap ? cap : s.liquid[from];
        const double moved = s.liquid[from] - bounded;
        s.liquid[to] += moved;
        s.liquid[from] = bounded;
        return moved;
    }
};

/// Heat capacity of a segment with its liquid and bound water, J/K. Vapour's is left out; water that turns to vapour takes its
/// warmth along, which the ledger counts as lost.
HL_FN double heat_capacity(const YarnParameters& yarn, double length, double water)
{
    return length * yarn.fibre_area * yarn.fibre_density * yarn.fibre_specific_heat + water * water_specific_heat;
}

/// Radius over the fibre's at which shell k of n begins: thinner towards the skin, where water enters first.
HL_FN double shell_start(int k, int n)
{
    const double inwards = 1.0 - static_cast<double>(k) / n;
    return 1.0 - inwards * inwards;
}
/// Of the fibre's section, in shell k of n.
HL_FN double shell_share(int k, int n)
{
    const double inner = shell_start(k, n), outer = shell_start(k + 1, n);
    return (outer - inner) * (outer + inner);
}

/// Water bound in a segment's fibres, kg.
HL_FN double bound_water(const Segments& s, const YarnParameters& yarn, int segment)
{
    double regain = 0;
    for (int k = 0; k < s.shells; ++k) regain += s.regain[segment * s.shells + k] * shell_share(k, s.shells);
    return regain * s.length[segment] * yarn.fibre_area * yarn.fibre_density;
}

/// Heat along each yarn, by conduction and with the liquid that has just moved (flux).
struct ConductAlongYarn {
    Segments s;
    ClimateParameters climate;
    double dt;
    bool face_only = false; ///< cut ends are closed

    HL_FN double joint(const YarnParameters& yarn, int i) const // W/K x s
    {
        const double area = yarn.fibre_area + yarn.pore_area;
        const double distance = 0.5 * (s.length[i] + s.length[i + 1]);
        const double liquid = (s.liquid[i] + s.liquid[i + 1]) / (climate.density * 2.0 * distance * area);
        return dt * parallel_conductivity(yarn.fibre_area / area, yarn.fibre_conductivity, liquid) * area / distance;
    }

    HL_FN void operator()(int index) const
    {
        const YarnLine line = s.visited_line(index);
        const YarnParameters& yarn = line.yarn;
        const int a = line.first, b = line.last;
        bool any = climate.air_warmth != 0;
        for (int i = a; i < b && !any; ++i) any = s.warmth[i] != 0;
        if (!any) return;

        const double end =
            face_only ? 0.0 : dt * climate.heat_transfer * (yarn.fibre_area + yarn.pore_area); // W/K x s, of a cut end in the air
        double before_joint = 0;
        for (int i = a; i < b; ++i) {
            if (s.fed != nullptr && s.fed[i] != 0) { // has the liquid's temperature that it hangs in
                s.work1[i] = s.work2[i] = 0;
                before_joint = i < b - 1 ? joint(yarn, i) : 0.0;
                continue;
            }
            const double in = i > a ? s.flux[i - 1] : 0.0; // from the segment before
            const double out = s.flux[i];
            const double next_joint = i < b - 1 ? joint(yarn, i) : 0.0;
            const double came = (in > 0 ? in : 0.0) - (out < 0 ? out : 0.0);
            const double now = heat_capacity(yarn, s.length[i], s.liquid[i] + bound_water(s, yarn, i));
            const double then = now - water_specific_heat * (in - out);
            const double lower = -before_joint - water_specific_heat * (in > 0 ? in : 0.0);
            const double higher = -next_joint + water_specific_heat * (out < 0 ? out : 0.0);
            const double ends = (i == a && line.starts ? end : 0.0) + (i == b - 1 && line.stops ? end : 0.0);
            const double pivot =
                then + water_specific_heat * came + before_joint + next_joint + ends - (i > a ? lower * s.work1[i - 1] : 0.0);
            s.work1[i] = higher / pivot;
            s.work2[i] = (then * s.warmth[i] + ends * climate.air_warmth - (i > a ? lower * s.work2[i - 1] : 0.0)) / pivot;
            before_joint = next_joint;
        }
        for (int i = b - 1; i >= a; --i) s.warmth[i] = s.work2[i] - (i < b - 1 ? s.work1[i] * s.warmth[i + 1] : 0.0);
        const auto lose = [&](int i) {
            if (s.fed == nullptr || s.fed[i] == 0) s.lost[i] += end * (s.warmth[i] - climate.air_warmth);
        };
        if (line.starts) lose(a);
        if (line.stops) lose(b - 1);
        if (s.fed == nullptr) return;
        for (int i = a; i < b - 1; ++i) {
            const double passed =
                joint(yarn, i) * (s.warmth[i] - s.warmth[i + 1]) + water_specific_heat * s.flux[i] * s.warmth[s.flux[i] > 0 ? i : i + 1];
            if (s.fed[i] != 0) s.lost[i] -= passed;
            if (s.fed[i + 1] != 0) s.lost[i + 1] += passed;
        }
    }
};

/// Volume of air in a segment's pores, m3; never quite none, so that a full yarn's vapour has a concentration.
HL_FN double pore_air(double pores, double liquid, double density)
{
    const double air = pores - liquid / density;
    return air > 1e-3 * pores ? air : 1e-3 * pores;
}

/// What a step of a segment's own will do to its pore vapour, foreseen by whatever moves vapour from one segment to another: its liquid
/// feeds it, fibres and air take from it. A concentration c at the end of the step leaves known - pivot c for the neighbours.
struct VapourAtHome {
    double pivot; ///< m3
    double known; ///< kg
};

/// Foresees it.
struct ForeseeVapour {
    Segments s;
    ClimateParameters climate;
    double dt;
    double face_area; ///< m2 of fabric face that a segment answers for
    bool heat;        ///< whether evaporation cools

    HL_FN VapourAtHome operator()(const YarnParameters& yarn, int i) const
    {
        const double air = pore_air(s.pores[i], s.liquid[i], climate.density);
        const double saturated = saturation_concentration(climate.temperature + s.warmth[i]);
        const double fed = supply(yarn, i, saturated), to_air = dt * climate.mass_transfer * face_area;
        // Liquid that came since has squeezed the vapour; fibres are at peace with no more than saturation.
        const double squeezed = s.vapour[i] / air, met = squeezed < saturated ? squeezed : saturated;
        return {air + s.uptake[i] + to_air + fed, s.vapour[i] + s.uptake[i] * met + fed * saturated + to_air * climate.vapour};
    }
    /// m3 of air that its liquid can bring to saturation: never more than it lasts for, nor than cools it by a few kelvin.
    HL_FN double supply(const YarnParameters& yarn, int i, double saturated) const
    {
        if (s.liquid[i] <= 0) return 0;
        constexpr double most_cooling = 3.0; // K
        const double fibre_share = yarn.fibre_area / (yarn.fibre_area + yarn.pore_area);
        const double rate = phase_change_rate(fibre_share, yarn.fibre_radius, 1.0 - fibre_share);
        const double wanted = s.pores[i] * rate * dt * wet_share(s.liquid[i] / (climate.density * s.pores[i]));
        const double dry = heat_capacity(yarn, s.length[i], 0.0);
        const double bearable = heat ? dry * most_cooling / heat_of_evaporation(climate.temperature) : s.liquid[i];
        const double lasting = (s.liquid[i] < bearable ? s.liquid[i] : bearable) / saturated;
        return wanted < lasting ? wanted : lasting;
    }
};

/// Vapour along each yarn, in its pores and beside it, and out of its ends; wet segments feed it from their liquid, and take the heat for
/// it. What the exchange that follows will take is foreseen, so that it goes as far as it does. Leaves the concentrations foreseen in
/// work2.
struct DiffuseVapourAlongYarn {
    Segments s;
    ClimateParameters climate;
    double dt;
    double face_area;
    bool heat;
    bool face_only = false; ///< cut ends are closed

    HL_FN double air(int i) const { return pore_air(s.pores[i], s.liquid[i], climate.density); }
    HL_FN double joint(const YarnParameters& yarn, int i, double own_air, double next_air) const // m3
    {
        const double distance = 0.5 * (s.length[i] + s.length[i + 1]);
        const double narrow = own_air / s.length[i] < next_air / s.length[i + 1] ? own_air / s.length[i] : next_air / s.length[i + 1];
        return dt * (yarn.vapour_diffusivity * narrow + yarn.open_vapour) / distance;
    }
    HL_FN double cut_ends(const YarnLine& line, int i, double own_air) const // m3, through the ends of the yarn to the air
    {
        const int ends = (line.starts && i == line.first ? 1 : 0) + (line.stops && i == line.last - 1 ? 1 : 0);
        if (face_only || ends == 0) return 0;
        const YarnParameters& yarn = line.yarn;
        const double inside = 2.0 * (yarn.vapour_diffusivity * own_air / s.length[i] + yarn.open_vapour) / s.length[i];
        const double outside = climate.mass_transfer * (yarn.fibre_area + yarn.pore_area);
        return inside > 0 && outside > 0 ? ends * dt * inside * outside / (inside + outside) : 0.0;
    }

    HL_FN void operator()(int index) const
    {
        const YarnLine line = s.visited_line(index);
        const YarnParameters& yarn = line.yarn;
        const int a = line.first, b = line.last;
        bool disturbed = false;
        for (int i = a; i < b && !disturbed; ++i) {
            const double difference = s.vapour[i] / air(i) - climate.vapour;
            disturbed = s.liquid[i] > 0 || difference > 1e-9 * climate.vapour || difference < -1e-9 * climate.vapour;
        }
        if (!disturbed) {
            for (int i = a; i < b; ++i) s.work2[i] = climate.vapour;
            return;
        }

        const ForeseeVapour foresee{s, climate, dt, face_area, heat};
        double before_joint = 0;
        double own_air = air(a);
        for (int i = a; i < b; ++i) {
            const double next_air = i < b - 1 ? air(i + 1) : 0.0;
            const double next_joint = i < b - 1 ? joint(yarn, i, own_air, next_air) : 0.0;
            const VapourAtHome home = foresee(yarn, i);
            const double end = cut_ends(line, i, own_air);
            const double lower = -before_joint;
            const double pivot = home.pivot + end + before_joint + next_joint - (i > a ? lower * s.work1[i - 1] : 0.0);
            s.work1[i] = -next_joint / pivot;
            s.work2[i] = (home.known + end * climate.vapour - (i > a ? lower * s.work2[i - 1] : 0.0)) / pivot;
            before_joint = next_joint;
            own_air = next_air;
        }
        for (int i = b - 1; i >= a; --i) s.work2[i] -= i < b - 1 ? s.work1[i] * s.work2[i + 1] : 0.0;
        // Masses follow from the fluxes of the solution, so vapour is neither made nor lost.
        double arriving = 0;
        own_air = air(a);
        for (int i = a; i < b; ++i) {
            const double next_air = i < b - 1 ? air(i + 1) : 0.0;
            const double leaving = i < b - 1 ? joint(yarn, i, own_air, next_air) * (s.work2[i] - s.work2[i + 1]) : 0.0;
            const double temperature = climate.temperature + s.warmth[i];
            const double saturated = saturation_concentration(temperature);
            const double evaporated = foresee.supply(yarn, i, saturated) * (saturated - s.work2[i]);
            const double through_end = cut_ends(line, i, own_air) * (s.work2[i] - climate.vapour);
            s.vapour[i] += arriving - leaving + evaporated - through_end; // less than nothing is what fibres and air will give
            s.evaporated[i] += through_end;
            if (heat && evaporated != 0) {
                const double released = -heat_of_evaporation(temperature) * evaporated;
                s.warmth[i] += released / heat_capacity(yarn, s.length[i], s.liquid[i] + bound_water(s, yarn, i));
                s.released[i] += released;
                s.lost[i] += water_specific_heat * evaporated * s.warmth[i];
            }
            s.liquid[i] -= evaporated;
            arriving = leaving;
            own_air = next_air;
        }
    }
};

} // namespace hygroloom
