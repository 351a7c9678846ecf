// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Every key of the project's schema either changes the water, or is named as one that does not: for good here, or in an experiment by
// idle_keys().
#include "core/base/error.h"
#include "core/design/validate.h"
#include "core/plan/frame_times.h"
#include "core/plan/idle_keys.h"
#include "core/plan/planning.h"
#include "core/project/project_json.h"
#include "core/project/project_schema.h"
#include "core/verify/set_ups.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace hygroloom;

namespace tst_keys {
namespace {

const char* const cloth = R"({
  "format": "hygroloom-project", "version": 1,
  "materials": [
    { "name": "fibre", "density_kg_m3": 1400, "fibre_radius_um": 7, "standard_regain": 0.075, "saturation_regain": 0.25,
      "fibre_diffusivity_m2_s": 1e-13, "contact_angle_deg": 40, "receding_angle_deg": 15, "cross_section": "bean",
      "thermal_conductivity_w_mk": 0.3, "specific_heat_j_kgk": 1300, "heat_of_wetting_j_g": 40 },
    { "name": "other", "based_on": "viscose" } ],
  "liquids": [ { "name": "bath", "surface_tension_mn_m": 70, "viscosity_mpa_s": 1.1, "density_kg_m3": 1000 } ],
  "fabrics": [
    { "name": "cloth", "ends_per_cm": 10, "picks_per_cm": 12, "weave": { "pattern": "plain" },
      "warp": { "material": "fibre", "diameter_mm": 0.5, "packing_factor": 0.5 },
      "weft": { "material": "fibre", "diameter_mm": 0.45, "packing_factor": 0.55 },
      "flyaway": { "loop_density_per_mm": 6, "hair_density_per_mm": 10, "loop_height_mm": 0.1, "hair_length_mm": 0.4 } } ],
  "experiments": [ { "name": "run", "climate": { "temperature_c": 25, "relative_humidity": 0.5, "air_speed_m_s": 0.5 }, "liquid": "bath" } ]
})";

/// What each type adds, in the order of ExperimentType.
const char* const scenes[experiment_types] = {
    R"({ "type": "droplet", "sample_mm": [6, 5], "duration_s": 0.1,
         "droplets": [ { "volume_ul": 1.5, "at_mm": [0.3, 0.2], "height_mm": 0.3, "speed_m_s": 0.2 } ] })",
    R"({ "type": "moisture_management", "sample_mm": [6, 5], "duration_s": 1, "volume_ul": 3, "feed_s": 0.5 })",
    R"({ "type": "vertical_wicking", "strip_mm": [4, 8], "duration_s": 2, "immersion_mm": 2 })",
    R"({ "type": "horizontal_wicking", "sample_mm": [9, 8], "duration_s": 2, "volume_ul": 20 })",
    R"({ "type": "drying", "sample_mm": [6, 5], "duration_s": 900, "initial_water_g_m2": 150 })",
    R"({ "type": "conditioning", "sample_mm": [6, 5], "duration_s": 60, "climate": { "relative_humidity": 1 } })",
    R"({ "type": "sweat", "sample_mm": [6, 5], "duration_s": 300, "rate_g_m2_h": 4000 })"};

/// A key of the schema, as object.key, and another value for it. Where it only acts beside others, what stands there before.
struct Change {
    const char* key;
    const char* at;
    const char* value;
    const char* at_before = "";
    const char* before = "";
};
#define WARP "/fabrics/0/warp/"
#define FABRIC "/fabrics/0/"
#define FIBRE "/materials/0/"
#define BATH "/liquids/0/"
#define RUN "/experiments/0/"
#define DRAFT FABRIC "weave/draft/"
const char* const gab = R"({ "monolayer_regain": 0.05, "c": 10, "k": 0.75 })";
const char* const spun_round = R"({ "material": "elastane", "share": 0.1 })";
const char* const halves = R"([{ "name": "fibre", "share": 0.5 }, { "name": "other", "share": 0.5 }])";
const char* const treadled = R"({ "pattern": null, "draft":
    { "shafts": 3, "treadles": 3, "threading": [1, 2, 3], "tie_up": [[1], [2], [3]], "treadling": [1, 2, 3] } })";
