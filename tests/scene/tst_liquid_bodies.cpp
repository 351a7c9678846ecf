// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Free liquid that no particles stand for is shown all the same: pools, caps, and drops before they arrive. By hand-worked numbers.
#include "core/geometry/textile.h"
#include "core/scene/liquid_bodies.h"

#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace {

constexpr double face = 0.3e-3; // m
constexpr double ul = 1e-9;     // m3

Experiment feed(double volume_ul, double drop_ul)
{
    Experiment experiment;
    experiment.type = ExperimentType::moisture_management;
    experiment.volume_ul = volume_ul;
    experiment.drop_ul = drop_ul;
    return experiment;
}

Frame standing(double volume_ul)
{
    Frame frame;
    frame.ledger.water_free = 1e-6 * volume_ul; // kg
    return frame;
}

bool near(double value, double wanted, double share = 1e-3) { return std::abs(value - wanted) <= share * std::abs(wanted); }

} // namespace

class TestLiquidBodies : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aPoolIsAHalfBallOnTheTopFace()
    {
        const auto bodies = liquid_bodies(standing(200), feed(200, 25), face);
        QCOMPARE(bodies.size(), std::size_t(1));
        QVERIFY(near(bodies[0].base, 4.571e-3)); // (3 x 200 mm3 / 2 pi)^(1/3)
        QVERIFY(near(bodies[0].height, bodies[0].base));
        QCOMPARE(bodies[0].face, face);
        QVERIFY(near(bodies[0].volume, 200 * ul));
    }

    void theRestOfAPoolStillCoversItsFirstDropsBase()
    {
        const auto bodies = liquid_bodies(standing(1), feed(200, 25), face);
        QCOMPARE(bodies.size(), std::size_t(1));
        const double a = bodies[0].base, h = bodies[0].height;
        QVERIFY(near(a, 2.285e-3)); // of 25 mm3
        QVERIFY(h < 0.1 * a);
        QVERIFY(near(M_PI * h * (3 * a * a + h * h) / 6, 1 * ul));
    }

    void withoutFreeWaterNothingIsShown() { QVERIFY(liquid_bodies(standing(0), feed(200, 25), face).empty()); }

    void particlesAndCapsNeedNoPool()
    {
        Frame frame = standing(10);
        frame.positions.push_back({0, 0, 0});
        QVERIFY(liquid_bodies(frame, feed(200, 25), face).empty());
        frame.positions.clear();
        frame.caps.push_back({1e-3, 2e-3, 1.5e-3, face, 0.4e-3, 2 * ul});
        const auto bodies = liquid_bodies(frame, feed(200, 25), face);
        QCOMPARE(bodies.size(), std::size_t(1));
        QCOMPARE(bodies[0].x, 1e-3);
    }

    void aDropFallsBeforeItAppears()
    {
        Experiment experiment;
        experiment.droplets = {Droplet{15, 2.0, {1, -2}, 2, 0.5}};
        Frame frame;
        frame.time = 1.99;
        const auto bodies = liquid_bodies(frame, experiment, face);
        QCOMPARE(bodies.size(), std::size_t(1));
        QCOMPARE(bodies[0].base, 0.0);
        QVERIFY(near(bodies[0].x, 1e-3) && near(bodies[0].y, -2e-3));
        QVERIFY(near(bodies[0].height, 2e-3 + 4.510e-3 + 3.060e-3)); // 0.5 x 0.01 - 9.807 x 0.01^2 / 2 higher, and 15 mm3 across
        frame.time = 1.0;
        QVERIFY(liquid_bodies(frame, experiment, face).empty());
    }

    void aDropThatHangsIsWhereItsSpeedComesFrom()
    {
        Experiment experiment;
        experiment.droplets = {Droplet{15, 2.0, {0, 0}, 2, 0.5}};
        Frame frame;
        frame.time = 1.6;
        const auto bodies = liquid_bodies(frame, experiment, face);
        QCOMPARE(bodies.size(), std::size_t(1));
        QVERIFY(near(bodies[0].height, 2e-3 + 12.746e-3 + 3.060e-3)); // 0.5^2 / (2 x 9.807) m
    }

    void aDropThatCameIsNotShownTwice()
    {
        Experiment experiment;
        Frame frame;
        QCOMPARE(liquid_bodies(frame, experiment, face).size(), std::size_t(1));
        frame.ledger.water_delivered = 15e-6;
        QVERIFY(liquid_bodies(frame, experiment, face).empty());
    }
};

QTEST_APPLESS_MAIN(TestLiquidBodies)
#include "tst_liquid_bodies.moc"
