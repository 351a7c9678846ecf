// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The table of measured scenes: written, read back, and refused.
#include "core/base/error.h"
#include "core/plan/expectation.h"
#include "core/run/plan_run.h"
#include "tests/support/drop_design.h"

#include <QTest>

#include <cmath>

namespace tst_measured_scenes {

using namespace hygroloom;

ModelPlan plan_of(Fidelity fidelity)
{
    const Design design = drop_design();
    return plan_run(design, design.fabrics[0], design.experiments[0], fidelity);
}

MeasuredScene scene_of(const char* name, const ModelPlan& plan, double seconds, std::optional<double> error)
{
    MeasuredScene scene;
    scene.name = name;
    scene.runs.push_back({.plan = plan, .seconds = seconds, .bytes = 30e6, .error = error});
    return scene;
}

class TestMeasuredScenes : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aTableReadsBackAsItWasWritten()
    {
        const ModelPlan plan = plan_of(Fidelity::standard), draft = plan_of(Fidelity::draft);
        MeasuredScene scene = scene_of("a drop, once", plan, 7, 0.02);
        scene.backend = "cuda";
        scene.device = "a GPU";
        scene.date = "2026-11-30";
        scene.runs[0].errors = {{"radius", 0.03}, {"time", 1e-9}};
        scene.runs.push_back({.plan = draft, .seconds = 2, .bytes = 30e6});
        scene.reference_errors = {{"radius", 0.01}};
        const std::string csv = measured_csv({scene});
        const std::vector<MeasuredScene> back = measured_scenes(csv, "x.csv");
        QCOMPARE(measured_csv(back), csv);
        QCOMPARE(back.size(), std::size_t(1));
        QCOMPARE(back[0].name + back[0].backend + back[0].device + back[0].date, std::string("a drop, oncecudaa GPU2026-11-30"));
        QCOMPARE(back[0].reference_errors.at("radius"), 0.01);
        QCOMPARE(back[0].runs.size(), std::size_t(2));
        const MeasuredRun& run = back[0].runs[0];
        QCOMPARE(*run.error, 0.02);
        QCOMPARE(run.errors.at("radius"), 0.03);
        QCOMPARE(run.errors.at("time"), 0.0);
        QVERIFY(!back[0].runs[1].error && back[0].runs[1].errors.empty());
        for (const char* part : {"liquid", "wicking", "sorption", "vapour", "heat", "growth"}) {
            QVERIFY2(run.plan.on(part) == plan.on(part) && run.plan.watches(part) == plan.watches(part), part);
        }
        for (const char* backend : {"cpu", "cuda"}) {
            QVERIFY(std::abs(rough_work(run.plan, backend) / rough_work(plan, backend) - 1) < 1e-4);
            QVERIFY(std::abs(rough_work(back[0].runs[1].plan, backend) / rough_work(draft, backend) - 1) < 1e-4);
        }
        QVERIFY(std::abs(rough_bytes(run.plan) / rough_bytes(plan) - 1) < 1e-4);
    }
    void errorsOfOneBackendHoldOnTheOther()
    {
        MeasuredScene here = scene_of("drop", plan_of(Fidelity::standard), 7, {}),
                      there = scene_of("drop", plan_of(Fidelity::standard), 3, 0.02);
        here.backend = "cpu";
        there.backend = "cuda";
        there.device = "a GPU";
        there.reference_errors = {{"radius", 0.01}};
        const std::vector<MeasuredScene> read = measured_scenes(measured_csv({here, there}), "x.csv");
        QCOMPARE(*read[0].runs[0].error, 0.02);
        QCOMPARE(read[0].runs[0].errors_from, std::string("a GPU"));
        QCOMPARE(read[0].reference_errors.at("radius"), 0.01);
    }
    void wrongTablesAreNamed()
    {
        const std::string good = measured_csv({scene_of("drop", plan_of(Fidelity::standard), 7, 0.02)});
        const std::size_t scene = good.find('\n') + 1, run = good.find('\n', scene) + 1;
        const auto with = [&](const char* from, const char* to) {
            std::string text = good;
            return text.replace(text.find(from), std::string(from).size(), to);
        };
        for (const std::string& wrong : {std::string(), std::string("{}"), good.substr(0, scene) + good.substr(run),
                                         good.substr(0, run) + good.substr(scene), with(",standard,", ",best,"), with("seconds", "time")}) {
            try {
                measured_scenes(wrong, "x.csv");
                QFAIL(wrong.c_str());
            } catch (const Error& error) {
                QVERIFY2(std::string(error.what()).starts_with("x.csv: "), error.what());
            }
        }
    }
};

} // namespace tst_measured_scenes

QTEST_APPLESS_MAIN(tst_measured_scenes::TestMeasuredScenes)
#include "tst_measured_scenes.moc"
