// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The free liquid: drops in the air and over cloth, balances, and that nothing passes through yarn.
#include "core/base/random.h"
#include "core/solver/cpu_solver.h"
#include "core/solver/steps/contact.h"
#include "tests/solver/plate.h"

#include <QTest>

#include <algorithm>

using namespace hygroloom;

namespace {

/// Water on a plate, a little off its lattice: a column in a box, or half a ball that lies free.
Scene water_in_vessel(bool box)
{
    constexpr double spacing = 2e-4, plate = 5e-3, half = 1e-3; // m
    Scene scene = bare_scene(1, 1, 2e-3, 293.15);
    scene.rules.network_step = scene.rules.calm_network_step = 1;
    scene.rules.step_share = 0;
    for (int k = 0; k < (box ? 20 : 5); ++k)
        for (int j = -5; j < 5; ++j)
            for (int i = -5; i < 5; ++i) {
                const auto number = static_cast<std::uint64_t>(scene.liquid.places.size());
                const auto off = [&](std::uint64_t axis) { return 0.3 * (random_uniform(3, axis, number) - 0.5); };
                const Vec3d place = spacing * Vec3d{i + 0.5 + off(0), j + 0.5 + off(1), k + 0.5 + off(2)};
                if (box || length(place) < half) scene.liquid.places.push_back(place + Vec3d{0, 0, plate});
            }
    scene.liquid.velocities.assign(scene.liquid.places.size(), Vec3d{});
    scene.liquid.particle_volume = spacing * spacing * spacing;
    scene.liquid.vessel = SceneVessel{{-half, -half, plate}, {half, half, 1}, scene.climate.surface_tension};
    if (!box) scene.liquid.vessel->low.x = scene.liquid.vessel->low.y = -(scene.liquid.vessel->high.x = scene.liquid.vessel->high.y = 1);
    return scene;
}

/// How far any particle of a frame is from the nearest of another one, which may have them in another order, and how differently both
/// move; m, m/s.
std::pair<double, double> greatest_differences(const Frame& a, const Frame& b)
{
    const auto vector = [](const std::array<float, 3>& v) { return Vec3d{v[0], v[1], v[2]}; };
    double farthest = 0, fastest = 0;
    for (std::size_t i = 0; i < a.positions.size(); ++i) {
        const auto far_from = [&](std::size_t j) { return length(vector(a.positions[i]) - vector(b.positions[j])); };
        std::size_t nearest = 0;
        for (std::size_t j = 1; j < b.positions.size(); ++j)
            if (far_from(j) < far_from(nearest)) nearest = j;
        farthest = std::max(farthest, far_from(nearest));
        fastest = std::max(fastest, length(vector(a.velocities[i]) - vector(b.velocities[nearest])));
    }
    return {farthest, fastest};
}

} // namespace

