// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A yarn with the room beside it and the yarns that it crosses: what passes between these three classes of pores in a step, and how
// readily. Which way liquid goes, and how readily, follows from the step's start and stays.
#pragma once

#include "core/solver/caps.h"
#include "core/solver/steps/pores_found.h"
#include "core/solver/steps/yarn_lines.h"

namespace hygroloom {

/// A pool on a face, or drops: caps, or particles.
struct StandingPool {
    bool stands = false;
    double pressure = 0;             ///< Pa, of a pool, by its weight and its curved surface
    const CapOnFace* caps = nullptr; ///< null: there are none
    CapSums* sums = nullptr;         ///< of the caps
    bool drops = false;              ///< which hairs hold off dry yarns
    int face = 1;                    ///< on which it stands: 1 on top, 0 at the bottom
};

/// Classes of pores at a place of a line.
constexpr int own_pores = 0, room_pores = 1, crossed_pores = 2;

/// A part of the cloth, end by end, with columns of numbers of each of its places; see WholePores.
struct PlaceBox {
    int first_end = 0, first_pick = 0, ends = 0, picks = 0;
    double* numbers = nullptr;

    HL_FN int places() const { return ends * picks; }
    HL_FN double& operator()(int column, int k) const { return column_of(column)[k]; }
    HL_FN double* column_of(int column) const { return numbers + static_cast<std::size_t>(column) * static_cast<std::size_t>(places()); }
};

struct PoreLines {
    /// What a line's team keeps of each place; of three, one for each class.
    enum Column {
        suction,           ///< Pa, as rounds find it
        before = 3,        ///< Pa, at the step's start
        held_before = 6,   ///< saturation
        can_hold = 9,      ///< kg
        finer = 12,        ///< see PoresFound
        begun = 15,        ///< see PoreCourse: saturation
        zero = 18,         ///< see PoreCourse
        empties = 21,      ///< see PoreCourse
        bend = 24,         ///< see PoreCourse
        feed = 27,         ///< kg/Pa from the pool
        most_fed = 30,     ///< kg
        along = 33,        ///< kg/Pa to the next place: own, room
        own_room = 35,     ///< kg/Pa
        own_crossed = 36,  ///< kg/Pa
        room_crossed = 37, ///< kg/Pa
        presses = 38,      ///< Pa, of the pool or cap over the place
        taken = 39,        ///< bends of all classes, see PoreCourse; a bit for each
        left = 40,         ///< kg more comes than the crossed segment holds
        response = 41,     ///< Pa/kg, of the crossed segment
        wet = 42           ///< which yarns are, and whether liquid stands over them, see room_conditions
    };
    static constexpr int columns = 43;
    static constexpr double near_course = 1e-6; // of saturation

    Segments s;
    ClimateParameters climate;
    double dt;        ///< s
    double dt_across; ///< s, across the lines and from a pool: half of it where stages of both systems pass each crossing
    bool of_warp;     ///< lines are all ends, or all picks
    double lift;      ///< Pa, by which suction rises from a place to the next in liquid at rest; in panels Pa/m, for each m of rise
    StandingPool pool;
    std::int64_t* drawn;    ///< sums up quanta that came from the pool
    int most_rounds;        ///< for the suctions along a line
    std::int64_t* shed;     ///< sums up quanta that passed through holes
    std::int64_t* unsolved; ///< counts lines whose rounds did not close in; they stay as they were
    bool settles;           ///< whether classes settle: in the last stage of a step

