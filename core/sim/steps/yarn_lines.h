// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Transport along a yarn: implicit Euler on the line of its segments, each yarn by a team of threads.
// Matrices are M-matrices: positive and conservative at any step; the masses moved are the fluxes of the converged solution.
#pragma once

#include "core/physics/heat_moisture.h"
#include "core/physics/wicking.h"
#include "core/sim/state.h"
#include "core/sim/team.h"

namespace hygroloom::inline HL_PRECISION {

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

    // Along the line while Newton's rounds go on; flux has the joints until there are fluxes.
    HL_FN double* saturation() const { return s.work0; }
    HL_FN double* power() const { return s.work1; }     ///< of the saturation
    HL_FN double* potential() const { return s.work2; } ///< of the saturation
    HL_FN void saturate(const YarnParameters& yarn, int i, double value) const
    {
        saturation()[i] = value;
        power()[i] = saturation_power(value, yarn.exponent);
        potential()[i] = value * power()[i] / (yarn.exponent + 1.0);
    }

    template <typename Team> HL_FN void operator()(const Team& team, int index) const
    {
        const YarnLine line = s.visited_line(index);
        const YarnParameters& yarn = line.yarn;
        const int a = line.first, b = line.last;
        if (yarn.liquid_diffusivity <= 0 || !team.any_of(a, b, [&](int i) { return s.liquid[i] > 0; })) {
            team.each(a, b, [&](int i) { s.flux[i] = 0; });
            return;
        }
        team.each(a, b, [&](int i) {
            saturate(yarn, i, is_fed(i) ? 1.0 : s.liquid[i] / capacity(i));
            s.flux[i] = i < b - 1 ? joint(yarn, i) : 0.0;
        });
        const double gravity = line.is_warp ? gravity_along_warp : gravity_along_weft;
        bool closes_in = true;
        for (int round = 0; round < most_newton_rounds && closes_in; ++round) closes_in = newton_round(team, line, gravity);

        team.each(a, b - 1, [&](int i) {
            s.flux[i] = s.flux[i] * (potential()[i] - potential()[i + 1]) - fall(yarn, gravity, i) * saturation()[i + 1];
        });
        team.each(a, b, [&](int i) {
            const double gained = (i > a ? s.flux[i - 1] : 0.0) - s.flux[i];
            if (is_fed(i))
                s.supplied[i] -= gained;
            else
                s.liquid[i] += gained;
        });
        carry_rounding(team, line);
    }

    /// One Newton round by elimination; returns whether any saturation changed too much for it to be the last.
    template <typename Team> HL_FN bool newton_round(const Team& team, const YarnLine& line, double gravity) const
    {
        constexpr double little = 1e-9; // what a round leaves goes with the square of its change
        const YarnParameters& yarn = line.yarn;
        const int a = line.first, b = line.last;
        const auto row = [&](int i) -> Equation {
            if (is_fed(i)) return {0, 1, 0, 0}; // cannot change
            const bool first = i == a, last = i == b - 1;
            const double before_joint = first ? 0.0 : s.flux[i - 1], next_joint = last ? 0.0 : s.flux[i];
            const double before_fall = first ? 0.0 : fall(yarn, gravity, i - 1), next_fall = last ? 0.0 : fall(yarn, gravity, i);
            const double own = potential()[i], before = first ? 0.0 : potential()[i - 1], next = last ? 0.0 : potential()[i + 1];
            const double cap = capacity(i);
            const double residual = cap * saturation()[i] - s.liquid[i] + before_joint * (own - before) + next_joint * (own - next) +
                                    before_fall * saturation()[i] - (last ? 0.0 : next_fall * saturation()[i + 1]);
            return {first ? 0.0 : -before_joint * power()[i - 1], cap + (before_joint + next_joint) * power()[i] + before_fall,
                    last ? 0.0 : -next_joint * power()[i + 1] - next_fall, -residual};
        };
        bool moved = false;
        team.solve(a, b, row, [&](int i, double change) {
            const double before = saturation()[i];
            double updated = before + change;
            updated = updated < 0 ? 0.0 : updated > 1 ? 1.0 : updated;
            moved = moved || updated - before >= little || before - updated >= little;
            saturate(yarn, i, updated);
        });
        return team.any(moved);
    }

    /// Passes on what rounding, or a full place below, left outside 0..capacity, so that neither bound nor the total is touched.
    template <typename Team> HL_FN void carry_rounding(const Team& team, const YarnLine& line) const
    {
        const auto bounded = [&](int i) {
            const double cap = capacity(i);
            return s.liquid[i] < 0 ? 0.0 : s.liquid[i] > cap ? cap : s.liquid[i];
        };
        if (!team.any_of(line.first, line.last, [&](int i) { return s.liquid[i] != bounded(i); })) return;
        team.carry(
            line.first, line.last,
            [&](int i) {
                const double kept = bounded(i), over = s.liquid[i] - kept;
                if (over != 0) s.liquid[i] = kept;
                return over;
            },
            [&](int from, int to, double amount) {
                if (from < to)
                    s.flux[from] += amount;
                else
                    s.flux[to] -= amount;
            },
            [&](int i, double amount) { s.liquid[i] += amount; });
    }
};

