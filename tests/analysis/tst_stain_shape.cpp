// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Shapes of stains against those whose numbers are known.
#include "core/analysis/stain_shape.h"

#include <QTest>

#include <cmath>
#include <functional>

using namespace hygroloom;

namespace {

/// Places of a grid of 0.1 by 0.2 mm within an outline, m.
std::optional<StainShape> shape_within(const std::function<bool(double, double)>& inside)
{
    constexpr double cell_x = 1e-4, cell_y = 2e-4;
    std::vector<std::array<double, 2>> places;
    for (int i = -200; i <= 200; ++i)
        for (int k = -100; k <= 100; ++k)
            if (inside(i * cell_x, k * cell_y)) places.push_back({i * cell_x + 3e-3, k * cell_y});
    return stain_shape(places, cell_x, cell_y);
}

} // namespace

class TestStainShape : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anEllipseHasItsAspectAndNoArms()
    {
        const StainShape shape = *shape_within([](double x, double y) { return std::hypot(x / 6e-3, y / 9e-3) < 1; });
        QVERIFY(std::abs(shape.aspect - 1.5) < 0.01);
        QVERIFY(std::abs(shape.armness) < 0.005);
        QVERIFY(shape.solidity > 0.97 && shape.solidity <= 1);
    }
    void armsAreTheFourFoldPartOfTheOutline_data()
    {
        QTest::addColumn<double>("part");
        QTest::newRow("along the yarns") << 0.12;
        QTest::newRow("between them") << -0.08;
    }
    void armsAreTheFourFoldPartOfTheOutline()
    {
        QFETCH(double, part);
        const StainShape shape =
            *shape_within([&](double x, double y) { return std::hypot(x, y) < 8e-3 * (1 + part * std::cos(4 * std::atan2(y, x))); });
        QVERIFY(std::abs(shape.armness - part) < 0.005);
        QVERIFY(std::abs(shape.aspect - 1) < 0.01);
    }
    void aPlainCrossHasASolidityBelowOne() // two bars, 16.1 by 4.2 mm: 117.6 of 188.4 mm2
    {
        const auto bar = [](double x, double y) { return std::abs(x) < 8.05e-3 && std::abs(y) < 2.1e-3; };
        const StainShape shape = *shape_within([&](double x, double y) { return bar(x, y) || bar(y, x); });
        qInfo("%.3f", shape.solidity);
        QVERIFY(std::abs(shape.solidity - 117.6 / 188.4) < 0.02);
        QVERIFY(shape.armness > 0.25);
    }
    void littleHasNoShape()
    {
        QVERIFY(!shape_within([](double x, double y) { return std::hypot(x, y) < 2.5e-4; }));
    }
};

QTEST_APPLESS_MAIN(TestStainShape)
#include "tst_stain_shape.moc"