    template <typename Team> struct Line {
        const Team& team;
        int first, last;
        bool ring;        ///< the last place joins the first
        int number, base; ///< of the end or pick; segment of its first place, visited or not
        typename Team::Columns numbers;

        HL_FN double& operator()(int column, int i) const { return numbers(column, i - first); }
    };
    template <typename Team> HL_FN static Line<Team> line_of(const Team& team, int first, int last, int number, int base)
    {
        return {team, first, last, false, number, base, team.columns(columns, last - first)};
    }
    /// In panels lines are chains of places.
    template <typename Team> HL_FN Line<Team> chain_of(const Team& team, int first, int last) const
    {
        return {team, first, last, last > first && is_seam(last - 1), 0, 0, team.columns(columns, last - first)};
    }
    HL_FN bool has_rings() const { return s.panels.has_rings; }
    static constexpr int none = -1;
    template <typename Team> HL_FN static int place_before(const Line<Team>& line, int i)
    {
        return i > line.first ? i - 1 : line.ring ? line.last - 1 : none;
    }
    template <typename Team> HL_FN static int place_after(const Line<Team>& line, int i)
    {
        return i + 1 < line.last ? i + 1 : line.ring ? line.first : none;
    }
    struct Place {
        int own, crossing, crossed; ///< segment, crossing, segment
        int end, pick;
    };
    template <typename Team> HL_FN Place place(const Line<Team>& line, int i) const
    {
        if (!s.whole()) return place_in_chain(i);
        const int k = i - line.base;
        if (of_warp) return {i, i, s.weft_of(line.number, k), line.number, k};
        const int crossing = s.warp_of(k, line.number);
        return {i, crossing, crossing, k, line.number};
    }
    HL_FN Place place(const PlaceBox& box, int k) const
    {
        const int end = box.first_end + k / box.picks, pick = box.first_pick + k % box.picks, crossing = s.warp_of(end, pick);
        return {crossing, crossing, s.weft_of(end, pick), end, pick};
    }
    HL_FN Place place_in_chain(int i) const
    {
        const int own = s.panels.order[i], crossing = s.crossing_of(own), end = crossing / s.picks, pick = crossing % s.picks;
        return {own, crossing, of_warp ? s.weft_of(end, pick) : crossing, end, pick};
    }
    HL_FN int segment_at(int i) const { return s.whole() ? i : s.panels.order[i]; }
    /// Whether a seam lies between a place and the next, or the first of a ring.
    HL_FN bool is_seam(int i) const { return !s.whole() && s.panels.joint_yarns[i] >= 0; }
    HL_FN const YarnParameters& yarn(const Place& p, bool own) const
    {
        return s.parameters[own == of_warp ? s.type_of_end(p.end, p.pick) : s.type_of_pick(p.pick)];
    }
    HL_FN const YarnParameters& yarn_of(const Place& p, int which) const { return yarn(p, which == own_pores); }
    HL_FN int face(const Place& p, int which) const { return s.face_of(p.crossing, (which == own_pores) == of_warp); }
    HL_FN const WettedPores& pores(const Place& p, int which) const { return yarn_of(p, which).on_face[face(p, which)]; }
    HL_FN const BetweenParameters& room(const Place& p) const { return s.crossing_at(p.end, p.pick).between; }
    HL_FN bool is_fed(int i) const { return s.fed != nullptr && s.fed[i] != 0; } // in no garment
    HL_FN FindPores find() const { return {s, climate.density}; }
    HL_FN int taker(const Place& p, int which) const
    {
        return which == own_pores ? p.own : which == room_pores ? 2 * s.crossings() + p.crossing : p.crossed;
    }
    HL_FN double& liquid(const Place& p, int which) const
    {
        return which == own_pores ? s.liquid[p.own] : which == room_pores ? s.between[p.crossing] : s.liquid[p.crossed];
    }
    HL_FN double capacity(const Place& p, int which) const // kg
    {
        return climate.density * (which == room_pores ? s.room[p.crossing] : s.pores[which == own_pores ? p.own : p.crossed]);
    }
    /// Of dry pores.
    template <typename Places> HL_FN const Retention& retention(const Places& line, const Place& p, int which, int i) const
    {
        return which == room_pores ? room(p).retention[static_cast<int>(line(wet, i))] : pores(p, which).retention;
    }
    HL_FN PoresFound found(const Place& p, int which, int condition) const
    {
        if (which == room_pores) return find().between(p.crossing, room(p), condition);
        return find().segment(which == own_pores ? p.own : p.crossed, yarn_of(p, which), face(p, which));
    }

