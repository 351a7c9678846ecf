// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A library is a list of projects of one fabric each, so that it is read, checked and migrated as projects are.
#include "core/project/library.h"
#include "core/base/words.h"

#include "core/project/atomic_file.h"
#include "core/project/json_reader.h"
#include "core/project/project_file.h"
#include "core/project/project_json.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {

extern const char library_fabrics_json[];
extern const char library_finishes_json[];

namespace {

constexpr int library_version = 1;

std::vector<Preset> presets_from(std::string_view text, const std::string& name)
{
    const ProjectJson json = parse_json(text, name);
    ObjectReader file(json, name, {});
    require_format(file, "hygroloom-library", library_version, "libraries");
    const ProjectJson& list = array_in(file.require("presets"), name, "presets");
    file.finish();
    std::vector<Preset> presets;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string at = fmt::format("presets[{}]", i);
        ObjectReader entry(list[i], name, at);
        Preset preset;
        entry.read("group", preset.group);
        entry.read("note", preset.note);
        preset.design = design_from_json(entry.require("project"), name + ": " + at + ".project");
        entry.finish();
        if (preset.design.fabrics.size() != 1)
            entry.refuse("project", fmt::format("A preset has one fabric; this one has {}.", preset.design.fabrics.size()));
        presets.push_back(std::move(preset));
    }
    return presets;
}

template <typename Thing> std::string name_beside(const std::vector<Thing>& things, const std::string& name)
{
    return free_name(name, [&](const std::string& wanted) {
        return std::any_of(things.begin(), things.end(), [&](const Thing& thing) { return thing.name == wanted; });
    });
}

template <typename Change> void each_yarn(Fabric& fabric, const Change& change)
{
    change(fabric.warp);
    change(fabric.weft);
    for (Yarn& yarn : fabric.extra_yarns) change(yarn);
}

} // namespace

const std::vector<Preset>& shipped_presets()
{
    static const std::vector<Preset> presets = presets_from(library_fabrics_json, "the library");
    return presets;
}

std::vector<Preset> read_library(const std::filesystem::path& path)
{
    if (!std::filesystem::exists(path)) return {};
    return presets_from(read_file(path, largest_project_bytes), path.string());
}

void write_library(const std::vector<Preset>& presets, const std::filesystem::path& path)
{
    ProjectJson json{{"format", "hygroloom-library"}, {"version", library_version}};
    json["presets"] = ProjectJson::array();
    for (const Preset& preset : presets)
        json["presets"].push_back({{"group", preset.group}, {"note", preset.note}, {"project", json_from_design(preset.design)}});
    std::string text;
    try {
        text = text_from_json(json);
    } catch (const Error& error) {
        throw FileError(path.string() + ": " + error.what());
    }
    write_file(path, text, Previous::keep_as_backup);
}

Preset preset_of(const Design& design, const Fabric& fabric, const std::string& group, const std::string& note)
{
    Preset preset{group, note, {}};
    preset.design.fabrics.push_back(fabric);
    for (const Material& material : design.materials) {
        bool used = false;
        each_yarn(preset.design.fabrics[0], [&](const Yarn& yarn) {
            for (const std::string& name : materials_in(yarn)) used = used || name == material.name;
        });
        if (used) preset.design.materials.push_back(material);
    }
    return preset;
}

std::size_t add_preset(Design& design, const Preset& preset)
{
    Fabric fabric = preset.fabric();
    for (const Material& material : preset.design.materials) {
        const auto same = std::find_if(design.materials.begin(), design.materials.end(), [&](Material own) {
            own.name = material.name;
            return own == material;
        });
        Material added = material;
        added.name = same != design.materials.end() ? same->name : name_beside(design.materials, material.name);
        if (same == design.materials.end()) design.materials.push_back(added);
        each_yarn(fabric, [&](Yarn& yarn) {
            for (MaterialShare& part : yarn.material)
                if (part.name == material.name) part.name = added.name;
            if (yarn.core && yarn.core->material == material.name) yarn.core->material = added.name;
        });
    }
    fabric.name = name_beside(design.fabrics, fabric.name);
    design.fabrics.push_back(fabric);
    return design.fabrics.size() - 1;
}

const std::vector<Finish>& finishes()
{
    static const std::vector<Finish> all = [] {
        std::vector<Finish> list;
        const ProjectJson file = ProjectJson::parse(library_finishes_json);
        for (const auto& entry : file.at("finishes"))
            list.push_back(
                {entry.at("name").get<std::string>(), entry.at("contact_angle_deg").get<double>(), entry.at("note").get<std::string>()});
        return list;
    }();
    return all;
}

} // namespace hygroloom
