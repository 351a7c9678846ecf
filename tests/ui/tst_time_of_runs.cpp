// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The time that many runs will still take.
#include "ui/compare/time_of_runs.h"

#include <QTest>

using namespace hygroloom;

class TestTimeOfRuns : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void plansCountUntilSomethingHasRun()
    {
        const TimeOfRuns times;
        QCOMPARE(*times.left({{10, 0, 0}}, {10, 30}, 1), 50.0);
        QCOMPARE(*times.left({{10, 0, 0}}, {10, 30}, 4), 30.0); // side by side: the longest
        QVERIFY(!times.left({{0, 5, 0.01}}, {0, 0}, 1));        // nothing is known
        QCOMPARE(*times.left({{0, 5, 0.5}}, {0, 0}, 1), 25.0);  // they are like the one under way
        QCOMPARE(*times.left({}, {}, 1), 0.0);
    }

    /// Plans of another machine: ten times too short, and too long.
    void whatHasRunCorrectsThePlans_data()
    {
        QTest::addColumn<double>("factor");
        QTest::newRow("too short") << 10.0;
        QTest::newRow("too long") << 0.1;
    }
    void whatHasRunCorrectsThePlans()
    {
        QFETCH(double, factor);
        TimeOfRuns times;
        times.add(10, 10 * factor, {{0.5, 5 * factor}});
        QVERIFY(std::abs(*times.left({{20, 0, 0}}, {30}, 1) - 50 * factor) < 1e-9 * factor);
        QVERIFY(std::abs(*times.left({{20, 10 * factor, 0.5}}, {}, 1) - 10 * factor) < 1e-9 * factor);
    }

    /// A drop falls and is absorbed in the first tenth, which takes nine tenths of the time.
    void timePassesAsInRunsThatEnded()
    {
        TimeOfRuns times;
        times.add(0, 100, {{0.05, 45}, {0.1, 90}, {0.5, 95}});
        const double early = *times.left({{0, 45, 0.05}}, {}, 1), late = *times.left({{0, 90, 0.1}}, {}, 1);
        QVERIFY2(early > 50 && early < 60, qPrintable(QString::number(early))); // not 855
        QVERIFY2(late > 9 && late < 11, qPrintable(QString::number(late)));     // not 810
    }

    void aRunThatOverrunsItsPlanIsNotAboutToEnd()
    {
        const TimeOfRuns times;
        QVERIFY(*times.left({{10, 60, 0.1}}, {}, 1) > 30);
        QVERIFY(*times.left({{10, 60, 0.5}}, {}, 1) > 50);
    }

    /// One of unknown length tells nothing of how plans compare with what runs take.
    void runsWithoutAPlanDoNotCorrectThePlans()
    {
        const TimeOfRuns times;
        QVERIFY(std::abs(*times.left({{10, 20, 0.5}}, {10}, 1) - 60) < 1e-9); // 20 and 40
        QVERIFY(std::abs(*times.left({{10, 20, 0.5}, {0, 50, 0.5}}, {10}, 1) - 110) < 1e-9);
    }

    void failedRunsTellNothing()
    {
        TimeOfRuns times;
        times.add(10, 0, {});
        QCOMPARE(*times.left({}, {10}, 1), 10.0);
    }
};

QTEST_GUILESS_MAIN(TestTimeOfRuns)
#include "tst_time_of_runs.moc"
