// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/trace_json.h"

#include "core/analysis/series_keys.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace hygroloom {
namespace {

constexpr double tenths = 1e4;          ///< of g/m2 in a kg/m2
constexpr double longest_cell_mm = 1e3; ///< an assumption
constexpr double longest_s = 1e9;       ///< the same
constexpr double most_tenths = 1e9;     ///< the same

/// With four digits.
double rounded(double value) { return std::strtod(fmt::format("{:.4g}", value).c_str(), nullptr); }

bool is_traced(const SeriesKey& key)
{
    const auto traced = traced_series();
    return std::find(traced.begin(), traced.end(), key.values) != traced.end();
}

constexpr std::size_t most_worn = 2000; ///< an assumption: numbers of the panels and zones of a garment

/// A curve that never changes is one number.
ProjectJson curve_value(const std::vector<double>& values)
{
    ProjectJson array = ProjectJson::array();
    for (const double value : values) array.push_back(rounded(value));
    const auto same = [&array](const ProjectJson& each) { return each == array.front(); };
    if (std::all_of(array.begin(), array.end(), same)) return ProjectJson::array({array.front()});
    return array;
}

/// The least rectangle of cells in which all are that hold anything, row by row.
ProjectJson face_value(const CellMap& map)
{
    std::vector<int> water;
    for (const double each : map.water)
        water.push_back(static_cast<int>(std::lround(std::clamp(tenths * each, -most_tenths, most_tenths))));
    int left = map.columns, right = -1, low = map.rows, high = -1;
    const auto at = [&](int column, int row) { return water[static_cast<std::size_t>(row * map.columns + column)]; };
    for (int row = 0; row < map.rows; ++row)
        for (int column = 0; column < map.columns; ++column) {
            if (at(column, row) == 0) continue;
            left = std::min(left, column);
            right = std::max(right, column);
            low = std::min(low, row);
            high = std::max(high, row);
        }
    ProjectJson value;
    value["from"] = right < 0 ? ProjectJson::array({0, 0}) : ProjectJson::array({left, low});
    value["size"] = right < 0 ? ProjectJson::array({0, 0}) : ProjectJson::array({right - left + 1, high - low + 1});
    value["water_tenths_of_g_m2"] = ProjectJson::array();
    for (int row = low; row <= high; ++row)
        for (int column = left; column <= right; ++column) value["water_tenths_of_g_m2"].push_back(at(column, row));
    return value;
}

ProjectJson map_value(const TracedMap& map)
{
    ProjectJson value;
    value["time_s"] = map.time;
    value["crossings_per_cell"] = map.top.crossings_per_cell;
    value["columns"] = map.top.columns;
    value["rows"] = map.top.rows;
    value["cell_mm"] = {1e3 * map.top.cell_width, 1e3 * map.top.cell_height};
    value["top"] = face_value(map.top);
    value["bottom"] = face_value(map.bottom);
    return value;
}

std::vector<double> curve_from(const ProjectJson& value, const std::string& key, ObjectReader& reader)
{
    const ProjectJson& numbers = array_in(value, reader.file(), reader.path_of(key));
    if (numbers.size() != 1 && numbers.size() != trace_points)
        reader.refuse(key, fmt::format("1 or {} numbers are allowed; given are {}.", trace_points, numbers.size()));
    std::vector<double> values;
    for (const ProjectJson& each : numbers) values.push_back(number_in(each, reader.file(), reader.path_of(key)));
    values.resize(trace_points, values.front());
    return values;
}

void read_curve(const ProjectJson& value, const SeriesKey& key, ObjectReader& reader, RunTrace& trace)
{
    std::vector<double>& values = trace.series.*key.values = curve_from(value, key.key, reader);
    for (double& each : values) each = (each - key.offset) / key.factor;
}

std::map<std::string, std::vector<double>> worn_from(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader reader(value, file, path);
    std::map<std::string, std::vector<double>> worn;
    for (const auto& [key, curve] : value.items())
        if (const ProjectJson* found = reader.find(key)) worn[key] = curve_from(*found, key, reader);
    return worn;
}

/// Two whole numbers, each between 0 and the grid's.
std::array<int, 2> pair_in(ObjectReader& reader, const char* key, const CellMap& grid)
{
    std::array<double, 2> pair{-1, -1};
    reader.read(key, pair);
    const auto fits = [](double number, int most) { return number >= 0 && number <= most && number == std::floor(number); };
    if (!fits(pair[0], grid.columns) || !fits(pair[1], grid.rows))
        reader.refuse(key, fmt::format("allowed are 0 to {} columns and 0 to {} rows, whole numbers.", grid.columns, grid.rows));
    return {static_cast<int>(pair[0]), static_cast<int>(pair[1])};
}

CellMap face_from(const ProjectJson& value, const std::string& file, const std::string& path, CellMap map)
{
    ObjectReader reader(value, file, path);
    const std::array<int, 2> from = pair_in(reader, "from", map), size = pair_in(reader, "size", map);
    if (from[0] + size[0] > map.columns || from[1] + size[1] > map.rows) reader.refuse("size", "it reaches beyond the map.");
    constexpr const char* key = "water_tenths_of_g_m2";
    const ProjectJson& cells = array_in(reader.require(key), file, reader.path_of(key));
    const auto count = static_cast<std::size_t>(size[0] * size[1]);
    if (cells.size() != count) reader.refuse(key, fmt::format("there must be {} cells; given are {}.", count, cells.size()));
    map.water.assign(static_cast<std::size_t>(map.columns * map.rows), 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        const double water = number_in(cells[i], file, reader.path_of(key));
        if (std::abs(water) > most_tenths) reader.refuse(key, fmt::format("allowed is -{0:g} to {0:g}.", most_tenths));
        const int column = from[0] + static_cast<int>(i) % size[0], row = from[1] + static_cast<int>(i) / size[0];
        map.water[static_cast<std::size_t>(row * map.columns + column)] = water / tenths;
    }
    reader.finish({"from", "size"});
    return map;
}

TracedMap map_from(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader reader(value, file, path);
    TracedMap made;
    CellMap grid;
    std::array<double, 2> cell{0, 0};
    reader.read("time_s", made.time);
    reader.read("crossings_per_cell", grid.crossings_per_cell);
    reader.read("columns", grid.columns);
    reader.read("rows", grid.rows);
    reader.read("cell_mm", cell);
    if (!(made.time >= 0 && made.time <= longest_s)) reader.refuse("time_s", fmt::format("allowed is 0 to {:g}.", longest_s));
    for (const auto& [key, number] : {std::pair("columns", grid.columns), std::pair("rows", grid.rows)})
        if (number < 1 || number > most_traced_cells) reader.refuse(key, fmt::format("allowed is 1 to {}.", most_traced_cells));
    if (grid.crossings_per_cell < 1) reader.refuse("crossings_per_cell", "allowed is 1 or more.");
    for (const double length : cell)
        if (!(length > 0 && length <= longest_cell_mm))
            reader.refuse("cell_mm", fmt::format("allowed is more than 0, up to {:g}.", longest_cell_mm));
    grid.cell_width = 1e-3 * cell[0];
    grid.cell_height = 1e-3 * cell[1];
    made.top = face_from(reader.require("top"), file, reader.path_of("top"), grid);
    made.bottom = face_from(reader.require("bottom"), file, reader.path_of("bottom"), grid);
    reader.finish({"time_s", "crossings_per_cell", "columns", "rows", "cell_mm"});
    return made;
}

} // namespace

