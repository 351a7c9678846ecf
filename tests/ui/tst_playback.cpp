// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Recordings in the window: damaged ones, and one whose run goes on.
#include "tests/support/crafted_recording.h"
#include "ui/results/playback.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

class TestPlayback : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    /// A valid one of which a frame lacks its temperature.
    QString without(int frame) const
    {
        const QString path = folder_.filePath("damaged.hygrorec");
        write_small_recording(path.toStdString());
        craft_by_sql(path.toStdString(), "UPDATE frames SET temperature=NULL WHERE number=" + std::to_string(frame));
        return path;
    }

private Q_SLOTS:
    void damagedFramesAreNamedAndTheOthersShown_data()
    {
        QTest::addColumn<int>("frame");
        for (int frame = 0; frame < 3; ++frame) QTest::addRow("%d", frame) << frame;
    }
    void damagedFramesAreNamedAndTheOthersShown()
    {
        QFETCH(int, frame);
        const QString path = without(frame);
        Playback playback;
        QSignalSpy opened(&playback, &Playback::opened), failed(&playback, &Playback::failed);
        playback.open(path);
        QTRY_COMPARE(opened.count(), 1);
        QTRY_VERIFY(playback.whole());
        QTRY_VERIFY(failed.count() >= 1);
        QVERIFY(failed.last()[0].toString().startsWith(path + QString(": Frame %1 cannot be read: ").arg(frame)));
        QVERIFY(playback.firstFrame());
        QCOMPARE(playback.firstFrame()->time, frame == 0 ? 0.1 : 0.0);
        QCOMPARE(playback.metrics()->series.time.size(), std::size_t(2));
        QTRY_COMPARE(playback.frames(), 2); // the damaged one is no time to go to
        const double times[2] = {frame == 0 ? 0.1 : 0.0, frame == 2 ? 0.1 : 0.2};
        for (int index = 0; index < 2; ++index) {
            QCOMPARE(playback.timeOf(index), times[index]);
            playback.show(index);
            QTRY_VERIFY(playback.frame() && playback.frame()->time == times[index]);
        }
        QCOMPARE(failed.count(), 1);
    }
    void whatIsNoRecordingIsRefusedWithASentence()
    {
        const QString path = folder_.filePath("damaged.hygrorec");
        write_small_recording(path.toStdString());
        QVERIFY(craft_by_sql(path.toStdString(), "DROP TABLE frames"));
        Playback playback;
        QSignalSpy failed(&playback, &Playback::failed);
        playback.open(path);
        QTRY_COMPARE(failed.count(), 1);
        QVERIFY(failed[0][0].toString().contains("\"frames\" is missing"));
    }
    void whatIsStillOpeningDoesNotReplaceARunThatHasBegun()
    {
        const QString path = folder_.filePath("late.hygrorec"), other = folder_.filePath("wanted.hygrorec");
        write_small_recording(path.toStdString());
        write_small_recording(other.toStdString());
        Playback playback;
        QSignalSpy opened(&playback, &Playback::opened);
        playback.open(path);
        QTest::qSleep(1000); // it has been read, and waits for this thread
        playback.begin(std::make_shared<const RunRecord>(small_run()), "live");
        QTest::qWait(100);
        QCOMPARE(opened.count(), 0);
        QVERIFY(playback.live() && playback.path() == "live");
        playback.open(path);
        QTest::qSleep(1000);
        playback.open(other); // the newest request counts
        QTRY_COMPARE(opened.count(), 1);
        QCOMPARE(playback.path(), other);
        playback.open(path);
        QTest::qSleep(1000);
        playback.stopOpening();
        QTest::qWait(100);
        QCOMPARE(playback.path(), other);
        QVERIFY(playback.whole());
    }
    void aRecordingWhoseRunGoesOnOpensWithItsFramesSoFar()
    {
        const QString path = folder_.filePath("running.hygrorec");
        const RunRecord run = small_run();
        RecordingWriter writer(path.toStdString(), run);
        const auto commit = [&writer] { // which frames wait for 0.2 s
            QTest::qSleep(250);
            writer.commit_when_due();
        };
        for (int k = 0; k < 2; ++k) writer.append(small_frame(run, k));
        commit();
        Playback playback;
        playback.open(path);
        QTRY_COMPARE(playback.frames(), 2);
        writer.append(small_frame(run, 2));
        commit();
        QTRY_VERIFY(playback.frame() && playback.whole());
        playback.open(path);
        QTRY_COMPARE(playback.frames(), 3);
    }
};

QTEST_GUILESS_MAIN(TestPlayback)
#include "tst_playback.moc"
