// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Yarns side by side that are simulated as one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace hygroloom {

/// How yarns are shared out to bundles.
struct Bundling {
    int yarns = 1; ///< that a bundle stands for, about
    /// Bundles of just so many yarns, counted from the sample's middle, so that a stain does not depend on the sample's size. The outermost
    /// have up to half a bundle more, or fewer.
    bool whole = false;
};

/// The yarns of a system, shared out to bundles of equal size. A bundle may begin within a yarn. Places are counted in parts of a yarn.
class Bundles {
public:
    int yarns = 0;
    int count = 0;

    /// As many yarns in each as there are to share; they need not be whole.
    Bundles(int yarns, int count) : yarns(yarns), count(count), parts_(count), first_(0), step_(yarns) {}
    /// So many yarns in each, from the middle.
    static Bundles from_middle(int yarns, int count, int size)
    {
        Bundles bundles(yarns, count);
        bundles.parts_ = 2;
        bundles.step_ = std::int64_t{2} * size;
        bundles.first_ = yarns - std::int64_t{count} * size;
        return bundles;
    }

    /// Yarns that a bundle stands for.
    double size() const { return static_cast<double>(step_) / static_cast<double>(parts_); }
    /// Yarns that there are in it: of an outermost one more, or fewer, than size().
    double held(int bundle) const { return static_cast<double>(end_of(bundle) - begin_of(bundle)) / static_cast<double>(parts_); }
    /// Where the middle of a bundle lies, in yarns.
    double middle(int bundle) const { return static_cast<double>(first_) / static_cast<double>(parts_) + (bundle + 0.5) * size(); }
    /// The bundle in which a yarn begins, and the one in which it ends: the same or the next.
    int first_of(int yarn) const { return bundle_at(yarn * parts_ - first_); }
    int last_of(int yarn) const { return bundle_at((yarn + 1) * parts_ - first_ - 1); }
    /// Part of the yarn that is in one of those.
    double share(int yarn, int bundle) const
    {
        const std::int64_t begin = std::max(yarn * parts_, begin_of(bundle)), end = std::min((yarn + 1) * parts_, end_of(bundle));
        return static_cast<double>(end - begin) / static_cast<double>(parts_);
    }
    /// The yarn in its middle.
    int middle_of(int bundle) const
    {
        const std::int64_t twice = 2 * first_ + (2 * std::int64_t{bundle} + 1) * step_;
        return static_cast<int>(std::clamp<std::int64_t>(twice / (2 * parts_), 0, yarns - 1));
    }

private:
    std::int64_t parts_, first_, step_; ///< of a yarn; where the first bundle begins; a bundle's

    int bundle_at(std::int64_t place) const { return static_cast<int>(std::clamp<std::int64_t>(place / step_, 0, count - 1)); }
    std::int64_t begin_of(int bundle) const { return bundle == 0 ? 0 : first_ + bundle * step_; }
    std::int64_t end_of(int bundle) const { return bundle == count - 1 ? yarns * parts_ : first_ + (bundle + 1) * step_; }
};

/// Bundles of about the wanted number of yarns, all of one size. Their number is even, so that the sample's middle, over which drops hang,
/// lies between two, however large the sample is. They are whole only where that changes its width by less than a tenth.
inline Bundles bundles_of(int yarns, const Bundling& wanted)
{
    if (wanted.yarns <= 1) return {yarns, yarns};
    const int count = std::max(1, 2 * ((yarns + wanted.yarns) / (2 * wanted.yarns)));
    if (wanted.whole && 10 * std::abs(count * wanted.yarns - yarns) < yarns) return Bundles::from_middle(yarns, count, wanted.yarns);
    return {yarns, count};
}

} // namespace hygroloom
