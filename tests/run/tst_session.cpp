// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is done to a scene while it runs: a drop is put over it, or its air changes.
#include "core/base/error.h"
#include "core/project/project_file.h"
#include "core/run/plan_run.h"
#include "core/run/session.h"
#include "tests/support/drop_design.h"

#include <QTest>

using namespace hygroloom;

namespace {

Scene scene_of(const Design& design, const ForcedParts& forced, const KnobSettings& knobs = {{"particles_per_droplet", 200}})
{
    const ModelPlan plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft, forced, knobs);
    return build_scene(design, build_textile(design, design.fabrics[0], plan.region), design.experiments[0], plan, 1);
}

/// One drop of 2 ul at the start.
Scene one_drop() { return scene_of(drop_design(35, 0.2), {{"vapour", true}, {"heat", true}}); }

Design wet_cloth()
{
    Design design = drop_design(35, 1);
    Experiment drying = standard_experiment(ExperimentType::drying);
    drying.sample_mm = {4, 4};
    design.experiments = {drying};
    return design;
}

void advance(Session& session, double until)
{
    while (session.advance(until) < until) {}
}

Frame frame(Session& session) { return session.take_frame().get(); }

/// Mean over the particles, m; 0 without any.
double height_of(const Frame& frame)
{
    double sum = 0;
    for (const auto& place : frame.positions) sum += place[2] / static_cast<double>(frame.positions.size());
    return sum;
}

double water(double volume, const Scene& scene) { return volume * scene.climate.density; }

} // namespace

class TestSession : public QObject {
    Q_OBJECT

