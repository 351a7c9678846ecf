// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a plan counts of a run: which part computes for how long. No clock is asked.
#include "core/plan/expectation.h"
#include "core/plan/frame_times.h"
#include "core/plan/held_liquid.h"
#include "core/run/plan_run.h"
#include "tests/support/drop_design.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace hygroloom;

namespace {

PlannedPart& part(ModelPlan& plan, const std::string& name)
{
    return *std::find_if(plan.parts.begin(), plan.parts.end(), [&](const PlannedPart& each) { return each.name == name; });
}

} // namespace

class TestRoughWork : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// A tester's feed has 200 frames of its own, each of which takes a step beside, is measured and recorded.
    void framesOfAFeedCount()
    {
        Design design = drop_design(35);
        design.experiments[0] = standard_experiment(ExperimentType::moisture_management);
        design.experiments[0].drop_ul = 0;
        const auto plan_with = [&](double feed_s) {
            design.experiments[0].feed_s = feed_s;
            return plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::live);
        };
        const ModelPlan brief = plan_with(2), usual = plan_with(20);
        QCOMPARE(usual.counts.frames, double(frame_times(design.experiments[0], usual.frame_interval).size()));
        QVERIFY(usual.counts.frames > brief.counts.frames + 150);
        QVERIFY(rough_work(usual, "cpu") > 1.1 * rough_work(brief, "cpu"));
        QVERIFY(recording_seconds(usual) > 1.5 * recording_seconds(brief));
    }
    /// On a large sample few cells are computed, but all of it is built.
    void buildingALargeSampleCounts()
    {
        Design design = drop_design(35);
        const auto work_of = [&](double side_mm) {
            design.experiments[0].sample_mm = {side_mm, side_mm};
            return rough_work(plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::live), "cpu");
        };
        const double segments = 2 * double(design.fabrics[0].ends_per_cm) * 30 * double(design.fabrics[0].picks_per_cm) * 30;
        QVERIFY(work_of(300) - work_of(20) > 0.8e-6 * segments);
    }
    void aStartIsNotMultiplied()
    {
        // Sweat for 0.7 s on a small sample takes 0.10 s and the drawing of its rooms another 0.4 s, the shipped one 6 s.
        Design design = drop_design();
        Experiment& sweat = design.experiments[0] = standard_experiment(ExperimentType::sweat);
        sweat.sample_mm = {2, 2};
        sweat.duration_s = 0.7;
        ModelPlan plan = plan_run(design, design.fabrics[0], sweat, Fidelity::draft);
        expect(plan, shipped_measurements("cpu"));
        QVERIFY(plan.on("vapour") || plan.on("sorption") || plan.on("wicking"));
        QVERIFY2(plan.expected_seconds > 0.15 && plan.expected_seconds < 0.8, qPrintable(QString::number(plan.expected_seconds)));
    }
    /// However much of a run set-up is counted to be: a hundred times the steps take longer.
    void moreStepsTakeLongerInEveryShippedScene()
    {
        for (const MeasuredScene& scene : shipped_measurements())
            for (const MeasuredRun& run : scene.runs) {
                if (run.seconds == 0 || (run.plan.on("liquid") && !run.plan.on("cap"))) continue; // particles are as many as before
                ModelPlan longer = run.plan;
                longer.segments *= 100;
                longer.region.ends *= 10;
                longer.region.picks *= 10;
                longer.shown_ends = longer.shown_picks = 0;
                expect(longer, {scene});
                QVERIFY2(longer.expected_seconds > 1.2 * run.seconds, scene.name.c_str());
            }
    }
    // Scaled is the whole of a measured run: where one kind's counts are far off those of another, the smaller part of a run comes out as
    // far off. Seconds at draft over rough work lie between 0.4 and 6.4: a known miss. Dense cloths on which liquid stands (poplin, drill,
    // sheeting) take more rounds a step than is counted.
    void countsOfAllKindsTakeAlikeLong()
    {
        double least = 1e30, most = 0;
        int runs = 0;
        for (const MeasuredScene& scene : shipped_measurements("cpu"))
            for (const MeasuredRun& run : scene.runs) {
                if (run.plan.fidelity != Fidelity::draft || run.seconds <= 0) continue;
                const double ratio = run.seconds / rough_work(run.plan, "cpu");
                qInfo("%s: %.2f", scene.name.c_str(), ratio);
                ++runs;
                least = std::min(least, ratio);
                most = std::max(most, ratio);
            }
        QVERIFY2(runs > 5, qPrintable(QString::number(runs)));
        QVERIFY2(most / least < 20, qPrintable(QString("%1 to %2").arg(least).arg(most)));
    }
    void aDropThatFallsPastASmallSampleIsSoonGone()
    {
        // It took 89 steps and 0.16 s for 1 243 s.
        Design design = drop_design();
        Experiment& drop = design.experiments[0];
        drop.sample_mm = {1.2, 0.33};
        drop.duration_s = 1243;
        drop.droplets[0].volume_ul = 5000;
        drop.droplets[0].height_mm = 20;
        drop.droplets[0].speed_m_s = 10;
        ModelPlan plan = plan_run(design, design.fabrics[0], drop, Fidelity::draft);
        expect(plan, shipped_measurements("cpu"));
        const double steps = count_liquid(plan).steps;
        QVERIFY2(steps > 89.0 / 3 && steps < 89.0 * 3, qPrintable(QString::number(steps)));
        QVERIFY2(plan.expected_seconds < 0.5, qPrintable(QString::number(plan.expected_seconds)));
        drop.sample_mm = {60, 60};
        QVERIFY(count_liquid(plan_run(design, design.fabrics[0], drop, Fidelity::draft)).steps > 10 * steps);
    }
    void whatClingsUnabsorbedKeepsStepsShort()
    {
        Design design = drop_design(80);
        design.fabrics[0].warp.packing_factor = design.fabrics[0].weft.packing_factor = 0.35; // 80 degrees do not get into such dry pores
        Experiment& drop = design.experiments[0];
        drop.closure = Closure::pores;
        drop.sample_mm = {1.2, 0.33};
        drop.droplets[0].volume_ul = 5000;
        const auto work = [&](double duration) {
            drop.duration_s = duration;
            const ModelPlan plan = plan_run(design, design.fabrics[0], drop, Fidelity::draft, {}, {{"free_liquid", 2}});
            if (!plan.on("wicking") || plan.counts.uptake > 0) throw Error("Another case is meant.");
            return rough_work(plan, "cpu");
        };
        QVERIFY2(work(6000) > 5 * work(600), qPrintable(QString("%1 %2").arg(work(6000)).arg(work(600))));
    }
    void noMoreClingsThanASampleHolds()
    {
        SceneCounts scene;
        scene.uptake = 1e-8;
        scene.duration = 1e6;
        scene.capillarity = 7.2e-5;
        scene.sample_area = 1.2e-3 * 0.33e-3;
        scene.sample_edge = 2 * (1.2e-3 + 0.33e-3);
        const auto clings = [&](double microlitres) {
            scene.drop_volume = scene.largest_drop = microlitres * 1e-9;
            return clings_for(scene);
        };
        QVERIFY(std::abs(clings(20) / (0.3 * 20e-9 / 1e-8) - 1) < 1e-9);
        QCOMPARE(clings(500), clings(5000));
        QVERIFY(clings(5000) > clings(20));
    }
    void whatNoYarnAbsorbsSleepsSoon()
    {
        Design design = drop_design(120);
        Experiment& drop = design.experiments[0];
        drop.climate.relative_humidity = 1.2; // so that yarns take steps
        const auto work = [&](double duration) {
            drop.duration_s = duration;
            return rough_work(plan_run(design, design.fabrics[0], drop, Fidelity::draft), "cpu");
        };
        QVERIFY2(work(600) < 2 * work(6), qPrintable(QString("%1 %2").arg(work(600)).arg(work(6))));
    }
    void whatLiesOnFullClothKeepsStepsShort()
    {
        Design design = drop_design();
        Experiment& drop = design.experiments[0];
        drop.closure = Closure::pores;
        drop.sample_mm = {2, 2};
        const auto work = [&](double volume, double duration) {
            drop.droplets[0].volume_ul = volume;
            drop.duration_s = duration;
            return rough_work(plan_run(design, design.fabrics[0], drop, Fidelity::draft, {}, {{"free_liquid", 2}}), "cpu");
        };
        QVERIFY(work(0.1, 6000) < 2 * work(0.1, 600)); // absorbed
        QVERIFY(work(10, 6000) > 5 * work(10, 600));
    }
    /// 2.2 ul at 55 C in dry air on cloth that drew hardly any of it lost 3 % in 10 s, and were counted to lie there for a day.
    void whatDriesOnFullClothEndsShortSteps()
    {
        Design design = drop_design();
        Experiment& drop = design.experiments[0];
        drop.closure = Closure::pores;
        drop.sample_mm = {2, 2};
        drop.duration_s = 6000;
        drop.droplets[0].volume_ul = 10;
        ModelPlan plan = plan_run(design, design.fabrics[0], drop, Fidelity::draft, {{"vapour", true}}, {{"free_liquid", 2}});
        const auto work_with = [&](double dried) {
            part(plan, "vapour").share = dried;
            return rough_work(plan, "cpu");
        };
        const double stays = work_with(0.1), dries = work_with(1000);
        QVERIFY2(dries < 0.1 * stays, qPrintable(QString("%1 %2").arg(dries).arg(stays)));
    }
    void whatIsSweptOffDoesNotCling()
    {
        SceneCounts scene;
        scene.uptake = 5e-11;
        scene.duration = 1e6;
        scene.capillarity = 7e-5;
        scene.sample_area = 1.3e-3 * 1.4e-3;
        scene.sample_edge = 2 * (1.3e-3 + 1.4e-3);
        scene.drop_volume = scene.largest_drop = 23e-9;
        const double lies = clings_for(scene);
        scene.landing_speed = 10;
        QVERIFY2(clings_for(scene) < 0.05 * lies, qPrintable(QString("%1 %2").arg(clings_for(scene)).arg(lies)));
    }
    /// Steps of 1.4 ms, as long as particles of 5 ml may take, end where the yarns' do.
    void stepsOfALargeDropEndWhereItMeetsTheYarns()
    {
        Design design = drop_design(120);
        Experiment& drop = design.experiments[0];
        drop.sample_mm = {60, 60};
        drop.droplets[0].volume_ul = 5000;
        ModelPlan plan = plan_run(design, design.fabrics[0], drop, Fidelity::draft);
        const double steps = count_liquid(plan).steps;
        plan.knobs.network_step_limit = 1e-4;
        QVERIFY2(count_liquid(plan).steps > 5 * steps, qPrintable(QString::number(steps)));
    }
    void whatClothAbsorbsEndsShortSteps()
    {
        Design design = drop_design();
        Experiment& drop = design.experiments[0];
        drop.closure = Closure::paper;
        drop.sample_mm = {20, 20};
        const auto work = [&](double duration) {
            drop.duration_s = duration;
            return rough_work(plan_run(design, design.fabrics[0], drop, Fidelity::draft), "cpu");
        };
        QVERIFY2(work(6000) < 2 * work(600), qPrintable(QString("%1 %2").arg(work(6000)).arg(work(600))));
    }
    void aDropThatIsHardlyAbsorbedSeldomWakes()
    {
        Design design = drop_design();
        design.experiments[0].closure = Closure::pores;
        design.experiments[0].duration_s = 400;
        ModelPlan plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft, {}, {{"free_liquid", 2}});
        const double absorbed = count_liquid(plan).steps;
        plan.counts.uptake *= 1e-6;
        const double lies = count_liquid(plan).steps;
        QVERIFY2(lies < 3 * absorbed, qPrintable(QString("%1 %2").arg(lies).arg(absorbed)));
        plan.knobs.settle_share = 0; // it never sleeps
        QVERIFY(count_liquid(plan).steps > 100 * lies);
    }
    void aDropThatDriesWakes()
    {
        Design design = drop_design(120);
        ModelPlan plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft, {{"vapour", true}});
        const auto steps_with = [&](double dried) {
            part(plan, "vapour").share = dried;
            return count_liquid(plan).steps;
        };
        const double stays = steps_with(0), all = steps_with(1e6);
        QVERIFY(all > 3 * stays);
        plan.counts.duration = 1e-3 * design.experiments[0].duration_s;
        QVERIFY(count_liquid(plan).steps < stays);
    }
    /// Not for as long as a run takes: a full strip has no front, and up one that draws nothing none goes.
    void aFrontTakesStepsForTheCrossingsThatItPasses()
    {
        Design design = drop_design();
        Experiment& strip = design.experiments[0] = standard_experiment(ExperimentType::vertical_wicking);
        ModelPlan plan = plan_run(design, design.fabrics[0], strip, Fidelity::draft);
        const auto steps = [&] { return rough_work(plan, "cpu") - set_up_seconds(plan, "cpu"); };
        const double usual = steps();
        plan.counts.uptake *= 100; // the strip is full long before the end
        QVERIFY2(steps() < 2 * usual, qPrintable(QString("%1 %2").arg(steps()).arg(usual)));
        plan.counts.uptake = 0;
        QVERIFY2(steps() < 0.7 * usual, qPrintable(QString("%1 %2").arg(steps()).arg(usual)));
    }
    /// Flow along a period of one wide and one narrow pitch is found in many rounds: 66 000 voxels took 2.2 s, not 0.3.
    void longPeriodsTakeLongerToDraw()
    {
        Design design = drop_design();
        design.experiments[0].closure = Closure::pores;
        ModelPlan plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft);
        QVERIFY(plan.counts.drawn_longest >= 2);
        const double before = set_up_seconds(plan, "cpu");
        plan.counts.drawn_longest *= 10;
        QVERIFY(set_up_seconds(plan, "cpu") > 2 * before);
        plan.counts.drawn_longest = 0; // not known
        QVERIFY(set_up_seconds(plan, "cpu") > 0.3 * before && set_up_seconds(plan, "cpu") < 3 * before);
    }
    void dropsThatFallAtOnceTakeTheStepsOfOne()
    {
        for (const Closure closure : {Closure::pores, Closure::paper}) {
            Design design = drop_design();
            Experiment& drop = design.experiments[0];
            drop.closure = closure;
            drop.sample_mm = {60, 60};
            drop.duration_s = 60;
            drop.droplets.assign(4, drop.droplets[0]);
            const auto steps = [&](double apart) {
                for (std::size_t k = 0; k < 4; ++k) drop.droplets[k].time_s = apart * static_cast<double>(k);
                return count_liquid(plan_run(design, design.fabrics[0], drop, Fidelity::draft)).steps;
            };
            const double together = steps(0), apart = steps(1);
            QVERIFY2(apart > 1.5 * together, qPrintable(QString("%1 %2").arg(apart).arg(together)));
        }
    }
    void liquidThatIsForcedOnWithoutADropCountsNothing()
    {
        Design design = drop_design();
        Experiment& drying = design.experiments[0] = standard_experiment(ExperimentType::drying);
        ModelPlan plan = plan_run(design, design.fabrics[0], drying, Fidelity::draft, {{"liquid", true}});
        expect(plan, shipped_measurements("cpu"));
        QCOMPARE(count_liquid(plan).steps, 0.0);
        QVERIFY(std::isfinite(plan.expected_seconds) && plan.expected_seconds > 0);
    }
    // 15 ul on textile F at live, 10 s: 195 steps of the yarns. Without any the run would be expected to take its start and its frames.
    void yarnsTakeStepsUnderCaps()
    {
        const auto work = [](double contact_angle) {
            Design design = drop_design(contact_angle, 10);
            design.experiments[0].closure = Closure::pores;
            const ModelPlan plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::live);
            return plan.on("cap") ? rough_work(plan, "cpu") : 0.0;
        };
        QVERIFY2(work(35) > 1.5 * work(120), qPrintable(QString("%1 %2").arg(work(35)).arg(work(120))));
    }
    void aPoolThatNothingDrawsTakesNoMoreStepsThanFrames()
    {
        Design design = drop_design(120);
        Experiment& management = design.experiments[0] = standard_experiment(ExperimentType::moisture_management);
        const auto work = [&](double duration) {
            management.duration_s = duration;
            return rough_work(plan_run(design, design.fabrics[0], management, Fidelity::draft), "cpu");
        };
        QVERIFY2(work(86400) < 15 * work(120), qPrintable(QString::number(work(86400) / work(120))));
    }
};

QTEST_APPLESS_MAIN(TestRoughWork)
#include "tst_rough_work.moc"
