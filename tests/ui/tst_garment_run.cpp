// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A garment that is worn in the Garment workspace: frames as they come, colours, numbers, the pin, a kept run, recordings.
#include "answer_questions.h"
#include "core/base/round_up.h"
#include "core/wear/wear_map.h"
#include "ui/basics/elided_label.h"
#include "ui/basics/quantity_edit.h"
#include "ui/document/document.h"
#include "ui/document/recovery.h"
#include "ui/garment/flat_view.h"
#include "ui/garment/garment_edits.h"
#include "ui/garment/garment_view.h"
#include "ui/garment/parts_table.h"
#include "ui/garment/shape_view.h"
#include "ui/garment/step_legend.h"
#include "ui/garment/steps_dialog.h"
#include "ui/picture/viewport.h"
#include "ui/results/chart.h"
#include "ui/results/project_runs.h"
#include "ui/results/run_history.h"
#include "ui/results/run_panel.h"
#include "ui/window/examples.h"
#include "ui/window/run_workspace.h"

#include <QDir>
#include <QMainWindow>
#include <QSet>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <limits>

using namespace hygroloom;

class TestGarmentRun : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { qRegisterMetaType<QueuedRun::Outcome>(); }
    void init()
    {
        document_ = std::make_unique<Document>();
        recovery_ = std::make_unique<Recovery>(*document_, folder_.path());
        QVERIFY(document_->openExample(QDir(examplesFolder()).filePath("three-candidates.hygro")));
        window_ = std::make_unique<QMainWindow>();
        history_ = std::make_unique<RunHistory>();
        project_ = std::make_unique<ProjectRuns>(*document_, *recovery_, *history_);
        viewport_ = std::make_unique<Viewport>();
        run_ = std::make_unique<RunWorkspace>(*document_, *history_, *project_, queue_, *viewport_, *window_);
        run_->setSubject(Subject::garment);
        workspace_ = &run_->garment();
        window_->setCentralWidget(&workspace_->view());
        window_->resize(1000, 700);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
        run_->panel().setFidelity(Fidelity::live);
        workspace_->choice().setGarmentIndex(addBuiltInGarment(*document_, "singlet"));
        editGarment(*document_, "a child's", 0, {}, [](Garment& garment) { // few cells
            garment.built_in.chest_mm = 600;
            garment.built_in.length_mm = 350;
        });
        editWear(*document_, "shorter", 0, {}, [](WearExperiment& wear) {
            wear.duration_s = 60;
            wear.activity = {{0, 10}};
        });
        QTRY_VERIFY(workspace_->choice().drawing());
    }
    void cleanup()
    {
        run_.reset();
        viewport_.reset();
        window_.reset();
        project_.reset();
        history_.reset();
        recovery_.reset();
        document_.reset();
    }
    void framesAreShownAsTheyCome()
    {
        QSignalSpy frames(&workspace_->playback(), &WearPlayback::frameShown);
        run();
        QCOMPARE(workspace_->playback().frames(), static_cast<int>(frames.count()));
        QCOMPARE(workspace_->playback().time(), 60.0);
        QCOMPARE(run_->chartOf(Subject::garment).points().size(), frames.count());
        const WornRun& run = *workspace_->playback().run();
        QVERIFY(run.most_water > 0);
        // The same as the map that the command line writes, cell by cell.
        WearMapOptions options;
        options.crossings = 1;
        const WearMap map = wear_map(run.layout(), *workspace_->playback().frame(), options);
        const std::vector<double> values = cellValues(run.layout(), *workspace_->playback().frame(), WearValue::water);
        QCOMPARE(values.size(), map.values.size());
        for (std::size_t i = 0; i < values.size(); ++i) { QVERIFY(std::abs(values[i] - map.values[i]) <= 1e-12 * run.most_water); }
    }
    void aCellHasTheColourOfItsStep()
    {
        openRun();
        WearPlayback& playback = workspace_->playback();
        const WornRun& run = *playback.run();
        const std::vector<double> values = cellValues(run.layout(), *playback.frame(), WearValue::water);
        const QImage picture = workspace_->view().flat().picture();
        int seen = 0;
        for (std::size_t i = 0; i < run.layout().cells.size(); i += 97) {
            const GarmentCell& cell = run.layout().cells[i];
            const GarmentSpot spot{cell.panel, run.layout().panels[static_cast<std::size_t>(cell.panel)].grid.middle(cell.end, cell.pick)};
            QCOMPARE(run.lookup->at(spot), static_cast<int>(i));
            const auto step = step_colour(step_of(even_steps(playback.most()), values[i]));
            const QColor drawn = picture.pixelColor(workspace_->view().flat().pixelOf(spot).toPoint());
            seen += drawn == QColor(step[0], step[1], step[2]) ? 1 : 0;
        }
        // Names, arrows, outlines and pixels on a border between cells are in the way of few.
        QVERIFY2(seen > 0.8 * static_cast<double>(run.layout().cells.size() / 97), qPrintable(QString::number(seen)));
    }
    void theGarmentOrRunChosenLastIsShown()
    {
        run();
        GarmentView& view = workspace_->view();
        const QString file = workspace_->playback().run()->file;
        workspace_->choice().setGarmentIndex(addBuiltInGarment(*document_, "leggings"));
        QTRY_VERIFY(workspace_->choice().drawing() && !workspace_->choice().reading());
        QCOMPARE(view.newest().drawing(), workspace_->choice().drawing());
        QVERIFY(view.newest().drawing() != workspace_->playback().run()->drawing);
        workspace_->choice().setGarmentIndex(0); // its run, as before
        QCOMPARE(view.newest().drawing(), workspace_->playback().run()->drawing);
        workspace_->choice().setGarmentIndex(1);
        QTRY_COMPARE(view.newest().drawing(), workspace_->choice().drawing());
        open(file);
        QCOMPARE(view.newest().drawing(), workspace_->playback().run()->drawing);
    }
    void titlesOfAAndBKeepTheirEnds()
    {
        openRun();
        workspace_->playback().keepAsA();
        workspace_->view().setCompared(GarmentView::Compared::difference);
        window_->resize(700, 700);
        QTest::qWait(50);
        for (GarmentPane* pane : {&workspace_->view().kept(), &workspace_->view().newest()}) {
            const QString full = pane->caption().text(), shown = pane->caption().shownText();
            QVERIFY(pane->caption().isVisible());
            QCOMPARE(pane->caption().toolTip(), full);
            QVERIFY2(shown.size() < full.size() && shown.contains(QChar(0x2026)), qPrintable(shown));
            QVERIFY2(shown.startsWith(full.left(3)) && shown.endsWith(full.right(3)), qPrintable(shown));
            pane->caption().resize(pane->caption().fontMetrics().horizontalAdvance(full) + 20, pane->caption().height());
            QCOMPARE(pane->caption().shownText(), full);
        }
    }
    void theLegendNamesEightStepsUpToTheEnd()
    {
        openRun();
        StepLegend& legend = workspace_->view().legend();
        QCOMPARE(legend.texts().size(), 8);
        workspace_->playback().setMost(400.0);
        QCOMPARE(legend.texts().back(), QString("0 to 50"));
        QCOMPARE(legend.texts().front(), QString("350 to 400"));
        workspace_->playback().setMost(0.5 * workspace_->playback().run()->most_water);
        QVERIFY2(legend.texts().front().endsWith("and more"), qPrintable(legend.texts().front()));
        workspace_->view().setColors(GarmentView::Colors::share);
        workspace_->playback().setMost(1.0);
        QCOMPARE(legend.texts().back(), QString("0 to 12.5"));
    }
    void theScaleOfSharesEndsJustAboveWhatTheRunsHold()
    {
        openRun();
        workspace_->view().setColors(GarmentView::Colors::share);
        const WornRun& run = *workspace_->playback().run();
        double held = 0;
        for (const auto& frame : run.frames) {
            for (const double share : cellValues(run.layout(), *frame, WearValue::share)) { held = std::max(held, share); }
        }
        QVERIFY2(held > 0 && held < 0.9, qPrintable(QString::number(held))); // else 100 % would be right
        QCOMPARE(workspace_->playback().most(), rounded_up(held));
        QCOMPARE(rounded_up(3e-14), 1.0); // a dry garment is white
        QVERIFY(workspace_->playback().most() < 1);
    }

    void theEndsOfTheStepsAreTyped()
    {
        openRun();
        WearPlayback& playback = workspace_->playback();
        const WornRun& run = *playback.run();
        workspace_->view().editSteps();
        StepsDialog& dialog = *workspace_->view().steps();
        const double most = playback.most();
        QCOMPARE(dialog.end(7).value(), std::optional(most));
        const auto type = [&](std::size_t step, double value) {
            dialog.end(step).setText(QString::number(value, 'g', 17));
            dialog.end(step).setModified(true);
            QTest::keyClick(&dialog.end(step), Qt::Key_Return);
        };
        type(1, 0.9 * most); // above the next ones
        QVERIFY2(dialog.complaint().contains("Step 3"), qPrintable(dialog.complaint()));
        QVERIFY(!playback.ownSteps());
        QCOMPARE(dialog.end(1).value(), std::optional(0.9 * most)); // stays to be corrected
        type(1, 0.15 * most);
        QVERIFY2(dialog.complaint().isEmpty(), qPrintable(dialog.complaint()));
        QVERIFY(playback.ownSteps());
        type(7, 3 * most);
        QCOMPARE(playback.most(), 3 * most);
        const WearSteps steps = *playback.ownSteps();
        // Legend, flat panels and files have the same steps.
        QCOMPARE(workspace_->view().legend().ends(), steps);
        const std::vector<double> values = cellValues(run.layout(), *playback.frame(), WearValue::water);
        WearMapOptions options;
        options.crossings = 1;
        options.steps = playback.steps();
        QCOMPARE(wear_map(run.layout(), *playback.frame(), options).steps, steps);
        const QImage picture = workspace_->view().flat().picture();
        int seen = 0, asked = 0;
        for (std::size_t i = 0; i < values.size(); i += 97, ++asked) {
            const GarmentCell& cell = run.layout().cells[i];
            const GarmentSpot spot{cell.panel, run.layout().panels[static_cast<std::size_t>(cell.panel)].grid.middle(cell.end, cell.pick)};
            const auto color = step_colour(step_of(steps, values[i]));
            seen += picture.pixelColor(workspace_->view().flat().pixelOf(spot).toPoint()) == QColor(color[0], color[1], color[2]) ? 1 : 0;
        }
        QVERIFY2(seen > 0.8 * asked, qPrintable(QString::number(seen)));
        workspace_->view().setColors(GarmentView::Colors::share); // has steps of its own
        QVERIFY(!playback.ownSteps());
        QVERIFY(playback.most() < most);
        QCOMPARE(dialog.end(7).value(), std::optional(playback.most()));
        workspace_->view().setColors(GarmentView::Colors::water);
        QCOMPARE(dialog.end(7).value(), std::optional(3 * most));
        dialog.reset();
        QVERIFY(!playback.ownSteps());
        QCOMPARE(dialog.end(7).value(), std::optional(most));
        QCOMPARE(playback.steps(), even_steps(most));
    }
    void aClickPinsACellWithItsHistory()
    {
        openRun();
        FlatView& flat = workspace_->view().flat();
        const WornRun& run = *workspace_->playback().run();
        const std::size_t i = run.layout().cells.size() / 2;
        const GarmentCell& cell = run.layout().cells[i];
        const GarmentSpot spot{cell.panel, run.layout().panels[static_cast<std::size_t>(cell.panel)].grid.middle(cell.end, cell.pick)};
        const QPoint at = flat.pixelOf(spot).toPoint();
        const int there = run.lookup->at(flat.spotAt(at));
        QVERIFY(there >= 0);
        QTest::mouseClick(&flat, Qt::LeftButton, Qt::NoModifier, at);
        QVERIFY(workspace_->playback().pin().panel >= 0);
        QVERIFY(run_->chartOf(Subject::garment).title().contains("pin"));
        const WearFrame& last = *run.frames.back();
        const double expected =
            1e3 * last.water(static_cast<std::size_t>(there)) / run.layout().cells[static_cast<std::size_t>(there)].area;
        QCOMPARE(run_->chartOf(Subject::garment).points().back().y(), expected);
        const QString zone =
            QString::fromStdString(body_zones()[static_cast<std::size_t>(run.layout().cells[static_cast<std::size_t>(there)].zone)]);
        QVERIFY2(workspace_->view().probeText().contains(zone), qPrintable(workspace_->view().probeText()));
        QVERIFY(workspace_->view().probeText().contains("g/m²"));
        run_->pressKey(Qt::Key_Escape);
        QVERIFY(run_->chartOf(Subject::garment).title().contains("garment"));
    }
    void keysStepThroughTime()
    {
        openRun();
        WearPlayback& playback = workspace_->playback();
        const int last = playback.current();
        QVERIFY(run_->pressKey(Qt::Key_Left));
        QCOMPARE(playback.current(), last - 1);
        QVERIFY(run_->pressKey(Qt::Key_Right));
        QCOMPARE(playback.current(), last);
        QVERIFY(!run_->pressKey(Qt::Key_Q));
        workspace_->view().flat().zoomBy(4); // a panel lies in the middle
        const FlatView& flat = workspace_->view().flat();
        GarmentSpot middle = flat.spotAt(flat.rect().center());
        for (const ShapeView* shape : workspace_->view().findChildren<ShapeView*>()) { // where one is seen, its middle counts
            if (shape->isVisible()) { middle = shape->spotAt({0.5 * shape->width(), 0.5 * shape->height()}); }
        }
        const bool panel = middle.panel >= 0;
        QVERIFY(run_->pressKey(Qt::Key_Return));
        QCOMPARE(playback.pin().panel >= 0, panel);
        QVERIFY(run_->pressKey(Qt::Key_Escape));
        QCOMPARE(playback.pin().panel, -1);
    }
    void panelsAddUpToTheGarment()
    {
        openRun();
        const PartsTable& table = workspace_->parts();
        double panels = 0, zones = 0;
        for (int row = 1; row < table.rowCount(); ++row) {
            (table.item(row, 0)->text().startsWith("Panel") ? panels : zones) += table.item(row, 2)->data(Qt::UserRole).toDouble();
        }
        const double all = table.item(0, 2)->data(Qt::UserRole).toDouble();
        QVERIFY(all > 0);
        QVERIFY(std::abs(panels - all) <= 1e-9 * all && std::abs(zones - all) <= 1e-9 * all);
        const QStringList lines = table.csv().split('\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), table.rowCount() + 1);
        QVERIFY(lines[1].startsWith("Garment,"));
        for (int column = 1; column < table.columnCount(); ++column) {
            QSet<qsizetype> decimals; // all of a column have as many
            for (int row = 0; row < table.rowCount(); ++row) {
                const QString text = table.item(row, column)->text();
                if (text != "–") { decimals << (text.contains('.') ? text.size() - text.indexOf('.') : 0); }
            }
            QVERIFY2(decimals.size() <= 1, qPrintable(table.horizontalHeaderItem(column)->text()));
        }
    }
    void aKeptRunIsComparedAtTheSameTime()
    {
        openRun();
        WearPlayback& playback = workspace_->playback();
        playback.keepAsA();
        const auto kept = playback.run();
        editWear(*document_, "more sweat", 0, {}, [](WearExperiment& wear) { wear.activity = {{0, 5}}; });
        run();
        QVERIFY(playback.run() != kept && playback.kept() == kept);
        workspace_->view().setCompared(GarmentView::Compared::difference);
        playback.show(playback.frames() / 2);
        QCOMPARE(playback.keptFrame()->time, playback.frame()->time);
        const std::vector<double> b = cellValues(playback.run()->layout(), *playback.frame(), WearValue::water);
        const std::vector<double> a = cellValues(kept->layout(), *playback.keptFrame(), WearValue::water);
        const std::vector<double> less = playback.difference();
        QCOMPARE(less.size(), b.size());
        for (std::size_t i = 0; i < less.size(); ++i) { QCOMPARE(less[i], b[i] - a[i]); } // the same cells
        QVERIFY(workspace_->view().kept().isVisible() && workspace_->view().difference().isVisible());
        QCOMPARE(workspace_->parts().columnCount(), 1 + 3 * 10); // areas, too: cells of other fabrics are of other sizes
        playback.dropA();
        QVERIFY(!workspace_->view().kept().isVisible());
    }
    void differencesAreSoughtAtTheSamePlaceOfOtherCells()
    {
        openRun();
        WearPlayback& playback = workspace_->playback();
        const auto kept = playback.run();
        playback.keepAsA();
        cutAllFrom(*document_, 0, document_->design()->fabrics[1].name);
        run();
        const std::vector<double> zero(kept->layout().cells.size(), 0), one(playback.run()->layout().cells.size(), 1);
        const std::vector<double> less = differences(one, zero, samePlaces(*playback.run(), *kept));
        const auto ones = std::count(less.begin(), less.end(), 1.0);
        QVERIFY(static_cast<std::size_t>(ones) > 0.99 * static_cast<double>(less.size()));
    }
    void aRecordedRunOpensAgain()
    {
        run();
        const QString file = workspace_->playback().run()->file;
        QCOMPARE(QFileInfo(file).absolutePath(), QFileInfo(project_->folder()).absoluteFilePath());
        const std::vector<double> before =
            cellValues(workspace_->playback().run()->layout(), *workspace_->playback().frame(), WearValue::water);
        QVERIFY(isGarmentRecording(file));
        run_->clearResults();
        QVERIFY(!workspace_->playback().run());
        open(file);
        const std::vector<double> after =
            cellValues(workspace_->playback().run()->layout(), *workspace_->playback().frame(), WearValue::water);
        QCOMPARE(after.size(), before.size());
        const double most = workspace_->playback().run()->most_water;
        for (std::size_t i = 0; i < after.size(); ++i) { QVERIFY(std::abs(after[i] - before[i]) <= 1e-5 * most); } // written as floats
    }
    void aRunStopsAndKeepsItsFrames()
    {
        editWear(*document_, "longer", 0, {}, [](WearExperiment& wear) { wear.duration_s = 36000; });
        QTRY_VERIFY(run_->panel().canRun());
        QSignalSpy ended(&run_->run(), &QueuedRun::ended);
        run_->start();
        QTRY_VERIFY_WITH_TIMEOUT(workspace_->playback().frames() > 0, 60000);
        run_->run().cancel();
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 20000);
        QVERIFY(ended[0][0].value<QueuedRun::Outcome>() == QueuedRun::Outcome::cancelled);
        QVERIFY(workspace_->playback().frames() > 0);
        QVERIFY(run_->panel().canRun());
        // What was computed is a run of the project, which says that it was stopped.
        const KeptRun* kept = history_->find(workspace_->playback().run()->file);
        QVERIFY(kept && kept->worn && kept->own && !kept->complete());
        QVERIFY(!workspace_->playback().run()->file.isEmpty());
    }
    void aRunPausesAndGoesOn()
    {
        editWear(*document_, "longer", 0, {}, [](WearExperiment& wear) { wear.duration_s = 36000; });
        QTRY_VERIFY(run_->panel().canRun());
        std::array<QPushButton*, 3> buttons{};
        const std::array<QString, 3> names{"Run", "Pause", "Stop"};
        for (auto* button : run_->panel().findChildren<QPushButton*>()) {
            for (std::size_t k = 0; k < names.size(); ++k) {
                if (button->text() == names[k]) { buttons[k] = button; }
            }
        }
        const auto places = [&] { return std::array{buttons[0]->geometry(), buttons[1]->geometry(), buttons[2]->geometry()}; };
        const auto before = places();
        QVERIFY(!buttons[1]->isEnabled());
        QSignalSpy ended(&run_->run(), &QueuedRun::ended);
        buttons[0]->click();
        QTRY_VERIFY_WITH_TIMEOUT(workspace_->playback().frames() > 0, 60000);
        QCOMPARE(places(), before);
        buttons[1]->click();
        QVERIFY(run_->run().paused());
        QCOMPARE(buttons[1]->text(), QString("Resume"));
        QTest::qWait(500); // a frame that was under way
        const int frames = workspace_->playback().frames();
        QTest::qWait(1500);
        QCOMPARE(workspace_->playback().frames(), frames);
        QCOMPARE(places(), before);
        buttons[1]->click();
        QTRY_VERIFY_WITH_TIMEOUT(workspace_->playback().frames() > frames, 60000);
        buttons[1]->click();
        const auto answer = answerQuestions("Keep");
        buttons[2]->click(); // also while it is paused
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 20000);
        QVERIFY(!buttons[1]->isEnabled());
        QCOMPARE(buttons[1]->text(), QString("Pause"));
        QCOMPARE(places(), before);
    }

