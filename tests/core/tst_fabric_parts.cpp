// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Every key of a fabric in the project's schema belongs to one part, and a change of it is found there and nowhere else.
#include "core/base/error.h"
#include "core/design/fabric_parts.h"
#include "core/project/project_json.h"
#include "core/project/project_schema.h"

#include <QTest>

#include <algorithm>
#include <map>
#include <set>

using namespace hygroloom;

namespace tst_fabric_parts {
namespace {

const char* const cloth = R"({
  "format": "hygroloom-project", "version": 1,
  "materials": [
    { "name": "fibre", "density_kg_m3": 1400, "fibre_radius_um": 7, "standard_regain": 0.075, "saturation_regain": 0.25,
      "fibre_diffusivity_m2_s": 1e-13, "contact_angle_deg": 40, "receding_angle_deg": 15, "cross_section": "bean",
      "thermal_conductivity_w_mk": 0.3, "specific_heat_j_kgk": 1300, "heat_of_wetting_j_g": 40 } ],
  "fabrics": [
    { "name": "cloth", "ends_per_cm": 10, "picks_per_cm": 12, "weave": { "pattern": "plain" },
      "warp": { "material": "fibre", "diameter_mm": 0.5 }, "weft": { "material": "fibre", "diameter_mm": 0.45 } } ],
  "experiments": []
})";

/// Another value for each key of a fabric, and its place where that is not the key.
struct Change {
    const char* value;
    const char* at = "";
};
const char* const drawn = R"({ "draft": { "shafts": 3, "threading": [1, 2, 3], "liftplan": [[1], [2], [3]] } })";
const char* const yarns = R"([{ "material": "cotton", "diameter_mm": 0.3 }])";
const char* const order = R"([{ "yarn": 0, "count": 2 }])";
const char* const fitted =
    R"({ "file": "a.csv", "experiment": "e", "fidelity": "draft", "quantity": "metrics", "residual_rms": 1, "before": {} })";
