// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The Garment workspace in its window: how it is reached, which commands it has, that everything fits, and the garment in 3D.
#include "core/project/project_file.h"
#include "ui/basics/quantity_edit.h"
#include "ui/compare/run_list.h"
#include "ui/document/run_folder.h"
#include "ui/garment/fit_form.h"
#include "ui/garment/flat_view.h"
#include "ui/garment/garment_edits.h"
#include "ui/garment/garment_panel.h"
#include "ui/garment/garment_view.h"
#include "ui/garment/panel_table.h"
#include "ui/garment/shape_view.h"
#include "ui/garment/wear_form.h"
#include "ui/panels/issues_panel.h"
#include "ui/results/run_history.h"
#include "ui/results/run_panel.h"
#include "ui/window/docks.h"
#include "window_test.h"

#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>

using namespace hygroloom;

class TestGarmentWindow : public WindowTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { useOwnSettings(); }
    void init()
    {
        openWindow({1280, 800});
        QVERIFY(window_->document().openExample(example("three-candidates")));
    }
    void cleanup()
    {
        window_->document().history()->setClean();
        window_.reset();
    }

    void aKeyLeadsToTheWorkspaceAndItsCommands()
    {
        QTest::keyClick(window_.get(), Qt::Key_4, Qt::ControlModifier);
        QTRY_COMPARE(window_->workspace(), Workspace::garment);
        QVERIFY(window_->run().docks().garment->isVisible() && !window_->run().actions().plan->isEnabled());
        QTest::keyClick(window_.get(), Qt::Key_2, Qt::ControlModifier);
        QTRY_COMPARE(window_->workspace(), Workspace::simulate);
        QVERIFY(!window_->run().docks().garment->isVisible() && window_->run().actions().plan->isEnabled());
    }

    void everythingFitsAt1280By800()
    {
        showTee();
        auto& garment = window_->run().garment();
        QVERIFY(garment.panel().width() >= 300);
        QVERIFY(garment.panel().widget()->width() <= garment.panel().viewport()->width());
        QVERIFY(garment.wear().widget()->width() <= garment.wear().viewport()->width());
        QVERIFY(garment.view().flat().width() >= 150);
        PanelTable& panels = garment.panel().panels(); // names are whole, in two lines at most
        for (int row = 0; row < panels.rowCount(); ++row) {
            const QRect words =
                panels.fontMetrics().boundingRect({0, 0, panels.columnWidth(0) - 6, 1000}, Qt::TextWordWrap, panels.item(row, 0)->text());
            QVERIFY2(words.width() <= panels.columnWidth(0) - 6 && words.height() <= panels.rowHeight(row),
                     qPrintable(panels.item(row, 0)->text()));
        }
        run();
        garment.view().setColors(GarmentView::Colors::share);
        QTest::qWait(50);
        garment.view().setColors(GarmentView::Colors::water);
        QTest::qWait(50);
        QCOMPARE(window_->width(), 1280);
        garment.playback().keepAsA();
        cutAllFrom(window_->document(), 0, window_->document().design()->fabrics[1].name);
        run();
        garment.view().setCompared(GarmentView::Compared::difference);
        QTest::qWait(200);
        QCOMPARE(window_->width(), 1280);
        QVERIFY(garment.view().difference().isVisible());
    }

    void gapsAndSeamsAreReachedByKey()
    {
        showTee();
        auto& garment = window_->run().garment();
        reveal(window_->run().docks().fit);
        window_->activateWindow();
        QTest::qWait(100);
        const auto& zones = gap_zones();
        garment.fit().gapOf("default")->setFocus();
        for (const std::string& zone : zones) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            QuantityEdit* edit = garment.fit().gapOf(zone);
            QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(edit));
            QVERIFY2(edit->visibleRegion().boundingRect().height() == edit->height(), zone.c_str());
        }
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(garment.fit().seamOf()));
        QTest::keyClicks(QApplication::focusWidget(), "40");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QCOMPARE(window_->document().design()->garments[0].seams.at("default"), 0.4);
    }

    void mapsAndPicturesAreSaved()
    {
        showTee();
        run();
        const QString folder = folder_.filePath("maps/of a tee"); // not there yet
        chooseFile(folder);
        trigger("Save Map…");
        for (const char* file : {"front.png", "front_texture.png", "cells.csv", "garment.obj", "garment.glb"}) {
            QTRY_VERIFY2_WITH_TIMEOUT(QFileInfo(folder + "/tee at 5 s/" + file).size() > 0, file, 20000);
        }
        chooseFile(folder);
        trigger("Save Map…");
        QTRY_VERIFY_WITH_TIMEOUT(QDir(folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size() == 2, 20000);
        const QString picture = folder_.filePath("worn.png");
        chooseFile(picture);
        trigger("Save Picture…");
        QTRY_VERIFY(QFileInfo::exists(picture));
        const QImage saved(picture);
        QCOMPARE(saved.size(), window_->run().garment().view().size() * window_->run().garment().view().devicePixelRatioF());
        // The garment in 3D is in it.
        ShapeView* shape = window_->run().garment().view().newest().shape();
        const QPoint middle = shape->mapTo(&window_->run().garment().view(), shape->rect().center());
        QCOMPARE(saved.pixelColor(middle), shape->picture().pixelColor(shape->rect().center()));
    }

    void endsOfStepsStayWithTheWindow()
    {
        const WearSteps steps{1, 2, 5, 10, 20, 50, 100, 200};
        window_->run().garment().playback().setSteps(WearValue::water, steps);
        QVERIFY(window_->close());
        openWindow({1280, 800});
        QCOMPARE(window_->run().garment().playback().ownSteps(WearValue::water), std::optional(steps));
        QVERIFY(!window_->run().garment().playback().ownSteps(WearValue::share));
        window_->run().garment().playback().setSteps(WearValue::water, std::nullopt);
        QVERIFY(window_->close());
        openWindow({1280, 800});
        QVERIFY(!window_->run().garment().playback().ownSteps(WearValue::water));
    }

    void aReportIsSavedAsPageAndAsPdf()
    {
        showTee();
        run();
        const QString page = folder_.filePath("worn.html"), pdf = folder_.filePath("worn.pdf");
        chooseFile(page);
        trigger("Save Report…");
        QTRY_VERIFY_WITH_TIMEOUT(QFileInfo(page).size() > 0, 60000);
        QFile html(page);
        QVERIFY(html.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(html.readAll());
        for (const char* words : {"Zones of the body", "<th>front</th>", "Water by panel", "not accounted for", "tee, wear"}) {
            QVERIFY2(text.contains(words), words);
        }
        QVERIFY(!text.contains("The run was stopped"));
        const auto panels = static_cast<qsizetype>(window_->run().garment().playback().run()->layout().panels.size());
        QVERIFY(text.count("<img ") >= panels && text.count("<img ") <= 4 * panels);
        chooseFile(pdf);
        trigger("Save Report…");
        QTRY_VERIFY_WITH_TIMEOUT(QFileInfo(pdf).size() > 10000, 60000);
        QFile written(pdf);
        QVERIFY(written.open(QIODevice::ReadOnly));
        QVERIFY(written.read(5) == "%PDF-");
    }

    /// As of every other experiment: in name.hygro-runs, and there again when the project is opened.
    void runsStayWithTheirProject()
    {
        showTee();
        run();
        window_->document().history()->setClean(); // the question about changes is another's
        auto asked = press("Cancel");
        QVERIFY(!window_->close()); // the project has no file yet
        QVERIFY2(asked->contains("tee, wear"), qPrintable(*asked));
        const QString project = folder_.filePath("worn.hygro"), recording = runFolderOf(project) + "/run-1.hygrorec";
        chooseFile(project);
        trigger("Save As…");
        QCOMPARE(window_->run().garment().playback().run()->file, recording);
        QVERIFY(isGarmentRecording(recording));
        run();
        QCOMPARE(window_->run().garment().playback().run()->file, runFolderOf(project) + "/run-2.hygrorec");
        const double water = window_->run().garment().playback().frame()->ledger.water_liquid;
        QVERIFY(window_->close());

        openWindow({1280, 800});
        QVERIFY(window_->openFile(project));
        window_->setWorkspace(Workspace::garment);
        auto* list = window_->run().list().findChild<QTreeWidget*>();
        QTRY_COMPARE_WITH_TIMEOUT(list->topLevelItemCount(), 2, 20000);
        QCOMPARE(list->topLevelItem(1)->text(0), QString("2: tee of Cotton plain"));
        QCOMPARE(list->topLevelItem(1)->text(1), QString("wear"));
        QVERIFY2(!list->topLevelItem(1)->text(5).contains("older"), qPrintable(list->topLevelItem(1)->text(5)));
        QVERIFY(!window_->run().garment().playback().run());
        const auto labels = window_->run().garment().view().findChildren<QLabel*>();
        QLabel* offer = *std::find_if(labels.begin(), labels.end(), [](QLabel* l) { return l->accessibleName() == "Run that is kept"; });
        QVERIFY(offer->isVisible() && offer->text().contains("Open the kept run of") && !offer->text().contains("older"));
        Q_EMIT offer->linkActivated("run");
        QTRY_VERIFY_WITH_TIMEOUT(window_->run().garment().playback().whole(), 20000);
        QCOMPARE(window_->run().garment().playback().run()->file, runFolderOf(project) + "/run-2.hygrorec"); // the newest
        QVERIFY(!offer->isVisible());
        QCOMPARE(runs().runs().size(), std::size_t{2}); // no third one
        window_->run().garment().playback().show(window_->run().garment().playback().frames() - 1);
        QCOMPARE(window_->run().garment().playback().frame()->ledger.water_liquid, water);
        // Compare has both, once it has read their numbers.
        window_->setWorkspace(Workspace::compare);
        for (const auto* tree : compareView().findChildren<QTreeWidget*>()) { QCOMPARE(tree->topLevelItemCount(), 2); }
        QTRY_VERIFY_WITH_TIMEOUT(whyNotCompared(runs().runs()[0], runs().runs()[1]).isEmpty(), 20000);
        window_->setWorkspace(Workspace::garment);

        editWear(window_->document(), "longer", 0, {}, [](WearExperiment& wear) { wear.duration_s = 30; });
        QVERIFY2(list->topLevelItem(0)->text(5).contains("older design"), qPrintable(list->topLevelItem(0)->text(5)));
        list->setCurrentItem(list->topLevelItem(1));
        button("Keep")->click();
        QVERIFY(isMarked(runFolderOf(project) + "/run-2.hygrorec"));
        asked = press("Forget");
        button("Forget Older…")->click();
        QVERIFY2(asked->contains("1: tee, wear"), qPrintable(*asked));
        QVERIFY(!QFile::exists(recording));
        QCOMPARE(list->topLevelItemCount(), 1);
        list->setCurrentItem(list->topLevelItem(0));
        asked = press("Forget");
        button("Forget…")->click();
        QVERIFY(!QDir(runFolderOf(project)).exists());
        QCOMPARE(list->topLevelItemCount(), 0);
    }

    /// In memory, in the file, and in the steps that are undone and done again.
    void filesOfAGarmentAreFoundAfterSaveAs()
    {
        const QDir folder(folder_.path());
        QVERIFY(folder.mkpath("one/files") && folder.mkpath("two/deeper"));
        QVERIFY(QFile::copy(QString(HYGROLOOM_SOURCE_DIR) + "/tests/data/garments/tee.json", folder.filePath("one/files/tee.json")));
        for (const char* name : {"one/zones.csv", "one/rates.csv"}) { QVERIFY(QFile(folder.filePath(name)).open(QIODevice::WriteOnly)); }
        Document& document = window_->document();
        QVERIFY(document.saveAs(folder.filePath("one/worn.hygro")));
        addGarmentFile(document, folder.filePath("one/files/tee.json"));
        QCOMPARE(document.design()->garments[0].source, std::string("files/tee.json"));
        editGarment(document, "zones", 0, {}, [](Garment& garment) { garment.wearer.zones = "zones.csv"; });
        editWear(document, "rates", 0, {}, [](WearExperiment& wear) { wear.activity_file = "rates.csv"; });
        const Design before = *document.design();
        const QString project = folder.filePath("two/deeper/worn.hygro");
        chooseFile(project);
        trigger("Save As…");
        const auto expectMoved = [](const Design& design) {
            QCOMPARE(design.garments[0].source, std::string("../../one/files/tee.json"));
            QCOMPARE(design.garments[0].wearer.zones, std::string("../../one/zones.csv"));
            QCOMPARE(design.wears[0].activity_file, std::string("../../one/rates.csv"));
        };
        expectMoved(*document.design());
        expectMoved(read_project(project.toStdString()));
        QVERIFY(garmentHoldsFor(before, before.garments[0].name, before.wears[0].name, *document.design()));
        QVERIFY(!document.modified());
        QTRY_VERIFY(window_->run().garment().choice().drawing());
        document.history()->undo();
        document.history()->undo();
        QCOMPARE(document.design()->garments[0].source, std::string("../../one/files/tee.json"));
        QCOMPARE(document.design()->garments[0].wearer.zones, Wearer{}.zones);
        document.history()->redo();
        document.history()->redo();
        expectMoved(*document.design());
        QVERIFY(!document.modified());
    }

    void aRunIsSavedToAnotherFile()
    {
        showTee();
        run();
        auto& garment = window_->run().garment();
        const QString file = folder_.filePath("afterwards.hygrorec");
        chooseFile(file);
        trigger("Save Recording As…");
        QTRY_VERIFY_WITH_TIMEOUT(runs().runs().size() == 1 && runs().runs()[0].copy == file, 20000);
        QVERIFY(isSaved(runs().runs()[0]));
        const WearRecording saved(file.toStdString());
        QVERIFY(saved.finished());
        QCOMPARE(saved.frames(), garment.playback().frames());
        const auto last = garment.playback().run()->frames.back();
        QCOMPARE(saved.frame(saved.frames() - 1).inside.size(), last->inside.size());
        QCOMPARE(saved.frame(saved.frames() - 1).ledger.water_liquid, last->ledger.water_liquid);
    }

    void aRunKeptAsAIsSavedWhileTheNextOneRuns()
    {
        showTee();
        run();
        auto& garment = window_->run().garment();
        garment.playback().keepAsA();
        const auto a = garment.playback().kept();
        editWear(window_->document(), "longer", 0, {}, [](WearExperiment& wear) { wear.duration_s = 36000; });
        QTRY_VERIFY(window_->run().panel().canRun());
        window_->run().start();
        QTRY_VERIFY_WITH_TIMEOUT(garment.playback().run() != a, 60000);
        const QString file = folder_.filePath("a.hygrorec");
        chooseFile(file);
        trigger("Save A As…");
        QTRY_VERIFY_WITH_TIMEOUT(runs().find(a->file) && runs().find(a->file)->copy == file, 20000);
        const WearRecording saved(file.toStdString());
        QVERIFY(saved.finished());
        QCOMPARE(saved.frames(), static_cast<int>(a->frames.size()));
        // The next run goes on where Return answers the question on closing, and Save is the answer to the one about its runs.
        window_->document().history()->setClean();
        const auto defaultOf = [this] {
            auto words = std::make_shared<QString>();
            meet<QMessageBox>([words](QMessageBox* box) {
                for (QAbstractButton* button : box->buttons()) {
                    auto* push = qobject_cast<QPushButton*>(button);
                    if (push && push->isDefault()) { *words = push->text().remove('&'); }
                }
                QTest::keyClick(box, Qt::Key_Escape);
            });
            return words;
        };
        auto words = defaultOf();
        QVERIFY(!window_->close());
        QCOMPARE(*words, QString("Let It Run"));
        QVERIFY(window_->run().run().running());
        window_->run().stopRun();
        words = defaultOf();
        QVERIFY(!window_->close());
        QCOMPARE(*words, QString("Save the Project"));
        QVERIFY(QFileInfo::exists(a->file));
    }

    void aRunOfAChangedDesignIsOutOfDate()
    {
        showTee();
        run();
        const auto captions = [this] {
            QStringList texts;
            for (const QLabel* label : window_->run().garment().view().newest().findChildren<QLabel*>()) { texts << label->text(); }
            return texts.join(' ');
        };
        QVERIFY(!captions().contains("Out of date"));
        editWear(window_->document(), "longer", 0, {}, [](WearExperiment& wear) { wear.duration_s = 30; });
        QVERIFY2(captions().contains("Out of date"), qPrintable(captions()));
        window_->document().history()->undo();
        QVERIFY(!captions().contains("Out of date"));
    }

    void thePlaceUnderThePointerIsThatOfTheFlatPanel()
    {
        showTee();
        ShapeView* shape = window_->run().garment().view().newest().shape();
        QVERIFY(shape);
        QVERIFY2(shape->problem().isEmpty(), qPrintable(shape->problem()));
        shape->lookFrom(0);
        QTest::qWait(100);
        const QPointF middle(0.5 * shape->width(), 0.5 * shape->height());
        const GarmentSpot spot = shape->spotAt(middle);
        const auto& drawing = window_->run().garment().choice().drawing();
        QVERIFY(spot.panel >= 0);
        QCOMPARE(drawing->panels[static_cast<std::size_t>(spot.panel)].name, std::string("front"));
        QVERIFY(drawing->panels[static_cast<std::size_t>(spot.panel)].path.contains(
            QPointF(spot.flat[0] + drawing->panels[static_cast<std::size_t>(spot.panel)].on_sheet[0],
                    spot.flat[1] + drawing->panels[static_cast<std::size_t>(spot.panel)].on_sheet[1])));
        // Its colour, which light dims a little.
        const QImage picture = shape->picture();
        const QColor drawn = picture.pixelColor((middle * picture.devicePixelRatio()).toPoint()), own = fabricColor(0);
        QVERIFY2(std::abs(drawn.red() - own.red()) < 40 && std::abs(drawn.green() - own.green()) < 40 &&
                     std::abs(drawn.hue() - own.hue()) < 12,
                 qPrintable(drawn.name()));
        shape->lookFrom(180);
        QTest::qWait(100);
        QCOMPARE(drawing->panels[static_cast<std::size_t>(shape->spotAt(middle).panel)].name, std::string("back"));
    }

    /// A value that is still being typed belongs to the experiment that goes.
    void removingTakesATypedValueAlong()
    {
        showTee();
        window_->activateWindow();
        QuantityEdit* duration = nullptr;
        for (QuantityEdit* edit : window_->run().garment().wear().findChildren<QuantityEdit*>()) {
            if (edit->accessibleName() == "Duration") { duration = edit; }
        }
        QVERIFY(duration);
        duration->setFocus();
        duration->selectAll();
        QTest::keyClicks(duration, "45");
        for (QToolButton* button : window_->run().garment().wear().findChildren<QToolButton*>()) {
            if (button->toolTip().startsWith("Remove the experiment")) { button->click(); }
        }
        QVERIFY(window_->document().design()->wears.empty());
        window_->document().history()->undo();
        QCOMPARE(window_->document().design()->wears.size(), std::size_t(1));
    }

    void anIssueOfAGarmentLeadsToIt()
    {
        showTee();
        window_->setWorkspace(Workspace::design);
        editGarment(window_->document(), "too warm", 0, {}, [](Garment& garment) { garment.wearer.skin_temperature_c = 90; });
        QVERIFY(window_->document().hasError());
        QVERIFY(!window_->run().panel().canRun());
        Q_EMIT window_->findChild<IssuesPanel*>()->issueActivated(Place("garments") / std::size_t{0} / "wearer" / "skin_temperature_c");
        QVERIFY(window_->run().docks().garment->isVisible());
    }

private:
    QPushButton* button(const QString& text)
    {
        for (QPushButton* each : window_->run().list().findChildren<QPushButton*>()) {
            if (each->text().remove('&') == text) { return each; }
        }
        return nullptr;
    }
    void showTee()
    {
        window_->setWorkspace(Workspace::garment);
        window_->run().panel().setFidelity(Fidelity::live);
        window_->run().garment().choice().setGarmentIndex(addBuiltInGarment(window_->document(), "tee"));
        editGarment(window_->document(), "a child's", 0, {}, [](Garment& garment) { // few cells
            garment.built_in.chest_mm = 600;
            garment.built_in.length_mm = 400;
            garment.built_in.sleeve_mm = 120;
        });
        editWear(window_->document(), "shorter", 0, {}, [](WearExperiment& wear) { wear.duration_s = 5; });
        QTRY_VERIFY(window_->run().garment().choice().drawing());
        QTest::qWait(200);
    }
    void run()
    {
        QTRY_VERIFY(window_->run().panel().canRun());
        window_->run().start();
        QTRY_VERIFY_WITH_TIMEOUT(!window_->run().run().running(), 120000);
        QVERIFY(window_->run().garment().playback().frames() > 1);
    }
};

QTEST_MAIN(TestGarmentWindow)
#include "tst_garment_window.moc"
