// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The nearest skin of a yarn to a place, through the box hierarchy: fabric, crossing, yarn.
#pragma once

#include "core/base/lanes.h"
#include "core/solver/particles.h"
#include "core/solver/segments.h"

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
    bool has_rooms = false;            ///< whether liquid passes into the room between yarns, too
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
    HL_FN const YarnShape& warp_shape(int end) const { return shapes[type[end]]; } // drops fall on whole rectangles only
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

} // namespace hygroloom::inline HL_PRECISION
