// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The pores of all places of a box of the cloth at once: what couples them in both directions, and what a step leaves open. Each stage goes
// through the places of one end.
#pragma once

#include "core/solver/steps/pore_flow.h"

namespace hygroloom {

/// Sums over a box, and what a solution's rounds go on with.
struct WholeSums {
    double moves;         ///< places where more than next to nothing passes
    double worst;         ///< most that is left open, of a class' capacity
    double slope;         ///< of the energy along a round's change, J
    double product;       ///< of what is left and what the preconditioner makes of it
    double first_product; ///< in the first of a solution's rounds
    double along, kept;   ///< how far a round goes its way; how much of the last way the next one keeps
    double downhill;      ///< by how much the energy falls at first along all the ways so far, J
};

/// Places of a line where anything can pass, from its first to before its last: of each end, then of each pick.
struct WholeReach {
    int* first;
    int* last;
};

/// Classes at a place, in the order of PoreLines: the end's pores, the room, the pick's pores. Precondition: one rectangle without a bath.
struct WholePores : FlowAlongLines {
    PlaceBox box;
    double lift_across; ///< Pa, see PoreLines::lift; from an end to the next
    double enough;      ///< of the capacity: so much may be left open
    WholeReach reach;
    double* line_sums; ///< numbers_of_line of each end
    WholeSums* sums;

    static constexpr int numbers_of_line = 2;
    /// Beyond those of PoreLines; of three, one for each class.
    enum Column {
        along_picks = PoreLines::columns, ///< kg/Pa to the next end: the pick's pores, the room
        open = along_picks + 2,           ///< kg more comes than is held
        falls = open + 3,                 ///< kg/Pa, see PoreRounds::Balance
        change = falls + 3,               ///< Pa, of suctions in a round of Newton's
        rest = change + 3,                ///< kg, that its solution has left so far; then kg of liquid before joints pass any
        solved = rest + 3,                ///< Pa, of that by the preconditioner; then K, of the end's segment and of the pick's
        way = solved + 3,                 ///< Pa, in which the change goes next
        answer = way + 3,                 ///< kg, of the equations to that
        beside = answer + 3,              ///< Pa, what lines along picks add to solved
        on_ends = beside + 3,             ///< what WholeLines notes of a place's equations
        on_picks = on_ends + 4,
        stiff = on_picks + 4, ///< kg/Pa, how steep a class at least is taken to be, see WholeStiffen
        whole_columns = stiff + 3
    };

    HL_FN int at(int end, int pick) const { return end * box.picks + pick; }
    HL_FN int first_on_end(int end) const { return reach.first[end]; }
    HL_FN int last_on_end(int end) const { return reach.last[end]; }
    /// Calls f(place) for those of an end where anything can pass.
    template <typename Team, typename F> HL_FN void each_on_end(const Team& team, int end, const F& f) const
    {
        const int begin = at(end, 0);
        team.each(first_on_end(end), last_on_end(end), [&](int pick) { f(begin + pick); });
    }
    template <typename Team, typename F> HL_FN double sum_on_end(const Team& team, int end, const F& f) const
    {
        const int begin = at(end, 0);
        return team.sum(first_on_end(end), last_on_end(end), [&](int pick) { return f(begin + pick); });
    }
    HL_FN bool is_coupled(int k) const
    {
        return coupled(own_pores, k) + coupled(room_pores, k) + coupled(crossed_pores, k) > 0 || is_fed_at(k);
    }
    HL_FN bool is_fed_at(int k) const
    {
        return pool.stands && (box(feed + own_pores, k) > 0 || box(feed + room_pores, k) > 0 || box(feed + crossed_pores, k) > 0);
    }
    /// kg/Pa from a place to the next: on the same end, of its pores or of the room.
    HL_FN double joint_along_end(int which, int k) const { return box(along + which, k); }
    /// On the same pick, of its pores or of the room.
    HL_FN double joint_along_pick(int which, int k) const { return box(along_picks + (which == crossed_pores ? 0 : 1), k); }

