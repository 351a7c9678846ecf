// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Indices of the moisture management test on curves made up so that each is known.
#include "core/analysis/management.h"

#include <QTest>

using namespace hygroloom;

namespace {

/// Dry for a while, then rising evenly for a while, then level; the circle grows evenly from the same time.
struct Ramp {
    double from = 0, to = 0, slope = 0; ///< s, s, % per s
    double speed = 0;                   ///< mm/s
    double farthest = 0;                ///< mm
};

FaceCurve curve(const std::vector<double>& time, const Ramp& ramp)
{
    FaceCurve face;
    for (double t : time) {
        face.water.push_back(ramp.slope * (std::clamp(t, ramp.from, ramp.to) - ramp.from));
        face.radius.push_back(1e-3 * std::min(ramp.farthest, ramp.speed * std::max(0.0, t - ramp.from)));
    }
    return face;
}

std::vector<double> times(double step, double end)
{
    std::vector<double> time;
    for (int i = 0; i * step <= end + 1e-9; ++i) time.push_back(i * step);
    return time;
}

} // namespace

class TestManagement : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void rampsHaveTheIndicesTheyWereMadeWith()
    {
        const std::vector<double> time = times(0.25, 120);
        const ManagementIndices m = management_indices(time, curve(time, {2, 20, 30, 1.25, 23}), curve(time, {4, 12, 50, 2.5, 100}), 20);
        QCOMPARE(*m.top.wetting_time, 2.0);
        QCOMPARE(*m.bottom.wetting_time, 4.0);
        QCOMPARE(m.top.absorption_rate, 30.0);
        QCOMPARE(m.bottom.absorption_rate, 50 * 8.0 / 16); // level from 12 s on, the feed ends at 20 s
        QCOMPARE(m.top.maximum_wetted_radius, 20.0);
        QCOMPARE(m.bottom.maximum_wetted_radius, 30.0); // no ring lies farther out
        QVERIFY(std::abs(m.top.spreading_speed - 1.25) < 1e-9);
        QVERIFY(std::abs(m.bottom.spreading_speed - 2.5) < 1e-9);
        const double top = 540 * (0.5 * 18 + 100), bottom = 400 * (0.5 * 8 + 108);
        QVERIFY(std::abs(m.one_way_transport - (bottom - top) / 120) < 1e-9);
        QCOMPARE(m.ommc, overall_capability(m.bottom.absorption_rate, m.one_way_transport, m.bottom.spreading_speed));
    }
    void aDryFaceHasNoWettingTime()
    {
        const std::vector<double> time = times(1, 120);
        const ManagementIndices m =
            management_indices(time, curve(time, {0, 120, 0.26, 0, 0}), curve(time, {}), 20); // below tan 15 degrees
        QVERIFY(!m.top.wetting_time && !m.bottom.wetting_time);
        QCOMPARE(m.top.maximum_wetted_radius, 0.0);
        const ManagementGrades grades = management_grades(m);
        QCOMPARE(grades.wetting_time_top, 1);
        QCOMPARE(grades.one_way_transport, 2); // both faces alike
        QCOMPARE(QString(fabric_class(m)), QString("water-proof or water-repellent"));
        QCOMPARE(management_indices({0}, {{0}, {0}}, {{0}, {0}}, 20).ommc, 0.0);
    }
    void ringsWettedAtOnceHaveNoEndlessSpeed()
    {
        const std::vector<double> time{0, 1, 2};
        const FaceCurve face{{0, 100, 100}, {0.02, 0.02, 0.02}};
        QCOMPARE(management_indices(time, face, face, 20).top.spreading_speed, 5 / 0.1);
    }
    void theOverallCapabilityIsAsPublished()
    {
        QVERIFY(std::abs(overall_capability(55, 250, 3.1) - 0.6333333333) < 1e-9);
        QCOMPARE(overall_capability(0, -300, 0), 0.0);
        QCOMPARE(overall_capability(500, 2000, 50), 1.0);
    }
    void gradesFollowTheCutPoints_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<int>("rate");
        QTest::addColumn<int>("radius");
        QTest::addColumn<int>("speed");
        QTest::addColumn<int>("transport");
        QTest::addColumn<int>("time");
        QTest::newRow("-60") << -60.0 << 1 << 1 << 1 << 1 << 5;
        QTest::newRow("0.9") << 0.9 << 1 << 1 << 1 << 2 << 5;
        QTest::newRow("3") << 3.0 << 1 << 1 << 4 << 2 << 4;
        QTest::newRow("8") << 8.0 << 1 << 2 << 5 << 2 << 3;
        QTest::newRow("15") << 15.0 << 2 << 3 << 5 << 2 << 3;
        QTest::newRow("20") << 20.0 << 2 << 4 << 5 << 2 << 2;
        QTest::newRow("60") << 60.0 << 4 << 5 << 5 << 2 << 2;
        QTest::newRow("120") << 120.0 << 5 << 5 << 5 << 3 << 1;
        QTest::newRow("250") << 250.0 << 5 << 5 << 5 << 4 << 1;
        QTest::newRow("401") << 401.0 << 5 << 5 << 5 << 5 << 1;
    }
    void gradesFollowTheCutPoints()
    {
        QFETCH(double, value);
        ManagementIndices m;
        m.top = {value, value, value, value};
        m.one_way_transport = value;
        const ManagementGrades grades = management_grades(m);
        QTEST(grades.absorption_rate_top, "rate");
        QTEST(grades.maximum_wetted_radius_top, "radius");
        QTEST(grades.spreading_speed_top, "speed");
        QTEST(grades.one_way_transport, "transport");
        QTEST(grades.wetting_time_top, "time");
        QCOMPARE(grades.ommc, 1);
    }
    void clothsFallIntoTheirClasses()
    {
        const auto class_of = [](const FaceIndices& top, const FaceIndices& bottom, double transport) {
            ManagementIndices m;
            m.top = top;
            m.bottom = bottom;
            m.one_way_transport = transport;
            return QString(fabric_class(m));
        };
        QCOMPARE(class_of({2, 60, 10, 1}, {3, 60, 25, 3}, 250), QString("moisture management"));
        QCOMPARE(class_of({2, 60, 10, 1}, {3, 60, 10, 1}, 250), QString("water penetration"));
        QCOMPARE(class_of({30, 20, 10, 1}, {30, 20, 10, 1}, 0), QString("slow-absorbing and slow-drying"));
        QCOMPARE(class_of({4, 40, 25, 4}, {4, 40, 25, 4}, 0), QString("fast-absorbing and quick-drying"));
        QCOMPARE(class_of({4, 40, 10, 1}, {4, 40, 10, 1}, 0), QString("fast-absorbing and slow-drying"));
    }
};

QTEST_APPLESS_MAIN(TestManagement)
#include "tst_management.moc"