const std::map<std::string, Change> changes{
    {"name", {R"("other")"}},
    {"yarn.material", {R"("cotton")"}},
    {"yarn.material.name", {R"("cotton")", "material"}},
    {"yarn.material.share", {R"([{ "name": "fibre", "share": 0.5 }, { "name": "cotton", "share": 0.5 }])", "material"}},
    {"yarn.core.material", {R"({ "material": "elastane", "share": 0.05 })", "core"}},
    {"yarn.core.share", {R"({ "material": "elastane", "share": 0.05 })", "core"}},
    {"yarn.diameter_mm", {"0.4"}},
    {"yarn.linear_density_tex", {"30"}},
    {"yarn.packing_factor", {"0.6"}},
    {"yarn.yarn_class", {R"("rotor")"}},
    {"yarn.filament_count", {"90"}},
    {"yarn.fibres_per_yarn", {"40"}},
    {"yarn.twist_per_m", {"800"}},
    {"yarn.twist_direction", {R"("S")"}},
    {"yarn.plies", {"2"}},
    {"yarn.ply_twist_per_m", {"500"}},
    {"yarn.ply_twist_direction", {R"("Z")"}},
    {"yarn.irregularity_cv", {"0.1"}},
    {"yarn.color", {R"("#102030")"}},
    {"yarn.price", {"6.5"}},
    {"yarn.library_yarn", {R"("fine")"}},
    {"weave.pattern", {R"("twill 2/2 Z")"}},
    {"weave.rows", {R"({ "rows": ["110", "011", "101"] })", "weave"}},
    {"ends_per_cm", {"11"}},
    {"picks_per_cm", {"13"}},
    {"warp_order.yarn", {order, "warp_order"}},
    {"warp_order.count", {order, "warp_order"}},
    {"weft_order.yarn", {order, "weft_order"}},
    {"weft_order.count", {order, "weft_order"}},
    {"thickness_mm", {"0.9"}},
    {"warp_crimp_percent", {"4"}},
    {"weft_crimp_percent", {"4"}},
    {"flyaway.loop_density_per_mm", {"4"}},
    {"flyaway.hair_density_per_mm", {"4"}},
    {"flyaway.loop_height_mm", {"0.4"}},
    {"flyaway.hair_length_mm", {"0.4"}},
    {"contact_angle_deg", {"50"}},
    {"finish_face", {"50"}},
    {"finish_back", {"50"}},
    {"finish_depth", {"0.2"}},
    {"finish_holes", {"0.05"}},
    {"porosity", {"0.7"}},
    {"areal_density_g_m2", {"200"}},
    {"tortuosity", {"1.5"}},
    {"crimp_percent", {"6"}},
    {"uncertainty.contact_angle_deg", {"4"}},
    {"uncertainty.receding_angle_deg", {"4"}},
    {"uncertainty.packing_factor", {"0.02"}},
    {"loom.ends_per_cm", {"9"}},
    {"loom.picks_per_cm", {"11"}},
    {"loom.reed_width_cm", {"160"}},
    {"loom.ends_per_dent", {"2"}},
};

/// The change of a key: of a yarn's those of "yarn", of a draft's and of a further yarn's the whole.
Change change_of(const std::string& key)
{
    if (key.starts_with("weave.draft.")) return {drawn, "weave"};
    if (key.starts_with("extra_yarns.")) return {yarns, "extra_yarns"};
    if (key.starts_with("calibrated.")) return {fitted, "calibrated"};
    const bool of_yarn = key.starts_with("warp.") || key.starts_with("weft.");
    const auto found = changes.find(of_yarn ? "yarn" + key.substr(4) : key);
    if (found == changes.end()) throw Error("The test has no other value for " + key + ".");
    return found->second;
}

const ProjectJson& schema()
{
    static const ProjectJson filled = project_schema();
    return filled;
}

/// The keys that hold no others, by their path in a fabric; those of a list's members are the list's.
void find_leaves(const ProjectJson& part, const std::string& path, std::set<std::string>& leaves)
{
    bool holds_others = false;
    if (part.contains("$ref")) {
        const auto name = part.at("$ref").get<std::string>();
        find_leaves(schema().at(ProjectJson::json_pointer(name.substr(1))), path, leaves);
        return;
    }
    if (part.contains("properties"))
        for (const auto& [key, value] : part.at("properties").items()) {
            find_leaves(value, path.empty() ? key : path + "." + key, leaves);
            holds_others = true;
        }
    if (part.contains("items") && (part.at("items").contains("properties") || part.at("items").contains("$ref"))) {
        find_leaves(part.at("items"), path, leaves);
        holds_others = true;
    }
    if (part.contains("oneOf") && !part.contains("properties")) {
        for (const ProjectJson& one : part.at("oneOf")) find_leaves(one, path, leaves);
        holds_others = true;
    }
    if (!holds_others) leaves.insert(path);
}

std::set<std::string> keys_of_fabric()
{
    std::set<std::string> leaves;
    find_leaves(schema().at("$defs").at("fabric"), "", leaves);
    return leaves;
}

bool holds(const PartField& field, const std::string& key) { return key == field.key || key.starts_with(field.key + "."); }

std::string pointer_of(const std::string& key)
{
    std::string pointer = key;
    std::replace(pointer.begin(), pointer.end(), '.', '/');
    return pointer;
}

/// The fabric with another value at a key.
Fabric changed(const std::string& key)
{
    const Change change = change_of(key);
    std::string path = pointer_of(key);
    if (*change.at) {
        const bool of_yarn = key.starts_with("warp.") || key.starts_with("weft.");
        path = (of_yarn ? key.substr(0, 5) : std::string()) + change.at;
        std::replace(path.begin(), path.end(), '.', '/');
    }
    ProjectJson project = ProjectJson::parse(cloth);
    project[ProjectJson::json_pointer("/fabrics/0/" + path)] = ProjectJson::parse(change.value);
    return design_from_json(project, "parts").fabrics.front();
}

/// A yarn's count is another way to write its linear density, plies and filaments.
std::set<std::string> keys_without_counts()
{
    std::set<std::string> keys = keys_of_fabric();
    std::erase_if(keys, [](const std::string& key) { return key.ends_with(".count"); });
    return keys;
}

} // namespace

class TestFabricParts : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void eachKeyOfTheSchemaBelongsToOnePart()
    {
        const std::set<std::string> keys = keys_without_counts();
        QVERIFY2(keys.size() > 60 && keys.contains("warp.twist_per_m") && keys.contains("weave.draft.tie_up"),
                 "the walk over the schema finds too few keys");
        for (const std::string& key : keys) {
            int parts = 0;
            for (const FabricPart& part : fabric_parts())
                for (const PartField& field : part.fields) parts += holds(field, key) ? 1 : 0;
            QVERIFY2(parts == 1, (key + " belongs to " + std::to_string(parts) + " parts").c_str());
        }
        for (const FabricPart& part : fabric_parts())
            for (const PartField& field : part.fields)
                QVERIFY2(std::any_of(keys.begin(), keys.end(), [&](const std::string& key) { return holds(field, key); }),
                         (field.key + " is no key of the schema").c_str());
    }

    void aChangeOfAKeyIsADifferenceOfItsPartAlone_data()
    {
        QTest::addColumn<QString>("key");
        for (const std::string& key : keys_without_counts()) QTest::newRow(key.c_str()) << QString::fromStdString(key);
    }
    void aChangeOfAKeyIsADifferenceOfItsPartAlone()
    {
        QFETCH(QString, key);
        const Design design = design_from_json(ProjectJson::parse(cloth), "parts");
        const Fabric &one = design.fabrics.front(), other = changed(key.toStdString());
        QVERIFY(one != other);
        const FabricPart* own = nullptr;
        for (const FabricPart& part : fabric_parts())
            for (const PartField& field : part.fields)
                if (holds(field, key.toStdString())) own = &part;
        QVERIFY(own);
        const auto found = part_differences(design, one, other, true);
        QCOMPARE(found.size(), own->acts == PartActs::never ? std::size_t{0} : std::size_t{1});
        if (found.empty()) return;
        QCOMPARE(found[0].title, own->title);
        QVERIFY(found[0].first != found[0].second || found[0].title == "weave");
        Fabric copy = one;
        for (const PartField* field : found[0].fields) field->copy(copy, other);
        QVERIFY(copy == other);
        QCOMPARE(part_differences(design, one, other, false).empty(), own->acts == PartActs::in_replicates);
    }

    void theColourAloneOfAFurtherYarnIsNoDifference()
    {
        const Design design = design_from_json(ProjectJson::parse(cloth), "parts");
        Fabric one = design.fabrics.front(), other = one;
        one.extra_yarns = other.extra_yarns = {one.warp};
        other.extra_yarns[0].color = Color{16, 32, 48};
        QVERIFY(one != other);
        QVERIFY(part_differences(design, one, other, true).empty());
        other.extra_yarns[0].twist_per_m += 100;
        const auto found = part_differences(design, one, other, true);
        QVERIFY(found.size() == 1 && found[0].title == "stripes" && found[0].first != found[0].second);
    }

    void fibresOfOtherAnglesAloneCountToTheContactAngle()
    {
        const std::map<std::string, const char*> values{{"density_kg_m3", "1500"},
                                                        {"fibre_radius_um", "8"},
                                                        {"standard_regain", "0.08"},
                                                        {"saturation_regain", "0.2"},
                                                        {"isotherm", R"({ "monolayer_regain": 0.05, "c": 10, "k": 0.75 })"},
                                                        {"fibre_diffusivity_m2_s", "2e-13"},
                                                        {"contact_angle_deg", "50"},
                                                        {"receding_angle_deg", "10"},
                                                        {"cross_section", R"("round")"},
                                                        {"thermal_conductivity_w_mk", "0.2"},
                                                        {"specific_heat_j_kgk", "1200"},
                                                        {"heat_of_wetting_j_g", "50"}};
        for (const auto& [key, schema_of_key] : schema().at("$defs").at("material").at("properties").items()) {
            if (key == "name" || key == "based_on" || key == "sorption_heat_j_g") continue; // the last is an older name of another
            const auto value = values.find(key);
            QVERIFY2(value != values.end(), key.c_str());
            ProjectJson project = ProjectJson::parse(cloth);
            project["materials"].push_back(project["materials"][0]);
            project["materials"][1]["name"] = "fibre 2";
            project["materials"][1][key] = ProjectJson::parse(value->second);
            const Design design = design_from_json(project, "parts");
            Fabric other = design.fabrics[0];
            other.warp.material[0].name = other.weft.material[0].name = "fibre 2";
            std::string titles;
            for (const PartDifference& each : part_differences(design, design.fabrics[0], other, false)) titles += each.title + ";";
            const bool angle = key == "contact_angle_deg" || key == "receding_angle_deg";
            QCOMPARE(titles, std::string(angle ? "contact angle;" : "warp fibre;weft fibre;"));
        }
    }

    void weavesOfOneMatrixAreOneWeave()
    {
        const Design design = design_from_json(ProjectJson::parse(cloth), "parts");
        Fabric other = design.fabrics[0];
        other.weave = other.weave.toggled(0, 0).toggled(0, 0);
        QVERIFY(!(other.weave == design.fabrics[0].weave));
        QVERIFY(part_differences(design, design.fabrics[0], other, true).empty());
    }
};

} // namespace tst_fabric_parts

QTEST_GUILESS_MAIN(tst_fabric_parts::TestFabricParts)
#include "tst_fabric_parts.moc"
