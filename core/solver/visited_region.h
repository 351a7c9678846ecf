// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The part of the cloth that steps go through: it begins where something happens and grows before liquid, vapour or heat reach its border.
#pragma once

#include "core/solver/segments.h"

#include <algorithm>
#include <span>

namespace hygroloom {

class VisitedRegion {
public:
    /// Nothing of a sample at rest but what hangs in liquid; all of a sample that is not at rest, or whose air changes.
    void load(const Scene& scene)
    {
        scene_ = &scene;
        out_ = {};
        const bool stirred = !scene.cloth.start.liquid.empty() || scene.cloth.start.warmth != 0 || scene.cloth.start.humidity >= 0 ||
                             scene.climate.humidity > 1 || !scene.climate.course.empty() || scene.supply.sweat > 0 ||
                             scene.cloth.panels.count > 0;
        if (scene.rules.rest_tolerance <= 0 || stirred) return;
        out_ = {scene.cloth.ends / 2, (scene.cloth.ends - 1) / 2, scene.cloth.picks / 2, (scene.cloth.picks - 1) / 2};
        int fed_reach[4] = {-1, -1, -1, -1};
        for (int i = 0; i < static_cast<int>(scene.supply.fed.size()) / 2; ++i) {
            if (scene.supply.fed[static_cast<std::size_t>(i)] == 0) continue;
            const int end = i / scene.cloth.picks, pick = i % scene.cloth.picks;
            Reach{fed_reach}.include(yarns_of(scene), i);
            out_.ends_before = std::min(out_.ends_before, end);
            out_.ends_after = std::min(out_.ends_after, scene.cloth.ends - 1 - end);
            out_.picks_before = std::min(out_.picks_before, pick);
            out_.picks_after = std::min(out_.picks_after, scene.cloth.picks - 1 - pick);
        }
        include_reached(fed_reach);
    }

    Unvisited& unvisited() { return out_; }
    const Unvisited& unvisited() const { return out_; }

    /// Takes in what lies within a radius of a place, m from the sample's middle.
    void include_disc(double x, double y, double radius)
    {
        const auto least = [](int& out, int threads, double reach, double pitch) {
            const int before = static_cast<int>(std::clamp(0.5 * (threads - 1) - reach / pitch, 0.0, threads - 1.0));
            out = std::min(out, before);
        };
        least(out_.ends_before, scene_->cloth.ends, radius - x, scene_->cloth.warp_pitch);
        least(out_.ends_after, scene_->cloth.ends, radius + x, scene_->cloth.warp_pitch);
        least(out_.picks_before, scene_->cloth.picks, radius - y, scene_->cloth.weft_pitch);
        least(out_.picks_after, scene_->cloth.picks, radius + y, scene_->cloth.weft_pitch);
    }

    /// Threads within this number of the region's border count as close to it.
    int threads_at_border() const { return 4 + widest() / 16; }

    /// Grows by a quarter, or more, on the sides whose border liquid, vapour or heat has come close to. reach: see Reach.
    void include_reached(std::span<const int> reach)
    {
        if (!out_.any()) return;
        constexpr int least_growth = 8;
        const int close = threads_at_border(), growth = std::max(least_growth, widest() / 4);
        const auto grow = [&](int& out, int threads, int farthest) { // farthest from the other side
            if (farthest >= threads - out - close) out = std::max(0, threads - 1 - farthest - growth);
        };
        grow(out_.ends_after, scene_->cloth.ends, reach[0]);
        grow(out_.picks_after, scene_->cloth.picks, reach[1]);
        grow(out_.ends_before, scene_->cloth.ends, reach[2]);
        grow(out_.picks_before, scene_->cloth.picks, reach[3]);
    }

private:
    int widest() const
    {
        return std::max(scene_->cloth.ends - out_.ends_before - out_.ends_after,
                        scene_->cloth.picks - out_.picks_before - out_.picks_after);
    }

    const Scene* scene_ = nullptr;
    Unvisited out_;
};

} // namespace hygroloom
