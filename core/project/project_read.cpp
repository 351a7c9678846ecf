// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The design in a project's JSON. Form only: whether values make sense is for validate().
#include "core/base/words.h"
#include "core/project/field_json.h"
#include "core/project/project_file.h"
#include "core/project/project_json.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {

namespace {

void read_isotherm(ObjectReader& object, GabIsotherm& gab)
{
    const ProjectJson* value = object.find("isotherm");
    if (!value) return;
    if (value->is_string()) {
        if (*value != "master")
            object.refuse("isotherm", fmt::format("This must be \"master\" or an object; given is {}.", in_words(*value)));
        gab = {};
        return;
    }
    ObjectReader isotherm(*value, object.file(), object.path_of("isotherm"));
    isotherm.require("monolayer_regain");
    isotherm.require("c");
    isotherm.require("k");
    read_fields(isotherm, gab);
    isotherm.finish();
}

void read_diffusion(ObjectReader& object, FibreDiffusion& diffusion)
{
    const ProjectJson* value = object.find("fibre_diffusivity_m2_s");
    if (!value) return;
    diffusion.two_stage = *value == "two-stage";
    if (diffusion.two_stage) return;
    if (!value->is_number())
        object.refuse("fibre_diffusivity_m2_s", fmt::format("This must be a number or \"two-stage\"; given is {}.", in_words(*value)));
    diffusion.constant_m2_s = value->get<double>();
}

/// A number, or the name of a shape.
void read_cross_section(ObjectReader& object, CrossSection& section)
{
    const ProjectJson* value = object.find("cross_section");
    if (!value) return;
    std::string known;
    for (const CrossSection& shape : cross_sections()) {
        if (*value == shape.shape) {
            section = shape;
            return;
        }
        known += fmt::format("\"{}\", ", shape.shape);
    }
    if (!value->is_number())
        object.refuse("cross_section",
                      fmt::format("This must be one of {}or a number from 1 to 3, perimeter over that of a circle of the same "
                                  "area; given is {}.",
                                  known, in_words(*value)));
    section = {value->get<double>(), {}};
}

Material read_material(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    Material material;
    std::string name, based_on;
    std::vector<std::string> required{"name"};
    object.read("name", name);
    object.read("based_on", based_on);
    if (!based_on.empty()) {
        const Material* base = find_library_material(based_on);
        if (!base) {
            const std::string known = listed(names_in(material_library()));
            object.refuse("based_on", fmt::format("The library has no material {}. It has: {}.", in_words(based_on), known));
        }
        material = *base;
    }
    material.name = name;
    material.based_on = based_on;
    read_fields(object, material);
    read_isotherm(object, material.gab);
    read_diffusion(object, material.diffusion);
    read_cross_section(object, material.cross_section);
    if (based_on.empty()) {
        for (const Field<Material>& field : fields_of<Material>())
            if (!field.is_optional() && !field.is_written) required.emplace_back(field.key);
        required.emplace_back("fibre_diffusivity_m2_s");
    }
    if (object.find("sorption_heat_j_g") && object.find("heat_of_wetting_j_g"))
        object.refuse("sorption_heat_j_g", "This is another name of heat_of_wetting_j_g; give one of them.");
    object.read("sorption_heat_j_g", material.heat_of_wetting_j_g);
    object.finish(required);
    return material;
}

std::vector<YarnRun> read_order(ObjectReader& object, const char* key)
{
    std::vector<YarnRun> order;
    const ProjectJson* list = object.find(key);
    if (!list) return order;
    array_in(*list, object.file(), object.path_of(key));
    for (std::size_t i = 0; i < list->size(); ++i) {
        ObjectReader run((*list)[i], object.file(), fmt::format("{}[{}]", object.path_of(key), i));
        YarnRun read;
        run.read("yarn", read.yarn);
        run.read("count", read.count);
        run.finish({"yarn"});
        order.push_back(read);
    }
    return order;
}

std::optional<Calibrated> read_calibrated(ObjectReader& fabric)
{
    const ProjectJson* value = fabric.find("calibrated");
    if (!value) return {};
    ObjectReader object(*value, fabric.file(), fabric.path_of("calibrated"));
    Calibrated calibrated;
    object.read("file", calibrated.file);
    object.read("experiment", calibrated.experiment);
    object.read("fidelity", calibrated.fidelity);
    object.read("quantity", calibrated.quantity);
    object.read("residual_rms", calibrated.residual_rms);
    if (const ProjectJson* old = object.find("before")) {
        ObjectReader before(*old, object.file(), object.path_of("before"));
        before.read("contact_angle_deg", calibrated.before.contact_angle_deg);
        before.read("receding_angle_deg", calibrated.before.receding_angle_deg);
        before.read("packing_factor", calibrated.before.packing_factor);
        before.finish();
    }
    object.finish({"file", "experiment", "fidelity", "quantity", "residual_rms", "before"});
    return calibrated;
}

template <typename Part> void read_part(ObjectReader& whole, const char* key, Part& part)
{
    const ProjectJson* value = whole.find(key);
    if (!value) return;
    ObjectReader object(*value, whole.file(), whole.path_of(key));
    read_fields(object, part);
    object.finish();
}

Fabric read_fabric(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    Fabric fabric;
    object.read("name", fabric.name);
    if (const ProjectJson* warp = object.find("warp")) fabric.warp = yarn_from_json(*warp, file, object.path_of("warp"));
    if (const ProjectJson* weft = object.find("weft")) fabric.weft = yarn_from_json(*weft, file, object.path_of("weft"));
    if (const ProjectJson* weave = object.find("weave")) fabric.weave = weave_from_json(*weave, file, object.path_of("weave"));
    if (const ProjectJson* extra = object.find("extra_yarns")) {
        array_in(*extra, file, object.path_of("extra_yarns"));
        for (std::size_t i = 0; i < extra->size(); ++i)
            fabric.extra_yarns.push_back(yarn_from_json((*extra)[i], file, fmt::format("{}[{}]", object.path_of("extra_yarns"), i)));
    }
    fabric.warp_order = read_order(object, "warp_order");
    fabric.weft_order = read_order(object, "weft_order");
    read_fields(object, fabric);
    read_part(object, "flyaway", fabric.flyaway);
    read_fields(object, fabric.measured);
    read_part(object, "uncertainty", fabric.uncertainty);
    read_part(object, "loom", fabric.loom);
    fabric.calibrated = read_calibrated(object);
    object.finish({"name", "warp", "weft", "weave", "ends_per_cm", "picks_per_cm"});
    return fabric;
}

Droplet read_droplet(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    Droplet droplet;
    read_fields(object, droplet);
    object.read("at_mm", droplet.at_mm);
    object.finish({"volume_ul"});
    return droplet;
}

template <typename Kind> Kind kind_in(ObjectReader& object, const std::string& key, Kind value, int kinds)
{
    if (!object.find(key)) return value;
    std::vector<const char*> words;
    for (int i = 0; i < kinds; ++i) words.push_back(name_of(static_cast<Kind>(i)));
    return static_cast<Kind>(object.word(key, words));
}

void read_air(ObjectReader& air, Climate& climate)
{
    read_fields(air, climate);
    air.finish();
}

void read_climates(ObjectReader& object, Experiment& experiment)
{
    const ProjectJson* climate = object.find("climate");
    if (!climate) return;
    const std::string path = object.path_of("climate");
    if (!climate->is_array()) {
        ObjectReader air(*climate, object.file(), path);
        return read_air(air, experiment.climate);
    }
    if (climate->empty()) object.refuse("climate", "A changing climate needs at least the one at 0 s.");
    Climate before = experiment.climate;
    for (std::size_t i = 0; i < climate->size(); ++i) {
        ObjectReader air((*climate)[i], object.file(), fmt::format("{}[{}]", path, i));
        ClimateMoment moment{0, before}; // absent values stay as before
        if (i > 0) air.require("time_s");
        air.read("time_s", moment.time_s);
        read_air(air, moment.climate);
        before = moment.climate;
        if (i > 0)
            experiment.climates.push_back(moment);
        else if (moment.time_s == 0)
            experiment.climate = moment.climate;
        else
            air.refuse("time_s", fmt::format("A changing climate begins at 0 s; given is {}.", moment.time_s));
    }
}

void read_droplets(ObjectReader& object, const char* key, std::vector<Droplet>& droplets)
{
    const std::string path = object.path_of(key);
    const ProjectJson& list = array_in(object.require(key), object.file(), path);
    droplets.clear();
    for (std::size_t i = 0; i < list.size(); ++i) droplets.push_back(read_droplet(list[i], object.file(), fmt::format("{}[{}]", path, i)));
}

Experiment read_experiment(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    object.require("type");
    Experiment experiment = standard_experiment(kind_in(object, "type", ExperimentType::droplet, experiment_types));
    const ExperimentTypeInfo& type = info_of(experiment.type);
    std::vector<std::string> required{"name"};
    object.read("name", experiment.name);
    read_climates(object, experiment);
    object.read("liquid", experiment.liquid);
    experiment.closure = kind_in(object, "closure", experiment.closure, closures);
    object.read("swelling", experiment.swelling);
    object.read(type.sample_key, experiment.sample_mm);
    if (!type.has_usual_duration) required.emplace_back("duration_s");
    read_field(object, field_named<Experiment>("duration_s"), experiment);
    for (const Field<Experiment>& field : fields_of<Experiment>())
        if (uses_field(experiment.type, field.key)) read_field(object, field, experiment);
    if (uses_field(experiment.type, "initial")) read_part(object, "initial", experiment.initial);
    if (uses_field(experiment.type, "droplets")) read_droplets(object, "droplets", experiment.droplets);
    object.finish(required);
    return experiment;
}

Liquid read_liquid(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    Liquid liquid;
    object.read("name", liquid.name);
    read_fields(object, liquid);
    object.finish({"name"});
    return liquid;
}

int read_version(ObjectReader& object, int newest)
{
    const std::string format = text_in(object.require("format"), object.file(), "format");
    if (format != "hygroloom-project")
        object.refuse("format", fmt::format("This must be \"hygroloom-project\"; given is {}.", in_words(format)));
    int version = 0;
    object.require("version");
    object.read("version", version);
    if (version > newest)
        object.refuse("version",
                      fmt::format("The project was written by a newer Hygroloom (format {}); this one reads up to {}. Use the newer one.",
                                  version, newest));
    if (version < 1) object.refuse("version", fmt::format("Versions begin at 1; given is {}.", version));
    return version;
}

} // namespace

