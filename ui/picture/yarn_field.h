// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How far a point is from the yarns round it: for shade in the gaps, and for what lies under the pointer.
// Sections count as racetracks upright on the yarn's level, which is near enough to look at.
#pragma once

#include "core/geometry/textile.h"

#include <optional>
#include <vector>

namespace hygroloom {

/// A place on a yarn: numbered from the textile's first crossing.
struct YarnPlace {
    YarnKind kind = YarnKind::warp;
    int yarn = 0;
    int at = 0;        ///< the crossing along it
    double offset = 0; ///< from that crossing, -0.5 .. 0.5 pitches
};

/// The yarn's centreline and half section at a place along it; it runs on straight outside the textile.
struct YarnSlice {
    float across = 0; ///< m, x of an end, y of a pick
    float height = 0;
    float half_width = 0;
    float half_height = 0;
    float slope = 0; ///< dz along the yarn
};

/// Slices of the yarns in and just round a region, kept in a table. The textile must outlive it.
class YarnField {
public:
    /// The region is numbered from the textile's first crossing.
    YarnField(const Textile& textile, const TextileRegion& region);

    /// m, negative inside a yarn; a large number where no yarn is near. Valid within half a pitch round the region.
    double distance(const Vec3d& point) const;
    /// Share of light that reaches a skin from near by: 1 in the open, towards 0 deep between yarns.
    double openness(const Vec3d& point, const Vec3d& normal) const;
    YarnSlice slice(YarnKind kind, int yarn, double along) const;
    const Textile& textile() const { return textile_; }
    int first(YarnKind kind) const { return kind == YarnKind::warp ? first_end_ : first_pick_; }
    int count(YarnKind kind) const { return kind == YarnKind::warp ? ends_ : picks_; }

private:
    const Textile& textile_;
    int first_end_ = 0, first_pick_ = 0, ends_ = 0, picks_ = 0;
    std::vector<YarnSlice> slices_[2]; ///< by kind: yarn by yarn, samples along
};

/// Share of linear light that a skin with that openness gets: light that comes from skin to skin softens its shade.
double shade_of(double openness);

/// What a ray meets first.
struct YarnHit {
    Vec3d point; ///< on the skin, m
    YarnPlace place;
};

/// The first skin along a ray from a point in a unit direction, on the kept side of a plane (normal . point <= offset) if there is one.
struct CutPlane {
    Vec3d normal;
    double offset = 0;
};
std::optional<YarnHit> first_skin(const Textile& textile, const Vec3d& from, const Vec3d& direction,
                                  const std::optional<CutPlane>& cut = {});

/// The middle of a yarn at a place.
Vec3d axis_point(const Textile& textile, const YarnPlace& place);

} // namespace hygroloom