/// Heat capacity of a segment with its liquid and bound water, J/K. Vapour's is left out; water that turns to vapour takes its
/// warmth along, which the ledger counts as lost.
HL_FN double heat_capacity(const YarnParameters& yarn, double length, double water)
{
    return length * yarn.fibre_area * yarn.fibre_density * yarn.fibre_specific_heat + water * water_specific_heat;
}

/// Goes one after the other through the shells that divide a fibre: thinner towards the skin, where water enters first.
struct ShellWalk {
    double width, left;          ///< left: how far the skin still is, before shells are drawn to it, of the radius
    double square = left * left; ///< in radii of the fibre, as it is drawn

    /// Over the next shell towards the skin; its share of the fibre's section.
    HL_FN double outwards()
    {
        const double inner = square;
        left -= width;
        square = left * left;
        return (inner - square) * (2.0 - inner - square);
    }
    HL_FN double inwards()
    {
        const double outer = square;
        left += width;
        square = left * left;
        return (square - outer) * (2.0 - square - outer);
    }
};
HL_FN ShellWalk from_the_middle(int shells) { return {plain_inverse(static_cast<double>(shells)), 1.0}; }
HL_FN ShellWalk from_the_skin(int shells) { return {plain_inverse(static_cast<double>(shells)), 0.0}; }

/// Water bound in a segment's fibres, kg.
HL_FN double bound_water(const Segments& s, const YarnParameters& yarn, int segment)
{
    ShellWalk walk = from_the_middle(s.shells);
    double regain = 0;
    for (int k = 0; k < s.shells; ++k) regain += s.regain[segment * s.shells + k] * walk.outwards();
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

    HL_FN bool is_fed(int i) const { return s.fed != nullptr && s.fed[i] != 0; }

    template <typename Team> HL_FN void operator()(const Team& team, int index) const
    {
        const YarnLine line = s.visited_line(index);
        const int a = line.first, b = line.last;
        if (climate.air_warmth == 0 && !team.any_of(a, b, [&](int i) { return s.warmth[i] != 0; })) return;

        double* joints = s.work0;
        team.each(a, b - 1, [&](int i) { joints[i] = joint(line.yarn, i); });
        const double end = // W/K x s, of a cut end in the air
            face_only ? 0.0 : dt * climate.heat_transfer * (line.yarn.fibre_area + line.yarn.pore_area);
        const auto lose = [&](int i) {
            if (!is_fed(i)) s.lost[i] += end * (s.warmth[i] - climate.air_warmth);
        };
        team.solve(
            a, b, [&](int i) { return row(line, i, end, joints); },
            [&](int i, double warmth) {
                s.warmth[i] = warmth;
                if (line.starts && i == a) lose(i);
                if (line.stops && i == b - 1) lose(i);
            });
        if (s.fed == nullptr) return;
        const auto passed = [&](int i) {
            return joints[i] * (s.warmth[i] - s.warmth[i + 1]) + water_specific_heat * s.flux[i] * s.warmth[s.flux[i] > 0 ? i : i + 1];
        };
        team.each(a, b, [&](int i) {
            if (!is_fed(i)) return;
            if (i > a) s.lost[i] += passed(i - 1);
            if (i < b - 1) s.lost[i] -= passed(i);
        });
    }
    HL_FN Equation row(const YarnLine& line, int i, double end, const double* joints) const
    {
        if (is_fed(i)) return {0, 1, 0, 0}; // has the liquid's temperature that it hangs in
        const bool first = i == line.first, last = i == line.last - 1;
        const double in = first ? 0.0 : s.flux[i - 1]; // from the segment before
        const double out = s.flux[i];
        const double before_joint = first ? 0.0 : joints[i - 1], next_joint = last ? 0.0 : joints[i];
        const double came = (in > 0 ? in : 0.0) - (out < 0 ? out : 0.0);
        const double now = heat_capacity(line.yarn, s.length[i], s.liquid[i] + bound_water(s, line.yarn, i));
        const double then = now - water_specific_heat * (in - out);
        const double ends = (first && line.starts ? end : 0.0) + (last && line.stops ? end : 0.0);
        return {-before_joint - water_specific_heat * (in > 0 ? in : 0.0),
                then + water_specific_heat * came + before_joint + next_joint + ends,
                -next_joint + water_specific_heat * (out < 0 ? out : 0.0), then * s.warmth[i] + ends * climate.air_warmth};
    }
};

/// Volume of air in a segment's pores, m3; never quite none, so that a full yarn's vapour has a concentration.
HL_FN double pore_air(double pores, double liquid, double density)
{
    const double air = pores - liquid * plain_inverse(density);
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
        const double rate = phase_change_rate(yarn.fibre_area, yarn.fibre_radius, yarn.pore_area);
        const double wanted = s.pores[i] * rate * dt * wet_share(s.liquid[i] / (climate.density * s.pores[i]));
        const double dry = heat_capacity(yarn, s.length[i], 0.0);
        const double bearable = heat ? dry * most_cooling / heat_of_evaporation(climate.temperature) : s.liquid[i];
        const double lasting = (s.liquid[i] < bearable ? s.liquid[i] : bearable) / saturated;
        return wanted < lasting ? wanted : lasting;
    }
};

