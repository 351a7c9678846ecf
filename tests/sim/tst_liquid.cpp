// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The free liquid: neighbours against brute force, balances, and that nothing passes through yarn.
#include "core/base/random.h"
#include "core/sim/cpu_executor.h"
#include "core/sim/solver.h"
#include "core/verify/set_ups.h"

#include <QTest>

using namespace hygroloom;

namespace {

Scene drop_over_plate(double volume, double height, double speed, int particles)
{
    Scene scene = bare_scene(24, 24, 3e-4, 293.15);
    scene.half_thickness = 1e-4;
    for (ContactShape* shape : {&scene.warp_shape, &scene.weft_shape}) {
        shape->amplitude = 5e-5;
        shape->half_height = 5e-5;
        shape->half_width = 1.47e-4;
        shape->profile = {5e-5f, 0, 5e-5f, 1.47e-4f, -5e-5f, 0, 5e-5f, 1.47e-4f};
    }
    const double radius = std::cbrt(3 * volume / (4 * pi));
    scene.droplets.push_back({0, volume, {0, 0, scene.half_thickness + height + radius}, speed});
    scene.particles_per_droplet = particles;
    return scene;
}

} // namespace

class TestLiquid : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void neighboursAreThoseABruteSearchFinds()
    {
        constexpr int n = 500;
        std::vector<Vec3> x;
        for (int i = 0; i < n; ++i)
            x.push_back({Real(random_uniform(1, 0, std::uint64_t(i))), Real(random_uniform(1, 1, std::uint64_t(i))), Real(random_uniform(1, 2, std::uint64_t(i)))});
        CellGrid grid;
        grid.size = Real(0.2);
        grid.nx = grid.ny = grid.nz = 5;
        CpuExecutor exec;
        CpuExecutor::Buffer<int> key, order;
        key.resize(n);
        order.resize(n);
        std::vector<int> start(static_cast<std::size_t>(grid.cells()) + 2);
        std::vector<std::uint8_t> alive(n, 1);
        grid.key = key.data();
        grid.start = start.data();
        Particles p;
        p.count = n;
        p.support = Real(0.2);
        p.position = x.data();
        p.alive = alive.data();
        exec.for_each("cell", n, FindCell{p, grid});
        exec.sort_by_key(key, order, n, grid.cells());
        std::vector<Vec3> sorted;
        for (int i = 0; i < n; ++i) sorted.push_back(x[static_cast<std::size_t>(order.read(static_cast<std::size_t>(i)))]);
        p.position = sorted.data();
        exec.for_each("starts", n + 1, FindCellStarts{grid, n});
        std::vector<int> neighbours(n * largest_neighbour_count), counts(n);
        p.neighbours = neighbours.data();
        p.neighbour_count = counts.data();
        exec.for_each("neighbours", n, FindNeighbours{p, grid});
        for (int i = 0; i < n; ++i) {
            int expected = 0;
            for (int j = 0; j < n; ++j) {
                const Vec3 d = sorted[static_cast<std::size_t>(i)] - sorted[static_cast<std::size_t>(j)];
                expected += j != i && dot(d, d) < p.support * p.support;
            }
            QCOMPARE(counts[static_cast<std::size_t>(i)], expected);
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
        const double fallen = scene.droplets[0].centre.z - middle.z;
        QCOMPARE(int(frames[1].positions.size()), 800);
        QVERIFY(std::abs(fallen - 0.5 * 9.80665 * 0.03 * 0.03) < 0.02 * fallen);
        QVERIFY(std::abs(speed.z + 9.80665 * 0.03) < 0.01 * 9.80665 * 0.03);
        QVERIFY(std::hypot(speed.x, speed.y) < 1e-3);
    }
    void aDropInTheAirStaysRoundAndComesToRest()
    {
        const auto backend = make_cpu_backend();
        const Frame frame = frames_at(*backend, drop_over_plate(5e-9, 20e-3, 0, 800), {0.04}).back();
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
    void noParticlePassesThroughClosedCloth_data()
    {
        QTest::addColumn<double>("speed");
        for (double speed : {0.0, 1.0, 5.0, 10.0}) QTest::addRow("%g m/s", speed) << speed;
    }
    void noParticlePassesThroughClosedCloth()
    {
        QFETCH(double, speed);
        const auto backend = make_cpu_backend();
        const Frame frame = frames_at(*backend, drop_over_plate(1e-9, 0.5e-3, speed, 300), {0.01}).back();
        for (const auto& x : frame.positions) // those over the cloth; thrown sideways they may fall past its edge
            if (std::abs(x[0]) < 3.3e-3f && std::abs(x[1]) < 3.3e-3f) QVERIFY2(x[2] > 0, qPrintable(QString::number(double(x[2]))));
        QCOMPARE(frame.ledger.water_delivered, frame.ledger.water_free + frame.ledger.water_dripped);
    }
    void skinIsFoundOnTheSideOneIsOn()
    {
        const Scene scene = drop_over_plate(1e-9, 1e-3, 0, 10);
        const std::vector<float> unshifted(static_cast<std::size_t>(scene.segments()), 0.0f);
        TextileShape shape{scene.ends, scene.picks, Real(1e-4), {}, {}, scene.warp_up.data(), unshifted.data()};
        for (auto [from, to] : {std::pair{&scene.warp_shape, &shape.warp}, std::pair{&scene.weft_shape, &shape.weft}})
            *to = {Real(from->pitch), Real(from->amplitude), Real(from->half_height), Real(from->half_width), from->samples, from->profile.data()};
        const NearestSkin above = nearest_skin(shape, {Real(1.5e-4), Real(1.5e-4), Real(1.8e-4)}, Real(2e-4));
        QVERIFY(above.segment >= 0);
        QVERIFY(above.normal.z > Real(0.9));
        QVERIFY(std::abs(above.distance - Real(0.8e-4)) < Real(1e-6));
        QCOMPARE(nearest_skin(shape, {0, 0, Real(1e-2)}, Real(2e-4)).segment, -1);
        QCOMPARE(nearest_skin(shape, {Real(1), 0, 0}, Real(2e-4)).segment, -1);
    }
};

QTEST_APPLESS_MAIN(TestLiquid)
#include "tst_liquid.moc"
