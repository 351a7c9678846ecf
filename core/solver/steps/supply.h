// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Liquid that comes to the yarns without drops: from a bath they hang in, a pool on a face, or an even feed.
#pragma once

#include "core/base/portable.h"
#include "core/solver/steps/pore_flow.h"

namespace hygroloom {

/// Segments that hang in the liquid are full and have its temperature.
struct KeepFed {
    Segments s;
    double density;

    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        if (s.fed[i] == 0) return;
        const YarnParameters& yarn = s.yarn_of(i);
        s.lost[i] += heat_capacity(yarn, s.fibre_length(i, yarn), s.warm_water(i)) * s.warmth[i];
        s.warmth[i] = 0;
        s.supplied[i] += density * s.pores[i] - s.liquid[i];
        s.liquid[i] = density * s.pores[i];
        if (s.between == nullptr || !s.is_warp(i)) return;
        s.supplied[i] += density * s.room[i] - s.between[i];
        s.between[i] = density * s.room[i];
    }
};

/// What free liquid passes into: a segment, or the room between the yarns of a crossing. Numbered as SegmentCount::takers.
struct Taker {
    const Segments& s;
    double density;
    int number;
    double pressure = 0; ///< Pa over the air's, of the liquid
    int at_face = 1;     ///< on which it lies: 1 on top, 0 at the bottom

    HL_FN bool is_room() const { return number >= 2 * s.crossings(); }
    HL_FN int crossing() const { return is_room() ? number - 2 * s.crossings() : s.crossing_of(number); }
    HL_FN double capacity() const { return density * (is_room() ? s.room[crossing()] : s.pores[number]); } // kg
    HL_FN double held() const { return is_room() ? s.between[crossing()] : s.liquid[number]; }
    HL_FN double room() const { return capacity() - held() - static_cast<double>(s.absorbed[number]) * water_quantum; }
    /// kg that it draws in dt from liquid at no suction on one of its faces, however much room there is. Hairs hold drops off dry yarns.
    HL_FN double draws(double dt, double room, bool from_drop = false) const
    {
        if (s.suction == nullptr) {
            const YarnParameters& yarn = s.yarn_of(number);
            return dt * yarn.intake_flux * yarn.face_area * room / capacity();
        }
        const PoresFound pores = found();
        const double draws = density * dt * conductance(pores, from_drop) * pores.suction;
        return draws > 0 ? draws : 0.0;
    }
    /// The same from a cap that stands on the face, where liquid flows by suction.
    HL_FN double draws_from_cap(double dt) const { return density * dt * pull(true); }
    static constexpr double most_pull = 1e6; ///< Pa
    /// m3/s, from liquid on one of its faces, where liquid flows by suction.
    HL_FN double pull(bool from_drop = false) const
    {
        const PoresFound pores = found();
        const double by = pores.suction + pressure;
        return by > 0 ? conductance(pores, from_drop) * (by < most_pull ? by : most_pull) : 0.0;
    }

private:
    HL_FN PoresFound found() const
    {
        const FindPores find{s, density};
        if (is_room()) return find.between(crossing(), at().between, find.condition_of_room(crossing(), at().between, true));
        return find.segment(number, s.yarn_of(number), face());
    }
    HL_FN int face() const { return s.face_of(crossing(), s.is_warp(number)); }
    HL_FN double conductance(const PoresFound& pores, bool from_drop) const
    {
        if (is_room()) {
            const double lets_in = pores.is_connected() || FindPores{s, density}.wet_yarns(crossing()) > 0 ? 1.0 : 0.0;
            return FindPores{s, density}.permeability_of_room(crossing(), at().between) * at().between.face *
                   at().between.lets_in_from_face(lets_in, at_face, pressure);
        }
        const YarnParameters& yarn = s.yarn_of(number);
        const double lets_in = yarn.on_face[face()].lets_in_from_face(pores.is_connected(), from_drop, pressure);
        return yarn.face_conductance * (face() == at_face ? lets_in : at().between.lets_in_from_face(lets_in, at_face, pressure));
    }
    HL_FN const CrossingParameters& at() const { return s.crossing_at(crossing() / s.picks, crossing() % s.picks); }
};

