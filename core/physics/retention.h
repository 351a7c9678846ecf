// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How much liquid a class of pores holds at a suction, after what it held before: curves of filling and of emptying, between which menisci
// only bulge. SI; suction is positive below the air's pressure, saturation 0..1 of the pores' volume.
#pragma once

#include "core/physics/pores.h"

#include <algorithm>

namespace hygroloom {

/// The share of the pores' volume that menisci give or take when the suction changes by the entry suction (of a room, by that at which it
/// breaks) and no pore fills or empties: bulging in the gaps between rods; an estimate of its order.
constexpr double bulging = 0.03;

/// A PoreClosure as steps use it, whose shape is a half number; or a room between yarns, see retention_of_room().
struct Retention {
    double entry = 0;     ///< Pa; of a room, by how much suction grows until a full one has emptied to its knee
    double emptying = 0;  ///< Pa, at which full pores begin to empty; of a room, at its knee
    double front = 0;     ///< Pa, see PoreClosure
    double dry = 0;       ///< Pa, at and beyond which dry pores stay dry
    double gives = 0;     ///< Pa, at which the menisci of full pores begin to bulge
    double threshold = 0; ///< saturation
    int twice_shape = 8;  ///< 0: a room between yarns
    int quarters = 0;     ///< of a room, 4 times the power of suction that it empties by below its knee
    double full = 0;      ///< Pa, at and below which a filling room is full
    double knee = 0;      ///< Pa, to which what it holds then falls on a straight line
    double at_knee = 0;   ///< saturation there
    double breaks = 0;    ///< Pa, beyond which a room empties as 1 / suction^2