    /// Finds what couples a place's classes with each other and with the next places'; whether anything does.
    HL_FN bool couple_whole(int end, int pick) const
    {
        const int k = at(end, pick);
        const Place p = place(box, k);
        const BetweenParameters& between = room(p);
        const End own = end_of(box, p, own_pores, k), middle = end_of(box, p, room_pores, k), crossed = end_of(box, p, crossed_pores, k);
        const double density = climate.density;
        bool moves = false;
        box(own_room, k) = coupling_across(middle, true, own, density * between.to_warp, moves);
        box(own_crossed, k) = coupling_across(own, false, crossed, density * between.yarns, moves);
        box(room_crossed, k) = coupling_across(middle, true, crossed, density * between.to_weft, moves);
        box(along, k) = box(along + 1, k) = box(along_picks, k) = box(along_picks + 1, k) = 0;
        const auto in_series = [density](double from, double to) {
            return from > 0 && to > 0 ? density * 2.0 * from * to / (from + to) : 0.0;
        };
        if (pick + 1 < box.picks) {
            const int next = k + 1;
            const Place q = place(box, next);
            const double yarns = density * along_yarn(yarn_of(p, own_pores), p.own, q.own);
            box(along, k) = coupling_along(own, end_of(box, q, own_pores, next), lift, yarns, 7, moves);
            const double rooms = in_series(between.along_warp * open_along(p, p.own), room(q).along_warp * open_along(q, q.own));
            box(along + 1, k) = coupling_along(middle, end_of(box, q, room_pores, next), lift, rooms, between.quarters_along_warp, moves);
        }
        if (end + 1 < box.ends) {
            const int next = k + box.picks;
            const Place q = place(box, next);
            const double yarns = density * along_yarn(yarn_of(p, crossed_pores), p.crossed, q.crossed);
            box(along_picks, k) = coupling_along(crossed, end_of(box, q, crossed_pores, next), lift_across, yarns, 7, moves);
            const double rooms = in_series(between.along_weft * open_along(p, p.crossed), room(q).along_weft * open_along(q, q.crossed));
            box(along_picks + 1, k) =
                coupling_along(middle, end_of(box, q, room_pores, next), lift_across, rooms, between.quarters_along_weft, moves);
        }
        const bool by_pool = pool.stands && couple_with_pool(box, p, k);
        return by_pool || moves;
    }

    /// kg from a place to the next on its end, of the end's pores or of the room.
    HL_FN double flux_along_end(int which, int k) const
    {
        const double joint = joint_along_end(which, k);
        return joint > 0 ? joint * (box(suction + which, k + 1) - box(suction + which, k) - lift) : 0.0;
    }
    HL_FN double flux_along_pick(int which, int k) const
    {
        const double joint = joint_along_pick(which, k);
        return joint > 0 ? joint * (box(suction + which, k + box.picks) - box(suction + which, k) - lift_across) : 0.0;
    }
    HL_FN double in_along_end(int which, int k) const { return (k > 0 ? flux_along_end(which, k - 1) : 0.0) - flux_along_end(which, k); }
    HL_FN double in_along_pick(int which, int k) const
    {
        return (k >= box.picks ? flux_along_pick(which, k - box.picks) : 0.0) - flux_along_pick(which, k);
    }
    /// kg that come to a class by its joints.
    HL_FN double comes(int which, int k) const
    {
        if (which == own_pores) return in_along_end(own_pores, k) + from_room(box, k) + from_crossed(box, k);
        if (which == crossed_pores) return in_along_pick(crossed_pores, k) - from_crossed(box, k) - from_crossed_to_room(box, k);
        return in_along_end(room_pores, k) + in_along_pick(room_pores, k) - from_room(box, k) + from_crossed_to_room(box, k);
    }
    HL_FN Inflow inflow(int k) const
    {
        Inflow found;
        for (int which = 0; which < 3; ++which) found.in[which] = comes(which, k);
        for (int which = 0; which < 3; ++which) found.coupled[which] = coupled(which, k);
        return found;
    }
    /// kg/Pa, of all joints of a class.
    HL_FN double coupled(int which, int k) const
    {
        double all = which == own_pores    ? box(own_room, k) + box(own_crossed, k)
                     : which == room_pores ? box(own_room, k) + box(room_crossed, k)
                                           : box(own_crossed, k) + box(room_crossed, k);
        if (which != crossed_pores) all += along_end(which, k);
        if (which != own_pores) all += along_pick(which, k);
        return all;
    }
    HL_FN double along_end(int which, int k) const { return joint_along_end(which, k) + (k > 0 ? joint_along_end(which, k - 1) : 0.0); }
    HL_FN double along_pick(int which, int k) const
    {
        return joint_along_pick(which, k) + (k >= box.picks ? joint_along_pick(which, k - box.picks) : 0.0);
    }
    /// Of a column of three numbers: what joints along ends bring to a place for the numbers of its neighbours.
    HL_FN double brought_along_end(int column, int which, int k) const
    {
        double brought = joint_along_end(which, k) > 0 ? joint_along_end(which, k) * box(column + which, k + 1) : 0.0;
        if (k > 0 && joint_along_end(which, k - 1) > 0) brought += joint_along_end(which, k - 1) * box(column + which, k - 1);
        return brought;
    }
    HL_FN double brought_along_pick(int column, int which, int k) const
    {
        const int step = box.picks;
        double brought = joint_along_pick(which, k) > 0 ? joint_along_pick(which, k) * box(column + which, k + step) : 0.0;
        if (k >= step && joint_along_pick(which, k - step) > 0)
            brought += joint_along_pick(which, k - step) * box(column + which, k - step);
        return brought;
    }

