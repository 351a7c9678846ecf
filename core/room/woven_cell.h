// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The part of a weave that the cloth repeats: of twills and satins one end, which goes on beside itself some picks higher.
#pragma once

#include "core/geometry/textile.h"

#include <numeric>
#include <optional>

namespace hygroloom {

/// Its picks follow each other without end; beyond its last end it begins anew so many picks higher: crossing (end + ends, pick) is as
/// (end, pick - shift).
struct WovenCell {
    int ends = 1, picks = 1;
    int shift = 0; ///< 0 .. picks - 1

    int crossings() const { return ends * picks; }
    /// Ends after which the cloth repeats without a shift.
    int ends_of_period() const { return ends * (picks / std::gcd(shift, picks)); }
    /// Of the cell, end x picks + pick, as which any crossing is.
    std::size_t crossing(int end, int pick) const
    {
        const auto within = [](int i, int n) { return ((i % n) + n) % n; };
        const int first = within(end, ends), higher = (end - first) / ends * shift;
        return static_cast<std::size_t>(first * picks + within(pick - higher, picks));
    }
};

/// The smallest of a weave, from its first end and pick on; none where that has more than so many crossings.
std::optional<WovenCell> smallest_cell(const Weave& weave, int most);

} // namespace hygroloom
