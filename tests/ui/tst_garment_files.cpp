// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Files that the Garment workspace takes beside patterns: rates over time for the experiment, and recordings of other projects; and its
// commands without a garment.
#include "ui/basics/quantity_edit.h"
#include "ui/document/sources.h"
#include "ui/garment/flat_view.h"
#include "ui/garment/garment_edits.h"
#include "ui/garment/garment_panel.h"
#include "ui/garment/garment_view.h"
#include "ui/garment/rates_file.h"
#include "ui/garment/wear_form.h"
#include "ui/results/run_history.h"
#include "ui/results/run_panel.h"
#include "window_test.h"

#include <QDir>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QToolButton>

using namespace hygroloom;

class TestGarmentFiles : public WindowTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { useOwnSettings(); }
    void init()
    {
        openWindow({1280, 800});
        QVERIFY(window_->document().openExample(example("three-candidates")));
        window_->setWorkspace(Workspace::garment);
    }
    void cleanup()
    {
        window_->document().history()->setClean();
        window_.reset();
    }

    void aRunKeptAsATakesTheFilesOfItsGarmentAlong()
    {
        addTee();
        const QByteArray rates = "time_s,zone,g_m2_h\n0,default,200\n600,default,840\n";
        QVERIFY(QDir().mkpath(folder_.filePath("kept/run")) && QDir().mkpath(folder_.filePath("elsewhere")));
        QVERIFY(window_->document().saveAs(folder_.filePath("kept/worn.hygro")));
        write(folder_.filePath("kept/run/rates.csv"), rates);
        editWear(window_->document(), "rates", 0, {}, [](WearExperiment& wear) {
            wear.activity_file = "run/rates.csv";
            wear.duration_s = 5;
        });
        window_->run().panel().setFidelity(Fidelity::live);
        QTRY_VERIFY(window_->run().panel().canRun());
        window_->run().start();
        auto& playback = window_->run().garment().playback();
        QTRY_VERIFY_WITH_TIMEOUT(playback.run() && playback.whole(), 60000);
        playback.keepAsA();
        chooseFile(folder_.filePath("elsewhere/a.hygrorec"));
        trigger("Save A As…");
        QFile copy(folder_.filePath("elsewhere/run/rates.csv"));
        QTRY_VERIFY_WITH_TIMEOUT(copy.exists() && copy.size() == rates.size(), 20000);
        QCOMPARE(folderOfSources(playback.kept()->record->design, folder_.filePath("elsewhere/a.hygrorec")), folder_.filePath("elsewhere"));
        write(folder_.filePath("elsewhere/run/rates.csv"), "another file\n"); // is not replaced
        QCOMPARE(copySources(playback.kept()->record->design, folder_.filePath("kept"), folder_.filePath("elsewhere")),
                 QStringList("run/rates.csv"));
        QCOMPARE(copy.size(), qint64{13});

        QVERIFY(QFile::remove(folder_.filePath("kept/run/rates.csv")) && QDir().mkpath(folder_.filePath("third")));
        QSignalSpy problems(&window_->run(), &RunWorkspace::problemFound);
        chooseFile(folder_.filePath("third/a.hygrorec"));
        trigger("Save A As…"); // its files are gone
        QTRY_COMPARE_WITH_TIMEOUT(problems.count(), 1, 20000);
        QVERIFY2(problems[0][0].toString().contains("could not be copied beside it: run/rates.csv"), qPrintable(problems[0][0].toString()));
        QVERIFY(QFile::exists(folder_.filePath("third/a.hygrorec")));
    }
    void aFileIsOutsideOfAFolderOnlyByItsPath()
    {
        QVERIFY(QDir().mkpath(folder_.filePath("names/project")) && QDir().mkpath(folder_.filePath("names/to")));
        Design design;
        design.wears.resize(2);
        design.wears[0].activity_file = "..rates.csv";
        design.wears[1].activity_file = "../above.csv";
        write(folder_.filePath("names/project/..rates.csv"), "time_s\n");
        write(folder_.filePath("names/above.csv"), "time_s\n");
        QVERIFY(QDir().mkpath(folder_.filePath("other/to")));
        QCOMPARE(copySources(design, folder_.filePath("names/project"), folder_.filePath("other/to")), QStringList("../above.csv"));
        QVERIFY(QFile::exists(folder_.filePath("other/to/..rates.csv")) && !QFile::exists(folder_.filePath("other/above.csv")));
        QCOMPARE(copySources(design, {}, folder_.filePath("other/to")), (QStringList{"..rates.csv", "../above.csv"}));
    }
    void ratesOverTimeAreChosenReadAndLetGo()
    {
        addTee();
        const QString project = folder_.filePath("rates/worn.hygro"), file = folder_.filePath("rates/run/rates.csv");
        QVERIFY(QDir().mkpath(folder_.filePath("rates/run")));
        QVERIFY(window_->document().saveAs(project));
        write(file, "time_s,zone,g_m2_h,skin_temperature_c\n0,chest,200,33\n600,chest,840,34\n900,default,400,34\n");
        RatesFile& rates = window_->run().garment().wear().rates();
        auto* table = window_->run().garment().wear().findChild<QTableWidget*>();
        QVERIFY(table->isVisible());
        chooseFile(file);
        rates.choose();
        QCOMPARE(wear().activity_file, std::string("run/rates.csv")); // from the project's folder
        QTRY_COMPARE(rates.said(), QString("3 rows from 0 to 900 s, with skin temperatures. Zones: chest, default."));
        QVERIFY(!table->isVisible()); // no factor acts
        QCOMPARE(window_->width(), 1280);

        write(file, "time_s,zone,g_m2_h\n0,chest,200\n1,chest,-5\n"); // it is watched
        QTRY_VERIFY2(rates.said().contains("line 3: g_m2_h must be from 0 to 100000; given is -5."), qPrintable(rates.said()));
        QVERIFY(rates.said().contains("rates.csv"));
        QTest::qWait(50);
        auto* words = rates.findChild<QLabel*>();
        QVERIFY(words->height() >= words->heightForWidth(words->width())); // all lines are seen
        QVERIFY(window_->run().garment().wear().widget()->width() <= window_->run().garment().wear().viewport()->width());

        QVERIFY(window_->document().saveAs(folder_.filePath("moved.hygro")));
        QCOMPARE(wear().activity_file, std::string("rates/run/rates.csv"));
        rates.clear();
        QVERIFY(wear().activity_file.empty() && table->isVisible() && rates.said().isEmpty());
        QCOMPARE(wear().activity, (std::vector<Activity>{Activity{}}));
        window_->document().history()->undo();
        QCOMPARE(wear().activity_file, std::string("rates/run/rates.csv"));
        QTRY_VERIFY(rates.said().contains("line 3"));
        window_->document().history()->undo();
        QVERIFY(wear().activity_file.empty());
    }

    void commandsThatNeedAGarmentSayWhyTheyWait()
    {
        QVERIFY(window_->document().design()->garments.empty());
        QAction* run = window_->run().actions().start;
        QAction* remove = nullptr;
        for (QAction* action : window_->findChildren<QAction*>()) {
            if (action->text().remove('&') == "Remove Garment") { remove = action; }
        }
        QVERIFY(remove);
        const auto waits = [](const QAction* action, const char* why) {
            return !action->isEnabled() && action->toolTip().contains(why) && action->statusTip().contains(why);
        };
        QVERIFY(waits(run, "Add a garment.") && waits(remove, "There is no garment to remove."));
        for (const char* name : {"Remove the garment and its experiments", "Rename the garment"}) {
            for (const QToolButton* button : window_->run().garment().panel().findChildren<QToolButton*>()) {
                if (button->accessibleName() != name) { continue; }
                QVERIFY2(!button->isEnabled() && button->toolTip().startsWith("There is no garment"), name);
            }
        }
        addTee();
        QTRY_VERIFY(run->isEnabled() && remove->isEnabled());
        QCOMPARE(remove->toolTip(), QString("Remove Garment"));
        QVERIFY(!run->statusTip().isEmpty() && !remove->statusTip().isEmpty());
        window_->setWorkspace(Workspace::simulate); // its commands stay
        remove->trigger();
        QVERIFY(waits(remove, "There is no garment to remove."));
        window_->setWorkspace(Workspace::garment);
        QVERIFY(waits(run, "Add a garment.") && waits(remove, "There is no garment to remove."));
    }

    void aRecordingBringsItsDesignToAnUntouchedProject()
    {
        const QString recording = recordTee();
        QVERIFY(window_->document().openExample(example("three-candidates")));
        QVERIFY(window_->document().design()->garments.empty());
        open(recording);
        QCOMPARE(window_->document().design()->garments.size(), std::size_t{1});
        QCOMPARE(window_->document().title(), QString("Design of tee.hygrorec"));
        QVERIFY(window_->run().garment().playback().run() && window_->run().garment().playback().frames() > 1); // it is still shown
        QCOMPARE(window_->run().garment().choice().wear()->name, std::string("wear"));
        QVERIFY(view().noticeText().isEmpty());
        QTRY_VERIFY(window_->run().panel().canRun()); // its forms act
    }

    void aProjectWithChangesStaysAndTheRecordingSaysWhatItIs()
    {
        const QString recording = recordTee();
        QVERIFY(window_->document().openExample(example("three-candidates")));
        window_->run().garment().choice().setGarmentIndex(addBuiltInGarment(window_->document(), "leggings"));
        QTRY_VERIFY(window_->run().garment().choice().drawing());
        QVERIFY(view().newest().flat().acceptDrops());
        open(recording);
        QCOMPARE(window_->document().design()->garments[0].name, std::string("leggings"));
        QVERIFY2(view().noticeText().contains("recording of “tee”"), qPrintable(view().noticeText()));
        bool shown = false;
        for (const QLabel* label : view().findChildren<QLabel*>()) {
            shown = shown || (label->isVisible() && label->text() == view().noticeText());
        }
        QVERIFY(shown);
        QVERIFY(!view().newest().flat().acceptDrops());
        view().setColors(GarmentView::Colors::fabrics); // the project's own garment
        QVERIFY(view().noticeText().isEmpty());
        QVERIFY(view().newest().flat().acceptDrops());
        view().setColors(GarmentView::Colors::water);
        QVERIFY(!view().noticeText().isEmpty());

        window_->document().history()->setClean(); // the question about changes is another's
        for (QPushButton* button : view().findChildren<QPushButton*>()) {
            if (button->text() == "Open Its Design") { button->click(); }
        }
        QCOMPARE(window_->document().design()->garments[0].name, std::string("tee"));
        QVERIFY(view().noticeText().isEmpty());
        QVERIFY(window_->run().garment().playback().run());
    }