    /// Water (kg) that a wet cloth loses from 5 s to 10 s in this air.
    static double loss(const std::optional<Climate>& poked)
    {
        const Design design = wet_cloth();
        const Scene scene = scene_of(design, {{"heat", false}}, {{"step_error", 1e-6}});
        const Textile textile = textile_of_run(design, design.fabrics[0], design.experiments[0]);
        const auto backend = make_cpu_backend();
        Session session(*backend, scene, 1);
        session.load();
        advance(session, 5);
        const double before = frame(session).ledger.water_evaporated;
        if (poked) session.poke(air_of(*poked, 5, textile, design.experiments[0]));
        advance(session, 10);
        const Ledger after = frame(session).ledger;
        if (std::abs(after.water_imbalance()) > 1e-12 * after.water_liquid) return -1;
        return after.water_evaporated - before;
    }

private Q_SLOTS:
    void anAbsorbedDropLeavesNoParticleAndTheLedgerSaysWhen()
    {
        Design design = drop_design(35, 1);
        design.experiments[0].closure = Closure::pores;
        const Scene scene = scene_of(design, {});
        const auto backend = make_cpu_backend();
        Session session(*backend, scene, 1);
        session.load();
        advance(session, 1);
        QCOMPARE(backend->particles(), 0); // though what was left slept
        const double until = frame(session).ledger.free_until;
        QVERIFY2(until > 0.02 && until < 0.9, qPrintable(QString::number(until)));
        const std::vector<std::byte> state = session.state();
        session.load();
        advance(session, 0.9 * until);
        QVERIFY(frame(session).ledger.water_free > 0);
        advance(session, 1.1 * until); // a stop on the way moves the steps, and with them the end of the drop
        QCOMPARE(frame(session).ledger.water_free, 0.0);
        session.go_on_from(state);
        QCOMPARE(frame(session).ledger.free_until, until);
    }
    void aPourThatIsDrawnAtOnceIsFreeLiquidUntilItEnds()
    {
        Design design = read_project(HYGROLOOM_SOURCE_DIR "/resources/examples/one-drop-on-cotton.hygro");
        Experiment pour = standard_experiment(ExperimentType::horizontal_wicking);
        pour.volume_ul = 100;
        pour.sample_mm = {40, 40};
        pour.duration_s = 8;
        design.experiments = {pour};
        const Scene scene = scene_of(design, {}, {});
        const double end = scene.supply.pools.at(0).end;
        const auto backend = make_cpu_backend();
        Session session(*backend, scene, 1);
        session.load();
        advance(session, end + 2);
        const Ledger ledger = frame(session).ledger;
        QVERIFY(ledger.water_free < 1e-9 * ledger.water_delivered);
        QVERIFY2(ledger.free_until >= end - 1e-9 && ledger.free_until < end + 1, qPrintable(QString::number(ledger.free_until)));
    }
    void aPokedDropIsDeliveredAndBalances()
    {
        const Scene scene = one_drop();
        const auto backend = make_cpu_backend();
        Session session(*backend, scene, 1);
        session.load();
        advance(session, 0.05);
        const Frame before = frame(session);
        const PutDrop put{1.5e-3, -1e-3, 0.56e-9, 0.4e-3, 0};
        session.poke(put);
        QCOMPARE(frame(session).ledger.water_delivered, before.ledger.water_delivered);
        advance(session, 0.051);
        const Frame after = frame(session);
        // To a quantum for each rounding, of which there is one a drop.
        QVERIFY(std::abs(after.ledger.water_delivered - before.ledger.water_delivered - water(put.volume, scene)) <= water_quantum);
        QVERIFY(std::abs(after.ledger.water_imbalance()) <= 1e-12 * after.ledger.water_delivered);
        const double lowest = scene.cloth.half_thickness + put.height - 0.05e-3; // it has fallen 5 um; particles fill a ball roughly
        double x = 0, y = 0;
        int falling = 0;
        for (const auto& place : after.positions) {
            if (std::hypot(place[0] - put.x, place[1] - put.y) > 0.6e-3 || place[2] < lowest) continue;
            x += place[0];
            y += place[1];
            ++falling;
        }
        QCOMPARE(falling, 56); // 0.56 ul of 2 ul, of which 200 particles were made: whole shells of a lattice about the middle
        QVERIFY(std::abs(x / falling - put.x) < 2e-6 && std::abs(y / falling - put.y) < 2e-6);
        advance(session, 0.2);
        const Ledger end = frame(session).ledger;
        QCOMPARE(end.water_delivered, after.ledger.water_delivered);
        QVERIFY(std::abs(end.water_imbalance()) <= 1e-12 * end.water_delivered);
        QVERIFY(end.water_liquid > before.ledger.water_liquid);
    }
    void aDropFallsAsABodyUntilShortlyBeforeItLands()
    {
        Scene scene = one_drop();
        SceneDroplet& drop = scene.supply.droplets.at(0); // 2 ul: 5.3 ms to find its shape
        const double height = 20e-3;
        drop.centre.z += height;
        const double bottom = drop.centre.z - std::cbrt(3 * drop.volume / (4 * pi)) - scene.cloth.half_thickness;
        const double landed = std::sqrt(2 * bottom / gravity_acceleration);
        const auto backend = make_cpu_backend();
        Session session(*backend, scene, 1);
        session.load();
        const auto fallen = [](double time) { return 0.5 * gravity_acceleration * time * time; };
        advance(session, 1e-3);
        const double middle = height_of(frame(session)) + fallen(1e-3);
        for (const double share : {0.3, 0.5}) {
            advance(session, share * landed);
            const Frame flying = frame(session);
            QCOMPARE(backend->liquid_steps(), 0L);
            QCOMPARE(flying.positions.size(), std::size_t{200});
            const double expected = middle - fallen(share * landed);
            QVERIFY2(std::abs(height_of(flying) - expected) < 1e-6, qPrintable(QString::number(height_of(flying) - expected)));
            QVERIFY(std::abs(flying.velocities[7][2] + gravity_acceleration * share * landed) < 1e-6);
            QCOMPARE(flying.ledger.water_free, flying.ledger.water_delivered);
        }
        advance(session, landed);
        QVERIFY(backend->liquid_steps() > 0);
        QVERIFY(std::abs(height_of(frame(session)) - (middle - fallen(landed))) < 0.05e-3);
        advance(session, landed + 0.1);
        const Ledger end = frame(session).ledger;
        QVERIFY(end.water_liquid > 0 && std::abs(end.water_imbalance()) <= 1e-12 * end.water_delivered);
    }
    void dropsThatMeetInTheAirAreFollowed()
    {
        for (const double later : {0.0, 5e-3}) { // side by side, and a faster one after it
            Scene scene = one_drop();
            SceneDroplet first = scene.supply.droplets.at(0);
            first.centre.z += 20e-3;
            SceneDroplet second = first;
            second.time = later;
            if (later > 0) {
                second.speed = 2;
            } else {
                second.centre.x += 3e-3;
            }
            scene.supply.droplets = {first, second};
            const auto backend = make_cpu_backend();
            Session session(*backend, scene, 1);
            session.load();
            advance(session, 7e-3);
            QCOMPARE(backend->liquid_steps() > 0, later > 0);
            advance(session, 0.1);
            const Ledger end = frame(session).ledger;
            QVERIFY(end.water_liquid > 0 && std::abs(end.water_imbalance()) <= 1e-12 * end.water_delivered);
        }
    }
    void dropsMayBePutWhereNoneWasPlanned()
    {
        Scene scene = one_drop();
        scene.supply.droplets.clear();
        const auto backend = make_cpu_backend();
        Session session(*backend, scene, 1);
        session.load();
        advance(session, 0.01);
        QCOMPARE(frame(session).ledger.water_delivered, 0.0);
        double put = 0;
        for (double volume : {0.5e-9, 1e-9}) {
            session.poke(PutDrop{0, 0, volume, 0.3e-3, 0});
            put += water(volume, scene);
            advance(session, put < water(1e-9, scene) ? 0.03 : 0.05);
            const Ledger now = frame(session).ledger;
            QVERIFY(std::abs(now.water_delivered - put) <= 2 * water_quantum);
            QVERIFY(std::abs(now.water_imbalance()) <= 1e-12 * now.water_delivered);
        }
    }
    void aDropThatCannotBeIsRefused()
    {
        const auto backend = make_cpu_backend();
        Session dry(*backend, scene_of(wet_cloth(), {}), 1);
        QVERIFY_EXCEPTION_THROWN(dry.poke(PutDrop{0, 0, 1e-9, 0, 0}), Error);
        Session wet(*backend, one_drop(), 1);
        QVERIFY_EXCEPTION_THROWN(wet.poke(PutDrop{}), Error);
    }
    /// Wet cloth of the air's temperature loses water with the air's lack of it: 1 - humidity.
    void pokedAirDriesAsItsHumiditySays()
    {
        const Climate as_it_was = wet_cloth().experiments[0].climate;
        Climate drier = as_it_was, damp = as_it_was;
        drier.relative_humidity = 0.5 * as_it_was.relative_humidity;
        damp.relative_humidity = 1;
        const double unpoked = loss({}), same = loss(as_it_was), dry = loss(drier), none = loss(damp);
        QVERIFY(unpoked > 0);
        QVERIFY2(std::abs(same / unpoked - 1) < 1e-3, qPrintable(QString::number(same / unpoked, 'g', 10)));
        const double expected = (1 - drier.relative_humidity) / (1 - as_it_was.relative_humidity);
        QVERIFY2(std::abs(dry / unpoked / expected - 1) < 1e-3, qPrintable(QString("%1, expected %2").arg(dry / unpoked).arg(expected)));
        QVERIFY2(std::abs(none) < 1e-3 * unpoked, qPrintable(QString::number(none / unpoked)));
    }
    void airMayChangeTwiceAtOneTime()
    {
        Scene scene = one_drop();
        const auto backend = make_cpu_backend();
        Session session(*backend, scene, 1);
        session.load();
        advance(session, 0.02);
        AirMoment warm = air_at(scene.climate, 0), cool = warm;
        warm.air_warmth = 20;
        cool.air_warmth = -5;
        session.poke(warm);
        session.poke(cool);
        QCOMPARE(air_at(session.scene().climate, 0.02).air_warmth, -5.0);
        QCOMPARE(air_at(session.scene().climate, 0.01).air_warmth, 0.0);
        advance(session, 0.03);
        QVERIFY(frame(session).ledger.water_delivered > 0);
    }
};

QTEST_GUILESS_MAIN(TestSession)
#include "tst_session.moc"
