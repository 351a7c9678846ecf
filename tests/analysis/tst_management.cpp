// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Grades, capability and classes of the moisture management test.
#include "core/analysis/management.h"

#include <QTest>

using namespace hygroloom;

class TestManagement : public QObject {
    Q_OBJECT
private Q_SLOTS:
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
