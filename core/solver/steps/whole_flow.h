// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What passes in a box of the cloth by the suctions that a step has found: masses by fluxes, and the heat that they carry.
#pragma once

#include "core/solver/steps/whole_solution.h"

namespace hygroloom {

/// Whether each end's pores have room for what a solution leaves open at its places, and as much as it leaves too little; for each end, 1
/// if they have not.
struct WholeFits {
    WholePores w;
    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        const double over = w.sum_on_end(team, end, [&](int k) { return left_over(k, true); });
        const double room = w.sum_on_end(team, end, [&](int k) { return left_over(k, false); });
        const double held = w.sum_on_end(team, end, [&](int k) { return w.box(PoreLines::can_hold, k); }) - room;
        team.each(0, 1, [&](int) { w.line_sums[end * WholePores::numbers_of_line] = over > room || -over > held ? 1.0 : 0.0; });
    }
    /// kg that the place's classes do not hold, or that its end's pores have room for.
    HL_FN double left_over(int k, bool over) const
    {
        const PoreLines::Place p = w.place(w.box, k);
        double mass[3], left = 0;
        for (int which = 0; which < 3; ++which) {
            mass[which] = w.liquid(p, which) + w.comes(which, k) + w.from_pool(w.box, which, k);
            if (which == room_pores) mass[which] -= w.through_hole(w.box, w.room(p), k);
            left += WholePores::put(mass[which], 0, w.capacity(p, which));
        }
        for (int which = 0; which < 3 && left != 0; ++which) left = WholePores::put(mass[which], left, w.capacity(p, which));
        return over ? left : w.capacity(p, own_pores) - mass[own_pores];
    }
};

/// Masses move by the solution's fluxes; each class notes the suction at which it settles. Leaves in rest what there was before joints
/// passed any, and in flux what went along yarns, with the room's along ends.
struct WholeAccept {
    WholePores w;
    static constexpr bool wide_along_lines = true;
    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        const int picks = w.box.picks;
        const int first = w.first_on_end(end), last = w.last_on_end(end);
        const auto rests = [&](int pick) { return pick < first || pick >= last; };
        const bool overflows =
            team.each_saying(0, picks, [&](int pick) { return rests(pick) ? rest(w.at(end, pick)) : pass(w.at(end, pick)); });
        if (overflows) carry_rounding(team, end);
        team.each(0, picks, [&](int pick) {
            const int k = w.at(end, pick);
            rests(pick) ? w.stay(w.box, k) : w.settle(w.box, k);
        });
    }
    HL_FN bool rest(int k) const
    {
        const PoreLines::Place p = w.place(w.box, k);
        w.s.flux[p.own] = w.s.flux[p.crossed] = 0;
        return false;
    }
    HL_FN bool pass(int k) const
    {
        const PlaceBox& box = w.box;
        const PoreLines::Place p = w.place(box, k);
        std::int64_t drew[3] = {};
        if (w.pool.stands) {
            w.take_from_pool(box, p, k, drew);
            w.shed_through_hole(box, p, k);
        }
        const PoreRounds::Inflow passed = w.inflow(k);
        double mass[3];
        for (int which = 0; which < 3; ++which) {
            box(WholePores::rest + which, k) = w.liquid(p, which);
            mass[which] = w.liquid(p, which) + passed.in[which];
        }
        w.s.flux[p.own] = w.flux_along_end(own_pores, k) + w.flux_along_end(room_pores, k);
        w.s.flux[p.crossed] = w.flux_along_pick(crossed_pores, k);
        const std::int64_t had = drew[crossed_pores] != 0 ? w.s.offered[w.taker(p, crossed_pores)] : 0;
        const double came = mass[own_pores] + mass[room_pores] + mass[crossed_pores];
        const bool overflows = w.keep_in_bounds(p, mass, drew);
        const double kept = mass[own_pores] + mass[room_pores] + mass[crossed_pores];
        const bool hands_back = drew[own_pores] > 0 || drew[room_pores] > 0 || drew[crossed_pores] > 0;
        const double from_crossed =
            drew[crossed_pores] != 0 ? static_cast<double>(w.s.offered[w.taker(p, crossed_pores)] - had) * water_quantum : 0.0;
        box(handed_back + 1, k) = from_crossed;
        box(handed_back, k) = hands_back ? came - kept - from_crossed : 0.0;
        for (int which = 0; which < 3; ++which) w.liquid(p, which) = mass[which];
        return overflows;
    }
    static constexpr int handed_back = WholePores::way; ///< columns, kg to the pool: of the end's segment with the room, and of the pick's
    template <typename Team> HL_FN void carry_rounding(const Team& team, int end) const
    {
        const int begin = w.s.warp_of(w.box.first_end + end, w.box.first_pick);
        const WickAlongYarn wick{w.s, w.climate, w.dt, 0, 0};
        wick.carry_rounding(team, {w.s.yarn_of(begin), begin + w.first_on_end(end), begin + w.last_on_end(end), true, true, true});
    }
};

