// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A round of Newton's over a box of the cloth, by conjugate gradients (Hestenes and Stiefel 1952). What they are preconditioned with are
// the equations along lines: along ends, along picks, and along ends again, each with all that couples the classes of a place.
#pragma once

#include "core/solver/steps/whole_pores.h"

namespace hygroloom {

/// Lines in one direction, of one class that goes along them and of the room. The other class has no neighbours then: it is eliminated at
/// its place.
template <bool of_ends> struct WholeLines {
    const WholePores& w;

    static constexpr int goes = of_ends ? own_pores : crossed_pores, stays = of_ends ? crossed_pores : own_pores;
    /// Columns: of the class that stays, Pa/kg; then what the team makes of the equations of the others.
    static constexpr int of_stays = of_ends ? WholePores::on_ends : WholePores::on_picks, pivots = of_stays + 1;
    /// kg, at a place.
    struct Right {
        double goes, room, stays;
    };

    HL_FN double along(int which, int k) const { return of_ends ? w.along_end(which, k) : w.along_pick(which, k); }
    HL_FN double across(int which, int k) const { return of_ends ? w.along_pick(which, k) : w.along_end(which, k); }
    HL_FN double to_goes(int k) const { return w.box(PoreLines::own_crossed, k); } // kg/Pa, of the class that stays
    HL_FN double to_room(int k) const { return w.box(of_ends ? PoreLines::room_crossed : PoreLines::own_room, k); }
    HL_FN int number(int line, int i) const { return of_ends ? w.at(line, i) : w.at(i, line); }
    HL_FN int first(int line) const { return w.reach.first[of_ends ? line : w.box.ends + line]; }
    HL_FN int last(int line) const { return w.reach.last[of_ends ? line : w.box.ends + line]; }
    HL_FN Pair joints(int k) const // kg/Pa, to the next place
    {
        return of_ends ? Pair{w.joint_along_end(goes, k), w.joint_along_end(room_pores, k)}
                       : Pair{w.joint_along_pick(goes, k), w.joint_along_pick(room_pores, k)};
    }
    /// A place's equations without its neighbours on the line.
    HL_FN SymmetricMatrix pivot(int k) const
    {
        const PlaceBox& box = w.box;
        const double direct = box(of_ends ? PoreLines::own_room : PoreLines::room_crossed, k);
        const double held = box(WholePores::falls + stays, k) + across(stays, k); // what does not go on to the others
        const double per_stays = plain_inverse(held + to_goes(k) + to_room(k)), through = direct + to_goes(k) * to_room(k) * per_stays;
        box(of_stays, k) = per_stays;
        return {box(WholePores::falls + goes, k) + along(goes, k) + to_goes(k) * held * per_stays + through, -through,
                box(WholePores::falls + room_pores, k) + along(room_pores, k) + across(room_pores, k) + to_room(k) * held * per_stays +
                    through};
    }
    template <typename Team> HL_FN void factor(const Team& team, int line) const
    {
        team.factor_pairs(
            first(line), last(line), [&](int i) { return pivot(number(line, i)); }, [&](int i) { return joints(number(line, i)); },
            [&](int i) { return pivot_at(number(line, i)); });
    }
    HL_FN SymmetricColumns pivot_at(int k) const { return {&w.box(pivots, k), &w.box(pivots + 1, k), &w.box(pivots + 2, k)}; }
    /// Calls use(k, numbers of the three classes) for each place of a line.
    template <typename Team, typename RightAt, typename Use>
    HL_FN void solve(const Team& team, int line, const RightAt& right_at, const Use& use) const
    {
        team.solve_factored(
            first(line), last(line), [&](int i) { return pivot_at(number(line, i)).read(); },
            [&](int i) { return joints(number(line, i)); },
            [&](int i) {
                const int k = number(line, i);
                const Right right = right_at(k);
                const double brings = right.stays * w.box(of_stays, k);
                return Pair{right.goes + to_goes(k) * brings, right.room + to_room(k) * brings};
            },
            [&](int i, const Pair& x) {
                const int k = number(line, i);
                double found[3];
                found[goes] = x.first;
                found[room_pores] = x.second;
                found[stays] = (right_at(k).stays + to_goes(k) * x.first + to_room(k) * x.second) * w.box(of_stays, k);
                use(k, found);
            });
    }
};

/// Before a solution: along ends or picks.
template <bool of_ends> struct WholeFactor {
    WholePores w;
    static constexpr bool wide_along_lines = true;
    static constexpr int columns = 1; // of a team that solves pairs; none of them is used
    HL_FN static bool has_rings() { return false; }
    template <typename Team> HL_FN void operator()(const Team& team, int line) const { WholeLines<of_ends>{w}.factor(team, line); }
};

/// Goes its way as far as the last round found; then along ends.
struct WholeAlongEnds {
    WholePores w;
    static constexpr bool wide_along_lines = true;
    bool begins; ///< with all that is open
    static constexpr int columns = 1;
    HL_FN static bool has_rings() { return false; }

    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        const PlaceBox& box = w.box;
        const double along = w.sums->along;
        w.each_on_end(team, end, [&](int k) { begins ? begin(k) : go(k, along); });
        WholeLines<true>{w}.solve(
            team, end,
            [&](int k) {
                return WholeLines<true>::Right{box(WholePores::rest + own_pores, k), box(WholePores::rest + room_pores, k),
                                               box(WholePores::rest + crossed_pores, k)};
            },
            [&](int k, const double(&found)[3]) {
                for (int which = 0; which < 3; ++which) box(WholePores::solved + which, k) = found[which];
            });
    }
    HL_FN void begin(int k) const
    {
        for (int which = 0; which < 3; ++which) {
            w.box(WholePores::change + which, k) = w.box(WholePores::way + which, k) = 0;
            w.box(WholePores::rest + which, k) = -w.box(WholePores::open + which, k);
        }
    }
    HL_FN void go(int k, double along) const
    {
        for (int which = 0; which < 3; ++which) {
            w.box(WholePores::change + which, k) += along * w.box(WholePores::way + which, k);
            w.box(WholePores::rest + which, k) -= along * w.box(WholePores::answer + which, k);
        }
    }
};