/// Where a face is fed: within a circle.
struct FedFace {
    bool top = true;
    double radius = 0; ///< m; less than 0: the whole face
    double warp_pitch = 0, weft_pitch = 0;
    int places = 1;      ///< along each side of a crossing's cell that are looked at; more in bundles of yarns
    double x = 0, y = 0; ///< m, its middle, from the sample's

    /// Part of a segment that lies on the fed face, and there within the circle.
    HL_FN double share(const Segments& s, int i) const
    {
        const int crossing = s.crossing_of(i);
        const double warp = s.warp_up_share ? static_cast<double>(s.warp_up_share[crossing]) : s.warp_up[crossing] != 0 ? 1.0 : 0.0;
        const double on_face = s.is_warp(i) == top ? warp : 1.0 - warp;
        return radius < 0 || on_face <= 0 ? on_face : on_face * places_inside(s, crossing) / (places * places);
    }
    HL_FN int places_inside(const Segments& s, int crossing) const
    {
        const double across = (crossing / s.picks - 0.5 * (s.ends - 1)) * warp_pitch - x,
                     along = (crossing % s.picks - 0.5 * (s.picks - 1)) * weft_pitch - y;
        const double from_middle = std::sqrt(across * across + along * along), to_corner = 0.5 * (warp_pitch + weft_pitch); // or less far
        if (from_middle > radius + to_corner) return 0;
        if (from_middle < radius - to_corner) return places * places;
        int inside = 0;
        for (int place = 0; place < places * places; ++place)
            inside += is_inside(s, crossing, beside(place / places), beside(place % places));
        return inside;
    }
    HL_FN double beside(int place) const { return (place + 0.5) / places - 0.5; }
    HL_FN bool is_inside(const Segments& s, int crossing, double beside_end, double beside_pick) const
    {
        const double across = (crossing / s.picks + beside_end - 0.5 * (s.ends - 1)) * warp_pitch - x,
                     along = (crossing % s.picks + beside_pick - 0.5 * (s.picks - 1)) * weft_pitch - y;
        return across * across + along * along <= radius * radius;
    }
};

/// What stages count for the host in a step of the yarns.
struct YarnTotals {
    std::int64_t asked = 0, given = 0; ///< quanta
    std::int64_t shed = 0;             ///< quanta, through holes
    std::int64_t unsolved = 0;         ///< lines, see FlowAlongLines
    std::int64_t swollen = 0;          ///< segments, see Swell
    std::int64_t pressed_out = 0;      ///< quanta, see PressOut
    std::int64_t wicking_error = 0;    ///< quanta
    std::int64_t bound_error = 0;      ///< quanta
    std::int64_t heat_error = 0;       ///< see EstimateExchange
    int largest_change = 0;            ///< of saturation: see TrackChange
    int reach[4] = {-1, -1, -1, -1};   ///< where liquid, vapour or heat has come: see Reach
};

/// What each fed segment could take now, in quanta, summed up.
struct AskPool {
    Segments s;
    FedFace face;
    double density;
    double dt;
    double evenly; ///< kg offered to each in this step; less than 0: as much as suction draws through its skin
    std::int64_t* total;

    HL_FN std::int64_t wanted(int i) const
    {
        const double share = face.share(s, i);
        if (share <= 0) return 0;
        const Taker taker{s, density, i};
        const double room = taker.room();
        if (room <= 0) return 0;
        const double drawn = share * (evenly >= 0 ? evenly : taker.draws(dt, room));
        return static_cast<std::int64_t>((drawn < room ? drawn : room) / water_quantum);
    }
    HL_FN std::int64_t operator()(int index) const { return wanted(s.visited_segment(index)); }
};

/// A skin under the cloth sweats: each crossing's share goes to its yarns that lie on the skin, then to the room between them, as much as
/// they draw and have room for; the rest stays on the skin, and what that does not hold drips.
struct SweatFromSkin {
    Segments s;
    double density;
    double seconds; ///< of sweating at the scene's rates
    double dt;
    double holds;        ///< m of liquid
    std::int64_t* total; ///< quanta that came
    std::int64_t* drips; ///< quanta

