// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Parallel yarns that touch pass liquid to each other where liquid flows by suction.
#include "core/physics/wicking.h"
#include "core/plan/planning.h"
#include "core/scene/coarse_scene.h"
#include "core/verify/set_ups.h"

#include <QTest>

using namespace hygroloom;

namespace {

struct Cut {
    Textile textile;
    Scene scene;
};
/// 4 x 3 mm of textile F in another weave, its ends at a share of the closest sett, without supply.
Cut cut_of(double closeness, const char* weave = "plain")
{
    Fabric fabric = library_fabric("Textile F");
    fabric.ends_per_cm = closeness * 10 / *fabric.warp.diameter_mm;
    fabric.picks_per_cm = 20;
    fabric.thickness_mm.reset();
    fabric.weave = weave_from_pattern(weave);
    Experiment experiment = standard_experiment(ExperimentType::horizontal_wicking);
    experiment.name = "patch";
    experiment.sample_mm = {4, 3};
    const Design design = design_of(fabric, experiment);
    Cut cut{textile_of_run(design, design.fabrics[0], design.experiments[0]), {}};
    const ModelPlan plan = plan_model(design, cut.textile, design.experiments[0], Fidelity::draft);
    cut.scene = build_scene(design, cut.textile, design.experiments[0], plan, 1);
    cut.scene.supply.pools.clear();
    cut.scene.rules.rest_tolerance = 0;
    return cut;
}

/// The first end holds a share of what it can; nothing passes but between touching yarns.
Scene first_end_wet(double share)
{
    Scene scene = cut_of(1).scene;
    scene.rules.sorption = scene.rules.vapour = scene.rules.heat = false;
    for (YarnParameters& yarn : scene.cloth.yarns) yarn.flow_along = 0;
    for (CrossingParameters& crossing : scene.cloth.crossing) {
        BetweenParameters& b = crossing.between;
        b.along_warp = b.along_weft = b.to_warp = b.to_weft = b.yarns = b.face = 0;
    }
    scene.cloth.start.liquid.assign(static_cast<std::size_t>(scene.cloth.segments()), 0.0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(scene.cloth.picks); ++i)
        scene.cloth.start.liquid[i] = share * scene.climate.density * scene.cloth.yarns[0].pore_area * scene.cloth.length[i];
    return scene;
}

double end_holds(const Scene& scene, const Frame& frame, int end)
{
    double sum = 0;
    for (int pick = 0; pick < scene.cloth.picks; ++pick)
        sum += static_cast<double>(frame.liquid[static_cast<std::size_t>(end * scene.cloth.picks + pick)]);
    return sum;
}

} // namespace

class TestTouching : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void contactsAreWhereYarnsTouch()
    {
        QVERIFY(cut_of(0.9).scene.cloth.touching.empty());
        const auto [textile, scene] = cut_of(1);
        const YarnType& type = textile.warp.types[0];
        const double across = permeability_across(1e-6 * type.fibre.fibre_radius_um / type.perimeter_factor, type.packing);
        const double by_hand = 0.5 * type.section.height * scene.cloth.length[0] * across / (scene.climate.viscosity * type.section.width);
        QVERIFY(std::abs(scene.cloth.touching[0] / by_hand - 1) < 1e-12);
        for (int pick = 0; pick < textile.picks(); ++pick) // the last end has no next; picks are apart
            QCOMPARE(scene.cloth.touching[static_cast<std::size_t>(textile.segment(YarnKind::warp, textile.ends() - 1, pick))], 0.0);
        QCOMPARE(scene.cloth.touching.back(), 0.0);
        // Two ends that lie side by side in a basket are pushed together; the next two are parted by a pick.
        const Cut basket = cut_of(0.7, "basket 2/2");
        int together = 0, apart = 0;
        for (int end = 0; end + 1 < basket.textile.ends(); ++end)
            (basket.scene.cloth.touching[static_cast<std::size_t>(end * basket.textile.picks())] > 0 ? together : apart)++;
        QVERIFY(std::abs(together - apart) <= 1);
    }
    void liquidPassesFromEndToEndButNoMoreThanSuctionsDrive()
    {
        const std::unique_ptr<Backend> backend = make_cpu_backend();
        for (double step : {1e-3, 1.0, 1e3}) {
            Scene scene = first_end_wet(0.9);
            scene.rules.network_step = scene.rules.calm_network_step = step;
            scene.rules.step_share = 0;
            scene.rules.saturation_change = 1;
            const std::vector<Frame> frames = frames_at(*backend, scene, {step, 20 * step, 1000 * step});
            double before = 0;
            for (const Frame& frame : frames) {
                const double first = end_holds(scene, frame, 0), second = end_holds(scene, frame, 1);
                QVERIFY(first > second && second >= before);
                QVERIFY(std::abs(frame.ledger.water_imbalance()) < 1e-14 * frame.ledger.water_delivered);
                for (float saturation : frame.saturation) QVERIFY(saturation >= 0 && saturation <= 1);
                before = second;
            }
            if (step >= 1) QVERIFY2(before > 0.01 * end_holds(scene, frames.back(), 0), qPrintable(QString::number(before)));
        }
        Scene apart = first_end_wet(0.9);
        apart.cloth.touching.clear();
        QCOMPARE(end_holds(apart, frames_at(*backend, apart, {10}).front(), 1), 0.0);
    }
    void whatRestsStaysToAFloat()
    {
        const std::unique_ptr<Backend> backend = make_cpu_backend();
        Scene scene = first_end_wet(0.9);
        scene.rules.network_step = scene.rules.calm_network_step = 10;
        scene.rules.step_share = 0;
        scene.rules.saturation_change = 1;
        const std::vector<Frame> frames = frames_at(*backend, scene, {3e5, 3.001e5});
        QVERIFY(frames[0].liquid == frames[1].liquid);
    }
    void warmLiquidCarriesItsHeat()
    {
        const std::unique_ptr<Backend> backend = make_cpu_backend();
        Scene scene = cut_of(1).scene;
        scene.rules.sorption = scene.rules.vapour = scene.rules.heat = true;
        scene.cloth.start.warmth = 15;
        scene.cloth.start.liquid = first_end_wet(0.9).cloth.start.liquid;
        const Frame frame = frames_at(*backend, scene, {2}).front();
        QVERIFY(std::abs(frame.ledger.water_imbalance()) < 1e-12 * frame.ledger.water_delivered);
        QVERIFY(std::abs(frame.ledger.energy_imbalance()) < 1e-9 * frame.ledger.energy_lost);
    }
    void bundlesConductAsTheirYarnsDo()
    {
        Scene fine = cut_of(1).scene;
        for (double& contact : fine.cloth.touching) contact = contact > 0 ? 6.0 : 0.0;
        const Scene coarse = coarsened(fine, {3});
        const double ends = static_cast<double>(fine.cloth.ends) / coarse.cloth.ends,
                     picks = static_cast<double>(fine.cloth.picks) / coarse.cloth.picks;
        QVERIFY(ends > 2);
        for (std::size_t i = 0; i < coarse.cloth.touching.size(); ++i) {
            const bool joins = i < static_cast<std::size_t>((coarse.cloth.ends - 1) * coarse.cloth.picks);
            QVERIFY(std::abs(coarse.cloth.touching[i] - (joins ? 6.0 * picks / ends : 0.0)) < 1e-12);
        }
    }
};

QTEST_APPLESS_MAIN(TestTouching)
#include "tst_touching.moc"