    /// What a class held, and at what suction, when it last settled: where its course begins in each stage of a step, so that what one
    /// stage fills and the next empties goes back the way it came, as if both had acted at once.
    HL_FN HeldBefore settled(const Place& p, int which) const
    {
        if (which == room_pores) return {s.between_settled[p.crossing], s.between_suction[p.crossing]};
        const int segment = which == own_pores ? p.own : p.crossed;
        return {s.settled[segment], s.suction[segment]};
    }
    HL_FN void settle_at(const Place& p, int which, const HeldBefore& now) const
    {
        const int segment = which == own_pores ? p.own : p.crossed;
        (which == room_pores ? s.between_suction[p.crossing] : s.suction[segment]) = now.suction;
        (which == room_pores ? s.between_settled[p.crossing] : s.settled[segment]) = now.saturation;
    }

    HL_FN bool is_covered(const Place& p) const
    {
        if (!pool.stands) return false;
        for (int which = 0; which < 3; ++which)
            if (s.offered[taker(p, which)] > 0) return true;
        return false;
    }
    template <typename Team> HL_FN bool is_wet(const Line<Team>& line, int i) const
    {
        const Place p = place(line, i);
        for (int which = 0; which < 3; ++which)
            if (liquid(p, which) > 0) return true;
        return is_covered(p);
    }
    template <typename Places> HL_FN void look_at(const Places& line, int i) const
    {
        const Place p = place(line, i);
        const int condition = find().condition_of_room(p.crossing, room(p), is_covered(p));
        line(wet, i) = condition;
        for (int which = 0; which < 3; ++which) {
            const PoresFound found_now = found(p, which, condition);
            const HeldBefore now{found_now.saturation, is_fed(p.own) ? 0.0 : found_now.suction};
            line(suction + which, i) = line(before + which, i) = now.suction;
            line(held_before + which, i) = now.saturation;
            line(can_hold + which, i) = found_now.capacity;
            line(finer + which, i) = found_now.finer;
            PoreCourse course = course_from(found_now.retention, settled(p, which));
            const double off = course.at(now.suction).saturation - now.saturation;
            if (!(off < near_course && off > -near_course)) { // dried up, or the pores have changed their shape
                settle_at(p, which, now);
                course = course_from(found_now.retention, now);
            }
            line(begun + which, i) = course.saturation;
            line(zero + which, i) = course.zero;
            line(empties + which, i) = course.empties;
            line(bend + which, i) = course.bend;
        }
        if (pool.stands) line(presses, i) = pressure_over(p);
    }
    HL_FN double pressure_over(const Place& p) const
    {
        if (pool.caps == nullptr) return pool.pressure;
        const int cap = s.cap_over[p.crossing];
        return cap < 0 ? 0.0 : pool.caps[cap].pressure;
    }
    template <typename Places> HL_FN PoreCourse course(const Places& line, const Place& p, int which, int i) const
    {
        return {narrowed(retention(line, p, which, i), line(finer + which, i)), line(begun + which, i), line(zero + which, i),
                line(empties + which, i), line(bend + which, i)};
    }

    /// A class of pores as couplings see it.
    struct End {
        double suction, saturation, threshold, entry, capacity;
        double gate;   ///< of dry pores
        double across; ///< over that, for what comes across the fibres
        bool straight; ///< see Retention

