// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What frames see of the yarns: every segment of a sample, the cells of a garment.
#pragma once

#include "core/solver/yarn_network.h"

namespace hygroloom::inline HL_PRECISION {

template <typename Executor> void YarnNetwork<Executor>::take_stock(Stock& stock)
{
    if (yarns().whole() || scene_->rules.shows_segments) each_segment("take stock", TakeStock{segments()});
    if (!yarns().whole()) {
        const std::size_t cells = scene_->cloth.panels.shown_ends.size();
        cells_.resize(cells);
        exec_.for_each("see cells", static_cast<int>(cells), SeeCells{segments(), cells_.data()});
    }
    stock.delivered += pools_.pumped.mass();
    stock.standing = std::accumulate(pools_.standing.begin(), pools_.standing.end(), caps_.water());
    stock.caps = caps_.shown(stock.time);
    stock.evaporated = evaporated_from_caps_.mass();
    stock.dripped += pools_.ran_off.mass();
    stock.unsolved_lines = unsolved_lines_;
    stock.unvisited = region_.unvisited();
}

template <typename Executor> template <typename LookAt> void YarnNetwork<Executor>::show(const LookAt& look_at, Stock& stock)
{
    const bool shows_segments = yarns().whole() || scene_->rules.shows_segments;
    Segments::each(
        [&](const auto& field, auto& buffer, auto& shown) {
            const bool wanted = shows_segments && field.shown && (field.count != SegmentCount::shells || scene_->rules.shows_shells);
            shown = look_at(buffer, wanted ? buffer.size() : 0);
        },
        fields_, stock.segments);
    stock.cells = look_at(cells_, yarns().whole() ? 0 : cells_.size());
}

} // namespace hygroloom::inline HL_PRECISION
