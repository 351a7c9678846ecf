// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How far runs lie from the reference, worked by hand; the Pareto front; the files.
#include "core/analysis/closed_forms.h"
#include "core/analysis/tradeoff.h"
#include "core/base/error.h"
#include "core/physics/water.h"
#include "core/run/plan_run.h"
#include "core/scene/scene.h"
#include "tests/support/spot_design.h"

#include <QTest>

using namespace hygroloom;

namespace {

TradeoffOutcome outcome(double radius, double temperature, std::vector<double> map, std::vector<char> wet, double bound)
{
    TradeoffOutcome o;
    o.metrics = {{"radius_mm", radius}, {"surface_temperature_steady_c", temperature}, {"absorbency_time_s", std::nullopt}};
    o.air_temperature_c = 25;
    o.moments.push_back({1.0, {{"bound_water_kg", bound}, {"yarn_water_kg", 4e-6 - bound}}, std::move(map), std::move(wet)});
    o.wall = 2;
    const Design design = drop_design();
    o.plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft);
    return o;
}

double error_of(const TradeoffErrors& errors, const std::string& name)
{
    for (const MetricError& m : errors.metrics)
        if (m.name == name) return m.error;
    return -1;
}

TradeoffPoint point(const char* name, double wall, double error)
{
    TradeoffPoint p;
    p.variant.name = name;
    p.walls = {wall};
    p.errors = TradeoffErrors{};
    p.errors->largest = error;
    return p;
}

/// As a run of the experiment begins.
RunRecord run_of(const Design& design)
{
    RunRecord run;
    run.design = design;
    run.fabric = design.fabrics[0].name;
    run.experiment = design.experiments[0].name;
    run.plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft);
    run.textile = textile_of_run(design, design.fabrics[0], design.experiments[0], run.plan.region);
    run.seed = 1;
    return run;
}

Design conditioning_design(const char* warp, const char* weft)
{
    Design design = drop_design();
    design.fabrics[0].warp.material = {{warp}};
    design.fabrics[0].weft.material = {{weft}};
    design.experiments[0].type = ExperimentType::conditioning;
    design.experiments[0].climate = {20, 0.65, 0.1};
    design.experiments[0].initial = {20, 0.2, 0.1};
    design.experiments[0].droplets.clear();
    return design;
}

bool near(double a, double b) { return std::abs(a - b) < 1e-12; }

} // namespace

