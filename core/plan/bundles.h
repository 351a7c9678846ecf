// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Yarns side by side that are simulated as one.
#pragma once

#include <algorithm>
#include <cstdint>

namespace hygroloom {

/// The yarns of a system, shared out to bundles of equal size. That need not be whole: a bundle may begin within a yarn, so that the last
/// is like all others.
struct Bundles {
    int yarns = 0;
    int count = 0;

    double size() const { return static_cast<double>(yarns) / count; }
    /// The bundle in which a yarn begins, and the one in which it ends: the same or the next.
    int first_of(int yarn) const { return static_cast<int>(std::int64_t{yarn} * count / yarns); }
    int last_of(int yarn) const { return static_cast<int>((std::int64_t{yarn} * count + count - 1) / yarns); }
    /// Part of the yarn that is in one of those.
    double share(int yarn, int bundle) const
    {
        const std::int64_t begin = std::max(std::int64_t{yarn} * count, std::int64_t{bundle} * yarns);
        const std::int64_t end = std::min(std::int64_t{yarn + 1} * count, std::int64_t{bundle + 1} * yarns);
        return static_cast<double>(end - begin) / count;
    }
    /// The yarn in its middle.
    int middle_of(int bundle) const { return static_cast<int>(((2 * std::int64_t{bundle} + 1) * yarns) / (2 * count)); }
};

/// Bundles of about the wanted number of yarns, all of one size. Their number is even, so that the sample's middle, over which drops hang,
/// lies between two, however large the sample is.
inline Bundles bundles_of(int yarns, int wanted)
{
    if (wanted <= 1) return {yarns, yarns};
    return {yarns, std::max(1, 2 * ((yarns + wanted) / (2 * wanted)))};
}

} // namespace hygroloom
