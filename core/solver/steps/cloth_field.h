// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How the cloth acts on the free liquid from a distance: yarns as rows of beads that count as liquid, with forces that have an energy.
#pragma once

#include "core/physics/fluid_forces.h"
#include "core/solver/steps/skin.h"

namespace hygroloom::inline HL_PRECISION {

/// Of the beads of one type of yarn.
struct BeadType {
    Real support = 0; ///< m, of the kernel of pressure, as wide as one convolved with a bead
    Real reach = 0;   ///< m, of the surface's kernel, the same
    Real share = 1;   ///< how much it counts as liquid for the surface: see bead_share()
    Real pull = 0;    ///< N/m2: energy of the wall's attraction per area of skin, times skin per volume, over the part that acts outside
};

/// A yarn's section, cut into rows and columns of beads; m.
struct CutSection {
    double half_height, half_width;
    int rows, columns;

    HL_FN double flat() const { return half_width > half_height ? half_width - half_height : 0.0; }
    HL_FN double area() const { return pi * half_height * half_height + 4.0 * flat() * half_height; } // of a stadium
    HL_FN double outline() const { return 2.0 * pi * half_height + 4.0 * flat(); }
    HL_FN double up(int row) const { return half_height * (2.0 * row + 1.0 - rows) / rows; }
    HL_FN double side(int column) const { return half_width * (2.0 * column + 1.0 - columns) / columns; }
    /// Of a bead's places about its middle, the mean along both directions; of an ellipse.
    HL_FN double variance() const
    {
        return 0.125 * (half_height * half_height / (rows * rows) + half_width * half_width / (columns * columns));
    }
};

/// How many beads a segment is cut into: rows and columns of its section, and pieces along it.
struct BeadGrid {
    int rows = 1, columns = 1, along = 1;
    double length = 0; ///< m, of a piece, at most

    HL_FN int per_segment() const { return rows * columns * along; }
};

/// Beads of yarns, the same number in each segment. Tiles of crossings near where drops fall have theirs in memory, the warp's before the
/// weft's, those of a yarn one after the other; of the other tiles beads are cut when a particle asks for them.
struct Beads {
    static constexpr int tile = 16; ///< yarns along its sides, or what is left of them

    const Quad* bead = nullptr; ///< place (m) and volume (m3)
    const int* first = nullptr; ///< of each tile, by its ends and then its picks: where its beads begin; -1: they are not in memory
    const BeadType* types = nullptr;
    BeadGrid grid;
    double warp_pitch = 0, weft_pitch = 0; ///< m
    Real widest = 0;                       ///< m, the farthest that any reaches
    Real top = 0;                          ///< m, over the middle plane or under it: no bead is farther

    HL_FN static int tiles(int yarns) { return (yarns + tile - 1) / tile; }
    HL_FN static int yarns_in(int tile_of_yarns, int yarns)
    {
        const int left = yarns - tile_of_yarns * tile;
        return left < tile ? left : tile;
    }
    /// Where a segment's beads begin, counted from its tile's first.
    HL_FN int place(const TextileShape& t, bool is_warp, int end, int pick) const
    {
        const int ends = yarns_in(end / tile, t.ends), picks = yarns_in(pick / tile, t.picks), e = end % tile, p = pick % tile;
        return grid.per_segment() * (is_warp ? e * picks + p : ends * picks + p * ends + e);
    }
    /// The same in memory, or -1.
    HL_FN int find(const TextileShape& t, bool is_warp, int end, int pick) const
    {
        const int of_tile = first[end / tile * tiles(t.picks) + pick / tile];
        return of_tile < 0 ? -1 : of_tile + place(t, is_warp, end, pick);
    }
    /// One of a segment's beads, by its number along the yarn.
    HL_FN Quad cut(const TextileShape& t, bool is_warp, int end, int pick, int number) const
    {
        const int column = number % grid.columns, row = number / grid.columns % grid.rows, k = number / (grid.columns * grid.rows);
        const double x = (end - 0.5 * (t.ends - 1)) * warp_pitch, y = (pick - 0.5 * (t.picks - 1)) * weft_pitch;
        const double pitch = is_warp ? weft_pitch : warp_pitch, part = (k + 0.5) / grid.along - 0.5;
        const YarnPlace<Real> at = yarn_place(t, t.segment(is_warp, end, pick), AlongYarn<Real>(t, static_cast<Real>(part)));
        const CutSection section{static_cast<double>(at.half_height), static_cast<double>(at.half_width), grid.rows, grid.columns};
        const double slope = static_cast<double>(at.slope), cosine = 1.0 / std::sqrt(1.0 + slope * slope);
        const double up = section.up(row), side = static_cast<double>(at.side) + section.side(column);
        const double forth = part * pitch - up * slope * cosine, volume = section.area() * pitch / (cosine * grid.per_segment());
        return {static_cast<Real>(x + (is_warp ? side : forth)), static_cast<Real>(y + (is_warp ? forth : side)),
                static_cast<Real>(static_cast<double>(at.height) + up * cosine), static_cast<Real>(volume)};
    }
};

/// Sums over the beads near each particle, anew where it has moved by a tenth of its spacing; else by their slopes. A flat wall at the
/// nearest skin's distance would not do: where yarns are thinner than the kernel its forces have no energy, and a drop on them heats up. A
/// flat yarn acts as a wall does (bead_share(), bead_attraction()): its attraction's energy is as the surface kernel's integral over the
/// skin.
struct FeelCloth {
    Particles p;
    TextileShape textile;
    Beads beads;
    static constexpr bool wide = true;

