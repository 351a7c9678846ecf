// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the free liquid's steps decide as they go: their length, when neighbours are listed, how often pressure is corrected, when yarns
// absorb, when the liquid sleeps. It stands where the stages run, and stages of one element change it, so that no thread waits for an
// answer.
#pragma once

#include "core/physics/caps.h"
#include "core/physics/liquid.h"
#include "core/solver/steps/contact.h"
#include "core/solver/steps/liquid.h"

namespace hygroloom::inline HL_PRECISION {

constexpr Real touching_in_spacings = Real(0.1); // to a skin; the cloth's field keeps most particles farther off
// Of water sliding on yarn, per normal impulse; without a source. 0 and 1 change a drop's absorbency time on cotton by -2 and +8 %, its
// radius by 0.6 %.
constexpr Real friction_coefficient = Real(0.2);
constexpr int most_cells = 400000;           // of the grid that finds neighbours, if particles are not many more
constexpr Real skin_in_spacings = Real(0.2); // by which neighbours are listed too far, to last for several steps
/// Of sqrt(gamma / (rho spacing)), at which a swing at a particle's own frequency would carry it a twentieth of the spacing.
constexpr double resting_speed = 0.05;         // root of the mean square, over all particles, each times its size
constexpr double fastest_resting_speed = 0.25; // of any particle away from the cloth: a drip gets faster
constexpr double most_hurry = 8;               // how much faster liquid creeps that was woken than it would have unasked
constexpr int absorbing_turns = 4;             // of yarns, once particles are less than half full
constexpr int fewest_pressure_rounds = 3;
constexpr int most_pressure_rounds = 8;
constexpr int least_int = -0x7fffffff - 1;

/// What stays the same as long as a scene runs.
struct LiquidRules {
    Real spacing = 0;           ///< m
    double particle_mass = 0;   ///< kg
    double density = 0;         ///< kg/m3
    double surface_tension = 0; ///< N/m
    double capillary_dt = 0;    ///< s, longest step that surface waves allow
    double viscous_dt = 0;      ///< s, the same for viscosity
    double weight_dt = 0;       ///< s, the same for the weight of what stands in a vessel
    double courant = 0;         ///< spacings that a particle may go in a step
    double correction_time = 0; ///< s, over which what a step finds pressed together is corrected, however short the step
    int steps_between_absorption = 1;
    double stiffness = 0;    ///< delta x dt2
    double settle_share = 0; ///< of the liquid left, that must have been absorbed before what sleeps wakes; 0: it never sleeps
    double drag = 0;         ///< m2/s, 20 nu
    double thinnest2 = 0;    ///< m2, square of the thinnest yarn's half height

    /// Equal steps to a moment, none longer than dt: a sliver of a step would ask for an endless pressure.
    HL_FN static double steps_to(double time, double dt)
    {
        const double steps = std::ceil(time / dt - 1e-6);
        return steps > 1.0 ? steps : 1.0;
    }
    /// However slowly particles move, s.
    HL_FN double longest_step() const
    {
        const double flowing = capillary_dt < viscous_dt ? capillary_dt : viscous_dt;
        return flowing < weight_dt ? flowing : weight_dt;
    }
    /// In which a volume of liquid finds its shape, s.
    HL_FN double capillary_time(double volume) const { return hygroloom::capillary_time(volume, density, surface_tension); }
    HL_FN double advective_step(double speed) const { return courant * static_cast<double>(spacing) / (speed > 1e-6 ? speed : 1e-6); }
};

/// The free liquid's steps: where they are and what comes next.
struct LiquidControl {
    double time = 0, sync_time = 0; ///< s, now and when liquid and yarns meet
    double longest_dt = 0;          ///< s, of the next step
    double dt = 0;                  ///< s, of this step
    StepNumbers step;               ///< of this step
    int last = 0;                   ///< whether this step ends when liquid and yarns meet
    int count = 0;                  ///< particles, with those that died since neighbours were listed
    int side = 0;                   ///< where the particles are: see LiquidFlow
    int budget = 0;                 ///< steps to take before somebody else has a look
    std::int64_t steps = 0, rounds = 0, listings = 0;
    Flag goes;     ///< another step follows
    Flag begins;   ///< what neighbours read is not of this step yet
    Flag lists;    ///< neighbours must be listed
    Flag presses;  ///< another round of pressure follows
    Flag absorbs;  ///< yarns absorb from the particles in this step
    Flag in_turns; ///< when they do, in several turns: see GiveToSegments
    Flag drains;   ///< the liquid sleeps until liquid and yarns meet: it only drains

