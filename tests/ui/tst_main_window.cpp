// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The whole window, driven as a designer would. Needs a display: xvfb-run.
#include "core/design/draft.h"
#include "core/project/project_file.h"
#include "place_of.h"
#include "ui/basics/quantity_edit.h"
#include "ui/export/export_dialog.h"
#include "ui/panels/issues_panel.h"
#include "ui/results/chart.h"
#include "ui/results/plan_dialog.h"
#include "ui/results/results_panel.h"
#include "ui/results/timeline.h"
#include "ui/results/water_map_view.h"
#include "ui/weave/import_dialog.h"
#include "ui/weave/weave_editor.h"
#include "ui/window/command_palette.h"
#include "window_test.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenuBar>
#include <QMimeData>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBrowser>

using namespace hygroloom;

class TestMainWindow : public WindowTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        useOwnSettings();
        openWindow();
    }

    void cleanupTestCase()
    {
        simulation().cancel();
        window_.reset();
    }

    void theExampleIsShownAtOnce()
    {
        QSignalSpy preview(&window_->viewport(), &Viewport::previewUpdated);
        window_->openShippedExample();
        QTRY_VERIFY_WITH_TIMEOUT(preview.count() > 0, 5000);
        QVERIFY(window_->document().fabric());
        QVERIFY(window_->viewport().shown());
        QVERIFY(simulationPanel().canRun());
        QVERIFY(window_->windowTitle().contains("cotton"));
    }

    void changingTheWeaveChangesThePicture()
    {
        const QImage before = settled();
        QSignalSpy preview(&window_->viewport(), &Viewport::previewUpdated);
        auto* pattern = window_->findChild<WeaveEditor*>()->findChild<QComboBox*>();
        pattern->setFocus();
        pattern->lineEdit()->selectAll();
        QTest::keyClicks(pattern->lineEdit(), "satin 5/2");
        QTest::keyClick(pattern->lineEdit(), Qt::Key_Return);

        QCOMPARE(window_->document().fabric()->weave.ends(), 5);
        QTRY_VERIFY_WITH_TIMEOUT(preview.count() > 0, 5000);
        QCOMPARE(window_->viewport().shown()->textile.weave.ends(), 5);
        QVERIFY(settled() != before);
        QVERIFY(window_->isWindowModified());
    }

    void undoBringsTheWeaveBack()
    {
        QSignalSpy preview(&window_->viewport(), &Viewport::previewUpdated);
        window_->document().history()->undo();
        QCOMPARE(window_->document().fabric()->weave.pattern(), std::string("plain"));
        QTRY_VERIFY_WITH_TIMEOUT(preview.count() > 0, 5000);
        QVERIFY(!window_->isWindowModified());
    }

    void undoReachesTheDesignFromAField()
    {
        QuantityEdit* ends = nullptr;
        for (QuantityEdit* edit : window_->findChildren<QuantityEdit*>()) { ends = edit->accessibleName() == "Ends" ? edit : ends; }
        QVERIFY(ends);
        QApplication::setActiveWindow(window_.get()); // there may be no window manager to do it
        ends->setFocus();
        const double before = window_->document().fabric()->ends_per_cm;
        ends->selectAll();
        QTest::keyClicks(ends, "31");
        QTest::keyClick(ends, Qt::Key_Return);
        QCOMPARE(window_->document().fabric()->ends_per_cm, 31.0);
        QTest::keyClick(ends, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(window_->document().fabric()->ends_per_cm, before);
    }

    void aDesignThatCannotBeWovenRefusesToRun()
    {
        window_->document().edit("ends", {}, [](Design& d) { d.fabrics[0].ends_per_cm = -1; });
        QString reason;
        QVERIFY(!simulationPanel().canRun(&reason));
        QVERIFY(reason.endsWith('.'));
        window_->document().history()->undo();
        QVERIFY(simulationPanel().canRun());
    }

    void everyFieldHasAName()
    {
        for (QWidget* widget : window_->findChildren<QWidget*>()) {
            const bool field = qobject_cast<QAbstractButton*>(widget) || qobject_cast<QComboBox*>(widget) ||
                               qobject_cast<QuantityEdit*>(widget) || qobject_cast<QAbstractSlider*>(widget);
            if (!field || widget->focusPolicy() == Qt::NoFocus || widget->objectName().startsWith("qt_")) { continue; }
            const auto* button = qobject_cast<QAbstractButton*>(widget);
            QVERIFY2(
                !widget->accessibleName().isEmpty() || (button && !button->text().isEmpty()),
                qPrintable(QString("%1 in %2").arg(widget->metaObject()->className(), widget->parentWidget()->metaObject()->className())));
        }
    }

    void aRunShowsWaterOnTheMaps()
    {
        shortenExperiment(0.02, 4, 0.5);
        simulationPanel().setFidelity(Fidelity::draft); // of particles
        QSignalSpy started(&playback(), &Playback::runChanged);
        QSignalSpy ended(&simulation(), &QueuedRun::ended);
        QSignalSpy maps(&waterMaps(), &WaterMapView::mapChanged);

        window_->run().start();
        QTRY_VERIFY_WITH_TIMEOUT(started.count() == 1, 10000);
        QCOMPARE(window_->workspace(), Workspace::simulate);
        QTRY_VERIFY_WITH_TIMEOUT(maps.count() > 0, 60000);
        QTRY_VERIFY_WITH_TIMEOUT(ended.count() == 1, 120000);

        QCOMPARE(ended.first().at(0).value<QueuedRun::Outcome>(), QueuedRun::Outcome::finished);
        QVERIFY(playback().frames() > 1);
        QTRY_VERIFY_WITH_TIMEOUT(waterMaps().top().map().maximum() > 0, 5000);
        QVERIFY(waterMaps().top().circle().radius > 0);
        // Of the last frame, also when its map came after the run was complete.
        const double reached = wetted_circle(playback().run()->textile, *playback().frame(), Face::top).radius;
        QTRY_COMPARE_WITH_TIMEOUT(waterMaps().top().circle().radius, reached, 5000);
        QVERIFY(chart().points().size() > 1);
        QCOMPARE(chart().curves(), (QStringList{"free", "in yarns", "in fibres", "evaporated"}));
        QVERIFY(!window_->run().sample().resultsAreStale());
    }

    void resultsFitASmallScreenSideways()
    {
        const QSize before = window_->size();
        window_->resize(1280, 800);
        QTRY_COMPARE(window_->width(), 1280);
        window_->resetLayout();
        QTRY_VERIFY(results().viewport()->width() > 350);
        QTRY_COMPARE(results().horizontalScrollBar()->maximum(), 0);
        window_->resize(before);
    }

    void resultsSayHowTheyWereComputed()
    {
        const auto& run = playback().run();
        QVERIFY(run->wall > 0);
        const QString line = originOf(*run, false);
        QVERIFY(run->plan.expected_error);
        QVERIFY2(line.contains(QRegularExpression("^Draft, expected numerical error about [0-9.]+ %, on ")) && line.contains(", took "),
                 qPrintable(line));
        const QString text = results().text();
        QVERIFY2(text.contains(QRegularExpression("Fidelity: Draft\nExpected numerical error about [0-9.]+ %\\. Estimated from ")),
                 qPrintable(text));
        QVERIFY2(text.contains("\nDevice: " + QString::fromStdString(run->device) + "\nStarted: "), qPrintable(text));
        RunRecord other = *run;
        other.wall = 0;
        other.date.clear();
        other.plan.knobs.fibre_shells = 3;
        for (PlannedPart& part : other.plan.parts)
            if (part.name == "heat") part.forced = true;
        other.plan.expected_error.reset();
        QVERIFY(originOf(other, true).startsWith("Draft, 1 knob set, expected numerical error not known, on "));
        QVERIFY(originOf(other, true).endsWith(", running"));
        QVERIFY(originOf(other, false).endsWith(", stopped"));
        other.plan.expected_error = 0;
        other.plan.fidelity = Fidelity::reference;
        QVERIFY(originOf(other, false).contains("the reference for numerical errors"));
        other.plan.fidelity = Fidelity::draft;
        QVERIFY(originInFull(other, false).contains("fibre shells set to 3 (draft has 5)"));
        QVERIFY(originInFull(other, false)
                    .join('\n')
                    .contains(QRegularExpression("^heat switched (on|off) by the user$", QRegularExpression::MultilineOption)));
    }

    void plansSayWhichRunTheyAreOf()
    {
        window_->document().edit("another name", {}, [](Design& d) { d.experiments[0].name = "soon"; });
        QTRY_VERIFY_WITH_TIMEOUT(simulationPanel().canRun(), 5000);
        const auto reported = [](QWidget& panel) {
            auto* dialog = panel.findChild<PlanDialog*>();
            const QString text = dialog ? dialog->findChild<QTextBrowser*>()->toPlainText() : QString();
            delete dialog;
            return text;
        };
        QString next;
        const auto ask = [&] {
            simulationPanel().showPlan();
            next = reported(simulationPanel());
            return next;
        };
        QTRY_VERIFY_WITH_TIMEOUT(ask().startsWith("The next run: soon on "), 5000);
        results().showPlan();
        const QString shown = reported(results());
        const QString ran = QString::fromStdString(playback().run()->experiment);
        QVERIFY2(shown.startsWith("The run on screen: " + ran + " on ") && ran != "soon", qPrintable(shown));
        QVERIFY(shown.contains(QString::fromStdString(playback().run()->plan.parts[0].reason)));
        window_->document().history()->undo();
    }

    void scrubbingToTheStartShowsADryMap()
    {
        playback().show(0);
        QTRY_COMPARE_WITH_TIMEOUT(waterMaps().top().map().maximum(), 0.0, 5000);
        playback().show(playback().frames() - 1);
        QTRY_VERIFY_WITH_TIMEOUT(waterMaps().top().map().maximum() > 0, 5000);
    }

    void anEditMarksTheResultsStaleAndUndoDoesNot()
    {
        window_->document().edit("picks", {}, [](Design& d) { d.fabrics[0].picks_per_cm -= 1; });
        QVERIFY(window_->run().sample().resultsAreStale());
        QVERIFY(waterMaps().top().map().maximum() > 0);
        window_->document().history()->undo();
        QVERIFY(!window_->run().sample().resultsAreStale());
    }

    void theLiquidThatWasUsedMakesResultsStale()
    {
        window_->document().edit("another", {}, [](Design& d) { d.liquids = {{"oil"}}; });
        QVERIFY(!window_->run().sample().resultsAreStale());
        window_->document().edit("water", {}, [](Design& d) { d.liquids = {{"water", 72.74, 5}}; });
        QVERIFY(window_->run().sample().resultsAreStale());
        window_->document().history()->undo();
        window_->document().history()->undo();
        QVERIFY(!window_->run().sample().resultsAreStale());
    }

    void theRecordingOpensAgain()
    {
        const QString path = playback().path();
        const int frames = playback().frames();
        const double water = waterMaps().top().map().maximum(), range = waterMaps().range();
        QSignalSpy opened(&playback(), &Playback::opened);
        QVERIFY(window_->openFile(path));
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 10000);
        QCOMPARE(playback().frames(), frames);
        QTRY_VERIFY_WITH_TIMEOUT(qAbs(waterMaps().top().map().maximum() - water) <= 1e-5 * water, 5000);
        QTRY_VERIFY_WITH_TIMEOUT(chart().points().size() == frames, 10000);
        QTRY_COMPARE_WITH_TIMEOUT(waterMaps().range(), range, 5000);
        QVERIFY(playback().run()->wall > 0 && !playback().run()->date.empty());
    }

    void playingMovesThroughTheRecording()
    {
        playback().show(0);
        timeline().togglePlaying();
        QVERIFY(timeline().playing());
        QTRY_VERIFY_WITH_TIMEOUT(playback().current() > 0, 5000);
        if (timeline().playing()) { timeline().togglePlaying(); }
    }

    void aRunCanBePausedAndStopped()
    {
        window_->document().edit("a long experiment", {}, [](Design& d) { d.experiments[0].duration_s = 60; });
        QSignalSpy started(&playback(), &Playback::runChanged);
        QSignalSpy progressed(&simulation(), &QueuedRun::progressed);
        QSignalSpy ended(&simulation(), &QueuedRun::ended);
        window_->run().start();
        QTRY_VERIFY_WITH_TIMEOUT(started.count() == 1 && progressed.count() > 0, 20000);

        simulation().setPaused(true);
        QVERIFY(simulation().paused());
        simulation().setPaused(false);
        simulation().cancel();

        QTRY_VERIFY_WITH_TIMEOUT(ended.count() == 1, 2000);
        QCOMPARE(ended.first().at(0).value<QueuedRun::Outcome>(), QueuedRun::Outcome::cancelled);
        QVERIFY(!simulation().running());
    }

    void savingAndOpeningKeepsTheDesign()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("kept.hygro");
        QVERIFY(window_->document().saveAs(path));
        const std::string text = format_project(*window_->document().design());
        QVERIFY(window_->openFile(path));
        QCOMPARE(format_project(*window_->document().design()), text);
        QVERIFY(window_->windowTitle().contains("kept.hygro"));
    }

    void aDroppedProjectIsOpened()
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(QString(HYGROLOOM_SOURCE_DIR) + "/resources/examples/textile-A.hygro")});
        QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window_.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window_.get(), &drop);
        QVERIFY(window_->windowTitle().contains("textile-A"));
        QVERIFY(QSettings().value("recent").toStringList().first().endsWith("textile-A.hygro"));
    }

    void thePapersExperimentsAreInTheMenu()
    {
        window_->openShippedExample(); // nothing to save
        CommandPalette palette(*window_->menuBar());
        palette.search("figure 08");
        QCOMPARE(palette.shown(), 1);
        palette.chosen()->trigger();
        QVERIFY(window_->document().fabric());
        QCOMPARE(window_->document().fabric()->name, std::string("Textile C"));
    }

    void aDroppedDraftAsksAndBecomesACandidate()
    {
        const QString path = QString(HYGROLOOM_SOURCE_DIR) + "/tests/data/wif/desired_basic_wif__two_color_liftplan.wif";
        const std::size_t before = window_->document().design()->fabrics.size();
        for (const bool agreed : {false, true}) {
            bool asked = false;
            QTimer::singleShot(200, this, [&] {
                if (auto* page = qobject_cast<ImportDialog*>(QApplication::activeModalWidget())) {
                    asked = true;
                    agreed ? page->accept() : page->reject();
                }
            });
            QMimeData data;
            data.setUrls({QUrl::fromLocalFile(path)});
            QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(window_.get(), &enter);
            QVERIFY(enter.isAccepted());
            QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(window_.get(), &drop);
            QVERIFY(asked);
            QCOMPARE(window_->document().design()->fabrics.size(), before + (agreed ? 1 : 0));
        }
        QVERIFY(window_->document().fabric()->weave.draft());
        window_->document().history()->undo();
        QCOMPARE(window_->document().design()->fabrics.size(), before);
    }

    void exportDraftWritesTheChosenFabricsDraft()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("chosen.wif");
        QTimer::singleShot(200, this, [&] {
            if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
                dialog->findChild<QLineEdit*>()->setText(path);
                QMetaObject::invokeMethod(dialog, "accept");
            }
        });
        trigger("Export Draft");
        const DraftImport read = import_draft(path.toStdString());
        QVERIFY(read.fabric.weave.same_matrix(window_->document().fabric()->weave));
        QCOMPARE(read.fabric.ends_per_cm, window_->document().fabric()->ends_per_cm);
    }

    void exportMeshOpensOneDialogBesideTheWindow()
    {
        trigger("Export Mesh");
        trigger("Export Mesh");
        const auto dialogs = window_->findChildren<ExportDialog*>();
        QCOMPARE(dialogs.size(), 1);
        QVERIFY(dialogs.first()->isVisible());
        QVERIFY(!dialogs.first()->isModal());
        dialogs.first()->close();
        QTRY_VERIFY(window_->findChildren<ExportDialog*>().isEmpty());
    }

    void closingAsksAboutAnExport()
    {
        QTemporaryDir folder;
        trigger("Export Mesh");
        auto* dialog = window_->findChild<ExportDialog*>();
        for (QComboBox* box : dialog->findChildren<QComboBox*>()) {
            box->setCurrentIndex(box->accessibleName() == "Detail" ? 2 : 1); // PLY, fibres, a size
        }
        for (QuantityEdit* edit : dialog->findChildren<QuantityEdit*>()) {
            if (edit->accessibleName() == "Width along the weft" || edit->accessibleName() == "Height along the warp") {
                edit->setText("20 mm");
            }
        }
        dialog->setFile(folder.filePath("large.ply"));
        QSignalSpy ended(dialog, &ExportDialog::ended);
        dialog->start();
        QVERIFY(dialog->writing());
        bool asked = false;
        QTimer::singleShot(100, this, [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                asked = true;
                QTest::mouseClick(box->button(QMessageBox::Cancel), Qt::LeftButton);
            }
        });
        QVERIFY(!window_->close());
        QVERIFY(asked);
        QVERIFY(dialog->writing());

        QTimer::singleShot(100, this, [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                for (QAbstractButton* button : box->buttons()) {
                    if (button->text().remove('&') == "Stop the Export") { QTest::mouseClick(button, Qt::LeftButton); }
                }
            }
        });
        QVERIFY(window_->close());
        QCOMPARE(ended.count(), 1);
        QVERIFY(QDir(folder.path()).isEmpty(QDir::Files | QDir::Hidden));
        QCOMPARE(QSettings().value("export/detail").toInt(), 2); // the choice is kept
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    }

    void closingAsksAboutChangesBeforeItStopsAnExport()
    {
        QTemporaryDir folder;
        window_->document().edit("ends", {}, [](Design& d) { d.fabrics[0].ends_per_cm += 1; });
        trigger("Export Mesh");
        auto* dialog = window_->findChild<ExportDialog*>();
        dialog->setFile(folder.filePath("large.ply"));
        dialog->start();
        QVERIFY(dialog->writing());
        QStringList questions;
        QTimer::singleShot(100, this, [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                questions << box->windowTitle();
                QTest::mouseClick(box->button(QMessageBox::Cancel), Qt::LeftButton);
            }
        });
        QVERIFY(!window_->close());
        QCOMPARE(questions, QStringList{"Unsaved changes"});
        dialog->cancel();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog->writing(), 10000);
        dialog->close();
        window_->document().history()->undo();
    }

    void aFilesNameIsShownAsItIs()
    {
        QVERIFY(!window_->openFile("/nowhere/a<i>b.hygro"));
        auto* box = window_->findChild<QMessageBox*>();
        QVERIFY(box && box->text().contains("a<i>b.hygro"));
        QCOMPARE(box->textFormat(), Qt::PlainText);
        box->close();
    }

    void anIssueLeadsToWhatItIsAbout_data()
    {
        QTest::addColumn<QString>("where");
        QTest::addColumn<int>("fabric");
        QTest::addColumn<int>("experiment");
        QTest::addColumn<QString>("field");
        QTest::newRow("another fabric's sett") << "fabrics[1].ends_per_cm" << 1 << 0 << "Ends";
        QTest::newRow("a folded section") << "fabrics[1].flyaway.hair_length_mm" << 1 << 0 << "Hair length";
        QTest::newRow("a weft like the warp") << "fabrics[1].weft.twist_per_m" << 1 << 0 << "Twist";
        QTest::newRow("a fibre") << "fabrics[0].warp.material" << 0 << 0 << "Fibre";
        QTest::newRow("a yarn of the stripes") << "fabrics[1].extra_yarns[1].plies" << 1 << 0 << "Plies";
        QTest::newRow("a contradiction in a yarn") << "fabrics[0].warp" << 0 << 0 << "Fibre";
        QTest::newRow("an order") << "fabrics[1].weft_order[0]" << 1 << 0 << "Order of the picks";
        QTest::newRow("a weave") << "fabrics[1].weave" << 1 << 0 << "Weave on point paper";
        QTest::newRow("a fabric as a whole") << "fabrics[1]" << 1 << 0 << "Fabrics of the project";
        QTest::newRow("another experiment") << "experiments[1].duration_s" << 0 << 1 << "Duration";
        QTest::newRow("a liquid") << "liquids[0].density_kg_m3" << 0 << 0 << "Density";
        QTest::newRow("a material") << "materials[0].density_kg_m3" << 1 << 0 << "Density";
        QTest::newRow("a material's name") << "materials[0].name" << 1 << 0 << "Rename the fibre";
    }
    void anIssueLeadsToWhatItIsAbout()
    {
        QFETCH(QString, where);
        QFETCH(int, fabric);
        QFETCH(int, experiment);
        QFETCH(QString, field);
        Document& document = window_->document();
        window_->setWorkspace(Workspace::design);
        window_->resetLayout();
        document.edit("more", {}, [](Design& d) {
            d.materials.push_back(*find_library_material("cotton"));
            d.materials[0].name = "own";
            d.fabrics.push_back(d.fabrics[0]);
            d.fabrics[1].name = "striped";
            d.fabrics[1].extra_yarns = {d.fabrics[0].warp, d.fabrics[0].warp};
            d.fabrics[1].extra_yarns[0].material = {{"own", 1}};
            d.fabrics[1].weft_order = {{0, 3}, {2, 1}};
            d.experiments.push_back(d.experiments[0]);
            d.experiments[1].name = "again";
            d.liquids.push_back({"oil"});
        });
        document.setFabricIndex(0);
        document.setExperimentIndex(0);
        QApplication::setActiveWindow(window_.get());
        Q_EMIT window_->findChild<IssuesPanel*>()->issueActivated(placeOf(where));
        QTest::qWait(50);
        const QWidget* focus = window_->focusWidget();
        QVERIFY(focus);
        QString name;
        for (; focus && name.isEmpty(); focus = focus->parentWidget()) { name = focus->accessibleName(); }
        QCOMPARE(name, field);
        QCOMPARE(document.fabricIndex(), fabric);
        QCOMPARE(document.experimentIndex(), experiment);
        QVERIFY(window_->focusWidget()->isVisible());
        document.history()->undo();
        window_->resetLayout();
    }

    void closingAsksAboutUnsavedChanges()
    {
        window_->document().edit("ends", {}, [](Design& d) { d.fabrics[0].ends_per_cm += 1; });
        bool asked = false;
        QTimer::singleShot(200, this, [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                asked = true;
                QTest::mouseClick(box->button(QMessageBox::Cancel), Qt::LeftButton);
            }
        });
        QVERIFY(!window_->close());
        QVERIFY(asked);
        window_->document().history()->undo();
    }

private:
    QImage settled()
    {
        QTest::qWait(300);
        return window_->viewport().picture();
    }
};

QTEST_MAIN(TestMainWindow)
#include "tst_main_window.moc"