Design design_from_json(ProjectJson project, const std::string& file, const std::vector<Migration>& steps)
{
    {
        ObjectReader head(project, file, {});
        migrate_project(project, read_version(head, static_cast<int>(steps.size()) + 1), steps);
    }
    ObjectReader object(project, file, {});
    object.require("format");
    object.require("version");
    Design design;
    const auto each = [&](const char* key, auto read) {
        const ProjectJson* list = object.find(key);
        if (!list) return;
        array_in(*list, file, key);
        for (std::size_t i = 0; i < list->size(); ++i) read((*list)[i], file, fmt::format("{}[{}]", key, i));
    };
    each("materials", [&](const auto&... from) { design.materials.push_back(read_material(from...)); });
    each("liquids", [&](const auto&... from) { design.liquids.push_back(read_liquid(from...)); });
    each("fabrics", [&](const auto&... from) { design.fabrics.push_back(read_fabric(from...)); });
    each("experiments", [&](const auto& value, const auto&... from) {
        if (is_wear(value))
            design.wears.push_back(wear_from_json(value, from...));
        else
            design.experiments.push_back(read_experiment(value, from...));
    });
    each("garments", [&](const auto&... from) { design.garments.push_back(garment_from_json(from...)); });
    object.finish();
    return design;
}

} // namespace hygroloom
