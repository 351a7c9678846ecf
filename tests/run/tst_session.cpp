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

/// Two drops that stand as caps on a cloth, the second after 0.35 s.
Scene two_caps()
{
    Design design = drop_design(35, 2);
    design.experiments[0].closure = Closure::pores;
    design.experiments[0].sample_mm = {16, 16};
    design.experiments[0].droplets = {Droplet{2, 0, {-1, 0.5}, 0.5, 0}, Droplet{1.5, 0.35, {2, -1}, 2, 0}};
    const ModelPlan plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::live, {{"vapour", true}, {"heat", true}});
    return build_scene(design, build_textile(design, design.fabrics[0], plan.region), design.experiments[0], plan, 1);
}

/// m, along the warp: middle of the liquid in the yarns.
double middle_of_liquid(const Frame& frame, const Cloth& cloth)
{
    double sum = 0, all = 0;
    for (int end = 0; end < cloth.ends; ++end)
        for (int pick = 0; pick < cloth.picks; ++pick) {
            const double here = static_cast<double>(frame.liquid[static_cast<std::size_t>(end * cloth.picks + pick)]);
            sum += here * pick * cloth.weft_pitch;
            all += here;
        }
    return sum / all;
}

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
        Session session(*backend, scene, {1});
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
        Session session(*backend, scene, {1});
        session.load();
        advance(session, 1);
        QCOMPARE(backend->particles(), 0); // though what was left slept
        const double until = frame(session).ledger.free_until;
        QVERIFY2(until > 0.02 && until < 0.9, qPrintable(QString::number(until)));
        const std::vector<std::byte> state = session.state();
        session.load();
        advance(session, 0.9 * until);
        QVERIFY(frame(session).ledger.water_free > 0);
        advance(session, 1.5 * until); // a stop on the way moves the steps, and with them the end of the drop
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
        Session session(*backend, scene, {1});
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
        Session session(*backend, scene, {1});
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
        Session session(*backend, scene, {1});
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
            Session session(*backend, scene, {1});
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
        Session session(*backend, scene, {1});
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
    void aPokedCapIsThatOfAnExperiment()
    {
        const Scene planned = two_caps();
        QVERIFY(planned.caps.on);
        const SceneDroplet second = planned.supply.droplets.at(1);
        Scene without = planned;
        without.supply.droplets.pop_back();
        const auto one = make_cpu_backend(), other = make_cpu_backend();
        Session from_start(*one, planned, {1}), poked(*other, without, {1});
        from_start.load();
        poked.load();
        advance(from_start, second.time);
        advance(poked, second.time);
        const double ball = std::cbrt(3 * second.volume / (4 * pi));
        poked.poke(PutDrop{second.centre.x, second.centre.y, second.volume, second.centre.z - ball - planned.cloth.half_thickness, 0});
        const double before = frame(poked).ledger.water_delivered;
        for (const double time : {0.36, 0.5, 1.3}) {
            advance(from_start, time);
            advance(poked, time);
        }
        const Ledger a = frame(from_start).ledger, b = frame(poked).ledger;
        QVERIFY(std::abs(b.water_delivered - before - water(second.volume, planned)) <= water_quantum);
        QVERIFY2(std::abs(b.water_imbalance()) <= 1e-12 * b.water_delivered, qPrintable(QString::number(b.water_imbalance())));
        QVERIFY(b.water_liquid > 0 && b.water_bound > 0 && b.water_evaporated > 0);
        for (const LedgerColumn& column : ledger_columns)
            QVERIFY2(a.*column.value == b.*column.value,
                     qPrintable(QString("%1: %2 and %3").arg(column.name).arg(a.*column.value).arg(b.*column.value)));
        QVERIFY(from_start.state() == poked.state()); // to the last byte
    }
    void manyPokesLoseNoWater()
    {
        Scene scene = two_caps();
        const Climate dry{40, 0.2, 2};
        scene.supply.droplets.clear();
        const Design design = drop_design(35, 2);
        const Textile textile = textile_of_run(design, design.fabrics[0], design.experiments[0]);
        const auto backend = make_cpu_backend();
        Session session(*backend, scene, {1});
        session.load();
        double put = 0;
        for (int k = 0; k < 12; ++k) {
            advance(session, 0.1 * (k + 1));
            if (k % 4 == 3)
                session.poke(air_of(dry, 0.1 * (k + 1), textile, design.experiments[0]));
            else if (k % 4 == 2)
                session.poke(Tilt{k % 8 == 2 ? 5.0 : -5.0, 1.0});
            else {
                session.poke(PutDrop{1e-3 * (k - 6), 0.5e-3 * (6 - k), 1e-9, 1e-3, 0});
                put += water(1e-9, scene);
            }
        }
        advance(session, 1.5);
        const Ledger ledger = frame(session).ledger;
        QVERIFY(std::abs(ledger.water_delivered - put) <= 12 * water_quantum);
        QVERIFY2(std::abs(ledger.water_imbalance()) <= 1e-12 * ledger.water_delivered,
                 qPrintable(QString::number(ledger.water_imbalance())));
    }
    /// Its own weight many times over, as in a centrifuge, so that a second suffices.
    void onATiltedClothLiquidGoesDown()
    {
        const auto after = [](double pull) {
            Scene scene = two_caps();
            scene.supply.droplets.resize(1);
            const auto backend = make_cpu_backend();
            Session session(*backend, scene, {1});
            session.load();
            advance(session, 0.2);
            session.poke(Tilt{pull, 0});
            advance(session, 1.2);
            const Frame end = frame(session);
            return std::pair(middle_of_liquid(end, scene.cloth), end.ledger.water_imbalance() / end.ledger.water_delivered);
        };
        const auto [flat, none] = after(0);
        const auto [down, lost] = after(1000);
        const auto [up, gained] = after(-1000);
        QVERIFY2(down < flat - 1e-5 && up > flat + 1e-5, qPrintable(QString("%1 %2 %3").arg(down).arg(flat).arg(up)));
        QVERIFY(std::abs(none) < 1e-12 && std::abs(lost) < 1e-12 && std::abs(gained) < 1e-12);
    }
    void aDropThatCannotBeIsRefused()
    {
        const auto backend = make_cpu_backend();
        Session dry(*backend, scene_of(wet_cloth(), {}), {1});
        QVERIFY_EXCEPTION_THROWN(dry.poke(PutDrop{0, 0, 1e-9, 0, 0}), Error);
        Session wet(*backend, one_drop(), {1});
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
        Session session(*backend, scene, {1});
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