class TestLiquid : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void nearlyAbsorbedParticlesDoNotKeepADropAwakeButADripDoes()
    {
        Vec3 velocity[3] = {{Real(0.1), 0, 0}, {0, 0, Real(-0.3)}, {1, 0, 0}}; // full, nearly absorbed, dead
        std::int64_t content[3] = {1000, 20, 1000};
        std::uint8_t alive[3] = {1, 1, 0};
        ClothField cloth[3];
        Particles p;
        p.velocity = velocity;
        p.content = content;
        p.alive = alive;
        p.cloth = cloth;
        p.per_quantum = Real(1e-3);
        int largest = 0;
        const SumSpeeds speeds{p, nullptr, &largest};
        const auto square = [&](int i) { return static_cast<double>(speeds(i)) * SumSpeeds::quantum; };
        for (ClothField& c : cloth) c.surface_share = Real(0.1); // at the cloth
        QVERIFY(std::abs(square(0) - 0.01) < 1e-8);
        QVERIFY(std::abs(square(1) - 0.02 * 0.09) < 1e-8);
        QCOMPARE(square(2), 0.0);
        QCOMPARE(largest, 0);
        cloth[1].surface_share = 0; // a drip
        square(1);
        QVERIFY(std::abs(from_ordered_bits(largest) - 0.09f) < 1e-7f);
    }
    void aFallingDropKeepsItsLists()
    {
        CpuSolver solver;
        solver.load(drop_over_plate(5e-9, 100e-3, 0, 800)); // steps begin after 0.1 s
        for (double time = 0; time < 0.12;) time = solver.advance(0.12, 1e9);
        const long steps = solver.liquid_steps(), listings = solver.listings();
        QVERIFY(steps > 0);
        for (double time = 0.12; time < 0.14;) time = solver.advance(0.14, 1e9);
        QVERIFY2(2 * (solver.listings() - listings) < solver.liquid_steps() - steps,
                 qPrintable(QString::number(solver.listings() - listings)));
    }
    void nothingDependsOnThreadsOrOnFramesTaken()
    {
        Scene scene = drop_over_plate(1e-9, 0.2e-3, 0.5, 300);
        for (YarnParameters& yarn : scene.cloth.yarns) { // so that yarns absorb some
            yarn.pore_area = 5e-8;
            yarn.absorbs = true;
            yarn.intake_flux = 100;
            yarn.face_area = 1e-7;
        }
        std::vector<Frame> ends;
        for (int threads : {1, 2})
            for (bool takes_frames : {false, true}) {
                const auto backend = make_cpu_backend();
                backend->set_threads(threads);
                backend->load(scene);
                for (int k = 1; k <= 40; ++k) {
                    const double until = 2.5e-4 * k;
                    while (backend->advance(until) < until) {}
                    if (takes_frames) backend->frame();
                }
                ends.push_back(backend->frame());
            }
        QVERIFY(ends[0].positions.size() < 300);
        for (const Frame& end : ends) {
            QVERIFY(!end.positions.empty());
            QVERIFY(end.positions == ends[0].positions);
            QVERIFY(end.velocities == ends[0].velocities);
            QVERIFY(end.liquid == ends[0].liquid);
            QCOMPARE(end.ledger.water_free, ends[0].ledger.water_free);
        }
    }
    void whatAVesselHoldsGoesOnWhereItWasTaken_data()
    {
        QTest::addColumn<bool>("box");
        QTest::newRow("column") << true;
        QTest::newRow("drop on a plate") << false;
    }
    /// Without what its walls stand for, particles at them would be off by 3 um after 0.1 ms and by 0.1 mm after 10 ms; rounding, in
    /// another order of neighbours, moves them by 0.1 um.
    void whatAVesselHoldsGoesOnWhereItWasTaken()
    {
        QFETCH(bool, box);
        const Scene scene = water_in_vessel(box);
        CpuSolver whole, resumed;
        const auto advance = [](CpuSolver& solver, double until) {
            while (solver.advance(until, 10) < until) {}
        };
        whole.load(scene);
        advance(whole, 0.01);
        resumed.load(scene);
        resumed.go_on_from(whole.state());
        for (double until : {0.0101, 0.011, 0.02}) {
            advance(whole, until);
            advance(resumed, until);
            QCOMPARE(resumed.liquid_steps(), whole.liquid_steps());
            const auto [farthest, fastest] = greatest_differences(whole.frame(), resumed.frame());
            QVERIFY2(farthest < 1e-6, qPrintable(QString("%1 m at %2 s").arg(farthest).arg(until)));
            QVERIFY2(fastest < 1e-3, qPrintable(QString("%1 m/s at %2 s").arg(fastest).arg(until)));
        }
    }
    void aDropInTheAirFallsWithoutDrifting()
    {
        const auto backend = make_cpu_backend();
        Scene scene = drop_over_plate(5e-9, 20e-3, 0, 800);
        const std::vector<Frame> frames = frames_at(*backend, scene, {1e-3, 0.03});
        Vec3d middle, speed;
        for (std::size_t i = 0; i < frames[1].positions.size(); ++i) {
            const auto& x = frames[1].positions[i];
            const auto& v = frames[1].velocities[i];
            middle += (1.0 / 800) * Vec3d{x[0], x[1], x[2]};
            speed += (1.0 / 800) * Vec3d{v[0], v[1], v[2]};
        }
        const double fallen = scene.supply.droplets[0].centre.z - middle.z;
        QCOMPARE(int(frames[1].positions.size()), 800);
        QVERIFY2(std::abs(fallen - 0.5 * 9.80665 * 0.03 * 0.03) < 0.02 * fallen,
                 qPrintable(QString("%1 m, %2 m/s").arg(fallen).arg(speed.z)));
        QVERIFY(std::abs(speed.z + 9.80665 * 0.03) < 0.01 * 9.80665 * 0.03);
        QVERIFY(std::hypot(speed.x, speed.y) < 1e-3);
    }
    void aSliverOfAStepKicksNothing()
    {
        const auto backend = make_cpu_backend();
        const double whole = 5e-3;
        for (double sliver : {1e-18, 1e-12, 1e-10, 1e-8, 1e-6}) { // as a drop's time and a frame's may differ
            const double later = whole + sliver;
            const std::vector<Frame> frames = frames_at(*backend, drop_over_plate(5e-9, 2e-3, 0, 800), {whole, later, later + 1e-3});
            const auto fastest = [](const Frame& frame) {
                double most = 0;
                for (const auto& v : frame.velocities) most = std::max(most, std::hypot(double(v[0]), double(v[1])));
                return most;
            };
            for (const Frame& frame : frames) QVERIFY2(fastest(frame) < fastest(frames[0]) + 0.02, qPrintable(QString::number(sliver)));
        }
    }
    void aDropInTheAirStaysRoundAndComesToRest()
    {
        const auto backend = make_cpu_backend();
        const Frame frame = frames_at(*backend, drop_over_plate(5e-9, 100e-3, 0, 800), {0.14}).back(); // it lands at 0.143
        Vec3d middle, speed;
        for (std::size_t i = 0; i < 800; ++i) {
            middle += (1.0 / 800) * Vec3d{frame.positions[i][0], frame.positions[i][1], frame.positions[i][2]};
            speed += (1.0 / 800) * Vec3d{frame.velocities[i][0], frame.velocities[i][1], frame.velocities[i][2]};
        }
        double farthest = 0, agitation = 0;
        for (std::size_t i = 0; i < 800; ++i) {
            farthest = std::max(farthest, length(Vec3d{frame.positions[i][0], frame.positions[i][1], frame.positions[i][2]} - middle));
            const Vec3d v = Vec3d{frame.velocities[i][0], frame.velocities[i][1], frame.velocities[i][2]} - speed;
            agitation += dot(v, v) / 800;
        }
        QVERIFY(farthest < 1.15 * std::cbrt(3 * 5e-9 / (4 * pi)));
        QVERIFY2(std::sqrt(agitation) < 0.03, qPrintable(QString::number(std::sqrt(agitation))));
    }
    /// Neighbours slow each other down, they must not throw each other about.
    void aStickyDropComesToRestWithoutSpeedingUp()
    {
        const auto backend = make_cpu_backend();
        Scene scene = drop_over_plate(1e-10, 0, 1, 300);
        scene.climate.viscosity = 0.5;
        double fastest = 0;
        for (const Frame& frame : frames_at(*backend, scene, {1e-5, 3e-5, 1e-4, 3e-4, 1e-3})) {
            fastest = 0;
            for (const auto& v : frame.velocities) fastest = std::max(fastest, std::hypot(double(v[0]), double(v[1]), double(v[2])));
            QVERIFY2(fastest < 2 * scene.supply.droplets[0].speed, qPrintable(QString("%1 m/s at %2 s").arg(fastest).arg(frame.time)));
        }
        QVERIFY2(fastest < 0.2, qPrintable(QString::number(fastest)));
    }
    void noParticlePassesThroughClosedCloth_data()
    {
        QTest::addColumn<double>("speed");
        QTest::addColumn<std::vector<double>>("half_heights");
        for (double speed : {0.0, 1.0, 5.0, 10.0}) {
            QTest::addRow("%g m/s", speed) << speed << std::vector<double>{5e-5};
            QTest::addRow("%g m/s, thick and thin yarns", speed) << speed << std::vector<double>{5e-5, 2.5e-5, 4e-5};
        }
    }
    void noParticlePassesThroughClosedCloth()
    {
        QFETCH(double, speed);
        QFETCH(std::vector<double>, half_heights);
        const auto backend = make_cpu_backend();
        const Frame frame = frames_at(*backend, drop_over_plate(1e-9, 0.5e-3, speed, 300, half_heights), {0.01}).back();
        for (const auto& x : frame.positions) // those far from its edge, past which they may be thrown and cling to the other face
            if (std::abs(x[0]) < 7e-3f && std::abs(x[1]) < 7e-3f) QVERIFY2(x[2] > 0, qPrintable(QString::number(double(x[2]))));
        QCOMPARE(frame.ledger.water_delivered, frame.ledger.water_free + frame.ledger.water_dripped);
    }
};

QTEST_APPLESS_MAIN(TestLiquid)
#include "tst_liquid.moc"