    HL_FN void operator()(int i) const
    {
        const Vec3 x = p.position[i];
        const bool alive = p.alive[i] != 0, near = x.z < beads.top + beads.widest && x.z > -beads.top - beads.widest;
        ClothExpansion& from = p.cloth_from[i];
        const Vec3 way = near ? x - from.at : Vec3{};
        const Real far = Real(0.1) * p.spacing;
        const bool anew = alive && !(dot(way, way) <= far * far);
        for (unsigned left = elements_where(anew); left != 0; left &= left - 1) {
            const int element = lowest_bit(left);
            const ClothExpansion e = expansion({of_element(x.x, element), of_element(x.y, element), of_element(x.z, element)});
            if (element == own_element()) from = e;
        }
        if (alive) p.cloth[i] = !near ? ClothField{} : anew ? from.field : from.near(way);
    }
    /// At a place that beads reach. On a GPU the work of a whole warp.
    HL_FN ClothExpansion expansion(const Vec3& x) const
    {
        Sums sums;
        const Real u = x.x / textile.warp_pitch + Real(0.5) * Real(textile.ends - 1);
        const Real v = x.y / textile.weft_pitch + Real(0.5) * Real(textile.picks - 1);
        const Real wide_u = beads.widest / textile.warp_pitch, wide_v = beads.widest / textile.weft_pitch;
        // A segment reaches half a pitch to both sides along its yarn, and a yarn may lie beside its place.
        const int end0 = first(u - wide_u - Real(0.5), textile.ends), end1 = first(u + wide_u + Real(1.5), textile.ends);
        const int pick0 = first(v - wide_v - Real(0.5), textile.picks), pick1 = first(v + wide_v + Real(1.5), textile.picks);
        for (int end = end0 + own_element(); end < end1; end += elements_beside)
            add_yarn(sums, x, true, end, pick0, pick1, beads.types[textile.type[end]]);
        for (int pick = pick0 + own_element(); pick < pick1; pick += elements_beside)
            add_yarn(sums, x, false, pick, end0, end1, beads.types[textile.type_of_pick(pick)]);
        return sums.expansion(x);
    }

private:
    /// Second slopes: xx, yy, zz, xy, yz, zx.
    struct Bend {
        Pack parts[6]{};

        HL_FN void add(const Pack& along, const Pack& even, const Vec3T<Pack>& d)
        {
            parts[0] += along * d.x * d.x + even;
            parts[1] += along * d.y * d.y + even;
            parts[2] += along * d.z * d.z + even;
            parts[3] += along * d.x * d.y;
            parts[4] += along * d.y * d.z;
            parts[5] += along * d.z * d.x;
        }
        HL_FN void add(const Bend& other, Real factor)
        {
            for (int k = 0; k < 6; ++k) parts[k] += factor * other.parts[k];
        }
        HL_FN void total(Real (&sums)[6]) const
        {
            for (int k = 0; k < 6; ++k) sums[k] = sum_beside(parts[k]);
        }
    };
    struct Sums {
        Pack share{}, surface_share{};
        Packs slope{}, surface_slope{}, adhesion{};
        Bend bend, surface_bend, adhesion_bend;

