// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// In the embedded file "x-fields" names the rows that an object has, and "x-defaults" that what it leaves out is as the rows say. What the
// file itself says of a field comes on top of its row.
#include "core/project/project_schema.h"

#include "core/project/field_json.h"

#include <map>

namespace hygroloom {

extern const char project_schema_json[];

namespace {

template <typename Owner> ProjectJson schema_of(const Field<Owner>& field, bool with_default)
{
    ProjectJson json;
    if (const auto* choice = std::get_if<FieldChoice<Owner>>(&field.value)) {
        json["enum"] = ProjectJson::array();
        for (const char* word : choice->words) json["enum"].push_back(word);
    } else {
        json["type"] = field.is_whole() ? "integer" : "number";
        json["minimum"] = field.least;
        json["maximum"] = field.most;
        if (field.is_whole()) {
            json["minimum"] = static_cast<long>(field.least);
            json["maximum"] = static_cast<long>(field.most);
        }
    }
    json["title"] = field.label;
    if (*field.help) json["description"] = field.help;
    if (with_default && !field.is_optional()) json["default"] = json_of_field(field, Owner());
    return json;
}

template <typename Owner> void fill(ProjectJson& properties, bool with_defaults)
{
    for (const Field<Owner>& field : fields_of<Owner>()) {
        ProjectJson json = schema_of(field, with_defaults);
        if (properties.contains(field.key)) json.merge_patch(properties[field.key]);
        properties[field.key] = std::move(json);
    }
}

using Fill = void (*)(ProjectJson&, bool);
const std::map<std::string, Fill> rows{{"material", fill<Material>},
                                       {"isotherm", fill<GabIsotherm>},
                                       {"yarn", fill<Yarn>},
                                       {"core", fill<YarnCore>},
                                       {"fabric", fill<Fabric>},
                                       {"flyaway", fill<Flyaway>},
                                       {"measured", fill<Measured>},
                                       {"uncertainty", fill<Uncertainty>},
                                       {"loom", fill<Loom>},
                                       {"liquid", fill<Liquid>},
                                       {"climate", fill<Climate>},
                                       {"droplet", fill<Droplet>},
                                       {"experiment", fill<Experiment>},
                                       {"wear", fill<WearExperiment>},
                                       {"activity", fill<Activity>},
                                       {"built_in", fill<BuiltInGarment>},
                                       {"cut", fill<PanelCut>},
                                       {"own_zone", fill<OwnZone>},
                                       {"wearer", fill<Wearer>}};

void fill_in(ProjectJson& part)
{
    if (!part.is_structured()) return;
    if (part.contains("x-fields")) {
        for (const ProjectJson& name : part["x-fields"]) rows.at(name)(part["properties"], part.contains("x-defaults"));
        part.erase("x-fields");
        part.erase("x-defaults");
    }
    for (ProjectJson& each : part) fill_in(each);
}

} // namespace

ProjectJson project_schema()
{
    ProjectJson schema = ProjectJson::parse(project_schema_json);
    fill_in(schema);
    return schema;
}

} // namespace hygroloom