    HL_FN bool is_room() const { return twice_shape == 0; }
    /// Pa, by how much suction changes as menisci bulge by `bulging`.
    HL_FN double bulges_over() const { return is_room() ? breaks - gives : entry; }
    /// Pa, at and below which filling pores are full.
    HL_FN double full_at() const { return is_room() ? full : entry; }
};

/// Shape in halves, 1 to 6.
inline Retention retention_of(const PoreClosure& pores)
{
    return {pores.entry_suction,
            pores.hysteresis * pores.entry_suction,
            pores.front_suction,
            (1.0 + front_ramp) * pores.front_suction,
            pores.entry_suction,
            pores.threshold,
            static_cast<int>(std::lround(2.0 * pores.shape))};
}
constexpr double almost_full = 0.95, room_sunk = 0.85, room_knee = 4.0 / 7.0, room_low = 0.3, room_rings = 0.1;

/// Suctions (Pa) at which the liquid of a room is at rest.
struct RoomSuctions {
    double almost, sunk, knee, low; ///< when it holds those shares as it empties; below 0 where flat yarns press (taffeta -750)
    double fills;                   ///< when the rings about the crossings of a dry one have joined
    double breaks;                  ///< when the liquid of a full one has parted into such rings
};
/// Of the room between yarns, as its liquid advances and as it recedes. From a little below no suction on the faces' menisci sink into it,
/// so what it holds falls with suction on a straight line, to 4/7; then as suction^-n, and once it has parted into rings, faster. n is 1/4
/// to 3/4: no less steep than the line before it. It fills from what presses only where its rings do not join before.
inline Retention retention_of_room(const RoomSuctions& advancing, const RoomSuctions& receding)
{
    constexpr double flattest = 10.0; // Pa, over which a line falls to its knee at least: a millimetre of water
    // Where the lines by the first two and by the next two meet what is full, the middle.
    const double by_first = advancing.almost - (advancing.sunk - advancing.almost) * (1.0 - almost_full) / (almost_full - room_sunk);
    const double by_next = advancing.sunk - (advancing.knee - advancing.sunk) * (1.0 - room_sunk) / (room_sunk - room_knee);
    Retention room;
    room.twice_shape = 0;
    room.gives = std::min(0.5 * (by_first + by_next), advancing.sunk);
    const double sinks = std::max(flattest, advancing.knee - room.gives);
    room.entry = std::max(sinks, receding.knee - room.gives);
    room.emptying = room.gives + room.entry;
    const double beyond = std::log(std::max(1.001, (receding.low - room.gives) / room.entry));
    room.quarters = static_cast<int>(std::lround(std::clamp(4.0 * std::log(room_knee / room_low) / beyond, 1.0, 3.0)));
    room.breaks = std::max(room.emptying, receding.breaks);
    // Filling.
    constexpr double most = 0.95; // of what joins at once
    room.front = advancing.fills;
    const double past = (room.front - room.gives) / sinks;
    room.threshold = past <= 1.0 ? 1.0 - (1.0 - room_knee) * past : room_knee * std::pow(past, -0.25 * room.quarters);
    if (room.threshold <= most) {
        room.full = room.gives;
        room.knee = std::min(room.front, room.gives + sinks);
        room.at_knee = std::max(room.threshold, room_knee);
    } else {
        room.full = room.front - flattest;
        room.knee = room.front;
        room.at_knee = room.threshold = most;
    }
    room.dry = room.front + std::max(0.5 * flattest, front_ramp * (room.front - room.full));
    return room;
}

/// The same pores, finer by this factor.
HL_FN Retention narrowed(Retention pores, double factor)
{
    pores.entry *= factor;
    pores.emptying *= factor;
    pores.front *= factor;
    pores.dry *= factor;
    pores.gives *= factor;
    pores.full *= factor;
    pores.knee *= factor;
    pores.breaks *= factor;
    return pores;
}

/// A yarn whose fibres have swollen, m3.
struct Swollen {
    double pores;
    double grown; ///< by how much it is larger than when dry, into the room beside it
};
constexpr double each_takes_of_room = 0.25; // yarns that grow: both together take up to half of the room beside them; an assumption

/// Bound water widens the fibres by its own volume. As long as its share of the room lasts, the yarn grows and stays as packed as it was;
/// then the fibres grow into its pores, of which a twentieth always stays open.
HL_FN Swollen swollen_yarn(double dry_pores, double dry_fibres, double bound, double share_of_room)
{
    const double as_packed = bound * (1.0 + dry_pores / dry_fibres), grown = as_packed < share_of_room ? as_packed : share_of_room;
    const double pores = dry_pores + grown - bound, least = 0.05 * dry_pores;
    return {pores > least ? pores : least, grown};
}

/// base^(twice / 2), 0 <= base.
HL_FN double half_power(double base, int twice)
{
    double power = (twice & 1) != 0 ? std::sqrt(base) : 1.0;
    for (int k = twice >> 1; k > 0; --k) power *= base;
    return power;
}

/// A saturation and how it falls with suction, 1/Pa, at least 0.
struct Held {
    double saturation, fall;
};

/// base^(quarters / 4), 0 <= base.
HL_FN double quarter_power(double base, int quarters)
{
    const double root = std::sqrt(base);
    double power = (quarters & 1) != 0 ? std::sqrt(root) : 1.0;
    if ((quarters & 2) != 0) power *= root;
    for (int k = quarters >> 2; k > 0; --k) power *= base;
    return power;
}

/// What a room holds on a straight line from full to so much, over so many Pa.
HL_FN Held straight(double least, double over, double suction)
{
    const double fall = (1.0 - least) / over;
    return {1.0 - fall * suction, fall};
}
/// What it holds at so many times the suction at which it holds so much; per: 1 / Pa of that.
HL_FN Held past_knee(double at_knee, double times, double per, int quarters)
{
    const double held = at_knee * quarter_power(1.0 / times, quarters);
    return {held, 0.25 * quarters * held * per / times};
}
/// What an emptying room holds as it breaks.
HL_FN double room_breaks_at(const Retention& room)
{
    return room_knee * quarter_power(room.entry / (room.breaks - room.gives), room.quarters);
}

/// What pores hold that fill only, at a suction.
HL_FN Held held_filling(const Retention& pores, double suction)
{
    if (suction < pores.full_at()) return {1.0, 0.0};
    if (suction < pores.front) {
        if (pores.is_room()) {
            const double line = pores.knee - pores.full, along = suction - pores.full;
            return along <= line ? straight(pores.at_knee, line, along)
                                 : past_knee(pores.at_knee, along / line, 1.0 / line, pores.quarters);
        }
        const double held = half_power(pores.entry / suction, pores.twice_shape);
        return {held, 0.5 * pores.twice_shape * held / suction};
    }
    const double per_ramp = 1.0 / (pores.dry - pores.front);
    if (suction <= pores.dry) return {pores.threshold * (pores.dry - suction) * per_ramp, pores.threshold * per_ramp};
    return {0.0, 0.0};
}
/// What pores hold that empty only.
HL_FN Held held_emptying(const Retention& pores, double suction)
{
    if (pores.is_room()) {
        const double sunk = suction - pores.gives, broken = pores.breaks - pores.gives;
        if (sunk < 0) return {1.0, 0.0};
        if (sunk < pores.entry) return straight(room_knee, pores.entry, sunk);
        if (sunk < broken) return past_knee(room_knee, sunk / pores.entry, 1.0 / pores.entry, pores.quarters);
        const double times = broken / sunk, held = room_breaks_at(pores) * times * times;
        return {held, 2.0 * held / sunk};
    }
    if (suction < pores.emptying) return {1.0, 0.0};
    const double held = half_power(pores.emptying / suction, pores.twice_shape);
    return {held, 0.5 * pores.twice_shape * held / suction};
}

/// Suction at which filling pores hold this much, Pa; full ones at any below.
HL_FN double suction_filling(const Retention& pores, double saturation)
{
    if (saturation <= pores.threshold) return pores.dry - (pores.dry - pores.front) * saturation / pores.threshold;
    if (!pores.is_room()) return pores.entry * std::pow(saturation, -2.0 / pores.twice_shape);
    const double line = pores.knee - pores.full;
    return pores.full + line * (saturation >= pores.at_knee ? (1.0 - saturation) / (1.0 - pores.at_knee)
                                                            : std::pow(saturation / pores.at_knee, -4.0 / pores.quarters));
}
/// Suction at which emptying pores hold this much.
HL_FN double suction_emptying(const Retention& pores, double saturation)
{
    constexpr double least = 1e-4; // what is less clings to fibres, as what there is of it
    const double held = saturation > least ? saturation : least;
    if (!pores.is_room()) return pores.emptying * std::pow(held, -2.0 / pores.twice_shape);
    if (held >= room_knee) return pores.gives + pores.entry * (1.0 - held) / (1.0 - room_knee);
    const double last = room_breaks_at(pores);
    return pores.gives + (held >= last ? pores.entry * std::pow(held / room_knee, -4.0 / pores.quarters)
                                       : (pores.breaks - pores.gives) * std::sqrt(last / held));
}
/// Pores that held a saturation at a suction: what they hold at others when these come next.
struct HeldBefore {
    double saturation, suction;
};

constexpr double nearly_full = 1.0 - 1e-6;

/// What pores hold from there on: along the line of bulging menisci, until that meets the curve of filling or that of emptying. It falls
/// with suction everywhere, but as it bends both ways, it is solved for as the difference of two convex functions, of which the second
/// has straight pieces only (Casulli and Zanolli 2010: nested Newton rounds).
struct PoreCourse {
    Retention pores;
    double saturation, zero; ///< of the line: what it holds at a suction, Pa
    double empties;          ///< Pa, where emptying begins
    double bend;             ///< 1/Pa, by how much it holds less steeply below that suction than above it

