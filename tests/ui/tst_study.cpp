// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is missing of a comparison, what the numbers so far give, and running it.
#include "compare_test.h"
#include "core/base/error.h"
#include "core/project/project_file.h"
#include "ui/compare/study_report.h"
#include "ui/document/run_folder.h"

#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

class TestStudy : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        qputenv("XDG_DATA_HOME", folder_.path().toUtf8()); // unsaved work
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
        design_ = read_project(std::string(HYGROLOOM_SOURCE_DIR) + "/resources/examples/three-candidates.hygro");
        design_.experiments.resize(1);
        design_.experiments[0].duration_s = 0.1;
        design_.experiments[0].sample_mm = {4, 4};
        design_.experiments[0].droplets = {Droplet{0.5, 0, {0, 0}, 0.05, 0}};
    }

    void aRunIsMissingUnlessOneIsOfTheDesignAsItIs()
    {
        Design older = design_;
        older.fabrics[1].contact_angle_deg = 70;
        KeptRun stopped = runOf(design_, 2, Fidelity::draft, 5);
        auto record = std::make_shared<RunRecord>(*stopped.run);
        record->wall = 0;
        stopped.run = record;
        const std::vector<KeptRun> runs{runOf(design_, 0, Fidelity::draft, 5), runOf(older, 1, Fidelity::draft, 6), stopped,
                                        runOf(design_, 1, Fidelity::standard, 7)};
        const auto rows = studyRows(design_, runs, {}, {experiment(), Fidelity::draft, 1});
        QCOMPARE(rows.size(), std::size_t{3});
        QVERIFY(rows[0].candidate && rows[0].missing.empty());
        QVERIFY(!rows[1].candidate && !rows[2].candidate);
        QCOMPARE(rows[1].missing, (std::vector<StudyJob>{{design_.fabrics[1].name, experiment(), Fidelity::draft, true, 0, 1}}));
        QCOMPARE(rows[2].missing.size(), std::size_t{1});
        QVERIFY(studyRows(design_, runs, {}, {experiment(), Fidelity::standard, 1})[1].candidate);
    }

    void theFirstReplicateIsTheProjectsRun()
    {
        const std::vector<KeptRun> runs{runOf(design_, 0, Fidelity::draft, 5)};
        const StudyChoice four{experiment(), Fidelity::draft, 4};
        const StudyRow row = studyRows(design_, runs, {}, four)[0];
        QCOMPARE(row.missing.size(), std::size_t{3});
        QVERIFY(std::none_of(row.missing.begin(), row.missing.end(), [](const StudyJob& job) { return job.recorded; }));
        QCOMPARE(row.missing.front().number, 1);
        QCOMPARE(row.runs, 1);
    }

    void replicatesCountOnlyForTheDesignThatTheyAreOf()
    {
        const std::vector<KeptRun> runs{runOf(design_, 0, Fidelity::draft, 5)};
        const StudyChoice four{experiment(), Fidelity::draft, 4};
        const std::vector<ReplicateSet> sets{setOf(design_, 4)};
        const StudyRow row = studyRows(design_, runs, sets, four)[0];
        QVERIFY(row.missing.empty());
        QCOMPARE(row.runs, 4);
        Comparison comparison = comparisonOf(compared_by(ExperimentType::droplet), four, {row}, "");
        judge(comparison);
        QCOMPARE(comparison.candidates.front().intervals.at(radius).runs, 4);
        QCOMPARE(comparison.candidates.front().intervals.at(radius).centre, 5.0); // the run's own 5 in place of the set's 3
        QVERIFY(comparison_csv(comparison).find("In 1 of 4 replicates water reached the edge of the sample, after 0.75 s") !=
                std::string::npos);
        Design changed = design_;
        changed.fabrics[0].contact_angle_deg = 50;
        QCOMPARE(studyRows(changed, {runOf(changed, 0, Fidelity::draft, 5)}, sets, four)[0].missing.size(), std::size_t{3});
        QCOMPARE(studyRows(design_, runs, sets, {experiment(), Fidelity::draft, 8})[0].missing.size(), std::size_t{7});
        changed = design_;
        changed.fabrics[1].contact_angle_deg = 50; // another fabric
        QVERIFY(studyRows(changed, {runOf(changed, 0, Fidelity::draft, 5)}, sets, four)[0].missing.empty());
    }

    void numbersOfReplicatesAreReadAsTheyWereWritten()
    {
        const std::vector<ReplicateSet> sets{setOf(design_, 4), setOf(design_, 8)};
        const std::vector<ReplicateSet> back = parse_replicates(format_replicates(sets), "file");
        QCOMPARE(back.size(), sets.size());
        for (std::size_t i = 0; i < sets.size(); ++i) {
            QVERIFY(back[i].key == sets[i].key);
            QCOMPARE(back[i].unknowns, sets[i].unknowns);
            QCOMPARE(back[i].runs.size(), sets[i].runs.size());
            for (const auto& [number, run] : sets[i].runs) {
                QCOMPARE(back[i].runs.at(number).numbers, run.numbers);
                QCOMPARE(back[i].runs.at(number).places, run.places);
                QCOMPARE(back[i].runs.at(number).edge_time, run.edge_time);
            }
        }
    }

    void aDamagedFileIsRefusedInASentence_data()
    {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("said");
        QTest::newRow("no JSON") << "{"
                                 << "["
                                 << "file";
        QTest::newRow("another format") << "hygroloom-replicates"
                                        << "hygroloom-project"
                                        << "hygroloom-replicates";
        QTest::newRow("a newer version") << "\"version\": 1,\n  \"sets\""
                                         << "\"version\": 2,\n  \"sets\""
                                         << "version 1";
        QTest::newRow("a number too high") << "\"number\": 3"
                                           << "\"number\": 4"
                                           << "0 to 3";
        QTest::newRow("a number twice") << "\"number\": 3"
                                        << "\"number\": 2"
                                        << "once";
        QTest::newRow("too many") << "\"of\": 4"
                                  << "\"of\": 4000"
                                  << "2 to 1000";
        QTest::newRow("a place outside") << "0.25"
                                         << "1.25"
                                         << "between 0 and 1";
        QTest::newRow("a place too few") << "[0.25]"
                                         << "[]"
                                         << "each of the unknowns";
        QTest::newRow("text for a number") << ": 4.0"
                                           << ": \"four\""
                                           << "four";
        QTest::newRow("a fidelity that is none") << "\"draft\""
                                                 << "\"sketch\""
                                                 << "draft, standard";
        QTest::newRow("another fabric") << "\"fabric\": \"Cotton plain\""
                                        << "\"fabric\": \"Cotton twill\""
                                        << "the fabric";
        QTest::newRow("an unknown key") << "\"seed\""
                                        << "\"sed\""
                                        << "sed";
    }
    void aDamagedFileIsRefusedInASentence()
    {
        QFETCH(const QString, from);
        QFETCH(const QString, to);
        QFETCH(const QString, said);
        QString text = QString::fromStdString(format_replicates({setOf(design_, 4)}));
        QVERIFY2(text.contains(from), qPrintable(text.left(600)));
        text.replace(text.indexOf(from), from.size(), to);
        try {
            parse_replicates(text.toStdString(), "file");
            QFAIL("It was taken.");
        } catch (const FileError& error) {
            QVERIFY2(QString::fromStdString(error.what()).contains(said), error.what());
        }
        for (qsizetype length = 0; length < text.size(); length += 97) { // cut short anywhere
            try {
                parse_replicates(text.left(length).toStdString(), "file");
                QFAIL("It was taken.");
            } catch (const FileError&) {
            }
        }
    }

    void tiesAreShownAsTiesAndVerdictsInWords()
    {
        Comparison comparison;
        comparison.experiment = "one drop";
        comparison.criteria = compared_by(ExperimentType::droplet);
        comparison.ranked_by = comparison.criteria.front();
        comparison.baseline = "b";
        comparison.candidates = {candidate("a", 5, 0.1), candidate("b", 8, 0.5), candidate("c", 8.2, 0.5)};
        const std::vector<GridEntry> entries{{"a", "a"}, {"b", "b"}, {"c", "c"}, {"d", {}, false, 0, {StudyJob{"d", "one drop"}}}};
        std::vector<GridEntry> own = entries;
        for (std::size_t i = 0; i < 3; ++i) { own[i].runs = 1; }
        judge(comparison);
        Grid grid = gridOf(comparison, own);
        QCOMPARE(grid.rows[0].rank, QString("3"));
        QCOMPARE(grid.rows[1].rank, QString("1="));
        QCOMPARE(grid.rows[2].rank, QString("1="));
        QCOMPARE(grid.rows[3].rank, QString());
        QCOMPARE(grid.rows[0].cells[0].verdict, QString("worse"));
        QCOMPARE(grid.rows[1].cells[0].verdict, QString("baseline"));
        QCOMPARE(grid.rows[2].cells[0].verdict, QString("no difference shown"));
        QVERIFY(grid.rows[3].cells[0].state == GridCell::State::missing);
        QCOMPARE(grid.rows[1].cells[0].number, QString("8.00 ± 0.50") + QChar(0x00a0) + "mm");
        QCOMPARE(grid.columns[0].low, 4.9);
        QCOMPARE(grid.columns[0].high, 8.7);
        sortRows(grid, 0, false);
        QCOMPARE(grid.rows.front().name, std::string("c"));
        QCOMPARE(grid.rows.back().name, std::string("d"));
        sortRows(grid, 0, true);
        QCOMPARE(grid.rows.front().name, std::string("a"));
        QCOMPARE(grid.rows.back().name, std::string("d")); // what has no number stays last
        filterRows(grid, "B");
        QCOMPARE(grid.rows.size(), std::size_t{1});
    }

    void anUnfinishedSetOfReplicatesHasNoVerdict()
    {
        Comparison comparison;
        comparison.criteria = compared_by(ExperimentType::droplet);
        comparison.ranked_by = comparison.criteria.front();
        comparison.baseline = "a";
        comparison.replicates = 4;
        comparison.candidates = {candidate("a", 5, 0.1), candidate("b", 8, 0.5)};
        judge(comparison);
        const Grid grid = gridOf(comparison, {{"a", "a", false, 1}, {"b", "b", false, 1}});
        QCOMPARE(grid.rows[1].cells[0].verdict, QString("1 of 4 runs"));
        QCOMPARE(grid.rows[0].rank, QString("1="));
    }

    void measuredNumbersStandBesideTheSimulated()
    {
        Comparison comparison;
        comparison.experiment = "one drop";
        comparison.criteria = compared_by(ExperimentType::droplet);
        comparison.ranked_by = comparison.criteria.front();
        comparison.baseline = "a";
        comparison.candidates = {candidate("a", 5, 0.1), candidate("b", 8, 0.5)};
        judge(comparison);
        const QString key = QString::fromStdString(comparison.criteria.front().key);
        const QString file = folder_.filePath("measured.csv");
        const auto write = [&file](const QString& rows) {
            QFile table(file);
            QVERIFY(table.open(QIODevice::WriteOnly));
            table.write(("fabric,metric,value,unit,spread\n" + rows).toUtf8());
        };
        write("b," + key + ",7.25,mm,0.5\n");
        const std::vector<std::string> fabrics{"a", "b", "d"}; // d has not been run
        comparison.measured = readMeasured(comparison.criteria, fabrics, file);
        const Grid grid = gridOf(comparison, {{"a", "a", false, 1}, {"b", "b", false, 1}});
        QCOMPARE(grid.rows[0].cells[0].measured, QString());
        QCOMPARE(grid.rows[1].cells[0].measured, QString("measured 7.25 ± 0.5") + QChar(0x00a0) + "mm");
        CandidateTable table;
        table.setGrid(grid, {}, false);
        QVERIFY(table.item(0, CandidateTable::first_number)->text().contains("measured 7.25")); // b is the best
        const QString report = QString::fromStdString(html_of(studyReport(comparison, {})));
        QVERIFY(report.contains("measured 7.25") && report.contains("better"));
        write("c," + key + ",7.25,mm,\n");
        QVERIFY_EXCEPTION_THROWN(readMeasured(comparison.criteria, fabrics, file), Error); // there is no c
        write("d," + key + ",7.25,mm,\n");
        QCOMPARE(readMeasured(comparison.criteria, fabrics, file).size(), std::size_t{1});
        rememberMeasured("/a/b.hygro", "one drop", file);
        QCOMPARE(measuredFile("/a/b.hygro", "one drop"), file);
        QCOMPARE(measuredFile("/a/b.hygro", "another"), QString());
    }

    void mouseAndKeysRunOpenAndPin()
    {
        Comparison comparison;
        comparison.criteria = compared_by(ExperimentType::droplet);
        comparison.ranked_by = comparison.criteria.front();
        comparison.baseline = "a";
        comparison.candidates = {candidate("a", 5, 0.1), candidate("b", 8, 0.5)};
        judge(comparison);
        const std::vector<GridEntry> entries{
            {"a", "run a", false, 1}, {"b", "run b", false, 1}, {"c", {}, false, 0, {StudyJob{"c", "one drop"}}}};
        CandidateTable table;
        table.resize(900, 400);
        table.setGrid(gridOf(comparison, entries), {}, false);
        table.show();
        QCOMPARE(table.grid().rows[0].name, std::string("b")); // the best first
        QStringList opened, run, pinned;
        connect(&table, &CandidateTable::openRequested, this, [&](const QString& path) { opened << path; });
        connect(&table, &CandidateTable::baselineRequested, this, [&](const std::string& name) { pinned << QString::fromStdString(name); });
        connect(&table, &CandidateTable::runRequested, this, [&](const std::vector<StudyJob>& jobs) {
            for (const StudyJob& job : jobs) { run << QString::fromStdString(job.fabric); }
        });
        const auto at = [&table](int row, int column) { return table.visualItemRect(table.item(row, column)); };
        const auto click = [&table](const QPoint& point) { QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, point); };
        const QRect missing = at(2, CandidateTable::first_number);
        click(missing.topLeft() + QPoint(missing.width() - 8, missing.height() / 2)); // beside the button
        QVERIFY(run.isEmpty() && opened.isEmpty());
        click(QPoint(missing.left() + 30 + table.fontMetrics().horizontalAdvance("not run"), missing.center().y()));
        QCOMPARE(run, QStringList{"c"});
        click(at(0, CandidateTable::first_number).center());
        QCOMPARE(opened, QStringList{"run b"});
        click(at(0, CandidateTable::pin_column).center());
        QCOMPARE(pinned, QStringList{"b"});
        table.setCurrentCell(1, CandidateTable::first_number);
        QTest::keyClick(&table, Qt::Key_Return);
        QCOMPARE(opened.back(), QString("run a"));
        table.setCurrentCell(2, CandidateTable::first_number);
        QTest::keyClick(&table, Qt::Key_Return);
        QCOMPARE(run, (QStringList{"c", "c"}));
    }

    void runningWhatIsMissingFillsTheTableAndIsFoundAgain()
    {
        const QString path = folder_.filePath("p/cloth.hygro");
        QVERIFY(QDir().mkpath(QFileInfo(path).absolutePath()));
        Design two = design_;
        two.fabrics.pop_back();
        write_project(two, path.toStdString());
        const auto& first = two.fabrics[0].name;
        {
            Workplace place;
            QVERIFY(place.document.open(path));
            CompareView& view = place.view;
            view.resize(900, 700);
            view.show();
            QCOMPARE(view.table()->cellText(rowOf(view, first), 0), QString("not run"));
            QTRY_VERIFY(view.bar()->runAll()->isEnabled());
            view.bar()->setReplicates(4);
            view.bar()->runAll()->click();
            QVERIFY(place.runs.running());
            const int id = place.queue.list().front().id;
            place.queue.runs().set_paused(id, true); // in the list of runs
            QTRY_VERIFY(place.runs.paused());
            QVERIFY2(place.runs.stateText().endsWith(" of 8 runs done, paused."), qPrintable(place.runs.stateText()));
            place.queue.runs().set_paused(id, false);
            QTRY_VERIFY(!place.runs.paused());
            QTRY_VERIFY_WITH_TIMEOUT(!place.runs.running(), 120000);
            const QString text = view.table()->cellText(rowOf(view, first), 0);
            QVERIFY2(text.contains(QChar(0x00b1)) && text.endsWith("baseline"), qPrintable(text));
            QVERIFY(!view.bar()->runAll()->isEnabled());
            QCOMPARE(place.history.runs().size(), std::size_t{2}); // the other replicates have no recordings
            QVERIFY(place.history.runs()[0].own && place.history.runs()[0].saved);
            QCOMPARE(recordingsIn(runFolderOf(path)).size(), 2);
            QCOMPARE(view.comparison().candidates.front().replicates.size(), std::size_t{4});
            QCOMPARE(view.comparison().candidates.front().intervals.at(radius).runs, 4);
        }
        Workplace again;
        QSignalSpy failed(&again.runs, &StudyRuns::failed);
        QVERIFY(again.document.open(path));
        again.project.setCompared(true);
        again.view.bar()->setReplicates(4);
        QTRY_VERIFY_WITH_TIMEOUT(again.view.comparison().candidates.size() == 2, 20000);
        QCOMPARE(again.view.comparison().candidates.front().intervals.at(radius).runs, 4);
        again.document.edit("an angle", {}, [](Design& design) { design.fabrics[0].contact_angle_deg = 50; });
        again.view.show(); // which brings it up to date
        QCOMPARE(again.view.table()->cellText(rowOf(again.view, first), 0), QString("outdated"));
        QCOMPARE(failed.count(), 0);
    }

    void aDamagedFileBesideTheRunsIsSaidAndKept()
    {
        const QString path = folder_.filePath("d/cloth.hygro"), file = replicatesIn(runFolderOf(path));
        QVERIFY(QDir().mkpath(QFileInfo(file).absolutePath()));
        write_project(design_, path.toStdString());
        QFile damaged(file);
        QVERIFY(damaged.open(QIODevice::WriteOnly) && damaged.write("{\"format\": 3}") > 0);
        damaged.close();
        Workplace place;
        QSignalSpy failed(&place.runs, &StudyRuns::failed);
        QVERIFY(place.document.open(path));
        QCOMPARE(failed.count(), 1);
        QVERIFY(failed[0][0].toString().contains("replicates"));
        auto& store = const_cast<ReplicateStore&>(place.runs.store());
        store.add(setOf(design_, 4));
        QTRY_VERIFY(QFile::exists(file + "~")); // in the background
        QCOMPARE(read_replicates(file.toStdString()).size(), std::size_t{1});
    }

    void whatIsNotSavedYetIsSavedAtTheEnd()
    {
        const QString path = folder_.filePath("cloth.hygro");
        write_project(design_, path.toStdString());
        {
            Workplace place;
            QVERIFY(place.document.open(path));
            for (int of = 2; of < 9; ++of) { const_cast<ReplicateStore&>(place.runs.store()).add(setOf(design_, of)); }
        }
        QCOMPARE(read_replicates(replicatesIn(runFolderOf(path)).toStdString()).size(), std::size_t{7});
    }

    void leftoversAreDropped()
    {
        Design renamed = design_;
        renamed.fabrics[0].name = "gone";
        std::vector<ReplicateSet> sets{setOf(renamed, 4)};
        for (int of = 2; of < 2 + static_cast<int>(most_kept_sets) + 5; ++of) { sets.push_back(setOf(design_, of)); }
        const std::vector<ReplicateSet> kept = without_leftovers(sets, design_);
        QVERIFY(kept.size() < most_kept_sets && kept.back().key == sets.back().key); // there are too many runs in all
        std::size_t runs = 0;
        for (const ReplicateSet& set : kept) { runs += set.runs.size(); }
        QVERIFY(runs <= most_kept_runs && runs + most_kept_sets + 6 > most_kept_runs);
        for (ReplicateSet& set : sets) { set.runs.clear(); }
        QCOMPARE(without_leftovers(sets, design_).size(), most_kept_sets);
        QVERIFY(without_leftovers({setOf(renamed, 4)}, design_).empty());
        merge(sets, setOf(design_, 2)); // the last to be used goes last
        QCOMPARE(sets.back().key.of, 2);
        QString text = QString::fromStdString(format_replicates({setOf(design_, 4)}));
        QVERIFY(text.contains("\"answers\": \""));
        text.replace("\"answers\": \"", "\"answers\": \"0");
        QVERIFY(parse_replicates(text.toStdString(), "file").empty()); // of another version
    }

    void replicatesGoAlongWithAProjectThatIsSavedElsewhere()
    {
        const QString path = folder_.filePath("e/cloth.hygro"), other = folder_.filePath("f/cloth.hygro");
        for (const QString& each : {path, other}) { QVERIFY(QDir().mkpath(QFileInfo(each).absolutePath())); }
        write_project(design_, path.toStdString());
        Workplace place;
        QVERIFY(place.document.open(path));
        const_cast<ReplicateStore&>(place.runs.store()).add(setOf(design_, 4));
        QVERIFY(place.document.saveAs(other));
        QTRY_VERIFY(QFile::exists(replicatesIn(runFolderOf(other))));
        QCOMPARE(read_replicates(replicatesIn(runFolderOf(other)).toStdString()).size(), std::size_t{1});
        QCOMPARE(place.runs.store().sets().size(), std::size_t{1});
    }

private:
    static constexpr const char* radius = "equal_area_radius_mm";

    std::string experiment() const { return design_.experiments[0].name; }

    static Candidate candidate(const std::string& name, double radius_mm, double half)
    {
        Candidate made;
        made.fabric = name;
        made.numerical[radius] = half;
        made.replicates = {ReplicateRun{{{radius, radius_mm}}, {}}};
        return made;
    }

    QTemporaryDir folder_;
    Design design_;
};

QTEST_MAIN(TestStudy)
#include "tst_study.moc"
