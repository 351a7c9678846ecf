// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/fitted_fabric.h"
#include "core/design/validate.h"
#include "core/project/project_file.h"

#include <QTest>

#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

using namespace hygroloom;
namespace fs = std::filesystem;

namespace {

using Change = std::function<void(Design&)>;

Design sound()
{
    Design design;
    Fabric fabric;
    fabric.name = "cloth";
    fabric.warp.diameter_mm = fabric.weft.diameter_mm = 0.2;
    design.fabrics.push_back(fabric);
    Experiment experiment;
    experiment.name = "one drop";
    design.experiments.push_back(experiment);
    return design;
}

const Issue* find(const std::vector<Issue>& issues, const std::string& code)
{
    for (const Issue& issue : issues)
        if (issue.code == code) return &issue;
    return nullptr;
}

} // namespace

Q_DECLARE_METATYPE(Change)

class TestValidate : public QObject {
    Q_OBJECT

    void row(const char* where, const char* code, Change change) { QTest::newRow(where) << QString(where) << QString(code) << change; }

private Q_SLOTS:
    void aSoundDesignHasNoIssues() { QVERIFY(validate(sound()).empty()); }
    void everyStandardExperimentIsSound()
    {
        for (int type = 0; type < experiment_types; ++type) {
            Design design = sound();
            design.experiments[0] = standard_experiment(static_cast<ExperimentType>(type));
            design.experiments[0].name = "standard";
            design.experiments[0].climates = {{60, {30, 0.5, 0}}};
            const auto issues = validate(design);
            QVERIFY2(issues.empty(), issues.empty() ? "" : issues[0].text().c_str());
        }
    }
    void aProjectsOwnLiquidIsKnown()
    {
        Design design = sound();
        design.liquids.push_back({"dye bath"});
        design.experiments[0].liquid = "dye bath";
        QVERIFY(validate(design).empty());
    }

    void yarnsMayBePackedAsCloselyAsGivenButNotSqueezedSo()
    {
        Design design = sound();
        for (Yarn* yarn : {&design.fabrics[0].warp, &design.fabrics[0].weft}) yarn->packing_factor = 0.99;
        design.fabrics[0].thickness_mm = 0.3; // flattens them, which keeps their packing
        const auto dense = validate(design);
        QVERIFY(!has_error(dense));
        QVERIFY(find(dense, "closed_yarns"));
        design.fabrics[0].ends_per_cm = 60; // narrows them
        QVERIFY(find(validate(design), "ends_do_not_fit"));
        for (Yarn* yarn : {&design.fabrics[0].warp, &design.fabrics[0].weft}) yarn->packing_factor = 0.6;
        QVERIFY(!find(validate(design), "closed_yarns"));
    }
    void closelyPackedYarnsTakeALaboratorysWord()
    {
        Design design = sound();
        for (Yarn* yarn : {&design.fabrics[0].warp, &design.fabrics[0].weft}) yarn->packing_factor = 0.88;
        const double derived = derive_quantities(design, design.fabrics[0]).areal_density_g_m2;
        design.fabrics[0].measured.areal_density_g_m2 = 1.05 * derived; // packed to 0.924
        const auto denser = validate(design);
        QVERIFY(!has_error(denser));
        QVERIFY(find(denser, "closed_yarns"));
        design.fabrics[0].measured.areal_density_g_m2 = 1.2 * derived;
        QVERIFY(find(validate(design), "measured_disagrees"));
        for (Yarn* yarn : {&design.fabrics[0].warp, &design.fabrics[0].weft}) yarn->packing_factor = 0.95;
        design.fabrics[0].measured.areal_density_g_m2 = 0.9 * derive_quantities(design, design.fabrics[0]).areal_density_g_m2;
        QVERIFY(!find(validate(design), "closed_yarns"));
    }

    void aStripesYarnThatDoesNotFitIsNamed()
    {
        Design design = sound();
        Fabric& fabric = design.fabrics[0];
        fabric.extra_yarns.resize(2, fabric.warp);
        fabric.extra_yarns[1].diameter_mm = 0.9;
        fabric.thickness_mm = 0.4;
        fabric.weft_order = {{0, 3}, {2, 1}};
        const auto issues = validate(design);
        const Issue* issue = find(issues, "ends_do_not_fit");
        QVERIFY(issue);
        QCOMPARE(issue->where.text(), std::string("fabrics[0].picks_per_cm"));
        QVERIFY2(issue->text().find("picks/cm of yarn C (extra yarn 2) do not fit: a yarn of 0.9 mm") != std::string::npos,
                 issue->text().c_str());
    }

