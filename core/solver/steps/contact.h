// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where the liquid meets the yarns: the nearest skin through the box hierarchy (fabric, crossing, yarn), contact, and drinking.
#pragma once

#include "core/physics/water.h"
#include "core/solver/steps/liquid.h"

namespace hygroloom::inline HL_PRECISION {

/// One type of yarn at a crossing.
struct YarnShape {
    Real half_height = 0;
    Real half_width = 0;
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
    /// Per segment, to the crossing before and to the one after: first sample of the profile that it follows, side of the other yarn
    /// that it is on at its own crossing (1 over it, -1 under it), its shift there and how much greater that is at the next crossing. All
    /// in one place since every particle near a skin looks it up.
    const Quad* paths = nullptr;
    const std::uint8_t* warp_up = nullptr;
    const float* shift = nullptr; ///< per segment, beside the yarn's place

    template <typename Whole> HL_FN Whole segment(bool is_warp, const Whole& end, const Whole& pick) const
    {
        return is_warp ? end * picks + pick : ends * picks + pick * ends + end;
    }
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

/// The skin nearest to a point, or to each of a pack of points.
template <typename Number> struct Nearest {
    using Whole = decltype(whole(Number{}));
    Number distance{};           ///< less than 0 inside
    Vec3T<Number> normal;        ///< out of the yarn
    Whole segment = Whole{} - 1; ///< -1: none within reach
};
using NearestSkin = Nearest<Real>;
#if !HL_LANE_IS_THREAD
inline NearestSkin skin_of(const Nearest<Pack>& skins, int lane)
{
    return {skins.distance[lane], {skins.normal.x[lane], skins.normal.y[lane], skins.normal.z[lane]}, skins.segment[lane]};
}
#endif

/// How far a place is along the yarns of one system: part of the way from a crossing to the next, about 1/2 at most.
template <typename Number> struct AlongYarn {
    using Whole = decltype(whole(Number{}));
    Whole forth;  ///< 1: the next crossing is the one after; 0: the one before
    Number step;  ///< 1 or -1, to the next crossing
    Whole low;    ///< sample of a profile before the place
    Number part;  ///< of the way to the next sample
    Number eased; ///< how far the yarn has gone over from its own side to the next crossing's

    HL_FN AlongYarn(const TextileShape& t, const Number& from_crossing)
    {
        const auto onwards = from_crossing >= 0;
        forth = choose(onwards, Whole{} + 1, Whole{});
        step = choose(onwards, Number{} + 1, Number{} - 1);
        const Number part_way = size_of(from_crossing), position = part_way * Real(t.samples - 1);
        low = whole(position);
        part = position - real(low);
        eased = part_way * part_way * (Real(3) - Real(2) * part_way);
    }
};

/// A yarn at one place along it.
template <typename Number> struct YarnPlace {
    Number side; ///< of its middle from the crossing's, across it
    Number height, slope;
    Number half_height, half_width;
};

/// The yarn of one segment, so far along to the next.
template <typename Number, typename Whole>
HL_FN YarnPlace<Number> yarn_place(const TextileShape& t, const Whole& segment, const AlongYarn<Number>& along)
{
    const auto path = quad_at(t.paths, 2 * segment + along.forth);
    const Whole sample = whole(path.x) + along.low;
    const auto a = quad_at(t.profiles, sample), b = quad_at(t.profiles + 1, sample);
    return {path.z + along.eased * path.w, path.y * (a.x + along.part * (b.x - a.x)),
            path.y * along.step * (a.y + along.part * (b.y - a.y)), a.z + along.part * (b.z - a.z), a.w + along.part * (b.w - a.w)};
}

/// The skin of one segment's yarn, seen from a point beside its crossing; or a pack of such.
template <typename Number> struct YarnSkin {
    using Whole = decltype(whole(Number{}));
    Whole segment;
    Number of_warp;       ///< 1, or 0 of the weft
    Number height, slope; ///< of the yarn's middle
    Number sideways;      ///< to the point from the flat part of the yarn's core
    Number over;          ///< to the point from the yarn's middle
    Number cosine2;       ///< of the slope
    Number from_core;
    Number distance;

    HL_FN YarnSkin(const TextileShape& t, bool is_warp, const Whole& tried, const AlongYarn<Number>& along, const Number& across,
                   const Number& z)
        : segment(tried), of_warp(Number{} + Real(is_warp ? 1 : 0))
    {
        const YarnPlace<Number> at = yarn_place(t, tried, along);
        height = at.height;
        slope = at.slope;
        const Number beside = across - at.side, past = positive(size_of(beside) - positive(at.half_width - at.half_height));
        sideways = choose(beside < 0, -past, past);
        over = z - at.height;
        cosine2 = inverse(Number{} + 1 + at.slope * at.slope);
        from_core = root(past * past + over * over * cosine2);
        distance = from_core - at.half_height;
    }
    template <typename Mask> HL_FN void replace_where(const Mask& nearer, const YarnSkin& other)
    {
        segment = choose(nearer, other.segment, segment);
        of_warp = choose(nearer, other.of_warp, of_warp);
        height = choose(nearer, other.height, height);
        slope = choose(nearer, other.slope, slope);
        sideways = choose(nearer, other.sideways, sideways);
        over = choose(nearer, other.over, over);
        cosine2 = choose(nearer, other.cosine2, cosine2);
        from_core = choose(nearer, other.from_core, from_core);
        distance = choose(nearer, other.distance, distance);
    }
    HL_FN Vec3T<Number> normal() const
    {
        const auto has_direction = from_core > Real(1e-12), is_warp = of_warp > 0;
        const Number away = choose(height < 0, Number{} - 1, Number{} + 1), cosine = root(cosine2);
        const Number one_over = choose(has_direction, inverse(from_core), Number{}), n_side = sideways * one_over;
        const Number n_z = choose(has_direction, over * cosine * one_over, away) * cosine, n_along = -n_z * slope;
        return {choose(is_warp, n_side, n_along), choose(is_warp, n_along, n_side), n_z};
    }
};

/// The nearest skin within reach of a place, or of each of a pack of places: the fabric's box, then the yarns through the crossing that
/// the place is over, then those beside it.
template <typename Number> HL_FN Nearest<Number> nearest_skins(const TextileShape& t, const Vec3T<Number>& p, Real reach)
{
    using Whole = decltype(whole(Number{}));
    const Number nothing{}, far = nothing + reach;
    const Whole none = Whole{} - 1;
    const Number u = p.x * t.per_warp_pitch + Real(0.5) * Real(t.ends - 1), u_past = u + Real(0.5);
    const Number v = p.y * t.per_weft_pitch + Real(0.5) * Real(t.picks - 1), v_past = v + Real(0.5);
    const auto is_near =
        (size_of(p.z) <= t.half_thickness + reach) & (u_past >= 0) & (u_past < Real(t.ends)) & (v_past >= 0) & (v_past < Real(t.picks));
    if (!any(is_near)) return {far, {}, none};
    const Whole end = whole(choose(is_near, u_past, nothing)), pick = whole(choose(is_near, v_past, nothing));
    const Number from_end = choose(is_near, u - real(end), nothing), from_pick = choose(is_near, v - real(pick), nothing);
    const AlongYarn<Number> along_warp(t, from_pick), along_weft(t, from_end);
    const Number across_warp = from_end * t.warp_pitch, across_weft = from_pick * t.weft_pitch;
    YarnSkin<Number> skin(t, true, t.segment(true, end, pick), along_warp, across_warp, p.z);
    const YarnSkin<Number> weft(t, false, t.segment(false, end, pick), along_weft, across_weft, p.z);
    skin.replace_where(weft.distance < skin.distance, weft);
    const auto try_beside = [&](bool is_warp, const Number& step, const AlongYarn<Number>& along, const Number& across) {
        const Real pitch = is_warp ? t.warp_pitch : t.weft_pitch, widest = is_warp ? t.widest_warp : t.widest_weft;
        const Number yarn = real(is_warp ? end : pick) + step, gap = pitch - step * across - widest;
        const auto may_reach = is_near & (gap <= skin.distance) & (gap <= reach) & (yarn >= 0) & (yarn < Real(is_warp ? t.ends : t.picks));
        if (!any(may_reach)) return;
        const Whole next = whole(choose(may_reach, yarn, nothing));
        const Whole segment = is_warp ? t.segment(true, next, pick) : t.segment(false, end, next);
        const YarnSkin<Number> other(t, is_warp, segment, along, across - step * pitch, p.z);
        skin.replace_where(may_reach & (other.distance < skin.distance), other);
    };
    for (Real side : {Real(1), Real(-1)}) { // the nearer one first
        try_beside(true, choose(across_warp < 0, nothing - side, nothing + side), along_warp, across_warp);
        try_beside(false, choose(across_weft < 0, nothing - side, nothing + side), along_weft, across_weft);
    }
    const auto within = is_near & (skin.distance < reach);
    const Vec3T<Number> normal = skin.normal();
    return {choose(within, skin.distance, far),
            {choose(within, normal.x, nothing), choose(within, normal.y, nothing), choose(within, normal.z, nothing)},
            choose(within, skin.segment, none)};
}

HL_FN NearestSkin nearest_skin(const TextileShape& t, const Vec3& p, Real reach) { return nearest_skins(t, p, reach); }

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
        Search s;
        if (!begin(s, i)) return;
        while (go_on(s, nearest_skin(textile, s.place, reach))) {}
    }
#if !HL_LANE_IS_THREAD
    /// The same for particles side by side, of which as many as a pack has lanes look for skins at once.
    void operator()(int first, int last) const
    {
        Search searches[lanes];
        bool looks[lanes] = {};
        Real x[lanes] = {}, y[lanes] = {}, z[lanes] = {};
        int next = first;
        for (;;) {
            bool any_looks = false;
            for (int lane = 0; lane < lanes; ++lane) {
                Search& s = searches[lane];
                while (!looks[lane] && next < last) looks[lane] = begin(s, next++);
                x[lane] = s.place.x, y[lane] = s.place.y, z[lane] = s.place.z;
                any_looks |= looks[lane];
            }
            if (!any_looks) return;
            const Nearest<Pack> found = nearest_skins(textile, Packs{load(x), load(y), load(z)}, reach);
            for (int lane = 0; lane < lanes; ++lane) looks[lane] = looks[lane] && go_on(searches[lane], skin_of(found, lane));
        }
    }
#endif

private:
    /// A particle that looks for the skins on its way, one place after the other.
    struct Search {
        Vec3 place; ///< to look at next
        int particle;
        enum { on_its_way, at_its_end, out_of_yarns, back_at_start } where;
        int places;     ///< on the way, or out of yarns, so far
        Real way, gone; ///< m, to the end and so far
        Vec3 normal;    ///< of the skin that it has just left
    };
    /// Whether it needs to look for skins.
    HL_FN bool begin(Search& s, int i) const
    {
        if (!p.alive[i]) return false;
        const Vec3& x = p.position[i];
        Vec3& v = p.velocity[i];
        if (room.was_left(x)) {
            p.alive[i] = 0;
            atomic_add(dripped, p.content[i]);
            return false;
        }
        const Real yarn = p.cloth[i].share < Real(0.9) ? positive(p.cloth[i].share) : Real(0.9), open = Real(1) - yarn;
        v = (open * open / (open * open + step->drag * yarn * yarn)) * v;
        s.way = length(x - start_of(i));
        const Real at_start = p.wall_distance[i];
        // No skin has come nearer than by the way.
        if (const Real free = at_start - s.way; free > touching && !vessel.present) {
            p.wall_distance[i] = free;
            return false;
        }
        s.particle = i;
        s.places = 0;
        s.gone = 0;
        const Real free = at_start - Real(0.5) * touching;
        if (s.way <= free)
            look_at_end(s);
        else
            look_further(s, free);
        return true;
    }
    /// With the skin nearest to the place it looked at; whether it must look at another.
    HL_FN bool go_on(Search& s, const NearestSkin& skin) const
    {
        Vec3 &x = p.position[s.particle], &v = p.velocity[s.particle];
        if (s.where == Search::on_its_way) {
            constexpr int most_pieces = 200;
            const Real free = skin.distance - Real(0.5) * touching;
            if (free >= 0 && s.places++ < most_pieces) {
                look_further(s, free);
                return true;
            }
            x = s.place;
        }
        if (s.where == Search::on_its_way || s.where == Search::at_its_end) {
            if (skin.segment >= 0 && skin.distance < touching) {
                lose_approach(v, skin.normal, step->friction);
                s.places = 0;
                push(s, x, skin.normal, skin);
                return true;
            }
        } else if (s.where == Search::out_of_yarns) {
            constexpr int most_ways = 4;
            if (skin.distance < Real(0.9) * touching) {
                lose_approaches(v, s.normal, skin.normal);
                if (s.places < most_ways) {
                    const Real cosine = dot(s.normal, skin.normal), sine2 = Real(1) - cosine * cosine;
                    push(s, x, sine2 > least_sine2 ? (Real(1) / sine2) * (skin.normal - cosine * s.normal) : skin.normal, skin);
                    return true;
                }
            }
            if (skin.distance < Real(0.5) * touching) { // in a wedge between yarns
                x = s.place = start_of(s.particle);
                v = {};
                s.where = Search::back_at_start;
                return true;
            }
        }
        rest(s.particle, skin);
        return false;
    }
    HL_FN Vec3 start_of(int i) const { return {p.place[i].x, p.place[i].y, p.place[i].z}; }
    HL_FN void look_at_end(Search& s) const
    {
        s.place = p.position[s.particle];
        s.where = Search::at_its_end;
    }
    /// A move ends at the first place about half as near to a skin as particles rest (a quarter, at the least), so that they may slide.
    /// Goes on by what the nearest skin leaves free, less a part since yarns bend.
    HL_FN void look_further(Search& s, Real free) const
    {
        const Real piece = Real(0.7) * free, least = Real(0.25) * touching;
        s.gone += piece > least ? piece : least;
        if (s.gone >= s.way) {
            look_at_end(s);
            return;
        }
        const Vec3 start = start_of(s.particle);
        s.place = start + (s.gone / s.way) * (p.position[s.particle] - start);
        s.where = Search::on_its_way;
    }
    /// Takes a place out of the yarns it is in: by the shortest way out of one, then along its skin out of the next. In a narrow wedge that
    /// way would be long: it ends after twice the distance at which particles rest, and the place may be left too near.
    HL_FN void push(Search& s, Vec3& x, const Vec3& way, const NearestSkin& skin) const
    {
        const Real longest = Real(2) * touching / length(way), wanted = touching - skin.distance;
        x += (wanted < longest || s.places == 0 ? wanted : longest) * way;
        s.place = x;
        s.normal = skin.normal;
        s.where = Search::out_of_yarns;
        ++s.places;
    }
    /// Where a particle has come to, the nearest skin is known; or a vessel's wall is nearer.
    HL_FN void rest(int i, NearestSkin skin) const
    {
        Vec3 &x = p.position[i], &v = p.velocity[i];
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
};

/// Adds up squares of the speeds that the cloth has left, times the particles' sizes: one that is nearly drunk rattles with no force to
/// speak of. The largest is of any particle, whatever is left of it.
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
        return static_cast<std::int64_t>(static_cast<double>(p.size(i)) * static_cast<double>(square) / quantum);
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
        return get_ready(i);
    }
#if !HL_LANE_IS_THREAD
    /// The same for particles side by side.
    std::int64_t operator()(int first, int last) const
    {
        for (int i = first; i < last; ++i) move(i);
        meet(first, last);
        std::int64_t sum = 0;
        for (int i = first; i < last; ++i) sum += get_ready(i);
        return sum;
    }
#endif

private:
    HL_FN std::int64_t get_ready(int i) const
    {
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
