// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How the cloth acts on the free liquid from a distance: yarns as rows of beads that count as liquid, with forces that have an energy.
#pragma once

#include "core/physics/fluid_forces.h"
#include "core/sim/steps/contact.h"

namespace hygroloom {

/// Of the beads of one type of yarn.
struct BeadType {
    Real support = 0; ///< m, of the kernel of pressure, as wide as one convolved with a bead
    Real reach = 0;   ///< m, of the surface's kernel, the same
    Real share = 1;   ///< how much it counts as liquid for the surface: see wall_share()
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

/// Sums over the beads near each particle. A flat wall at the nearest skin's distance would not do: where yarns are thinner than the
/// kernel its forces have no energy, and a drop on them heats up. A flat yarn acts as a wall does (wall_share(), wall_attraction()): its
/// attraction's energy is as the surface kernel's integral over the skin.
struct FeelCloth {
    Particles p;
    TextileShape textile;
    Beads beads;
    static constexpr bool wide = true;

    HL_FN void operator()(int i) const
    {
        if (!p.alive[i]) return;
        const Vec3 x = p.position[i];
        ClothField field;
        if (x.z < beads.top + beads.widest && x.z > -beads.top - beads.widest) {
            Sums sums;
            const Real u = x.x / textile.warp_pitch + Real(0.5) * Real(textile.ends - 1);
            const Real v = x.y / textile.weft_pitch + Real(0.5) * Real(textile.picks - 1);
            const Real wide_u = beads.widest / textile.warp_pitch, wide_v = beads.widest / textile.weft_pitch;
            // A segment reaches half a pitch to both sides along its yarn, and a yarn may lie beside its place.
            const int end0 = first(u - wide_u - Real(0.5), textile.ends), end1 = first(u + wide_u + Real(1.5), textile.ends);
            const int pick0 = first(v - wide_v - Real(0.5), textile.picks), pick1 = first(v + wide_v + Real(1.5), textile.picks);
            for (int end = end0; end < end1; ++end)
                add(sums, x, textile.segment(true, end, pick0), pick1 - pick0, beads.types[textile.type_of_end(end)]);
            for (int pick = pick0; pick < pick1; ++pick)
                add(sums, x, textile.segment(false, end0, pick), end1 - end0, beads.types[textile.type_of_pick(pick)]);
            field = sums.field();
        }
        p.cloth[i] = field;
    }

private:
    struct Sums {
        Pack share{}, surface_share{}, bend[6]{};
        Vec3T<Pack> slope{}, surface_slope{}, adhesion{};

        HL_FN static Vec3 total(const Vec3T<Pack>& packs) { return {sum_of(packs.x), sum_of(packs.y), sum_of(packs.z)}; }
        HL_FN ClothField field() const
        {
            ClothField f;
            f.share = sum_of(share);
            f.slope = total(slope);
            f.surface_share = sum_of(surface_share);
            f.surface_slope = total(surface_slope);
            for (int k = 0; k < 6; ++k) f.bend[k] = sum_of(bend[k]);
            f.adhesion = total(adhesion);
            return f;
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
        const Real tiny = Real(1e-12) * type.reach * type.reach; // at no distance there is no direction
        for (int k = 0; k < count; k += lanes) {
            Quads b = load(bead + k);
            if (count - k < lanes) b.w *= first_lanes(count - k);
            const Vec3T<Pack> d{x.x - b.x, x.y - b.y, x.z - b.z};
            const Pack r2 = dot(d, d), r = root(r2);
            const Pack counted = type.share * b.w;
            const Pack slope = spline_gradient_factor(r, type.reach);
            const Pack factor = counted * slope;
            const Pack bend = (counted * spline_curvature(r, type.reach) - factor) / (r2 + tiny);
            s.surface_share += counted * spline_kernel(r, type.reach);
            s.surface_slope += factor * d;
            s.adhesion += (type.pull * b.w) * slope * d;
            s.bend[0] += bend * d.x * d.x + factor;
            s.bend[1] += bend * d.y * d.y + factor;
            s.bend[2] += bend * d.z * d.z + factor;
            s.bend[3] += bend * d.x * d.y;
            s.bend[4] += bend * d.y * d.z;
            s.bend[5] += bend * d.z * d.x;
            const Pack push = b.w * spline_gradient_factor(r, type.support);
            s.share += b.w * spline_kernel(r, type.support);
            s.slope += push * d;
        }
    }
    HL_FN static Pack first_lanes(int count)
    {
        Pack ones{};
#if HL_LANES == 1
        ones = count > 0 ? Real(1) : Real(0);
#else
        for (int l = 0; l < lanes; ++l) ones[l] = l < count ? Real(1) : Real(0);
#endif
        return ones;
    }
};

} // namespace hygroloom
