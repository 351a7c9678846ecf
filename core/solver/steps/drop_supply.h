// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What yarns and the room between them may draw from a drop's particles where liquid flows by suctions: it is offered before a step of the
// yarns, drawn in the same implicit step as the flow, and paid after it. So pores under a drop stay at the drop's pressure, however full
// they are.
#pragma once

#include "core/solver/steps/absorption.h"
#include "core/solver/steps/liquid_control.h"

namespace hygroloom::inline HL_PRECISION {

/// Each particle offers all takers that it touches the same part of its content; the first, what division leaves, too. Each taker notes the
/// fullest.
struct OfferFromDrops {
    Particles p;
    TextileShape textile;
    Segments s;
    Reach reach;

    /// Calls visit(taker, quanta offered to it).
    template <typename Visit> HL_FN void for_takers(int i, const Visit& visit) const
    {
        if (!p.alive[i] || p.wall_distance[i] > p.spacing) return;
        int takers = 0;
        for_touched_segments(textile, p.position[i], p.spacing, [&](int) { ++takers; });
        if (takers == 0) return;
        const std::int64_t content = p.content[i], each = content / takers;
        std::int64_t offer = content - (takers - 1) * each;
        for_touched_segments(textile, p.position[i], p.spacing, [&](int taker) {
            visit(taker, offer);
            offer = each;
        });
    }
    HL_FN void operator()(int i) const
    {
        const int note = note_of(p, i);
        for_takers(i, [&](int taker, std::int64_t offer) {
            atomic_min(s.contact + taker, note);
            atomic_add(&s.offered[taker], offer);
            atomic_add(&s.promised[taker], offer);
            reach.include(s, taker < 2 * s.crossings() ? s.crossing_of(taker) : taker - 2 * s.crossings());
        });
    }
};

/// Each particle pays its share of what its takers drew, rounded up to whole quanta.
struct PayForDrawn {
    OfferFromDrops offered;
    std::int64_t* absorbed; ///< quanta

    HL_FN void operator()(int i) const
    {
        std::int64_t pays = 0;
        offered.for_takers(i, [&](int taker, std::int64_t offer) { pays += pay(offered.s, taker, offer); });
        offered.p.content[i] -= pays;
        if (pays != 0) atomic_add(absorbed, pays);
    }
    HL_FN static std::int64_t pay(const Segments& s, int taker, std::int64_t offer)
    {
        constexpr double surely_up = 1.0 + 1e-15;
        const std::int64_t promised = s.promised[taker], drawn = promised - s.offered[taker];
        if (drawn == 0) return 0;
        const double share = static_cast<double>(drawn) / static_cast<double>(promised) * static_cast<double>(offer);
        const double part = std::ceil(share > 0 ? share * surely_up : share);
        const std::int64_t pays = part < static_cast<double>(offer) ? static_cast<std::int64_t>(part) : offer;
        atomic_add(&s.paid[taker], pays);
        return pays;
    }
};

/// The particle that a taker has noted gets back what was paid too much, and clears the account.
struct CloseAccounts {
    OfferFromDrops offered;
    std::int64_t* absorbed; ///< quanta
    std::int64_t* total;    ///< quanta that particles still hold
    std::int64_t* above;    ///< of them over the cloth's middle

    HL_FN std::int64_t operator()(int i) const
    {
        const Particles& p = offered.p;
        if (!p.alive[i]) return 0;
        std::int64_t back = 0;
        offered.for_takers(i, [&](int taker, std::int64_t) {
            if (ForgetContact::forget(offered.s.contact[taker], i)) back += clear(offered.s, taker);
        });
        p.content[i] += back;
        if (back != 0) atomic_add(absorbed, -back);
        if (p.content[i] == 0) p.alive[i] = 0;
        if (p.alive[i] && p.position[i].z > 0) atomic_add(above, p.content[i]);
        return p.content[i];
    }
    HL_FN static std::int64_t clear(const Segments& s, int taker)
    {
        const std::int64_t drawn = s.promised[taker] - s.offered[taker], back = s.paid[taker] - drawn;
        s.promised[taker] = s.offered[taker] = s.paid[taker] = 0;
        return back;
    }
};

/// What particles lie on the cloth with, in millionths of one that is full: each touches with the square of its width.
struct SumTouching {
    Particles p;
    std::int64_t* water; ///< quanta of all particles
    std::int64_t* total;

    HL_FN std::int64_t operator()(int i) const
    {
        if (!p.alive[i]) return 0;
        atomic_add(water, p.content[i]);
        const double width = std::cbrt(static_cast<double>(p.size(i)));
        return p.wall_distance[i] <= p.spacing ? static_cast<std::int64_t>(1e6 * width * width) : 0;
    }
};

/// Each particle loses the same share of its content to the air.
struct ShrinkInAir {
    Particles p;
    double share;
    std::int64_t* total; ///< quanta that they lose

    HL_FN std::int64_t operator()(int i) const
    {
        if (!p.alive[i]) return 0;
        const auto lost = static_cast<std::int64_t>(share * static_cast<double>(p.content[i]));
        p.content[i] -= lost < p.content[i] ? lost : p.content[i];
        if (p.content[i] == 0) p.alive[i] = 0;
        return lost;
    }
};

} // namespace hygroloom::inline HL_PRECISION
