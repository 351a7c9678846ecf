// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The part of a yarn network's step in which liquid flows by suctions along ends and picks at once.
#pragma once

#include "core/solver/yarn_network.h"

namespace hygroloom {

/// All of the visited cloth at once, along ends and picks: an implicit Euler step whose suctions make a convex energy least. Then what
/// touching yarns pass. Returns whether the suctions were found; where they were not nothing has moved.
template <typename Executor> bool YarnNetwork<Executor>::flow_whole(double dt)
{
    const Unvisited out = region_.unvisited();
    PlaceBox box{out.ends_before, out.picks_before, yarns().visited_ends(), yarns().visited_picks()};
    const auto places = static_cast<std::size_t>(box.places());
    const std::size_t numbers = WholePores::whole_columns * places;
    if (whole_numbers_.size() < numbers) whole_numbers_.resize(numbers + numbers / 4);
    const auto line_sums = static_cast<std::size_t>(WholePores::numbers_of_line * box.ends);
    if (whole_line_sums_.size() < line_sums) whole_line_sums_.resize(2 * line_sums);
    const auto lines = static_cast<std::size_t>(box.ends + box.picks);
    if (whole_reach_.size() < 2 * lines) whole_reach_.resize(3 * lines);
    if (whole_sums_.size() == 0) whole_sums_.resize(1);
    box.numbers = whole_numbers_.data();

    Segments s = segments();
    s.room_with_warp = true;
    const WholePores w{{s, climate_, dt, dt, true, lift(true), standing_pool(), &totals_.data()->given, scene_->rules.suction_rounds,
                        &totals_.data()->shed, &totals_.data()->unsolved, true},
                       box,
                       lift(false),
                       0.0,
                       {whole_reach_.data(), whole_reach_.data() + lines},
                       whole_line_sums_.data(),
                       whole_sums_.data()};
    const auto ends = [&](const char* name, const auto& stage) { exec_.for_each_line(name, box.ends, box.picks, stage); };
    const auto sum = [&](SumLines::Of of) { exec_.for_each_line("whole, sum", 1, box.ends, SumLines{w.line_sums, box.ends, of, w.sums}); };
    ends("whole, look", WholeLook{w});
    ends("whole, couple", WholeCouple{w});
    sum(SumLines::moves);
    if (whole_sums_.read(0).moves > 0) {
        exec_.for_each_line("whole, reach", box.ends + box.picks, std::max(box.ends, box.picks), FindWholeReach{w});
        constexpr double rounding = 1e-10; // of the capacity
        for (double open = scene_->rules.suction_error;; open *= 1e-3) {
            if (!find_suctions(w, open)) return false;
            ends("whole, fits", WholeFits{w});
            sum(SumLines::moves);
            if (open < rounding || whole_sums_.read(0).moves == 0) break; // or in a yarn that is full all along
        }
        ends("whole, accept", WholeAccept{w});
        if (scene_->rules.heat) carry_heat(w, dt);
    } else
        ends("whole, stay", WholeStay{w});
    if (fields_.touching.size() > 0) flow_between_touching(dt, warp_first_);
    return true;
}

/// What is left open; and how the energy changes along the last change, if there was one.
template <typename Executor> template <typename Whole> WholeSums YarnNetwork<Executor>::balance_of(const Whole& w, bool changed)
{
    exec_.for_each_line("whole, balance", w.box.ends, w.box.picks, WholeBalance{w, changed});
    exec_.for_each_line("whole, sum", 1, w.box.ends, SumLines{w.line_sums, w.box.ends, SumLines::balance, w.sums});
    return whole_sums_.read(0);
}

/// By Newton's rounds, before each of which open places close alone. They leave little of what was open at first, so that what comes to
/// rest does, and no more than so much of the capacity.
template <typename Executor> template <typename Whole> bool YarnNetwork<Executor>::find_suctions(const Whole& whole, double open)
{
    constexpr double of_the_first = 0.01;
    Whole w = whole;
    constexpr int most_rounds = 60;
    constexpr double open_alone = 1e-4; // of the capacity
    const PlaceBox& box = w.box;
    bool stiff = false; // whether changes led past bends
    WholeSums now = balance_of(w, false);
    w.enough = std::min(open, of_the_first * now.worst);
    for (int round = 0; now.worst > 0; ++round) {
        if (round == most_rounds) return false;
        for (int turn = 0; turn < 2; ++turn) exec_.for_each_line("whole, sweep", box.ends, box.picks, WholeSweep{w, turn, open_alone});
        now = balance_of(w, false);
        if (!(now.worst > 0)) break;
        if (stiff) exec_.for_each_line("whole, stiff", box.ends, box.picks, WholeStiff{w});
        now = go_downhill(w, solve_round(w), stiff);
    }
    return true;
}

/// Goes along a round's change, by which the energy falls so much at first, to where it rises or falls by little more; to the change's end
/// where it still falls there. Where it rises steeply there, the rounds that follow take classes to be as stiff as this change found them,
/// until one falls short.
template <typename Executor>
template <typename Whole>
WholeSums YarnNetwork<Executor>::go_downhill(const Whole& w, double downhill, bool& stiff)
{
    constexpr int most_trials = 8;
    constexpr double level = 0.2, steep = 10.0, too_short = 0.5; // of downhill
    struct Place {
        double at, slope;
    } low{0, -downhill}, high{1, 0};
    double at = 0;
    const auto go = [&](double to) {
        exec_.for_each_line("whole, move", w.box.ends, w.box.picks, WholeMove{w, to - at});
        at = to;
        return balance_of(w, true);
    };
    WholeSums now = go(high.at);
    high.slope = now.slope;
    if (now.slope <= level * downhill) {
        if (now.slope < -too_short * downhill) stiff = false;
        return now;
    }
    if (now.slope > steep * downhill) {
        exec_.for_each_line("whole, stiffen", w.box.ends, w.box.picks, WholeStiffen{w, !stiff});
        stiff = true;
    }
    bool halves = false; // where a line through both slopes left most of the way between them
    for (int trial = 0; trial < most_trials && now.worst > 0 && std::abs(now.slope) > level * downhill; ++trial) {
        const double between = high.at - low.at;
        now = go(low.at + between * (halves ? 0.5 : std::clamp(low.slope / (low.slope - high.slope), 0.1, 0.9)));
        (now.slope > 0 ? high : low) = {at, now.slope};
        halves = high.at - low.at > 0.5 * between;
    }
    return now;
}

/// A round's change of suctions; returns how much the energy falls along it at first.
template <typename Executor> template <typename Whole> double YarnNetwork<Executor>::solve_round(const Whole& w)
{
    constexpr int most_turns = 400;
    constexpr double left = 0.01; // of what was open before: less would cost rounds, which are dear
    const PlaceBox& box = w.box;
    const auto ends = [&](const char* name, const auto& stage) { exec_.for_each_line(name, box.ends, box.picks, stage); };
    const auto sum = [&](SumLines::Of of) { exec_.for_each_line("whole, sum", 1, box.ends, SumLines{w.line_sums, box.ends, of, w.sums}); };
    const auto precondition = [&](bool begins) {
        ends("whole, along ends", WholeAlongEnds{w, begins});
        exec_.for_each_line("whole, along picks", box.picks, box.ends, WholeAlongPicks{w});
        ends("whole, along ends again", WholeAlongEndsAgain{w});
        sum(begins ? SumLines::first_product : SumLines::product);
    };
    ends("whole, factor", WholeFactor<true>{w});
    exec_.for_each_line("whole, factor", box.picks, box.ends, WholeFactor<false>{w});
    precondition(true);
    for (int turn = 0; turn < most_turns; ++turn) {
        ends("whole, turn", WholeTurn{w});
        ends("whole, answer", WholeAnswer{w});
        sum(SumLines::answer);
        precondition(false);
        const WholeSums now = whole_sums_.read(0);
        if (!(now.product > left * left * now.first_product)) break;
    }
    return whole_sums_.read(0).downhill;
}

/// Heat that has gone with the liquid; then what yarns conduct.
template <typename Executor> template <typename Whole> void YarnNetwork<Executor>::carry_heat(const Whole& w, double dt)
{
    constexpr int turns = 2;
    const PlaceBox& box = w.box;
    const auto ends = [&](const char* name, const auto& stage) { exec_.for_each_line(name, box.ends, box.picks, stage); };
    ends("whole, warmth", WholeWarmBegin{w});
    for (int turn = 0; turn < turns; ++turn) {
        ends("whole, warm along ends", WholeWarm<true>{w});
        exec_.for_each_line("whole, warm along picks", box.picks, box.ends, WholeWarm<false>{w});
    }
    ends("whole, warm", WholeWarmEnd{w});
    ends("whole, forget flux", WholeForgetFlux{w});
    each_line("conduct", ConductAlongYarn{w.s, climate_, dt, scene_->cloth.face_only});
}

} // namespace hygroloom
