// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where the liquid meets the yarns: the nearest skin through the box hierarchy (fabric, crossing, yarn), contact, and drinking.
#pragma once

#include "core/physics/water.h"
#include "core/sim/steps/liquid.h"

namespace hygroloom::inline HL_PRECISION {

/// One type of yarn at a crossing.
struct YarnShape {
    Real half_height = 0;
    Real half_width = 0;
};

/// How a yarn goes on from a crossing to a neighbouring one, in one number since every particle near a skin looks it up.
struct PathCode {
    int code = 0;
    HL_FN static PathCode of(int profile, bool is_under, bool has_next) { return {4 * profile + (has_next ? 2 : 0) + (is_under ? 1 : 0)}; }
    HL_FN int profile() const { return code >> 2; }
    HL_FN int steps_to_next() const { return code >> 1 & 1; }    ///< 0 where the yarn ends
    HL_FN Real side() const { return Real(1 - 2 * (code & 1)); } ///< at its own crossing: 1 over the other yarn, -1 under it
};

struct TextileShape : Yarns {
    Real half_thickness = 0;
    Real warp_pitch = 0; ///< from end to end
    Real weft_pitch = 0;
    Real per_warp_pitch = 0, per_weft_pitch = 0; ///< 1/m
    Real widest_warp = 0;                        ///< from an end's place to its farthest side, anywhere, of all types
    Real widest_weft = 0;
    int samples = 0;                   ///< of a profile, from crossing to crossing
    const YarnShape* shapes = nullptr; ///< per type, as parameters
    const Quad* profiles = nullptr;    ///< height, slope, half height, half width per sample
    const PathCode* paths = nullptr;   ///< per segment, to the crossing before and to the one after
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
};

/// The skin nearest to a point.
struct NearestSkin {
    Real distance = 0; ///< less than 0 inside
    Vec3 normal;       ///< out of the yarn
    int segment = -1;  ///< -1: none within reach
};

HL_FN Real size_of(Real value) { return value < 0 ? -value : value; }

/// How far a place is along the yarns of one system: part of the way from a crossing to the next, 1/2 at most.
struct AlongYarn {
    bool forth; ///< the next crossing is the one after, else the one before
    int low;    ///< sample of a profile before the place
    Real part;  ///< of the way to the next sample
    Real eased; ///< how far the yarn has gone over from its own side to the next crossing's

    HL_FN AlongYarn(const TextileShape& t, Real from_crossing)
    {
        forth = from_crossing >= 0;
        const Real part_way = forth ? from_crossing : -from_crossing, position = part_way * Real(t.samples - 1);
        const int before = static_cast<int>(position), last = t.samples - 2;
        low = before < last ? before : last;
        part = position - Real(low);
        eased = part_way * part_way * (3 - 2 * part_way);
    }
    HL_FN int step() const { return forth ? 1 : -1; }
};

/// A yarn at one place along it.
struct YarnPlace {
    Real side = 0; ///< of its middle from the crossing's, across it
    Real height = 0, slope = 0;
    Real half_height = 0, half_width = 0;
};

/// The yarn of one segment, so far along to the next.
HL_FN YarnPlace yarn_place(const TextileShape& t, int segment, const AlongYarn& along)
{
    const PathCode path = t.paths[2 * segment + (along.forth ? 1 : 0)];
    const Quad* sample = t.profiles + path.profile() * t.samples + along.low;
    const Quad a = sample[0], b = sample[1];
    const Real shift = Real(t.shift[segment]), next_shift = Real(t.shift[segment + path.steps_to_next() * along.step()]);
    return {shift + along.eased * (next_shift - shift), path.side() * (a.x + along.part * (b.x - a.x)),
            path.side() * Real(along.step()) * (a.y + along.part * (b.y - a.y)), a.z + along.part * (b.z - a.z),
            a.w + along.part * (b.w - a.w)};
}

/// The skin of one segment's yarn, seen from a point beside its crossing.
struct YarnSkin {
    int segment;
    YarnPlace at;
    Real sideways; ///< to the point from the flat part of the yarn's core
    Real over;     ///< to the point from the yarn's middle
    Real cosine2;  ///< of the slope
    Real from_core;