const char* const lifted = R"({ "pattern": null, "draft": { "shafts": 3, "threading": [1, 2, 3], "liftplan": [[1], [2], [3]] } })";
const char* const stripes = R"({ "extra_yarns": [{ "material": "other", "diameter_mm": 0.4 }],
    "warp_order": [{ "yarn": 1 }, { "yarn": 0 }], "weft_order": [{ "yarn": 1 }, { "yarn": 0 }] })";
const char* const by_count = R"({ "material": "fibre", "linear_density_tex": 160, "diameter_mm": null, "packing_factor": 0.5 })";
const char* const course =
    R"([{ "temperature_c": 25, "relative_humidity": 0.5, "air_speed_m_s": 0.5 }, { "time_s": 0.06, "temperature_c": 30 }])";
const Change changes[] = {
    {"material.density_kg_m3", FIBRE "density_kg_m3", "1600"},
    {"material.fibre_radius_um", FIBRE "fibre_radius_um", "9"},
    {"material.standard_regain", FIBRE "standard_regain", "0.1"},
    {"material.saturation_regain", FIBRE "saturation_regain", "0.12"},
    {"material.isotherm", FIBRE "isotherm", R"({ "monolayer_regain": 0.05, "c": 10, "k": 0.75 })"},
    {"material.isotherm.monolayer_regain", FIBRE "isotherm/monolayer_regain", "0.06", FIBRE "isotherm", gab},
    {"material.isotherm.c", FIBRE "isotherm/c", "15", FIBRE "isotherm", gab},
    {"material.isotherm.k", FIBRE "isotherm/k", "0.8", FIBRE "isotherm", gab},
    {"material.fibre_diffusivity_m2_s", FIBRE "fibre_diffusivity_m2_s", "1e-14"},
    {"material.contact_angle_deg", FIBRE "contact_angle_deg", "55"},
    {"material.receding_angle_deg", FIBRE "receding_angle_deg", "30", WARP "irregularity_cv", "0.4"}, // an even feed fills alike yarns only
    {"material.cross_section", FIBRE "cross_section", R"("round")"},
    {"material.thermal_conductivity_w_mk", FIBRE "thermal_conductivity_w_mk", "0.6"},
    {"material.specific_heat_j_kgk", FIBRE "specific_heat_j_kgk", "1800"},
    {"material.heat_of_wetting_j_g", FIBRE "heat_of_wetting_j_g", "80"},
    {"material.sorption_heat_j_g", FIBRE "sorption_heat_j_g", "80", FIBRE "heat_of_wetting_j_g", "null"},
    {"yarn.material", WARP "material", R"("other")"},
    {"blend.name", WARP "material/1/name", R"("polyester")", WARP "material", halves},
    {"blend.share", WARP "material", R"([{ "name": "fibre", "share": 0.7 }, { "name": "other", "share": 0.3 }])", WARP "material", halves},
    {"yarn.core", WARP "core", spun_round},
    {"yarn.core.material", WARP "core/material", R"("polypropylene")", WARP "core", spun_round},
    {"yarn.core.share", WARP "core/share", "0.2", WARP "core", spun_round},
    {"yarn.diameter_mm", WARP "diameter_mm", "0.6"},
    {"yarn.count", WARP "count", R"("160 tex")", WARP "packing_factor", "null"},
    {"yarn.linear_density_tex", WARP "linear_density_tex", "160", WARP "packing_factor", "null"},
    {"yarn.packing_factor", WARP "packing_factor", "0.6"},
    {"yarn.yarn_class", WARP "yarn_class", R"("rotor")", "/fabrics/0/warp", by_count},
    {"yarn.filament_count", WARP "filament_count", "200"},
    {"yarn.twist_per_m", WARP "twist_per_m", "350"},
    {"yarn.plies", WARP "plies", "2"},
    {"yarn.ply_twist_per_m", WARP "ply_twist_per_m", "300", WARP "plies", "2"},
    {"yarn.irregularity_cv", WARP "irregularity_cv", "0.15"},
    {"weave.pattern", FABRIC "weave/pattern", R"("twill 2/2 Z")"},
    {"weave.rows", FABRIC "weave", R"({ "pattern": null, "rows": ["1100", "0110", "0011", "1001"] })"},
    {"draft.threading", DRAFT "threading", "[1, 2, 3, 2]", FABRIC "weave", treadled},
    {"draft.tie_up", DRAFT "tie_up", "[[1, 2], [2, 3], [1, 3]]", FABRIC "weave", treadled},
    {"draft.treadling", DRAFT "treadling", "[1, 2, 3, 2]", FABRIC "weave", treadled},
    {"draft.rising_shed", DRAFT "rising_shed", "false", FABRIC "weave", treadled},
    {"draft.liftplan", DRAFT "liftplan", "[[1], [2], [3], [2]]", FABRIC "weave", lifted},
    {"fabric.ends_per_cm", FABRIC "ends_per_cm", "9"},
    {"fabric.picks_per_cm", FABRIC "picks_per_cm", "10"},
    {"fabric.warp_order.yarn", FABRIC "warp_order/0/yarn", "0", "/fabrics/0", stripes},
    {"fabric.warp_order.count", FABRIC "warp_order/1/count", "3", "/fabrics/0", stripes},
    {"fabric.weft_order.yarn", FABRIC "weft_order/0/yarn", "0", "/fabrics/0", stripes},
    {"fabric.weft_order.count", FABRIC "weft_order/1/count", "3", "/fabrics/0", stripes},
    {"fabric.thickness_mm", FABRIC "thickness_mm", "0.9"},
    {"fabric.warp_crimp_percent", FABRIC "warp_crimp_percent", "4"},
    {"fabric.weft_crimp_percent", FABRIC "weft_crimp_percent", "4"},
    {"fabric.flyaway.loop_density_per_mm", FABRIC "flyaway/loop_density_per_mm", "12"},
    {"fabric.flyaway.hair_density_per_mm", FABRIC "flyaway/hair_density_per_mm", "20"},
    {"fabric.flyaway.loop_height_mm", FABRIC "flyaway/loop_height_mm", "0.3"},
    {"fabric.flyaway.hair_length_mm", FABRIC "flyaway/hair_length_mm", "0.8"},
    {"fabric.contact_angle_deg", FABRIC "contact_angle_deg", "55"},
    {"fabric.finish_face", FABRIC "finish_face", "60"},
    {"fabric.finish_back", FABRIC "finish_back", "60"},
    {"fabric.finish_depth", FABRIC "finish_depth", "0.3", FABRIC "finish_face", "110"},
    {"fabric.finish_holes", FABRIC "finish_holes", "0.2", "/fabrics/0",
     R"({ "finish_face": 120, "finish_back": 120, "finish_depth": 0.5 })"},
    {"fabric.porosity", FABRIC "porosity", "0.8"},
    {"fabric.areal_density_g_m2", FABRIC "areal_density_g_m2", "240"},
    {"fabric.tortuosity", FABRIC "tortuosity", "1.6"},
    {"fabric.crimp_percent", FABRIC "crimp_percent", "5"},
    {"climate.temperature_c", RUN "climate/temperature_c", "30"},
    {"climate.relative_humidity", RUN "climate/relative_humidity", "0.8"},
    {"climate.air_speed_m_s", RUN "climate/air_speed_m_s", "2"},
    {"experiment.liquid", RUN "liquid", R"("water")"},
    {"experiment.closure", RUN "closure", R"("pores")", RUN "closure", R"("paper")"},
    {"experiment.sample_mm", RUN "sample_mm", "[5, 4]"},
    {"experiment.strip_mm", RUN "strip_mm", "[6, 9]"},
    {"experiment.feed_s", RUN "feed_s", "0.8"},
    {"experiment.drop_ul", RUN "drop_ul", "1.5"},
    {"experiment.volume_ul", RUN "volume_ul", "4"},
    {"experiment.direction", RUN "direction", R"("weft")"},
    {"experiment.immersion_mm", RUN "immersion_mm", "4"},
    {"experiment.initial_water_g_m2", RUN "initial_water_g_m2", "200"},
    {"experiment.initial", RUN "initial", R"({ "temperature_c": 30, "relative_humidity": 0.3 })"},
    {"experiment.rate_g_m2_h", RUN "rate_g_m2_h", "30000"},
    {"experiment.side", RUN "side", R"("top")"},
    {"experiment.droplets", RUN "droplets", R"([{ "volume_ul": 1 }, { "volume_ul": 1, "at_mm": [2, 2] }])"},
    {"experiment.droplets.volume_ul", RUN "droplets/0/volume_ul", "1"},
    {"experiment.droplets.time_s", RUN "droplets/0/time_s", "0.02"},
    {"experiment.droplets.at_mm", RUN "droplets/0/at_mm", "[-0.5, 0.6]"},
    {"experiment.droplets.height_mm", RUN "droplets/0/height_mm", "1"},
    {"experiment.droplets.speed_m_s", RUN "droplets/0/speed_m_s", "0.5"},
    {"experiment.climate.time_s", RUN "climate/1/time_s", "0.03", RUN "climate", course},
    {"experiment.climate.temperature_c", RUN "climate/1/temperature_c", "35", RUN "climate", course},
    {"experiment.climate.relative_humidity", RUN "climate/1/relative_humidity", "0.8", RUN "climate", course},
    {"experiment.climate.air_speed_m_s", RUN "climate/1/air_speed_m_s", "2", RUN "climate", course},
    {"experiment.swelling", RUN "swelling", "true"},
    {"experiment.duration_s", RUN "duration_s", "0.05"},
    {"liquid.surface_tension_mn_m", BATH "surface_tension_mn_m", "50"},
    {"liquid.viscosity_mpa_s", BATH "viscosity_mpa_s", "2"},
    {"liquid.density_kg_m3", BATH "density_kg_m3", "1150"},
};

