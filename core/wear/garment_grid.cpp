// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/garment_grid.h"

#include "core/base/error.h"
#include "core/garment/outline.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace hygroloom {
namespace {

constexpr double most_cells_across = 100'000;
constexpr double rounding = 1e-6; // of a cell

double dot(const FlatPlace& a, const FlatPlace& b) { return a[0] * b[0] + a[1] * b[1]; }

/// Marks the cells of each pick between every second place where the outline crosses the pick's middle line; those with their middle on it,
/// too, so that both sides of a symmetric panel have them.
void mark_inside(PanelGrid& grid, const std::vector<FlatPlace>& outline)
{
    const double across2 = dot(grid.across, grid.across), along2 = dot(grid.along, grid.along);
    const auto in_cells = [&](const FlatPlace& place) -> FlatPlace {
        const FlatPlace from{place[0] - grid.origin[0], place[1] - grid.origin[1]};
        return {dot(from, grid.across) / across2, dot(from, grid.along) / along2};
    };
    std::vector<std::vector<double>> cuts(static_cast<std::size_t>(grid.picks));
    for (std::size_t i = 0; i < outline.size(); ++i) {
        FlatPlace a = in_cells(outline[i]), b = in_cells(outline[(i + 1) % outline.size()]);
        if (a[1] > b[1]) std::swap(a, b);
        const int first = std::max(0, static_cast<int>(std::ceil(a[1]))),
                  last = std::min(grid.picks - 1, static_cast<int>(std::ceil(b[1])) - 1);
        for (int pick = first; pick <= last; ++pick)
            cuts[static_cast<std::size_t>(pick)].push_back(a[0] + (pick - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
    }
    for (int pick = 0; pick < grid.picks; ++pick) {
        std::vector<double>& cut = cuts[static_cast<std::size_t>(pick)];
        std::sort(cut.begin(), cut.end());
        for (std::size_t k = 0; k + 1 < cut.size(); k += 2)
            for (int end = std::max(0, static_cast<int>(std::ceil(cut[k] - rounding))); end < grid.ends && end <= cut[k + 1] + rounding;
                 ++end)
                grid.there[grid.cell(end, pick)] = 1;
    }
}

/// m2 by which the cells' area differs from that inside the outline.
double area_off(const PanelGrid& grid, double area)
{
    const auto cells = static_cast<double>(std::count(grid.there.begin(), grid.there.end(), 1));
    return std::abs(cells * std::abs(grid.across[0] * grid.along[1] - grid.across[1] * grid.along[0]) - area);
}

} // namespace

std::array<int, 2> PanelGrid::cell_at(const FlatPlace& place) const
{
    const FlatPlace from{place[0] - origin[0], place[1] - origin[1]};
    return {static_cast<int>(std::lround(dot(from, across) / dot(across, across))),
            static_cast<int>(std::lround(dot(from, along) / dot(along, along)))};
}

PanelGrid panel_grid(const PatternPanel& panel, double grain, double end_pitch, double pick_pitch)
{
    const FlatPlace across{std::cos(grain), std::sin(grain)}, along{-std::sin(grain), std::cos(grain)};
    const std::vector<FlatPlace> places = outline_of(panel);
    double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
    for (const FlatPlace& place : places)
        for (int k = 0; k < 2; ++k) {
            const double at = dot(place, k == 0 ? across : along);
            low[k] = std::min(low[k], at);
            high[k] = std::max(high[k], at);
        }
    const double ends = std::ceil((high[0] - low[0]) / end_pitch - rounding), picks = std::ceil((high[1] - low[1]) / pick_pitch - rounding);
    if (!(ends <= most_cells_across && picks <= most_cells_across))
        throw Error("The panel \"" + panel.name + "\" has more than 100 000 cells across; take larger ones.");
    const auto grid_of = [&](int end_count, int pick_count) {
        PanelGrid grid;
        grid.ends = std::max(1, end_count);
        grid.picks = std::max(1, pick_count);
        const double first_end = 0.5 * (low[0] + high[0]) - 0.5 * (grid.ends - 1) * end_pitch,
                     first_pick = 0.5 * (low[1] + high[1]) - 0.5 * (grid.picks - 1) * pick_pitch;
        for (std::size_t k = 0; k < 2; ++k) {
            grid.origin[k] = first_end * across[k] + first_pick * along[k];
            grid.across[k] = end_pitch * across[k];
            grid.along[k] = pick_pitch * along[k];
        }
        grid.there.assign(static_cast<std::size_t>(grid.ends) * static_cast<std::size_t>(grid.picks), 0);
        mark_inside(grid, places);
        return grid;
    };
    // Of the grids about the panel's middle that with the panel's area: with all cells that have a part of it, or one less either way.
    PanelGrid best = grid_of(static_cast<int>(ends), static_cast<int>(picks));
    const double area = area_of(panel);
    for (const auto& [fewer_ends, fewer_picks] : {std::array{0, 1}, {1, 0}, {1, 1}}) {
        PanelGrid grid = grid_of(static_cast<int>(ends) - fewer_ends, static_cast<int>(picks) - fewer_picks);
        if (area_off(grid, area) < (1 - rounding) * area_off(best, area)) best = std::move(grid);
    }
    return best;
}

PanelGrid turned(const PanelGrid& grid)
{
    PanelGrid made = grid;
    std::swap(made.ends, made.picks);
    std::swap(made.across, made.along);
    for (int end = 0; end < made.ends; ++end)
        for (int pick = 0; pick < made.picks; ++pick) made.there[made.cell(end, pick)] = grid.there[grid.cell(pick, end)];
    return made;
}

void for_cells_in_triangles(const PanelGrid& grid, const GarmentShape& shape, int panel, const VisitCell& visit)
{
    for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
        if (shape.panel[t] != panel) continue;
        std::array<FlatPlace, 3> flat;
        int low[2] = {grid.ends, grid.picks}, high[2] = {-1, -1};
        for (std::size_t k = 0; k < 3; ++k) {
            flat[k] = shape.flat[static_cast<std::size_t>(shape.triangles[t][k])];
            const std::array<int, 2> at = grid.cell_at(flat[k]);
            for (std::size_t side = 0; side < 2; ++side) {
                low[side] = std::min(low[side], at[side]);
                high[side] = std::max(high[side], at[side]);
            }
        }
        const double whole = twice_area(flat[0], flat[1], flat[2]);
        if (whole == 0) continue;
        for (int end = std::max(0, low[0]); end <= std::min(grid.ends - 1, high[0]); ++end)
            for (int pick = std::max(0, low[1]); pick <= std::min(grid.picks - 1, high[1]); ++pick) {
                const FlatPlace at = grid.middle(end, pick);
                const double a = twice_area(at, flat[1], flat[2]) / whole, b = twice_area(flat[0], at, flat[2]) / whole, c = 1 - a - b;
                constexpr double beside = -1e-9;
                if (a < beside || b < beside || c < beside) continue;
                visit({t, end, pick, {a, b, c}});
            }
    }
}

std::vector<Vec3d> places_of(const PanelGrid& grid, const GarmentShape& shape, int panel)
{
    std::vector<Vec3d> places(grid.there.size());
    std::vector<std::uint8_t> known(places.size(), 0);
    for_cells_in_triangles(grid, shape, panel, [&](const CellInTriangle& at) {
        const auto corner = [&](std::size_t k) { return shape.places[static_cast<std::size_t>(shape.triangles[at.triangle][k])]; };
        places[grid.cell(at.end, at.pick)] = at.shares[0] * corner(0) + at.shares[1] * corner(1) + at.shares[2] * corner(2);
        known[grid.cell(at.end, at.pick)] = 1;
    });
    std::deque<std::array<int, 2>> edge; // cells that tell their neighbours
    for (int end = 0; end < grid.ends; ++end)
        for (int pick = 0; pick < grid.picks; ++pick)
            if (known[grid.cell(end, pick)]) edge.push_back({end, pick});
    for (; !edge.empty(); edge.pop_front()) {
        const auto [end, pick] = edge.front();
        for (const auto& [e, p] : {std::array{end + 1, pick}, {end - 1, pick}, {end, pick + 1}, {end, pick - 1}}) {
            if (e < 0 || p < 0 || e >= grid.ends || p >= grid.picks || known[grid.cell(e, p)]) continue;
            known[grid.cell(e, p)] = 1;
            places[grid.cell(e, p)] = places[grid.cell(end, pick)];
            edge.push_back({e, p});
        }
    }
    return places;
}

} // namespace hygroloom
