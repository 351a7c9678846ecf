// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Every key of a garment and of its experiment in the project's schema moves what comes out of wearing it, or is named here as one that
// cannot.
#include "core/base/error.h"
#include "core/project/project_file.h"
#include "core/project/project_json.h"
#include "core/project/project_schema.h"
#include "core/wear/wear_outcomes.h"
#include "tests/wear/flat_garment.h"

#include <QTest>

#include <set>

using namespace hygroloom;

namespace tst_wear_keys {
namespace {

/// A key of the schema, its place in the project below, and another value.
struct Change {
    const char* key;
    const char* at;
    const char* value;
};
const Change changes[] = {
    {"garment.source.built_in", "/garments/0/source", R"({"built_in": "singlet"})"},
    {"garment.source.chest_mm", "/garments/0/source/chest_mm", "1200"},
    {"garment.source.length_mm", "/garments/0/source/length_mm", "800"},
    {"garment.source.ease_mm", "/garments/0/source/ease_mm", "200"},
    {"garment.source.sleeve_mm", "/garments/0/source/sleeve_mm", "400"},
    {"garment.panels.fabric", "/garments/0/panels/*/fabric", "\"Poplin shirting\""},
    {"garment.panels.grain_deg", "/garments/0/panels/*/grain_deg", "30"},
    {"garment.panels.face", "/garments/0/panels/*/face", "\"top_inside\""},
    {"garment.panels.layers", "/garments/0/panels/*/layers", "2"},
    {"garment.seams", "/garments/0/seams", R"({"front|back": 0})"},
    {"garment.seams.default", "/garments/0/seams/default", "0"},
    {"garment.wearer.skin_temperature_c", "/garments/0/wearer/skin_temperature_c", "30"},
    {"garment.wearer.gap_mm", "/garments/0/wearer/gap_mm", R"({"default": 3, "chest": 10})"},
    {"garment.wearer.gap_mm.default", "/garments/0/wearer/gap_mm/default", "10"},
    {"garment.wearer.zones", "/garments/0/wearer/zones", "\"taylor-2013 rest\""},
    {"garment.wearer.own_zones.panel", "/garments/0/wearer/own_zones/0/panel", "\"back\""},
    {"garment.wearer.own_zones.outline_mm", "/garments/0/wearer/own_zones/0/outline_mm",
     "[[-100, 100], [100, 100], [100, 200], [-100, 200]]"},
    {"garment.wearer.own_zones.sweat_g_m2_h", "/garments/0/wearer/own_zones/0/sweat_g_m2_h", "50"},
    {"wear.garment", "/experiments/0/garment", "\"other\""},
    {"wear.climate", "/experiments/0/climate/temperature_c", "30"},
    {"wear.liquid", "/experiments/0/liquid", "\"saline\""},
    {"wear.duration_s", "/experiments/0/duration_s", "200"},
    {"wear.activity.time_s", "/experiments/0/activity/1/time_s", "30"},
    {"wear.activity.factor", "/experiments/0/activity/0/factor", "2"},
    {"wear.initial_water_g_m2", "/experiments/0/initial_water_g_m2", "40"},
};
const std::map<std::string, const char*> without_effect{
    {"garment.name", "a name"},
    {"garment.source", "holds others"},
    {"garment.uv_unit", "of meshes alone; tst_garment_mesh"},
    {"garment.panels", "holds others"},
    {"garment.panels.lining", "of layers alone; tst_layers"},
    {"garment.wearer", "holds others"},
    {"garment.wearer.own_zones", "holds others"},
    {"garment.wearer.own_zones.name", "a name"},
    {"wear.name", "a name"},
    {"wear.type", "says what it is"},
    {"wear.activity", "holds others"},
};

void find_keys(const ProjectJson& part, const std::string& object, std::set<std::string>& keys)
{
    if (part.contains("properties"))
        for (const auto& [key, value] : part.at("properties").items()) {
            keys.insert(object + "." + key);
            find_keys(value, object + "." + key, keys);
        }
    for (const char* below : {"items", "additionalProperties"})
        if (part.contains(below) && part.at(below).is_object()) find_keys(part.at(below), object, keys);
    if (part.contains("oneOf"))
        for (const ProjectJson& one : part.at("oneOf")) find_keys(one, object, keys);
}

/// A tee of a twill whose faces differ, and a singlet.
ProjectJson project()
{
    Design design = library_design("Denim");
    for (const Preset& preset : shipped_presets())
        if (preset.fabric().name == "Poplin shirting") add_preset(design, preset);
    Garment tee;
    tee.name = "tee";
    tee.panels["*"] = {"Denim"};
    tee.seams["default"] = 1;
    design.garments = {tee, tee};
    design.garments[0].wearer.own_zones = {{"belt", "front", {{-200, 100}, {200, 100}, {200, 400}, {-200, 400}}, 2000}};
    design.garments[1].name = "other";
    design.garments[1].built_in = standard_garment("singlet");
    WearExperiment wear;
    wear.name = "wear";
    wear.garment = "tee";
    wear.duration_s = 100;
    wear.activity = {{0, 8}, {60, 1}};
    design.wears = {wear};
    return json_from_design(design);
}

std::string outcome(const ProjectJson& json)
{
    const Design design = design_from_json(json, "a test");
    for (const Issue& issue : validate(design))
        if (issue.severity == Severity::error) throw Error(issue.where.text() + ": " + issue.text());
    GarmentParts parts;
    parts.design = &design;
    parts.wear = &design.wears.front();
    parts.garment = find_garment(design, parts.wear->garment);
    parts.pattern = read_pattern(*parts.garment, {});
    add_layers(parts.pattern, *parts.garment);
    parts.sweat = sweat_table(parts.garment->wearer.zones, {});
    const GarmentScene garment = garment_scene(parts, {knobs_of(Fidelity::draft), 40e-3});
    const WearLayout layout = wear_layout(parts, garment);
    WearMetrics metrics(layout);
    const std::unique_ptr<Backend> cpu = make_cpu_backend();
    RunControl control;
    run_wear(garment, *parts.wear, *cpu, control, {[&](const std::shared_ptr<const WearFrame>& frame) { metrics.add(*frame); }, {}});
    return wear_json(metrics);
}

} // namespace

class TestWearKeys : public QObject {
    Q_OBJECT
    std::string usual_;

private Q_SLOTS:
    void everyKeyIsListed()
    {
        const ProjectJson schema = project_schema();
        std::set<std::string> keys, listed;
        for (const char* object : {"garment", "wear"}) find_keys(schema.at("$defs").at(object), object, keys);
        QVERIFY(keys.size() > 20);
        for (const auto& [key, why] : without_effect) listed.insert(key);
        for (const Change& change : changes) QVERIFY2(listed.insert(change.key).second, change.key);
        for (const std::string& key : keys) QVERIFY2(listed.erase(key) == 1, (key + " is not listed in this test").c_str());
        QVERIFY2(listed.empty(), listed.empty() ? "" : (*listed.begin() + " is not in the schema").c_str());
    }
    void eachKeyActs_data()
    {
        QTest::addColumn<int>("number");
        for (int i = 0; i < static_cast<int>(std::size(changes)); ++i) QTest::newRow(changes[i].key) << i;
    }
    void eachKeyActs()
    {
        QFETCH(int, number);
        const Change& change = changes[number];
        if (usual_.empty()) {
            usual_ = outcome(project());
            QVERIFY(outcome(project()) == usual_); // or all would seem to act
        }
        ProjectJson other = project();
        other[ProjectJson::json_pointer(change.at)] = ProjectJson::parse(change.value);
        QVERIFY(outcome(other) != usual_);
    }
};

} // namespace tst_wear_keys

QTEST_GUILESS_MAIN(tst_wear_keys::TestWearKeys)
#include "tst_wear_keys.moc"
