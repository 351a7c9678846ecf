// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Transport along a yarn: implicit Euler on the line of its segments, each yarn by a team of threads.
// Matrices are M-matrices: positive and conservative at any step; the masses moved are the fluxes of the converged solution.
#pragma once

#include "core/physics/heat_moisture.h"
#include "core/physics/wicking.h"
#include "core/solver/segments.h"
#include "core/solver/team.h"

namespace hygroloom {

constexpr int most_newton_rounds = 40;

/// Liquid along each yarn: d(m)/dt = d/dx(rho A D0 s ds/dx + rho A fall g s). Leaves the mass that passed each joint in flux.
struct WickAlongYarn {
    Segments s;
    ClimateParameters climate;
    double dt;
    double gravity_along_warp; ///< m/s2 towards the line's start
    double gravity_along_weft;
    double* there_was = nullptr; ///< kg, takes the liquid as it is before; null: not wanted

    /// A line, and what its places share.
    struct Line {
        const YarnLine& at;
        double per_joint; ///< kg m per m2 of pores' section and unit of potential
        double per_fall;  ///< the same per unit of saturation; 0: nothing falls
    };

    HL_FN double capacity(int i) const { return climate.density * s.pores[i]; }
    HL_FN bool is_fed(int i) const { return s.fed != nullptr && s.fed[i] != 0; }
    /// The section between i and i + 1 over the length that counts in it, m, times the warm liquid's ease.
    HL_FN double section(int i, double per_length) const
    {
        const double area = (s.pores[i] + s.pores[i + 1]) * per_length;
        if (s.warmth[i] == 0 && s.warmth[i + 1] == 0) return area;
        return area * 0.5 * (flow_factor(climate.flow, s.warmth[i]) + flow_factor(climate.flow, s.warmth[i + 1]));
    }
    HL_FN double joint(const Line& line, int i) const // kg per unit of potential, between i and i + 1
    {
        const double per_length = plain_inverse(s.length[i] + s.length[i + 1]);
        return line.per_joint * section(i, per_length) * 2.0 * per_length;
    }
    HL_FN double fall(const Line& line, int i) const // kg per unit of saturation, from i + 1 down to i
    {
        if (line.per_fall == 0) return 0;
        return line.per_fall * section(i, plain_inverse(s.length[i] + s.length[i + 1]));
    }

    // Along the line while Newton's rounds go on.
    HL_FN double* saturation() const { return s.work0; }
    HL_FN double* joints() const { return s.work1; }
    HL_FN double potential(int i) const { return spreading_potential(saturation()[i]); }

    template <typename Team> HL_FN void operator()(const Team& team, int index) const
    {
        const YarnLine at = s.visited_line(index);
        const YarnParameters& yarn = at.yarn;
        const int a = at.first, b = at.last;
        if (yarn.liquid_diffusivity <= 0 || !team.any_of(a, b, [&](int i) { return s.liquid[i] > 0; })) {
            team.each(a, b, [&](int i) {
                s.flux[i] = 0;
                if (there_was != nullptr) there_was[i] = s.liquid[i];
            });
            return;
        }
        const double gravity = at.is_warp ? gravity_along_warp : gravity_along_weft, mass = dt * climate.density;
        const Line line{at, mass * yarn.liquid_diffusivity, gravity > 0 ? mass * yarn.fall * gravity : 0.0};
        team.each(a, b, [&](int i) {
            saturation()[i] = is_fed(i) ? 1.0 : s.liquid[i] * plain_inverse(capacity(i));
            joints()[i] = i < b - 1 ? joint(line, i) : 0.0;
            if (there_was != nullptr) there_was[i] = s.liquid[i];
        });
        bool closes_in = true;
        for (int round = 0; round < most_newton_rounds && closes_in; ++round) closes_in = newton_round(team, line);

        const auto passed = [&](int i) {
            if (is_fed(i) && is_fed(i + 1)) return 0.0; // both stand in the liquid, which bears itself
            return joints()[i] * (potential(i) - potential(i + 1)) - fall(line, i) * saturation()[i + 1];
        };
        const bool overflows = team.each_saying(a, b, [&](int i) {
            const double out = i < b - 1 ? passed(i) : 0.0, gained = (i > a ? passed(i - 1) : 0.0) - out;
            s.flux[i] = out;
            if (is_fed(i))
                s.supplied[i] -= gained;
            else
                s.liquid[i] += gained;
            return s.liquid[i] != bounded(i);
        });
        if (overflows) carry_rounding(team, at);
    }

