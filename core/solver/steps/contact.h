// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where particles meet yarns and vessels: they stop at skins, slide, and rest.
#pragma once

#include "core/solver/steps/liquid.h"
#include "core/solver/steps/skin.h"

namespace hygroloom::inline HL_PRECISION {

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

/// Adds up squares of the speeds that the cloth has left, times the particles' sizes: one that is nearly absorbed rattles with no force to
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

/// The end of a step for a particle: it moves, meets the yarns, and is ready for the next step, unless yarns absorb from it before.
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

} // namespace hygroloom::inline HL_PRECISION
