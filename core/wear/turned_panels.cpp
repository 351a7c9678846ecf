// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/units.h"
#include "core/garment/outline.h"
#include "core/wear/garment_scene.h"
#include "core/wear/on_edge.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

/// Of the yarns that an edge cuts, the share that is warp.
double warp_share(const FlatPlace& out, double grain)
{
    const double along = std::abs(out[1] * std::cos(grain) - out[0] * std::sin(grain)),
                 across = std::abs(out[0] * std::cos(grain) + out[1] * std::sin(grain));
    return along + across > 0 ? along / (along + across) : 0.5;
}

/// m of a seam over which more yarns meet their own system than the other, if both panels lie alike; less than 0: it is the other way.
double alike(const GarmentPattern& pattern, const PatternSeam& seam, double grain_a, double grain_b)
{
    constexpr int places = 32; // along a seam, whose direction may change
    const PanelEdge &a = pattern.panels[static_cast<std::size_t>(seam.panel_a)].edges[static_cast<std::size_t>(seam.edge_a)],
                    &b = pattern.panels[static_cast<std::size_t>(seam.panel_b)].edges[static_cast<std::size_t>(seam.edge_b)];
    double sum = 0;
    for (int place = 0; place < places; ++place) {
        const double share = (place + 0.5) / places;
        const double one = warp_share(at_share(a, share).out, grain_a),
                     other = warp_share(at_share(b, seam.reversed ? 1 - share : share).out, grain_b);
        const double same = std::min(one, other) + std::min(1 - one, 1 - other),
                     crossed = std::min(one, 1 - other) + std::min(1 - one, other);
        sum += same - crossed;
    }
    return 0.5 * (length_of(a) + length_of(b)) * sum / places;
}

} // namespace

std::vector<bool> turned_panels(const GarmentPattern& pattern, const Garment& garment, const std::vector<double>& pass)
{
    const std::size_t count = pattern.panels.size();
    std::vector<double> gains(count * count, 0.0); // m, of two panels that lie alike
    const auto grain = [&](int panel) {
        const PanelCut* cut = garment.cut_of(pattern.panels[static_cast<std::size_t>(panel)].cut());
        return cut != nullptr ? radian_from_degree(cut->grain_deg) : 0.0;
    };
    for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
        const PatternSeam& seam = pattern.seams[s];
        if (seam.panel_a == seam.panel_b || pass[s] <= 0) continue;
        const double gain = pass[s] * alike(pattern, seam, grain(seam.panel_a), grain(seam.panel_b));
        const auto a = static_cast<std::size_t>(seam.panel_a), b = static_cast<std::size_t>(seam.panel_b);
        gains[a * count + b] += gain;
        gains[b * count + a] += gain;
    }
    std::vector<double> sum(count, 0.0); // of each panel with those that are decided
    std::vector<bool> turned(count, false), decided(count, false);
    constexpr double least = 1e-6;                        // m: less is rounding
    for (std::size_t round = 0; round < count; ++round) { // the panel that gains most, or the first
        std::size_t next = count;
        for (std::size_t panel = 0; panel < count; ++panel)
            if (!decided[panel] && (next == count || std::abs(sum[panel]) > std::abs(sum[next]) + least)) next = panel;
        decided[next] = true;
        turned[next] = sum[next] < -least;
        for (std::size_t other = 0; other < count; ++other) sum[other] += (turned[next] ? -1 : 1) * gains[next * count + other];
    }
    return turned;
}

} // namespace hygroloom