    /// One Newton round by elimination; returns whether any saturation changed too much for it to be the last.
    template <typename Team> HL_FN bool newton_round(const Team& team, const Line& line) const
    {
        constexpr double little = 3e-6; // what a round leaves goes with the square of its change: some 1e-11
        const int a = line.at.first, b = line.at.last;
        const auto row = [&](int i) -> Equation {
            if (is_fed(i)) return {0, 1, 0, 0}; // cannot change
            const bool first = i == a, last = i == b - 1;
            const double own = saturation()[i], before = first ? 0.0 : saturation()[i - 1], next = last ? 0.0 : saturation()[i + 1];
            const double before_joint = first ? 0.0 : joints()[i - 1], next_joint = joints()[i];
            const double before_fall = first ? 0.0 : fall(line, i - 1), next_fall = last ? 0.0 : fall(line, i);
            const double cap = capacity(i);
            const double residual = cap * own - s.liquid[i] + before_joint * (spreading_potential(own) - spreading_potential(before)) +
                                    next_joint * (spreading_potential(own) - spreading_potential(next)) + before_fall * own -
                                    next_fall * next;
            return {-before_joint * before, cap + (before_joint + next_joint) * own + before_fall, -next_joint * next - next_fall,
                    -residual};
        };
        team.solve(a, b, row);
        return team.each_saying(a, b, [&](int i) {
            const double before = saturation()[i];
            double updated = before + team.found(a, i);
            updated = updated < 0 ? 0.0 : updated > 1 ? 1.0 : updated;
            saturation()[i] = updated;
            return updated - before >= little || before - updated >= little;
        });
    }