private:
    void run()
    {
        QTRY_VERIFY(run_->panel().canRun());
        QSignalSpy ended(&run_->run(), &QueuedRun::ended);
        run_->start();
        QVERIFY(!run_->panel().canRun());
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 120000);
        QCOMPARE(ended[0][1].toString(), QString());
    }

    void open(const QString& recording)
    {
        QSignalSpy measured(&workspace_->playback(), &ShownRun::measured);
        QVERIFY(run_->openRecording(recording));
        QTRY_COMPARE_WITH_TIMEOUT(measured.count(), 1, 60000);
    }

    /// What run() shows, of which one recording is made: the project is the same at the start of each test.
    void openRun()
    {
        const QString recording = folder_.filePath("once.hygrorec");
        if (!QFile::exists(recording)) {
            run();
            QVERIFY(QFile::copy(workspace_->playback().run()->file, recording));
            return;
        }
        open(recording);
    }

    QTemporaryDir folder_;
    std::unique_ptr<Document> document_;
    std::unique_ptr<Recovery> recovery_;
    std::unique_ptr<RunHistory> history_;
    std::unique_ptr<ProjectRuns> project_;
    std::unique_ptr<QMainWindow> window_;
    WindowQueue queue_;
    std::unique_ptr<Viewport> viewport_;
    std::unique_ptr<RunWorkspace> run_;
    GarmentSubject* workspace_ = nullptr; ///< of it
};

QTEST_MAIN(TestGarmentRun)
#include "tst_garment_run.moc"
