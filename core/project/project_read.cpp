// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The design in a project's JSON. Form only: whether values make sense is for validate().
#include "core/base/words.h"
#include "core/project/json_reader.h"
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
    isotherm.read("monolayer_regain", gab.monolayer_regain);
    isotherm.read("c", gab.c);
    isotherm.read("k", gab.k);
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
            std::string all;
            for (const Material& known : material_library()) all += (all.empty() ? "" : ", ") + known.name;
            object.refuse("based_on", fmt::format("The library has no material {}. It has: {}.", in_words(based_on), all));
        }
        material = *base;
    }
    material.name = name;
    material.based_on = based_on;
    const auto number = [&](const char* key, double& field) {
        if (based_on.empty()) required.emplace_back(key);
        object.read(key, field);
    };
    number("density_kg_m3", material.density_kg_m3);
    number("fibre_radius_um", material.fibre_radius_um);
    number("standard_regain", material.standard_regain);
    number("saturation_regain", material.saturation_regain);
    read_isotherm(object, material.gab);
    if (based_on.empty()) required.emplace_back("fibre_diffusivity_m2_s");
    read_diffusion(object, material.diffusion);
    number("contact_angle_deg", material.contact_angle_deg);
    object.read("receding_angle_deg", material.receding_angle_deg);
    read_cross_section(object, material.cross_section);
    number("thermal_conductivity_w_mk", material.thermal_conductivity_w_mk);
    number("specific_heat_j_kgk", material.specific_heat_j_kgk);
    object.read("heat_of_wetting_j_g", material.heat_of_wetting_j_g);
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

Fabric read_fabric(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    Fabric fabric;
    object.read("name", fabric.name);
    if (const ProjectJson* warp = object.find("warp")) fabric.warp = yarn_from_json(*warp, file, object.path_of("warp"));
    if (const ProjectJson* weft = object.find("weft")) fabric.weft = yarn_from_json(*weft, file, object.path_of("weft"));
    if (const ProjectJson* weave = object.find("weave")) fabric.weave = weave_from_json(*weave, file, object.path_of("weave"));
    object.read("ends_per_cm", fabric.ends_per_cm);
    object.read("picks_per_cm", fabric.picks_per_cm);
    if (const ProjectJson* extra = object.find("extra_yarns")) {
        array_in(*extra, file, object.path_of("extra_yarns"));
        for (std::size_t i = 0; i < extra->size(); ++i)
            fabric.extra_yarns.push_back(yarn_from_json((*extra)[i], file, fmt::format("{}[{}]", object.path_of("extra_yarns"), i)));
    }
    fabric.warp_order = read_order(object, "warp_order");
    fabric.weft_order = read_order(object, "weft_order");
    object.read("thickness_mm", fabric.thickness_mm);
    object.read("warp_crimp_percent", fabric.warp_crimp_percent);
    object.read("weft_crimp_percent", fabric.weft_crimp_percent);
    if (const ProjectJson* flyaway = object.find("flyaway")) {
        ObjectReader fibres(*flyaway, file, object.path_of("flyaway"));
        fibres.read("loop_density_per_mm", fabric.flyaway.loop_density_per_mm);
        fibres.read("hair_density_per_mm", fabric.flyaway.hair_density_per_mm);
        fibres.read("loop_height_mm", fabric.flyaway.loop_height_mm);
        fibres.read("hair_length_mm", fabric.flyaway.hair_length_mm);
        fibres.finish();
    }
    object.read("contact_angle_deg", fabric.contact_angle_deg);
    object.read("finish_face", fabric.finish_face);
    object.read("finish_back", fabric.finish_back);
    object.read("finish_depth", fabric.finish_depth);
    object.read("finish_holes", fabric.finish_holes);
    object.read("porosity", fabric.measured.porosity);
    object.read("areal_density_g_m2", fabric.measured.areal_density_g_m2);
    object.read("capillary_radius_um", fabric.measured.capillary_radius_um);
    object.read("tortuosity", fabric.measured.tortuosity);
    object.read("crimp_percent", fabric.measured.crimp_percent);
    if (const ProjectJson* uncertainty = object.find("uncertainty")) {
        ObjectReader either_way(*uncertainty, file, object.path_of("uncertainty"));
        either_way.read("contact_angle_deg", fabric.uncertainty.contact_angle_deg);
        either_way.read("receding_angle_deg", fabric.uncertainty.receding_angle_deg);
        either_way.read("packing_factor", fabric.uncertainty.packing_factor);
        either_way.finish();
    }
    fabric.calibrated = read_calibrated(object);
    object.finish({"name", "warp", "weft", "weave", "ends_per_cm", "picks_per_cm"});
    return fabric;
}