        HL_FN ClothExpansion expansion(const Vec3& at) const
        {
            ClothExpansion e;
            e.at = at;
            e.field.share = sum_beside(share);
            e.field.slope = sum_beside(slope);
            e.field.surface_share = sum_beside(surface_share);
            e.field.surface_slope = sum_beside(surface_slope);
            e.field.adhesion = sum_beside(adhesion);
            surface_bend.total(e.field.bend);
            bend.total(e.slope_bend);
            adhesion_bend.total(e.adhesion_bend);
            return e;
        }
    };
    /// The first thread at or behind a place, of those there are.
    HL_FN static int first(Real place, int count)
    {
        return place <= 0 ? 0 : place >= Real(count) ? count : static_cast<int>(std::ceil(place));
    }
    /// Beads of a yarn's segments from one yarn that it crosses to another, tile by tile.
    HL_FN void add_yarn(Sums& s, const Vec3& x, bool is_warp, int yarn, int from, int to, const BeadType& type) const
    {
        while (from < to) {
            const int tile_end = (from / Beads::tile + 1) * Beads::tile, until = tile_end < to ? tile_end : to;
            const int first = beads.find(textile, is_warp, is_warp ? yarn : from, is_warp ? from : yarn);
            const int count = (until - from) * beads.grid.per_segment();
            if (first >= 0)
                add(s, x, BeadsInMemory{beads.bead + first, count}, count, type);
            else
                cut_and_add(s, x, BeadsCut{textile, beads, is_warp, yarn, from, count}, type);
            from = until;
        }
    }
    /// Packs of beads one after the other; those past the last have no volume.
    struct BeadsInMemory {
        const Quad* bead;
        int count;

        HL_FN Quads operator()(int k) const
        {
            Quads b = load(bead + k);
            if (count - k < lanes) b.w *= first_lanes(count - k);
            return b;
        }
    };
    /// The same of segments whose tile is not in memory.
    struct BeadsCut {
        const TextileShape& textile;
        const Beads& beads;
        bool is_warp;
        int yarn, from; ///< the first yarn that it crosses
        int count;

        HL_FN Quad bead(int k) const
        {
            if (k >= count) return {};
            const int per_segment = beads.grid.per_segment(), crossed = from + k / per_segment;
            return beads.cut(textile, is_warp, is_warp ? yarn : crossed, is_warp ? crossed : yarn, k % per_segment);
        }
        HL_FN Quads operator()(int k) const
        {
#if HL_LANE_IS_THREAD
            const Quad own = bead(k + own_lane());
            return {own.x, own.y, own.z, own.w};
#else
            Quad cut[lanes];
            for (int lane = 0; lane < lanes; ++lane) cut[lane] = bead(k + lane);
            return load(cut);
#endif
        }
    };
    HL_SELDOM void cut_and_add(Sums& s, const Vec3& x, const BeadsCut& cut, const BeadType& type) const { add(s, x, cut, cut.count, type); }
    template <typename PackAt> HL_FN void add(Sums& s, const Vec3& x, const PackAt& pack_at, int count, const BeadType& type) const
    {
        const SplineUnits units(type.reach), near(type.support);
        Pack surface_share{};
        Packs surface_slope{};
        Bend surface_bend;
        HL_UNROLL(2)
        for (int k = 0; k < count; k += lanes) {
            const Quads b = pack_at(k);
            const Packs d{x.x - b.x, x.y - b.y, x.z - b.z};
            const Pack square = dot(d, d) + units.nothing, one_over = inverse_root(square), r = root_beside(square, one_over);
            const Spline<Pack> outer(r * units.per_metre), inner(r * near.per_metre);
            const Pack factor = b.w * units.slope * outer.slope() * one_over, push = b.w * near.slope * inner.slope() * one_over;
            surface_share += b.w * units.kernel * outer.kernel();
            surface_slope += factor * d;
            surface_bend.add((b.w * units.gradient_factor * outer.curvature() - factor) * (one_over * one_over), factor, d);
            s.share += b.w * near.kernel * inner.kernel();
            s.slope += push * d;
            s.bend.add((b.w * near.gradient_factor * inner.curvature() - push) * (one_over * one_over), push, d);
        }
        s.surface_share += type.share * surface_share;
        s.surface_slope += (Pack{} + type.share) * surface_slope;
        s.adhesion += (Pack{} + type.pull) * surface_slope; // of the same slopes
        s.surface_bend.add(surface_bend, type.share);
        s.adhesion_bend.add(surface_bend, type.pull);
    }
};

} // namespace hygroloom::inline HL_PRECISION