ProjectJson trace_value(const RunTrace& trace)
{
    ProjectJson value;
    value["duration_s"] = trace.series.time.empty() ? 0.0 : trace.series.time.back();
    value["water_initial_g"] = rounded(1e3 * trace.water_initial);
    value["curves"] = ProjectJson::object();
    for (const SeriesKey& key : series_keys())
        if (is_traced(key) && !(trace.series.*key.values).empty()) value["curves"][key.key] = curve_value(values_of(key, trace.series));
    for (const auto& [key, values] : trace.worn) value["worn"][key] = curve_value(values);
    value["maps"] = ProjectJson::array();
    for (const TracedMap& map : trace.maps) value["maps"].push_back(map_value(map));
    return value;
}

RunTrace trace_from(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader reader(value, file, path);
    RunTrace trace;
    double duration = -1, initial = 0;
    reader.read("duration_s", duration);
    reader.read("water_initial_g", initial);
    if (!(duration >= 0 && duration <= longest_s)) reader.refuse("duration_s", fmt::format("allowed is 0 to {:g}.", longest_s));
    trace.water_initial = 1e-3 * initial;
    trace.series.time = trace_times(duration);
    ObjectReader curves(reader.require("curves"), file, reader.path_of("curves"));
    for (const SeriesKey& key : series_keys())
        if (is_traced(key))
            if (const ProjectJson* found = curves.find(key.key)) read_curve(*found, key, curves, trace);
    curves.finish();
    if (const ProjectJson* worn = reader.find("worn")) {
        if (worn->size() > most_worn) reader.refuse("worn", fmt::format("at most {} curves are allowed.", most_worn));
        trace.worn = worn_from(*worn, file, reader.path_of("worn"));
    }
    const ProjectJson& maps = array_in(reader.require("maps"), file, reader.path_of("maps"));
    if (maps.size() > std::size(traced_shares)) reader.refuse("maps", fmt::format("at most {} are allowed.", std::size(traced_shares)));
    for (std::size_t i = 0; i < maps.size(); ++i)
        trace.maps.push_back(map_from(maps[i], file, fmt::format("{}[{}]", reader.path_of("maps"), i)));
    reader.finish({"duration_s"});
    return trace;
}

} // namespace hygroloom
