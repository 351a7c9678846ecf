// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Drops at rest on a plate against caps of balls, the balance of forces and puddles.
#include "core/base/units.h"
#include "core/solver/drop_shapes.h"

#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace {

bool near(double value, double expected, double share) { return std::abs(value - expected) <= share * std::abs(expected); }

constexpr double water = 998.2 * 9.80665 / 0.07274; // 1/m2, density x gravity / surface tension

} // namespace

class TestDropShapes : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void withoutWeightItIsACap_data()
    {
        QTest::addColumn<double>("angle");
        for (double angle : {1.0, 30.0, 60.0, 90.0, 120.0, 150.0, 179.0}) QTest::addRow("%g degrees", angle) << angle;
    }
    void withoutWeightItIsACap()
    {
        QFETCH(double, angle);
        const double theta = radian_from_degree(angle), c = std::cos(theta), volume = 5e-9;
        const DropOnPlate drop = drop_of_volume(volume, theta, 0);
        const double base = std::sin(theta) * std::cbrt(3.0 * volume / (pi * (2.0 - 3.0 * c + c * c * c)));
        QVERIFY(near(drop.volume, volume, 1e-6));
        QVERIFY(near(drop.base_radius, base, 1e-5));
        QVERIFY(near(drop.height, base * std::tan(0.5 * theta), 1e-5));
    }
    void halfABallHasItsMoments()
    {
        const DropOnPlate half = drop_of_top(1e3, 0.5 * pi, 0); // 1 mm
        QVERIFY(near(half.middle, 0.375e-3, 1e-6));
        QVERIFY(near(half.square, 0.4e-6, 1e-6));
    }
    void theBaseBearsTheWeight_data()
    {
        QTest::addColumn<double>("angle");
        QTest::addColumn<double>("volume_ul");
        for (double angle : {20.0, 60.0, 90.0, 135.0, 175.0})
            for (double volume : {0.1, 5.0, 50.0, 2000.0}) QTest::addRow("%g ul at %g degrees", volume, angle) << angle << volume;
    }
    void theBaseBearsTheWeight()
    {
        QFETCH(double, angle);
        QFETCH(double, volume_ul);
        const double theta = radian_from_degree(angle), volume = cubic_metre_from_ul(volume_ul);
        const DropOnPlate drop = drop_of_volume(volume, theta, water);
        QVERIFY(near(drop.volume, volume, 1e-6));
        // Pressure at the base times its area = weight + what the surface pulls down at its edge.
        const double r = drop.base_radius, pressed = pi * r * r * (2.0 * drop.top_curvature + water * drop.height);
        QVERIFY(near(pressed, water * volume + 2.0 * pi * r * std::sin(theta), 1e-6));
    }
    void aWideOneIsAPuddle()
    {
        for (double angle : {30.0, 90.0, 150.0}) {
            const double theta = radian_from_degree(angle);
            QVERIFY(near(drop_of_volume(1e-3, theta, water).height, 2.0 / std::sqrt(water) * std::sin(0.5 * theta), 0.01));
        }
    }
    void isFoundByItsMoments()
    {
        for (double weight : {0.0, water})
            for (double angle : {20.0, 45.0, 90.0, 150.0}) {
                const DropOnPlate drop = drop_of_volume(15e-9, radian_from_degree(angle), weight);
                const DropOnPlate found = drop_like(drop.middle, drop.square, weight);
                QVERIFY(near(found.contact_angle, drop.contact_angle, 1e-4));
                QVERIFY(near(found.base_radius, drop.base_radius, 1e-4));
                QVERIFY(near(found.height, drop.height, 1e-4));
            }
    }
};

QTEST_APPLESS_MAIN(TestDropShapes)
#include "tst_drop_shapes.moc"
