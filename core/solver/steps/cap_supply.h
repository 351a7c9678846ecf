// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What yarns and the room between them may draw from drops that stand on the upper face as caps.
#pragma once

#include "core/solver/caps.h"
#include "core/solver/steps/supply.h"

namespace hygroloom {

/// Where a cap covers a face.
HL_FN FedFace under_cap(FedFace face, const CapOnFace& cap)
{
    face.x = cap.x;
    face.y = cap.y;
    face.radius = cap.base;
    return face;
}

/// Finds which cap lies over each crossing: of several the one that covers most of it.
struct FindCap {
    Segments s;
    const CapOnFace* caps;
    int count;
    FedFace face; ///< its circle is set for each cap

    HL_FN FedFace under(int cap) const { return under_cap(face, caps[cap]); }
    HL_FN void operator()(int index) const
    {
        const int crossing = s.visited_crossing(index);
        int best = -1, most = 0;
        for (int cap = 0; cap < count; ++cap) {
            const int inside = under(cap).places_inside(s, crossing);
            if (inside <= most) continue;
            best = cap;
            most = inside;
        }
        s.cap_over[crossing] = best;
    }
};

/// How much each taker would draw from the cap over it, summed up for each cap.
struct WeighCaps {
    FindCap find;
    double density;
    double dt; ///< s
    CapSums* sums;

    HL_FN std::int64_t weight(int number, int crossing, int cap) const
    {
        const Taker taker{find.s, density, number, find.caps[cap].pressure};
        const FedFace circle = find.under(cap);
        const double places = circle.places * circle.places;
        const double share = taker.is_room() ? circle.places_inside(find.s, crossing) / places : circle.share(find.s, number);
        constexpr double most = 1e-6; // kg, over what a taker holds: their sum can be counted
        const double draws = share > 0 ? share * taker.draws_from_cap(dt) : 0.0;
        return static_cast<std::int64_t>((draws < most ? draws : most) / water_quantum);
    }
    HL_FN void operator()(int index) const
    {
        const int i = find.s.visited_segment(index), crossing = find.s.crossing_of(i), cap = find.s.cap_over[crossing];
        if (cap < 0) return;
        const std::int64_t all =
            weight(i, crossing, cap) + (find.s.is_warp(i) ? weight(2 * find.s.crossings() + crossing, crossing, cap) : 0);
        if (all > 0) atomic_add(&sums[cap].wanted, all);
    }
};

/// Offers each taker its share of the cap over it.
struct OfferCaps {
    WeighCaps weigh;

    HL_FN void operator()(int index) const
    {
        const Segments& s = weigh.find.s;
        const int i = s.visited_segment(index), crossing = s.crossing_of(i);
        offer(i, crossing);
        if (s.is_warp(i)) offer(2 * s.crossings() + crossing, crossing);
    }
    HL_FN void offer(int number, int crossing) const
    {
        const Segments& s = weigh.find.s;
        const int cap = s.cap_over[crossing];
        const std::int64_t all = cap < 0 ? 0 : weigh.sums[cap].wanted;
        s.offered[number] = 0;
        if (all <= 0) return;
        const double share = static_cast<double>(weigh.weight(number, crossing, cap)) / static_cast<double>(all) * (1.0 - 1e-12);
        s.offered[number] = static_cast<std::int64_t>(share * static_cast<double>(weigh.find.caps[cap].water));
    }
};

} // namespace hygroloom
