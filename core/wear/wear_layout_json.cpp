// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/wear_layout_json.h"

#include "core/project/json_reader.h"

#include <fmt/format.h>

#include <cmath>

namespace hygroloom {
namespace {

constexpr std::size_t most_panels = 255;
constexpr double most_flat = 100;                  // m, of places on flat panels
constexpr double least_side = 1e-6, most_side = 1; // m, of cells

ProjectJson json_of(const FlatPlace& place) { return ProjectJson::array({place[0], place[1]}); }

FlatPlace place_in(const ProjectJson& value, const std::string& file, const std::string& path)
{
    const ProjectJson& pair = array_in(value, file, path);
    if (pair.size() != 2) throw FileError(fmt::format("{}: {}: a place has two numbers.", file, path));
    const FlatPlace place{number_in(pair[0], file, path), number_in(pair[1], file, path)};
    if (!(std::abs(place[0]) <= most_flat && std::abs(place[1]) <= most_flat))
        throw FileError(fmt::format("{}: {}: a place lies within {:g} m; given is {:g}, {:g}.", file, path, most_flat, place[0], place[1]));
    return place;
}

/// Of cells: each as long as a cell can be, and not along each other.
bool can_be_sides(const FlatPlace& across, const FlatPlace& along)
{
    const double a = std::hypot(across[0], across[1]), b = std::hypot(along[0], along[1]);
    const auto is_length = [](double length) { return length >= least_side && length <= most_side; };
    return is_length(a) && is_length(b) && std::abs(across[0] * along[1] - across[1] * along[0]) > 0.01 * a * b;
}

WearPanel read_panel(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    WearPanel panel;
    object.read("name", panel.name);
    object.read("fabric", panel.fabric);
    object.read("grain", panel.grain);
    object.read("crossings_per_cell", panel.crossings_per_cell);
    object.read("ends", panel.grid.ends);
    object.read("picks", panel.grid.picks);
    panel.grid.origin = place_in(object.require("origin"), file, path);
    panel.grid.across = place_in(object.require("across"), file, path);
    panel.grid.along = place_in(object.require("along"), file, path);
    for (const ProjectJson& place : array_in(object.require("outline"), file, path)) panel.outline.push_back(place_in(place, file, path));
    object.finish({"name", "ends", "picks"});
    const auto is_count = [](int count) { return count >= 1 && count <= 100'000; };
    if (!is_count(panel.crossings_per_cell) || !is_count(panel.grid.ends) || !is_count(panel.grid.picks) || panel.outline.size() < 3)
        throw FileError(fmt::format("{}: {}: a panel has from 1 to 100 000 cells each way, and an outline.", file, path));
    if (static_cast<long>(panel.grid.ends) * panel.grid.picks > most_layout_cells)
        throw FileError(fmt::format("{}: {}: a panel has at most {} cells; given are {} x {}.", file, path, most_layout_cells,
                                    panel.grid.ends, panel.grid.picks));
    if (!can_be_sides(panel.grid.across, panel.grid.along))
        throw FileError(fmt::format("{}: {}: a cell's sides, across and along, are from {:g} to {:g} m long and cross each other.", file,
                                    path, least_side, most_side));
    if (!(std::abs(panel.grain) <= 10)) throw FileError(fmt::format("{}: {}.grain: {:g} is no angle.", file, path, panel.grain));
    return panel;
}

double skin_temperature_in(double temperature, const std::string& file)
{
    if (!(temperature >= 200 && temperature <= 400))
        throw FileError(fmt::format("{}: skin_temperature is from 200 to 400 K; given is {:g}.", file, temperature));
    return temperature;
}

decltype(WearLayout::skin_course) read_skin_course(const ProjectJson& courses, const std::string& file)
{
    constexpr const char* name = "skin_course";
    decltype(WearLayout::skin_course) read;
    for (const ProjectJson& zone : array_in(courses, file, name)) {
        read.emplace_back();
        for (const ProjectJson& moment : array_in(zone, file, name)) {
            const double before = read.back().empty() ? 0 : read.back().back().time;
            if (array_in(moment, file, name).size() != 2 || number_in(moment[0], file, name) < before)
                throw FileError(fmt::format("{}: {}: moments have a time and a temperature, and are in order.", file, name));
            read.back().push_back({number_in(moment[0], file, name), skin_temperature_in(number_in(moment[1], file, name), file)});
        }
    }
    return read;
}

} // namespace

std::string layout_json(const WearLayout& layout)
{
    ProjectJson json{{"garment", layout.garment},
                     {"experiment", layout.experiment},
                     {"cells_in_words", layout.cells_in_words},
                     {"skin_temperature", layout.skin_temperature}};
    if (!layout.own_zones.empty()) json["own_zones"] = layout.own_zones;
    if (layout.stops) json["stops"] = *layout.stops;
    for (const std::vector<WearLayout::SkinTemperature>& zone : layout.skin_course) {
        ProjectJson& course = json["skin_course"].emplace_back(ProjectJson::array());
        for (const auto& [time, temperature] : zone) course.push_back(ProjectJson::array({time, temperature}));
    }
    json["panels"] = ProjectJson::array();
    for (const WearPanel& panel : layout.panels) {
        ProjectJson made{{"name", panel.name},
                         {"fabric", panel.fabric},
                         {"grain", panel.grain},
                         {"crossings_per_cell", panel.crossings_per_cell},
                         {"ends", panel.grid.ends},
                         {"picks", panel.grid.picks},
                         {"origin", json_of(panel.grid.origin)},
                         {"across", json_of(panel.grid.across)},
                         {"along", json_of(panel.grid.along)}};
        made["outline"] = ProjectJson::array();
        for (const FlatPlace& place : panel.outline) made["outline"].push_back(json_of(place));
        json["panels"].push_back(std::move(made));
    }
    return json.dump();
}

WearLayout layout_from(const std::string& text, const std::string& file)
{
    const ProjectJson json = parse_json(text, file);
    ObjectReader object(json, file, {});
    WearLayout layout;
    object.read("garment", layout.garment);
    object.read("experiment", layout.experiment);
    object.read("cells_in_words", layout.cells_in_words);
    object.read("skin_temperature", layout.skin_temperature);
    object.read("stops", layout.stops);
    layout.skin_temperature = skin_temperature_in(layout.skin_temperature, file);
    if (const ProjectJson* courses = object.find("skin_course")) layout.skin_course = read_skin_course(*courses, file);
    if (const ProjectJson* zones = object.find("own_zones"))
        for (const ProjectJson& name : array_in(*zones, file, "own_zones")) layout.own_zones.push_back(text_in(name, file, "own_zones"));
    const ProjectJson& panels = array_in(object.require("panels"), file, "panels");
    if (panels.empty() || panels.size() > most_panels) throw FileError(file + ": a garment has from 1 to 255 panels.");
    for (std::size_t i = 0; i < panels.size(); ++i) layout.panels.push_back(read_panel(panels[i], file, fmt::format("panels[{}]", i)));
    object.finish({"garment", "experiment"});
    return layout;
}

} // namespace hygroloom
