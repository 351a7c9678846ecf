// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a plan expects: from the nearest measured scene, scaled; and what auto makes of it. No clock is asked here: the times compared with
// were measured once and are kept in tests/data/tradeoff.
#include "core/base/error.h"
#include "core/plan/expectation.h"
#include "core/project/atomic_file.h"
#include "core/project/project_file.h"
#include "core/run/plan_run.h"
#include "tests/support/drop_design.h"

#include <QFile>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace hygroloom;

namespace {

ModelPlan plan_of(double angle, Fidelity fidelity = Fidelity::standard, const KnobSettings& settings = {})
{
    const Design design = drop_design(angle);
    return plan_run(design, design.fabrics[0], design.experiments[0], fidelity, {}, settings);
}

MeasuredScene scene_of(const char* name, const ModelPlan& plan, double seconds, std::optional<double> error)
{
    MeasuredScene scene;
    scene.name = name;
    scene.runs.push_back({.plan = plan, .seconds = seconds, .bytes = 30e6, .error = error});
    return scene;
}

bool mentions(const std::string& text, const char* words) { return text.find(words) != std::string::npos; }

/// Plans of the three fidelities with these expectations.
std::vector<ModelPlan> ladder(std::array<double, 3> seconds, std::array<std::optional<double>, 3> errors)
{
    std::vector<ModelPlan> plans(3);
    for (std::size_t i = 0; i < 3; ++i) {
        plans[i].fidelity = all_fidelities[i + 1];
        plans[i].expected_seconds = seconds[i];
        plans[i].expected_error = errors[i];
    }
    return plans;
}

/// Scenes that the program does not ship.
std::vector<MeasuredScene> unshipped()
{
    const std::string file = HYGROLOOM_SOURCE_DIR "/tests/data/tradeoff/measured.csv";
    return measured_scenes(read_file(file, 1'000'000), file);
}

template <typename Parse> bool refuses(Parse parse, const char* text)
{
    try {
        parse(text);
    } catch (const Error&) {
        return true;
    }
    return false;
}

} // namespace

