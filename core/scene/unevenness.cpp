// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/scene/unevenness.h"

#include "core/base/random.h"
#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

/// Deviations of mean 0 and variance 1 at the crossings of one yarn, each the mean of what that many fibres' lengths bring: what two have
/// in common falls evenly with their distance. Numbered from the middle, as yarns are, so that one seed gives samples of other sizes and
/// setts the same middle.
std::vector<double> unevenness_along(std::uint64_t seed, int number, int crossings, int alike_over)
{
    // Seed and yarn are mixed first: random_bits() adds seed and stream, and the next seed would give the next yarn what this one gave it.
    const std::uint64_t own = random_bits(seed, 0, static_cast<std::uint64_t>(number));
    const auto fresh = [&](int from_middle) {
        return std::sqrt(12.0) * (random_uniform(own, 0, static_cast<std::uint64_t>(from_middle)) - 0.5);
    };
    const int middle = crossings / 2, first = -middle - alike_over / 2;
    std::vector<double> sums{0}; // of all before
    for (int k = 0; k < crossings + alike_over; ++k) sums.push_back(sums.back() + fresh(first + k));
    std::vector<double> along;
    for (std::size_t k = 0; k < static_cast<std::size_t>(crossings); ++k)
        along.push_back((sums[k + static_cast<std::size_t>(alike_over)] - sums[k]) / std::sqrt(alike_over));
    return along;
}

} // namespace

std::vector<double> uneven_pores(const Textile& textile, const std::vector<double>& lengths, std::uint64_t seed)
{
    std::vector<double> found;
    const auto &all = textile.warp.types, &more = textile.weft.types;
    const auto is_uneven = [](const YarnType& type) { return type.unevenness.cv > 0; };
    if (std::none_of(all.begin(), all.end(), is_uneven) && std::none_of(more.begin(), more.end(), is_uneven)) return found;
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        const YarnSystem& own = textile.system(kind);
        const int crossed = textile.system(other_kind(kind)).count;
        const double pitch = textile.system(other_kind(kind)).pitch;
        for (int yarn = 0; yarn < own.count; ++yarn) {
            const YarnType& type = textile.type(kind, yarn);
            const int alike_over = std::max(1, static_cast<int>(std::lround(metre_from_mm(type.unevenness.alike_over_mm) / pitch)));
            const std::vector<double> along =
                unevenness_along(seed, 2 * (yarn - own.count / 2) + (kind == YarnKind::warp ? 0 : 1), crossed, alike_over);
            for (int k = 0; k < crossed; ++k) {
                const double thicker = std::clamp(1.0 + type.unevenness.cv * along[static_cast<std::size_t>(k)], 0.2, 1.8);
                found.push_back(thicker * type.area * (1.0 - type.packing) * lengths[found.size()]);
            }
        }
    }
    return found;
}

} // namespace hygroloom
