// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What frames see of the yarns: every segment of a sample, or its cells, as of a garment.
#pragma once

#include "core/solver/yarn_network.h"

namespace hygroloom {

template <typename Executor> void YarnNetwork<Executor>::take_stock(YarnStock& stock)
{
    if (yarns().whole() || scene_->rules.shows_segments) each_segment("take stock", TakeStock{segments()});
    if (!yarns().whole()) {
        const std::size_t cells = scene_->cloth.panels.shown_ends.size();
        cells_.resize(cells);
        exec_.for_each("see cells", static_cast<int>(cells), SeeCells{segments(), cells_.data()});
    }
    if (shows_cells()) see_shown();
    stock.delivered += pools_.pumped.mass();
    stock.standing = std::accumulate(pools_.standing.begin(), pools_.standing.end(), caps_.water() + film_);
    stock.caps = caps_.shown(stock.time);
    stock.evaporated += evaporated_from_standing_.mass();
    stock.dripped += pools_.ran_off.mass();
    stock.unsolved_lines = unsolved_lines_;
    stock.unvisited = region_.unvisited();
}

/// Cells in which nothing is visited stay as they were seen first.
template <typename Executor> void YarnNetwork<Executor>::see_shown()
{
    const CellSpans ends{scene_->cloth.ends, scene_->cloth.shown_ends}, picks{scene_->cloth.picks, scene_->cloth.shown_picks};
    const int segments_shown = 2 * ends.cells * picks.cells, lines = ends.cells + picks.cells;
    shown_fields_.resize(static_cast<std::size_t>(segments_shown) * shown_field_count);
    shown_sums_.resize(static_cast<std::size_t>(segments_shown));
    shown_lines_.resize(static_cast<std::size_t>(lines));
    wet_.resize(static_cast<std::size_t>(scene_->cloth.ends));
    if (!cells_were_seen_) wet_.fill({});
    // What was visited beside the steps' own way has to be seen once more.
    const Unvisited out = cells_were_seen_ ? left_out_by_both(region_.unvisited(), unseen_) : Unvisited();
    cells_were_seen_ = true;
    unseen_ = region_.unvisited();
    const int first_column = ends.cell_of(out.ends_before), first_row = picks.cell_of(out.picks_before);
    const int columns = ends.last_of(ends.yarns - 1 - out.ends_after) + 1 - first_column;
    const int rows = picks.last_of(picks.yarns - 1 - out.picks_after) + 1 - first_row;
    const double density = scene_->climate.density;
    exec_.for_each("see cells", 2 * columns * rows,
                   SeeShown{segments(), ends, picks, density, scene_->climate.temperature, scene_->rules.vapour,
                            scene_->rules.shows_wet_sums, scene_->climate.humidity, first_column, columns, first_row, rows,
                            shown_fields_.data(), shown_sums_.data()});
    exec_.for_each("sum cells", lines, SumShown{ends, picks, shown_sums_.data(), shown_lines_.data()});
    exec_.for_each("see wet", yarns().visited_ends(), SeeWet{segments(), density, wet_.data()});
}

template <typename Executor> template <typename LookAt> void YarnNetwork<Executor>::show(const LookAt& look_at, YarnStock& stock)
{
    const bool shows_segments = (yarns().whole() || scene_->rules.shows_segments) && !shows_cells();
    Segments::each(
        [&](const auto& field, auto& buffer, auto& shown) {
            const bool wanted = shows_segments && field.shown && (field.count != SegmentCount::shells || scene_->rules.shows_shells);
            shown = look_at(buffer, wanted ? buffer.size() : 0);
        },
        fields_, stock.segments);
    stock.cells = look_at(cells_, yarns().whole() ? 0 : cells_.size());
    stock.shown_fields = look_at(shown_fields_, shows_cells() ? shown_fields_.size() : 0);
    stock.shown_lines = look_at(shown_lines_, shows_cells() ? shown_lines_.size() : 0);
    stock.wet = look_at(wet_, shows_cells() ? wet_.size() : 0);
}

} // namespace hygroloom
