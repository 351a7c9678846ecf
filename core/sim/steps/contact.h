// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where the liquid meets the yarns: the nearest skin through the box hierarchy (fabric, crossing, yarn), contact, and drinking.
#pragma once

#include "core/physics/water.h"
#include "core/sim/steps/liquid.h"

namespace hygroloom::inline HL_PRECISION {

/// One type of yarn as stages see it.
struct YarnShape {
    Real half_height = 0; ///< at a crossing
    Real half_width = 0;
    Real widest = 0;  ///< from its place to its farthest side, anywhere
    int profiles = 0; ///< where its own begin among TextileShape::profiles
};

struct TextileShape : Yarns {
    Real half_thickness = 0;
    Real warp_pitch = 0; ///< from end to end
    Real weft_pitch = 0;
    int samples = 0;                   ///< of a profile, from crossing to crossing
    const YarnShape* shapes = nullptr; ///< per type, as parameters
    const float* profiles = nullptr;   ///< height, slope, half height, half width per sample; see ContactShape
    const std::uint8_t* warp_up = nullptr;
    const float* shift = nullptr; ///< per segment, beside the yarn's place

    HL_FN int segment(bool is_warp, int end, int pick) const { return is_warp ? end * picks + pick : ends * picks + pick * ends + end; }
    HL_FN bool is_warp_up(int end, int pick) const { return warp_up[end * picks + pick] != 0; }
    /// Of a yarn's centreline at a crossing.
    HL_FN Real height(bool is_warp, int end, int pick) const
    {
        const CrossingParameters& here = crossing_at(end, pick);
        const Real rise = static_cast<Real>(is_warp ? here.warp_rise : here.weft_rise);
        return is_warp_up(end, pick) == is_warp ? rise : -rise;
    }
    HL_FN const YarnShape& warp_shape(int end) const { return shapes[type_of_end(end)]; }
    HL_FN const YarnShape& weft_shape(int pick) const { return shapes[type_of_pick(pick)]; }
    /// Of a yarn from over a yarn of one type to over or under the next; the other system's types count from 0.
    HL_FN const float* profile(const YarnShape& own, int before, int after, bool is_warp, bool changes) const
    {
        const int types = is_warp ? weft_types : warp_types;
        return profiles + own.profiles + 4 * samples * (2 * (before * types + after) + (changes ? 1 : 0));
    }
};

/// The skin nearest to a point.
struct NearestSkin {
    Real distance = 0; ///< less than 0 inside
    Vec3 normal;       ///< out of the yarn
    int segment = -1;  ///< -1: none within reach
};

/// A yarn at one place along it.
struct YarnPlace {
    Real side = 0; ///< of its middle from the crossing's, across it
    Real height = 0, slope = 0;
    Real half_height = 0, half_width = 0;
};

/// The yarn of one system through a crossing, part_way (-1/2 to 1/2) along to the next.
HL_FN YarnPlace yarn_place(const TextileShape& t, bool is_warp, int end, int pick, Real part_way)
{
    const YarnShape& yarn = is_warp ? t.warp_shape(end) : t.weft_shape(pick);
    const int segment = t.segment(is_warp, end, pick);
    const bool up = t.is_warp_up(end, pick);
    const int step = part_way < 0 ? -1 : 1;
    part_way *= Real(step);
    const int next_end = is_warp ? end : end + step, next_pick = is_warp ? pick + step : pick;
    const bool inside = next_end >= 0 && next_end < t.ends && next_pick >= 0 && next_pick < t.picks;
    const bool changes = inside && t.is_warp_up(next_end, next_pick) != up;
    const Real shift = Real(t.shift[segment]), next_shift = inside ? Real(t.shift[t.segment(is_warp, next_end, next_pick)]) : shift;
    const int crossed = is_warp ? t.type_of_pick(pick) - t.warp_types : t.type_of_end(end);
    const int next_crossed = !inside ? crossed : is_warp ? t.type_of_pick(next_pick) - t.warp_types : t.type_of_end(next_end);

    YarnPlace at;
    at.side = shift + part_way * part_way * (3 - 2 * part_way) * (next_shift - shift);
    at.half_height = yarn.half_height;
    at.half_width = yarn.half_width;
    if (!changes && next_crossed == crossed) { // it runs level
        at.height = t.height(is_warp, end, pick);
        return at;
    }
    const Real up_or_down = up == is_warp ? Real(1) : Real(-1);
    const float* profile = t.profile(yarn, crossed, next_crossed, is_warp, changes);
    const Real position = part_way * Real(t.samples - 1);
    const int low = position >= Real(t.samples - 2) ? t.samples - 2 : static_cast<int>(position);
    const Real part = position - Real(low);
    const float* a = profile + 4 * low;
    const float* b = a + 4;
    at.height = up_or_down * (Real(a[0]) + part * (Real(b[0]) - Real(a[0])));
    at.slope = up_or_down * Real(step) * (Real(a[1]) + part * (Real(b[1]) - Real(a[1])));
    at.half_height = Real(a[2]) + part * (Real(b[2]) - Real(a[2]));
    at.half_width = Real(a[3]) + part * (Real(b[3]) - Real(a[3]));
    return at;
}

/// Tests one yarn at one of its crossings; keeps the nearer. along and across are measured from the crossing's middle.
HL_FN void try_yarn(const TextileShape& t, bool is_warp, int end, int pick, Real along, Real across, Real z, Real reach,
                    NearestSkin& nearest)
{
    const YarnShape& yarn = is_warp ? t.warp_shape(end) : t.weft_shape(pick);
    const Real pitch = is_warp ? t.weft_pitch : t.warp_pitch; // from crossing to crossing
    const Real near = reach < nearest.distance ? reach : nearest.distance;
    if (across > yarn.widest + near || -across > yarn.widest + near) return;

    const YarnPlace at = yarn_place(t, is_warp, end, pick, along / pitch);
    const Real side = t.is_warp_up(end, pick) == is_warp ? Real(1) : Real(-1);
    const Real height = at.height, slope = at.slope, half_height = at.half_height, half_width = at.half_width;
    const int segment = t.segment(is_warp, end, pick);
    across -= at.side;
    const Real cosine = Real(1) / std::sqrt(Real(1) + slope * slope);
    const Real up_from_axis = (z - height) * cosine;
    const Real flat = half_width > half_height ? half_width - half_height : Real(0);
    const Real sideways = across > flat ? across - flat : across < -flat ? across + flat : Real(0);
    const Real from_core = std::sqrt(sideways * sideways + up_from_axis * up_from_axis);
    const Real distance = from_core - half_height;
    if (distance >= near) return;

    nearest.distance = distance;
    nearest.segment = segment;
    const Real inverse = from_core > Real(1e-12) ? Real(1) / from_core : Real(0);
    const Real n_side = from_core > Real(1e-12) ? sideways * inverse : Real(0);
    const Real n_up = from_core > Real(1e-12) ? up_from_axis * inverse : side;
    const Real n_along = -n_up * slope * cosine;
    const Real n_z = n_up * cosine;
    nearest.normal = is_warp ? Vec3{n_side, n_along, n_z} : Vec3{n_along, n_side, n_z};
}

/// The nearest skin within reach: the fabric's box, then the crossing the point is over, then the yarns through it and beside it.
HL_FN NearestSkin nearest_skin(const TextileShape& t, const Vec3& p, Real reach)
{
    NearestSkin nearest;
    nearest.distance = reach;
    if (p.z > t.half_thickness + reach || p.z < -t.half_thickness - reach) return nearest;
    const Real u = p.x / t.warp_pitch + Real(0.5) * Real(t.ends - 1);
    const Real v = p.y / t.weft_pitch + Real(0.5) * Real(t.picks - 1);
    const int end = static_cast<int>(std::floor(u + Real(0.5)));
    const int pick = static_cast<int>(std::floor(v + Real(0.5)));
    if (end < 0 || end >= t.ends || pick < 0 || pick >= t.picks) return nearest;
    for (int beside : {0, -1, 1}) { // the nearest first
        const int e = end + beside, k = pick + beside;
        if (e >= 0 && e < t.ends)
            try_yarn(t, true, e, pick, (v - Real(pick)) * t.weft_pitch, (u - Real(e)) * t.warp_pitch, p.z, reach, nearest);
        if (k >= 0 && k < t.picks)
            try_yarn(t, false, end, k, (u - Real(end)) * t.warp_pitch, (v - Real(k)) * t.weft_pitch, p.z, reach, nearest);
    }
    return nearest;
}

/// The nearest of a vessel's walls, if it is nearer than what was found.
HL_FN void try_vessel(const Vessel& v, const Vec3& x, NearestSkin& nearest)
{
    if (!v.present) return;
    const Real distance[5] = {x.z - v.low.z, x.x - v.low.x, v.high.x - x.x, x.y - v.low.y, v.high.y - x.y};
    const Vec3 normal[5] = {{0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    for (int k = 0; k < 5; ++k)
        if (distance[k] < nearest.distance) nearest = {distance[k], normal[k], vessel_wall};
}

/// Stops a particle on its way at the first skin it meets, whatever the way's length; a place under a skin is left by the shortest way.
/// It loses what it had towards the yarn and slides with friction. Between yarns it is dragged on as a liquid in a bed of rods (Kozeny and
/// Carman, constant 5, two over the radius of skin per volume): nu 20 s^2 / (r (1 - s))^2, s the share of the space that is yarn. A vessel
/// is smooth, lets the liquid slip, and keeps it half a spacing off.
struct MeetYarns {
    Particles p;
    TextileShape textile;
    Vessel vessel;
    Real reach;    ///< how far the wall is felt
    Real touching; ///< distance at which a particle rests on a skin; it never comes nearer than half of that, nor through such a hole
    Real half_spacing;
    const StepNumbers* step;
    Real lowest;           ///< below it a particle has dripped off
    std::int64_t* dripped; ///< quanta

    HL_FN void operator()(int i) const
    {
        if (!p.alive[i]) return;
        Vec3& x = p.position[i];
        Vec3& v = p.velocity[i];
        const Vec3 start{p.place[i].x, p.place[i].y, p.place[i].z};
        if (x.z < lowest) {
            p.alive[i] = 0;
            atomic_add(dripped, p.content[i]);
            return;
        }
        const Real yarn = p.cloth[i].share < Real(0.9) ? positive(p.cloth[i].share) : Real(0.9), open = Real(1) - yarn;
        v = (open * open / (open * open + step->drag * yarn * yarn)) * v;
        // No skin has come nearer than by the way.
        if (const Real free = p.wall_distance[i] - length(x - start); free > touching && !vessel.present) {
            p.wall_distance[i] = free;
            return;
        }
        x = stopped(start, x, p.wall_distance[i]);
        NearestSkin skin = nearest_skin(textile, x, reach);
        if (skin.segment >= 0) {
            if (skin.distance < touching) skin = leave(x, v, skin);
            if (skin.distance < Real(0.5) * touching) { // in a wedge between yarns
                x = start;
                v = {};
                skin = nearest_skin(textile, x, reach);
            }
        }
        try_vessel(vessel, x, skin);
        if (skin.segment == vessel_wall && skin.distance < half_spacing) {
            const Real approach = dot(v, skin.normal);
            if (approach < 0) v -= approach * skin.normal;
            x += (half_spacing - skin.distance) * skin.normal;
            skin.distance = half_spacing;
        }
        p.wall_distance[i] = skin.distance;
        p.wall_normal[i] = skin.normal;
        p.wall_segment[i] = skin.segment;
    }
    /// Takes a place out of the yarns it is in: by the shortest way out of one, then along its skin out of the next. In a narrow wedge that
    /// way would be long: it ends after twice the distance at which particles rest, and the place may be left too near.
    HL_FN NearestSkin leave(Vec3& x, Vec3& v, NearestSkin skin) const
    {
        lose_approach(v, skin.normal, step->friction);
        Vec3 way = skin.normal;
        constexpr int most_ways = 4;
        for (int k = 1;; ++k) {
            const Vec3 before = skin.normal;
            const Real longest = Real(2) * touching / length(way), wanted = touching - skin.distance;
            x += (wanted < longest || k == 1 ? wanted : longest) * way;
            skin = nearest_skin(textile, x, reach);
            if (skin.distance >= Real(0.9) * touching) return skin;
            lose_approaches(v, before, skin.normal);
            if (k == most_ways) return skin;
            const Real cosine = dot(before, skin.normal), sine2 = Real(1) - cosine * cosine;
            way = sine2 > least_sine2 ? (Real(1) / sine2) * (skin.normal - cosine * before) : skin.normal;
        }
    }
    static constexpr Real least_sine2 = Real(0.05); // of the angle between two skins, below which they count as parallel
    /// Between two skins: what is left of the velocity leads into neither.
    HL_FN static void lose_approaches(Vec3& v, const Vec3& a, const Vec3& b)
    {
        const Real towards_b = dot(v, b);
        if (towards_b >= 0) return;
        v -= towards_b * b;
        const Real towards_a = dot(v, a);
        if (towards_a >= 0) return;
        const Vec3 edge = cross(a, b);
        const Real edge2 = dot(edge, edge);
        v = edge2 > least_sine2 ? (dot(v, edge) / edge2) * edge : v - towards_a * a;
    }
    HL_FN void lose_approach(Vec3& v, const Vec3& normal, Real coefficient) const
    {
        const Real approach = dot(v, normal);
        if (approach >= 0) return;
        v -= approach * normal;
        const Real slide = length(v);
        const Real held = -coefficient * approach;
        v = slide > held ? (Real(1) - held / slide) * v : Vec3{};
    }
    /// Where a move ends: at the first place about half as near to a skin as particles rest (a quarter, at the least), so that they may
    /// slide. Goes on by what the nearest skin leaves free, less a part since yarns bend.
    HL_FN Vec3 stopped(const Vec3& start, const Vec3& end, Real free_at_start) const
    {
        const Real way = length(end - start);
        if (way <= free_at_start - Real(0.5) * touching) return end;
        const Real least = Real(0.25) * touching;
        Real free = free_at_start - Real(0.5) * touching, gone = 0;
        constexpr int most_pieces = 200;
        for (int k = 0; k < most_pieces; ++k) {
            const Real piece = Real(0.7) * free;
            gone += piece > least ? piece : least;
            if (gone >= way) return end;
            const Vec3 here = start + (gone / way) * (end - start);
            free = nearest_skin(textile, here, reach).distance - Real(0.5) * touching;
            if (free < 0) return here;
        }
        return start + (gone / way) * (end - start);
    }
};

/// Adds up squares of the speeds that the cloth has left.
struct SumSpeeds {
    Particles p;
    std::int64_t* total; ///< quanta
    int* largest;        ///< bits of the largest away from the cloth; squares are positive, so their bits order like integers

    static constexpr double quantum = 1e-12; ///< m2/s2
    HL_FN std::int64_t operator()(int i) const
    {
        if (!p.alive[i]) return 0;
        constexpr float moves = 1.0F; // m2/s2, far more than at rest; without a bound the sum of many could overflow
        const auto whole = static_cast<float>(dot(p.velocity[i], p.velocity[i])), square = whole < moves ? whole : moves;
        if (p.cloth[i].surface_share <= Real(0)) atomic_max_of_all(largest, ordered_bits(square));
        return static_cast<std::int64_t>(static_cast<double>(square) / quantum);
    }
};

/// The end of a step for a particle: it moves, meets the yarns, and is ready for the next step, unless yarns drink from it before.
struct Arrive {
    MoveParticles move;
    MeetYarns meet;
    SumSpeeds speeds;
    BeginStep begin;
    std::int64_t* total = speeds.total;
    HL_FN std::int64_t operator()(int i) const
    {
        move(i);
        meet(i);
        if (begin(i) > 0) atomic_add(begin.total, 1);
        return speeds(i);
    }
};

/// Gap between two intervals given by their middles and half lengths; 0 where they overlap.
HL_FN Real interval_gap(Real a, Real half_a, Real b, Real half_b)
{
    const Real gap = (a > b ? a - b : b - a) - half_a - half_b;
    return gap > 0 ? gap : Real(0);
}

/// Calls visit(segment) for every segment whose box the particle's cube of liquid touches: the crossing under it and those beside.
template <typename Visit> HL_FN void for_touched_segments(const TextileShape& t, const Vec3& x, Real spacing, const Visit& visit)
{
    const int end = static_cast<int>(std::floor(x.x / t.warp_pitch + Real(0.5) * Real(t.ends)));
    const int pick = static_cast<int>(std::floor(x.y / t.weft_pitch + Real(0.5) * Real(t.picks)));
    const Real half = Real(0.5) * spacing;
    const Real nearly = Real(0.1) * spacing; // a resting particle's middle lies half a spacing from the skin
    for (int e = end > 0 ? end - 1 : 0; e <= end + 1 && e < t.ends; ++e) {
        const Real xe = (Real(e) - Real(0.5) * Real(t.ends - 1)) * t.warp_pitch;
        const bool in_column = interval_gap(x.x, half, xe, Real(0.5) * t.warp_pitch) <= 0;
        for (int k = pick > 0 ? pick - 1 : 0; k <= pick + 1 && k < t.picks; ++k) {
            const Real yk = (Real(k) - Real(0.5) * Real(t.picks - 1)) * t.weft_pitch;
            const auto touches = [&](bool is_warp, const YarnShape& yarn, Real across, Real place) {
                return interval_gap(across, half, place + Real(t.shift[t.segment(is_warp, e, k)]), yarn.half_width) <= 0 &&
                       interval_gap(x.z, half, t.height(is_warp, e, k), yarn.half_height) <= nearly;
            };
            if (interval_gap(x.y, half, yk, Real(0.5) * t.weft_pitch) <= 0 && touches(true, t.warp_shape(e), x.x, xe))
                visit(t.segment(true, e, k));
            if (in_column && touches(false, t.weft_shape(k), x.y, yk)) visit(t.segment(false, e, k));
        }
    }
}

constexpr int particle_numbers = 1 << 23;

/// As what a segment notes a particle: the fullest comes first, then by number.
HL_FN int note_of(const Particles& p, int i)
{
    constexpr int fullest = 255;
    const int fullness = static_cast<int>(Real(fullest) * p.size(i));
    return (fullness < fullest ? fullest - fullness : 0) * particle_numbers + i;
}
HL_FN bool notes(int note, int i) { return note % particle_numbers == i; }

/// Every segment notes the fullest particle that touches it.
struct TouchSegments {
    Particles p;
    TextileShape textile;
    int* contact;

    HL_FN void operator()(int i) const
    {
        if (!p.alive[i] || p.wall_distance[i] > p.spacing) return;
        for_touched_segments(textile, p.position[i], p.spacing,
                             [&, note = note_of(p, i)](int segment) { atomic_min(contact + segment, note); });
    }
};

/// The noted particle gives its segments what suction lets through their skins in this step, in whole quanta, never more than the
/// pores hold. A segment drinks from one particle only, so nothing is given twice. A particle shrinks until it is empty, and
/// then is gone.
struct GiveToSegments {
    Particles p;
    TextileShape textile;
    Segments s;
    double density;
    const double* dt; ///< s, for which they drink
    Reach reach;
    std::int64_t* drunk; ///< quanta

    HL_FN void operator()(int i) const
    {
        if (!p.alive[i] || p.wall_distance[i] > p.spacing) return;
        for_touched_segments(textile, p.position[i], p.spacing, [&](int segment) {
            if (notes(s.contact[segment], i)) give(i, segment);
        });
        if (p.content[i] == 0) p.alive[i] = 0;
    }
    HL_FN void give(int i, int segment) const
    {
        const YarnParameters& yarn = s.yarn_of(segment);
        const double capacity = density * s.pores[segment];
        const double room = capacity - s.liquid[segment] - static_cast<double>(s.absorbed[segment]) * water_quantum;
        if (room <= 0) return;
        const double wanted = *dt * yarn.intake_flux * yarn.face_area * room / capacity;
        const double most = (wanted < room ? wanted : room) / water_quantum;
        const std::int64_t given = most < static_cast<double>(p.content[i]) ? static_cast<std::int64_t>(most) : p.content[i];
        if (given == 0) return;
        s.absorbed[segment] += given;
        p.content[i] -= given;
        atomic_add(drunk, given);
        reach.include(s, s.crossing_of(segment));
    }
};

/// Segments whose pores have become too narrow for their liquid give some of it back, as a particle over or under their yarn.
struct GiveBack {
    Particles p;
    TextileShape textile;
    Segments s;
    double density;
    const int* from; ///< the segments, each of which gives to the particle at its own place behind the first
    int first;
    Real clear; ///< m, from a skin

    HL_FN void operator()(int k) const
    {
        const int segment = from[k], i = first + k, crossing = s.crossing_of(segment);
        const bool is_warp = s.is_warp(segment);
        const int end = crossing / s.picks, pick = crossing % s.picks;
        const double surplus = s.work0[segment], most = static_cast<double>(p.mass);
        const auto given = static_cast<std::int64_t>((surplus < most ? surplus : most) / water_quantum);
        const double mass = static_cast<double>(given) * water_quantum;
        s.liquid[segment] -= mass;
        s.pores[segment] -= mass / density;
        s.lost[segment] += mass * water_specific_heat * s.warmth[segment];

        const YarnShape& yarn = is_warp ? textile.warp_shape(end) : textile.weft_shape(pick);
        const Real side = textile.is_warp_up(end, pick) == is_warp ? Real(1) : Real(-1), shift = Real(textile.shift[segment]);
        p.position[i] = {(Real(end) - Real(0.5) * Real(textile.ends - 1)) * textile.warp_pitch + (is_warp ? shift : Real(0)),
                         (Real(pick) - Real(0.5) * Real(textile.picks - 1)) * textile.weft_pitch + (is_warp ? Real(0) : shift),
                         textile.height(is_warp, end, pick) + side * (yarn.half_height + clear)};
        p.velocity[i] = p.wall_normal[i] = {};
        p.wall_distance[i] = 0; // not looked for yet
        p.wall_segment[i] = no_wall;
        p.cloth_from[i] = {};
        p.place[i] = {};
        p.content[i] = given;
        p.alive[i] = 1;
    }
};

struct ForgetContact {
    Particles p;
    TextileShape textile;
    int* contact;
    HL_FN void operator()(int i) const
    {
        if (p.wall_distance[i] <= p.spacing)
            for_touched_segments(textile, p.position[i], p.spacing, [&](int segment) {
                if (notes(contact[segment], i)) contact[segment] = no_particle;
            });
    }
};

} // namespace hygroloom::inline HL_PRECISION
