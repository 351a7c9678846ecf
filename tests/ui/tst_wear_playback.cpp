// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The scale of a garment's colours while its run goes on, and places of one run in another.
#include "core/base/round_up.h"
#include "ui/garment/wear_playback.h"
#include "ui/results/chart.h"
#include "ui/results/timeline.h"

#include <QSignalSpy>
#include <QSlider>
#include <QTest>

using namespace hygroloom;

class TestWearPlayback : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theScaleEndsWhereTheRunWill()
    {
        QCOMPARE(scaleEndOfRun(10, 0.1, 1000), 100.0);
        QCOMPARE(scaleEndOfRun(10, 0.1, 55), 60.0); // no more than the cloth can hold
        QCOMPARE(scaleEndOfRun(90, 1, 55), 100.0);  // but what it holds
    }

    void theScaleStaysWhileTheRunGoesOn()
    {
        WearPlayback playback;
        playback.begin(runOf100s());
        QSignalSpy changes(&playback, &WearPlayback::scaleChanged);
        for (int k = 0; k <= 100; ++k) {
            append(playback, k, {2.0 * k, 0.005 * k}); // to 200 g/m2
            if (k > 0) { QCOMPARE(playback.most(), 200.0); }
        }
        QCOMPARE(changes.count(), 1); // with the first water
        playback.end();
        QCOMPARE(playback.most(), rounded_up(200));
        playback.setValue(WearValue::share);
        QCOMPARE(playback.most(), 0.5);
    }

    /// All comes in the first hundredth, which looked like the cloth's whole capacity.
    void theScaleFallsAfterAnEarlyBurst()
    {
        WearPlayback playback;
        playback.begin(runOf100s());
        QSignalSpy changes(&playback, &WearPlayback::scaleChanged);
        append(playback, 1, {20, 0.06});
        QCOMPARE(playback.most(), rounded_up(300));
        for (int k = 2; k <= 100; ++k) {
            append(playback, k, {20, 0.06});
            const double expected = scaleEndOfRun(20, k / 100.0, 300);
            QVERIFY2(playback.most() >= 20 && playback.most() <= 2 * expected, qPrintable(QString::number(k)));
        }
        QVERIFY(playback.most() <= 40);
        QVERIFY2(changes.count() <= 5, qPrintable(QString::number(changes.count()))); // it does not follow each frame
    }

    void whatIsKeptStaysWhenTheRunIsDiscarded()
    {
        WearPlayback playback;
        const std::shared_ptr<WornRun> a = runOf100s(0);
        playback.begin(a);
        append(playback, 100, {20, 0.06});
        playback.end();
        playback.keepAsA();
        playback.begin(runOf100s(0));
        append(playback, 1, {20, 0.06});
        playback.end();
        playback.discard();
        QVERIFY(!playback.run() && playback.kept() == a);
        playback.clear();
        QVERIFY(!playback.kept());
    }

    void theTimelineAndTheChartOfSamplesShowAGarment()
    {
        WearPlayback playback;
        Timeline timeline(playback);
        Chart chart(playback);
        playback.begin(runOf100s(0));
        for (int k = 0; k <= 9; ++k) { append(playback, 10.0 * k, {20, 0.06}); }
        QCOMPARE(playback.current(), 9); // it follows the run
        timeline.step(-3);
        QCOMPARE(timeline.findChild<QSlider*>()->value(), 6);
        append(playback, 100, {20, 0.06});
        QCOMPARE(playback.time(), 60.0); // until the user looks at another time
        QCOMPARE(playback.frameAt(59.9), 5);
        QCOMPARE(playback.frameAt(60), 6);
        QCOMPARE(playback.frameAt(-1), 0);
        timeline.step(100);
        QCOMPARE(playback.time(), 100.0);
        QCOMPARE(chart.title(), QString::fromUtf8("Water in the garment, g/m²"));
        QCOMPARE(chart.curves(), QStringList{""});
        playback.end();
        playback.keepAsA();
        playback.setValue(WearValue::share);
        QCOMPARE(chart.title(), QString("Share of the garment's capacity, %"));
        QCOMPARE(chart.curves(), (QStringList{"B", "A"}));
        playback.clear();
        QCOMPARE(playback.frameAt(0), -1);
        QVERIFY(!timeline.findChild<QSlider*>()->isEnabled());
    }

    /// Panels of two runs may stand in another order, or be missing.
    void placesAreFoundByThePanelsName()
    {
        WearLayout one, other;
        one.panels.resize(3);
        other.panels.resize(2);
        one.panels[0].name = "front";
        one.panels[1].name = "back";
        one.panels[2].name = "sleeve";
        other.panels[0].name = "back";
        other.panels[1].name = "front";
        QCOMPARE(sameSpot(one, other, {0, {0.1, 0.2}}), (GarmentSpot{1, {0.1, 0.2}}));
        QCOMPARE(sameSpot(other, one, {0, {0.1, 0.2}}), (GarmentSpot{1, {0.1, 0.2}}));
        QCOMPARE(sameSpot(one, other, {2, {0.1, 0.2}}).panel, -1);
        QCOMPARE(sameSpot(one, other, {}).panel, -1);
        QCOMPARE(sameSpot(one, other, {7, {}}).panel, -1);
    }

private:
    /// Of cells that hold up to 300 g/m2.
    static std::shared_ptr<WornRun> runOf100s(std::size_t cells = 1)
    {
        auto record = std::make_shared<WearRecord>();
        GarmentCell cell;
        cell.area = 1e-4;
        cell.capacity = 30e-6;
        record->layout.cells.assign(cells, cell);
        auto run = std::make_shared<WornRun>();
        run->record = record;
        run->live = true;
        run->duration = 100;
        return run;
    }
    static void append(WearPlayback& playback, double time, const MostWater& most)
    {
        auto frame = std::make_shared<WearFrame>();
        frame->time = time;
        playback.append(frame, nullptr, most);
    }
};

QTEST_MAIN(TestWearPlayback)
#include "tst_wear_playback.moc"
