// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A design as the project's JSON, and that as text.
#include "core/base/error.h"
#include "core/project/color_text.h"
#include "core/project/field_json.h"
#include "core/project/project_file.h"
#include "core/project/project_json.h"

#include <fmt/format.h>

#include <cmath>

namespace hygroloom {

namespace {

void write_if_given(ProjectJson& json, const char* key, const std::optional<double>& value)
{
    if (value) json[key] = *value;
}

ProjectJson write_material(const Material& material)
{
    const Material* base = material.based_on.empty() ? nullptr : find_library_material(material.based_on);
    ProjectJson json{{"name", material.name}};
    if (base) json["based_on"] = material.based_on;
    write_fields(json, material, base);
    if (base ? base->gab != material.gab : material.gab.given()) {
        if (material.gab.given())
            json["isotherm"] = json_of_fields(material.gab);
        else
            json["isotherm"] = "master";
    }
    if (material.diffusion.two_stage)
        json["fibre_diffusivity_m2_s"] = "two-stage";
    else if (!base || base->diffusion != material.diffusion)
        json["fibre_diffusivity_m2_s"] = material.diffusion.constant_m2_s;
    if (const CrossSection& section = material.cross_section; section != (base ? base->cross_section : CrossSection{})) {
        if (section.shape.empty())
            json["cross_section"] = section.perimeter_factor;
        else
            json["cross_section"] = section.shape;
    }
    return json;
}

ProjectJson write_yarn(const Yarn& yarn)
{
    ProjectJson json = ProjectJson::object();
    if (yarn.material.size() == 1 && yarn.material[0].share == 1.0) {
        json["material"] = yarn.material[0].name;
    } else {
        json["material"] = ProjectJson::array();
        for (const MaterialShare& part : yarn.material) json["material"].push_back({{"name", part.name}, {"share", part.share}});
    }
    if (yarn.core) {
        json["core"] = {{"material", yarn.core->material}};
        write_fields(json["core"], *yarn.core);
    }
    write_fields(json, yarn);
    if (yarn.color) json["color"] = text_of(*yarn.color);
    if (!yarn.library_yarn.empty()) json["library_yarn"] = yarn.library_yarn;
    return json;
}

ProjectJson write_weave(const Weave& weave)
{
    if (!weave.pattern().empty()) return {{"pattern", weave.pattern()}};
    if (weave.draft()) return {{"draft", json_from_draft(*weave.draft())}};
    ProjectJson rows = ProjectJson::array();
    for (int pick = weave.picks() - 1; pick >= 0; --pick) {
        std::string row;
        for (int end = 0; end < weave.ends(); ++end) row += weave.warp_up(end, pick) ? '1' : '0';
        rows.push_back(row);
    }
    return {{"rows", rows}};
}

ProjectJson write_order(const std::vector<YarnRun>& order)
{
    ProjectJson json = ProjectJson::array();
    for (const YarnRun& run : order) json.push_back({{"yarn", run.yarn}, {"count", run.count}});
    return json;
}

ProjectJson write_calibrated(const Calibrated& calibrated)
{
    ProjectJson before = ProjectJson::object();
    write_if_given(before, "contact_angle_deg", calibrated.before.contact_angle_deg);
    write_if_given(before, "receding_angle_deg", calibrated.before.receding_angle_deg);
    write_if_given(before, "packing_factor", calibrated.before.packing_factor);
    return {{"file", calibrated.file},         {"experiment", calibrated.experiment},     {"fidelity", calibrated.fidelity},
            {"quantity", calibrated.quantity}, {"residual_rms", calibrated.residual_rms}, {"before", before}};
}

ProjectJson write_fabric(const Fabric& fabric)
{
    ProjectJson json{{"name", fabric.name}};
    json["warp"] = write_yarn(fabric.warp);
    json["weft"] = write_yarn(fabric.weft);
    json["weave"] = write_weave(fabric.weave);
    write_fields(json, fabric);
    if (!fabric.extra_yarns.empty()) json["extra_yarns"] = ProjectJson::array();
    for (const Yarn& yarn : fabric.extra_yarns) json["extra_yarns"].push_back(write_yarn(yarn));
    if (!fabric.warp_order.empty()) json["warp_order"] = write_order(fabric.warp_order);
    if (!fabric.weft_order.empty()) json["weft_order"] = write_order(fabric.weft_order);
    json["flyaway"] = json_of_fields(fabric.flyaway);
    write_fields(json, fabric.measured);
    if (const ProjectJson uncertainty = json_of_fields(fabric.uncertainty); !uncertainty.empty()) json["uncertainty"] = uncertainty;
    if (const ProjectJson loom = json_of_fields(fabric.loom); !loom.empty()) json["loom"] = loom;
    if (fabric.calibrated) json["calibrated"] = write_calibrated(*fabric.calibrated);
    return json;
}

ProjectJson write_climates(const Experiment& experiment)
{
    if (experiment.climates.empty()) return json_of_fields(experiment.climate);
    ProjectJson course = ProjectJson::array();
    const auto add = [&](double time, const Climate& climate) {
        ProjectJson moment{{"time_s", time}};
        moment.update(json_of_fields(climate));
        course.push_back(moment);
    };
    add(0, experiment.climate);
    for (const ClimateMoment& moment : experiment.climates) add(moment.time_s, moment.climate);
    return course;
}

ProjectJson write_droplets(const std::vector<Droplet>& droplets)
{
    ProjectJson json = ProjectJson::array();
    for (const Droplet& drop : droplets) {
        json.push_back(json_of_fields(drop));
        json.back()["at_mm"] = ProjectJson::array({drop.at_mm[0], drop.at_mm[1]});
    }
    return json;
}

ProjectJson write_experiment(const Experiment& experiment)
{
    const ExperimentTypeInfo& type = info_of(experiment.type);
    ProjectJson json{{"name", experiment.name}, {"type", type.key}};
    json["climate"] = write_climates(experiment);
    json["liquid"] = experiment.liquid;
    if (experiment.closure != Closure::pores) json["closure"] = name_of(experiment.closure);
    if (experiment.swelling) json["swelling"] = true;
    json[type.sample_key] = ProjectJson::array({experiment.sample_mm[0], experiment.sample_mm[1]});
    json["duration_s"] = experiment.duration_s;
    for (const Field<Experiment>& field : fields_of<Experiment>())
        if (uses_field(experiment.type, field.key)) json[field.key] = json_of_field(field, experiment);
    if (uses_field(experiment.type, "initial")) json["initial"] = json_of_fields(experiment.initial);
    if (uses_field(experiment.type, "droplets")) json["droplets"] = write_droplets(experiment.droplets);
    return json;
}

ProjectJson write_liquid(const Liquid& liquid)
{
    ProjectJson json{{"name", liquid.name}};
    write_fields(json, liquid);
    return json;
}

void print(std::string& text, const ProjectJson& value, const std::string& indent, const std::string& path)
{
    if (value.is_number_float() && !std::isfinite(value.get<double>()))
        throw Error(fmt::format("{}: The value is {}, which no project can hold; give a number.", path, value.get<double>()));
    // One line each: rows draw the weave.
    const bool rows = path.ends_with(".rows") || path.ends_with(".private_lines");
    const bool plain =
        value.is_array() && !rows && std::none_of(value.begin(), value.end(), [](const auto& item) { return item.is_structured(); });
    if (!value.is_structured() || value.empty()) {
        text += value.dump();
        return;
    }
    const std::string inner = plain ? "" : "\n" + indent + "  ";
    const char* separator = plain ? ", " : ",";
    text += value.is_object() ? '{' : '[';
    bool first = true;
    std::size_t index = 0;
    for (const auto& [key, member] : value.items()) {
        if (!first) text += separator;
        first = false;
        text += inner;
        if (value.is_object()) text += ProjectJson(key).dump() + ": ";
        print(text, member, indent + "  ",
              value.is_object() ? (path.empty() ? key : path + "." + key) : fmt::format("{}[{}]", path, index++));
    }
    if (!plain) text += "\n" + indent;
    text += value.is_object() ? '}' : ']';
}

} // namespace

ProjectJson json_from_design(const Design& design)
{
    ProjectJson json{{"format", "hygroloom-project"}, {"version", project_version}};
    json["materials"] = ProjectJson::array();
    for (const Material& material : design.materials) json["materials"].push_back(write_material(material));
    if (!design.liquids.empty()) json["liquids"] = ProjectJson::array();
    for (const Liquid& liquid : design.liquids) json["liquids"].push_back(write_liquid(liquid));
    json["fabrics"] = ProjectJson::array();
    for (const Fabric& fabric : design.fabrics) json["fabrics"].push_back(write_fabric(fabric));
    json["experiments"] = ProjectJson::array();
    for (const Experiment& experiment : design.experiments) json["experiments"].push_back(write_experiment(experiment));
    for (const WearExperiment& wear : design.wears) json["experiments"].push_back(json_from_wear(wear));
    if (!design.garments.empty()) json["garments"] = ProjectJson::array();
    for (const Garment& garment : design.garments) json["garments"].push_back(json_from_garment(garment));
    return json;
}

std::string text_from_json(const ProjectJson& project)
{
    std::string text;
    try {
        print(text, project, {}, {});
    } catch (const ProjectJson::exception&) {
        throw Error("A name in the project is not valid UTF-8 text; change it.");
    }
    return text + "\n";
}

} // namespace hygroloom
