// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The order of the free liquid's stages, written once: an executor goes through it on the host, stage by stage, or a GPU's threads go
// through it themselves.
#pragma once

#include "core/solver/order.h"
#include "core/solver/steps/absorption.h"
#include "core/solver/steps/cloth_field.h"
#include "core/solver/steps/contact.h"
#include "core/solver/steps/liquid.h"
#include "core/solver/steps/liquid_control.h"

namespace hygroloom::inline HL_PRECISION {

/// The liquid's steps up to the moment when it meets the yarns, or until its budget is spent. An Executor offers for_each, sort_into_cells,
/// loop and when. Sorting writes the particles to the other side; LiquidControl::side says on which they are in the end.
struct LiquidFlow {
    LiquidControl* control = nullptr;
    LiquidRules rules;
    Particles particles;    ///< on side 0
    SortedParticles sorted; ///< on side 1
    TextileShape textile;
    Beads beads;
    LiquidParameters liquid;
    Segments segments;
    Real wall_reach = 0; ///< m, how far walls are felt
    Room room;           ///< about the sample
    double density_tolerance = 0;
    bool absorbs = false; ///< whether any yarn takes up liquid from drops
    int* reach = nullptr; ///< see Reach
    int* order = nullptr; ///< of particles, for sorting
    int* key = nullptr;   ///< the cell of each
    int* start = nullptr; ///< of each cell, its first particle

    template <typename Executor> HL_FN void operator()(Executor& executor) const
    {
        int side = 0;
        executor.for_each("begin flow", 1, BeginFlow{control, rules});
        executor.loop(&control->goes, [&] { step(executor, side); });
        if (absorbs) executor.when(&control->drains, [&] { give_to_segments(executor, on(side), EndDraining{control}); });
    }

private:
    HL_FN Particles on(int side) const { return side == 0 ? particles : sorted.of(particles); }
    HL_FN Counted all_particles() const { return {&control->count, particles.room}; }

    template <typename Executor> HL_FN void step(Executor& executor, int& side) const
    {
        list_neighbours(executor, side);
        const Particles p = on(side);
        executor.for_each("cloth, surface", all_particles(), InTurn<FeelCloth, FindSurface>{{p, textile, beads}, {p, liquid}});
        executor.for_each("forces", all_particles(), FindForces{p, liquid});
        correct_pressure(executor, p);
        if (p.stress != nullptr) executor.for_each("stress", all_particles(), FindStress{p, liquid});
        const MeetYarns meet{p,
                             textile,
                             liquid.vessel,
                             wall_reach,
                             touching_in_spacings * rules.spacing,
                             Real(0.5) * rules.spacing,
                             &control->step,
                             room,
                             &control->dripped};
        executor.for_each("move", all_particles(),
                          Arrive{{p, &control->step, &control->fastest},
                                 meet,
                                 {p, &control->squares, &control->largest},
                                 {p, kept_pressure, control->moved, &control->dead}},
                          EndStep{control, rules, absorbs});
        if (absorbs) executor.when(&control->absorbs, [&] { give_to_segments(executor, p, EndAbsorbing{control, rules}); });
    }
    /// Lists neighbours and brings particles into the order of cells, unless what is listed still holds.
    template <typename Executor> HL_FN void list_neighbours(Executor& executor, int& side) const
    {
        const Particles p = on(side);
        executor.when(&control->begins, [&] {
            executor.for_each("begin step", all_particles(), BeginStep{p, Real(1), control->moved, &control->dead});
        });
        executor.for_each("farthest moved", all_particles(), FindFarthestMoved{p, control->moved, &control->farthest},
                          DecideListing{control, rules});
        executor.when(&control->lists, [&] {
            sort_particles(executor, p, on(1 - side));
            side = 1 - side;
            executor.for_each("neighbours", all_particles(), FindNeighbours{on(side), &control->grid, &control->skin});
        });
    }
    template <typename Executor> HL_FN void sort_particles(Executor& executor, const Particles& from, const Particles& to) const
    {
        const CellGrid* grid = &control->grid;
        executor.for_each("find box", all_particles(), FindBox{from, grid, control->box}, FitGrid{control});
        executor.sort_into_cells(FindCell{from, grid}, key, order, start, all_particles(), &control->dead_key);
        executor.for_each("reorder", all_particles(), Reorder{order, key, &control->dead_key, from, to}, LeaveDead{control});
    }
    template <typename Executor> HL_FN void correct_pressure(Executor& executor, const Particles& p) const
    {
        const auto round = [&](std::int64_t* error, const auto& end) {
            executor.for_each("pressure", all_particles(), CorrectPressure{p, liquid, error});
            executor.for_each("pressure force", all_particles(), FindPressureForce{p, liquid}, end);
        };
        for (int k = 1; k < fewest_pressure_rounds; ++k) round(nullptr, Nothing{});
        round(&control->error, EndRound{control, density_tolerance, fewest_pressure_rounds});
        executor.loop(&control->presses, [&] { round(&control->error, EndRound{control, density_tolerance, 1}); });
    }
    /// In turns where little is left in each particle, for in a turn a segment absorbs from one of them only.
    template <typename Executor, typename Next> HL_FN void give_to_segments(Executor& executor, const Particles& p, const Next& next) const
    {
        executor.when(&control->in_turns, [&] {
            for (int turn = 1; turn < absorbing_turns; ++turn) {
                touch_and_give(executor, p);
                executor.for_each("forget", all_particles(), ForgetContact{p, textile, segments.contact, nullptr});
            }
        });
        touch_and_give(executor, p);
        executor.for_each("forget", all_particles(), ForgetContact{p, textile, segments.contact, &control->left}, next);
    }
    template <typename Executor> HL_FN void touch_and_give(Executor& executor, const Particles& p) const
    {
        executor.for_each("touch", all_particles(), TouchSegments{p, textile, segments.contact});
        executor.for_each("give", all_particles(),
                          GiveToSegments{p, textile, segments, rules.density, &control->absorb_dt, {reach}, &control->absorbed});
    }
};

} // namespace hygroloom::inline HL_PRECISION