/// Where nothing flows.
struct WholeStay {
    WholePores w;
    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        team.each(0, w.box.picks, [&](int pick) { w.stay(w.box, w.at(end, pick)); });
    }
};

/// Heat that the liquid carries: that between yarns is as warm as the end's segment. What comes to a place has the temperature that the
/// place it comes from has at the step's end; across the line's direction the one found last.
template <bool of_ends> struct WholeWarm {
    WholePores w;
    static constexpr bool wide_along_lines = true;
    static constexpr int columns = 1;
    HL_FN static bool has_rings() { return false; }
    /// Columns, K, of the end's segment and of the pick's: as found last, and where those found now come.
    static constexpr int of_end = of_ends ? WholePores::solved : WholePores::beside, of_pick = of_end + 1;
    static constexpr int new_of_end = of_ends ? WholePores::beside : WholePores::solved;

    /// kg that pass to the next place: of the end's segment with the room, and of the pick's.
    HL_FN double on_end(int k) const { return w.s.flux[w.place(w.box, k).own]; }
    HL_FN double on_pick(int k) const { return w.s.flux[w.place(w.box, k).crossed]; }
    HL_FN double room_on_pick(int k) const { return w.flux_along_pick(room_pores, k); }
    /// kg from the end's segment and the room to the pick's.
    HL_FN double across(const PoreLines::Place& p, int k) const
    {
        double came =
            w.liquid(p, crossed_pores) - w.box(WholePores::rest + crossed_pores, k) + on_pick(k) + w.box(WholeAccept::handed_back + 1, k);
        if (k >= w.box.picks) came -= on_pick(k - w.box.picks);
        return came;
    }
    /// J/K of a segment before joints passed any liquid; that of the end with the room.
    HL_FN double before(const PoreLines::Place& p, bool end, int k) const
    {
        const int i = end ? p.own : p.crossed;
        const PlaceBox& box = w.box;
        const double liquid =
            end ? box(WholePores::rest + own_pores, k) + box(WholePores::rest + room_pores, k) : box(WholePores::rest + crossed_pores, k);
        return heat_capacity(w.yarn(p, end), w.s.fibre_length(i, w.yarn(p, end)), liquid + w.s.bound[i]);
    }
    HL_FN static double more(double value) { return value > 0 ? value : 0.0; }
    /// Calls add(kg, place it comes from) for what comes to a place along a direction: of fluxes to the next place.
    template <typename Flux, typename Add> HL_FN void each_inflow(int k, int step, const Flux& flux, const Add& add) const
    {
        if (k >= step)
            if (const double in = flux(k - step); in > 0) add(in, k - step);
        if (const double out = flux(k); out < 0) add(-out, k + step);
    }

    template <typename Team> HL_FN void operator()(const Team& team, int line) const
    {
        const PlaceBox& box = w.box;
        const WholeLines<of_ends> lines{w};
        const int first = lines.first(line), last = lines.last(line);
        const auto number = [&](int i) { return lines.number(line, i); };
        team.solve_pairs(
            first, last,
            [&](int i, bool& open) {
                open = true;
                return row(number(i), i == first, i + 1 == last);
            },
            [&](int i, const Pair& x) {
                box(new_of_end, number(i)) = x.first;
                box(new_of_end + 1, number(i)) = x.second;
            });
    }
    HL_FN PairEquation row(int k, bool first, bool last) const
    {
        const PlaceBox& box = w.box;
        const PoreLines::Place p = w.place(box, k);
        const double c = water_specific_heat, over = across(p, k);
        double own_end = before(p, true, k), own_pick = before(p, false, k);
        double right_end = own_end * w.s.warmth[p.own], right_pick = own_pick * w.s.warmth[p.crossed];
        Pair lower, upper;
        const auto lagged_end = [&](double in, int from) {
            own_end += c * in;
            right_end += c * in * box(of_end, from);
        };
        const auto lagged_pick = [&](double in, int from) {
            own_pick += c * in;
            right_pick += c * in * box(of_pick, from);
        };
        if constexpr (of_ends) {
            lower.first = first ? 0.0 : -c * more(on_end(k - 1));
            upper.first = last ? 0.0 : -c * more(-on_end(k));
            each_inflow(
                k, box.picks, [&](int i) { return room_on_pick(i); }, lagged_end);
            each_inflow(
                k, box.picks, [&](int i) { return on_pick(i); }, lagged_pick);
        } else {
            lower = {first ? 0.0 : -c * more(room_on_pick(k - box.picks)), first ? 0.0 : -c * more(on_pick(k - box.picks))};
            upper = {last ? 0.0 : -c * more(-room_on_pick(k)), last ? 0.0 : -c * more(-on_pick(k))};
            each_inflow(
                k, 1, [&](int i) { return on_end(i); }, lagged_end);
        }
        const double to_end = c * more(-over), to_pick = c * more(over);
        return {lower,
                {own_end + to_end - lower.first - upper.first, -to_end, -to_pick, own_pick + to_pick - lower.second - upper.second},
                upper,
                {right_end, right_pick}};
    }
};

