// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How far runs lie from the reference, worked by hand; the files.
#include "core/analysis/tradeoff.h"
#include "core/base/error.h"
#include "core/run/plan_run.h"
#include "tests/support/drop_design.h"

#include <QTest>

using namespace hygroloom;

namespace {

TradeoffOutcome outcome(double radius, double temperature, std::vector<char> wet, double bound)
{
    TradeoffOutcome o;
    o.metrics = {{"radius_mm", radius}, {"surface_temperature_steady_c", temperature}, {"absorbency_time_s", std::nullopt}};
    o.air_temperature_c = 25;
    o.moments.push_back({{{"bound_water_kg", bound}, {"yarn_water_kg", 4e-6 - bound}}, std::move(wet)});
    o.type = "droplet";
    o.wall = 2;
    o.backend = "cpu";
    o.device = "a CPU";
    return o;
}

/// A run of the drop that ended so.
TradeoffRun run_of(const char* name, Fidelity fidelity, const TradeoffOutcome& outcome, const char* coarser = "")
{
    const Design design = drop_design();
    TradeoffRun run{
        .name = name, .plan = plan_run(design, design.fabrics[0], design.experiments[0], fidelity), .settings = {}, .coarser = coarser};
    run.outcome = outcome;
    if (*coarser == 0) run.walls = {outcome.wall, outcome.wall + 1, outcome.wall + 5};
    if (*coarser == 0) run.peaks = {3e7, 3e7, 3e7};
    return run;
}

bool near(double a, double b) { return std::abs(a - b) < 1e-12; }

} // namespace

