// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How much liquid a class of pores holds at a suction, after what it held before: curves of filling and of emptying, between which menisci
// only bulge. SI; suction is positive below the air's pressure, saturation 0..1 of the pores' volume.
#pragma once

#include "core/physics/pores.h"

#include <algorithm>

namespace hygroloom {

/// The share of the pores' volume that menisci give or take when the suction changes by the entry suction and no pore fills or empties:
/// bulging in the gaps between rods; an estimate of its order.
constexpr double bulging = 0.03;

/// A PoreClosure as steps use it, whose shape is a half number; or a room between yarns. Of a room, entry is by how much suction grows
/// until a full one has emptied to a half, emptying the suction then, and gives where it is full.
struct Retention {
    double entry = 0;     ///< Pa
    double emptying = 0;  ///< Pa, at which full pores begin to empty
    double front = 0;     ///< Pa, see PoreClosure
    double dry = 0;       ///< Pa, at and beyond which dry pores stay dry
    double gives = 0;     ///< Pa, at which the menisci of full pores begin to bulge
    double threshold = 0; ///< saturation
    int twice_shape = 8;  ///< 0: a room between yarns, see retention_of_room()

    HL_FN bool is_straight() const { return twice_shape == 0; }
    /// Pa, at and below which filling pores are full.
    HL_FN double full_at() const { return is_straight() ? gives : entry; }
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
/// Of the room between yarns, by the suctions (Pa) at which a dry one fills and a full one has emptied to a half. From no suction on the
/// faces' menisci sink into it, so what it holds falls with suction on a straight line, to a half; then they give way. What stays about
/// the crossings goes with suction^-1.5: from a half to a sixth as suction doubles, as diffuse-interface computations of a plain weave
/// have it. Suctions below nothing: it fills only from liquid that presses as much.
inline Retention retention_of_room(double filling, double emptying)
{
    constexpr double flattest = 10.0; // Pa, over which a line falls to a half at least: a millimetre of water
    const double full = std::min(0.0, filling - flattest), front = filling - full, half = std::max(front, emptying - full);
    return {half, full + half, filling, filling + front_ramp * front, full, 0.5, 0};
}
constexpr int twice_shape_of_ring = 3; // of what an emptying room holds below a half

/// The same pores, finer by this factor.
HL_FN Retention narrowed(Retention pores, double factor)
{
    pores.entry *= factor;
    pores.emptying *= factor;
    pores.front *= factor;
    pores.dry *= factor;
    pores.gives *= factor;
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

/// What a room holds above a half, which it holds at another suction.
HL_FN Held straight(double half, double suction) { return {1.0 - 0.5 * suction / half, 0.5 / half}; }

/// What pores hold that fill only, at a suction.
HL_FN Held held_filling(const Retention& pores, double suction)
{
    if (suction < pores.full_at()) return {1.0, 0.0};
    if (suction < pores.front) {
        if (pores.is_straight()) return straight(pores.front - pores.gives, suction - pores.gives);
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
    if (pores.is_straight()) {
        const double sunk = suction - pores.gives;
        if (sunk < 0) return {1.0, 0.0};
        if (sunk < pores.entry) return straight(pores.entry, sunk);
        const double held = 0.5 * half_power(pores.entry / sunk, twice_shape_of_ring);
        return {held, 0.5 * twice_shape_of_ring * held / sunk};
    }
    if (suction < pores.emptying) return {1.0, 0.0};
    const double held = half_power(pores.emptying / suction, pores.twice_shape);
    return {held, 0.5 * pores.twice_shape * held / suction};
}

/// Suction at which filling pores hold this much, Pa; full ones at any below.
HL_FN double suction_filling(const Retention& pores, double saturation)
{
    if (saturation <= pores.threshold) return pores.dry - (pores.dry - pores.front) * saturation / pores.threshold;
    if (pores.is_straight()) return pores.gives + 2.0 * (1.0 - saturation) * (pores.front - pores.gives);
    return pores.entry * std::pow(saturation, -2.0 / pores.twice_shape);
}
/// Suction at which emptying pores hold this much.
HL_FN double suction_emptying(const Retention& pores, double saturation)
{
    constexpr double least = 1e-4; // what is less clings to fibres, as what there is of it
    const double held = saturation > least ? saturation : least;
    if (!pores.is_straight()) return pores.emptying * std::pow(held, -2.0 / pores.twice_shape);
    return pores.gives + pores.entry * (held >= 0.5 ? 2.0 * (1.0 - held) : std::pow(2.0 * held, -2.0 / twice_shape_of_ring));
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

    HL_FN double slope() const { return bulging / pores.entry; } // of the line, 1/Pa
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
        const double per_ramp = pores.threshold / (pores.dry - pores.front),
                     past_ramp =
                         pores.is_straight() ? 0.5 / (pores.front - pores.gives) : 0.5 * pores.twice_shape * pores.threshold / pores.front;
        where[0] = empties;
        by[0] = bend;
        where[1] = pores.front;
        by[1] = on_line(pores.front) < pores.threshold && per_ramp > past_ramp ? per_ramp - past_ramp : 0.0;
        where[2] = full_at();
        const double fills = pores.is_straight() ? past_ramp : 0.5 * pores.twice_shape / pores.entry;
        by[2] = on_line(pores.full_at()) >= 1.0 ? slope() : fills;
        where[3] = pores.emptying;
        by[3] = pores.is_straight() && empties < pores.emptying ? 0.5 * (0.5 * twice_shape_of_ring - 1.0) / pores.entry : 0.0;
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
        const double places[] = {pores.dry, pores.front, full_at(), empties, pores.emptying};
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
    if (pores.is_straight()) {
        const double steeper = 0.5 / pores.entry - course.slope(), meets = pores.gives + (1.0 - course.on_line(pores.gives)) / steeper;
        if (meets < pores.emptying && course.zero < pores.emptying) {
            course.empties = meets;
            course.bend = steeper;
            return course;
        }
    }
    const double power = 0.5 * (pores.is_straight() ? twice_shape_of_ring : pores.twice_shape) + 1.0;
    double at = course.zero > pores.emptying ? course.zero : pores.emptying;
    for (int round = 0; round < 12; ++round) { // the curve is convex: from the left, or from a little beyond it to the left of it
        const Held held = held_emptying(pores, at);
        const double steeper = held.fall - course.slope();
        if (!(steeper > 0)) return course; // the line ends before it meets the curve
        const double newton = (held.saturation - course.on_line(at)) / steeper, from = pores.is_straight() ? at - pores.gives : at;
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
    const double suction = begins + (then.saturation - saturation) * pores.entry / bulging;
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
HL_FN double share_of_permeability_of_room(double saturation, int quarters)
{
    const double root = std::sqrt(saturation);
    double share = (quarters & 1) != 0 ? std::sqrt(root) : 1.0;
    if ((quarters & 2) != 0) share *= root;
    for (int k = quarters >> 2; k > 0; --k) share *= saturation;
    return share;
}
constexpr int usual_quarters_of_room = 11;

} // namespace hygroloom