    CellGrid grid;
    int dead_key = 0;   ///< of particles that are no more: behind all cells
    Real skin = 0;      ///< m, by which neighbours are listed too far
    int listed_for = 0; ///< steps that have used the neighbours listed last; 0: list anew
    int round = 0;      ///< of pressure in this step

    double since_absorbed = 0;    ///< s since yarns last absorbed from drops
    double absorb_dt = 0;         ///< s, for which yarns absorb now, in each turn
    int steps_since_absorbed = 0; ///< of the liquid since yarns last absorbed
    int asleep = 0;
    double landing = 0;                         ///< s, when the last drop released meets the cloth
    double flight_end = 0;                      ///< s; until then all free liquid is drops that fall as bodies, without steps
    double flight_start = 0, flight_speed = 0;  ///< s, when they were released; m/s, how fast they fall now
    double roused = 0;                          ///< s, when the free liquid last landed or woke
    double settling = 0;                        ///< s, that it takes to settle then
    double mean_square = 0, largest_square = 0; ///< m2/s2, of speeds, over the last time of settling
    double fell_asleep = 0;                     ///< s, when
    double hurry = 1;                           ///< by which liquid that was woken creeps faster, to make up for the time it slept

    std::int64_t unseen = 0; ///< quanta: so little of the last drop on the cloth is not seen

