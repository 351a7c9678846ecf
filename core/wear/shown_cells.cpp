// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/garment_scene.h"

#include "core/base/error.h"
#include "core/base/words.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace hygroloom {
namespace {

constexpr std::size_t most_unasked = 500'000; // cells

/// Near an asked side; at least the side where it is not asked for.
int computed_per_cell(const GarmentScene& garment, std::size_t panel, double side, bool asked)
{
    const double cells = side / std::sqrt(garment.fabrics[static_cast<std::size_t>(garment.fabric[panel])].cell_area());
    return std::max(1, static_cast<int>(asked ? std::lround(cells) : std::ceil(cells)));
}

/// Of the computed grid, in squares of so many cells; the last ones may be smaller.
PanelGrid coarse(const PanelGrid& fine, int per_cell)
{
    PanelGrid grid = fine;
    grid.ends = (fine.ends + per_cell - 1) / per_cell;
    grid.picks = (fine.picks + per_cell - 1) / per_cell;
    for (std::size_t k = 0; k < 2; ++k) {
        grid.across[k] = per_cell * fine.across[k];
        grid.along[k] = per_cell * fine.along[k];
        grid.origin[k] = fine.origin[k] + 0.5 * (per_cell - 1) * (fine.across[k] + fine.along[k]);
    }
    grid.there.assign(static_cast<std::size_t>(grid.ends) * static_cast<std::size_t>(grid.picks), 0);
    return grid;
}

/// What computed cells come to, with their mean place.
GarmentCell sum_of(const std::vector<const GarmentCell*>& computed)
{
    GarmentCell sum = *computed.front();
    sum.area = sum.capacity = sum.skin_contact = 0;
    sum.place = {};
    std::map<int, double> area_of_zone;
    for (const GarmentCell* cell : computed) {
        sum.area += cell->area;
        sum.capacity += cell->capacity;
        sum.skin_contact += cell->area * cell->skin_contact;
        sum.place = sum.place + cell->area * cell->place;
        area_of_zone[cell->zone] += cell->area;
    }
    sum.skin_contact /= sum.area;
    sum.place = (1 / sum.area) * sum.place;
    sum.zone =
        std::max_element(area_of_zone.begin(), area_of_zone.end(), [](const auto& a, const auto& b) { return a.second < b.second; })->first;
    return sum;
}

void require_panels(const GarmentPattern& pattern, const std::vector<std::string>& names)
{
    std::vector<std::string> all;
    for (const PatternPanel& panel : pattern.panels) all.push_back(panel.name);
    for (const std::string& name : names)
        if (std::find(all.begin(), all.end(), name) == all.end())
            throw Error("The garment has no panel \"" + name + "\"" + did_you_mean(name, all));
}

/// m; 0: as computed.
double shown_side(const GarmentScene& garment, const ShownSize& size)
{
    if (size.side > 0 || garment.cells.size() <= most_unasked) return size.side;
    double area = 0;
    for (const GarmentCell& cell : garment.cells) area += cell.area;
    return std::sqrt(area / most_unasked);
}

using ComputedCells = std::vector<std::vector<const GarmentCell*>>; ///< of each shown cell

/// In the order of their first crossings.
ComputedCells group(const GarmentScene& garment, const ShownCells& shown)
{
    std::vector<std::size_t> first{0}; // place of each panel
    for (const PanelGrid& grid : shown.grids) first.push_back(first.back() + grid.there.size());
    ComputedCells computed(first.back());
    for (const GarmentCell& cell : garment.cells) {
        const auto panel = static_cast<std::size_t>(cell.panel);
        const int per_cell = shown.computed_per_cell[panel];
        computed[first[panel] + shown.grids[panel].cell(cell.end / per_cell, cell.pick / per_cell)].push_back(&cell);
    }
    std::erase_if(computed, [](const auto& cells) { return cells.empty(); });
    std::sort(computed.begin(), computed.end(), [](const auto& a, const auto& b) { return a.front()->crossing < b.front()->crossing; });
    return computed;
}

} // namespace

ShownCells show_cells(GarmentScene& garment, const GarmentPattern& pattern, const ShownSize& size)
{
    require_panels(pattern, size.detail);
    const double side = shown_side(garment, size);
    ShownCells shown;
    for (std::size_t panel = 0; panel < garment.grids.size(); ++panel) {
        const std::string& name = pattern.panels[panel].name;
        const bool whole = std::find(size.detail.begin(), size.detail.end(), name) != size.detail.end();
        shown.computed_per_cell.push_back(whole ? 1 : computed_per_cell(garment, panel, side, size.side > 0));
        shown.grids.push_back(coarse(garment.grids[panel], shown.computed_per_cell.back()));
    }
    ClothPanels& panels = garment.scene.cloth.panels;
    for (const std::vector<const GarmentCell*>& computed : group(garment, shown)) {
        for (const GarmentCell* cell : computed) panels.shown.push_back(cell->crossing);
        panels.shown_ends.push_back(static_cast<int>(panels.shown.size()));
        GarmentCell cell = sum_of(computed);
        const auto panel = static_cast<std::size_t>(cell.panel);
        cell.end /= shown.computed_per_cell[panel];
        cell.pick /= shown.computed_per_cell[panel];
        cell.flat = shown.grids[panel].middle(cell.end, cell.pick);
        shown.grids[panel].there[shown.grids[panel].cell(cell.end, cell.pick)] = 1;
        shown.cells.push_back(cell);
    }
    const auto is_turned = [&](std::size_t panel) { return garment.fabrics[static_cast<std::size_t>(garment.fabric[panel])].turned; };
    for (GarmentCell& cell : shown.cells)
        if (is_turned(static_cast<std::size_t>(cell.panel))) std::swap(cell.end, cell.pick);
    for (std::size_t panel = 0; panel < shown.grids.size(); ++panel)
        if (is_turned(panel)) shown.grids[panel] = turned(shown.grids[panel]);
    return shown;
}

} // namespace hygroloom
