// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The cells of a garment with what they hold, for ParaView and others of VTK.
#include "core/analysis/poly_data.h"
#include "core/wear/wear_map.h"

#include <deque>
#include <map>
#include <utility>

namespace hygroloom {
namespace {

/// m, in space: from the middle of a cell to that of the next along the weft, and along the warp.
struct CellSides {
    Vec3d across, along;
};

/// Of each cell, as the shape lies there; beyond the shape's edge as at the cell beside, and where there is none, flat.
std::vector<CellSides> sides_of_cells(const WearLayout& layout)
{
    std::map<std::array<int, 3>, std::size_t> number; // by panel, end and pick
    std::vector<CellSides> sides(layout.cells.size());
    std::vector<std::uint8_t> known(layout.cells.size(), 0);
    std::deque<std::size_t> edge; // cells that tell their neighbours
    for (std::size_t i = 0; i < layout.cells.size(); ++i) {
        const GarmentCell& cell = layout.cells[i];
        const PanelGrid& grid = layout.panels[static_cast<std::size_t>(cell.panel)].grid;
        number[{cell.panel, cell.end, cell.pick}] = i;
        sides[i] = {{grid.across[0], grid.across[1], 0}, {grid.along[0], grid.along[1], 0}};
    }
    const GarmentShape& shape = layout.shape;
    for (std::size_t panel = 0; panel < layout.panels.size(); ++panel) {
        const PanelGrid& grid = layout.panels[panel].grid;
        for_cells_in_triangles(grid, shape, static_cast<int>(panel), [&](const CellInTriangle& at) {
            const auto found = number.find({static_cast<int>(panel), at.end, at.pick});
            if (found == number.end() || known[found->second]) return;
            const std::array<int, 3>& corners = shape.triangles[at.triangle];
            const auto flat = [&](std::size_t k) { return shape.flat[static_cast<std::size_t>(corners[k])]; };
            const auto place = [&](std::size_t k) { return shape.places[static_cast<std::size_t>(corners[k])]; };
            const FlatPlace a{flat(1)[0] - flat(0)[0], flat(1)[1] - flat(0)[1]}, b{flat(2)[0] - flat(0)[0], flat(2)[1] - flat(0)[1]};
            const double area = a[0] * b[1] - a[1] * b[0];
            const auto in_space = [&](const FlatPlace& step) {
                return ((step[0] * b[1] - step[1] * b[0]) / area) * (place(1) - place(0)) +
                       ((a[0] * step[1] - a[1] * step[0]) / area) * (place(2) - place(0));
            };
            sides[found->second] = {in_space(grid.across), in_space(grid.along)};
            known[found->second] = 1;
            edge.push_back(found->second);
        });
    }
    for (; !edge.empty(); edge.pop_front()) {
        const GarmentCell& cell = layout.cells[edge.front()];
        for (const auto& [e, p] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const auto found = number.find({cell.panel, cell.end + e, cell.pick + p});
            if (found == number.end() || known[found->second]) continue;
            known[found->second] = 1;
            sides[found->second] = sides[edge.front()];
            edge.push_back(found->second);
        }
    }
    return sides;
}

/// Cells as quadrilaterals. Where cells of a panel meet they share a corner, half-way between where each has it.
struct Quads {
    std::vector<float> places, flat; ///< mm
    std::vector<std::int32_t> corners, ends;

    explicit Quads(const WearLayout& layout)
    {
        const std::vector<CellSides> sides = sides_of_cells(layout);
        struct Corner {
            std::int32_t number = 0;
            int cells = 0;
            Vec3d sum;
            FlatPlace flat{};
        };
        std::map<std::array<int, 3>, Corner> known; // by panel, and by the end and the pick beyond it
        constexpr std::array<std::array<int, 2>, 4> round{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        for (std::size_t i = 0; i < layout.cells.size(); ++i) {
            const GarmentCell& cell = layout.cells[i];
            const CellSides& side = sides[i];
            const PanelGrid& grid = layout.panels[static_cast<std::size_t>(cell.panel)].grid;
            for (const auto& [e, p] : round) {
                const auto [at, is_new] = known.try_emplace({cell.panel, cell.end + e, cell.pick + p});
                Corner& corner = at->second;
                if (is_new) corner.number = static_cast<std::int32_t>(known.size() - 1);
                corners.push_back(corner.number);
                corner.sum = corner.sum + cell.place + (e - 0.5) * side.across + (p - 0.5) * side.along;
                ++corner.cells;
                for (std::size_t k = 0; k < 2; ++k) corner.flat[k] = cell.flat[k] + (e - 0.5) * grid.across[k] + (p - 0.5) * grid.along[k];
            }
            ends.push_back(static_cast<std::int32_t>(corners.size()));
        }
        places.resize(3 * known.size());
        flat.resize(3 * known.size());
        for (const auto& [key, corner] : known) {
            const Vec3d place = (1e3 / corner.cells) * corner.sum;
            const auto at = 3 * static_cast<std::size_t>(corner.number);
            places[at] = static_cast<float>(place.x);
            places[at + 1] = static_cast<float>(place.y);
            places[at + 2] = static_cast<float>(place.z);
            for (std::size_t k = 0; k < 2; ++k) flat[at + k] = static_cast<float>(1e3 * corner.flat[k]);
        }
    }
};

} // namespace

void write_cells_vtk(const WearLayout& layout, const WearFrame& frame, const std::filesystem::path& path)
{
    const Quads quads(layout);
    std::vector<std::int32_t> panel, zone, end, pick;
    for (const GarmentCell& cell : layout.cells) {
        panel.push_back(cell.panel);
        zone.push_back(cell.zone);
        end.push_back(cell.end);
        pick.push_back(cell.pick);
    }
    PolyData file;
    std::vector<std::string> panels;
    for (const WearPanel& each : layout.panels) panels.push_back(each.name);
    file.add_words("panels", panels);
    file.add_words("zones", layout.zone_names());
    file.begin("CellData");
    std::vector<std::vector<double>> numbers; // which must stay until the file is written
    for (const CellNumber& number : cell_numbers()) {
        std::vector<double> values;
        for (std::size_t i = 0; i < layout.cells.size(); ++i) values.push_back(number.of(layout.cells[i], frame, i));
        numbers.push_back(std::move(values));
        file.add(number.name, numbers.back());
    }
    for (const auto& [name, values] : {std::pair{"panel", &panel}, {"zone", &zone}, {"end", &end}, {"pick", &pick}})
        file.add(name, *values);
    file.end("CellData");
    file.begin("PointData");
    file.add("flat_mm", quads.flat, 3);
    file.end("PointData");
    file.begin("Points");
    file.add("Points", quads.places, 3);
    file.end("Points");
    file.begin("Polys");
    file.add("connectivity", quads.corners);
    file.add("offsets", quads.ends);
    file.end("Polys");
    file.write(path, frame.time, {quads.places.size() / 3, 0, 0, layout.cells.size()});
}

} // namespace hygroloom
