// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The scale of a garment's colours while its run goes on.
#include "core/base/round_up.h"
#include "ui/garment/wear_playback.h"

#include <QSignalSpy>
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
        auto record = std::make_shared<WearRecord>();
        GarmentCell cell;
        cell.area = 1e-4;
        cell.capacity = 30e-6; // 300 g/m2
        record->layout.cells.push_back(cell);
        auto run = std::make_shared<WornRun>();
        run->record = record;
        run->live = true;
        run->duration = 100;
        playback.begin(run);
        QSignalSpy changes(&playback, &WearPlayback::scaleChanged);
        for (int k = 0; k <= 100; ++k) {
            auto frame = std::make_shared<WearFrame>();
            frame->time = k;
            playback.append(frame, nullptr, {2.0 * k, 0.005 * k}); // to 200 g/m2
            if (k > 0) { QCOMPARE(playback.most(), 200.0); }
        }
        QCOMPARE(changes.count(), 1); // with the first water
        playback.end();
        QCOMPARE(playback.most(), rounded_up(200));
        playback.setValue(WearValue::share);
        QCOMPARE(playback.most(), 0.5);
    }
};

QTEST_GUILESS_MAIN(TestWearPlayback)
#include "tst_wear_playback.moc"
