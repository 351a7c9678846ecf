// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The stain of a pool, by suctions: how little it hangs on the length of steps.
#include "core/analysis/metrics.h"
#include "core/plan/planning.h"
#include "core/verify/set_ups.h"

#include <QTest>

#include <numeric>

using namespace hygroloom;

namespace {

/// What 10 ul come to that a pool has fed within a second.
struct Stain {
    double warp = 0, weft = 0; ///< m, its semi-axes
    double in_wefts = 0;       ///< of the water, with what lies beside them

    double radius() const { return std::sqrt(warp * weft); } // of the circle as large
};

/// At `standard`, in steps of which each aims at so much of the usual change of saturation.
Stain fed_stain(const std::string& fabric, double of_the_change)
{
    Experiment experiment = standard_experiment(ExperimentType::moisture_management);
    experiment.name = "pool";
    experiment.closure = Closure::pores;
    experiment.sample_mm = {26, 26};
    experiment.volume_ul = 10;
    experiment.drop_ul = 0;
    experiment.feed_s = 1;
    experiment.duration_s = 1.2;
    RunRecord run;
    run.design = design_of(library_fabric(fabric), experiment);
    run.experiment = experiment.name;
    run.textile = textile_of_run(run.design, run.design.fabrics[0], experiment);
    const ModelPlan plan = plan_model(run.design, run.textile, experiment, Fidelity::standard);
    Scene scene = build_scene(run.design, run.textile, experiment, plan, 1);
    scene.rules.saturation_change *= of_the_change;
    const std::unique_ptr<Backend> backend = make_cpu_backend();
    const Frame end = frames_at(*backend, scene, {experiment.duration_s}).back();
    MetricsCollector collector;
    collector.start(run);
    collector.add(end);
    const Metrics metrics = collector.metrics();
    const auto wefts = end.liquid.begin() + scene.cloth.crossings();
    const double in_warps = std::accumulate(end.liquid.begin(), wefts, 0.0), in_wefts = std::accumulate(wefts, end.liquid.end(), 0.0);
    return {metrics.wetted_area_ellipse_warp, metrics.wetted_area_ellipse_weft, in_wefts / (in_warps + in_wefts)};
}

} // namespace

class TestFedStain : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void stepsTwiceAsFineLeaveItsShape_data()
    {
        QTest::addColumn<QString>("fabric");
        QTest::addColumn<double>("most"); // by which the share in wefts may differ: see limits.md
        QTest::newRow("C, whose ends touch") << "Textile C" << 0.05;
        QTest::newRow("D") << "Textile D" << 0.02;
        QTest::newRow("denim") << "Denim" << 0.04;
    }
    void stepsTwiceAsFineLeaveItsShape()
    {
        QFETCH(QString, fabric);
        QFETCH(double, most);
        const Stain usual = fed_stain(fabric.toStdString(), 1), half = fed_stain(fabric.toStdString(), 0.5),
                    fine = fed_stain(fabric.toStdString(), 0.2);
        for (const Stain& s : {usual, half, fine}) qInfo("%.3f by %.3f mm, %.4f in wefts", 1e3 * s.warp, 1e3 * s.weft, s.in_wefts);
        const auto apart = [](double a, double b) { return std::abs(a / b - 1); };
        QVERIFY(apart(usual.radius(), half.radius()) < 0.03);
        QVERIFY(apart(usual.warp, half.warp) < 0.05 && apart(usual.weft, half.weft) < 0.05);
        QVERIFY(apart(usual.in_wefts, fine.in_wefts) < most);
    }
};

QTEST_APPLESS_MAIN(TestFedStain)
#include "tst_fed_stain.moc"
