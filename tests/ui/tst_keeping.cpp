// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a designer has made is not lost: not while it is typed, nor when it is saved over, nor in a crash. Needs a display: xvfb-run.
#include "core/project/project_file.h"
#include "ui/basics/quantity_edit.h"
#include "ui/document/run_folder.h"
#include "ui/panels/droplet_section.h"
#include "ui/panels/experiment_panel.h"
#include "ui/picture/textile_canvas.h"
#include "ui/weave/weave_editor.h"
#include "ui/window/design_workspace.h"
#include "window_test.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QLineEdit>
#include <QSpinBox>
#include <QToolButton>
#include <QWheelEvent>

#include <algorithm>

using namespace hygroloom;

class TestKeeping : public WindowTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        useOwnSettings();
        QVERIFY(QFile::copy(example("one-drop-on-cotton"), project()));
    }

    void init()
    {
        openWindow();
        QVERIFY(window_->openFile(project()));
    }

    void cleanup()
    {
        window_.reset();
        QDir(runFolderOf(project())).removeRecursively();
    }

    void savingCommitsTheValueBeingEdited()
    {
        type("Ends", "31");
        QCOMPARE(window_->document().fabric()->ends_per_cm, 35.0); // not taken yet
        trigger("Save");
        QCOMPARE(read_project(project().toStdString()).fabrics[0].ends_per_cm, 31.0);
        QVERIFY(!window_->isWindowModified());
    }

    void whatAnotherProgramWroteIsNotReplacedUnasked()
    {
        Design other = read_project(project().toStdString());
        const Design before = other;
        other.fabrics[0].picks_per_cm = 21;
        write_project(other, project().toStdString());
        type("Ends", "32");
        const auto first = press("Cancel");
        trigger("Save");
        QVERIFY2(first->contains("another program changed"), qPrintable(*first));
        QCOMPARE(read_project(project().toStdString()).fabrics[0].picks_per_cm, 21.0);
        QVERIFY(window_->isWindowModified());
        const auto other_version = press("Open the Other Version");
        trigger("Save");
        QVERIFY(!other_version->isEmpty());
        QCOMPARE(window_->document().fabric()->picks_per_cm, 21.0);
        QVERIFY(!window_->isWindowModified());
        window_->document().edit("ends", {}, [](Design& design) { design.fabrics[0].ends_per_cm = 32; });
        write_project(before, project().toStdString());
        const auto second = press("Replace the File");
        trigger("Save");
        QVERIFY(!second->isEmpty());
        QCOMPARE(read_project(project().toStdString()).fabrics[0].ends_per_cm, 32.0);
        QCOMPARE(read_project(project().toStdString() + "~").fabrics[0].picks_per_cm, before.fabrics[0].picks_per_cm);
        window_->document().history()->undo();
        trigger("Save"); // nothing is asked when nobody else wrote
        QVERIFY(read_project(project().toStdString()).fabrics[0].ends_per_cm != 32);
        write_project(before, project().toStdString());
    }

    void runningCommitsTheValueBeingEdited()
    {
        window_->setWorkspace(Workspace::simulate);
        simulationPanel().setFidelity(Fidelity::draft);
        type("Duration", "0.2 s");
        QSignalSpy started(&playback(), &Playback::runChanged);
        QSignalSpy ended(&simulation(), &QueuedRun::ended);
        trigger("Run");
        QTRY_VERIFY_WITH_TIMEOUT(started.count() == 1, 10000);
        simulation().cancel();
        QTRY_VERIFY_WITH_TIMEOUT(ended.count() == 1, 10000);
        QCOMPARE(playback().run()->design.experiments[0].duration_s, 0.2);
    }

    void closingAsksAboutTheValueBeingEdited()
    {
        type("Ends", "29");
        const auto asked = answer(QMessageBox::Cancel);
        QVERIFY(!window_->close());
        QVERIFY(*asked);
    }

    void aWeaveThatWasTypedIsWovenWhenTheFieldIsLeft()
    {
        auto* pattern = window_->findChild<WeaveEditor*>()->findChild<QComboBox*>();
        QCOMPARE(pattern->findText("twill 7/1 S"), -1);
        pattern->setFocus();
        pattern->lineEdit()->selectAll();
        QTest::keyClicks(pattern->lineEdit(), "twill 7/1 S");
        QTest::keyClick(pattern, Qt::Key_Tab);
        QCOMPARE(window_->document().fabric()->weave.pattern(), std::string("twill 7/1 S"));
    }

    void undoWorksInEveryField()
    {
        window_->design().docks().draft->show();
        QTRY_VERIFY((QApplication::setActiveWindow(window_.get()), window_->isActiveWindow())); // there may be no window manager to do it
        const double before = window_->document().fabric()->ends_per_cm;
        for (const Workspace workspace : {Workspace::design, Workspace::simulate}) {
            window_->setWorkspace(workspace);
            QTest::qWait(50);
            int tried = 0;
            for (QWidget* field : window_->findChildren<QWidget*>()) {
                const bool taken = qobject_cast<QLineEdit*>(field) || qobject_cast<QAbstractSpinBox*>(field);
                if (!taken || !field->isVisible() || !field->isEnabled() || field->focusPolicy() == Qt::NoFocus) { continue; }
                ++tried;
                window_->document().edit("ends", {}, [](Design& d) { d.fabrics[0].ends_per_cm = 27; });
                field->setFocus();
                QWidget* focused = QApplication::focusWidget();
                QTest::keyClick(focused, Qt::Key_Z, Qt::ControlModifier);
                QVERIFY2(window_->document().fabric()->ends_per_cm == before,
                         qPrintable(field->accessibleName() + " in " + field->parentWidget()->metaObject()->className()));
            }
            QVERIFY(tried > 6);
        }
    }

    void theRepeatsBoxesUndoTheirOwnStepAndTheDesigns()
    {
        auto* box = window_->findChild<WeaveEditor*>()->findChild<QSpinBox*>();
        box->setFocus();
        const std::string before = window_->document().fabric()->weave.pattern();
        box->selectAll();
        QTest::keyClicks(box, "7");
        QTest::keyClick(box, Qt::Key_Return);
        QCOMPARE(window_->document().fabric()->weave.ends(), 7);
        QTest::keyClick(box, Qt::Key_Up);
        QCOMPARE(window_->document().fabric()->weave.ends(), 8);
        QTest::keyClicks(box, "9"); // typed, not committed: its own
        QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(window_->document().fabric()->weave.ends(), 8);
        while (window_->document().modified()) {
            const int index = window_->document().history()->index();
            QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
            QVERIFY(window_->document().history()->index() < index);
        }
        QCOMPARE(window_->document().fabric()->weave.pattern(), before);
        QCOMPARE(box->value(), window_->document().fabric()->weave.ends());
    }

    void aDropFallsWhereTheFabricIsClicked()
    {
        window_->setWorkspace(Workspace::simulate);
        TextileCanvas* canvas = window_->viewport().canvas();
        if (!canvas) { QSKIP("no OpenGL"); }
        QTRY_VERIFY_WITH_TIMEOUT(canvas->fabric(), 10000);
        QCOMPARE(canvas->drops().size(), std::size_t{1});
        auto* panel = window_->findChild<ExperimentPanel*>();
        const QPoint aside = canvas->camera().project({3, -2, 0.2F}, QSizeF(canvas->size())).toPoint();
        QTest::mouseClick(canvas, Qt::LeftButton, {}, aside);
        QVERIFY(!window_->document().modified()); // not asked for
        for (QToolButton* button : panel->findChildren<QToolButton*>()) {
            if (button->accessibleName().startsWith("Place the droplet")) { button->click(); }
        }
        QVERIFY(panel->droplets().placing());
        QTest::mouseClick(canvas, Qt::LeftButton, {}, aside);
        const auto& at = window_->document().experiment()->droplets[0].at_mm;
        QVERIFY2(std::abs(at[0] - 3) < 0.3 && std::abs(at[1] + 2) < 0.3, qPrintable(QString("%1, %2").arg(at[0]).arg(at[1])));
        QCOMPARE(canvas->drops()[0], QPointF(at[0], at[1]));
        QTest::keyClick(canvas, Qt::Key_Escape);
        QVERIFY(!panel->droplets().placing());
        window_->document().history()->undo();
        QVERIFY(!window_->document().modified());
    }

    void theWheelChangesNoChoice()
    {
        for (const bool focused : {false, true}) {
            for (QComboBox* choice : window_->findChildren<QComboBox*>()) {
                if (!choice->isVisible() || !choice->isEnabled()) { continue; }
                if (focused) { choice->setFocus(); }
                const QPointF at = choice->rect().center();
                QWheelEvent turn(at, choice->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
                QApplication::sendEvent(choice, &turn);
                QVERIFY2(!window_->document().modified(), qPrintable(choice->accessibleName()));
                QVERIFY2(!turn.isAccepted(), qPrintable(choice->accessibleName())); // goes on to the panel, which scrolls
            }
        }
    }

    void aRecordingThatCannotBeCopiedLeavesTheOneThatWasThere()
    {
        run();
        const QString saved = folder_.filePath("saved.hygrorec");
        QFile old(saved);
        QVERIFY(old.open(QIODevice::WriteOnly));
        old.write("an older recording");
        old.close();
        QVERIFY(QFile::remove(playback().path()));
        saveRecording(saved);
        QTRY_VERIFY(QApplication::activeModalWidget());
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        QVERIFY(box && box->text().contains("saved.hygrorec"));
        box->close();
        QVERIFY(old.open(QIODevice::ReadOnly));
        QCOMPARE(old.readAll(), QByteArray("an older recording"));
    }

    void aSavedRecordingReplacesTheOneThatWasThere()
    {
        run();
        const QString saved = folder_.filePath("saved.hygrorec");
        saveRecording(saved);
        QTRY_COMPARE(QFileInfo(saved).size(), QFileInfo(playback().path()).size());
    }

    void anotherRunLeavesTheEarlierOne()
    {
        run();
        const QString first = playback().path();
        window_->document().edit("ends", {}, [](Design& d) { d.fabrics[0].ends_per_cm = 30; });
        run();
        QVERIFY(playback().path() != first);
        QCOMPARE(runs().runs().size(), std::size_t{2});
        QVERIFY(QFile::exists(first));
        Q_EMIT compareView().runRequested(first);
        QTRY_COMPARE_WITH_TIMEOUT(playback().path(), first, 5000);
        QTRY_VERIFY_WITH_TIMEOUT(playback().frame(), 5000);
        QCOMPARE(window_->document().fabric()->ends_per_cm, 30.0); // the project stays
        QVERIFY(window_->run().sample().resultsAreStale());
        QVERIFY(!QSettings().value("recent").toStringList().contains(first)); // it belongs to the project
    }

    void unsavedWorkOutlivesACrash()
    {
        QTemporaryDir folder;
        const QString crashed = folder.filePath("crashed.hygro");
        {
            Document document;
            Recovery recovery(document, folder.path());
            QVERIFY(document.open(project()));
            QSignalSpy kept(&recovery, &Recovery::kept);
            document.edit("ends", {}, [](Design& d) { d.fabrics[0].ends_per_cm = 27; });
            QVERIFY(kept.wait(5000));
            QVERIFY(recovery.leftOver().empty()); // it is in use
            const QString own = QDir(folder.path()).entryInfoList({"*.hygro"}).first().absoluteFilePath();
            QVERIFY(QFile::copy(own, crashed) && QFile::copy(own + ".origin", crashed + ".origin")); // a copy, as the lock is its process's
            document.history()->undo();
            QTRY_VERIFY(!QFile::exists(own)); // nothing is unsaved any more
        }
        Document document;
        Recovery recovery(document, folder.path());
        const std::vector<LeftOver> left = recovery.leftOver();
        QCOMPARE(left.size(), std::size_t{1});
        QCOMPARE(left.front().path, project());
        QCOMPARE(left.front().title, QFileInfo(project()).fileName());
        QVERIFY(recovery.open(left.front()));
        QCOMPARE(document.fabric()->ends_per_cm, 27.0);
        QCOMPARE(document.path(), project());
        QVERIFY(document.modified());
        QTRY_VERIFY_WITH_TIMEOUT(!QFile::exists(crashed), 5000); // kept anew
        QVERIFY(recovery.leftOver().empty());
        QCOMPARE(QDir(folder.path()).entryList({"*.hygro"}).size(), 1);
    }

    void aRunThatIsStoppedForAnotherRecordingIsKept()
    {
        run();
        const QString first = playback().path();
        const QString saved = folder_.filePath("first.hygrorec");
        QVERIFY(QFile::copy(first, saved));
        window_->document().edit("a longer experiment", {}, [](Design& d) { d.experiments[0].duration_s = 30; });
        simulationPanel().setFidelity(Fidelity::draft); // seconds long
        window_->run().start();
        QTRY_VERIFY_WITH_TIMEOUT(playback().live() && playback().frames() > 0, 30000);
        const QString second = playback().path();
        const auto asked = press("Stop and Keep What Is Recorded");
        QVERIFY(window_->openFile(saved));
        QVERIFY(asked->contains(QString::fromStdString(window_->document().fabric()->name)));
        QTRY_COMPARE_WITH_TIMEOUT(playback().path(), saved, 10000);
        const auto& kept = runs().runs();
        const auto stopped = std::find_if(kept.begin(), kept.end(), [&](const KeptRun& run) { return run.path == second; });
        QVERIFY(stopped != kept.end());
        QVERIFY(!stopped->complete() && stopped->own && stopped->saved);
    }

    void aJobThatFailsInTheBackgroundIsShownOnce()
    {
        NewestJob job;
        for (int times = 0; times < 3; ++times) {
            job.run([](const NewestJob::Turn&) { throw std::runtime_error("the yarns are tangled"); });
            QTRY_VERIFY(!job.busy());
        }
        QTest::qWait(50);
        const auto boxes = window_->findChildren<QMessageBox*>();
        QCOMPARE(boxes.size(), 1);
        QVERIFY2(boxes.first()->isVisible() && boxes.first()->text().contains("the yarns are tangled"), qPrintable(boxes.first()->text()));
        boxes.first()->close();
    }

    void workThatCannotBeKeptIsSaidOnce()
    {
        QTemporaryDir folder;
        const QString gone = folder.filePath("gone");
        Document document;
        Recovery recovery(document, gone);
        QVERIFY(document.open(project()));
        QSignalSpy failed(&recovery, &Recovery::failed), kept(&recovery, &Recovery::kept);
        document.edit("ends", {}, [](Design& d) { d.fabrics[0].ends_per_cm = 27; });
        QVERIFY(kept.wait(5000));
        QVERIFY(QDir(gone).removeRecursively());
        for (const double ends : {28.0, 29.0}) {
            document.edit("ends", {}, [=](Design& d) { d.fabrics[0].ends_per_cm = ends; });
            QTest::qWait(1300);
        }
        QCOMPARE(failed.count(), 1);
    }

    void workThatCannotBeLockedIsSaidOnce()
    {
        QTemporaryDir folder;
        QFile inTheWay(folder.filePath("recovery"));
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        Document document;
        Recovery recovery(document, inTheWay.fileName());
        QVERIFY(document.open(project()));
        QSignalSpy failed(&recovery, &Recovery::failed);
        for (const double ends : {28.0, 29.0}) {
            document.edit("ends", {}, [=](Design& d) { d.fabrics[0].ends_per_cm = ends; });
            QTest::qWait(1300);
        }
        QCOMPARE(failed.count(), 1);
    }

    void discardedWorkIsNotRecovered()
    {
        QTemporaryDir folder;
        {
            Document document;
            Recovery recovery(document, folder.path());
            QVERIFY(document.open(project()));
            QSignalSpy kept(&recovery, &Recovery::kept);
            document.edit("ends", {}, [](Design& d) { d.fabrics[0].ends_per_cm = 27; });
            QVERIFY(kept.wait(5000));
            document.edit("picks", {}, [](Design& d) { d.fabrics[0].picks_per_cm = 27; });
            QVERIFY(kept.wait(5000));
        }
        QVERIFY(QDir(folder.path()).isEmpty());
    }

private:
    QString project() const { return folder_.filePath("drop.hygro"); }

    void type(const QString& field, const QString& text)
    {
        for (QuantityEdit* edit : window_->findChildren<QuantityEdit*>()) {
            if (edit->accessibleName() == field && edit->isVisible()) {
                edit->setFocus();
                edit->selectAll();
                QTest::keyClicks(edit, text);
                return;
            }
        }
        QFAIL(qPrintable("There is no field " + field));
    }

    void run()
    {
        shortenExperiment(0.02, 4, 0.5);
        QSignalSpy ended(&simulation(), &QueuedRun::ended);
        window_->run().start();
        QTRY_VERIFY_WITH_TIMEOUT(ended.count() == 1, 60000);
    }

    void saveRecording(const QString& path)
    {
        chooseFile(path);
        trigger("Save Recording As");
    }
};

QTEST_MAIN(TestKeeping)
#include "tst_keeping.moc"
