// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Drops that stand as caps: their water is kept, they become one where they touch, dry, and are absorbed wherever they lie.
#include "core/analysis/metrics.h"
#include "core/base/random.h"
#include "core/physics/caps.h"
#include "core/physics/heat_moisture.h"
#include "core/plan/cap_room.h"
#include "core/plan/planning.h"
#include "core/scene/coarse_scene.h"
#include "core/solver/cap_air.h"
#include "core/solver/cap_shapes.h"
#include "core/solver/caps.h"
#include "core/solver/drop_shapes.h"
#include "core/verify/set_ups.h"

#include <QTest>

#include <algorithm>

using namespace hygroloom;

namespace {

Experiment drops_on_sample(std::vector<Droplet> drops, double duration)
{
    Experiment experiment = standard_experiment(ExperimentType::droplet);
    experiment.name = "drops";
    experiment.sample_mm = {20, 20};
    experiment.droplets = std::move(drops);
    experiment.duration_s = duration;
    return experiment;
}

Droplet drop_at(double x, double y, double volume_ul)
{
    Droplet drop;
    drop.volume_ul = volume_ul;
    drop.at_mm = {x, y};
    drop.height_mm = 1;
    return drop;
}

Scene scene_of(Fabric fabric, const Experiment& experiment, const KnobSettings& more = {}, const ForcedParts& forced = {})
{
    KnobSettings knobs{{"free_liquid", 1}};
    knobs.insert(more.begin(), more.end());
    const Design design = design_of(std::move(fabric), experiment);
    const Textile textile = textile_of_run(design, design.fabrics[0], experiment);
    const ModelPlan plan = plan_model(design, textile, experiment, Fidelity::draft, forced, knobs);
    Scene scene = build_scene(design, textile, experiment, plan, 1);
    return plan.crossings_per_cell > 1 ? coarsened(scene, plan.bundling()) : scene;
}

Fabric repellent(double angle)
{
    Fabric fabric = library_fabric("Textile G");
    fabric.contact_angle_deg = angle;
    return fabric;
}

double in_cloth(const Frame& frame) { return frame.ledger.water_liquid + frame.ledger.water_bound; }

} // namespace

