// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The page of studies: what is set up is what runs, rows come to the table and the charts, and a row becomes a fabric of the project.
#include "core/project/atomic_file.h"
#include "study_test.h"
#include "tests/support/drop_design.h"
#include "ui/basics/preferences.h"
#include "ui/document/document.h"
#include "ui/study/cluster_dialog.h"
#include "ui/study/indices_view.h"
#include "ui/study/pairs_view.h"
#include "ui/study/parallel_view.h"
#include "ui/study/study_page.h"
#include "ui/study/study_setup.h"
#include "ui/study/study_table.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <cmath>
#include <random>

using namespace hygroloom;

namespace {

constexpr int study_patience = 60000; // ms

void type(QLineEdit* field, const QString& text)
{
    field->setFocus();
    field->clear();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
}

/// Its drop stands as a cap, which is quick.
Design quickDesign()
{
    Design design = drop_design(35, 0.05);
    design.experiments[0].closure = Closure::pores;
    return design;
}

/// A page with a small project, as it is seen.
struct Bench {
    explicit Bench(const Design& design = quickDesign()) : page(document, queue)
    {
        document.take(design, "drops");
        page.resize(1280, 700);
        page.show();
        page.setFolder(folder.filePath("out"));
        QObject::connect(&page, &StudyPage::failed, [this](const QString& sentence) { sentences << sentence; });
        QObject::connect(&page, &StudyPage::messageShown, [this](const QString& sentence) { messages << sentence; });
    }
    void addFactor(const std::string& path, double low, double high)
    {
        page.setup().addFactors({fieldAt(*document.design(), path)});
        type(page.setup().form().field("low"), QString::number(low));
        type(page.setup().form().field("high"), QString::number(high));
    }
    /// Two points of a Latin hypercube at live.
    void makeSmall(int points = 2)
    {
        addFactor(ends, 26, 36);
        addFactor(volume, 1, 2);
        page.setup().setPoints(Sampling::latin_hypercube, points);
        page.setup().setFidelity(Fidelity::live);
    }
    void runToTheEnd()
    {
        QSignalSpy shown(&page, &StudyPage::shown);
        page.run();
        QTRY_VERIFY_WITH_TIMEOUT(!page.job().running() && !shown.isEmpty() && page.results() &&
                                     page.results()->table.rows() == page.results()->rows,
                                 study_patience);
    }

    QTemporaryDir folder;
    Document document;
    WindowQueue queue;
    StudyPage page;
    QStringList sentences, messages;
};

/// A table as a study of three factors leaves it.
void writeTable(const QString& path, int rows)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0, 1);
    QByteArray text = "point,replicate,fabrics[0].ends_per_cm,fabrics[0].picks_per_cm,fabrics[0].contact_angle_deg,status,"
                      "maximum_wetted_radius_top_mm,absorbency_time_s,wall_s,device,commit,reason\n";
    for (int row = 0; row < rows; ++row) {
        const double x = 20 + 20 * share(random), y = 20 + 20 * share(random), z = 20 + 40 * share(random);
        text += QByteArray::number(row) + ",0," + QByteArray::number(x, 'g', 10) + "," + QByteArray::number(y, 'g', 10) + "," +
                QByteArray::number(z, 'g', 10) + ",done," + QByteArray::number(12 - 0.1 * (x + y) + share(random), 'g', 10) + "," +
                QByteArray::number(0.02 * x * z / 10, 'g', 10) + ",0.61,CPU,abcdef,\n";
    }
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
}

} // namespace

class TestStudyPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName("hygroloom-test");
        QCoreApplication::setApplicationName("hygroloom-test");
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings_.path());
    }

    void whatIsSetUpIsInTheStudyFile()
    {
        Bench bench;
        StudySetup& setup = bench.page.setup();
        bench.addFactor(ends, 26, 36);
        setup.addFactors({fieldAt(*bench.document.design(), angle)});
        setup.form().setSpread(FactorForm::Spread::list);
        type(setup.form().field("values"), "20, 40, 60");
        setup.addFactors({fieldAt(*bench.document.design(), "fabrics[0].warp.twist_per_m")});
        setup.form().setSpread(FactorForm::Spread::normal);
        type(setup.form().field("mean"), "800");
        type(setup.form().field("sd"), "40");
        type(setup.form().field("low"), "");
        type(setup.form().field("high"), "");
        setup.setPoints(Sampling::sobol, 32);
        setup.setFidelity(Fidelity::live);
        QVERIFY2(setup.problems().isEmpty(), qPrintable(setup.problems().join('\n')));
        QVERIFY(bench.page.modified());
        const QString file = bench.folder.filePath("study.json");
        QVERIFY(bench.page.saveStudy(file));
        QVERIFY(!bench.page.modified());
        const Study study = read_study(file.toStdString());
        QCOMPARE(study.factors.size(), std::size_t{3});
        QCOMPARE(*study.factors[0].distribution.low, 26.0);
        QCOMPARE(*study.factors[0].distribution.high, 36.0);
        QCOMPARE(study.factors[1].values.size(), std::size_t{3});
        QCOMPARE(study.factors[1].values[1].number, 40.0);
        QVERIFY(study.factors[2].distribution.type == FactorDistribution::Type::normal);
        QCOMPARE(study.factors[2].distribution.sd, 40.0);
        QVERIFY(!study.factors[2].distribution.low);
        QVERIFY(study.sampling == Sampling::sobol && study.points == 32 && study.fidelity == Fidelity::live);
        QCOMPARE(study.fabrics, std::vector<std::string>{"cloth"});
        setup.removeFactor();
        QVERIFY(bench.page.modified());
        QVERIFY(bench.page.openStudy(file));
        QVERIFY(bench.page.setup().study() == study);
    }

    void whatIsWrongIsSaidInPlace()
    {
        Bench bench;
        StudySetup& setup = bench.page.setup();
        bench.addFactor(ends, 26, 36);
        QVERIFY(setup.problems().isEmpty());
        type(setup.form().field("high"), "20");
        QCOMPARE(setup.problems().size(), 1);
        QVERIFY2(setup.problems()[0].startsWith("ends (/cm): ") && setup.problems()[0].contains("given is 20"),
                 qPrintable(setup.problems()[0]));
        type(setup.form().field("high"), "");
        QVERIFY2(setup.problems()[0].contains("The highest value is missing"), qPrintable(setup.problems()[0]));
        type(setup.form().field("high"), "36");
        QVERIFY(setup.problems().isEmpty());
        setup.tick("cloth", false);
        QCOMPARE(setup.problems(), QStringList{"Fabrics: Tick one at least."});
        bench.page.run();
        QVERIFY(!bench.page.job().running());
    }

    void measuresAreListedInTheReadersUnit()
    {
        Bench bench;
        const auto listed = [&bench] {
            QStringList titles;
            for (const QListWidget* list : bench.page.setup().findChildren<QListWidget*>()) {
                for (int row = 0; row < list->count(); ++row) { titles << list->item(row)->text(); }
            }
            return titles.join('\n');
        };
        QVERIFY2(listed().contains("wetted radius, top (mm)"), qPrintable(listed()));
        const Study before = bench.page.setup().study();
        Preferences inches = preferences();
        inches.length = static_cast<int>(LengthUnit::inch);
        setPreferences(inches);
        const QString now = listed();
        QVERIFY2(now.contains("wetted radius, top (in)") && !now.contains("(mm)"), qPrintable(now));
        QVERIFY(bench.page.setup().study() == before);
        setPreferences({});
        QVERIFY(listed().contains("wetted radius, top (mm)"));
    }

    void itsCostIsForetold()
    {
        Bench bench;
        bench.makeSmall(12);
        QSignalSpy told(&bench.page, &StudyPage::costForetold);
        QTRY_VERIFY_WITH_TIMEOUT(!told.isEmpty(), study_patience);
        QVERIFY2(bench.page.cost().startsWith("12 runs (12 points), "), qPrintable(bench.page.cost()));
    }

    void aSmallStudyRunsToItsEnd()
    {
        Bench bench;
        bench.makeSmall(3);
        bench.runToTheEnd();
        QVERIFY2(bench.sentences.isEmpty(), qPrintable(bench.sentences.join('\n')));
        QCOMPARE(bench.page.table().rowCount(), 3);
        QCOMPARE(bench.page.results()->failed, std::size_t{0});
        QVERIFY(QFile::exists(bench.folder.filePath("out/results.csv")));
        QVERIFY2(bench.page.status().startsWith("3 of 3 runs done"), qPrintable(bench.page.status()));
        // Once more: nothing is left to do, and nothing is lost.
        bench.runToTheEnd();
        QCOMPARE(bench.page.table().rowCount(), 3);
    }

    void aStopIsQuickAndKeepsWhatHasEnded()
    {
        Bench bench(drop_design(35, 20));
        bench.makeSmall(40);
        QSignalSpy ended(&bench.page.job(), &StudyTask::ended);
        bench.page.run();
        QTRY_VERIFY_WITH_TIMEOUT(bench.page.job().progress().share > 0, study_patience);
        const int id = bench.queue.list().front().id;
        bench.queue.runs().set_paused(id, true); // in the list of runs
        QTRY_VERIFY2(bench.page.status().endsWith(", paused."), qPrintable(bench.page.status()));
        bench.queue.runs().set_paused(id, false);
        QTRY_VERIFY(!bench.page.status().contains("paused"));
        QElapsedTimer clock;
        clock.start();
        bench.page.job().cancel();
        QVERIFY(ended.wait(study_patience));
        qInfo("stopped after %lld ms", clock.elapsed());
        QVERIFY2(clock.elapsed() < 1000, "a stop takes long"); // 0.3 s on a machine that does nothing else
        QVERIFY(bench.page.job().outcome().cancelled);
        QVERIFY(bench.page.status().startsWith("Stopped."));
    }

    void aFolderOfAnotherStudyIsRefused()
    {
        Bench bench;
        bench.makeSmall();
        bench.runToTheEnd();
        bench.page.setup().setPoints(Sampling::latin_hypercube, 3);
        bench.page.run();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.page.job().running(), study_patience);
        QVERIFY(!bench.sentences.isEmpty());
        QVERIFY2(bench.sentences.last().contains("another study"), qPrintable(bench.sentences.last()));
    }

    void whatFailedSaysWhyAndRunsAgainOnRequest()
    {
        Bench bench;
        bench.page.setup().addFactors({fieldAt(*bench.document.design(), angle)});
        bench.page.setup().form().setSpread(FactorForm::Spread::list);
        type(bench.page.setup().form().field("values"), "400, 40"); // there is no angle of 400 degrees
        bench.page.setup().setPoints(Sampling::grid, 2);
        bench.page.setup().setFidelity(Fidelity::live);
        bench.runToTheEnd();
        QCOMPARE(bench.page.results()->failed, std::size_t{1});
        const StudyColumn* reason = bench.page.results()->table.find(StudyColumnRole::reason);
        QVERIFY2(reason->word(0).find("contact_angle_deg") != std::string::npos, reason->word(0).c_str());
        QVERIFY2(bench.page.status().contains("1 failed"), qPrintable(bench.page.status()));
        QPushButton* again = nullptr;
        for (QPushButton* button : bench.page.findChildren<QPushButton*>()) {
            if (button->text().remove('&') == "Run the Failed Again") { again = button; }
        }
        QVERIFY(again && again->isVisible() && again->isEnabled());
        QSignalSpy ended(&bench.page.job(), &StudyTask::ended);
        again->click();
        QVERIFY(ended.wait(study_patience));
        QCOMPARE(bench.page.job().outcome().progress.kept, std::size_t{1}); // only the other ran
        QCOMPARE(bench.page.job().outcome().progress.failed, std::size_t{1});
    }

    void anEditedStudyIsNotLostWithoutAQuestion()
    {
        Bench bench;
        QVERIFY(bench.page.agreesToLeave()); // nothing is set up yet
        bench.addFactor(ends, 26, 36);
        const auto answer = [](QMessageBox::StandardButton button, bool* asked) {
            auto* timer = new QTimer;
            QObject::connect(timer, &QTimer::timeout, [timer, button, asked] {
                auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
                if (!box) { return; }
                *asked = true;
                timer->deleteLater();
                timer->stop();
                box->button(button)->click();
            });
            timer->start(20);
        };
        bool asked = false;
        answer(QMessageBox::Cancel, &asked);
        QVERIFY(!bench.page.agreesToLeave());
        QVERIFY(asked);
        answer(QMessageBox::Discard, &asked);
        QVERIFY(bench.page.agreesToLeave());
        QVERIFY(bench.page.saveStudy(bench.folder.filePath("kept.json")));
        QVERIFY(bench.page.agreesToLeave()); // without a question
    }

    void aRowBecomesACandidateAsOneStep()
    {
        Bench bench;
        bench.makeSmall();
        bench.runToTheEnd();
        const double value = bench.page.results()->table.find(ends)->numbers[1];
        QVERIFY(value != bench.document.design()->fabrics[0].ends_per_cm);
        bench.page.choose(1);
        bench.page.makeCandidate();
        QVERIFY2(bench.sentences.isEmpty(), qPrintable(bench.sentences.join('\n')));
        QCOMPARE(bench.document.design()->fabrics.size(), std::size_t{2});
        const Fabric& made = bench.document.design()->fabrics[1];
        QCOMPARE(made.name, std::string("cloth, study 1"));
        QCOMPARE(made.ends_per_cm, value);
        QCOMPARE(bench.document.fabricIndex(), 1);
        QVERIFY2(bench.messages.last().contains("volume"), qPrintable(bench.messages.last())); // which is no part of a fabric
        bench.document.history()->undo();
        QCOMPARE(bench.document.design()->fabrics.size(), std::size_t{1});
    }

    void manyRowsOpenAtOnce()
    {
        Bench bench;
        Study study;
        study.points = 100000;
        study.fidelity = Fidelity::live;
        study.metrics = {"maximum_wetted_radius_top_mm", "absorbency_time_s"};
        for (const char* path : {ends, "fabrics[0].picks_per_cm", angle}) { study.factors.push_back(proposedFactor(path, 30)); }
        const QString file = bench.folder.filePath("many");
        write_study_folder(folder_of(*bench.document.design(), study), file.toStdString());
        writeTable(file + "/results.csv", 100000);
        for (int turn = 0; turn < 2; ++turn) { // the second with the pages of the disk in memory
            QSignalSpy shown(&bench.page, &StudyPage::shown);
            QElapsedTimer clock;
            clock.start();
            bench.page.openResults(file);
            QVERIFY(shown.wait(study_patience));
            bench.page.repaint();
            qInfo("100 000 rows: %lld ms", clock.elapsed());
            QVERIFY(bench.page.results()->of);
            QVERIFY2(clock.elapsed() < 2000, "opening takes long");
        }
        QCOMPARE(bench.page.table().rowCount(), 100000);
        QElapsedTimer clock;
        for (QWidget* chart : {static_cast<QWidget*>(&bench.page.pairs().chart()), static_cast<QWidget*>(&bench.page.parallel().chart())}) {
            clock.restart();
            chart->grab();
            qInfo("%s: %lld ms", chart->metaObject()->className(), clock.elapsed());
            QVERIFY(clock.elapsed() < 4000);
        }
        clock.restart();
        bench.page.table().sort(2, Qt::DescendingOrder);
        qInfo("sorted: %lld ms", clock.elapsed());
        const auto& numbers = bench.page.results()->table.columns[2].numbers;
        QCOMPARE(numbers[bench.page.table().rowAt(0)], *std::max_element(numbers.begin(), numbers.end()));
    }

    void aDragAlongAnAxisKeepsItsRows()
    {
        Bench bench;
        const QString file = bench.folder.filePath("results.csv");
        writeTable(file, 500);
        QSignalSpy shown(&bench.page, &StudyPage::shown);
        bench.page.openResults(file);
        QVERIFY(shown.wait(study_patience));
        ParallelChart& chart = bench.page.parallel().chart();
        chart.resize(900, 500);
        const StudyAxis& axis = bench.page.results()->axes[1];
        const QPoint from = chart.placeOf(1, axis.numberAt(0.25)).toPoint(), to = chart.placeOf(1, axis.numberAt(0.5)).toPoint();
        QTest::mousePress(&chart, Qt::LeftButton, {}, from);
        QTest::mouseMove(&chart, (from + to) / 2);
        QTest::mouseMove(&chart, to);
        QTest::mouseRelease(&chart, Qt::LeftButton, {}, to);
        QCOMPARE(chart.brushes().size(), std::size_t{1});
        const AxisBrush brush = chart.brushes()[0];
        QVERIFY(std::abs(axis.placeOf(brush.low) - 0.25) < 0.01 && std::abs(axis.placeOf(brush.high) - 0.5) < 0.01);
        const auto inside = [&brush](double number) { return number >= brush.low && number <= brush.high; };
        const auto expected = std::count_if(axis.numbers.begin(), axis.numbers.end(), inside);
        QVERIFY(expected > 50 && expected < 250);
        QCOMPARE(bench.page.table().rowCount(), static_cast<int>(expected));
        for (int row = 0; row < bench.page.table().rowCount(); ++row) { QVERIFY(inside(axis.numbers[bench.page.table().rowAt(row)])); }
        QTest::mouseClick(&chart, Qt::LeftButton, {}, to);
        QCOMPARE(bench.page.table().rowCount(), 500);
    }

    void aClickOnAPointChoosesItsRow()
    {
        Bench bench;
        const QString file = bench.folder.filePath("results.csv");
        writeTable(file, 20);
        QSignalSpy shown(&bench.page, &StudyPage::shown);
        bench.page.openResults(file);
        QVERIFY(shown.wait(study_patience));
        PairsChart& chart = bench.page.pairs().chart();
        chart.resize(800, 500);
        QTest::mouseClick(&chart, Qt::LeftButton, {}, chart.placeOf(7)->toPoint());
        QVERIFY(bench.page.chosen().has_value());
        QCOMPARE(*bench.page.chosen(), std::size_t{7});
    }

    void theFolderForAClusterIsOneThatTheCommandLineReads()
    {
        Bench bench;
        bench.makeSmall();
        const QString folder = bench.folder.filePath("for a cluster");
        ClusterDialog dialog(bench.document.design(), bench.page.setup().study(), folder);
        QVERIFY2(dialog.write(), qPrintable(dialog.said()));
        QVERIFY(read_study_folder(folder.toStdString()).study == bench.page.setup().study());
        QCOMPARE(dialog.command().section('\n', 0, 0), "hygroloom-cli sweep -o '" + folder + "' --slurm");
    }

    void indicesAreComputedOrTheSentenceSaysWhatIsMissing()
    {
        Bench bench;
        bench.makeSmall(4);
        bench.runToTheEnd();
        QVERIFY(bench.page.indices().note().isEmpty()); // the study does not ask for them
        Q_EMIT bench.page.indices().computeRequested();
        const QString reason = QString::fromStdString(why_no_analysis());
        if (!reason.isEmpty()) {
            QTRY_COMPARE_WITH_TIMEOUT(bench.page.indices().note(), reason, study_patience);
            return;
        }
        QTRY_VERIFY_WITH_TIMEOUT(bench.page.results()->has_indices, study_patience);
        QVERIFY(!bench.page.results()->indices.empty());
    }

private:
    QTemporaryDir settings_;
};

QTEST_MAIN(TestStudyPage)
#include "tst_study_page.moc"