    /// Notes what a place leaves open and how that answers to suction; returns the most, of a class' capacity, where it is too much.
    HL_FN double balance_whole(int k) const
    {
        constexpr double never = 1e300;
        const Balance found = balance(box, k, false, enough, inflow(k));
        double worst = 0;
        for (int which = 0; which < 3; ++which) {
            box(open + which, k) = found.left[which];
            box(falls + which, k) = found.falls[which];
            const double part = std::abs(found.left[which]) * plain_inverse(box(can_hold + which, k));
            if (!(part < never)) return never; // no number
            worst = part > worst ? part : worst;
        }
        return found.open ? worst : 0.0;
    }
    /// Takes a class to where its own balance closes while all others stay.
    HL_FN void close_alone(const Place& p, int which, int k) const
    {
        constexpr int most = 24;
        constexpr double nothing = 1e-9; // of the capacity
        const double cap = box(can_hold + which, k), joints = coupled(which, k), least = cap * 1e-10 / retention(box, p, which, k).entry;
        double& now = box(suction + which, k);
        const double others = comes(which, k) - joints * now; // what comes is this and joints times the suction
        const PoreCourse held = course(box, p, which, k);
        double low = -1e300, high = 1e300;
        for (int round = 0; round < most; ++round) {
            const Held holds = held.at(now);
            const double fed = from_pool(box, which, k), out = which == room_pores ? through_hole(box, room(p), k) : 0.0;
            const double over = others + joints * now + fed - out - cap * (holds.saturation - box(held_before + which, k));
            if (std::abs(over) <= nothing * cap) return;
            (over > 0 ? high : low) = now;
            double slope = (cap * holds.fall > least ? cap * holds.fall : least) + joints;
            if (out > 0) slope += hole(room(p), box(presses, k));
            if (pool.stands && fed < box(most_fed + which, k)) slope += box(feed + which, k);
            double next = held.as_far_as_bends(now, now - over / slope);
            if (!(next > low && next < high)) next = 0.5 * (low + high);
            now = next;
        }
    }
};

// Stages over a box. Those that sum up leave it for each end in line_sums; SumLines adds that up.

struct WholeLook {
    WholePores w;
    static constexpr bool wide_along_lines = true;
    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        team.each(0, w.box.picks, [&](int pick) {
            const int k = w.at(end, pick);
            w.look_at(w.box, k);
            for (int which = 0; which < 3; ++which) { // of places that only lines in one direction reach
                w.box(WholePores::falls + which, k) = 1;
                w.box(WholePores::beside + which, k) = 0;
            }
        });
    }
};

struct WholeCouple {
    WholePores w;
    static constexpr bool wide_along_lines = true;
    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        const bool moves = team.each_saying(0, w.box.picks, [&](int pick) { return w.couple_whole(end, pick); });
        team.each(0, 1, [&](int) { w.line_sums[end * WholePores::numbers_of_line] = moves ? 1.0 : 0.0; });
    }
};

/// Where anything can pass, of each end, then of each pick.
struct FindWholeReach {
    WholePores w;
    template <typename Team> HL_FN void operator()(const Team& team, int line) const
    {
        const bool is_end = line < w.box.ends;
        const int count = is_end ? w.box.picks : w.box.ends, pick = line - w.box.ends;
        const auto coupled = [&](int i) { return w.is_coupled(is_end ? w.at(line, i) : w.at(i, pick)); };
        const double last = team.most(0, count, [&](int i) { return coupled(i) ? i + 1.0 : 0.0; });
        const double first = count - team.most(0, count, [&](int i) { return coupled(i) ? static_cast<double>(count - i) : 0.0; });
        team.each(0, 1, [&](int) {
            w.reach.first[line] = last > 0 ? static_cast<int>(first) : 0;
            w.reach.last[line] = static_cast<int>(last);
        });
    }
};

