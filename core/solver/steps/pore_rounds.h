// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The suctions along a line at a step's end. What classes hold is the only part that is not linear, and it falls with suction: there is one
// solution, whatever the step's length, and no suction lies outside those before.
#pragma once

#include "core/solver/steps/pore_line.h"

namespace hygroloom {

struct PoreRounds : PoreLines {
    /// kg from a place to the next, of the own pores (0) or of the room (1).
    template <typename Team> HL_FN double flux_along(const Line<Team>& line, int which, int i) const
    {
        const double joint = line(along + which, i);
        return joint > 0 ? joint * (line(suction + which, place_after(line, i)) - line(suction + which, i) - lift_after(i)) : 0.0;
    }
    template <typename Team> HL_FN double inflow_along(const Line<Team>& line, int which, int i) const
    {
        const int last = place_before(line, i);
        double in = 0;
        if (last != none) in += flux_along(line, which, last);
        if (place_after(line, i) != none) in -= flux_along(line, which, i);
        return in;
    }
    template <typename Places> HL_FN double from_room(const Places& line, int i) const // kg to the own pores
    {
        return line(own_room, i) * (line(suction + own_pores, i) - line(suction + room_pores, i));
    }
    template <typename Places> HL_FN double from_crossed(const Places& line, int i) const
    {
        return line(own_crossed, i) * (line(suction + own_pores, i) - line(suction + crossed_pores, i));
    }
    template <typename Places> HL_FN double from_crossed_to_room(const Places& line, int i) const
    {
        return line(room_crossed, i) * (line(suction + room_pores, i) - line(suction + crossed_pores, i));
    }
    /// kg; less than nothing goes back.
    template <typename Places> HL_FN double from_pool(const Places& line, int which, int i) const
    {
        if (!pool.stands) return 0;
        const double draws = line(feed + which, i) * (line(suction + which, i) + line(presses, i)), most = line(most_fed + which, i);
        return draws < most ? draws : most;
    }

    /// kg/Pa that pass through the hole of a crossing where a pool can press liquid through it.
    HL_FN double hole(const BetweenParameters& room, double pressure) const
    {
        const bool opens = pool.stands && pressure > room.holds_back;
        return opens ? climate.density * room.through * dt_across : 0.0;
    }
    /// kg out of a room.
    template <typename Places> HL_FN double through_hole(const Places& line, const BetweenParameters& room, int i) const
    {
        const double over = -line(suction + room_pores, i) - room.holds_back;
        return over > 0 ? hole(room, line(presses, i)) * over : 0.0;
    }