/// Vapour along each yarn, in its pores and beside it, and out of its ends; wet segments feed it from their liquid, and take the heat for
/// it. What the exchange that follows will take is foreseen, so that it goes as far as it does. Leaves the concentrations foreseen in
/// work2, the pivots in work1.
struct DiffuseVapourAlongYarn {
    Segments s;
    ClimateParameters climate;
    double dt;
    double face_area;
    bool heat;
    bool face_only = false; ///< cut ends are closed

    HL_FN double air(int i) const { return pore_air(s.pores[i], s.liquid[i], climate.density); }
    HL_FN double joint(const YarnParameters& yarn, int i) const // m3
    {
        const double own_air = air(i), next_air = air(i + 1);
        const double distance = 0.5 * (s.length[i] + s.length[i + 1]);
        const double narrow = own_air / s.length[i] < next_air / s.length[i + 1] ? own_air / s.length[i] : next_air / s.length[i + 1];
        return dt * (yarn.vapour_diffusivity * narrow + yarn.open_vapour) / distance;
    }
    HL_FN double cut_ends(const YarnLine& line, int i) const // m3, through the ends of the yarn to the air
    {
        const int ends = (line.starts && i == line.first ? 1 : 0) + (line.stops && i == line.last - 1 ? 1 : 0);
        if (face_only || ends == 0) return 0;
        const YarnParameters& yarn = line.yarn;
        const double inside = 2.0 * (yarn.vapour_diffusivity * air(i) / s.length[i] + yarn.open_vapour) / s.length[i];
        const double outside = climate.mass_transfer * (yarn.fibre_area + yarn.pore_area);
        return inside > 0 && outside > 0 ? ends * dt * inside * outside / (inside + outside) : 0.0;
    }

    HL_FN bool is_disturbed(int i) const
    {
        const double difference = s.vapour[i] / air(i) - climate.vapour;
        return s.liquid[i] > 0 || difference > 1e-9 * climate.vapour || difference < -1e-9 * climate.vapour;
    }

    template <typename Team> HL_FN void operator()(const Team& team, int index) const
    {
        const YarnLine line = s.visited_line(index);
        const int a = line.first, b = line.last;
        double *joints = s.work0, *pivot = s.work1, *concentration = s.work2;
        const ForeseeVapour foresee{s, climate, dt, face_area, heat};
        if (!team.any_of(a, b, [&](int i) { return is_disturbed(i); })) {
            team.each(a, b, [&](int i) {
                pivot[i] = foresee(line.yarn, i).pivot;
                concentration[i] = climate.vapour;
            });
            return;
        }

        team.each(a, b - 1, [&](int i) { joints[i] = joint(line.yarn, i); });
        const auto row = [&](int i) -> Equation {
            const double before_joint = i > a ? joints[i - 1] : 0.0, next_joint = i < b - 1 ? joints[i] : 0.0;
            const VapourAtHome home = foresee(line.yarn, i);
            const double end = cut_ends(line, i);
            pivot[i] = home.pivot;
            return {-before_joint, home.pivot + end + before_joint + next_joint, -next_joint, home.known + end * climate.vapour};
        };
        team.solve(a, b, row, [&](int i, double found) { concentration[i] = found; });
        // Masses follow from the fluxes of the solution, so vapour is neither made nor lost.
        const auto passed = [&](int i) { return joints[i] * (concentration[i] - concentration[i + 1]); };
        team.each(a, b, [&](int i) { take(line, i, foresee, (i > a ? passed(i - 1) : 0.0) - (i < b - 1 ? passed(i) : 0.0)); });
    }
    HL_FN void take(const YarnLine& line, int i, const ForeseeVapour& foresee, double gained) const
    {
        const double concentration = s.work2[i];
        const double temperature = climate.temperature + s.warmth[i];
        const double saturated = saturation_concentration(temperature);
        const double evaporated = foresee.supply(line.yarn, i, saturated) * (saturated - concentration);
        const double through_end = cut_ends(line, i) * (concentration - climate.vapour);
        s.vapour[i] += gained + evaporated - through_end; // less than nothing is what fibres and air will give
        s.evaporated[i] += through_end;
        if (heat && evaporated != 0) {
            const double released = -heat_of_evaporation(temperature) * evaporated;
            s.warmth[i] += released / heat_capacity(line.yarn, s.length[i], s.liquid[i] + bound_water(s, line.yarn, i));
            s.released[i] += released;
            s.lost[i] += water_specific_heat * evaporated * s.warmth[i];
        }
        s.liquid[i] -= evaporated;
    }
};

} // namespace hygroloom::inline HL_PRECISION
