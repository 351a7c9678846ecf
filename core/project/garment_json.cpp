// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Garments in the project's JSON.
#include "core/base/words.h"
#include "core/project/field_json.h"
#include "core/project/project_json.h"

#include <fmt/format.h>

namespace hygroloom {

namespace {

BuiltInGarment read_built_in(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    object.require("built_in");
    std::vector<const char*> kinds;
    for (const std::string& kind : built_in_garments()) kinds.push_back(kind.c_str());
    BuiltInGarment garment = standard_garment(kinds[static_cast<std::size_t>(object.word("built_in", kinds))]);
    if (object.find("sleeve_mm") && garment.kind != "tee")
        object.refuse("sleeve_mm", fmt::format("Only a tee has sleeves; leave it out of a {}.", garment.kind));
    read_fields(object, garment);
    object.finish({"built_in"});
    return garment;
}

void read_source(ObjectReader& object, Garment& garment)
{
    const ProjectJson& source = object.require("source");
    const std::string path = object.path_of("source");
    if (source.is_object()) {
        garment.built_in = read_built_in(source, object.file(), path);
        return;
    }
    if (!source.is_string())
        object.refuse("source",
                      fmt::format("This must be the path of a file in quotes, or {{ \"built_in\": … }}; given is {}.", in_words(source)));
    garment.source = source.get<std::string>();
    if (garment.source.empty()) object.refuse("source", "The path of the garment's file is empty; give one.");
}

PanelCut read_cut(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    PanelCut cut;
    object.read("fabric", cut.fabric);
    read_fields(object, cut);
    object.read("lining", cut.lining);
    object.finish({"fabric"});
    return cut;
}

/// Numbers by names that are free.
std::map<std::string, double> read_numbers(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    std::map<std::string, double> numbers;
    for (const auto& [name, number] : value.items()) object.read(name, numbers[name]);
    return numbers;
}

std::vector<OwnZone> read_own_zones(const ProjectJson& value, const std::string& file, const std::string& path)
{
    std::vector<OwnZone> zones;
    const ProjectJson& list = array_in(value, file, path);
    for (std::size_t i = 0; i < list.size(); ++i) {
        ObjectReader object(list[i], file, fmt::format("{}[{}]", path, i));
        OwnZone zone;
        object.read("name", zone.name);
        object.read("panel", zone.panel);
        read_fields(object, zone);
        const ProjectJson& outline = object.require("outline_mm");
        const std::string at = object.path_of("outline_mm");
        for (const ProjectJson& place : array_in(outline, file, at)) {
            if (!place.is_array() || place.size() != 2)
                object.refuse("outline_mm", "Each place is two numbers, [x, y] in mm of the flat panel; given is " + in_words(place) + ".");
            zone.outline_mm.push_back({number_in(place[0], file, at), number_in(place[1], file, at)});
        }
        object.finish({"name", "panel", "sweat_g_m2_h"});
        zones.push_back(std::move(zone));
    }
    return zones;
}

ProjectJson json_from_own_zones(const std::vector<OwnZone>& zones)
{
    ProjectJson list = ProjectJson::array();
    for (const OwnZone& zone : zones) {
        ProjectJson outline = ProjectJson::array();
        for (const auto& place : zone.outline_mm) outline.push_back(ProjectJson::array({place[0], place[1]}));
        list.push_back({{"name", zone.name}, {"panel", zone.panel}, {"outline_mm", outline}});
        write_fields(list.back(), zone);
    }
    return list;
}

void read_wearer(const ProjectJson& value, const std::string& file, const std::string& path, Wearer& wearer)
{
    ObjectReader object(value, file, path);
    read_fields(object, wearer);
    if (const ProjectJson* gap = object.find("gap_mm")) wearer.gap_mm = read_numbers(*gap, file, object.path_of("gap_mm"));
    object.read("zones", wearer.zones);
    if (const ProjectJson* zones = object.find("own_zones")) wearer.own_zones = read_own_zones(*zones, file, object.path_of("own_zones"));
    object.finish();
}

} // namespace

Garment garment_from_json(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    Garment garment;
    object.require("name");
    object.read("name", garment.name);
    read_source(object, garment);
    std::vector<const char*> units;
    for (int unit = 0; unit < uv_units; ++unit) units.push_back(name_of(static_cast<UvUnit>(unit)));
    if (object.find("uv_unit")) garment.uv_unit = static_cast<UvUnit>(object.word("uv_unit", units));
    const ProjectJson& panels = object.require("panels");
    ObjectReader cuts(panels, file, object.path_of("panels")); // refuses what is no object
    for (const auto& [panel, cut] : panels.items()) garment.panels[panel] = read_cut(cut, file, cuts.path_of(panel));
    if (const ProjectJson* seams = object.find("seams")) garment.seams = read_numbers(*seams, file, object.path_of("seams"));
    if (const ProjectJson* wearer = object.find("wearer")) read_wearer(*wearer, file, object.path_of("wearer"), garment.wearer);
    object.finish();
    return garment;
}

ProjectJson json_from_garment(const Garment& garment)
{
    ProjectJson json{{"name", garment.name}};
    if (garment.is_built_in()) {
        json["source"] = {{"built_in", garment.built_in.kind}};
        write_fields(json["source"], garment.built_in);
    } else {
        json["source"] = garment.source;
    }
    if (garment.uv_unit != UvUnit::from_lengths) json["uv_unit"] = name_of(garment.uv_unit);
    json["panels"] = ProjectJson::object();
    for (const auto& [panel, cut] : garment.panels) {
        ProjectJson& written = json["panels"][panel];
        written = {{"fabric", cut.fabric}};
        write_fields(written, cut);
        if (!cut.lining.empty()) written["lining"] = cut.lining;
    }
    if (!garment.seams.empty()) json["seams"] = ProjectJson::object();
    for (const auto& [seam, share] : garment.seams) json["seams"][seam] = share;
    const Wearer& wearer = garment.wearer;
    json["wearer"] = json_of_fields(wearer);
    json["wearer"]["gap_mm"] = ProjectJson::object();
    json["wearer"]["zones"] = wearer.zones;
    for (const auto& [zone, gap] : wearer.gap_mm) json["wearer"]["gap_mm"][zone] = gap;
    if (!wearer.own_zones.empty()) json["wearer"]["own_zones"] = json_from_own_zones(wearer.own_zones);
    return json;
}

} // namespace hygroloom