    void everyWrongValueIsAnErrorAtItsPlace_data()
    {
        QTest::addColumn<QString>("where");
        QTest::addColumn<QString>("code");
        QTest::addColumn<Change>("change");
        const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
        row("fabrics[0].name", "line_break", [](Design& d) { d.fabrics[0].name = "linen\n  wetted radius, top  99 mm"; });
        row("garments[0].panels", "line_break", [](Design& d) { d.garments.emplace_back().panels["front\rback"] = {}; });
        row("fabrics[0].name", "empty_name", [](Design& d) { d.fabrics[0].name.clear(); });
        row("fabrics[0].warp.diameter_mm", "range", [](Design& d) { d.fabrics[0].warp.diameter_mm = 0; });
        row("fabrics[0].weft.diameter_mm", "range", [nan](Design& d) { d.fabrics[0].weft.diameter_mm = nan; });
        row("fabrics[0].warp.linear_density_tex", "range", [inf](Design& d) { d.fabrics[0].warp.linear_density_tex = inf; });
        row("fabrics[0].warp.packing_factor", "range", [](Design& d) { d.fabrics[0].warp.packing_factor = 0.995; });
        row("fabrics[0].warp", "no_size", [](Design& d) { d.fabrics[0].warp.diameter_mm.reset(); });
        row("fabrics[0].weft.fibres_per_yarn", "range", [](Design& d) { d.fabrics[0].weft.fibres_per_yarn = 501; });
        row("fabrics[0].weft.fibres_per_yarn ", "range", [](Design& d) { d.fabrics[0].weft.fibres_per_yarn = 0; });
        row("fabrics[0].weft.filament_count", "range", [](Design& d) { d.fabrics[0].weft.filament_count = 1; });
        row("fabrics[0].warp.filament_count", "range", [](Design& d) { // two of 0.13 mm2 each
            d.fabrics[0].warp.diameter_mm = 0.81;
            d.fabrics[0].warp.filament_count = 2;
        });
        row("fabrics[0].weft.twist_per_m", "range", [](Design& d) { d.fabrics[0].weft.twist_per_m = -1; });
        row("fabrics[0].warp.material", "no_material", [](Design& d) { d.fabrics[0].warp.material.clear(); });
        row("fabrics[0].warp.material ", "unknown_material", [](Design& d) { d.fabrics[0].warp.material = {{"stone", 1.0}}; });
        row("fabrics[0].warp.material  ", "shares", [](Design& d) { d.fabrics[0].warp.material = {{"cotton", 0.5}, {"wool", 0.4}}; });
        row("fabrics[0].warp.material[1]", "duplicate_name", [](Design& d) {
            d.fabrics[0].warp.material = {{"wool", 0.5}, {"wool", 0.5}};
        });
        row("fabrics[0].warp.material[1].share", "range", [nan](Design& d) {
            d.fabrics[0].warp.material = {{"wool", 0.5}, {"cotton", nan}};
        });
        row("fabrics[0].ends_per_cm", "range", [nan](Design& d) { d.fabrics[0].ends_per_cm = nan; });
        row("fabrics[0].picks_per_cm", "range", [](Design& d) { d.fabrics[0].picks_per_cm = 0; });
        row("fabrics[0].ends_per_cm ", "ends_do_not_fit", [](Design& d) { d.fabrics[0].ends_per_cm = 100; });
        row("fabrics[0].thickness_mm", "range", [](Design& d) { d.fabrics[0].thickness_mm = -1; });
        row("fabrics[0].thickness_mm ", "thickness_too_small", [](Design& d) { d.fabrics[0].thickness_mm = 0.02; });
        row("fabrics[0].flyaway.loop_height_mm", "range", [inf](Design& d) { d.fabrics[0].flyaway.loop_height_mm = inf; });
        row("fabrics[0].flyaway.hair_length_mm", "range", [](Design& d) { d.fabrics[0].flyaway.hair_length_mm = -0.1; });
        row("fabrics[0].flyaway.loop_density_per_mm", "range", [nan](Design& d) { d.fabrics[0].flyaway.loop_density_per_mm = nan; });
        row("fabrics[0].flyaway.hair_density_per_mm", "range", [](Design& d) { d.fabrics[0].flyaway.hair_density_per_mm = 1e9; });
        row("fabrics[0].contact_angle_deg", "range", [](Design& d) { d.fabrics[0].contact_angle_deg = 181; });
        row("fabrics[0].finish_face", "range", [](Design& d) { d.fabrics[0].finish_face = -1; });
        row("fabrics[0].finish_back", "range", [nan](Design& d) { d.fabrics[0].finish_back = nan; });
        row("fabrics[0].finish_depth", "range", [](Design& d) { d.fabrics[0].finish_depth = 1.01; });
        row("fabrics[0].finish_holes", "range", [nan](Design& d) { d.fabrics[0].finish_holes = nan; });
        row("fabrics[0].weft.irregularity_cv", "range", [](Design& d) { d.fabrics[0].weft.irregularity_cv = 0.41; });
        row("fabrics[0].porosity", "range", [](Design& d) { d.fabrics[0].measured.porosity = 1; });
        row("fabrics[0].areal_density_g_m2", "range", [nan](Design& d) { d.fabrics[0].measured.areal_density_g_m2 = nan; });
        row("fabrics[0].tortuosity", "range", [](Design& d) { d.fabrics[0].measured.tortuosity = 0.9; });
        row("fabrics[0].crimp_percent", "range", [](Design& d) { d.fabrics[0].measured.crimp_percent = -1; });
        row("fabrics[1].name", "duplicate_name", [](Design& d) { d.fabrics.push_back(d.fabrics[0]); });
        row("fabrics[0].weave", "range", [](Design& d) { d.fabrics[0].weave = Weave(2001, 1, std::vector<std::uint8_t>(2001)); });
        row("experiments[0].climate.temperature_c", "range", [](Design& d) { d.experiments[0].climate.temperature_c = 61; });
        row("experiments[0].climate.relative_humidity", "range", [nan](Design& d) { d.experiments[0].climate.relative_humidity = nan; });
        row("experiments[0].climate.air_speed_m_s", "range", [](Design& d) { d.experiments[0].climate.air_speed_m_s = 21; });
        row("experiments[0].liquid", "unknown_liquid", [](Design& d) { d.experiments[0].liquid = "mercury"; });
        row("experiments[0].sample_mm[1]", "range", [nan](Design& d) { d.experiments[0].sample_mm[1] = nan; });
        row("experiments[0].sample_mm", "sample_too_large", [](Design& d) {
            d.experiments[0].sample_mm = {2000, 2000};
            d.fabrics[0].ends_per_cm = 40;
            d.fabrics[0].picks_per_cm = 40;
        });
        row("experiments[0].duration_s", "range", [](Design& d) { d.experiments[0].duration_s = 0; });
        const auto set_up = [](Design& d, ExperimentType type) -> Experiment& {
            d.experiments[0] = standard_experiment(type);
            d.experiments[0].name = "set up";
            return d.experiments[0];
        };
        row("experiments[0].feed_s", "range", [=](Design& d) { set_up(d, ExperimentType::moisture_management).feed_s = 0; });
        const auto feed = [=](Design& d, double volume, double drop) {
            Experiment& e = set_up(d, ExperimentType::moisture_management);
            e.volume_ul = volume;
            e.drop_ul = drop;
        };
        row("experiments[0].drop_ul", "range", [=](Design& d) { feed(d, 200, -1); });
        row("experiments[0].drop_ul ", "range", [=](Design& d) { feed(d, 10, 0.49); });
        row("experiments[0].drop_ul  ", "range", [=](Design& d) { feed(d, 1e5, 1001); });
        row("experiments[0].drop_ul   ", "range", [=](Design& d) { feed(d, 200, nan); });
        row("experiments[0].drop_ul", "too_many_drops", [=](Design& d) { feed(d, 1e5, 24); });
        row("experiments[0].volume_ul", "range", [=](Design& d) { set_up(d, ExperimentType::horizontal_wicking).volume_ul = -1; });
        row("experiments[0].strip_mm[0]", "range", [=](Design& d) { set_up(d, ExperimentType::vertical_wicking).sample_mm[0] = 0; });
        row("experiments[0].immersion_mm", "range", [=](Design& d) { set_up(d, ExperimentType::vertical_wicking).immersion_mm = 150; });
        row("experiments[0].initial_water_g_m2", "range", [=](Design& d) { set_up(d, ExperimentType::drying).initial_water_g_m2 = nan; });
        row("experiments[0].initial.temperature_c", "range",
            [=](Design& d) { set_up(d, ExperimentType::conditioning).initial.temperature_c = -11; });
        row("experiments[0].rate_g_m2_h", "range", [=](Design& d) { set_up(d, ExperimentType::sweat).rate_g_m2_h = -1; });
        row("experiments[0].climate[1].time_s", "range", [](Design& d) { d.experiments[0].climates = {{0, {}}}; });
        row("experiments[0].climate[2].relative_humidity", "range", [](Design& d) {
            d.experiments[0].climates = {{1, {}}, {2, {20, 2.1, 0}}};
        });
        row("liquids[0].viscosity_mpa_s", "range", [](Design& d) { d.liquids = {{"glue", 50, 1e5, 1000}}; });
        row("liquids[1].name", "duplicate_name", [](Design& d) { d.liquids = {{"glue"}, {"glue"}}; });
        row("materials[0].heat_of_wetting_j_g", "range", [](Design& d) {
            d.materials.push_back(material_library()[0]);
            d.materials[0].heat_of_wetting_j_g = -1;
        });
        row("experiments[0].duration_s ", "range", [inf](Design& d) { d.experiments[0].duration_s = inf; });
        row("experiments[0].droplets[0].volume_ul", "range", [](Design& d) { d.experiments[0].droplets[0].volume_ul = 0; });
        row("experiments[0].droplets[0].volume_ul ", "range", [](Design& d) { d.experiments[0].droplets[0].volume_ul = 5001; });
        row("experiments[0].droplets[0].at_mm[0]", "droplet_off_sample", [](Design& d) { d.experiments[0].droplets[0].at_mm[0] = 11; });
        row("experiments[0].droplets[0].at_mm[1]", "droplet_off_sample", [nan](Design& d) { d.experiments[0].droplets[0].at_mm[1] = nan; });
        row("experiments[0].droplets[0].time_s", "range", [](Design& d) { d.experiments[0].droplets[0].time_s = -1; });
        row("experiments[0].droplets[0].time_s ", "droplet_after_end", [](Design& d) { d.experiments[0].droplets[0].time_s = 11; });
        row("experiments[0].droplets[0].height_mm", "range", [nan](Design& d) { d.experiments[0].droplets[0].height_mm = nan; });
        row("experiments[0].droplets[0].speed_m_s", "range", [](Design& d) { d.experiments[0].droplets[0].speed_m_s = 11; });
        row("experiments[0].droplets", "too_much_liquid", [](Design& d) {
            d.liquids = {{"heavy", 70, 1, 2000}};
            d.experiments[0].liquid = "heavy";
            d.experiments[0].droplets.assign(50, Droplet{5000});
        });
        row("experiments[0].droplets[1]", "droplets_overlap", [](Design& d) { d.experiments[0].droplets.resize(2); });
        row("materials[0].receding_angle_deg", "range", [nan](Design& d) {
            d.materials.push_back(material_library()[0]);
            d.materials[0].receding_angle_deg = nan;
        });
        row("materials[0].receding_angle_deg", "receding_above_advancing", [](Design& d) {
            d.materials.push_back(material_library()[0]);
            d.materials[0].receding_angle_deg = d.materials[0].contact_angle_deg + 1;
        });
        row("materials[0].cross_section", "range", [](Design& d) {
            d.materials.push_back(material_library()[0]);
            d.materials[0].cross_section.perimeter_factor = 0.99;
        });
        row("materials[0].density_kg_m3", "range", [](Design& d) {
            d.materials.push_back(material_library()[0]);
            d.materials[0].density_kg_m3 = 0;
        });
        row("materials[0].based_on", "unknown_material", [](Design& d) {
            d.materials.push_back(material_library()[0]);
            d.materials[0].based_on = "stone";
        });
        row("materials[0].isotherm.k", "range", [](Design& d) {
            d.materials.push_back(material_library()[0]);
            d.materials[0].gab.k = 1;
        });
        row("materials[0].saturation_regain", "range", [](Design& d) {
            d.materials.push_back(material_library()[0]);
            d.materials[0].saturation_regain = 0.01;
        });
        row("materials[0].fibre_diffusivity_m2_s", "no_two_stage_law", [](Design& d) {
            d.materials.push_back(*find_library_material("silk"));
            d.materials[0].diffusion.two_stage = true;
        });
        row("materials[0].specific_heat_j_kgk", "range", [nan](Design& d) {
            d.materials.push_back(material_library()[0]);
            d.materials[0].specific_heat_j_kgk = nan;
        });
    }
    void everyWrongValueIsAnErrorAtItsPlace()
    {
        QFETCH(QString, where);
        QFETCH(QString, code);
        QFETCH(Change, change);
        Design design = sound();
        change(design);
        const auto issues = validate(design);
        QVERIFY(has_error(issues));
        const Issue* issue = find(issues, code.toStdString());
        QVERIFY2(issue, issues[0].text().c_str());
        QCOMPARE(QString::fromStdString(issue->where.text()), where.trimmed());
        QVERIFY(issue->severity == Severity::error);
        QVERIFY(issue->text().size() > 20 && issue->text().back() == '.');
    }
    void disagreeingYarnIsRefusedWithTheNumbers()
    {
        Design design = sound();
        design.fabrics[0].warp.linear_density_tex = 30;
        design.fabrics[0].warp.packing_factor = 0.5;
        const auto issues = validate(design);
        const Issue* issue = find(issues, "yarn_disagrees");
        QVERIFY(issue);
        QVERIFY2(issue->text().find("24.35 tex") != std::string::npos && issue->text().find("30") != std::string::npos,
                 issue->text().c_str());
        design.fabrics[0].warp.linear_density_tex = 24.5; // within 1 %
        QVERIFY(!has_error(validate(design)));
        design.fabrics[0].warp.linear_density_tex = 24.7;
        QVERIFY(has_error(validate(design)));
    }
    void aCountThatWasNotMeantForTheDiameterIsWarnedOf()
    {
        Design design = sound();
        Yarn& warp = design.fabrics[0].warp;
        warp.packing_factor.reset();
        for (const auto& [tex, odd] : {std::pair(24.35, false), std::pair(10.0, true), std::pair(45.0, true)}) { // 0.5, 0.21, 0.92
            warp.linear_density_tex = tex;
            const auto issues = validate(design);
            const Issue* issue = find(issues, "odd_packing");
            QCOMPARE(issue != nullptr, odd);
            QVERIFY(!issue || (issue->severity == Severity::warning && issue->where.text() == "fabrics[0].warp"));
            QVERIFY(!has_error(issues));
        }
        warp.diameter_mm.reset(); // then it follows from the count
        QVERIFY(!find(validate(design), "odd_packing"));
    }
    void textGivesRangeAndValue()
    {
        Design design = sound();
        design.experiments[0].climate.temperature_c = 99;
        QCOMPARE(QString::fromStdString(validate(design)[0].text()), QString("The temperature must be from -10 to 60 C; given is 99."));
    }
    void aFeedSaysTheSmallestDropItMayFallIn()
    {
        Design design = sound();
        Experiment& experiment = design.experiments[0] = standard_experiment(ExperimentType::moisture_management);
        experiment.name = "feed";
        for (double drop : {0.0, 0.5, 25.0, 300.0}) { // none, 400, eight, one
            experiment.drop_ul = drop;
            QVERIFY2(!has_error(validate(design)), qPrintable(QString::number(drop)));
        }
        experiment.drop_ul = 0.4;
        QCOMPARE(QString::fromStdString(find(validate(design), "range")->text()),
                 QString("The volume of each drop of the feed must be 0 (the feed flows evenly) or at least 0.5 ul; given is 0.4."));
        experiment.volume_ul = 1e4;
        experiment.drop_ul = 2;
        QCOMPARE(QString::fromStdString(find(validate(design), "too_many_drops")->text()),
                 QString("A feed of 10000 ul may come in at most 4000 drops, of 2.5 ul or more; given are drops of 2 ul."));
    }
    void belowFreezingIsAWarning()
    {
        Design design = sound();
        design.experiments[0].climate.temperature_c = -5;
        const auto issues = validate(design);
        QVERIFY(!has_error(issues));
        QVERIFY(find(issues, "supercooled")->severity == Severity::warning);
    }
    void airThatIsMoreThanSaturatedIsAWarning()
    {
        Design design = sound();
        for (double humidity : {1.2, 2.0}) {
            design.experiments[0].climate.relative_humidity = humidity;
            const auto issues = validate(design);
            QVERIFY(!has_error(issues));
            QVERIFY(find(issues, "supersaturated")->severity == Severity::warning);
        }
        design.experiments[0].climate.relative_humidity = 1;
        QVERIFY(!find(validate(design), "supersaturated"));
    }
    void theExtremesOfStabilityAreSound()
    {
        Design design = sound();
        design.experiments[0].droplets[0].speed_m_s = 10;
        design.experiments[0].droplets[0].height_mm = 0.05;
        Material own = material_library()[0];
        own.based_on = own.name;
        own.name = "own";
        own.fibre_radius_um = 0.001;
        own.diffusion.constant_m2_s = 1e-30;
        design.materials = {own};
        design.fabrics[0].warp.material = {{"own", 1.0}};
        QVERIFY(!has_error(validate(design)));
        design.fabrics[0].warp.packing_factor = 0.01;
        design.fabrics[0].weft.packing_factor = 0.01;
        QVERIFY(!has_error(validate(design)));
        design.fabrics[0].weft.packing_factor = 0.99;
        QVERIFY(!has_error(validate(design)));
        design.fabrics[0].weft.packing_factor = 1; // no pores at all
        QVERIFY(has_error(validate(design)));
    }
    void looseThreadsAreAWarning()
    {
        Design design = sound();
        design.fabrics[0].weave = Weave(2, 2, {1, 0, 1, 1}); // end 0 is always up, pick 1 is all up
        const auto issues = validate(design);
        QVERIFY(!has_error(issues));
        QCOMPARE(std::count_if(issues.begin(), issues.end(), [](const Issue& i) { return i.code == "unbound_thread"; }), 2);
    }
    void waterRepellentFabricIsNoted()
    {
        Design design = sound();
        design.fabrics[0].contact_angle_deg = 110;
        const auto issues = validate(design);
        QVERIFY(find(issues, "no_wicking") && find(issues, "no_wicking")->severity == Severity::note);
    }
    void dropletOverTheEdgeIsAWarning()
    {
        Design design = sound();
        design.experiments[0].droplets[0].at_mm = {9.5, 0};
        const auto issues = validate(design);
        QVERIFY(!has_error(issues));
        QVERIFY(find(issues, "droplet_over_edge"));
    }
    void everyExampleIsSound()
    {
        int count = 0;
        for (const auto& entry : fs::recursive_directory_iterator(std::string(HYGROLOOM_SOURCE_DIR) + "/resources/examples")) {
            if (entry.path().extension() != ".hygro") continue;
            ++count;
            for (const Issue& issue : validate(read_project(entry.path()))) // some published setts are above the limit
                QVERIFY2(issue.severity == Severity::note || issue.code == "jammed", issue.text().c_str());
        }
        QVERIFY(count >= 17);
    }
    void issuesComeInTheOrderOfTheFile()
    {
        Design design = sound();
        design.fabrics[0].warp.twist_per_m = -1;
        design.fabrics[0].picks_per_cm = -1;
        design.experiments[0].duration_s = -1;
        const auto issues = validate(design);
        QCOMPARE(issues.size(), std::size_t(3));
        QCOMPARE(issues[0].where.text(), std::string("fabrics[0].warp.twist_per_m"));
        QCOMPARE(issues[1].where.text(), std::string("fabrics[0].picks_per_cm"));
        QCOMPARE(issues[2].where.text(), std::string("experiments[0].duration_s"));
    }
};

QTEST_APPLESS_MAIN(TestValidate)
#include "tst_validate.moc"