class TestExpectation : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theSameSceneIsExpectedAsMeasured()
    {
        ModelPlan plan = plan_of(35);
        expect(plan, {scene_of("far", plan_of(88), 100, 0.5), scene_of("near", plan, 7, 0.02)});
        QVERIFY(std::abs(plan.expected_seconds / 7 - 1) < 1e-12);
        QVERIFY(std::abs(plan.expected_bytes / 30e6 - 1) < 1e-12);
        QCOMPARE(*plan.expected_error, 0.02);
        QVERIFY(mentions(plan.expectation_source, "near"));
    }
    void noRunTakesLessThanItsStart()
    {
        const MeasuredScene measured = scene_of("drop", plan_of(35), 0.1, {});
        Design design = drop_design(35);
        Experiment& drop = design.experiments[0];
        drop.sample_mm = {0.5, 0.5};
        drop.duration_s = 1e-4;
        drop.droplets[0].volume_ul = 1e-6;
        ModelPlan plan = plan_run(design, design.fabrics[0], drop, Fidelity::standard, {}, {});
        expect(plan, {measured});
        QVERIFY(plan.expected_seconds >= 0.01 && plan.expected_seconds < 0.011);
    }
    void theNearestSceneCounts()
    {
        ModelPlan plan = plan_of(85);
        expect(plan, {scene_of("wetting", plan_of(35), 100, {}), scene_of("repellent", plan_of(88), 7, {})});
        QVERIFY2(mentions(plan.expectation_source, "repellent"), plan.expectation_source.c_str());
        QVERIFY(!plan.expected_error);
        QVERIFY(mentions(plan.expectation_source, "not measured"));
    }
    void aKnobWithoutEffectLeavesTheErrorKnown()
    {
        Design design = drop_design();
        design.experiments[0] = standard_experiment(ExperimentType::drying);
        const auto plan = [&](const KnobSettings& settings) {
            ModelPlan made = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft, {}, settings);
            expect(made, shipped_measurements("cpu"));
            return made;
        };
        QVERIFY(plan({}).expected_error);
        QVERIFY(plan({{"particles_per_droplet", 500}}).expected_error);
        QVERIFY(!plan({{"step_error", 1e-4}}).expected_error);
    }
    void aShorterFeedIsExpectedToTakeLess()
    {
        // Plain cotton at draft took 7.4, 33.7 and 38.2 s of a processor for 10, 120 and 600 s, the mean of two runs.
        Design design = drop_design();
        design.experiments[0] = standard_experiment(ExperimentType::moisture_management);
        const auto seconds = [&](double duration) {
            design.experiments[0].duration_s = duration;
            ModelPlan plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft);
            expect(plan, shipped_measurements("cpu"));
            return plan.expected_seconds;
        };
        const double usual = seconds(120);
        for (const auto& [duration, measured] : {std::pair(10.0, 7.4), std::pair(600.0, 38.2)}) {
            const double ratio = seconds(duration) / usual / (measured / 33.7);
            QVERIFY2(ratio > 1 / 1.5 && ratio < 1.5, qPrintable(QString("%1 s: %2").arg(duration).arg(ratio)));
        }
    }
    void aPartThatWasForcedOffLeavesTheErrorUnknown()
    {
        Design design = drop_design();
        design.experiments[0] = standard_experiment(ExperimentType::drying);
        for (const auto& [on, known] : {std::pair(true, true), std::pair(false, false)}) {
            ModelPlan plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft, {{"heat", on}});
            expect(plan, shipped_measurements("cpu"));
            QCOMPARE(plan.expected_error.has_value(), known);
        }
    }
    void moreWorkIsExpectedToTakeLonger()
    {
        const std::vector<MeasuredScene> measured{scene_of("drop", plan_of(35), 7, 0.02)};
        ModelPlan more = plan_of(35, Fidelity::standard, {{"particles_per_droplet", 32000}});
        expect(more, measured);
        QVERIFY(more.expected_seconds > 10);
        QVERIFY(!more.expected_error); // it was measured with other knobs
        QVERIFY(more.expected_bytes > 30e6);
    }
    void bundlesAreExpectedToTakeTheirNumbersTimeAndMemory()
    {
        Design design = drop_design();
        design.experiments[0] = standard_experiment(ExperimentType::drying);
        design.experiments[0].sample_mm = {80, 80}; // 280 x 280
        const auto plan = [&](double of) {
            return plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft, {},
                            {{"crossings_per_cell", of}, {"crossings_per_even_cell", 1}, {"room_voxels", 0}});
        };
        // As 16, 4 and 1, over what does not change.
        const double single = rough_work(plan(1), "cpu"), twos = rough_work(plan(2), "cpu"), fours = rough_work(plan(4), "cpu");
        QVERIFY(fours > 0 && std::abs((single - twos) / (twos - fours) - 4) < 1e-9);
        // Management of cotton at draft, 64 328 segments: 65.8, 43.7 and 36.8 MB with bundles of 1, 2 and 4, measured once.
        const double segments = plan(1).segments, most = rough_bytes(plan(1));
        for (const auto& [of, less] : {std::pair(2.0, 22.1e6), std::pair(4.0, 29.0e6)})
            QVERIFY2(std::abs((most - rough_bytes(plan(of))) / segments / (less / 64328) - 1) < 0.05,
                     qPrintable(QString::number((most - rough_bytes(plan(of))) / segments)));
    }
    void aGpuIsExpectedFromWhatWasMeasuredOnOne()
    {
        Design design = drop_design();
        design.experiments[0].closure = Closure::pores; // as the scenes were measured
        ModelPlan plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::standard);
        const double on_cpu = plan.expected_seconds;
        expect(plan, shipped_measurements("cuda"));
        QVERIFY2(mentions(plan.expectation_source, "H200"), plan.expectation_source.c_str());
        QVERIFY2(plan.expected_seconds < 0.5 * on_cpu, qPrintable(QString("%1 %2").arg(plan.expected_seconds).arg(on_cpu)));
        QVERIFY(plan.expected_error);
        // A GPU that one drop does not fill takes hardly longer for twice the particles.
        plan = plan_of(35);
        const ModelPlan more = plan_of(35, Fidelity::standard, {{"particles_per_droplet", 2.0 * plan.particles_per_droplet}});
        QVERIFY(rough_work(more, "cpu") / rough_work(plan, "cpu") > 2);
        QVERIFY(rough_work(more, "cuda") / rough_work(plan, "cuda") < 2);
    }
    void withoutAMeasurementOfItsKindItIsAGuess()
    {
        Design design = drop_design();
        design.experiments[0] = standard_experiment(ExperimentType::conditioning);
        design.experiments[0].sample_mm = {8, 8};
        ModelPlan plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::standard);
        for (const std::vector<MeasuredScene>& measured : {std::vector<MeasuredScene>{},
                                                           {scene_of("drop", plan_of(35), 7, 0.02)},
                                                           {scene_of("draft", plan_of(35, Fidelity::draft), 7, 0.02)}}) {
            expect(plan, measured);
            QVERIFY(mentions(plan.expectation_source, "rough guess"));
            QVERIFY(plan.expected_seconds > 0 && !plan.expected_error);
        }
    }
    void autoTakesTheCheapestThatKeepsTheError()
    {
        const std::vector<ModelPlan> plans = ladder({1, 5, 50}, {0.08, 0.02, 0.0});
        QVERIFY(choose_fidelity(plans, {0.10, {}}).fidelity == Fidelity::draft);
        QVERIFY(choose_fidelity(plans, {0.05, {}}).fidelity == Fidelity::standard);
        QVERIFY(choose_fidelity(plans, {0.01, {}}).fidelity == Fidelity::reference);
        QVERIFY(mentions(choose_fidelity(plans, {0.01, {}}).reason, "No fidelity is known from measurements to keep"));
        const FidelityChoice unknown = choose_fidelity(ladder({1, 5, 50}, {}), {0.05, {}});
        QVERIFY(unknown.fidelity == Fidelity::reference && mentions(unknown.reason, "No fidelity is known"));
    }
    void autoTakesTheFinestThatKeepsTheTime()
    {
        const std::vector<ModelPlan> plans = ladder({1, 5, 50}, {});
        QVERIFY(choose_fidelity(plans, {{}, 60}).fidelity == Fidelity::reference);
        QVERIFY(choose_fidelity(plans, {{}, 5}).fidelity == Fidelity::standard);
        const FidelityChoice none = choose_fidelity(plans, {{}, 0.5});
        QVERIFY(none.fidelity == Fidelity::draft && mentions(none.reason, "coarsest"));
    }
    void runsTogetherAreExpectedByTheWorst()
    {
        const std::vector<ModelPlan> some = ladder({1, 5, 50}, {0.08, 0.02, 0.0});
        const ModelPlan all = expected_of_all(some);
        QCOMPARE(all.expected_seconds, 56.0);
        QCOMPARE(*all.expected_error, 0.08);
        QVERIFY(mentions(all.expectation_source, "3 runs"));
        QCOMPARE(expected_of_all({some[1]}).expected_seconds, 5.0);
        QVERIFY(!expected_of_all({some[0], ladder({1}, {})[0]}).expected_error);
    }
    void targetsAreReadWithTheirUnits()
    {
        QCOMPARE(parse_error_target("5%"), 0.05);
        QCOMPARE(parse_error_target("0.05"), 0.05);
        QCOMPARE(parse_time_target("10s"), 10.0);
        QCOMPARE(parse_time_target("10"), 10.0);
        QCOMPARE(parse_time_target("1.5min"), 90.0);
        QCOMPARE(parse_time_target("2h"), 7200.0);
        for (const char* wrong : {"", "0%", "101%", "-1%", "5 %x", "nan", "five"}) QVERIFY2(refuses(parse_error_target, wrong), wrong);
        for (const char* wrong : {"", "0s", "-1", "10 days", "inf", "s"}) QVERIFY2(refuses(parse_time_target, wrong), wrong);
    }
    void countsStayWithinTheirBounds_data()
    {
        QTest::addColumn<double>("pores");
        QTest::addColumn<double>("base");
        QTest::addColumn<double>("uptake");
        QTest::addColumn<double>("duration");
        QTest::newRow("no pores") << 0.0 << 3.0 << 0.0 << 10.0;
        QTest::newRow("pores that draw nothing") << 1e-4 << 3.0 << 0.0 << 10.0;
        QTest::newRow("a ball") << 1e-4 << 0.05 << 1e-9 << 10.0;
        QTest::newRow("deep pores") << 0.1 << 40.0 << 1.0 << 10.0;
        QTest::newRow("an instant") << 1e-4 << 3.0 << 1e-9 << 1e-9;
        QTest::newRow("a month") << 1e-4 << 3.0 << 1e-15 << 3e6;
    }
    void countsStayWithinTheirBounds()
    {
        QFETCH(double, pores);
        QFETCH(double, base);
        QFETCH(double, uptake);
        QFETCH(double, duration);
        for (const Fidelity fidelity : {Fidelity::draft, Fidelity::standard, Fidelity::reference}) {
            ModelPlan plan = plan_of(35, fidelity);
            plan.counts.pores = pores;
            plan.counts.drop_base = base;
            plan.counts.uptake = uptake;
            plan.counts.duration = duration;
            const LiquidCount count = count_liquid(plan);
            QVERIFY(std::isfinite(count.steps) && count.steps > 0);
            QVERIFY(count.particles > 0 && count.particles <= plan.particles_per_droplet * plan.counts.drops * (1 + 1e-12));
        }
    }
    void whereTheClothHoldsLittleMoreParticlesAreLeft()
    {
        ModelPlan plan = plan_of(35);
        plan.counts.uptake = 2e-9;
        const auto particles = [&](double pores, double base) {
            plan.counts.pores = pores;
            plan.counts.drop_base = base;
            return count_liquid(plan).particles;
        };
        const double dense = particles(1.1e-4, 3.0);
        QVERIFY(particles(0.5e-4, 3.0) > 1.3 * dense && particles(1.1e-4, 2.0) > 1.1 * dense); // thin; open
        plan.particles_per_droplet /= 8;
        QVERIFY(8 * particles(1.1e-4, 3.0) > 1.2 * dense); // coarse ones last longer
    }
    void errorsAreOfTheKindByStudentsLaw()
    {
        const ModelPlan plan = plan_of(35), other = plan_of(35, Fidelity::draft);
        MeasuredScene first = scene_of("first", plan, 7, 0.02), second = scene_of("second", plan, 7, 0.02);
        first.runs[0].errors = {{"radius", 0.03}};
        second.runs[0].errors = {{"radius", 0.04}, {"time", 0.1}};
        second.reference_errors = {{"time", 0.1}};
        MeasuredScene draft = scene_of("draft", other, 7, 0.02);
        draft.runs[0].errors = {{"radius", 0.5}};
        MeasuredScene untimed = scene_of("third", plan, 0, 0.02); // on another backend
        untimed.runs[0].errors = {{"radius", 0.05}};
        const auto errors = [&](const std::vector<MeasuredScene>& measured, const std::vector<MeasuredScene>& elsewhere) {
            ModelPlan expected = plan;
            expect(expected, measured, elsewhere);
            return expected.expected_errors;
        };
        const auto of_two = errors({first, second, draft}, {first, second});
        QVERIFY(std::abs(of_two.at("radius") - 2.920 * std::sqrt((9e-4 + 16e-4) / 2)) < 1e-3);
        QVERIFY(std::abs(of_two.at("time") - 6.314 * std::sqrt(0.02)) < 1e-3); // of one scene, with its reference's own
        const auto of_three = errors({first, second}, {untimed});
        QVERIFY(std::abs(of_three.at("radius") - 2.353 * std::sqrt((9e-4 + 16e-4 + 25e-4) / 3)) < 1e-3);
    }
    // Each shipped scene is expected from the others: 2446 of 2728 numbers lie within (89.7 %), those of both backends and the contents of
    // water among them; of the GPU's alone without contents 88 % of 420. Half a crossing, which numerical_error() adds, is not in it.
    void nineOfTenErrorsLieWithinWhatOtherScenesLetExpect()
    {
        int within = 0, all = 0;
        for (const MeasuredScene& scene : shipped_measurements()) {
            std::vector<MeasuredScene> others, elsewhere;
            for (const MeasuredScene& other : shipped_measurements()) {
                if (other.name == scene.name) continue;
                (other.backend == scene.backend ? others : elsewhere).push_back(other);
            }
            for (const MeasuredRun& run : scene.runs) {
                if (run.plan.fidelity == Fidelity::reference) continue;
                ModelPlan plan = run.plan;
                expect(plan, others, elsewhere);
                for (const auto& [metric, error] : run.errors) {
                    const auto found = plan.expected_errors.find(metric);
                    if (found == plan.expected_errors.end()) continue;
                    ++all;
                    within += error <= found->second + 1e-9;
                }
            }
        }
        qInfo("%d of %d", within, all);
        QVERIFY(all > 300);
        QVERIFY2(within >= 0.89 * all, qPrintable(QString("%1 of %2").arg(within).arg(all)));
    }
    // Counts of other cloths than the estimate was calibrated on. Ratios to the drop on textile F, from whose run others are estimated.
    void countedDropsComeOutWithinHalf()
    {
        constexpr int all = 41, most_outside = 6; // flat filament is expected to wait up to 8 times as long
        const QString folder = HYGROLOOM_SOURCE_DIR "/tests/data/liquid_counts/";
        const Design design = read_project((folder + "drops.hygro").toStdString());
        QFile table(folder + "drops.csv");
        QVERIFY(table.open(QIODevice::ReadOnly));
        table.readLine(); // titles
        int rows = 0, within = 0;
        double first = 0; // ratio of counted to expected for textile F
        while (!table.atEnd()) {
            const QStringList row = QString(table.readLine()).trimmed().split(';');
            QCOMPARE(row.size(), 5);
            const Fabric* fabric = find_fabric(design, row[0].toStdString());
            const Experiment* experiment = find_experiment(design, row[1].toStdString());
            QVERIFY2(fabric && experiment, qPrintable(row[0] + row[1]));
            const bool standard = row[2] == "standard";
            const LiquidCount count = count_liquid(plan_run(design, *fabric, *experiment, standard ? Fidelity::standard : Fidelity::draft));
            const double ratio = row[3].toDouble() * row[4].toDouble() / (count.steps * count.particles);
            if (row[0] == "Textile F" && row[1] == "15 ul, 10 s") first = ratio;
            QVERIFY(first > 0);
            const double estimated = first / ratio;
            within += estimated < 1.5 && estimated > 1 / 1.5;
            ++rows;
            if (estimated >= 1.5 || estimated <= 1 / 1.5) qInfo("%s: %.2f", qPrintable(row.join(' ')), estimated);
        }
        QCOMPARE(rows, all);
        QVERIFY2(rows - within <= most_outside, qPrintable(QString::number(rows - within)));
    }
    // Of drops only steps and particles (no times) are among those above; what a voxel of a room takes was set on flax and twill.
    void scenesThatDoNotShipAreEstimatedWithinTwoThirds_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("backend");
        for (const MeasuredScene& scene : unshipped())
            QTest::addRow("%s, %s", scene.name.c_str(), scene.backend.c_str())
                << QString::fromStdString(scene.name) << QString::fromStdString(scene.backend);
    }
    void scenesThatDoNotShipAreEstimatedWithinTwoThirds() // a factor of 1.67 up or down, but for the known misses below
    {
        QFETCH(QString, name);
        QFETCH(QString, backend);
        const std::vector<MeasuredScene> all = unshipped();
        const auto found = std::find_if(all.begin(), all.end(), [&](const MeasuredScene& each) {
            return each.name == name.toStdString() && each.backend == backend.toStdString();
        });
        const MeasuredScene& scene = *found;
        QVERIFY(!scene.runs.empty());
        double worst = 1, worst_live = 1;
        for (const MeasuredRun& run : scene.runs) {
            ModelPlan plan = run.plan;
            expect(plan, shipped_measurements(scene.backend));
            const double time = plan.expected_seconds / run.seconds, memory = plan.expected_bytes / run.bytes;
            qInfo("%s: time %.2f, memory %.2f of the measured", name_of(run.plan.fidelity), time, memory);
            QVERIFY2(!mentions(plan.expectation_source, "rough guess"), plan.expectation_source.c_str());
            const bool live = run.plan.fidelity == Fidelity::live;
            (live ? worst_live : worst) = std::max({live ? worst_live : worst, time, 1 / time});
            QVERIFY2(time > 1 / 2.2, qPrintable(QString::number(time)));
            QVERIFY(memory < 1.5 && memory > 1 / 1.5);
        }
        // Known misses: a drop is scaled from the shipped one that is least unlike, and no count tells how long it stands on a dense cloth.
        // On viscose in a basket and a twill it is estimated at up to 3.8 and 2.8 times as long, on cotton twill, satin, textile F and of
        // syrup at up to 2.2.
        const bool dense = name.contains("Viscose"), other = name.contains("twill") || name.contains("syrup") || name.contains("Flax") ||
                                                             (name.contains("Textile F") && backend == "cpu");
        QVERIFY2(worst < (dense ? 4 : other ? 2.4 : 1.67), qPrintable(QString::number(worst)));
        QVERIFY2(worst_live < 2.7, qPrintable(QString::number(worst_live)));
    }
    void nineOfTenEstimatesAreWithinThree() // 56 of 60
    {
        int within = 0, all = 0;
        for (const MeasuredScene& scene : unshipped())
            for (const MeasuredRun& run : scene.runs) {
                ModelPlan plan = run.plan;
                expect(plan, shipped_measurements(scene.backend));
                const double times = plan.expected_seconds / run.seconds;
                ++all;
                within += times < 3 && times > 1 / 3.0;
            }
        QVERIFY(all >= 60);
        QVERIFY2(within >= 0.9 * all, qPrintable(QString("%1 of %2").arg(within).arg(all)));
    }
};

QTEST_APPLESS_MAIN(TestExpectation)
#include "tst_expectation.moc"