    HL_FN double slope() const { return bulging / pores.bulges_over(); } // of the line, 1/Pa
    HL_FN double on_line(double suction) const { return saturation - slope() * (suction - zero); }
    HL_FN Held at(double suction) const
    {
        if (suction >= empties) return held_emptying(pores, suction);
        const Held line{on_line(suction), slope()}, least = held_filling(pores, suction);
        if (least.saturation >= line.saturation) return least;
        return line.saturation >= 1.0 ? Held{1.0, 0.0} : line;
    }
    static constexpr int bends = 4;
    /// Suctions below which it becomes less steep, and by how much; at some by less than this.
    HL_FN void find_bends(double (&where)[bends], double (&by)[bends]) const
    {
        const double per_ramp = pores.threshold / (pores.dry - pores.front), past_ramp = at_front();
        where[0] = empties;
        by[0] = bend;
        where[1] = pores.front;
        by[1] = on_line(pores.front) < pores.threshold && per_ramp > past_ramp ? per_ramp - past_ramp : 0.0;
        where[2] = full_at();
        by[2] = on_line(pores.full_at()) >= 1.0 ? slope() : at_full();
        where[3] = pores.breaks;
        by[3] = pores.is_room() && empties < pores.breaks
                    ? (2.0 - 0.25 * pores.quarters) * room_breaks_at(pores) / (pores.breaks - pores.gives)
                    : 0.0;
    }
    /// How steep the curve of filling is as it leaves what is full, and before it ends at the front, 1/Pa.
    HL_FN double at_full() const
    {
        return pores.is_room() ? (1.0 - pores.at_knee) / (pores.knee - pores.full) : 0.5 * pores.twice_shape / pores.entry;
    }
    HL_FN double at_front() const
    {
        if (!pores.is_room()) return 0.5 * pores.twice_shape * pores.threshold / pores.front;
        return pores.front <= pores.knee ? at_full() : 0.25 * pores.quarters * pores.threshold / (pores.front - pores.full);
    }
    /// Suction at and below which the pores are full.
    HL_FN double full_at() const
    {
        const double by_line = zero - (1.0 - saturation) / slope();
        return by_line > pores.full_at() ? by_line : pores.full_at();
    }
    /// From a suction towards another, but no further than to the next bend.
    HL_FN double as_far_as_bends(double from, double to) const
    {
        const double places[] = {pores.dry, pores.front, full_at(), empties, pores.is_room() ? pores.breaks : pores.emptying};
        for (double place : places)
            if (from < place ? to > place : from > place && to < place) to = place;
        return to;
    }
};

/// Where the line of bulging menisci begins, Pa: full pores keep all until then, however they were pressed.
HL_FN double line_begins_at(const Retention& pores, const HeldBefore& before)
{
    return before.saturation >= nearly_full && before.suction < pores.gives ? pores.gives : before.suction;
}

/// Where the line meets the curve of emptying is found by Halley's rounds, none more than twice Newton's.
HL_FN PoreCourse course_from(const Retention& pores, const HeldBefore& before)
{
    constexpr double never = 1e300;
    PoreCourse course{pores, before.saturation, line_begins_at(pores, before), never, 0};
    if (before.saturation <= 0) return course; // the line lies below nothing from there on
    double power = 0.5 * pores.twice_shape + 1.0, at = pores.emptying, origin = 0;
    if (pores.is_room()) {
        const double steeper = (1.0 - room_knee) / pores.entry - course.slope(),
                     meets = pores.gives + (1.0 - course.on_line(pores.gives)) / steeper;
        if (meets < pores.emptying && course.zero < pores.emptying) {
            course.empties = meets;
            course.bend = steeper;
            return course;
        }
        origin = pores.gives;
        const bool breaks = course.on_line(pores.breaks) < room_breaks_at(pores) || course.zero > pores.breaks;
        power = breaks ? 3.0 : 0.25 * pores.quarters + 1.0;
        if (breaks) at = pores.breaks;
    }
    if (course.zero > at) at = course.zero;
    for (int round = 0; round < 12; ++round) { // the curve is convex: from the left, or from a little beyond it to the left of it
        const Held held = held_emptying(pores, at);
        const double steeper = held.fall - course.slope();
        if (!(steeper > 0)) return course; // the line ends before it meets the curve
        const double newton = (held.saturation - course.on_line(at)) / steeper, from = at - origin;
        const double bent = 1.0 - 0.5 * newton * held.fall * power / (from * steeper), step = newton / (bent > 0.5 ? bent : 0.5);
        if (!(std::abs(step) > 1e-5 * from)) { // what is left goes as its cube
            course.empties = at + step;
            course.bend = held.fall * (1.0 - power * step / from) - course.slope();
            return course;
        }
        at += step;
    }
    return course;
}

/// The suction of pores whose saturation has changed since it was another at a suction: along the line of bulging menisci, as far as pores
/// neither fill nor empty. Pa.
HL_FN double suction_after(const Retention& pores, const HeldBefore& then, double saturation)
{
    if (saturation <= 0) return pores.dry;
    constexpr double little = 1e-9; // of saturation, about which a curve may be missed
    const double begins = saturation < then.saturation - little ? line_begins_at(pores, then) : then.suction;
    const double suction = begins + (then.saturation - saturation) * pores.bulges_over() / bulging;
    if (saturation >= nearly_full && then.saturation < nearly_full && suction < pores.full_at())
        return pores.full_at(); // nothing presses them yet
    if (saturation < nearly_full && held_filling(pores, suction).saturation > saturation + little)
        return suction_filling(pores, saturation);
    if (held_emptying(pores, suction).saturation < saturation - little) return suction_emptying(pores, saturation);
    return suction;
}

/// Share of the permeability of full pores, of pores that are connected from a threshold on; power 7/2 between fibres, 4 between yarns.
HL_FN double share_of_permeability(double saturation, double threshold, int twice_power)
{
    const double connected = (saturation - threshold) / (1.0 - threshold);
    return connected > 0 ? half_power(connected < 1.0 ? connected : 1.0, twice_power) : 0.0;
}
/// The same of a room, saturation^(quarters / 4). Stokes flow past slipping menisci in drawn weaves goes with powers of 2.2 to 3.5, 2.75
/// in the middle.
HL_FN double share_of_permeability_of_room(double saturation, int quarters) { return quarter_power(saturation, quarters); }
constexpr int usual_quarters_of_room = 11;

} // namespace hygroloom