/// Keys that change no water in any experiment, and why.
const std::map<std::string, const char*> without_effect{
    {"project.format", "form of the file"},
    {"project.version", "form of the file"},
    {"project.garments", "holds others"},
    {"project.materials", "holds others"},
    {"project.liquids", "holds others"},
    {"project.fabrics", "holds others"},
    {"project.experiments", "holds others"},
    {"fabric.warp", "holds others"},
    {"fabric.weft", "holds others"},
    {"fabric.weave", "holds others"},
    {"fabric.extra_yarns", "holds others"},
    {"fabric.warp_order", "holds others"},
    {"fabric.weft_order", "holds others"},
    {"fabric.flyaway", "holds others"},
    {"fabric.uncertainty", "holds others"},
    {"fabric.uncertainty.contact_angle_deg", "of replicates, see tst_unknowns"},
    {"fabric.uncertainty.receding_angle_deg", "of replicates, see tst_unknowns"},
    {"fabric.uncertainty.packing_factor", "of replicates, see tst_unknowns"},
    {"fabric.loom", "holds others"},
    {"fabric.loom.ends_per_cm", "of the card"},
    {"fabric.loom.picks_per_cm", "of the card"},
    {"fabric.loom.reed_width_cm", "of the card"},
    {"fabric.loom.ends_per_dent", "of the card"},
    {"yarn.price", "of the card"},
    {"yarn.library_yarn", "a name: the numbers of the library's yarn stand in the yarn"},
    {"fabric.calibrated", "holds others"},
    {"fabric.calibrated.file", "where values come from"},
    {"fabric.calibrated.experiment", "where values come from"},
    {"fabric.calibrated.fidelity", "where values come from"},
    {"fabric.calibrated.quantity", "where values come from"},
    {"fabric.calibrated.residual_rms", "where values come from"},
    {"fabric.calibrated.before", "where values come from"},
    {"fabric.calibrated.before.contact_angle_deg", "where values come from"},
    {"fabric.calibrated.before.receding_angle_deg", "where values come from"},
    {"fabric.calibrated.before.packing_factor", "where values come from"},
    {"weave.draft", "holds others"},
    {"experiment.climate", "holds others"},
    {"material.name", "a name"},
    {"liquid.name", "a name"},
    {"fabric.name", "a name"},
    {"experiment.name", "a name"},
    {"experiment.type", "each type is a scene of its own here"},
    {"material.based_on", "where values come from that are not given"},
    {"yarn.color", "drawn only"},
    {"yarn.fibres_per_yarn", "drawn only"},
    {"yarn.twist_direction", "drawn only: liquid goes as far along either helix"},
    {"yarn.ply_twist_direction", "drawn only: liquid goes as far along either helix"},
    {"draft.shafts", "the loom's; the matrix follows from what is tied and threaded"},
    {"draft.treadles", "the loom's; the matrix follows from what is tied and threaded"},
    {"draft.private_lines", "another program's"},
};

