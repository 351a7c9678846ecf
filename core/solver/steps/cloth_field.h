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

/// Beads of all yarns, the same number in each segment; those of a yarn stand one after the other.
struct Beads {
    const Quad* bead = nullptr; ///< place (m) and volume (m3)
    const BeadType* types = nullptr;
    int per_segment = 0;
    Real widest = 0; ///< m, the farthest that any reaches
    Real top = 0;    ///< m, over the middle plane or under it: no bead is farther
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
            add(sums, x, textile.segment(true, end, pick0), pick1 - pick0, beads.types[textile.type[end]]);
        for (int pick = pick0 + own_element(); pick < pick1; pick += elements_beside)
            add(sums, x, textile.segment(false, end0, pick), end1 - end0, beads.types[textile.type_of_pick(pick)]);
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
    /// Beads of segments one after the other on a yarn.
    HL_FN void add(Sums& s, const Vec3& x, int segment, int segments, const BeadType& type) const
    {
        const Quad* bead = beads.bead + static_cast<std::int64_t>(segment) * beads.per_segment;
        const int count = segments * beads.per_segment;
        const SplineUnits units(type.reach), near(type.support);
        Pack surface_share{};
        Packs surface_slope{};
        Bend surface_bend;
        HL_UNROLL(2)
        for (int k = 0; k < count; k += lanes) {
            Quads b = load(bead + k);
            if (count - k < lanes) b.w *= first_lanes(count - k);
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
