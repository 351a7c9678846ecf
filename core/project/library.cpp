// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A library is a list of projects of one fabric each, so that it is read, checked and migrated as projects are.
#include "core/project/library.h"
#include "core/base/words.h"

#include "core/design/pattern_words.h"
#include "core/project/atomic_file.h"
#include "core/project/color_text.h"
#include "core/project/json_reader.h"
#include "core/project/project_file.h"
#include "core/project/project_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace hygroloom {

extern const char library_fabrics_json[];
extern const char library_finishes_json[];

namespace {

constexpr int library_version = 1;

/// A library's file, of which each half is read and written without the other.
struct LibraryJson {
    ProjectJson presets = ProjectJson::array(), yarns = ProjectJson::array();
};

LibraryJson library_from(std::string_view text, const std::string& name)
{
    const ProjectJson json = parse_json(text, name);
    ObjectReader file(json, name, {});
    require_format(file, "hygroloom-library", library_version, "libraries");
    LibraryJson library{array_in(file.require("presets"), name, "presets")};
    if (const ProjectJson* yarns = file.find("yarns")) library.yarns = array_in(*yarns, name, "yarns");
    file.finish();
    return library;
}

LibraryJson library_at(const std::filesystem::path& path)
{
    return std::filesystem::exists(path) ? library_from(read_file(path, largest_project_bytes), path.string()) : LibraryJson();
}

void write_json(const LibraryJson& library, const std::filesystem::path& path)
{
    ProjectJson json{{"format", "hygroloom-library"}, {"version", library_version}, {"presets", library.presets}};
    if (!library.yarns.empty()) json["yarns"] = library.yarns;
    std::string text;
    try {
        text = text_from_json(json);
    } catch (const Error& error) {
        throw FileError(path.string() + ": " + error.what());
    }
    write_file(path, text, Previous::keep_as_backup);
}

/// Where it cannot be made, writing says so.
void make_folder_of(const std::filesystem::path& path)
{
    std::error_code ignored;
    std::filesystem::create_directories(path.parent_path(), ignored);
}

std::vector<Preset> presets_from(const ProjectJson& list, const std::string& name)
{
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

/// The name that a preset's material has in a design, which gets it unless it has the same.
std::string name_in(Design& design, const Material& material)
{
    for (const Material& own : design.materials) {
        Material named = own;
        named.name = material.name;
        named.based_on = material.based_on;
        if (named == material) return own.name;
    }
    Material added = material; // a name that a shipped fibre has would change the yarns that have that one
    added.name = free_name(material.name, [&](const std::string& wanted) { return find_material(design, wanted) != nullptr; });
    if (find_library_material(material.name) == &material) added.based_on = material.name;
    design.materials.push_back(added);
    return added.name;
}

/// A preset's fabric for a design, which gets its materials unless it has the same; names that are taken get a number.
Fabric fabric_for(Design& design, const Preset& preset)
{
    Fabric fabric = preset.fabric();
    std::map<std::string, std::string> names; // in the preset -> in the design
    for (const Material& material : preset.design.materials) names[material.name] = name_in(design, material);
    const auto rename = [&](std::string& name) {
        const Material* shipped = find_library_material(name);
        if (names.contains(name))
            name = names[name];
        else if (shipped && find_material(design, name) != shipped) // the design has another of that name
            name = names[name] = name_in(design, *shipped);
    };
    each_yarn(fabric, [&](Yarn& yarn) {
        for (MaterialShare& part : yarn.material) rename(part.name);
        if (yarn.core) rename(yarn.core->material);
    });
    return fabric;
}

ProjectJson json_of(const LibraryYarn& yarn)
{
    ProjectJson json{{"name", yarn.name}};
    if (!yarn.supplier.empty()) json["supplier"] = yarn.supplier;
    if (!yarn.currency.empty()) json["currency"] = yarn.currency;
    if (!yarn.colours.empty()) json["colours"] = ProjectJson::array();
    for (const YarnColour& colour : yarn.colours) json["colours"].push_back({{"name", colour.name}, {"color", text_of(colour.color)}});
    if (!yarn.unsaid.empty()) json["unsaid"] = yarn.unsaid;
    json["project"] = json_from_design(yarn.design);
    return json;
}

LibraryYarn yarn_from(const ProjectJson& json, const std::string& name, const std::string& at)
{
    ObjectReader entry(json, name, at);
    LibraryYarn yarn;
    entry.read("name", yarn.name);
    entry.read("supplier", yarn.supplier);
    entry.read("currency", yarn.currency);
    if (const ProjectJson* colours = entry.find("colours"))
        for (const ProjectJson& each : array_in(*colours, name, at + ".colours")) {
            ObjectReader colour(each, name, at + ".colours");
            std::string called, text;
            colour.read("name", called);
            colour.read("color", text);
            colour.finish({"name", "color"});
            const auto color = color_of(text);
            if (!color) colour.refuse("color", fmt::format("This must be a colour as \"#rrggbb\"; given is \"{}\".", text));
            yarn.colours.push_back({called, *color});
        }
    if (const ProjectJson* unsaid = entry.find("unsaid"))
        for (const ProjectJson& each : array_in(*unsaid, name, at + ".unsaid")) {
            const std::string key = each.is_string() ? each.get<std::string>() : std::string();
            if (std::find(unsaid_keys().begin(), unsaid_keys().end(), key) == unsaid_keys().end())
                entry.refuse("unsaid", fmt::format("A yarn may leave out {}; given is {}.", listed(unsaid_keys()), in_words(each)));
            yarn.unsaid.push_back(key);
        }
    yarn.design = design_from_json(entry.require("project"), name + ": " + at + ".project");
    entry.finish({"name"});
    if (yarn.design.fabrics.size() != 1) entry.refuse("project", "A yarn of the library has one fabric, whose warp it is.");
    return yarn;
}

} // namespace

const std::vector<Preset>& shipped_presets()
{
    static const std::vector<Preset> presets = presets_from(library_from(library_fabrics_json, "the library").presets, "the library");
    return presets;
}

std::vector<Preset> read_library(const std::filesystem::path& path) { return presets_from(library_at(path).presets, path.string()); }

void write_library(const std::vector<Preset>& presets, const std::filesystem::path& path)
{
    LibraryJson library = library_at(path);
    library.presets = ProjectJson::array();
    for (const Preset& preset : presets)
        library.presets.push_back({{"group", preset.group}, {"note", preset.note}, {"project", json_from_design(preset.design)}});
    write_json(library, path);
}

std::vector<LibraryYarn> read_yarns(const std::filesystem::path& path)
{
    const ProjectJson list = library_at(path).yarns;
    std::vector<LibraryYarn> yarns;
    for (std::size_t i = 0; i < list.size(); ++i) yarns.push_back(yarn_from(list[i], path.string(), fmt::format("yarns[{}]", i)));
    return yarns;
}

void write_yarns(const std::vector<LibraryYarn>& yarns, const std::filesystem::path& path)
{
    LibraryJson library = library_at(path);
    library.yarns = ProjectJson::array();
    for (const LibraryYarn& yarn : yarns) library.yarns.push_back(json_of(yarn));
    write_json(library, path);
}

LibraryYarn library_yarn(const Design& design, const Yarn& yarn, const std::string& name)
{
    Fabric fabric;
    fabric.name = name;
    fabric.warp = yarn;
    fabric.warp.library_yarn.clear();
    fabric.weft = fabric.warp;
    fabric.weave = weave_from_pattern("plain");
    return {name, {}, {}, {}, preset_of(design, fabric, {}, {}).design, {}};
}

void keep_yarn(std::vector<LibraryYarn>& yarns, LibraryYarn yarn)
{
    const auto same = std::find_if(yarns.begin(), yarns.end(), [&](const LibraryYarn& each) { return each.name == yarn.name; });
    if (same == yarns.end())
        yarns.push_back(std::move(yarn));
    else
        *same = std::move(yarn);
}

void keep_in_library(LibraryYarn yarn, const std::filesystem::path& path)
{
    make_folder_of(path);
    const ChangeLock alone(path);
    std::vector<LibraryYarn> yarns = read_yarns(path);
    keep_yarn(yarns, std::move(yarn));
    write_yarns(yarns, path);
}

void keep_in_library(Preset preset, const std::filesystem::path& path)
{
    make_folder_of(path);
    const ChangeLock alone(path);
    std::vector<Preset> kept = read_library(path);
    std::erase_if(kept, [&](const Preset& each) { return each.fabric().name == preset.fabric().name; });
    kept.push_back(std::move(preset));
    write_library(kept, path);
}

Yarn take_yarn(Design& design, const LibraryYarn& from)
{
    Yarn yarn = fabric_for(design, {{}, {}, from.design}).warp;
    yarn.library_yarn = from.name;
    return yarn;
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
    Fabric fabric = fabric_for(design, preset);
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
