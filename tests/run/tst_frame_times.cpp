// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/frame_times.h"

#include <QTest>

#include <algorithm>

using namespace hygroloom;

class TestFrameTimes : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void framesLieAtWholeIntervalsAndAtTheEnd()
    {
        Experiment drop;
        drop.duration_s = 10;
        QCOMPARE(frame_times(drop, 4), (std::vector<double>{0, 4, 8, 10}));
        QCOMPARE(frame_times(drop, 5), (std::vector<double>{0, 5, 10}));
        QCOMPARE(frame_times(drop, 20), (std::vector<double>{0, 10}));
        drop.duration_s = 0.3;
        QCOMPARE(frame_times(drop, 0.1).size(), std::size_t(4)); // 0.3 / 0.1 is a little more than 3 in binary
        QCOMPARE(frame_times(drop, 0.1).back(), 0.3);
    }
    void aFeedIsSeenEveryTenthOfASecond()
    {
        Experiment test = standard_experiment(ExperimentType::moisture_management); // 20 of 120 s
        test.drop_ul = 0;
        const std::vector<double> times = frame_times(test, 1.2);
        QCOMPARE(times.size(), std::size_t(1 + 200 + 84)); // 20.4, 21.6 .. 120 s
        for (std::size_t i = 1; i < times.size(); ++i) QVERIFY(times[i] > times[i - 1]);
        QVERIFY(std::abs(times[7] - 0.7) < 1e-12);
        QCOMPARE(times[200], 20.0);
        QCOMPARE(times[201], 17 * 1.2);
        QCOMPARE(times.back(), 120.0);
    }
    /// Eight drops, 2.5 s apart.
    void betweenDropsOfAFeedEveryFifthFrameSuffices()
    {
        Experiment test = standard_experiment(ExperimentType::moisture_management);
        const double interval = test.feed_s / drops_of_feed(test);
        const std::vector<double> times = frame_times(test, 1.2);
        QCOMPARE(times.size(), std::size_t(1 + 80 + 84));
        const auto lies_in = [&](double time) {
            return std::any_of(times.begin(), times.end(), [&](double t) { return std::abs(t - time) < 1e-9; });
        };
        QVERIFY(!lies_in(interval + 0.7));
        for (double after : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 1.0, 1.5, 2.0})
            QVERIFY2(lies_in(interval + after), QByteArray::number(after));
        for (int drop = 1; drop <= 8; ++drop) QVERIFY(lies_in(drop * interval));
    }
    void aLongFeedHasTwoHundredFramesAndAShortRunEndsEarlier()
    {
        Experiment test = standard_experiment(ExperimentType::moisture_management);
        test.drop_ul = 0;
        test.feed_s = 1000;
        test.duration_s = 2000;
        QCOMPARE(frame_times(test, 20)[1], 5.0);
        QCOMPARE(frame_times(test, 2)[1], 2.0); // finer anyway
        test.drop_ul = 25;                      // no gap is longer than the interval
        test.feed_s = 120;
        test.duration_s = 240;
        const std::vector<double> fed = frame_times(test, 2.4);
        for (std::size_t i = 1; i < fed.size(); ++i) QVERIFY(fed[i] - fed[i - 1] < 2.4 + 1e-9);
        test.drop_ul = 0;
        test.feed_s = 20;
        test.duration_s = 5;
        const std::vector<double> times = frame_times(test, 0.5);
        QCOMPARE(times.size(), std::size_t(51));
        QCOMPARE(times.back(), 5.0);
        test.duration_s = 0.05;
        QCOMPARE(frame_times(test, 0.0005).size(), std::size_t(101));
    }
};

QTEST_APPLESS_MAIN(TestFrameTimes)
#include "tst_frame_times.moc"