    HL_FN void operator()(int index) const
    {
        const int crossing = s.visited_crossing(index), end = crossing / s.picks, pick = crossing % s.picks;
        const double area = s.panels.cell_area[s.panels.of_pick[pick]];
        const auto came = static_cast<std::int64_t>(s.sweat[crossing] * area * density * seconds / water_quantum);
        std::int64_t& skin = s.on_skin[crossing];
        skin += came;
        if (came != 0) atomic_add(total, came);
        if (skin <= 0) return;
        const FedFace face{s.panels.skin_on_top[s.panels.of_pick[pick]] != 0, -1.0};
        const std::int64_t offered = skin;
        const int weft = s.weft_of(end, pick);
        skin -= take(crossing, face, face.share(s, crossing), offered);
        skin -= take(weft, face, face.share(s, weft), offered);
        if (skin > 0) skin -= take(2 * s.crossings() + crossing, face, 1.0, skin); // the room between the yarns, once one of them is wet
        const auto most = static_cast<std::int64_t>(holds * area * density / water_quantum);
        if (skin <= most) return;
        atomic_add(drips, skin - most);
        skin = most;
    }
    /// Quanta that a taker takes of its share of what is offered.
    HL_FN std::int64_t take(int number, const FedFace& face, double share, std::int64_t offered) const
    {
        const Taker taker{s, density, number, 0.0, face.top ? 1 : 0};
        const double room = taker.room();
        if (share <= 0 || room <= 0) return 0;
        const double draws = share * taker.draws(dt, room), wanted = (draws < room ? draws : room) / water_quantum;
        const double there = share * static_cast<double>(offered);
        const auto quanta = static_cast<std::int64_t>(wanted < there ? wanted : there);
        s.absorbed[number] += quanta;
        return quanta;
    }
};

/// How much each taker draws from a pool on a face, summed up.
struct WeighPool {
    Segments s;
    FedFace face;
    double density;
    double pressure; ///< Pa over the air's
    double unit;     ///< m3/s, so large that the sum is counted
    std::int64_t* total;

    HL_FN std::int64_t weight(int taker) const
    {
        const int crossing = taker - 2 * s.crossings();
        const double inside = crossing >= 0 ? face.places_inside(s, crossing) : 0.0;
        const double share = crossing >= 0 ? inside / (face.places * face.places) : face.share(s, taker);
        return share > 0 ? static_cast<std::int64_t>(share * Taker{s, density, taker, pressure, face.top ? 1 : 0}.pull() / unit) : 0;
    }
    HL_FN std::int64_t operator()(int index) const
    {
        const int i = s.visited_segment(index);
        return weight(i) + (s.is_warp(i) ? weight(2 * s.crossings() + i) : 0);
    }
};

/// Offers each taker its share of a pool.
struct OfferPool {
    WeighPool weigh;
    std::int64_t standing; ///< quanta

    HL_FN void operator()(int index) const
    {
        const Segments& s = weigh.s;
        const int i = s.visited_segment(index);
        offer(i);
        if (s.is_warp(i)) offer(2 * s.crossings() + i);
    }
    HL_FN void offer(int taker) const
    {
        const double share = static_cast<double>(weigh.weight(taker)) / static_cast<double>(*weigh.total) * (1.0 - 1e-12);
        weigh.s.offered[taker] = *weigh.total > 0 ? static_cast<std::int64_t>(share * static_cast<double>(standing)) : 0;
    }
};

/// Gives each what it asked for, or the same share of it, in whole quanta; sums up what is given.
struct TakeFromPool {
    AskPool ask;
    std::int64_t offered; ///< quanta, for all who asked
    std::int64_t* total;

    HL_FN double share() const
    {
        const std::int64_t asked = *ask.total;
        return asked > offered ? static_cast<double>(offered) / static_cast<double>(asked) * (1.0 - 1e-12) : 1.0;
    }
    HL_FN std::int64_t operator()(int index) const
    {
        const int i = ask.s.visited_segment(index);
        const auto quanta = static_cast<std::int64_t>(share() * static_cast<double>(ask.wanted(i)));
        if (quanta > 0) ask.s.absorbed[i] += quanta;
        return quanta;
    }
};