/// What is left open; and how the energy changes along the last change, if there was one.
struct WholeBalance {
    WholePores w;
    static constexpr bool wide_along_lines = true;
    bool changed;
    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        const double worst = team.most(w.first_on_end(end), w.last_on_end(end), [&](int pick) { return w.balance_whole(w.at(end, pick)); });
        const double slope = changed ? w.sum_on_end(team, end, [&](int k) { return along_change(k); }) : 0.0;
        team.each(0, 1, [&](int) {
            w.line_sums[end * WholePores::numbers_of_line] = worst;
            w.line_sums[end * WholePores::numbers_of_line + 1] = slope;
        });
    }
    HL_FN double along_change(int k) const
    {
        double slope = 0;
        for (int which = 0; which < 3; ++which) slope += w.box(WholePores::open + which, k) * w.box(WholePores::change + which, k);
        return slope;
    }
};

/// Places that are open by more than a bound, each alone; every other one, as on a chessboard.
struct WholeSweep {
    WholePores w;
    static constexpr bool wide_along_lines = true;
    int colour;
    double bound; ///< of the capacity
    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        team.each(w.first_on_end(end), w.last_on_end(end), [&](int pick) {
            if (((w.box.first_end + end + w.box.first_pick + pick) & 1) == colour) close(w.at(end, pick));
        });
    }
    HL_FN void close(int k) const
    {
        bool is_open = false;
        for (int which = 0; which < 3; ++which)
            is_open = is_open || std::abs(w.box(WholePores::open + which, k)) > bound * w.box(PoreLines::can_hold + which, k);
        if (!is_open) return;
        const PoreLines::Place p = w.place(w.box, k);
        for (int which = 0; which < 3; ++which) w.close_alone(p, which, k);
    }
};

/// Suctions by some of the change.
struct WholeMove {
    WholePores w;
    static constexpr bool wide_along_lines = true;
    double by;
    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        w.each_on_end(team, end, [&](int k) {
            for (int which = 0; which < 3; ++which) w.box(PoreLines::suction + which, k) += by * w.box(WholePores::change + which, k);
        });
    }
};

/// Notes how steep classes are on the way of a change that leads past bends. The tangent where it begins knows nothing of them. A dry room
/// that hardly anything joins has none at all: it would go anywhere and keep all others from going their ways.
struct WholeStiffen {
    WholePores w;
    static constexpr bool wide_along_lines = true;
    bool first; ///< of a solution
    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        w.each_on_end(team, end, [&](int k) {
            for (int which = 0; which < 3; ++which) note(which, k);
        });
    }
    HL_FN void note(int which, int k) const
    {
        constexpr double much = 2.0; // steeper than where it begins
        const PlaceBox& box = w.box;
        const double change = box(WholePores::change + which, k), ends = box(PoreLines::suction + which, k),
                     cap = box(PoreLines::can_hold + which, k);
        double& stiff = box(WholePores::stiff + which, k);
        if (first) stiff = 0;
        if (change == 0) return;
        const PoreCourse held = w.course(box, w.place(box, k), which, k);
        const Held begins = held.at(ends - change);
        const double on_the_way = cap * (begins.saturation - held.at(ends).saturation) / change;
        if (on_the_way > much * cap * begins.fall && on_the_way > stiff) stiff = on_the_way;
    }
};

/// Then rounds take them to be as steep.
struct WholeStiff {
    WholePores w;
    static constexpr bool wide_along_lines = true;
    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        w.each_on_end(team, end, [&](int k) {
            for (int which = 0; which < 3; ++which) {
                double& falls = w.box(WholePores::falls + which, k);
                const double stiff = w.box(WholePores::stiff + which, k);
                falls = stiff > falls ? stiff : falls;
            }
        });
    }
};

/// What line_sums come to, and what follows from it.
struct SumLines {
    enum Of { moves, balance, product, first_product, answer };
    const double* line_sums;
    int ends;
    Of of;
    WholeSums* sums;

    template <typename Team> HL_FN void operator()(const Team& team, int) const
    {
        const auto number = [&](int k) { return [this, k](int end) { return line_sums[end * WholePores::numbers_of_line + k]; }; };
        const double first = of == balance ? team.most(0, ends, number(0)) : team.sum(0, ends, number(0));
        const double second = of == balance ? team.sum(0, ends, number(1)) : 0.0;
        team.each(0, 1, [&](int) { note(first, second); });
    }
    HL_FN void note(double first, double second) const
    {
        switch (of) {
        case moves: sums->moves = first; break;
        case balance:
            sums->worst = first;
            sums->slope = second;
            break;
        case first_product:
            sums->product = sums->first_product = first;
            sums->kept = sums->along = sums->downhill = 0;
            break;
        case product:
            sums->kept = first / sums->product;
            sums->product = first;
            break;
        case answer:
            sums->along = sums->product / first;
            sums->downhill += sums->along * sums->product;
            break;
        }
    }
};

} // namespace hygroloom
