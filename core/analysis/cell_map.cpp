// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/cell_map.h"

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/base/version.h"
#include "core/project/atomic_file.h"
#include "core/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {

MapSide map_side_from_name(const std::string& name)
{
    if (name == "top") return MapSide::top;
    if (name == "bottom") return MapSide::bottom;
    if (name == "total") return MapSide::total;
    throw Error("The side of a map must be top, bottom or total; \"" + name + "\" was given.");
}

double CellMap::maximum() const { return water.empty() ? 0.0 : *std::max_element(water.begin(), water.end()); }

Frame start_of_maps(const RunRecord& run, Frame first)
{
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    if (!experiment || !starts_wet(experiment->type)) return first;
    std::fill(first.liquid.begin(), first.liquid.end(), 0.0f);
    // The fibres absorbed part of the test's water; before it, they were in equilibrium with the air.
    const Scene scene = build_scene(run.design, run.textile, *experiment, run.plan, run.seed);
    const auto ends = static_cast<std::size_t>(scene.cloth.ends), picks = static_cast<std::size_t>(scene.cloth.picks);
    for (std::size_t line = 0, i = 0; line < ends + picks; ++line) {
        const auto dry = static_cast<float>(scene.cloth.yarns[scene.cloth.type[line]].resting_regain);
        for (const std::size_t end = i + (line < ends ? picks : ends); i < end; ++i) first.regain[i] = std::min(first.regain[i], dry);
    }
    return first;
}

namespace {

/// n crossings a cell, or, of a cloth that is shown in cells, as many of those as come nearest.
CellMap empty_map(const Textile& textile, int crossings)
{
    const int n = std::max(1, static_cast<int>(std::lround(static_cast<double>(crossings) / textile.yarns_per_cell())));
    CellMap map;
    map.crossings_per_cell = n * textile.yarns_per_cell();
    map.columns = (textile.ends() + n - 1) / n;
    map.rows = (textile.picks() + n - 1) / n;
    map.cell_width = n * textile.warp.pitch;
    map.cell_height = n * textile.weft.pitch;
    map.water.assign(static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows), 0.0);
    return map;
}

int cells_across(const Textile& textile, const CellMap& map) { return map.crossings_per_cell / textile.yarns_per_cell(); }

/// Calls use(kind, end, pick, segment, cell, its part that lies on the side) for each segment of which some does.
template <typename Use> void for_each_on(const Textile& textile, MapSide side, const CellMap& map, const Use& use)
{
    const int n = cells_across(textile, map);
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (int end = 0; end < textile.ends(); ++end)
            for (int pick = 0; pick < textile.picks(); ++pick) {
                const double top = textile.on_top(kind, end, pick);
                const double part = side == MapSide::total ? 1.0 : side == MapSide::top ? top : 1.0 - top;
                if (part == 0) continue;
                use(kind, end, pick, static_cast<std::size_t>(textile.segment(kind, end, pick)),
                    static_cast<std::size_t>(pick / n) * static_cast<std::size_t>(map.columns) + static_cast<std::size_t>(end / n), part);
            }
}

} // namespace

CellMap quantity_map(const Textile& textile, const Frame& frame, ShownQuantity quantity, MapSide side, int n)
{
    CellMap map = empty_map(textile, n);
    map.quantity = quantity;
    const std::vector<float> values = segment_values(frame, quantity);
    std::vector<double> lengths(map.water.size());
    for_each_on(textile, side, map, [&](YarnKind kind, int end, int pick, std::size_t i, std::size_t cell, double part) {
        const double length = part * textile.segment_length(kind, end, pick);
        map.water[cell] += length * static_cast<double>(values[i]);
        lengths[cell] += length;
    });
    // At each crossing one of its two yarns lies on the side.
    for (std::size_t cell = 0; cell < lengths.size(); ++cell) map.water[cell] /= lengths[cell];
    return map;
}

CellMap cell_map(const Textile& textile, const Frame& frame, const Frame& start, MapSide side, int crossings)
{
    CellMap map = empty_map(textile, crossings);
    const int n = cells_across(textile, map);
    for_each_on(textile, side, map, [&](YarnKind kind, int end, int pick, std::size_t i, std::size_t cell, double part) {
        map.water[cell] += part * (static_cast<double>(frame.liquid[i]) - static_cast<double>(start.liquid[i]));
        if (frame.regain[i] == start.regain[i]) return; // as in most of a cloth
        const YarnType& type = textile.type(kind, kind == YarnKind::warp ? end : pick);
        const double fibres = type.area * type.packing * type.fibre.density_kg_m3; // kg/m
        map.water[cell] += part * (static_cast<double>(frame.regain[i]) - static_cast<double>(start.regain[i])) * fibres *
                           textile.segment_length(kind, end, pick);
    });
    for (int row = 0; row < map.rows; ++row)
        for (int column = 0; column < map.columns; ++column) {
            const int ends = std::min(n, textile.ends() - column * n), picks = std::min(n, textile.picks() - row * n);
            map.water[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) + static_cast<std::size_t>(column)] /=
                ends * picks * textile.warp.pitch * textile.weft.pitch;
        }
    return map;
}

void write_cell_map_csv(const CellMap& map, const RunRecord& run, double time, MapSide side, const std::filesystem::path& path)
{
    constexpr const char* names[] = {"top", "bottom", "total"};
    const bool warm = map.quantity == ShownQuantity::temperature;
    const char* column_name = warm ? "temperature_c" : map.quantity == ShownQuantity::humidity ? "relative_humidity" : "water_g_m2";
    const auto written = [&](double value) {
        return warm ? celsius_from_kelvin(value) : map.quantity == ShownQuantity::humidity ? value : 1e3 * value;
    };
    std::string text =
        fmt::format("# program=Hygroloom {}\n# simulated=true\n# fabric={}\n# experiment={}\n# fidelity={}\n# seed={}\n# time_s={}\n"
                    "# side={}\n# crossings_per_cell={}\ncolumn,row,x_mm,y_mm,{}\n",
                    program_version(), run.fabric, run.experiment, name_of(run.plan.fidelity), run.seed, time,
                    names[static_cast<int>(side)], map.crossings_per_cell, column_name);
    const double width = run.textile.ends() * run.textile.warp.pitch, height = run.textile.picks() * run.textile.weft.pitch;
    for (int row = 0; row < map.rows; ++row)
        for (int column = 0; column < map.columns; ++column) {
            // The middle of what the cell really covers.
            const double right = std::min((column + 1) * map.cell_width, width), top = std::min((row + 1) * map.cell_height, height);
            text += fmt::format("{},{},{:.6g},{:.6g},{:.6g}\n", column, row, mm_from_metre(0.5 * (column * map.cell_width + right - width)),
                                mm_from_metre(0.5 * (row * map.cell_height + top - height)), written(map.at(column, row)));
        }
    write_file(path, text);
}

} // namespace hygroloom