Droplet read_droplet(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    Droplet droplet;
    object.read("volume_ul", droplet.volume_ul);
    object.read("time_s", droplet.time_s);
    object.read("at_mm", droplet.at_mm);
    object.read("height_mm", droplet.height_mm);
    object.read("speed_m_s", droplet.speed_m_s);
    object.finish({"volume_ul"});
    return droplet;
}

template <typename Kind> Kind kind_in(ObjectReader& object, const std::string& key, Kind value, int kinds)
{
    const ProjectJson* member = object.find(key);
    if (!member) return value;
    const std::string given = text_in(*member, object.file(), object.path_of(key));
    std::vector<std::string> known;
    for (int i = 0; i < kinds; ++i) {
        known.push_back(name_of(static_cast<Kind>(i)));
        if (known.back() == given) return static_cast<Kind>(i);
    }
    const std::string near = nearest_word(given, known);
    std::string all;
    for (const std::string& word : known) all += (all.empty() ? "" : ", ") + word;
    object.refuse(key, near.empty() ? fmt::format("This must be one of {}; given is {}.", all, in_words(given))
                                    : fmt::format("This must be one of {}; given is {}; did you mean \"{}\"?", all, in_words(given), near));
}

bool choice_in(ObjectReader& object, const std::string& key, const char* yes, const char* no, bool value)
{
    std::string given = value ? yes : no;
    object.read(key, given);
    if (given != yes && given != no)
        object.refuse(key, fmt::format("This must be \"{}\" or \"{}\"; given is {}.", yes, no, in_words(given)));
    return given == yes;
}

void read_air(ObjectReader& air, Climate& climate)
{
    air.read("temperature_c", climate.temperature_c);
    air.read("relative_humidity", climate.relative_humidity);
    air.read("air_speed_m_s", climate.air_speed_m_s);
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

/// Reads a field that only some types use.
struct FieldReader {
    ObjectReader& object;
    Experiment& experiment;
    const char* key;
    void operator()(ExperimentField::Number number) const { object.read(key, experiment.*number); }
    void operator()(const ExperimentChoice& choice) const
    {
        experiment.*choice.value = choice_in(object, key, choice.yes, choice.no, experiment.*choice.value);
    }
    void operator()(ExperimentField::Air climate) const
    {
        const ProjectJson* value = object.find(key);
        if (!value) return;
        ObjectReader air(*value, object.file(), object.path_of(key));
        read_air(air, experiment.*climate);
    }
    void operator()(ExperimentField::Drops drops) const { read_droplets(object, key, experiment.*drops); }
};

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
    object.read("duration_s", experiment.duration_s);
    for (const ExperimentField& field : type.fields) std::visit(FieldReader{object, experiment, field.key}, field.value);
    object.finish(required);
    return experiment;
}

Liquid read_liquid(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    Liquid liquid;
    object.read("name", liquid.name);
    object.read("surface_tension_mn_m", liquid.surface_tension_mn_m);
    object.read("viscosity_mpa_s", liquid.viscosity_mpa_s);
    object.read("density_kg_m3", liquid.density_kg_m3);
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