/// All keys of a part of the schema, as object.key.
void find_keys(const ProjectJson& part, const std::string& object, std::set<std::string>& keys)
{
    if (part.contains("properties"))
        for (const auto& [key, value] : part.at("properties").items()) {
            keys.insert(object + "." + key);
            find_keys(value, object + "." + key, keys);
        }
    if (part.contains("items")) find_keys(part.at("items"), object, keys);
    for (const char* choice : {"oneOf", "anyOf"})
        if (part.contains(choice))
            for (const ProjectJson& one : part.at(choice)) find_keys(one, object, keys);
}

std::set<std::string> keys_of_schema()
{
    const ProjectJson schema = project_schema();
    std::set<std::string> keys;
    find_keys(schema, "project", keys);
    for (const auto& [object, part] : schema.at("$defs").items()) find_keys(part, object, keys);
    return keys;
}

using Pointer = ProjectJson::json_pointer;

void put(ProjectJson& project, const char* at, const char* value)
{
    if (*at == 0) return;
    const Pointer place(at);
    const ProjectJson parsed = ProjectJson::parse(value);
    if (parsed.is_null())
        project[place.parent_pointer()].erase(place.back());
    else
        project[place].merge_patch(parsed);
}

struct Run {
    ModelPlan plan;
    std::vector<Frame> frames;
    std::vector<IdleKey> idle_keys;