    /// What a place may hold of its liquid, kg.
    HL_FN double bounded(int i) const
    {
        const double cap = capacity(i);
        return s.liquid[i] < 0 ? 0.0 : s.liquid[i] > cap ? cap : s.liquid[i];
    }
    /// Passes on what rounding, or a full place below, left outside 0..capacity, so that neither bound nor the total is touched.
    template <typename Team> HL_FN void carry_rounding(const Team& team, const YarnLine& line) const
    {
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

/// Goes one after the other through the shells that divide a fibre. Their sections shrink towards the skin, where water enters first, all
/// by the same ratio; over all of them to a half.
struct ShellWalk {
    double ratio; ///< of a shell's section to that of the next one inwards
    double left;  ///< 2 - the section within, of the fibre's: from 2 in the middle to 1 at the skin

    /// Over the next shell towards the skin; its share of the fibre's section.
    HL_FN double outwards()
    {
        const double inner = left;
        left *= ratio;
        return inner - left;
    }
    HL_FN double inwards()
    {
        const double outer = left;
        left *= 1.0 / ratio;
        return left - outer;
    }
};
HL_FN ShellWalk from_the_middle(int shells) { return {std::exp2(-1.0 / shells), 2.0}; }
HL_FN ShellWalk from_the_skin(int shells) { return {std::exp2(-1.0 / shells), 1.0}; }

/// Water bound in a segment's fibres, kg, summed up over their shells.
HL_FN double bound_water(const Segments& s, const YarnParameters& yarn, int segment)
{
    ShellWalk walk = from_the_middle(s.shells);
    double regain = 0;
    for (int k = 0; k < s.shells; ++k) regain += s.regain[segment * s.shells + k] * walk.outwards();
    return regain * s.fibre_length(segment, yarn) * yarn.fibre_area * yarn.fibre_density;
}

/// Lines from one on.
template <typename Stage> struct FromLine {
    Stage stage;
    int first;

    template <typename Team> HL_FN void operator()(const Team& team, int index) const { stage(team, first + index); }
};

/// Heat along each yarn, by conduction and with the liquid that has just moved (flux).
struct ConductAlongYarn {
    Segments s;
    ClimateParameters climate;
    double dt;
    bool face_only = false; ///< cut ends are closed

    /// A line, and what its places share.
    struct Line {
        const YarnLine& at;
        double dry;   ///< J/(m K), heat capacity of the fibres
        double joint; ///< W m/K x s, of a length without liquid
        double wet;   ///< the same, for more of a kg/m of liquid
        double end;   ///< W/K x s, of a cut end in the air
    };
    HL_FN Line share(const YarnLine& line) const
    {
        const YarnParameters& yarn = line.yarn;
        const double area = yarn.fibre_area + yarn.pore_area, fibres = yarn.fibre_area / area;
        const double dry = parallel_conductivity(fibres, yarn.fibre_conductivity, 0.0);
        const double wet = parallel_conductivity(fibres, yarn.fibre_conductivity, 1.0) - dry;
        return {line, heat_capacity(yarn, 1.0, 0.0), dt * dry * area, dt * wet / climate.density,
                face_only ? 0.0 : dt * climate.heat_transfer * area};
    }
    HL_FN double joint(const Line& line, int i) const // W/K x s
    {
        const double per_distance = 2.0 * plain_inverse(s.length[i] + s.length[i + 1]);
        return (line.joint + line.wet * 0.5 * (s.liquid[i] + s.liquid[i + 1]) * per_distance) * per_distance;
    }

    HL_FN bool is_fed(int i) const { return s.fed != nullptr && s.fed[i] != 0; }

    template <typename Team> HL_FN void operator()(const Team& team, int index) const
    {
        const YarnLine at = s.visited_line(index);
        const int a = at.first, b = at.last;
        if (climate.air_warmth == 0 && !team.any_of(a, b, [&](int i) { return s.warmth[i] != 0; })) return;

        const Line line = share(at);
        const auto lose = [&](int i) {
            if (!is_fed(i)) s.lost[i] += line.end * (s.warmth[i] - climate.air_warmth);
        };
        team.solve(a, b, [&](int i) { return row(line, i); });
        team.each(a, b, [&](int i) {
            s.warmth[i] = team.found(a, i);
            if (at.starts && i == a) lose(i);
            if (at.stops && i == b - 1) lose(i);
        });
        if (s.fed == nullptr) return;
        const auto passed = [&](int i) {
            return joint(line, i) * (s.warmth[i] - s.warmth[i + 1]) + water_specific_heat * s.flux[i] * s.warmth[s.flux[i] > 0 ? i : i + 1];
        };
        team.each(a, b, [&](int i) {
            if (!is_fed(i)) return;
            if (i > a) s.lost[i] += passed(i - 1);
            if (i < b - 1) s.lost[i] -= passed(i);
        });
    }
    HL_FN Equation row(const Line& line, int i) const
    {
        if (is_fed(i)) return {0, 1, 0, 0}; // has the liquid's temperature that it hangs in
        const bool first = i == line.at.first, last = i == line.at.last - 1;
        const double in = first ? 0.0 : s.flux[i - 1]; // from the segment before
        const double out = s.flux[i];
        const double before_joint = first ? 0.0 : joint(line, i - 1), next_joint = last ? 0.0 : joint(line, i);
        const double came = (in > 0 ? in : 0.0) - (out < 0 ? out : 0.0);
        const double now = s.fibre_length(i, line.at.yarn) * line.dry + s.warm_water(i) * water_specific_heat;
        const double then = now - water_specific_heat * (in - out);
        const double ends = (first && line.at.starts ? line.end : 0.0) + (last && line.at.stops ? line.end : 0.0);
        return {-before_joint - water_specific_heat * (in > 0 ? in : 0.0),
                then + water_specific_heat * came + before_joint + next_joint + ends,
                -next_joint + water_specific_heat * (out < 0 ? out : 0.0), then * s.warmth[i] + ends * climate.air_warmth};
    }
};

/// Volume of air beside liquid (m3) in pores (m3), m3; never quite none, so that a full yarn's vapour has a concentration.
HL_FN double air_beside(double pores, double liquid)
{
    const double air = pores - liquid;
    return air > 1e-3 * pores ? air : 1e-3 * pores;
}
/// The same beside liquid in kg.
HL_FN double pore_air(double pores, double liquid, double density) { return air_beside(pores, liquid * plain_inverse(density)); }

/// What a step of a segment's own will do to its pore vapour, foreseen by whatever moves vapour from one segment to another: its liquid
/// feeds it, fibres and air take from it. A concentration c at the end of the step leaves known - pivot c for the neighbours.
struct VapourAtHome {
    double pivot; ///< m3
    double known; ///< kg
};

/// Foresees it for the segments of a yarn.
struct ForeseeVapour {
    const Segments& s;
    const ClimateParameters& climate;
    double per_density; ///< m3/kg, of liquid
    double rate;        ///< at which wet pores come to saturation in the step, see phase_change_rate()
    double bearable;    ///< kg per m of yarn: more would cool it by more than a few kelvin
    double dt;
    double to_air; ///< m3, through the face, where the cloth is one rectangle

    HL_FN ForeseeVapour(const Segments& segments, const ClimateParameters& air, const YarnParameters& yarn, double seconds,
                        double face_area, bool cools)
        : s(segments), climate(air), per_density(plain_inverse(air.density)),
          rate(seconds * phase_change_rate(yarn.fibre_area, yarn.fibre_radius, yarn.pore_area)), bearable(1e300), dt(seconds),
          to_air(seconds * air.mass_transfer * face_area)
    {
        constexpr double most_cooling = 3.0; // K
        if (cools) bearable = heat_capacity(yarn, 1.0, 0.0) * most_cooling / heat_of_evaporation(air.temperature);
    }

    HL_FN double air(int i) const { return air_beside(s.pores[i], s.liquid[i] * per_density); }
    HL_FN VapourAtHome operator()(int i) const
    {
        const double own_air = air(i), saturated = saturation_concentration(climate.temperature + s.warmth[i]);
        const double fed = supply(i, saturated);
        // Liquid that came since has squeezed the vapour; fibres are at peace with no more than saturation.
        const double squeezed = s.vapour[i] * plain_inverse(own_air), met = squeezed < saturated ? squeezed : saturated;
        const double out = to_air_at(i), there = vapour_over(i);
        return {own_air + s.uptake[i] + out + fed, s.vapour[i] + s.uptake[i] * met + fed * saturated + out * there};
    }
    HL_FN double to_air_at(int i) const { return s.whole() ? to_air : dt * s.air_over(i).mass_transfer * s.cell_area(i); } // m3
    HL_FN double vapour_over(int i) const { return s.whole() ? climate.vapour : s.air_over(i).vapour; }                    // kg/m3
    /// m3 of air that its liquid can bring to saturation: never more than it lasts for, nor than cools it by a few kelvin.
    HL_FN double supply(int i, double saturated) const
    {
        const double liquid = s.liquid[i];
        if (liquid <= 0) return 0;
        const double wanted = s.pores[i] * rate * wet_share(liquid * per_density * plain_inverse(s.pores[i]));
        const double most = s.length[i] * bearable, lasting = (liquid < most ? liquid : most) * plain_inverse(saturated);
        return wanted < lasting ? wanted : lasting;
    }
};

/// Vapour along each yarn, in its pores and beside it, and out of its ends; wet segments feed it from their liquid, and take the heat for
/// it. What the exchange that follows will take is foreseen, so that vapour goes exactly as far. Leaves the concentrations foreseen in
/// work2, the pivots in work1.
struct DiffuseVapourAlongYarn {
    Segments s;
    ClimateParameters climate;
    double dt;
    double face_area;
    bool heat;
    bool face_only = false; ///< cut ends are closed

    HL_FN double joint(const ForeseeVapour& foresee, const YarnParameters& yarn, int i) const // m3
    {
        const double own = foresee.air(i) * plain_inverse(s.length[i]), next = foresee.air(i + 1) * plain_inverse(s.length[i + 1]);
        const double narrow = own < next ? own : next;
        return dt * (yarn.vapour_diffusivity * narrow + yarn.open_vapour) * 2.0 * plain_inverse(s.length[i] + s.length[i + 1]);
    }
    HL_FN double cut_ends(const YarnLine& line, int i) const // m3, through the ends of the yarn to the air
    {
        const int ends = (line.starts && i == line.first ? 1 : 0) + (line.stops && i == line.last - 1 ? 1 : 0);
        if (face_only || ends == 0) return 0;
        const YarnParameters& yarn = line.yarn;
        const double air = pore_air(s.pores[i], s.liquid[i], climate.density);
        const double inside = 2.0 * (yarn.vapour_diffusivity * air / s.length[i] + yarn.open_vapour) / s.length[i];
        const double outside = climate.mass_transfer * (yarn.fibre_area + yarn.pore_area);
        return inside > 0 && outside > 0 ? ends * dt * inside * outside / (inside + outside) : 0.0;
    }

    HL_FN bool is_disturbed(const ForeseeVapour& foresee, int i) const
    {
        if (s.liquid[i] > 0) return true;
        const double there = foresee.vapour_over(i);
        const double difference = s.vapour[i] * plain_inverse(pore_air(s.pores[i], s.liquid[i], climate.density)) - there;
        return difference > 1e-9 * there || difference < -1e-9 * there;
    }

    template <typename Team> HL_FN void operator()(const Team& team, int index) const
    {
        const YarnLine line = s.visited_line(index);
        const int a = line.first, b = line.last;
        double *joints = s.work0, *pivot = s.work1, *concentration = s.work2;
        const ForeseeVapour foresee(s, climate, line.yarn, dt, face_area, heat);
        if (!team.any_of(a, b, [&](int i) { return is_disturbed(foresee, i); })) {
            team.each(a, b, [&](int i) {
                pivot[i] = foresee(i).pivot;
                concentration[i] = foresee.vapour_over(i);
            });
            return;
        }

        const auto row = [&](int i) -> Equation {
            const double before_joint = i > a ? joint(foresee, line.yarn, i - 1) : 0.0;
            const double next_joint = i < b - 1 ? joint(foresee, line.yarn, i) : 0.0;
            const VapourAtHome home = foresee(i);
            const double end = cut_ends(line, i);
            joints[i] = next_joint;
            pivot[i] = home.pivot;
            return {-before_joint, home.pivot + end + before_joint + next_joint, -next_joint, home.known + end * climate.vapour};
        };
        team.solve(a, b, row);
        // Masses follow from the fluxes of the solution, so vapour is neither made nor lost.
        team.each(a, b, [&](int i) {
            const double own = team.found(a, i);
            double gained = i < b - 1 ? joints[i] * (team.found(a, i + 1) - own) : 0.0;
            if (i > a) gained += joints[i - 1] * (team.found(a, i - 1) - own);
            concentration[i] = own;
            take(line, i, foresee, own, gained);
        });
    }
    HL_FN void take(const YarnLine& line, int i, const ForeseeVapour& foresee, double concentration, double gained) const
    {
        const double temperature = climate.temperature + s.warmth[i];
        const double saturated = saturation_concentration(temperature);
        const double evaporated = foresee.supply(i, saturated) * (saturated - concentration);
        if (const double end = cut_ends(line, i); end > 0) {
            const double left = end * (concentration - climate.vapour);
            gained -= left;
            s.evaporated[i] += left;
        }
        s.vapour[i] += gained + evaporated; // less than nothing is what fibres and air will give
        if (evaporated == 0) return;
        if (heat) {
            const double released = -heat_of_evaporation(temperature) * evaporated;
            const double warmth =
                s.warmth[i] + released * plain_inverse(heat_capacity(line.yarn, s.fibre_length(i, line.yarn), s.warm_water(i)));
            s.warmth[i] = warmth;
            s.released[i] += released;
            s.lost[i] += water_specific_heat * evaporated * warmth;
        }
        s.liquid[i] -= evaporated;
    }
};

} // namespace hygroloom
