// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What liquid that stands on the cloth gives to the air: it is as warm as the cloth under it, which brings the heat, and it keeps the air
// off the face that it covers.
#pragma once

#include "core/solver/steps/cap_supply.h"

namespace hygroloom {

/// Counts the places that each drop or pool covers.
struct CountCovered {
    FindCap find;
    CapSums* sums;

    HL_FN void operator()(int index) const
    {
        const int crossing = find.s.visited_crossing(index), cap = find.s.cap_over[crossing];
        if (cap >= 0) atomic_add(&sums[cap].places, find.under(cap).places_inside(find.s, crossing));
    }
};

/// What stands over a segment, and its part of that.
struct OverSegment {
    double covered = 0; ///< share of its face
    double vapour = 0;  ///< m3/s, see CapOnFace
    double heat = 0;    ///< W/K
    double water = 0;   ///< kg
    std::int64_t* evaporated = nullptr;
};

/// Drops and pools on the upper face, each over its circle; or a film on both faces.
struct StandingLiquid {
    const CapOnFace* caps = nullptr;
    CapSums* sums = nullptr; ///< null: nothing stands
    FedFace face;            ///< its circle is set for each
    int film_on = 0;         ///< segments under the one that is a film; 0: there is none

    HL_FN OverSegment over(const Segments& s, int i) const
    {
        if (film_on > 0) return part_of(0, 1.0, 1.0 / film_on);
        const int crossing = s.crossing_of(i), cap = s.cap_over[crossing];
        if (cap < 0) return {};
        const FedFace circle = under_cap(face, caps[cap]);
        const double share = circle.share(s, i), places = circle.places * circle.places;
        return share > 0 ? part_of(cap, share, share * places / static_cast<double>(sums[cap].places)) : OverSegment{};
    }
    HL_FN OverSegment part_of(int cap, double covered, double part) const
    {
        return {covered, part * caps[cap].vapour, part * caps[cap].heat, part * static_cast<double>(caps[cap].water) * water_quantum,
                &sums[cap].evaporated};
    }
};

} // namespace hygroloom
