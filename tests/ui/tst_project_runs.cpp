// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs belong to their project: found again, taken along, and gone only when the user says so. Needs a display: xvfb-run.
#include "project_runs_test.h"
#include "ui/compare/cloths_view.h"
#include "ui/results/results_panel.h"

#include <QLabel>
#include <QTabWidget>

using namespace hygroloom;

class TestProjectRuns : public ProjectRunsTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { useOwnSettings(); }
    void init() { openProject(); }
    void cleanup() { closeProject(); }

    void runsAreFoundAgainBesideTheirProject()
    {
        run();
        run();
        QCOMPARE(playback().path(), runFolderOf(project_) + "/run-2.hygrorec");
        trigger("Save");
        QVERIFY(window_->close());
        openWindow();
        QVERIFY(window_->openFile(project_));
        QTRY_COMPARE_WITH_TIMEOUT(runs().runs().size(), std::size_t{2}, 20000);
        const KeptRun& first = runs().runs()[0];
        QCOMPARE(first.path, runFolderOf(project_) + "/run-1.hygrorec");
        QVERIFY(first.own && first.saved && first.current && first.complete());
        QVERIFY(first.bytes > 1000 && !first.metrics); // the list needs no frames
        window_->setWorkspace(Workspace::compare);
        QTRY_VERIFY_WITH_TIMEOUT(runs().runs()[0].metrics && runs().runs()[1].metrics, 20000);
        QVERIFY(runs().runs()[0].metrics->maximum_wetted_radius_top > 0);
        QVERIFY(compareView().chosen().contains(runs().runs()[1].path)); // as before
        window_->document().edit("ends", {}, [](Design& d) { d.fabrics[0].ends_per_cm = 30; });
        QVERIFY(!runs().runs()[0].current);
        QCOMPARE(list()->topLevelItem(0)->text(5), QString("older design: fabric"));
        window_->document().history()->undo();
        QVERIFY(runs().runs()[0].current);
        QCOMPARE(list()->topLevelItem(0)->text(5), QString());
    }

    void anotherProjectHasItsOwnRuns()
    {
        run();
        trigger("Save");
        const QString other = QFileInfo(project_).absolutePath() + "/other.hygro";
        QVERIFY(QFile::copy(project_, other));
        QVERIFY(window_->openFile(other));
        QVERIFY(runs().runs().empty());
        QVERIFY(window_->openFile(project_));
        QTRY_COMPARE_WITH_TIMEOUT(runs().runs().size(), std::size_t{1}, 20000);
    }

    void theResultsOfAProjectThatIsOpenedSayWhichRunsAreKept()
    {
        QVERIFY(results().text().startsWith("Run the experiment"));
        run();
        QVERIFY(!results().text().contains("kept"));
        run();
        trigger("Save");
        QVERIFY(window_->close());
        openWindow();
        QVERIFY(window_->openFile(project_));
        QTRY_VERIFY_WITH_TIMEOUT(results().text().startsWith("2 runs are kept. Open the newest"), 20000);
        QVERIFY(!playback().run());
        QLabel* link = nullptr;
        for (QLabel* label : results().findChildren<QLabel*>()) {
            if (label->text().contains("href='newest'")) { link = label; }
        }
        QVERIFY(link && link->isVisibleTo(&results()));
        Q_EMIT link->linkActivated("newest");
        QTRY_VERIFY_WITH_TIMEOUT(playback().path().endsWith("run-2.hygrorec"), 20000);
        QVERIFY(!link->isVisibleTo(&results()) && !results().text().contains("kept"));
    }

    void theKeptRunOfWhatIsChosenIsOffered()
    {
        run();
        Document& document = window_->document();
        document.editState("add", [](Design& design, DesignState& state) {
            Fabric other = design.fabrics.front();
            other.name = "other";
            design.fabrics.push_back(other);
            state.fabric = 1;
        });
        QVERIFY(!results().text().contains("is kept")); // what is shown is of the first
        run();
        document.setFabricIndex(0);
        QVERIFY(results().text().contains("A run of the selected fabric and experiment is kept. Open it."));
        QLabel* link = nullptr;
        for (QLabel* label : results().findChildren<QLabel*>()) {
            if (label->text().contains("href='chosen'")) { link = label; }
        }
        QVERIFY(link && link->isVisibleTo(&results()));
        Q_EMIT link->linkActivated("chosen");
        QTRY_VERIFY_WITH_TIMEOUT(playback().path().endsWith("run-1.hygrorec"), 20000);
        QVERIFY(!results().text().contains("is kept"));
    }

    void theFirstSaveTakesRunsAlong()
    {
        openExample();
        run();
        const QString before = playback().path();
        QVERIFY(before.startsWith(Recovery::standardFolder()));
        QVERIFY(!runs().runs()[0].saved);
        const QString path = saveAs("first.hygro");
        QCOMPARE(playback().path(), runFolderOf(path) + "/run-1.hygrorec");
        QVERIFY(!QFile::exists(before) && QFile::exists(playback().path()));
        QCOMPARE(runs().runs().size(), std::size_t{1});
        QVERIFY(runs().runs()[0].saved && runs().runs()[0].path == playback().path());
        QVERIFY(window_->close());            // nothing to ask about
        QTRY_VERIFY(unsavedWork().isEmpty()); // removed in the background
    }

    void savingAsTakesTheRunsAlongAndLeavesThem()
    {
        run();
        Q_EMIT compareView().markRequested(playback().path(), true);
        const QString path = saveAs("again.hygro");
        QCOMPARE(recordingsIn(runFolderOf(project_)).size(), 1);
        QCOMPARE(recordingsIn(runFolderOf(path)).size(), 1);
        QVERIFY(runs().runs()[0].marked && isMarked(runFolderOf(path) + "/run-1.hygrorec"));
    }

    void aRunInProgressFollowsTheProject()
    {
        openExample();
        startLongRun();
        const QString path = saveAs("follows.hygro");
        simulation().cancel();
        QTRY_COMPARE_WITH_TIMEOUT(playback().path(), runFolderOf(path) + "/run-1.hygrorec", 10000);
        QCOMPARE(runs().runs().size(), std::size_t{1});
        QVERIFY(runs().runs()[0].saved);
    }

    void leavingAsksAboutRunsWithoutAProjectFile()
    {
        openExample();
        run();
        const QString fabric = QString::fromStdString(window_->document().fabric()->name);
        window_->document().history()->setClean();
        auto asked = press("Cancel");
        QVERIFY(!window_->close());
        QVERIFY2(asked->contains("1: " + fabric), qPrintable(*asked));
        asked = press("Cancel");
        QVERIFY(!window_->openFile(project_));
        QVERIFY(!asked->isEmpty());
        QCOMPARE(recordingsIn(unsavedRuns()).size(), 1);
        asked = press("Delete the Run");
        QVERIFY(window_->openFile(project_));
        QVERIFY(!asked->isEmpty());
        QVERIFY(unsavedRuns().isEmpty());
    }

    void aRunWhoseCopyIsGoneIsAskedAbout()
    {
        openExample();
        run();
        window_->document().history()->setClean();
        const QString copy = QFileInfo(project_).absolutePath() + "/copy.hygrorec";
        chooseFile(copy);
        trigger("Save Recording");
        QTRY_VERIFY_WITH_TIMEOUT(window_->compare().project().unfiled().isEmpty(), 10000);
        QVERIFY(QFile::remove(copy));
        const auto asked = press("Cancel");
        QVERIFY(!window_->close());
        QVERIFY(!asked->isEmpty());
        QCOMPARE(recordingsIn(unsavedRuns()).size(), 1);
    }

    void aRunInProgressIsAskedAbout()
    {
        startLongRun();
        trigger("Save");
        for (const bool closing : {true, false}) {
            const auto asked = press("Let It Run");
            QVERIFY(closing ? !window_->close() : !window_->openFile(example("textile-F")));
            QVERIFY2(asked->contains(QString::fromStdString(window_->document().fabric()->name)), qPrintable(*asked));
            QVERIFY(simulation().running());
        }
        const auto asked = press("Stop and Keep What Is Recorded");
        QVERIFY(window_->close());
        QVERIFY(!asked->isEmpty());
        openWindow();
        QVERIFY(window_->openFile(project_));
        QTRY_COMPARE_WITH_TIMEOUT(runs().runs().size(), std::size_t{1}, 20000);
        QVERIFY(!runs().runs()[0].complete());
    }

    void aRunGoesOnWhenALaterQuestionIsCancelled()
    {
        openExample();
        startLongRun(); // which changes the experiment
        auto asked = stopAndThenPress("Cancel");
        QVERIFY(!window_->close());
        QVERIFY((*asked)->contains("Save the changes"));
        QVERIFY(simulation().running());
        window_->document().history()->setClean();
        asked = stopAndThenPress("Delete the Run");
        QVERIFY(window_->close());
        QVERIFY((*asked)->contains("run-1"));
        QVERIFY(unsavedRuns().isEmpty());
    }

    void runsOfUnsavedWorkOutliveACrash()
    {
        openExample();
        run();
        QTRY_VERIFY_WITH_TIMEOUT(!unsavedWork().isEmpty(), 5000);
        // What a crash leaves; a copy under another name, as the lock is this process's.
        const QDir folder(Recovery::standardFolder());
        const QString own = folder.filePath(unsavedWork().first()), left = folder.filePath("crashed.hygro");
        QVERIFY(QFile::copy(own, left) && QFile::copy(own + ".origin", left + ".origin"));
        QCOMPARE(bringRun(playback().path(), runFolderOf(left), Bring::copy), runFolderOf(left) + "/run-1.hygrorec");
        deleteRun(playback().path());
        window_->document().history()->setClean();
        QVERIFY(window_->close());
        openWindow();
        const auto asked = press("Open");
        window_->offerLeftOver();
        QVERIFY2(asked->contains("1 run belongs to it"), qPrintable(*asked));
        QTRY_COMPARE_WITH_TIMEOUT(runs().runs().size(), std::size_t{1}, 20000);
        QVERIFY(runs().runs()[0].current && !runs().runs()[0].saved);
        QTRY_VERIFY_WITH_TIMEOUT(!QFile::exists(left), 5000);
    }

    void discardedWorkTakesItsRunsWithIt()
    {
        const QString left = Recovery::standardFolder() + "/crashed.hygro";
        QVERIFY(QDir().mkpath(runFolderOf(left)) && QFile::copy(project_, left));
        run();
        bringRun(playback().path(), runFolderOf(left), Bring::copy);
        press("Discard");
        window_->offerLeftOver();
        QVERIFY(!QFile::exists(left) && !QFile::exists(runFolderOf(left)));
    }

    void aRecordingThatWasOpenedBeforeItsProjectIsItsRun()
    {
        run();
        trigger("Save");
        const QString path = playback().path();
        QVERIFY(window_->close());
        openWindow();
        QVERIFY(window_->openFile(path));
        QTRY_COMPARE_WITH_TIMEOUT(runs().runs().size(), std::size_t{1}, 20000);
        QVERIFY(!runs().runs()[0].own);
        window_->document().history()->setClean();
        QVERIFY(window_->openFile(project_));
        QTRY_VERIFY_WITH_TIMEOUT(runs().runs().size() == 1 && runs().runs()[0].own, 20000);
        window_->setWorkspace(Workspace::compare);
        list()->setCurrentItem(list()->topLevelItem(0));
        const auto asked = press("Cancel");
        button("Forget…")->click();
        QVERIFY(!asked->isEmpty());
        QVERIFY(QFile::exists(path));
    }

    void forgettingAsksAndNamesTheRun()
    {
        run();
        const QString path = playback().path();
        window_->setWorkspace(Workspace::compare);
        list()->setCurrentItem(list()->topLevelItem(0));
        auto asked = press("Cancel");
        button("Forget…")->click();
        QVERIFY2(asked->contains("1: " + QString::fromStdString(window_->document().fabric()->name)), qPrintable(*asked));
        QVERIFY(QFile::exists(path));
        asked = press("Forget");
        button("Forget…")->click();
        QVERIFY(!QFile::exists(path));
        QVERIFY(runs().runs().empty());
    }

    void whatAnotherWindowDidIsNotDeleted()
    {
        run();
        window_->document().edit("ends", {}, [](Design& d) { d.fabrics[0].ends_per_cm = 30; });
        const QString path = playback().path();
        setMarked(path, true); // the list does not know
        window_->setWorkspace(Workspace::compare);
        auto asked = press("Forget");
        button("Forget Older…")->click();
        QVERIFY(!asked->isEmpty() && QFile::exists(path));
        setMarked(path, false);
        QVERIFY(QFile::remove(path)); // forgotten there, and its number taken by another run
        QFile other(path);
        QVERIFY(other.open(QIODevice::WriteOnly) && other.write("another run") > 0);
        other.close();
        asked = press("OK");
        Q_EMIT compareView().forgetRequested(path);
        QTRY_VERIFY(asked->contains("no longer the run"));
        QVERIFY(QFile::exists(path));
    }

    void aRunThatIsBeingWrittenIsNotDeleted()
    {
        startLongRun();
        const QString path = playback().path();
        window_->compare().project().forget(path);
        QVERIFY(QFile::exists(path));
        simulation().cancel();
        QTRY_VERIFY_WITH_TIMEOUT(!simulation().running(), 10000);
        window_->compare().project().forget(path);
        QVERIFY(!QFile::exists(path));
    }

    void olderRunsAreForgottenUnlessTheyAreMarked()
    {
        run();
        run();
        const QString marked = runs().runs()[0].path, older = runs().runs()[1].path;
        window_->document().edit("ends", {}, [](Design& d) { d.fabrics[0].ends_per_cm = 30; });
        run();
        window_->setWorkspace(Workspace::compare);
        list()->setCurrentItem(list()->topLevelItem(0));
        button("Keep")->click();
        QVERIFY(isMarked(marked));
        QCOMPARE(list()->topLevelItem(0)->text(5), QString("kept, older design: fabric"));
        const auto asked = press("Forget");
        button("Forget Older…")->click();
        QVERIFY2(asked->contains("2: ") && !asked->contains("1: "), qPrintable(*asked));
        QVERIFY(QFile::exists(marked) && !QFile::exists(older));
        QCOMPARE(runs().runs().size(), std::size_t{2});
        QVERIFY(!button("Forget Older…")->isEnabled());
    }

    void aFolderThatCannotBeWrittenStopsNoRun()
    {
        QFile inTheWay(runFolderOf(project_));
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        QSignalSpy failed(&window_->compare().project(), &ProjectRuns::failed);
        run();
        QCOMPARE(failed.count(), 1);
        QVERIFY(playback().path().startsWith(Recovery::standardFolder()));
        trigger("Save");
        const auto asked = press("Delete the Run");
        QVERIFY(window_->close());
        QVERIFY(!asked->isEmpty());
    }

    void thePictureOfAComparisonIsWhatIsSeen()
    {
        run();
        window_->setWorkspace(Workspace::compare);
        QSignalSpy mapped(&compareView(), &CompareView::mapsChanged);
        QTRY_VERIFY_WITH_TIMEOUT(compareView().maps().size() == 1 && compareView().maps()[0]->map().maximum() > 0, 10000);
        const QString path = QFileInfo(project_).absolutePath() + "/seen.png";
        QCoreApplication::processEvents(); // the page has come, and is laid out now
        chooseFile(path);
        trigger("Save Picture…");
        const QImage saved(path);
        const QImage seen = compareView().picture();
        QVERIFY(!saved.isNull());
        QCOMPARE(saved.convertToFormat(QImage::Format_RGB32), seen.convertToFormat(QImage::Format_RGB32));
        QVERIFY(saved.size() != window_->viewport().picture().size());
        compareView().choose(playback().path(), false);
        const auto asked = answer(QMessageBox::Ok);
        trigger("Save Picture…");
        QTRY_VERIFY(*asked); // nothing is compared
    }

    void clothsIn3dLookFromOneSide()
    {
        run();
        window_->document().edit("an angle", {}, [](Design& design) { design.fabrics[0].contact_angle_deg = 70; });
        run();
        window_->setWorkspace(Workspace::compare);
        for (const KeptRun& each : runs().runs()) { compareView().choose(each.path, true); }
        auto* view = compareView().findChild<ClothsView*>();
        QVERIFY(view->cloths().empty()); // nothing is built before it is seen
        for (auto* tabs : compareView().findChildren<QTabWidget*>()) {
            if (tabs->indexOf(view) >= 0) { tabs->setCurrentWidget(view); }
        }
        QTRY_COMPARE_WITH_TIMEOUT(view->cloths().size(), std::size_t{2}, 10000);
        const TextileCanvas *one = view->cloths()[0]->canvas(), *other = view->cloths()[1]->canvas();
        QTRY_VERIFY_WITH_TIMEOUT(one->fabric() && other->fabric(), 20000);
        view->cloths()[0]->canvas()->turnBy({40, 10});
        QVERIFY(one->camera() == other->camera());
        view->cloths()[1]->canvas()->zoomBy(1.5);
        QVERIFY(one->camera() == other->camera());
    }

    void aRecordingThatIsOpenedLeavesAProjectWithRunsOpen()
    {
        run();
        trigger("Save");
        const QString other = folder_.filePath("elsewhere.hygrorec");
        QFile::remove(other);
        QVERIFY(QFile::copy(playback().path(), other));
        QVERIFY(window_->openFile(other));
        QTRY_COMPARE_WITH_TIMEOUT(runs().runs().size(), std::size_t{2}, 20000);
        QCOMPARE(window_->document().path(), project_);
        Q_EMIT compareView().forgetRequested(other);
        QVERIFY(QFile::exists(other)); // it is not the project's
        QCOMPARE(runs().runs().size(), std::size_t{1});
    }