    bool idle(const std::string& key) const
    {
        return std::any_of(idle_keys.begin(), idle_keys.end(), [&](const IdleKey& idle) { return idle.key == key; });
    }
};

Run run_of(const ProjectJson& project, const std::string& forced)
{
    const Design design = design_from_json(project, "keys");
    for (const Issue& issue : validate(design))
        if (issue.severity == Severity::error) throw Error(issue.where.text() + ": " + issue.text());
    const Experiment& experiment = design.experiments[0];
    const Textile textile = textile_of_run(design, design.fabrics[0], experiment);
    Run run;
    run.plan = plan_model(design, textile, experiment, Fidelity::draft, parse_forced_parts(forced),
                          {{"neglected_share", 0}, {"particles_per_droplet", 60}, {"fibre_shells", 2}, {"rest_tolerance", 0}});
    const std::unique_ptr<Backend> backend = make_cpu_backend();
    run.frames =
        frames_at(*backend, build_scene(design, textile, experiment, run.plan, 1), frame_times(experiment, run.plan.frame_interval));
    run.idle_keys = idle_keys(design.fabrics[0], experiment, run.plan);
    return run;
}

/// Whether a type of experiment has the key.
bool may_act(const std::string& key, ExperimentType type)
{
    const ExperimentTypeInfo& info = info_of(type);
    if (key == "experiment.sample_mm" || key == "experiment.strip_mm") return key == std::string("experiment.") + info.sample_key;
    const std::size_t dot = key.find('.');
    const std::string field = key.substr(dot + 1, key.find('.', dot + 1) - dot - 1);
    const auto knows = [&](int other) { return uses_field(static_cast<ExperimentType>(other), field); };
    bool some = false;
    for (int other = 0; other < experiment_types; ++other) some = some || knows(other);
    return !key.starts_with("experiment.") || !some || uses_field(type, field);
}