/// Finds where the cloth is no longer at rest near the border of what is visited.
struct FindReach {
    Segments s;
    ClimateParameters climate;
    double tolerance; ///< of saturation humidity; of ten kelvin
    int near;         ///< threads from the border that count
    Reach reach;

    HL_FN bool is_near(int crossing) const
    {
        const Unvisited& out = s.unvisited;
        const int end = crossing / s.picks, pick = crossing % s.picks;
        return (out.ends_before > 0 && end < out.ends_before + near) || (out.ends_after > 0 && s.ends - 1 - end < out.ends_after + near) ||
               (out.picks_before > 0 && pick < out.picks_before + near) ||
               (out.picks_after > 0 && s.picks - 1 - pick < out.picks_after + near);
    }
    HL_FN bool is_dry(int i) const
    {
        if (s.between != nullptr && s.is_warp(i) && s.between[i] > 1e-9 * climate.density * s.room[i]) return false;
        return s.liquid[i] <= 1e-9 * climate.density * s.pores[i];
    }
    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        if (!is_near(s.crossing_of(i))) return;
        const double air = pore_air(s.pores[i], s.liquid[i], climate.density);
        const double moister = s.vapour[i] / air - climate.vapour, warmer = s.warmth[i] - climate.air_warmth;
        const double most_moister = tolerance * saturation_concentration(climate.temperature), most_warmer = 10.0 * tolerance;
        const bool rests = is_dry(i) && moister < most_moister && moister > -most_moister && warmer < most_warmer && warmer > -most_warmer;
        if (!rests) reach.include(s, s.crossing_of(i));
    }
};

/// How much rates of change differ from those of the step before: the leading error of an implicit Euler step.
struct RateHistory {
    double* rate; ///< of the step before, per segment
    double dt, dt_before;
    bool known; ///< whether there was a step before

    HL_FN double error(int i, double change) const
    {
        const double now = change / dt;
        const double difference = now > rate[i] ? now - rate[i] : rate[i] - now;
        rate[i] = now;
        return known ? difference * dt * dt / (dt + dt_before) : 0.0;
    }
};

/// Error of the liquid that wicking moved since before[], summed up in quanta, yarn by yarn.
struct EstimateWicking {
    Segments s;
    RateHistory history;
    const double* before;
    std::int64_t* sum;

    template <typename Team> HL_FN void operator()(const Team& team, int index) const
    {
        const YarnLine line = s.visited_line(index);
        std::int64_t quanta = 0;
        team.each(line.first, line.last,
                  [&](int i) { quanta += static_cast<std::int64_t>(history.error(i, s.liquid[i] - before[i]) / water_quantum); });
        team.add(sum, quanta);
    }
};

/// Error of the fibres' water and of the heat since the last exchange, in quanta of each, yarn by yarn. What there was then stands in
/// bound and heat, which are brought up to date.
struct EstimateExchange {
    Segments s;
    RateHistory bound_history, heat_history;
    double* bound;
    double* heat;
    YarnTotals* totals;

    static constexpr double heat_quantum = 0x1.0p-50; ///< J
    template <typename Team> HL_FN void operator()(const Team& team, int index) const
    {
        const YarnLine line = s.visited_line(index);
        std::int64_t water = 0, joules = 0;
        team.each(line.first, line.last, [&](int i) {
            const double bound_now = s.bound[i];
            const double heat_now = heat_capacity(line.yarn, s.fibre_length(i, line.yarn), s.warm_water(i)) * s.warmth[i];
            water += static_cast<std::int64_t>(bound_history.error(i, bound_now - bound[i]) / water_quantum);
            const bool bath_warm = s.fed != nullptr && s.fed[i] != 0; // its temperature is set, not found
            if (!bath_warm) joules += static_cast<std::int64_t>(heat_history.error(i, heat_now - heat[i]) / heat_quantum);
            bound[i] = bound_now;
            heat[i] = heat_now;
        });
        team.add(&totals->bound_error, water);
        team.add(&totals->heat_error, joules);
    }
};

} // namespace hygroloom
