// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A drawn yarn as places of its centreline with their sections. Lengths in m.
#pragma once

#include "core/geometry/textile.h"

#include <optional>
#include <vector>

namespace hygroloom {

/// A place of a yarn's centreline, along the fabric, across the yarn and up, and its section: a racetrack.
struct YarnStation {
    double along = 0, across = 0, up = 0;
    double half_height = 0, flat = 0; ///< flat: half of the racetrack's
    double rise = 0;                  ///< of the centreline, over its way along the fabric
};

/// The station nearest to a place of the plane along the yarn and up, and its distance; none within reach: none. Half-way between two, what
/// lies half-way: so the same cloth is the same wherever its region begins, and turned over.
struct NearStation {
    std::optional<YarnStation> station;
    double off = 0;
};

/// In order along the yarn.
class YarnStations {
public:
    /// At most spacing apart, eight from crossing to crossing at least. beyond: crossings on both sides of the textile's region.
    YarnStations(const Textile& textile, YarnKind kind, int yarn, double spacing, int beyond);
    NearStation nearest(double along, double up, double reach) const;
    const std::vector<YarnStation>& all() const { return stations_; }

private:
    std::vector<YarnStation> stations_;
};

} // namespace hygroloom