private:
    void startLongRun()
    {
        shortenExperiment(3600, 10, 5);
        simulationPanel().setFidelity(Fidelity::draft); // seconds long
        window_->run().start();
        QTRY_VERIFY_WITH_TIMEOUT(playback().live() && playback().frames() > 1, 30000);
        simulation().setPaused(true); // or it ends while the test goes on
        QVERIFY(simulation().running());
    }

    /// Agrees to stop the run, and answers the question after that. Returns what that one asked.
    std::shared_ptr<std::shared_ptr<QString>> stopAndThenPress(const QString& text)
    {
        auto next = std::make_shared<std::shared_ptr<QString>>(std::make_shared<QString>());
        meet<QMessageBox>([this, next, text](QMessageBox* stop) {
            *next = press(text);
            for (QAbstractButton* button : stop->buttons()) {
                if (button->text().contains("Stop")) { button->click(); }
            }
        });
        return next;
    }

    static QStringList unsavedWork() { return QDir(Recovery::standardFolder()).entryList({"*.hygro"}, QDir::Files); }
    static QString unsavedRuns()
    {
        const QStringList folders = QDir(Recovery::standardFolder()).entryList({"*-runs"}, QDir::Dirs);
        return folders.isEmpty() ? QString() : Recovery::standardFolder() + "/" + folders.first();
    }
};

QTEST_MAIN(TestProjectRuns)
#include "tst_project_runs.moc"
