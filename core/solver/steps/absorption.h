// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What passes between particles and yarns: segments absorb from the particles that touch them, swollen ones give liquid back.
#pragma once

#include "core/physics/water.h"
#include "core/solver/steps/skin.h"
#include "core/solver/steps/supply.h"

namespace hygroloom::inline HL_PRECISION {

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
            if (t.has_rooms && e == end && k == pick && x.z - half <= t.half_thickness + nearly) visit(2 * t.crossings() + e * t.picks + k);
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
/// pores hold. A segment absorbs from one particle in each turn, so nothing is given twice. A particle shrinks until it is empty, and
/// then is gone.
struct GiveToSegments {
    Particles p;
    TextileShape textile;
    Segments s;
    double density;
    const double* dt; ///< s, for which they absorb in this turn
    Reach reach;
    std::int64_t* absorbed; ///< quanta

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
        const Taker taker{s, density, segment};
        const double room = taker.room();
        if (room <= 0) return;
        const double wanted = taker.draws(*dt, room, true);
        const double most = (wanted < room ? wanted : room) / water_quantum;
        const std::int64_t given = most < static_cast<double>(p.content[i]) ? static_cast<std::int64_t>(most) : p.content[i];
        if (given == 0) return;
        s.absorbed[segment] += given;
        p.content[i] -= given;
        atomic_add(absorbed, given);
        reach.include(s, taker.crossing());
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
    /// Returns whether it was noted. Only the particle that is writes. Others may read meanwhile: before or after, it is not them.
    HL_FN static bool forget(int& note, int i)
    {
#ifdef __CUDA_ARCH__
        const bool noted = notes(note, i);
        if (noted) note = no_particle;
#else
        const bool noted = notes(__atomic_load_n(&note, __ATOMIC_RELAXED), i);
        if (noted) __atomic_store_n(&note, no_particle, __ATOMIC_RELAXED);
#endif
        return noted;
    }
    Particles p;
    TextileShape textile;
    int* contact;
    std::int64_t* total; ///< quanta that particles still hold; nullptr: not counted
    HL_FN std::int64_t operator()(int i) const
    {
        if (p.wall_distance[i] <= p.spacing)
            for_touched_segments(textile, p.position[i], p.spacing, [&](int segment) { forget(contact[segment], i); });
        return p.alive[i] ? p.content[i] : 0;
    }
};

} // namespace hygroloom::inline HL_PRECISION