        HL_FN bool is_connected() const { return saturation > threshold; }
        /// What dry pores let in, of what connected ones do.
        HL_FN double lets_in() const { return is_connected() ? 1.0 : gate; }
        HL_FN double lets_in_across() const { return is_connected() ? 1.0 : gate * across; }
        /// Share of the permeability of full pores, by the power of what is connected: in halves, or of a room in quarters.
        HL_FN double permeability(int power) const
        {
            return straight ? share_of_permeability_of_room(saturation, power) : share_of_permeability(saturation, threshold, power);
        }
    };
    template <typename Places> HL_FN End end_of(const Places& line, const Place& p, int which, int i) const
    {
        const Retention& holds = retention(line, p, which, i);
        // Between dry yarns liquid does not spread by itself.
        const bool is_room = which == room_pores;
        const double gate = !is_room                                           ? pores(p, which).gate
                            : (static_cast<int>(line(wet, i)) & both_wet) != 0 ? 1.0
                                                                               : 0.0,
                     across = is_room ? 1.0 : pores(p, which).across;
        return {
            line(before + which, i), line(held_before + which, i), holds.threshold, holds.entry, line(can_hold + which, i), gate, across,
            holds.is_room()};
    }

    /// kg/Pa in some seconds, of a conductance in kg/(s Pa). Says where more than next to nothing would pass: in a line with no such place
    /// nothing does, so that rest is rest. In others those that conduct well couple, too, or what one place gives would come from its
    /// neighbours alone.
    HL_FN static double coupling(double conductance, double difference, const End& from, const End& to, double seconds, bool& moves)
    {
        constexpr double clings = 1e-9;           // of what a class can hold
        constexpr double least_difference = 1e-6; // of the entry suction
        constexpr double least_rate = 1e-6;       // 1/s, of what either can hold
        if (from.saturation < clings) return 0;
        const double gap = difference < 0 ? -difference : difference;
        const double smaller = from.capacity < to.capacity ? from.capacity : to.capacity;
        constexpr double small_difference = 1e-3; // of the entry suction
        const bool passes = gap > least_difference * from.entry && conductance * gap > least_rate * smaller;
        moves = moves || passes;
        return passes || conductance * small_difference * from.entry > least_rate * smaller ? conductance * seconds : 0.0;
    }
    HL_FN double lift_after(int i) const // Pa
    {
        if (s.whole()) return lift;
        if (is_seam(i)) return 0;
        const int here = s.panels.order[i], next = s.panels.order[i + 1];
        return lift * static_cast<double>(next > here ? s.panels.rise[here] : -s.panels.rise[next]);
    }
    HL_FN double coupling_along(const End& here, const End& next, double rises, double conductance, int power, bool& moves) const
    {
        const double difference = next.suction - here.suction - rises; // more than 0: on along the line
        const End &from = difference > 0 ? here : next, &to = difference > 0 ? next : here;
        return coupling(conductance * to.lets_in() * from.permeability(power), difference, from, to, dt, moves);
    }
    /// Within a crossing. Liquid in the room stands on as much of the yarns' skin as it fills of the room.
    HL_FN double coupling_across(const End& a, bool a_is_room, const End& b, double conductance, bool& moves) const
    {
        const double difference = b.suction - a.suction;
        const End &from = difference > 0 ? a : b, &to = difference > 0 ? b : a;
        const bool from_room = a_is_room && difference > 0;
        const double share = to.lets_in_across() * (from_room ? from.saturation : from.permeability(7));
        return coupling(conductance * share, difference, from, to, dt_across, moves);
    }
    /// Finds what couples a place's classes with each other and with the next place's; whether anything does.
    template <typename Team> HL_FN bool couple(const Line<Team>& line, int i) const
    {
        const Place p = place(line, i);
        const BetweenParameters& here = room(p);
        const End own = end_of(line, p, own_pores, i), beside = end_of(line, p, room_pores, i), crossed = end_of(line, p, crossed_pores, i);
        const double density = climate.density;
        const bool bath = is_fed(i);
        bool moves = false;
        line(own_room, i) = bath ? 0.0 : coupling_across(beside, true, own, density * (of_warp ? here.to_warp : here.to_weft), moves);
        line(own_crossed, i) = bath ? 0.0 : coupling_across(own, false, crossed, density * here.yarns, moves);
        line(room_crossed, i) =
            bath ? 0.0 : coupling_across(beside, true, crossed, density * (of_warp ? here.to_weft : here.to_warp), moves);
        line(along, i) = line(along + 1, i) = 0;
        if (const int next = place_after(line, i); next != none && !(bath && is_fed(next))) { // what stands in a bath bears itself
            const Place q = place(line, next);
            const double from = along_room(p), to = along_room(q);
            const double in_series = from > 0 && to > 0 ? 2.0 * from * to / (from + to) : 0.0;
            const bool seam = is_seam(i);
            const double yarns = seam ? s.panels.joint_yarns[i] : along_yarn(yarn_of(p, own_pores), segment_at(i), segment_at(next));
            const double rooms = seam ? s.panels.joint_rooms[i] : in_series;
            line(along, i) = coupling_along(own, end_of(line, q, own_pores, next), lift_after(i), density * yarns, 7, moves);
            const int power = of_warp ? here.quarters_along_warp : here.quarters_along_weft;
            line(along + 1, i) = coupling_along(beside, end_of(line, q, room_pores, next), lift_after(i), density * rooms, power, moves);
        }
        const bool by_pool = pool.stands && couple_with_pool(line, p, i);
        return by_pool || moves;
    }
    HL_FN double along_room(const Place& p) const // m3/(s Pa), half of the way to the next
    {
        return (of_warp ? room(p).along_warp : room(p).along_weft) * open_along(p, p.own);
    }
    /// Of a room, what its place in the weave and swollen yarns make of the permeability along a segment of its crossing.
    HL_FN double open_along(const Place& p, int segment) const
    {
        const double swollen = find().permeability_of_room(p.crossing, room(p));
        return s.room_along != nullptr ? swollen * static_cast<double>(s.room_along[segment]) : swollen;
    }
    HL_FN double along_yarn(const YarnParameters& yarn, int i, int next) const // m3/(s Pa), between neighbours
    {
        double flows = yarn.flow_along * 2.0 * plain_inverse(resists(yarn, i) + resists(yarn, next));
        if (s.varies()) flows *= 0.5 * (find().permeability(i, yarn) + find().permeability(next, yarn));
        if (s.warmth[i] == 0 && s.warmth[next] == 0) return flows;
        return flows * 0.5 * (flow_factor(climate.flow, s.warmth[i]) + flow_factor(climate.flow, s.warmth[next]));
    }
    /// m of a yarn without a finish that let through as little as a segment.
    HL_FN double resists(const YarnParameters& yarn, int i) const
    {
        return s.length[i] * plain_inverse(yarn.on_face[s.face_of(s.crossing_of(i), s.is_warp(i))].finish.conducts);
    }
    template <typename Places> HL_FN bool couple_with_pool(const Places& line, const Place& p, int i) const
    {
        bool any = false;
        for (int which = 0; which < 3; ++which) {
            const std::int64_t quanta = s.offered[taker(p, which)];
            line(most_fed + which, i) = static_cast<double>(quanta) * water_quantum;
            line(feed + which, i) = 0;
            if (quanta <= 0) continue;
            const End to = end_of(line, p, which, i);
            const double conductance =
                which == room_pores ? find().permeability_of_room(p.crossing, room(p)) * room(p).face : yarn_of(p, which).face_conductance;
            const bool below = which == room_pores || face(p, which) != pool.face; // the finish of the pool's face
            const double lets_in =
                which == room_pores ? to.lets_in() : pores(p, which).lets_in_from_face(to.is_connected(), pool.drops, line(presses, i));
            const double share = below ? room(p).lets_in_from_face(lets_in, pool.face, line(presses, i)) : lets_in;
            line(feed + which, i) = climate.density * conductance * dt_across * share;
            any = any || line(feed + which, i) > 0;
        }
        return any;
    }
};

} // namespace hygroloom