    /// What a class holds at its suction; nested: as if the bends that are not taken were straight.
    HL_FN static Held held(const PoreCourse& course, double suction, int bends_taken, bool nested)
    {
        Held held = course.at(suction);
        if (!nested) return held;
        double where[PoreCourse::bends], by[PoreCourse::bends];
        course.find_bends(where, by);
        for (int k = 0; k < PoreCourse::bends; ++k) {
            if ((bends_taken >> k & 1) != 0 || suction >= where[k]) continue;
            held.saturation += by[k] * (where[k] - suction);
            held.fall += by[k];
        }
        return held;
    }
    /// What is left of a place's balances, each class's.
    struct Balance {
        double left[3];  ///< kg more comes than is held
        double falls[3]; ///< kg/Pa, how what is held falls with suction
        bool open;       ///< too much is left
    };
    template <typename Team> HL_FN Balance balance(const Line<Team>& line, int i, bool nested) const
    {
        const double to_own = from_room(line, i), ab = from_crossed(line, i), bx = from_crossed_to_room(line, i);
        const double ab_all = line(own_crossed, i), ax_all = line(own_room, i), bx_all = line(room_crossed, i);
        const int last = place_before(line, i);
        constexpr double enough = 1e-10; // of the capacity
        return balance(line, i, nested, enough,
                       {{to_own + ab + inflow_along(line, 0, i), inflow_along(line, 1, i) - to_own + bx, -ab - bx},
                        {line(along, i) + (last == none ? 0.0 : line(along, last)) + ab_all + ax_all,
                         line(along + 1, i) + (last == none ? 0.0 : line(along + 1, last)) + ax_all + bx_all, ab_all + bx_all}});
    }
    /// What passes a place's joints.
    struct Inflow {
        double in[3];      ///< kg
        double coupled[3]; ///< kg/Pa, of all joints of a class
    };
    template <typename Places> HL_FN Balance balance(const Places& line, int i, bool nested, double enough, const Inflow& joints) const
    {
        constexpr double rounding = 1e-14;    // of what would flow by the whole suction
        constexpr double most_noise = 1e-6;   // of the capacity: a suction beyond all bounds does not excuse itself
        constexpr double least_fall = 1e-10;  // of the capacity over the entry suction, so that full pores do not leave their suction open
        constexpr double least_share = 1e-13; // of what couples them, so that elimination does not lose it among full pores in long steps
        const Place p = place(line, i);
        const double falls = through_hole(line, room(p), i), leak = falls > 0 ? hole(room(p), line(presses, i)) : 0.0;
        Balance found{{}, {}, false};
        for (int which = 0; which < 3; ++which) {
            const double cap = line(can_hold + which, i), fed = from_pool(line, which, i);
            const PoreCourse c = course(line, p, which, i);
            const Held h = held(c, line(suction + which, i), nested ? bends_taken(line, which, i) : 0, nested);
            const double out = which == room_pores ? falls : 0.0, leaks = which == room_pores ? leak : 0.0;
            const double over = joints.in[which] + fed - out - cap * (h.saturation - line(held_before + which, i));
            const double least = cap * least_fall / c.pores.entry + least_share * joints.coupled[which];
            found.left[which] = over;
            found.falls[which] = (cap * h.fall > least ? cap * h.fall : least) + leaks;
            if (pool.stands && fed < line(most_fed + which, i)) found.falls[which] += line(feed + which, i);
            const double flows = joints.coupled[which] + leaks + (pool.stands ? line(feed + which, i) : 0.0);
            const double rounded = rounding * flows * std::abs(line(suction + which, i)), most = most_noise * cap;
            const double noise = enough * cap + (rounded < most ? rounded : most);
            found.open = found.open || !(over <= noise && over >= -noise);
        }
        return found;
    }
    /// For the change of the own suction and of the room's; the crossed segment's follows from both. Says whether too much is left. The
    /// joint of a ring comes later: see solve_ring().
    template <typename Team> HL_FN PairEquation row(const Line<Team>& line, int i, bool nested, bool& open) const
    {
        if (is_fed(i)) return {{0, 0}, {1, 0, 0, 1}, {0, 0}, {0, 0}};
        const Balance at = balance(line, i, nested);
        open = open || at.open;
        const double ab = line(own_crossed, i), ax = line(own_room, i), bx = line(room_crossed, i);
        const double fall = at.falls[crossed_pores], of_crossed = plain_inverse(fall + ab + bx);
        line(response, i) = of_crossed;
        line(left, i) = at.left[crossed_pores];
        const Pair before_along{i > line.first ? line(along, i - 1) : 0.0, i > line.first ? line(along + 1, i - 1) : 0.0};
        const bool ends = i + 1 == line.last;
        const Pair next_along{ends ? 0.0 : line(along, i), ends ? 0.0 : line(along + 1, i)};
        const double through = ax + ab * bx * of_crossed, left_crossed = at.left[crossed_pores] * of_crossed;
        const double own = at.falls[own_pores] + before_along.first + next_along.first + ab * fall * of_crossed;
        const double room = at.falls[room_pores] + before_along.second + next_along.second + bx * fall * of_crossed;
        return {{-before_along.first, -before_along.second},
                {own + through, -through, -through, room + through},
                {-next_along.first, -next_along.second},
                {-(at.left[own_pores] + ab * left_crossed), -(at.left[room_pores] + bx * left_crossed)}};
    }
    template <typename Team> HL_FN RingEquation row_in_ring(const Line<Team>& line, int i, bool nested, bool& open) const
    {
        const PairEquation own = row(line, i, nested, open);
        const double leaves = (i == line.first ? 1.0 : 0.0) - (i + 1 == line.last ? 1.0 : 0.0);
        return {own.lower, own.pivot, own.upper, {own.right, diagonal({leaves, leaves})}};
    }
    /// By the solution; outside nested rounds for each class no further than to its next bend.
    template <typename Team> HL_FN void move(const Line<Team>& line, int i, const Pair& change, bool nested) const
    {
        if (is_fed(i)) return;
        const double crossed = line(own_crossed, i) * change.first + line(room_crossed, i) * change.second - line(left, i);
        const double changes[3] = {change.first, change.second, crossed * line(response, i)};
        const Place p = place(line, i);
        for (int which = 0; which < 3; ++which) {
            double& now = line(suction + which, i);
            const double next = now + changes[which];
            now = nested ? next : course(line, p, which, i).as_far_as_bends(now, next);
        }
    }
    /// Returns whether too much was left, so that suctions have moved.
    template <typename Team> HL_FN bool newton_round(const Line<Team>& line, bool nested) const
    {
        const auto change_by = [&](int i, const Pair& change) { move(line, i, change, nested); };
        if (!line.ring)
            return line.team.solve_pairs(
                line.first, line.last, [&](int i, bool& open) { return row(line, i, nested, open); }, change_by);
        const Pair joint{line(along, line.last - 1), line(along + 1, line.last - 1)};
        return line.team.solve_ring(
            line.first, line.last, [&](int i, bool& open) { return row_in_ring(line, i, nested, open); }, joint, change_by);
    }