class TestTradeoff : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void errorsAreThoseWorkedByHand()
    {
        const TradeoffOutcome reference = outcome(10, 15, {3, 4, 0}, {1, 1, 0, 1}, 1e-6);
        const TradeoffErrors errors = tradeoff_errors(outcome(9.5, 15.5, {3, 3.5, 0}, {1, 1, 1, 0}, 1.2e-6), reference);
        QVERIFY(near(error_of(errors, "radius_mm"), 0.05));
        QVERIFY(near(error_of(errors, "surface_temperature_steady_c"), 0.05)); // 0.5 K of the 10 K below the air
        QVERIFY(near(error_of(errors, "absorbency_time_s"), 0));
        QVERIFY(near(error_of(errors, "bound_water_kg"), 0.05)); // 0.2 mg of the 4 mg that moved
        QVERIFY(near(*errors.map, 0.1));                         // 0.5 over 5
        QVERIFY(near(*errors.overlap, 0.5));                     // 2 of 4
        QVERIFY(near(errors.largest, 0.5));
        const TradeoffErrors none = tradeoff_errors(reference, reference);
        QVERIFY(none.largest == 0 && *none.map == 0 && *none.overlap == 1);
    }
    void whatOnlyOneRunFindsIsWhollyWrong()
    {
        const TradeoffOutcome reference = outcome(10, 15, {0, 0}, {0, 0}, 0);
        TradeoffOutcome other = reference;
        other.metrics["absorbency_time_s"] = 3.0;
        const TradeoffErrors errors = tradeoff_errors(other, reference);
        QCOMPARE(error_of(errors, "absorbency_time_s"), 1.0);
        QVERIFY(!errors.map && !errors.overlap); // no water moved, nothing got wet
    }
    void closedFormsAreScaledLikeMetrics()
    {
        TradeoffOutcome run = outcome(10, 15, {0, 0}, {0, 0}, 0);
        QVERIFY(closed_form_errors(run).empty());
        run.closed_forms = {{"radius_mm", 8}, {"surface_temperature_steady_c", 14}, {"absorbency_time_s", 3}, {"regain_end", 1}};
        const std::vector<MetricError> errors = closed_form_errors(run); // of those that the run has
        QCOMPARE(errors.size(), std::size_t(2));
        QVERIFY(near(errors[0].error, 0.25) && *errors[0].value == 10 && *errors[0].reference == 8);
        QVERIFY(near(errors[1].error, 1.0 / 11)); // of the 11 K below the air
    }
    void fibresComeToRestInTheAir()
    {
        const double wool = closed_forms(run_of(conditioning_design("wool", "wool"))).at("regain_end"),
                     cotton = closed_forms(run_of(conditioning_design("cotton", "cotton"))).at("regain_end"),
                     both = closed_forms(run_of(conditioning_design("wool", "cotton"))).at("regain_end");
        QVERIFY2(std::abs(wool - find_library_material("wool")->standard_regain) < 0.005, qPrintable(QString::number(wool)));
        QVERIFY2(std::abs(cotton - find_library_material("cotton")->standard_regain) < 0.005, qPrintable(QString::number(cotton)));
        QVERIFY2(both > cotton + 0.3 * (wool - cotton) && both < cotton + 0.7 * (wool - cotton), qPrintable(QString::number(both)));
        Design changing = conditioning_design("wool", "wool");
        changing.experiments[0].climates = {{1, {20, 0.3, 0.1}}};
        QVERIFY(closed_forms(run_of(changing)).empty());
        QVERIFY(closed_forms(run_of(drop_design())).empty());
    }
    void aWetSheetComesToItsWetBulb()
    {
        Design design = conditioning_design("wool", "wool");
        design.experiments[0].type = ExperimentType::drying;
        design.experiments[0].initial_water_g_m2 = 250;
        design.experiments[0].duration_s = 3600;
        const RunRecord run = run_of(design);
        const std::map<std::string, double> answers = closed_forms(run);
        const Scene scene = build_scene(design, run.textile, design.experiments[0], run.plan, 1);
        const double celsius = answers.at("surface_temperature_steady_c"), rate = answers.at("drying_rate_g_m2_h") / 3.6e6;
        QVERIFY2(celsius < 17 && celsius > 15.8, qPrintable(QString::number(celsius))); // still air at 20 C and 65 %: 15.9 in a strong wind
        const double brought = 2 * scene.climate.heat_transfer * (20 - celsius), taken = rate * heat_of_evaporation(273.15 + celsius);
        QVERIFY2(std::abs(brought - taken) < 1e-9 * taken, qPrintable(QString("%1 %2").arg(brought).arg(taken)));
        design.experiments[0].initial_water_g_m2 = 20; // the fibres hold it all
        QVERIFY(closed_forms(run_of(design)).empty());
    }
    void oneWayTransportCountsByItsGrades()
    {
        TradeoffOutcome reference, other;
        reference.metrics["one_way_transport_pct"] = -0.02;
        other.metrics["one_way_transport_pct"] = 0.98;
        QVERIFY(near(error_of(tradeoff_errors(other, reference), "one_way_transport_pct"), 0.01));
        reference.metrics["one_way_transport_pct"] = 400;
        other.metrics["one_way_transport_pct"] = 380;
        QVERIFY(near(error_of(tradeoff_errors(other, reference), "one_way_transport_pct"), 0.05));
    }
    void theFrontIsWhatNothingBeats()
    {
        std::vector<TradeoffPoint> points{point("fast", 1, 0.2), point("slow and worse", 3, 0.1), point("good", 2, 0.05),
                                          point("as good, slower", 4, 0.05), point("exact", 10, 0)};
        points.push_back(point("no error known", 0.1, 0));
        points.back().errors.reset();
        mark_pareto(points);
        std::vector<bool> front;
        for (const TradeoffPoint& p : points) front.push_back(p.pareto);
        QVERIFY((front == std::vector<bool>{true, false, true, false, true, false}));
    }
    void medianIsOfOddAndEvenCounts()
    {
        QCOMPARE(median({3, 1, 2}), 2.0);
        QCOMPARE(median({4, 1, 2, 3}), 2.5);
        QCOMPARE(median({}), 0.0);
    }
    void variantsAreTheLadderAndOneKnobEach()
    {
        QCOMPARE(tradeoff_ladder().size(), std::size_t(4));
        QCOMPARE(tradeoff_variants({}).size(), 4 + 2 * knob_table().size());
        const std::vector<TradeoffVariant> shells = tradeoff_variants({"fibre_shells"});
        QCOMPARE(shells.size(), std::size_t(6));
        QCOMPARE(shells[4].name, std::string("fibre_shells=5"));
        QCOMPARE(shells[4].settings.size(), std::size_t(1));
        QVERIFY_EXCEPTION_THROWN(tradeoff_variants({"shells"}), Error);
    }
    void convergenceRunsAreTwiceAndFourTimesAsFine()
    {
        const std::vector<TradeoffVariant> runs = convergence_variants({{"particles_per_droplet", 1200}});
        const Knobs twice = with_settings(knobs_of(Fidelity::reference), runs[0].settings),
                    four_times = with_settings(knobs_of(Fidelity::reference), runs[1].settings);
        QCOMPARE(twice.particles_per_droplet, 2400.0);
        QCOMPARE(four_times.particles_per_droplet, 4800.0);
        QCOMPARE(twice.network_step_limit, 0.125e-3);
        QCOMPARE(four_times.liquid_step_factor, 0.25);
        QCOMPARE(four_times.settle_share, 0.0); // what is off stays off
        QCOMPARE(four_times.fibre_shells, static_cast<double>(largest_shell_count));
        QCOMPARE(four_times.crossings_per_cell, 1.0); // nothing is finer
    }
    void plansThatDifferInNothingThatCountsRunAlike()
    {
        const auto plan = [](double angle, const KnobSettings& settings) {
            const Design design = drop_design(angle);
            return plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::standard, {}, settings);
        };
        QVERIFY(!run_alike(plan(35, {}), plan(35, {{"fibre_shells", 5}})));
        QVERIFY(run_alike(plan(120, {}), plan(120, {{"fibre_shells", 5}}))); // repellent: its fibres take up nothing
        QVERIFY(!run_alike(plan(120, {}), plan(120, {{"settle_share", 0.05}})));
        QVERIFY(!run_alike(plan(120, {}), plan(120, {{"double_precision", 1}})));
        QVERIFY(!run_alike(plan(120, {}), plan(120, {{"liquid_step_factor", 0.5}})));
        QVERIFY(!run_alike(plan(35, {}), plan(35, {{"steps_between_absorption", 1}})));
        QVERIFY(!run_alike(plan(35, {}), plan(35, {{"neglected_share", 0.5}})));
        QVERIFY(run_alike(plan(35, {}), plan(35, {{"crossings_per_cell", 2}}))); // a drop meets single yarns
        const auto spot = [](const KnobSettings& settings) {
            const Design design = spot_design("cotton", 0.5, 10);
            return plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::standard, {}, settings);
        };
        QVERIFY(run_alike(spot({}), spot({{"crossings_per_cell", 1}})) && !run_alike(spot({}), spot({{"crossings_per_cell", 2}})));
        // The same parts are off, but not the same share would switch one on.
        QVERIFY(!run_alike(plan(35, {{"neglected_share", 0.1}}), plan(35, {{"neglected_share", 0.11}})));
        const auto watched = [](double shells) { // sorption that is off but may come on, with N shells
            ModelPlan off;
            off.parts = {{"sorption", false, false, "", 0.01, true}};
            off.knobs.fibre_shells = shells;
            return off;
        };
        QVERIFY(run_alike(watched(5), watched(5)) && !run_alike(watched(5), watched(8)));
    }
    void filesReadBack()
    {
        const Design design = drop_design();
        Tradeoff t = tradeoff_here(design.fabrics[0], design.experiments[0]);
        QVERIFY(!t.commit.empty() && t.date.size() == 20 && t.date.back() == 'Z');
        const TradeoffOutcome reference = outcome(10, 15, {3, 4}, {1, 1}, 1e-6), other = outcome(9, 15, {3, 3}, {1, 0}, 1e-6);
        TradeoffPoint p = point("draft", 1.5, 0);
        p.variant.settings = {{"fibre_shells", 4}};
        p.plan = other.plan;
        p.switched_on = {{"vapour", 20, 0.0103, 0.01, 0.0075}};
        p.peaks = {3e7};
        p.errors = tradeoff_errors(other, reference);
        p.closed_forms = {{"regain_end", 0.14, 0.145, 0.0345}};
        p.stages = {{"exchange", 40.5}};
        p.stands_for = {"fibre_shells=5"};
        t.points = {p, point("<standard>", 4, 0.01)};
        t.points[1].plan = reference.plan;
        t.convergence.push_back({"reference", "reference x 2", *p.errors});
        mark_pareto(t.points);
        QCOMPARE(tradeoff_json(tradeoff_from_json(tradeoff_json(t), "t.json")), tradeoff_json(t));
        QCOMPARE(QString::fromStdString(tradeoff_csv(t)).count('\n'), 11 + 1 + 2);
        const std::string svg = tradeoff_svg(t);
        QVERIFY(svg.find("&lt;standard&gt;") != std::string::npos && svg.find("<standard>") == std::string::npos);
        QVERIFY(svg.find("polyline") != std::string::npos);
        for (const char* wrong : {"", "{}", "{\"format\": \"hygroloom-tradeoff\", \"version\": 2}"}) {
            try {
                tradeoff_from_json(wrong, "t.json");
                QFAIL(wrong);
            } catch (const Error& error) {
                QVERIFY(std::string(error.what()).starts_with("t.json: "));
            }
        }
    }
    void anOutcomeSurvivesThePipe()
    {
        TradeoffOutcome o = outcome(10, 15, {3, 4.25}, {1, 0, 1}, 1e-6);
        o.closed_forms = {{"radius_mm", 9.5}};
        o.switched_on = {{"vapour", 20, 0.0103, 0.01, 0.0075}, {"heat", 30, 0.02, 0.01, std::nullopt, "the run was over"}};
        const TradeoffOutcome back = outcome_from_json(outcome_json(o));
        QCOMPARE(outcome_json(back), outcome_json(o));
        QCOMPARE(back.switched_on.size(), std::size_t(2));
        for (std::size_t i = 0; i < 2; ++i) QCOMPARE(in_words(back.switched_on[i]), in_words(o.switched_on[i]));
        QCOMPARE(tradeoff_errors(back, o).largest, 0.0);
        QVERIFY_EXCEPTION_THROWN(outcome_from_json("{"), Error);
    }
};

QTEST_APPLESS_MAIN(TestTradeoff)
#include "tst_tradeoff.moc"
