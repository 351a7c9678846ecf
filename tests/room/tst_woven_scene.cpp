// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Drawn rooms in scenes: each crossing has that of its place in the weave.
#include "core/plan/planning.h"
#include "core/project/library.h"
#include "core/room/kept_tables.h"
#include "core/scene/scene.h"
#include "core/solver/backend.h"
#include "core/verify/set_ups.h"

#include <QTest>

#include <cmath>

using namespace hygroloom;

class TestWovenScene : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aDrawnRoomConductsByItsPlaceInTheWeave()
    {
        Fabric fabric = library_fabric("Textile G");
        fabric.weave = weave_from_pattern("satin 5/2");
        Experiment experiment = standard_experiment(ExperimentType::horizontal_wicking);
        experiment.name = "patch";
        experiment.closure = Closure::pores;
        experiment.sample_mm = {8, 6};
        const Design design = design_of(fabric, experiment);
        const Textile textile = textile_of_run(design, design.fabrics[0], design.experiments[0], {3, 1, 10, 10});
        ModelPlan plan = plan_model(design, textile, design.experiments[0], Fidelity::draft);
        plan.knobs.room_voxels = 10;
        const auto drawn = room_tables(textile, 10);
        const Scene scene = build_scene(design, textile, design.experiments[0], plan, 1);
        const auto place = [&](int end, int pick) { return static_cast<std::size_t>((3 + end) % 5 * 5 + (1 + pick) % 5); };
        for (int end = 0; end < 10; ++end)
            for (int pick = 0; pick < 10; ++pick) {
                const auto warp = static_cast<std::size_t>(textile.segment(YarnKind::warp, end, pick)),
                           weft = static_cast<std::size_t>(textile.segment(YarnKind::weft, end, pick));
                QCOMPARE(scene.cloth.room_along[warp], drawn->warp_places[place(end, pick)]);
                QCOMPARE(scene.cloth.room_along[weft], drawn->weft_places[place(end, pick)]);
            }
        const BetweenParameters& between = scene.cloth.crossing[0].between;
        QCOMPARE(between.quarters_along_warp, static_cast<int>(std::lround(4 * drawn->falls_along_warp)));
        // Between yarns that are nearly full, liquid that begins in one room goes on by its place.
        const std::unique_ptr<Backend> backend = make_cpu_backend();
        const auto spread = [&](Scene begun) {
            begun.supply.pools.clear();
            begun.cloth.start.liquid.assign(static_cast<std::size_t>(begun.cloth.segments()), 0.0);
            begun.cloth.start.between.assign(100, 0.0);
            begun.cloth.start.between[44] = 0.9 * scene.climate.density * between.volume;
            for (std::size_t i = 0; i < 200; ++i)
                begun.cloth.start.liquid[i] =
                    0.999 * scene.climate.density * scene.cloth.yarns[i < 100 ? 0 : 1].pore_area * scene.cloth.length[i];
            return frames_at(*backend, begun, {0.1}).front().between;
        };
        Scene even = scene;
        even.cloth.room_along.clear();
        QVERIFY(spread(scene) != spread(even));
    }
};

QTEST_APPLESS_MAIN(TestWovenScene)
#include "tst_woven_scene.moc"