    HL_FN YarnSkin(const TextileShape& t, int tried, const AlongYarn& along, Real across, Real z) : segment(tried)
    {
        at = yarn_place(t, tried, along);
        const Real beside = across - at.side, past = positive(size_of(beside) - positive(at.half_width - at.half_height));
        sideways = beside < 0 ? -past : past;
        over = z - at.height;
        cosine2 = Real(1) / (Real(1) + at.slope * at.slope);
        from_core = std::sqrt(past * past + over * over * cosine2);
    }
    HL_FN Real distance() const { return from_core - at.half_height; }
    HL_FN Vec3 normal(bool is_warp) const
    {
        const bool has_direction = from_core > Real(1e-12);
        const Real inverse = has_direction ? Real(1) / from_core : Real(0), cosine = std::sqrt(cosine2);
        const Real n_side = sideways * inverse, n_up = has_direction ? over * cosine * inverse : at.height < 0 ? Real(-1) : Real(1);
        const Real n_z = n_up * cosine, n_along = -n_z * at.slope;
        return is_warp ? Vec3{n_side, n_along, n_z} : Vec3{n_along, n_side, n_z};
    }
};

/// The nearest skin within reach: the fabric's box, then the yarns through the crossing that the point is over, then those beside it.
HL_FN NearestSkin nearest_skin(const TextileShape& t, const Vec3& p, Real reach)
{
    NearestSkin nearest;
    nearest.distance = reach;
    if (p.z > t.half_thickness + reach || p.z < -t.half_thickness - reach) return nearest;
    const Real u = p.x * t.per_warp_pitch + Real(0.5) * Real(t.ends - 1);
    const Real v = p.y * t.per_weft_pitch + Real(0.5) * Real(t.picks - 1);
    const int end = static_cast<int>(std::floor(u + Real(0.5)));
    const int pick = static_cast<int>(std::floor(v + Real(0.5)));
    if (end < 0 || end >= t.ends || pick < 0 || pick >= t.picks) return nearest;
    const AlongYarn along_warp(t, v - Real(pick)), along_weft(t, u - Real(end));
    const Real across_warp = (u - Real(end)) * t.warp_pitch, across_weft = (v - Real(pick)) * t.weft_pitch;
    YarnSkin skin(t, t.segment(true, end, pick), along_warp, across_warp, p.z);
    const auto keep_nearer = [&](const YarnSkin& other) {
        if (other.distance() < skin.distance()) skin = other;
    };
    keep_nearer({t, t.segment(false, end, pick), along_weft, across_weft, p.z});
    const auto reaches = [&](Real widest, Real across) { return across <= widest + (skin.distance() < reach ? skin.distance() : reach); };
    if (reaches(t.widest_warp, t.warp_pitch - size_of(across_warp)))
        for (int step : {-1, 1})
            if (end + step >= 0 && end + step < t.ends)
                keep_nearer({t, t.segment(true, end + step, pick), along_warp, across_warp - Real(step) * t.warp_pitch, p.z});
    if (reaches(t.widest_weft, t.weft_pitch - size_of(across_weft)))
        for (int step : {-1, 1})
            if (pick + step >= 0 && pick + step < t.picks)
                keep_nearer({t, t.segment(false, end, pick + step), along_weft, across_weft - Real(step) * t.weft_pitch, p.z});
    if (skin.distance() < reach) nearest = {skin.distance(), skin.normal(t.is_warp(skin.segment)), skin.segment};
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

/// Where liquid may be about the sample; what leaves that has dripped off, for it cannot come back.
struct Room {
    Real half_x = 0, half_y = 0;
    Real lowest = 0;

    HL_FN bool was_left(const Vec3& x) const { return x.z < lowest || size_of(x.x) > half_x || size_of(x.y) > half_y; }
};

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
    Room room;
    std::int64_t* dripped; ///< quanta

    HL_FN void operator()(int i) const
    {
        if (!p.alive[i]) return;
        Vec3& x = p.position[i];
        Vec3& v = p.velocity[i];
        const Vec3 start{p.place[i].x, p.place[i].y, p.place[i].z};
        if (room.was_left(x)) {
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
        NearestSkin skin = stop(start, x, p.wall_distance[i]);
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
    /// Ends a move at the first place about half as near to a skin as particles rest (a quarter, at the least), so that they may slide; the
    /// skin nearest to its end. Goes on by what the nearest skin leaves free, less a part since yarns bend.
    HL_FN NearestSkin stop(const Vec3& start, Vec3& x, Real free_at_start) const
    {
        const Vec3 move = x - start;
        const Real way = length(move), least = Real(0.25) * touching;
        Real free = free_at_start - Real(0.5) * touching;
        if (way <= free) return nearest_skin(textile, x, reach);
        Real gone = 0;
        constexpr int most_pieces = 200;
        for (int k = 0;; ++k) {
            const Real piece = Real(0.7) * free;
            gone += piece > least ? piece : least;
            if (gone >= way) return nearest_skin(textile, x, reach);
            const Vec3 here = start + (gone / way) * move;
            const NearestSkin skin = nearest_skin(textile, here, reach);
            free = skin.distance - Real(0.5) * touching;
            if (free >= 0 && k < most_pieces) continue;
            x = here;
            return skin;
        }
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
