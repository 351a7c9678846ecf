// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The table of metrics: every type of experiment lists its numbers once, with a unit, a title and a reason where a value is missing.
#include "core/analysis/metrics_json.h"
#include "core/analysis/outcomes.h"
#include "tests/support/drop_design.h"

#include <QTest>
#include <nlohmann/json.hpp>

#include <set>

using namespace hygroloom;

namespace {

RunRecord run_of(ExperimentType type)
{
    RunRecord run;
    run.design = drop_design();
    run.design.experiments[0] = standard_experiment(type);
    run.fabric = run.design.fabrics[0].name;
    run.experiment = run.design.experiments[0].name;
    return run;
}

/// Results of every type, without any value that may be missing.
Metrics without_values()
{
    Metrics m;
    m.ledger.water_delivered = 1e-6;
    m.management.emplace();
    m.wicking.emplace();
    m.drying.emplace();
    m.conditioning.emplace();
    return m;
}

const Outcome& outcome_named(const std::vector<Outcome>& outcomes, const std::string& key)
{
    return *std::find_if(outcomes.begin(), outcomes.end(), [&](const Outcome& outcome) { return outcome.key == key; });
}

} // namespace

class TestOutcomes : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyMetricIsNamedOnceAndSaysWhyItIsMissing_data()
    {
        QTest::addColumn<int>("type");
        for (int type = 0; type < experiment_types; ++type) QTest::newRow(name_of(static_cast<ExperimentType>(type))) << type;
    }
    void everyMetricIsNamedOnceAndSaysWhyItIsMissing()
    {
        QFETCH(int, type);
        const RunRecord run = run_of(static_cast<ExperimentType>(type));
        const Metrics metrics = without_values();
        const std::vector<Outcome> outcomes = outcomes_of(run, metrics);
        const nlohmann::ordered_json json = metrics_value(run, metrics).at("metrics");
        std::set<std::string> keys;
        for (const Outcome& outcome : outcomes) {
            QVERIFY2(keys.insert(outcome.key).second, outcome.key.c_str());
            QVERIFY2(json.contains(outcome.key) && !outcome.title.empty(), outcome.key.c_str());
            QVERIFY2(outcome.value || !outcome.missing.empty() || !outcome.text.empty(), outcome.key.c_str());
            if (!outcome.value && outcome.text.empty()) {
                const std::string notes = json.at("notes").dump();
                QVERIFY2(json.at(outcome.key).is_null() && notes.find(outcome.key + ": " + outcome.missing) != std::string::npos,
                         notes.c_str());
            }
        }
        for (const OutcomeInfo& info : compared_by(static_cast<ExperimentType>(type))) {
            QVERIFY2(keys.contains(info.key), info.key.c_str());
            QVERIFY(info.better != Better::neither);
        }
    }
    void ranksFollowTheComparison()
    {
        const std::vector<Outcome> outcomes = outcomes_of(run_of(ExperimentType::horizontal_wicking), without_values());
        QCOMPARE(outcome_named(outcomes, "wick_rate_mm2_s").rank, 1);
        QCOMPARE(outcome_named(outcomes, "equal_area_radius_mm").rank, 2);
        QCOMPARE(outcome_named(outcomes, "maximum_wetted_radius_top_mm").rank, 4); // beside
        QCOMPARE(outcome_named(outcomes, "wetted_area_ellipse_warp_mm").rank, 0);
    }
    void unitsAreThoseOfTheKeys()
    {
        Metrics m = without_values();
        m.drying->rate = 1e-4; // kg/(m2 s)
        m.drying->steady_temperature = 293.15;
        const std::vector<Outcome> outcomes = outcomes_of(run_of(ExperimentType::drying), m);
        QCOMPARE(*outcome_named(outcomes, "drying_rate_g_m2_h").value, 360.0);
        QCOMPARE(*outcome_named(outcomes, "surface_temperature_steady_c").value, 20.0);
        m.conditioning->regain_end = 0.125;
        const std::vector<Outcome> regains = outcomes_of(run_of(ExperimentType::conditioning), m);
        const Outcome& end = outcome_named(regains, "regain_end");
        QCOMPARE(*end.value, 0.125);
        QCOMPARE(shown(end, *end.value).value, 12.5);
        QCOMPARE(shown(end, *end.value).unit, std::string("%"));
        QCOMPARE(end.remark, std::string("still changing"));
    }
    void ringsAreShownWhereTheyAreGraded()
    {
        const std::string rings = "maximum_wetted_radius_top_ring_mm";
        Metrics m = without_values();
        m.maximum_wetted_radius_top = 12.4e-3;
        const std::vector<Outcome> management = outcomes_of(run_of(ExperimentType::moisture_management), m);
        QVERIFY(is_shown(outcome_named(management, rings)) && outcome_named(management, rings).grade);
        m.management.reset();
        const std::vector<Outcome> droplet = outcomes_of(run_of(ExperimentType::droplet), m);
        QCOMPARE(*outcome_named(droplet, rings).value, 10.0);
        QVERIFY(!is_shown(outcome_named(droplet, rings)));
        QCOMPARE(full_title(outcome_named(droplet, rings)), std::string("wetted radius in 5 mm rings, top"));
    }
    void theTestersPinsGiveTheRingsAndItsAssumptionsAreNamed()
    {
        Metrics m = without_values();
        m.maximum_wetted_radius_top = 23e-3; // of the stain; the pins read less
        m.management->top.maximum_wetted_radius = 15;
        m.assumed = {"One.", "Two."};
        const nlohmann::json tester = metrics_value(run_of(ExperimentType::moisture_management), m).at("metrics");
        QCOMPARE(tester.at("maximum_wetted_radius_top_ring_mm").get<double>(), 15.0);
        QCOMPARE(tester.at("maximum_wetted_radius_top_mm").get<double>(), 23.0);
        QCOMPARE(tester.at("grades").at("maximum_wetted_radius_top").get<int>(), 3);
        QVERIFY(tester.at("assumed") == nlohmann::json({"One.", "Two."}));
        m.assumed.clear();
        QVERIFY(!metrics_value(run_of(ExperimentType::droplet), m).at("metrics").contains("assumed"));
    }
    void theBalanceNamesWaterFromTheAir()
    {
        Ledger ledger;
        ledger.water_evaporated = -2e-6;
        const std::vector<BalanceRow> rows = water_balance(ledger);
        const auto row = std::find_if(rows.begin(), rows.end(), [](const BalanceRow& r) { return r.title == "water taken from the air"; });
        QVERIFY(row != rows.end());
        QCOMPARE(row->value, 2.0);
        QCOMPARE(row->unit, std::string("mg"));
    }
};

QTEST_APPLESS_MAIN(TestOutcomes)
#include "tst_outcomes.moc"
