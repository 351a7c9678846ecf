// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs of a project that are damaged, reached through links, or must go to another file system. Needs a display: xvfb-run.
#include "project_runs_test.h"

using namespace hygroloom;

class TestFoundRuns : public ProjectRunsTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { useOwnSettings(); }
    void init() { openProject(); }
    void cleanup() { closeProject(); }

    void aDamagedRunIsListedWithItsReasonAndCanBeForgotten()
    {
        run();
        trigger("Save");
        QVERIFY(window_->close());
        const QString damaged = runFolderOf(project_) + "/run-2.hygrorec";
        QFile file(damaged);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("no recording") > 0);
        file.close();
        openWindow();
        QVERIFY(window_->openFile(project_));
        QTRY_COMPARE_WITH_TIMEOUT(runs().runs().size(), std::size_t{2}, 20000);
        window_->setWorkspace(Workspace::compare);
        QTRY_VERIFY_WITH_TIMEOUT(runs().runs()[0].metrics, 20000);
        QTreeWidgetItem* item = list()->topLevelItem(1);
        QCOMPARE(item->text(1), QString("cannot be read"));
        QVERIFY2(item->toolTip(1).contains("not a Hygroloom recording"), qPrintable(item->toolTip(1)));
        QVERIFY(!(item->flags() & Qt::ItemIsUserCheckable));
        list()->setCurrentItem(item);
        const auto asked = press("Forget");
        button("Forget…")->click();
        QVERIFY2(asked->contains("run-2, cannot be read"), qPrintable(*asked));
        QVERIFY(!QFile::exists(damaged));
        QCOMPARE(runs().runs().size(), std::size_t{1});
    }

    void aProjectUnderAnotherSpellingHasTheSameRuns()
    {
        run();
        const QString link = folder_.filePath("link%1").arg(tests_);
        QVERIFY(QFile::link(QFileInfo(project_).absolutePath(), link));
        chooseFile(link + "/cloth.hygro");
        trigger("Save As…");
        QCOMPARE(recordingsIn(runFolderOf(project_)).size(), 1);
        QCOMPARE(runs().runs().size(), std::size_t{1});
        QVERIFY(window_->openFile(link + "/cloth.hygro-runs/run-1.hygrorec"));
        QTRY_VERIFY_WITH_TIMEOUT(playback().whole(), 20000);
        QCOMPARE(runs().runs().size(), std::size_t{1});
        QVERIFY(runs().runs()[0].own);
    }

    void quittingAsksBeforeRunsOfCompareAreStopped()
    {
        shortenExperiment(3600, 10, 5);
        simulationPanel().setFidelity(Fidelity::draft); // seconds long
        trigger("Save");
        StudyRuns& study = window_->compare().study();
        study.start({{{window_->document().fabric()->name, window_->document().experiment()->name}, 1}});
        QVERIFY(study.running());
        auto asked = press("Cancel");
        QVERIFY(!window_->close());
        QVERIFY2(asked->contains("Stop the runs of Compare?"), qPrintable(*asked));
        QVERIFY(study.running());
        asked = press("Stop the Runs");
        QVERIFY(window_->close());
        QVERIFY(!asked->isEmpty() && !study.running());
    }

    void everyWorkspaceFitsASmallScreen()
    {
        for (const Workspace each : {Workspace::compare, Workspace::garment, Workspace::design, Workspace::simulate}) {
            window_->setWorkspace(each);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
            const QSize least = window_->minimumSizeHint();
            QVERIFY2(least.width() <= 1280 && least.height() <= 760, qPrintable(QString("%1 x %2").arg(least.width()).arg(least.height())));
        }
    }

    void runsAreCopiedToAnotherFileSystemInTheBackground()
    {
        QTemporaryDir elsewhere("/dev/shm/runs-XXXXXX");
        if (!elsewhere.isValid()) { QSKIP("no second file system"); }
        openExample();
        run();
        const QString before = playback().path();
        Q_EMIT compareView().markRequested(before, true);
        const QString path = elsewhere.filePath("cloth.hygro"), to = runFolderOf(path) + "/run-1.hygrorec";
        QSignalSpy ended(&window_->compare().project(), &ProjectRuns::copiesEnded);
        chooseFile(path);
        trigger("Save As…");
        QCOMPARE(ended.count(), 0); // not in this thread
        QVERIFY(window_->compare().project().copying());
        window_->compare().project().forget(before);
        QCOMPARE(runs().runs().size(), std::size_t{1}); // not while it is copied
        Q_EMIT compareView().markRequested(before, false);
        QVERIFY(window_->close()); // which waits
        QCOMPARE(ended.count(), 1);
        QCOMPARE(playback().path(), to);
        QVERIFY(QFile::exists(to) && !QFile::exists(before));
        QVERIFY(!isMarked(to));
        QVERIFY(runs().runs().size() == 1 && runs().runs()[0].saved);
    }
};

QTEST_MAIN(TestFoundRuns)
#include "tst_found_runs.moc"