class TestCaps : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void waterOfACapIsKept()
    {
        const Scene scene = scene_of(library_fabric("Textile F"), drops_on_sample({drop_at(0, 0, 15)}, 1));
        QVERIFY(scene.caps.on);
        const std::unique_ptr<Backend> backend = make_cpu_backend();
        double before = 1;
        for (const Frame& frame : frames_at(*backend, scene, {0, 0.02, 0.05, 0.1, 0.2, 0.4, 1})) {
            QVERIFY(std::abs(frame.ledger.water_imbalance()) <= 1e-12 * std::max(1e-6, frame.ledger.water_delivered));
            if (frame.time > 0) QVERIFY(frame.ledger.water_free <= before);
            if (frame.time > 0) before = frame.ledger.water_free;
        }
        QVERIFY(before < 1e-9 * 15e-6);
    }
    void aRunGoesOnFromItsStateToTheSameBytes()
    {
        const Scene scene = scene_of(library_fabric("Denim"), drops_on_sample({drop_at(-2, 1, 8), drop_at(3, -1, 5)}, 1));
        const std::unique_ptr<Backend> whole = make_cpu_backend(), first = make_cpu_backend(), second = make_cpu_backend();
        whole->load(scene);
        first->load(scene);
        second->load(scene);
        for (Backend* backend : {whole.get(), first.get()})
            for (double reached = 0; reached < 0.03;) reached = backend->advance(0.03);
        second->go_on_from(first->state());
        for (Backend* backend : {whole.get(), second.get()})
            for (double reached = 0; reached < 0.2;) reached = backend->advance(0.2);
        QVERIFY(whole->state() == second->state());
    }
    void capsThatTouchBecomeOne()
    {
        const Scene scene = scene_of(repellent(120), drops_on_sample({drop_at(-0.8, 0, 10), drop_at(0.8, 0, 20)}, 1));
        const std::unique_ptr<Backend> backend = make_cpu_backend();
        const Frame frame = frames_at(*backend, scene, {1}).back();
        QCOMPARE(frame.caps.size(), std::size_t(1));
        QVERIFY(std::abs(frame.caps[0].volume / 30e-9 - 1) < 1e-3);
        QVERIFY(std::abs(frame.caps[0].x - (-0.8e-3 * 10 + 0.8e-3 * 20) / 30) < 1e-6);
        const double weight = scene.climate.density * gravity_acceleration / scene.climate.surface_tension;
        QVERIFY(frame.caps[0].base >= 0.99 * drop_of_volume(frame.caps[0].volume, scene.caps.advancing, weight).base_radius);
    }
    void noShapeAtRestIsWiderThanThePlanExpects()
    {
        constexpr double tension = 0.0728, density = 998;
        for (int degrees = 3; degrees <= 175; degrees += 4)
            for (double ul = 0.05; ul < 2000; ul *= 1.2) {
                const double angle = radian_from_degree(degrees), volume = cubic_metre_from_ul(ul);
                const double base = CapShapes::table().base(volume, angle, density * gravity_acceleration / tension);
                QVERIFY2(base <= largest_cap_base(volume, angle, {tension, 1e-3, density}, 1e9),
                         qPrintable(QString("%1 degrees, %2 µl").arg(degrees).arg(ul)));
            }
    }
    void noCapLeavesTheSampleWhereThePlanGivesItRoom()
    {
        Scene scene = scene_of(library_fabric("Textile F"), drops_on_sample({drop_at(0, 0, 5)}, 1));
        int allowed = 0, small_angles = 0;
        for (std::uint64_t trial = 0; trial < 400; ++trial) {
            std::uint64_t drawn = 0;
            const auto from = [&](double least, double most) { return least + (most - least) * random_uniform(7, trial, drawn++); };
            Bounds bounds;
            bounds.liquid = {scene.climate.surface_tension, scene.climate.viscosity, scene.climate.density};
            bounds.advancing_deg = from(0, 60);
            const double duration = std::pow(10.0, from(-2, 2));
            std::vector<Droplet> drops;
            scene.supply.droplets.clear();
            for (int left = static_cast<int>(from(1, 5)); left > 0; --left) {
                Droplet drop = drop_at(from(-8, 8), from(-8, 8), std::pow(10.0, from(0, 2)));
                drop.height_mm = from(0, 20);
                drops.push_back(drop);
                const double volume = cubic_metre_from_ul(drop.volume_ul), ball = std::cbrt(3 * volume / (4 * pi));
                scene.supply.droplets.push_back(
                    {0,
                     volume,
                     {1e-3 * drop.at_mm[0], 1e-3 * drop.at_mm[1], scene.cloth.half_thickness + 1e-3 * drop.height_mm + ball},
                     0});
            }
            if (!why_no_cap(drops_on_sample(drops, duration), bounds).empty()) continue;
            ++allowed;
            small_angles += bounds.advancing_deg < 30;
            scene.caps.advancing = radian_from_degree(bounds.advancing_deg);
            scene.caps.receding = 0;
            Caps caps;
            caps.load(scene);
            caps.release(1e-9);
            for (double time = 0, dt = 1e-4; time < duration; dt = std::min({1.2 * dt, 0.05, std::max(1e-6, duration - time)})) {
                caps.spread(time += dt, dt);
                for (const FrameCap& cap : caps.shown(time))
                    QVERIFY2(std::max(std::abs(cap.x), std::abs(cap.y)) + cap.base <= 10e-3,
                             qPrintable(QString("%1 degrees, %2 s, at %3 and %4 mm, base %5 mm, %6 µl")
                                            .arg(bounds.advancing_deg)
                                            .arg(time)
                                            .arg(1e3 * cap.x)
                                            .arg(1e3 * cap.y)
                                            .arg(1e3 * cap.base)
                                            .arg(1e9 * cap.volume)));
            }
        }
        QVERIFY2(allowed > 60 && small_angles > 20, qPrintable(QString("%1, %2").arg(allowed).arg(small_angles)));
    }
    /// 10 ul on 120 degrees: half a wetted cloth's face would take it at a fifth of this rate.
    void aCapThatNothingAbsorbsDriesByDiffusion()
    {
        const Scene scene = scene_of(repellent(120), drops_on_sample({drop_at(0, 0, 10)}, 30), {}, {{"vapour", true}, {"heat", false}});
        const std::unique_ptr<Backend> backend = make_cpu_backend();
        const std::vector<Frame> frames = frames_at(*backend, scene, {1, 30});
        const double gone = frames[0].ledger.water_free - frames[1].ledger.water_free;
        const ClimateParameters& c = scene.climate;
        const FrameCap& cap = frames[0].caps.at(0);
        const double weight = c.density * gravity_acceleration / c.surface_tension; // which flattens it
        const double angle = CapShapes::table().shape(cap.volume, cap.base, weight).angle;
        const double rate =
            pi * cap.base * vapour_diffusivity(c.temperature) * evaporation_factor(angle) *
            drop_in_wind(c.air_speed, 2 * cap.base / std::sin(angle), air_kinematic_viscosity / vapour_diffusivity(c.temperature)) *
            (saturation_concentration(c.temperature) - c.vapour);
        QVERIFY(gone > 0);
        QVERIFY2(std::abs(gone / (29 * rate) - 1) < 0.05, qPrintable(QString::number(gone / (29 * rate))));
        QVERIFY(std::abs(frames[1].ledger.water_imbalance()) < 1e-12 * frames[1].ledger.water_delivered);
    }
    void windTakesMoreFromACapThanStillAir()
    {
        QCOMPARE(drop_in_wind(0, 2e-3, 0.6), 1.0);
        // 5 m/s over 2.25 mm: Reynolds 745, root 27.3; the cube root of 0.61 is 0.848
        QVERIFY(std::abs(drop_in_wind(5, 2.25e-3, 0.61) - (1 + 0.276 * 27.3 * 0.848)) < 0.01);
    }
    void aCapIsAbsorbedAlikeWhereverItLies()
    {
        const Fabric fabric = of_even_yarns(library_fabric("Textile F")); // 35 threads per cm, plain: 4 ends are two repeats
        const double moved = 4 * 10.0 / 35;
        const Scene centred = scene_of(fabric, drops_on_sample({drop_at(0, 0, 5)}, 1)),
                    aside = scene_of(fabric, drops_on_sample({drop_at(moved, -moved, 5)}, 1));
        const std::unique_ptr<Backend> backend = make_cpu_backend();
        const Frame a = frames_at(*backend, centred, {0.025}).back(), b = frames_at(*backend, aside, {0.025}).back();
        QVERIFY(a.ledger.water_free > 0.05 * a.ledger.water_delivered && in_cloth(a) > 0); // under way
        QVERIFY(std::abs(in_cloth(b) / in_cloth(a) - 1) < 1e-9);
        const int end = centred.cloth.ends / 2, pick = centred.cloth.picks / 2, picks = centred.cloth.picks;
        for (int k = -2; k <= 2; ++k) {
            const double here = double(a.liquid[static_cast<std::size_t>((end + k) * picks + pick)]),
                         there = double(b.liquid[static_cast<std::size_t>((end + 4 + k) * picks + pick - 4)]);
            QVERIFY(std::abs(there - here) <= 1e-5 * here);
        }
    }
    void bundlesTakeACapInAsSingleYarnsDo()
    {
        const Experiment experiment = drops_on_sample({drop_at(0, 0, 15)}, 1);
        const Scene single = scene_of(library_fabric("Textile F"), experiment),
                    bundles = scene_of(library_fabric("Textile F"), experiment, {{"crossings_per_cell", 2}});
        QVERIFY(bundles.cloth.threads_per_cell == 2);
        const std::unique_ptr<Backend> backend = make_cpu_backend();
        const auto wet = [](const Frame& frame) { // share of the segments that hold liquid
            const auto holds = [](float liquid) { return liquid > 0; };
            return double(std::count_if(frame.liquid.begin(), frame.liquid.end(), holds)) / double(frame.liquid.size());
        };
        const std::vector<double> times{0.03, 1};
        const std::vector<Frame> a = frames_at(*backend, single, times), b = frames_at(*backend, bundles, times);
        qInfo("0.03 s: %.4f mg in single yarns, %.4f mg in bundles; 1 s: %.4f and %.4f of the cloth wet", 1e6 * in_cloth(a[0]),
              1e6 * in_cloth(b[0]), wet(a[1]), wet(b[1]));
        // A bundle's room is reached at once, so a standing drop is drawn from faster: limits.md has the size.
        QVERIFY(std::abs(b[0].ledger.water_free - a[0].ledger.water_free) < 0.15 * a[0].ledger.water_delivered);
        QVERIFY(std::abs(in_cloth(b[1]) / in_cloth(a[1]) - 1) < 0.01);
        QVERIFY(std::abs(wet(b[1]) / wet(a[1]) - 1) < 0.2);
    }
    void shapesAreYoungAndLaplaces()
    {
        const double weight = 998.2 * gravity_acceleration / 0.0727;
        for (double ul : {0.01, 0.3, 5.0, 60.0, 900.0})
            for (double degrees : {8.0, 35.0, 61.0, 90.0, 119.0, 155.0}) {
                const DropOnPlate drop = drop_of_volume(1e-9 * ul, degrees * pi / 180, weight);
                QVERIFY(std::abs(CapShapes::table().base(drop.volume, drop.contact_angle, weight) / drop.base_radius - 1) < 0.003);
                const CapShape shape = CapShapes::table().shape(drop.volume, drop.base_radius, weight);
                QVERIFY(std::abs(shape.height / drop.height - 1) < 0.01);
            }
    }
    void contactLinesAdvanceByTheCubeOfTheirAngle()
    {
        const double slow = speed_of_contact_line(0.072, 1e-3, 0.2, 0), fast = speed_of_contact_line(0.072, 1e-3, 0.4, 0);
        QVERIFY(std::abs(fast / slow - 8) < 1e-12);
        QVERIFY(std::abs(slow - 0.072 * 0.008 / (108 * 1e-3)) < 1e-12); // 5 mm/s
        QCOMPARE(speed_of_contact_line(0.072, 1e-3, 0.2, 0.3), 0.0);
    }
    void inertiaSpreadsAsTheRootOfTime()
    {
        // Without an impact the base is 1.14 (surface tension x ball / density)^(1/4) t^(1/2).
        const double ball = 1.5e-3, pace = std::sqrt(0.072 * ball / 998);
        double base = 1e-5;
        constexpr double dt = 1e-7;
        double time = base * base / (1.14 * 1.14 * pace);
        for (; time < 5e-3; time += dt) base += dt * speed_of_inertia(0.072, 998, ball, 0, base);
        QVERIFY(std::abs(base / (1.14 * std::sqrt(pace * time)) - 1) < 1e-3);
        QVERIFY(std::abs(impact_base(0.072, 1000, ball, std::sqrt(16 * 0.072 / (1000 * 2 * ball))) / ball - 2) <
                1e-12); // a Weber number of 16
    }
    void aBallsCapHasItsInverse()
    {
        for (double angle = 0.02; angle < 3.1; angle += 0.1) {
            QVERIFY(std::abs(cap_angle(cap_fullness(angle) * 8e-9, 2e-3) - angle) < 1e-9);
            QVERIFY(std::abs(cap_base(cap_fullness(angle) * 8e-9, angle) / 2e-3 - 1) < 1e-12);
        }
    }
};

QTEST_APPLESS_MAIN(TestCaps)
#include "tst_caps.moc"