private:
    GarmentView& view() { return window_->run().garment().view(); }
    const WearExperiment& wear() { return window_->document().design()->wears.front(); }
    static void write(const QString& path, const char* text)
    {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) > 0);
    }
    void addTee()
    {
        window_->run().garment().choice().setGarmentIndex(addBuiltInGarment(window_->document(), "tee"));
        editGarment(window_->document(), "a child's", 0, {}, [](Garment& garment) { // few cells
            garment.built_in.chest_mm = 600;
            garment.built_in.length_mm = 400;
            garment.built_in.sleeve_mm = 120;
        });
        editWear(window_->document(), "shorter", 0, {}, [](WearExperiment& wear) { wear.duration_s = 20; });
        QTRY_VERIFY(window_->run().garment().choice().drawing());
    }
    /// A run of a tee, in a file that is no project's.
    QString recordTee()
    {
        const QString file = folder_.filePath("tee.hygrorec");
        if (QFile::exists(file)) { return file; }
        addTee();
        auto run = [this] {
            QTRY_VERIFY(window_->run().panel().canRun());
            window_->run().start();
            QTRY_VERIFY_WITH_TIMEOUT(!window_->run().run().running(), 120000);
        };
        run();
        window_->run().saveRecording(window_->run().garment().playback().path(), file);
        [&] { QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file), 20000); }();
        QTest::qWait(200);
        const QString own = window_->run().garment().playback().run()->file;
        runs().forget(own);
        QFile::remove(own); // or the next project finds it as its own
        return file;
    }
    void open(const QString& recording)
    {
        QSignalSpy measured(&window_->run().garment().playback(), &ShownRun::measured);
        QVERIFY(window_->openFile(recording));
        QTRY_COMPARE_WITH_TIMEOUT(measured.count(), 1, 20000);
        QTest::qWait(50);
    }
};

QTEST_MAIN(TestGarmentFiles)
#include "tst_garment_files.moc"