    /// Bits of a class.
    template <typename Places> HL_FN int bends_taken(const Places& line, int which, int i) const
    {
        return static_cast<int>(line(taken, i)) >> which * PoreCourse::bends & ((1 << PoreCourse::bends) - 1);
    }
    template <typename Team> HL_FN void begin_anew(const Line<Team>& line, int i) const
    {
        for (int which = 0; which < 3; ++which) line(suction + which, i) = line(before + which, i);
        line(taken, i) = 0;
    }
    /// Takes the bends that suctions have passed; whether there are more of them than before.
    template <typename Team> HL_FN bool take_bends(const Line<Team>& line, int i) const
    {
        const Place p = place(line, i);
        const int had = static_cast<int>(line(taken, i));
        int has = had;
        for (int which = 0; which < 3; ++which) {
            double where[PoreCourse::bends], by[PoreCourse::bends];
            course(line, p, which, i).find_bends(where, by);
            for (int k = 0; k < PoreCourse::bends; ++k)
                if (line(suction + which, i) < where[k] && by[k] > 0) has |= 1 << (which * PoreCourse::bends + k);
        }
        line(taken, i) = has;
        return has != had;
    }
    /// Newton's rounds as they come, which mostly close in after a few; then nested ones (Casulli and Zanolli 2010), which do not depend on
    /// where they begin. Returns whether they close in.
    template <typename Team> HL_FN bool solve(const Line<Team>& line) const
    {
        constexpr int most_plain = 20;
        const int a = line.first, b = line.last;
        int round = 0;
        for (; round < most_plain && round < most_rounds; ++round)
            if (!newton_round(line, false)) return true;
        line.team.each(a, b, [&](int i) { begin_anew(line, i); });
        for (; round < most_rounds; ++round)
            if (!newton_round(line, true) && !line.team.each_saying(a, b, [&](int i) { return take_bends(line, i); })) return true;
        line.team.each(a, a + 1, [&](int) { atomic_add(unsolved, std::int64_t(1)); });
        return false;
    }
};

} // namespace hygroloom