class TestTradeoff : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void errorsAreThoseWorkedByHand()
    {
        const TradeoffOutcome reference = outcome(10, 15, {1, 1, 0, 1}, 1e-6);
        const TradeoffErrors errors = tradeoff_errors(outcome(9.5, 15.5, {1, 1, 1, 0}, 1.2e-6), reference);
        QVERIFY(near(errors.metrics.at("radius_mm"), 0.05));
        QVERIFY(near(errors.metrics.at("surface_temperature_steady_c"), 0.05)); // 0.5 K of the 10 K below the air
        QVERIFY(!errors.metrics.contains("absorbency_time_s"));
        QVERIFY(near(errors.metrics.at("bound_water_kg"), 0.05)); // 0.2 mg of the 4 mg that moved
        QVERIFY(near(errors.largest, 0.5));                       // 2 of 4 are wet in both
        QCOMPARE(tradeoff_errors(reference, reference).largest, 0.0);
    }
    void whereAllGetsWetNoOverlapCounts()
    {
        TradeoffOutcome reference = outcome(10, 15, {1, 1, 0, 1}, 1e-6), other = outcome(9.5, 15.5, {1, 1, 1, 0}, 1.2e-6);
        reference.type = other.type = "drying";
        QVERIFY(near(tradeoff_errors(other, reference).largest, 0.05));
    }
    void whatOnlyOneRunFindsIsWhollyWrong()
    {
        const TradeoffOutcome reference = outcome(10, 15, {0, 0}, 0);
        TradeoffOutcome other = reference;
        other.metrics["absorbency_time_s"] = 3.0;
        QCOMPARE(tradeoff_errors(other, reference).largest, 1.0);
    }
    void whenAStainComesToRestIsNotTheLargestError()
    {
        TradeoffOutcome reference = outcome(10, 15, {1}, 0), other = outcome(9.5, 15, {1}, 0);
        reference.metrics["time_of_arrest_s"] = 10;
        other.metrics["time_of_arrest_s"] = 3;
        const TradeoffErrors errors = tradeoff_errors(other, reference);
        QVERIFY(near(errors.metrics.at("time_of_arrest_s"), 0.7));
        QVERIFY(near(errors.largest, 0.05));
    }
    void oneWayTransportCountsByItsGrades()
    {
        TradeoffOutcome reference, other;
        reference.metrics["one_way_transport_pct"] = -0.02;
        other.metrics["one_way_transport_pct"] = 0.98;
        QVERIFY(near(tradeoff_errors(other, reference).metrics.at("one_way_transport_pct"), 0.01));
        reference.metrics["one_way_transport_pct"] = 400;
        other.metrics["one_way_transport_pct"] = 380;
        QVERIFY(near(tradeoff_errors(other, reference).metrics.at("one_way_transport_pct"), 0.05));
    }
    void medianIsOfOddAndEvenCounts()
    {
        QCOMPARE(median({3, 1, 2}), 2.0);
        QCOMPARE(median({4, 1, 2, 3}), 2.5);
        QCOMPARE(median({}), 0.0);
    }
    void convergenceRunsAreTwiceAndFourTimesAsFine()
    {
        const Knobs twice = with_settings(knobs_of(Fidelity::reference), refined({{"particles_per_droplet", 1200}}, 2)),
                    four_times = with_settings(knobs_of(Fidelity::reference), refined({{"particles_per_droplet", 1200}}, 4));
        QCOMPARE(twice.particles_per_droplet, 2400.0);
        QCOMPARE(four_times.particles_per_droplet, 4800.0);
        QCOMPARE(twice.network_step_limit, 0.125e-3);
        QCOMPARE(four_times.liquid_step_factor, 0.25);
        QCOMPARE(four_times.settle_share, 0.0); // what is off stays off
        QCOMPARE(four_times.fibre_shells, static_cast<double>(largest_shell_count));
        QCOMPARE(four_times.crossings_per_cell, 1.0); // nothing is finer
    }
    void aFileGivesTheScenesRowsOfTheTable()
    {
        Tradeoff t = tradeoff_here("cloth", "one drop on cloth");
        t.repeats = 3;
        t.runs = {run_of("draft", Fidelity::draft, outcome(9, 15, {1, 1}, 1e-6)),
                  run_of("reference", Fidelity::reference, outcome(10, 15, {1, 1}, 1e-6)),
                  run_of("reference x 2", Fidelity::reference, outcome(10.5, 15, {1, 1}, 1e-6), "reference"),
                  run_of("reference x 4", Fidelity::reference, outcome(10.5, 15, {1, 1}, 1e-6), "reference x 2")};
        compare_runs(t.runs);
        const MeasuredScene scene = measured_scene(tradeoff_json(t), "t.json");
        QCOMPARE(scene.name + ", " + scene.backend + ", " + scene.device, std::string("one drop on cloth, cpu, a CPU"));
        QCOMPARE(scene.runs.size(), std::size_t(2));
        QCOMPARE(scene.runs[0].seconds, 3.0); // the median
        QCOMPARE(scene.runs[0].bytes, 3e7);
        QVERIFY(near(*scene.runs[0].error, 0.1) && near(scene.runs[0].errors.at("radius_mm"), 0.1));
        QCOMPARE(*scene.runs[1].error, 0.0);
        QVERIFY(near(scene.reference_errors.at("radius_mm"), 0.5 / 10.5)); // of the reference; that of twice as fine is none
    }
    void otherFilesAreNamed()
    {
        Tradeoff set = tradeoff_here("cloth", "drop");
        set.runs = {run_of("draft", Fidelity::draft, outcome(9, 15, {1}, 0))};
        set.runs[0].settings = {{"fibre_shells", 3}};
        for (const std::string& wrong :
             {std::string(), std::string("{}"), std::string("{\"format\": \"hygroloom-tradeoff\", \"version\": 1}"), tradeoff_json(set)}) {
            try {
                measured_scene(wrong, "t.json");
                QFAIL(wrong.c_str());
            } catch (const Error& error) {
                QVERIFY2(std::string(error.what()).starts_with("t.json: "), error.what());
            }
        }
    }
    void outcomesPassBetweenProcesses()
    {
        const TradeoffOutcome o = outcome(10, 15, {1, 0, 1}, 1e-6), back = outcome_from_json(outcome_json(o));
        QVERIFY(back.metrics == o.metrics && back.moments[0].contents == o.moments[0].contents && back.moments[0].wet == o.moments[0].wet);
        QCOMPARE(back.type + back.backend + back.device, o.type + o.backend + o.device);
        QCOMPARE(back.wall, 2.0);
        QCOMPARE(tradeoff_errors(back, o).largest, 0.0);
    }
};

QTEST_APPLESS_MAIN(TestTradeoff)
#include "tst_tradeoff.moc"
