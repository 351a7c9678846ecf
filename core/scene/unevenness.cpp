// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/scene/unevenness.h"

#include "core/base/random.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

/// Deviations of mean 0 and variance 1 at the crossings of one yarn, each kept by that share to the next. They go out from the middle, and
/// yarns are numbered from it, so that one seed gives samples of other sizes and setts the same middle.
std::vector<double> unevenness_along(std::uint64_t seed, int number, int crossings, double kept)
{
    // Seed and yarn are mixed first: random_bits() adds seed and stream, and the next seed would give the next yarn what this one gave it.
    const std::uint64_t own = random_bits(seed, 0, static_cast<std::uint64_t>(number));
    const auto fresh = [&](int from_middle) {
        return std::sqrt(12.0) * (random_uniform(own, 0, static_cast<std::uint64_t>(from_middle)) - 0.5);
    };
    std::vector<double> along(static_cast<std::size_t>(crossings));
    const int middle = crossings / 2;
    for (const int step : {1, -1})
        for (int k = middle; k >= 0 && k < crossings; k += step) {
            const double before = k == middle ? 0.0 : along[static_cast<std::size_t>(k - step)];
            along[static_cast<std::size_t>(k)] = k == middle ? fresh(0) : kept * before + std::sqrt(1.0 - kept * kept) * fresh(k - middle);
        }
    return along;
}

} // namespace

std::vector<double> uneven_pores(const Textile& textile, const std::vector<double>& lengths, std::uint64_t seed)
{
    std::vector<double> found;
    constexpr double alike_over = 20e-3; // m; an assumption
    const auto &all = textile.warp.types, &more = textile.weft.types;
    const auto is_uneven = [](const YarnType& type) { return type.irregularity_cv > 0; };
    if (std::none_of(all.begin(), all.end(), is_uneven) && std::none_of(more.begin(), more.end(), is_uneven)) return found;
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        const YarnSystem& own = textile.system(kind);
        const int crossed = textile.system(other_kind(kind)).count;
        const double kept = std::exp(-textile.system(other_kind(kind)).pitch / alike_over);
        for (int yarn = 0; yarn < own.count; ++yarn) {
            const YarnType& type = textile.type(kind, yarn);
            const double least = std::clamp((1.0 - 0.95) / (1.0 - type.packing), 0.5, 1.0); // of the pores
            const std::vector<double> along =
                unevenness_along(seed, 2 * (yarn - own.count / 2) + (kind == YarnKind::warp ? 0 : 1), crossed, kept);
            for (int k = 0; k < crossed; ++k) {
                const double fibres = std::clamp(1.0 + type.irregularity_cv * along[static_cast<std::size_t>(k)], 0.2, 1.8);
                const double pores = (1.0 - type.packing * fibres) / (1.0 - type.packing);
                const double length = lengths[found.size()];
                found.push_back(std::clamp(pores, least, 1.5) * type.area * (1.0 - type.packing) * length);
            }
        }
    }
    return found;
}

} // namespace hygroloom