    // Many elements add to these.
    int moved[6] = {};                             ///< see BeginStep
    int box[6] = {};                               ///< see FindBox
    std::int64_t left = 0;                         ///< quanta that particles held after yarns last absorbed, or when they were released
    std::int64_t above = 0;                        ///< of them over the cloth's middle, where yarns draw in their own step
    int farthest = 0;                              ///< see FindFarthestMoved
    int fastest = 0;                               ///< see MoveParticles
    int largest = 0;                               ///< see SumSpeeds
    std::int64_t dead = 0, error = 0, squares = 0; ///< see BeginStep, CorrectPressure, SumSpeeds
    std::int64_t dripped = 0;                      ///< quanta since the start
    std::int64_t absorbed = 0;                     ///< quanta since the liquid fell asleep
};

/// The same control on another machine, which has memory of its own and lists neighbours anew.
inline LiquidControl moved_to(LiquidControl control, const LiquidControl& own)
{
    control.grid = own.grid;
    control.listed_for = 0;
    return control;
}

/// Numbers of the next step, and what it counts from anew.
HL_FN void plan_step(LiquidControl& c, const LiquidRules& rules)
{
    const double left = c.sync_time - c.time, steps = LiquidRules::steps_to(left, c.longest_dt);
    c.last = steps == 1.0;
    c.dt = left / steps;
    c.step.dt = static_cast<Real>(c.dt);
    const double kept = 1.0 - c.dt / rules.correction_time;
    c.step.kept_excess = static_cast<Real>(kept > 0 ? kept : 0.0);
    // A sliver of a step would make speeds of roundings of the density.
    const double shortest = 0.1 * rules.correction_time, corrected_in = c.dt > shortest ? c.dt : shortest;
    c.step.stiffness = static_cast<Real>(rules.stiffness / (corrected_in * corrected_in));
    c.step.friction = static_cast<Real>(friction_coefficient / c.hurry);
    c.step.drag = static_cast<Real>(rules.drag * c.dt / rules.thinnest2 / c.hurry);
    c.fastest = c.largest = c.round = 0;
    c.error = c.squares = 0;
}

/// A drop of so many quanta has been released; what slept may be hit.
inline void count_drop(LiquidControl& c, std::int64_t water)
{
    c.left += water;
    c.above += water;
    c.unseen = static_cast<std::int64_t>(unseen_share * static_cast<double>(water));
    c.asleep = 0;
    c.hurry = 1;
}

/// Nothing has been found yet of what particles have moved since neighbours were listed.
HL_FN void forget_moves(LiquidControl& c)
{
    for (int& most : c.moved) most = least_int / 2;
    c.farthest = 0;
    c.dead = 0;
}

/// Wakes the liquid when enough of what is left was absorbed since it fell asleep to change its shape. What has changed is as large as
/// that, and so is the time in which it settles.
HL_FN void wake(LiquidControl& c, const LiquidRules& rules)
{
    const double absorbed = static_cast<double>(c.absorbed) * water_quantum / rules.particle_mass;
    const double left = static_cast<double>(c.left) * water_quantum / rules.particle_mass;
    if (absorbed < 1.0 || absorbed < rules.settle_share * left) return;
    c.asleep = 0;
    c.roused = c.time;
    c.settling = rules.capillary_time(absorbed * rules.particle_mass / rules.density);
    // To move as it would have meanwhile, it is less dragged on. Beyond the time a whole drop needs, little is left to move.
    const double slept = c.time - c.fell_asleep, whole = rules.capillary_time(left * rules.particle_mass / rules.density);
    const double due = slept / (most_hurry - 1) < whole ? slept / (most_hurry - 1) : whole;
    if (c.settling < due) c.settling = due;
    const double hurry = 1 + slept / c.settling;
    c.hurry = hurry < most_hurry ? hurry : most_hurry;
}

/// Yarns have absorbed nothing for dt longer; whether they absorb now, and if so, for how long a time, and whether in turns.
HL_FN bool absorb_after(LiquidControl& c, const LiquidRules& rules, double dt, bool now, int steps_between)
{
    c.since_absorbed += dt;
    if (!now && ++c.steps_since_absorbed < steps_between) return false;
    const double left = static_cast<double>(c.left) * water_quantum / rules.particle_mass;
    c.in_turns.on = left < 0.5 * c.count;
    c.absorb_dt = c.since_absorbed / (c.in_turns.on ? absorbing_turns : 1);
    c.since_absorbed = 0;
    c.left = 0;
    c.steps_since_absorbed = 0;
    return true;
}

/// Says what comes next: a step, rest up to the moment when liquid and yarns meet, or nothing.
HL_FN void decide_next(LiquidControl& c, const LiquidRules& rules)
{
    const bool flows = c.time < c.sync_time && c.count > 0;
    const bool drains = flows && c.asleep && absorb_after(c, rules, c.sync_time - c.time, true, 1);
    const bool goes = flows && !c.asleep && c.budget > 0;
    if (goes) plan_step(c, rules);
    c.drains.on = drains;
    c.goes.on = goes;
}

struct BeginFlow {
    LiquidControl* control;
    LiquidRules rules;
    HL_FN void operator()(int) const
    {
        control->side = 0;
        control->begins.on = 1;
        forget_moves(*control);
        if (control->asleep) wake(*control, rules);
        decide_next(*control, rules);
    }
};

/// Whether all that count are still listed: no two particles have come nearer to each other than by the skin, and few are dead.
struct DecideListing {
    LiquidControl* control;
    LiquidRules rules;
    HL_FN void operator()(int) const
    {
        LiquidControl& c = *control;
        const Real skin = skin_in_spacings * rules.spacing;
        // Twice the greatest displacement: as near as two may have come to each other.
        const double apart = 2.0 * std::sqrt(static_cast<double>(from_ordered_bits(c.farthest))) * static_cast<double>(rules.spacing);
        const bool fresh = c.listed_for == 0;
        const bool holds = !fresh && apart < 0.999 * static_cast<double>(c.skin) && 16 * c.dead < c.count;
        if (!holds) {
            const bool would_last = fresh || 2 * apart / c.listed_for < static_cast<double>(skin);
            c.skin = would_last ? skin : Real(0);
            c.listed_for = 0;
            ++c.listings;
            for (int& most : c.box) most = least_int;
        }
        ++c.listed_for;
        c.lists.on = !holds;
        c.begins.on = 0;
        forget_moves(c);
    }
};

/// The grid's box about the particles there are; wider cells where they lie so far apart that going through the cells would cost more.
struct FitGrid {
    LiquidControl* control;
    HL_FN void operator()(int) const
    {
        const int* box = control->box;
        CellGrid& g = control->grid;
        const int low[3] = {lowest(box[0]), lowest(box[1]), lowest(box[2])}, high[3] = {highest(box[3]), highest(box[4]), highest(box[5])};
        const std::int64_t most = most_cells > 2 * control->count ? most_cells : 2 * control->count;
        g.shift = 0;
        while (cells(low[0], high[0], g.shift) * cells(low[1], high[1], g.shift) * cells(low[2], high[2], g.shift) > most) ++g.shift;
        g.first_x = low[0] >> g.shift;
        g.first_y = low[1] >> g.shift;
        g.first_z = low[2] >> g.shift;
        g.nx = static_cast<int>(cells(low[0], high[0], g.shift));
        g.ny = static_cast<int>(cells(low[1], high[1], g.shift));
        g.nz = static_cast<int>(cells(low[2], high[2], g.shift));
        control->dead_key = g.cells();
    }

private:
    HL_FN static int lowest(int most) { return most == least_int ? 0 : -most; }
    HL_FN static int highest(int most) { return most > 0 ? most : 0; }
    HL_FN static std::int64_t cells(int low, int high, int shift) { return std::int64_t((high >> shift) - (low >> shift) + 1); }
};

/// After particles were brought to the other side in their order: the dead are left behind.
struct LeaveDead {
    LiquidControl* control;
    HL_FN void operator()(int) const
    {
        control->side = 1 - control->side;
        control->count = control->grid.start[control->grid.cells()];
    }
};

/// After rounds of pressure: whether another one must follow.
struct EndRound {
    LiquidControl* control;
    double density_tolerance;
    int rounds; ///< since it was asked last
    HL_FN void operator()(int) const
    {
        LiquidControl& c = *control;
        if (c.count > 0) c.rounds += rounds;
        c.round += rounds;
        const bool enough = static_cast<double>(c.error) * 1e-6 < density_tolerance * c.count || c.count == 0;
        c.error = 0;
        c.presses.on = c.round < most_pressure_rounds && !enough;
    }
};

/// After yarns have absorbed from liquid that sleeps: no particle counts any more where all of it is gone.
struct EndDraining {
    LiquidControl* control;
    HL_FN void operator()(int) const
    {
        if (control->left == 0) control->count = 0;
    }
};

/// After yarns have absorbed from particles, which have become smaller: what comes next.
struct EndAbsorbing {
    LiquidControl* control;
    LiquidRules rules;
    HL_FN void operator()(int) const
    {
        control->begins.on = 1;
        forget_moves(*control);
        decide_next(*control, rules);
    }
};

/// After particles were moved: capillary, advective and viscous limits of the next step; whether the liquid has come to rest: it falls
/// asleep, takes no steps and only drains; whether yarns absorb now, and if not, what comes next.
struct EndStep {
    LiquidControl* control;
    LiquidRules rules;
    bool absorbs; ///< whether any yarn does
    HL_FN void operator()(int) const
    {
        LiquidControl& c = *control;
        if (c.count > 0) {
            const double advective = rules.advective_step(static_cast<double>(from_ordered_bits(c.fastest)));
            c.longest_dt = advective < rules.longest_step() ? advective : rules.longest_step();
            ++c.steps;
        }
        --c.budget;
        c.time = c.last ? c.sync_time : c.time + c.dt;
        if (rules.settle_share > 0 && c.count > 0) watch(c);
        c.absorbs.on = absorbs && absorb_after(c, rules, c.dt, c.last, rules.steps_between_absorption);
        if (!c.absorbs.on) decide_next(c, rules);
    }

private:
    HL_FN void watch(LiquidControl& c) const
    {
        const double square = static_cast<double>(c.squares) * SumSpeeds::quantum / c.count;
        const double unit = rules.surface_tension / (rules.density * static_cast<double>(rules.spacing));
        // Means over the time of settling: a kick is no motion.
        const double share = c.dt < c.settling ? c.dt / c.settling : 1.0;
        c.mean_square += share * (square - c.mean_square);
        c.largest_square += share * (static_cast<double>(from_ordered_bits(c.largest)) - c.largest_square);
        if (c.time < c.landing) c.roused = c.time;
        const bool moves = c.mean_square > resting_speed * resting_speed * unit * c.hurry * c.hurry ||
                           c.largest_square > fastest_resting_speed * fastest_resting_speed * unit;
        c.asleep = !moves && c.time - c.roused >= c.settling;
        if (c.asleep) {
            c.absorbed = 0;
            c.fell_asleep = c.time;
            c.hurry = 1;
        }
    }
};

} // namespace hygroloom::inline HL_PRECISION