/// Temperatures begin as they are.
struct WholeWarmBegin {
    WholePores w;
    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        w.each_on_end(team, end, [&](int k) {
            const PoreLines::Place p = w.place(w.box, k);
            w.box(WholePores::solved, k) = w.s.warmth[p.own];
            w.box(WholePores::solved + 1, k) = w.s.warmth[p.crossed];
        });
    }
};

/// Heat by the fluxes and the temperatures found for them, so that none is made or lost.
struct WholeWarmEnd {
    WholePores w;
    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        w.each_on_end(team, end, [&](int k) { warm(k); });
    }
    HL_FN void warm(int k) const
    {
        const WholeWarm<true> flows{w};
        const PlaceBox& box = w.box;
        const PoreLines::Place p = w.place(box, k);
        const double c = water_specific_heat, at_end = box(flows.of_end, k), at_pick = box(flows.of_pick, k), over = flows.across(p, k);
        double end_heat = flows.before(p, true, k) * w.s.warmth[p.own], pick_heat = flows.before(p, false, k) * w.s.warmth[p.crossed];
        const auto pass = [&](double& heat, int column, double in, double out, int k_before, int k_next) {
            if (k_before >= 0) heat += c * in * box(column, in > 0 ? k_before : k);
            heat -= c * out * box(column, out < 0 ? k_next : k);
        };
        pass(end_heat, flows.of_end, k > 0 ? flows.on_end(k - 1) : 0.0, flows.on_end(k), k - 1, k + 1);
        pass(end_heat, flows.of_end, k >= box.picks ? flows.room_on_pick(k - box.picks) : 0.0, flows.room_on_pick(k), k - box.picks,
             k + box.picks);
        pass(pick_heat, flows.of_pick, k >= box.picks ? flows.on_pick(k - box.picks) : 0.0, flows.on_pick(k), k - box.picks, k + box.picks);
        end_heat -= c * box(WholeAccept::handed_back, k) * w.s.warmth[p.own];
        pick_heat -= c * box(WholeAccept::handed_back + 1, k) * w.s.warmth[p.crossed];
        const double crosses = c * over * (over > 0 ? at_end : at_pick);
        end_heat -= crosses;
        pick_heat += crosses;
        const auto warmth = [&](double heat, bool of_end) {
            const int i = of_end ? p.own : p.crossed;
            const double water = w.s.bound[i] + w.liquid(p, of_end ? own_pores : crossed_pores) + (of_end ? w.liquid(p, room_pores) : 0.0);
            return heat / heat_capacity(w.yarn(p, of_end), w.s.fibre_length(i, w.yarn(p, of_end)), water);
        };
        w.s.warmth[p.own] = warmth(end_heat, true);
        w.s.warmth[p.crossed] = warmth(pick_heat, false);
    }
};

/// What has been carried is not carried again.
struct WholeForgetFlux {
    WholePores w;
    template <typename Team> HL_FN void operator()(const Team& team, int end) const
    {
        team.each(0, w.box.picks, [&](int pick) {
            const PoreLines::Place p = w.place(w.box, w.at(end, pick));
            w.s.flux[p.own] = w.s.flux[p.crossed] = 0;
        });
    }
};

} // namespace hygroloom