/// The largest relative change of a field's sum of differences, or of a number of the ledger.
double moved(const Run& a, const Run& b)
{
    double most = 0;
    for (std::size_t k = 0; k < a.frames.size(); ++k) {
        const Frame &x = a.frames[k], &y = b.frames[k];
        for (const FrameField& field : frame_fields) {
            const auto &u = field.in(x), &v = field.in(y);
            if (u.size() != v.size()) return 1;
            double change = 0, all = 1e-30;
            for (std::size_t i = 0; i < u.size(); ++i) {
                change += std::abs(static_cast<double>(u[i]) - static_cast<double>(v[i]));
                all += std::abs(static_cast<double>(u[i]));
            }
            most = std::max(most, change / all);
        }
        for (const LedgerColumn& column : ledger_columns) {
            const double u = x.ledger.*column.value, v = y.ledger.*column.value;
            most = std::max(most, std::abs(u - v) / (std::abs(u) + 1e-30));
        }
        if (x.positions.size() != y.positions.size()) return 1;
        for (std::size_t i = 0; i < x.positions.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                most = std::max(most, std::abs(static_cast<double>(x.positions[i][c] - y.positions[i][c])) / 1e-3);
    }
    return most;
}

} // namespace

class TestKeys : public QObject {
    Q_OBJECT
    std::set<std::string> acting_; ///< that have moved something
private Q_SLOTS:
    void eachKeyOfTheSchemaIsListedOnce()
    {
        std::set<std::string> listed;
        for (const auto& [key, why] : without_effect) listed.insert(key);
        for (const Change& change : changes) QVERIFY2(listed.insert(change.key).second, change.key);
        for (const std::string& key : keys_of_schema()) {
            if (key.starts_with("garment.") || key.starts_with("wear.") || key.starts_with("worn_climate."))
                continue; // these are on samples: see tst_wear_keys
            QVERIFY2(listed.erase(key) == 1, (key + " is new: say in this test how it acts on the water, or why it does not").c_str());
        }
        QVERIFY2(listed.empty(), listed.empty() ? "" : (*listed.begin() + " is not in the schema").c_str());
    }
    void eachKeyMovesTheWaterOrIsNamedIdle_data()
    {
        QTest::addColumn<int>("type");
        QTest::addColumn<int>("closure");
        QTest::addColumn<QString>("forced");
        const auto row = [](int type, int closure, const char* forced) {
            QTest::addRow("%s, %s %s", name_of(static_cast<ExperimentType>(type)), name_of(static_cast<Closure>(closure)), forced)
                << type << closure << forced;
        };
        constexpr int droplet = static_cast<int>(ExperimentType::droplet);
        for (const Closure by : {Closure::paper, Closure::pores}) { // one by saturation, one by suction
            const int closure = static_cast<int>(by);
            for (int type = 0; type < experiment_types; ++type) row(type, closure, "");
            for (const char* forced : {"sorption=off", "vapour=off", "heat=off"}) row(droplet, closure, forced);
        }
    }
    void eachKeyMovesTheWaterOrIsNamedIdle()
    {
        QFETCH(int, type);
        QFETCH(int, closure);
        QFETCH(QString, forced);
        ProjectJson base = ProjectJson::parse(cloth);
        base["experiments"][0].merge_patch(ProjectJson::parse(scenes[type]));
        base["experiments"][0]["closure"] = name_of(static_cast<Closure>(closure));
        std::map<std::string, Run> before; // by what differs from the base
        std::string wrong;
        for (const Change& change : changes) {
            if (!may_act(change.key, static_cast<ExperimentType>(type))) continue;
            ProjectJson project = base;
            put(project, change.at_before, change.before);
            const auto [plain, is_new] = before.try_emplace(std::string(change.at_before) + change.before);
            if (is_new) plain->second = run_of(project, forced.toStdString());
            put(project, change.at, change.value);
            const Run changed = run_of(project, forced.toStdString());
            const bool is_idle = plain->second.idle(change.key) && changed.idle(change.key);
            const double moves = moved(plain->second, changed);
            if (moves > 0) acting_.insert(change.key);
            constexpr double rounding = 1e-9;
            if (is_idle ? moves > 0 : moves < rounding) wrong += std::string(" ") + change.key + (is_idle ? " moves," : " is idle,");
        }
        QVERIFY2(wrong.empty(), wrong.c_str());
    }
    void eachKeyMovesTheWaterSomewhere()
    {
        for (const Change& change : changes) QVERIFY2(acting_.contains(change.key), change.key);
    }
};

} // namespace tst_keys

QTEST_APPLESS_MAIN(tst_keys::TestKeys)
#include "tst_keys.moc"