struct WholeAlongPicks {
    WholePores w;
    static constexpr bool wide_along_lines = true;
    static constexpr int columns = 1;
    HL_FN static bool has_rings() { return false; }

    template <typename Team> HL_FN void operator()(const Team& team, int pick) const
    {
        WholeLines<false>{w}.solve(
            team, pick,
            [&](int k) {
                return WholeLines<false>::Right{w.brought_along_pick(WholePores::solved, crossed_pores, k),
                                                w.brought_along_pick(WholePores::solved, room_pores, k), 0.0};
            },
            [&](int k, const double(&found)[3]) {
                for (int which = 0; which < 3; ++which) w.box(WholePores::beside + which, k) = found[which];
            });
    }
};

/// The same of what picks have left; then what the preconditioner comes to.
struct WholeAlongEndsAgain {
    WholePores w;
    static constexpr bool wide_along_lines = true;
    static constexpr int columns = 1;
    HL_FN static bool has_rings() { return false; }

    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        const PlaceBox& box = w.box;
        WholeLines<true>{w}.solve(
            team, end,
            [&](int k) {
                return WholeLines<true>::Right{w.brought_along_end(WholePores::beside, own_pores, k),
                                               w.brought_along_end(WholePores::beside, room_pores, k), 0.0};
            },
            [&](int k, const double(&found)[3]) {
                for (int which = 0; which < 3; ++which)
                    box(WholePores::solved + which, k) += found[which] + box(WholePores::beside + which, k);
            });
        const double product = w.sum_on_end(team, end, [&](int k) {
            double sum = 0;
            for (int which = 0; which < 3; ++which) sum += box(WholePores::rest + which, k) * box(WholePores::solved + which, k);
            return sum;
        });
        team.each(0, 1, [&](int) { w.line_sums[end * WholePores::numbers_of_line] = product; });
    }
};

/// The next way.
struct WholeTurn {
    WholePores w;
    static constexpr bool wide_along_lines = true;
    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        const double kept = w.sums->kept;
        w.each_on_end(team, end, [&](int k) {
            for (int which = 0; which < 3; ++which) {
                double& way = w.box(WholePores::way + which, k);
                way = w.box(WholePores::solved + which, k) + kept * way;
            }
        });
    }
};

/// What the equations make of it.
struct WholeAnswer {
    WholePores w;
    static constexpr bool wide_along_lines = true;
    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        const double product = w.sum_on_end(team, end, [&](int k) { return answer(k); });
        team.each(0, 1, [&](int) { w.line_sums[end * WholePores::numbers_of_line] = product; });
    }
    HL_FN double answer(int k) const
    {
        const PlaceBox& box = w.box;
        const auto way = [&](int which) { return box(WholePores::way + which, k); };
        const double own = way(own_pores), room = way(room_pores), crossed = way(crossed_pores);
        const double ax = box(PoreLines::own_room, k) * (own - room), ab = box(PoreLines::own_crossed, k) * (own - crossed),
                     bx = box(PoreLines::room_crossed, k) * (crossed - room);
        double answers[3] = {ax + ab, -ax - bx, bx - ab};
        for (int which = 0; which < 3; ++which) answers[which] += box(WholePores::falls + which, k) * way(which);
        for (int which : {own_pores, room_pores})
            answers[which] += w.along_end(which, k) * way(which) - w.brought_along_end(WholePores::way, which, k);
        for (int which : {room_pores, crossed_pores})
            answers[which] += w.along_pick(which, k) * way(which) - w.brought_along_pick(WholePores::way, which, k);
        double product = 0;
        for (int which = 0; which < 3; ++which) {
            box(WholePores::answer + which, k) = answers[which];
            product += answers[which] * way(which);
        }
        return product;
    }
};

} // namespace hygroloom
