// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs side by side. The recordings are short runs of the example, so that reading them is part of what is tested.
#include "compare_test.h"
#include "core/analysis/metrics.h"
#include "core/project/project_file.h"
#include "core/run/runner.h"
#include "gpu/backends.h"
#include "ui/compare/card_columns.h"
#include "ui/compare/compare_maps.h"
#include "ui/document/run_folder.h"

#include <QComboBox>
#include <QLabel>
#include <QSet>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include <algorithm>

using namespace hygroloom;

class TestCompareView : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        qputenv("XDG_DATA_HOME", folder_.path().toUtf8()); // unsaved work
        three_ = read_project(std::string(HYGROLOOM_SOURCE_DIR) + "/resources/examples/three-candidates.hygro");
        three_.experiments.resize(1);
        Design design = read_project(std::string(HYGROLOOM_SOURCE_DIR) + "/resources/examples/one-drop-on-cotton.hygro");
        Experiment& drop = design.experiments[0];
        drop.duration_s = 0.2;
        drop.sample_mm = {4, 4};
        drop.droplets = {Droplet{0.5, 0, {0, 0}, 0.05, 0}};
        thick_ = ran(design, "thick");
        design.fabrics[0].name = "a thinner fabric, whose name is as long as names of fabrics get to be in a mill";
        design.fabrics[0].contact_angle_deg = 35.5; // wets a little less
        thin_ = ran(design, "thin");
        Design open = design;
        open.fabrics[0].name = "open";
        open.fabrics[0].ends_per_cm *= 0.8;
        open_ = ran(open, "open");
        design.experiments[0].climate.temperature_c = 35;
        hot_ = ran(design, "hot");
        cut_short_ = thick_;
        auto run = std::make_shared<RunRecord>(*thick_.run);
        run->wall = 0;
        cut_short_.run = run;
        cut_short_.path += " cut short";
    }

    void anEmptyHistorySaysWhatToDo()
    {
        Workplace place;
        auto& [document, recovery, history, project, queue, runs, view] = place;
        view.resize(900, 600);
        view.show();
        QVERIFY(view.chosen().isEmpty());
        bool reported = false;
        for (const QLabel* label : view.findChildren<QLabel*>()) {
            reported = reported || (label->isVisible() && label->text().startsWith("Nothing has been run yet"));
        }
        QVERIFY(reported);
    }

    void untilTheRunsAreFoundNothingIsSaidOfThem()
    {
        Workplace place;
        auto& [document, recovery, history, project, queue, runs, view] = place;
        document.take(three_, "three");
        view.resize(900, 600);
        view.show();
        auto* fidelity = view.bar()->findChildren<QComboBox*>()[1];
        history.setListing(true);
        KeptRun old = runOf(three_, 0, Fidelity::live, 3);
        old.own = true;
        history.keep(old);
        QCOMPARE(fidelity->currentText(), QString());
        QCOMPARE(fidelity->placeholderText(), QString("reading…"));
        const auto states = [&] {
            QSet<GridCell::State> found;
            for (const GridRow& row : view.table()->grid().rows) { found << row.cells[0].state; }
            return found;
        };
        view.showExperiment(three_.experiments[0].name);
        QVERIFY(states().contains(GridCell::State::reading) && !states().contains(GridCell::State::missing));
        const auto says = [&](const char* words) {
            const auto labels = view.findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) { return label->accessibleDescription() == words; });
        };
        QVERIFY(says("reading…")); // not that nothing is missing
        view.showExperiment({});
        KeptRun last = runOf(three_, 1, Fidelity::standard, 4);
        last.own = true;
        const auto numbers = std::exchange(last.metrics, nullptr); // which are read after it was found
        history.keep(last);
        history.setListing(false);
        QCOMPARE(view.bar()->fidelity(), Fidelity::standard);
        history.setMetrics(last.path, numbers);
        QVERIFY(states().contains(GridCell::State::missing) && !states().contains(GridCell::State::reading));
        QCOMPARE(view.bar()->fidelity(), Fidelity::standard);
        QVERIFY(!fidelity->currentText().isEmpty());
    }

    void cardsAreColumnsLikeAnyOther()
    {
        Workplace place;
        auto& [document, recovery, history, project, queue, runs, view] = place;
        Design priced = three_;
        for (Fabric& fabric : priced.fabrics) {
            for (Yarn* yarn : yarns_of(fabric)) { yarn->price = 6; }
        }
        document.take(priced, "three");
        view.resize(900, 600);
        view.show();
        view.showExperiment(three_.experiments[0].name);
        const std::size_t before = view.table()->grid().columns.size();
        view.cards().choose("ret_m2pa_w", true);
        view.cards().choose("cost_per_m", true);
        const auto known = [&] {
            const std::vector<GridRow>& rows = view.table()->grid().rows;
            return std::all_of(rows.begin(), rows.end(), [&](const GridRow& row) {
                return row.cells.size() == before + 2 && row.cells[before].state == GridCell::State::number;
            });
        };
        QTRY_VERIFY_WITH_TIMEOUT(known(), 60000); // without any run
        for (const GridRow& row : view.table()->grid().rows) {
            const GridCell &ret = row.cells[before], &cost = row.cells.back();
            QVERIFY(ret.low < ret.value && ret.value < ret.high && ret.number.contains("m² Pa/W"));
            QVERIFY(cost.value > 0 && cost.low == cost.high);
        }
        view.cards().choose("ret_m2pa_w", false);
        view.cards().choose("cost_per_m", false);
        QCOMPARE(view.table()->grid().columns.size(), before);
    }

    void twoFabricsStandSideBySideInOneRange()
    {
        Workplace place;
        auto& [document, recovery, history, project, queue, runs, view] = place;
        view.resize(900, 600);
        view.show();
        history.keep(thick_);
        history.keep(thin_);
        QSignalSpy mapped(&view, &CompareView::mapsChanged);
        view.choose(thick_.path, true);
        view.choose(thin_.path, true);
        QTRY_VERIFY_WITH_TIMEOUT(view.maps().size() == 2 && mapped.count() > 0 && view.maps()[1]->map().maximum() > 0, 10000);
        QVERIFY(view.maps()[0]->map().maximum() > 0);
        QVERIFY(view.maps()[0]->circle().radius > 0);

        CandidateTable* table = view.table();
        QVERIFY(!table->tabKeyNavigation()); // it would keep the focus
        QCOMPARE(table->rowCount(), 2);
        QCOMPARE(table->horizontalHeaderItem(CandidateTable::first_number)->text(), QString("Stain radius by area, top (mm)"));
        QVERIFY(thick_.metrics->equal_area_radius_top != thin_.metrics->equal_area_radius_top);
        const auto text = [&](const KeptRun& run) { return table->cellText(rowOf(view, run.run->fabric), 0); };
        QVERIFY(text(thick_).endsWith("\nbaseline")); // it is not better than itself
        // They lie within a crossing of each other.
        QVERIFY2(text(thin_).endsWith("\nno difference shown"), qPrintable(text(thin_)));
        QVERIFY(text(thin_).contains(QChar(0x00b1)));
        const auto labels = view.findChildren<QLabel*>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
            return !label->isHidden() && label->text().contains("rest on the numerical error of one run");
        }));
        view.setBaseline(thin_.path);
        QVERIFY(text(thin_).endsWith("\nbaseline"));
        QVERIFY(text(thick_).endsWith("\nno difference shown"));
        QVERIFY(text(thick_).contains(" mm") || text(thick_).contains(QString(QChar(0x00a0)) + "mm"));
    }

    void theDifferenceToTheBaselineTakesItsPlace()
    {
        Workplace place;
        CompareView& view = place.view;
        view.resize(900, 700);
        view.show();
        place.history.keep(thick_);
        place.history.keep(thin_);
        QTRY_VERIFY_WITH_TIMEOUT(view.maps().size() == 2 && view.maps()[1]->map().maximum() > 0, 10000);
        const double wet = view.maps()[1]->map().maximum();
        QSignalSpy mapped(&view, &CompareView::mapsChanged);
        auto* maps = view.findChild<CompareMaps*>();
        maps->show(CompareMaps::Shown::differences);
        QTRY_VERIFY_WITH_TIMEOUT(mapped.count() > 0, 10000);
        QVERIFY(!view.maps()[0]->isVisible() && view.maps()[1]->isVisible()); // the baseline's own is nothing
        const auto& water = view.maps()[1]->map().water;
        QVERIFY(*std::min_element(water.begin(), water.end()) < 0); // it holds less somewhere, and not only water
        QVERIFY(view.maps()[1]->map().maximum() < wet);
        const auto labels = view.findChildren<QLabel*>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
            return label->isVisible() && label->text().contains("Grey: ") && label->text().contains("numerical error");
        }));
        view.setBaseline(thin_.path);
        QTRY_VERIFY_WITH_TIMEOUT(view.maps().size() == 2 && view.maps()[0]->isVisible() && !view.maps()[1]->isVisible(), 10000);
    }

    void anEmptyDifferenceSaysOnlyWhyItIsEmpty()
    {
        Workplace place;
        CompareView& view = place.view;
        view.resize(900, 700);
        view.show();
        place.history.keep(thick_);
        place.history.keep(open_);
        QTRY_VERIFY_WITH_TIMEOUT(view.maps().size() == 2 && view.maps()[1]->map().maximum() > 0, 10000);
        QSignalSpy mapped(&view, &CompareView::mapsChanged);
        auto* maps = view.findChild<CompareMaps*>();
        maps->show(CompareMaps::Shown::differences);
        QTRY_VERIFY_WITH_TIMEOUT(mapped.count() > 0, 10000);
        const auto said = [maps] {
            QStringList texts;
            for (const QLabel* label : maps->findChildren<QLabel*>()) { texts << (label->isVisible() ? label->text() : QString()); }
            return texts.join('\n');
        };
        QVERIFY2(said().contains("There is no difference map of open: its setts differ from the baseline’s"), qPrintable(said()));
        QVERIFY2(!said().contains("error") && !said().contains("Water less that"), qPrintable(said()));
        // Beside one that there is, whose error the table knows.
        const QString knows = view.table()->cellText(rowOf(view, open_.run->fabric), 0);
        QVERIFY2(knows.contains(QChar(0x00b1)), qPrintable(knows));
        mapped.clear();
        place.history.keep(thin_);
        QTRY_VERIFY_WITH_TIMEOUT(mapped.count() > 0, 10000);
        QVERIFY2(said().contains("There is no difference map of open") && said().contains("% of the wetter one"), qPrintable(said()));
        QVERIFY2(!said().contains("not known"), qPrintable(said()));
    }

    void theNewestRunsThatGoTogetherAreProposed()
    {
        Workplace place;
        auto& [document, recovery, history, project, queue, runs, view] = place;
        for (const KeptRun& run : {hot_, thick_, thin_, cut_short_}) { history.keep(run); }
        QCOMPARE(view.chosen(), (QStringList{thin_.path, thick_.path}));
        view.choose(thin_.path, false);
        history.keep(thin_);
        QCOMPARE(view.chosen(), QStringList{thick_.path}); // from now on it is the user who chooses
    }

    void anExperimentThatIsChangedStaysOnScreen()
    {
        const QString path = folder_.filePath("changed.hygro");
        write_project(three_, path.toStdString());
        Workplace place;
        QVERIFY(place.document.open(path));
        CompareView& view = place.view;
        view.resize(900, 700);
        view.show();
        for (const std::size_t fabric : {std::size_t{0}, std::size_t{1}}) {
            KeptRun run = runOf(three_, fabric, Fidelity::draft, 3.0 + static_cast<double>(fabric));
            run.own = true;
            place.history.keep(run);
        }
        QCOMPARE(view.chosen().size(), 2);
        QCOMPARE(view.bar()->experiment(), 1);
        place.document.edit("longer", {}, [](Design& design) { design.experiments[0].duration_s += 1; });
        QCOMPARE(view.bar()->experiment(), 1); // not the runs as they were
        QCOMPARE(view.comparison().experiment, three_.experiments[0].name);
        QVERIFY(view.chosen().isEmpty());
        QCOMPARE(view.table()->cellText(rowOf(view, three_.fabrics[0].name), 0), QString("outdated"));
        QCOMPARE(view.table()->cellText(rowOf(view, three_.fabrics[2].name), 0), QString("not run"));
        const auto labels = view.findChildren<QLabel*>();
        const QString names = QString::fromStdString(three_.fabrics[0].name + ", " + three_.fabrics[1].name);
        const QString outdated = "Outdated, as the design or the program has changed since they were run: " + names + ".";
        QVERIFY(std::any_of(labels.begin(), labels.end(),
                            [&](const QLabel* label) { return label->isVisible() && label->text().contains(outdated); }));
        place.document.edit("another name", {}, [](Design& design) { design.experiments[0].name = "renamed"; });
        QCOMPARE(view.bar()->experiment(), 1);
        for (int i = 0; i < 2; ++i) { place.document.history()->undo(); }
        QCOMPARE(view.bar()->experiment(), 1);
        QCOMPARE(view.chosen().size(), 2);
        view.choose(view.chosen().first(), false); // the user's own choice
        place.document.edit("longer", {}, [](Design& design) { design.experiments[0].duration_s += 1; });
        QCOMPARE(view.bar()->experiment(), 1);
    }

    void theReplicatesThatAreKeptAreChosen()
    {
        const QString path = folder_.filePath("k/cloth.hygro");
        QVERIFY(QDir().mkpath(runFolderOf(path)));
        Design one = three_;
        one.fabrics.resize(1);
        write_project(one, path.toStdString());
        QFile file(replicatesIn(runFolderOf(path)));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(file.write(QByteArray::fromStdString(format_replicates({setOf(one, 8), setOf(one, 4)}))) > 0);
        file.close();
        KeptRun run = runOf(one, 0, Fidelity::draft, 3);
        run.own = true;
        {
            Workplace place;
            QVERIFY(place.document.open(path));
            place.view.show();
            QCOMPARE(place.view.bar()->replicates(), 1); // the run of the project is missing
            place.history.keep(run);
            QCOMPARE(place.view.bar()->replicates(), 8);
            QCOMPARE(place.view.comparison().replicates, 8);
            QVERIFY(place.view.comparison().complete);
            place.document.edit("an angle", {}, [](Design& design) { design.fabrics[0].contact_angle_deg = 50; });
            QCOMPARE(place.view.bar()->replicates(), 8); // what is missing now is to be run again
            place.document.history()->undo();
            place.view.bar()->setReplicates(4);
            place.history.setMarked(run.path, true);
            QCOMPARE(place.view.bar()->replicates(), 4); // it is the user's from now on
        }
        Workplace place;
        QVERIFY(place.document.open(path));
        place.document.edit("two fabrics", {}, [this](Design& design) { design.fabrics.push_back(three_.fabrics[1]); });
        place.view.show();
        place.history.keep(run);
        QCOMPARE(place.view.bar()->replicates(), 1); // of the other there is nothing
    }

    void onlyRunsOfTheSameExperimentThatEndedAreTaken()
    {
        Workplace place;
        auto& [document, recovery, history, project, queue, runs, view] = place;
        for (const KeptRun& run : {thick_, hot_, cut_short_}) { history.keep(run); }
        view.choose(hot_.path, false);
        view.choose(thick_.path, true);
        view.choose(hot_.path, true);
        view.choose(cut_short_.path, true);
        QCOMPARE(view.chosen(), QStringList{thick_.path});
        const auto* list = view.findChild<QTreeWidget*>();
        QVERIFY(list->topLevelItem(0)->flags() & Qt::ItemIsUserCheckable);
        QVERIFY(!(list->topLevelItem(1)->flags() & Qt::ItemIsUserCheckable));
        QVERIFY(list->topLevelItem(1)->toolTip(0).contains("another experiment"));
        QVERIFY(list->topLevelItem(2)->toolTip(0).contains("Only completed runs"));
        view.choose(thick_.path, false);
        view.choose(hot_.path, true);
        QCOMPARE(view.chosen(), QStringList{hot_.path});
    }

    void tickingARunTakesIt()
    {
        Workplace place;
        auto& [document, recovery, history, project, queue, runs, view] = place;
        history.keep(thick_);
        QCOMPARE(view.chosen(), QStringList{thick_.path});
        auto* list = view.findChild<QTreeWidget*>();
        list->topLevelItem(0)->setCheckState(0, Qt::Unchecked);
        QTRY_VERIFY(view.chosen().isEmpty());
        list->topLevelItem(0)->setCheckState(0, Qt::Checked);
        QTRY_COMPARE(view.chosen(), QStringList{thick_.path});
    }

    void aRunThatIsKeptAgainStaysOneAndSaved()
    {
        RunHistory history;
        history.keep(thick_);
        history.keep(thin_);
        const auto saved = [&history](const KeptRun& run) { return isSaved(*history.find(run.path)); };
        QVERIFY(!saved(thick_));
        const QString copy = thick_.path + " copy";
        QVERIFY(QFile::copy(thick_.path, copy));
        history.markCopied(thick_.path, copy);
        history.keep(thick_);
        QCOMPARE(history.runs().size(), std::size_t{2});
        QVERIFY(saved(thick_) && !saved(thin_));
        QVERIFY(QFile::remove(copy) && QFile::copy(thin_.path, copy));
        history.markCopied(thin_.path, copy);
        QVERIFY(!saved(thick_) && saved(thin_));
        QVERIFY(QFile::remove(copy));
        QVERIFY(!saved(thin_));
    }

    void theTableIsWrittenBestFirst()
    {
        const bool thickIsBest = thick_.metrics->equal_area_radius_top > thin_.metrics->equal_area_radius_top;
        const KeptRun& best = thickIsBest ? thick_ : thin_;
        const KeptRun& worse = thickIsBest ? thin_ : thick_;
        Workplace place;
        auto& [document, recovery, history, project, queue, runs, view] = place;
        for (const KeptRun& run : {worse, best}) { history.keep(run); }
        view.choose(worse.path, true);
        view.choose(best.path, true);
        const QString csv = QString::fromStdString(view.tableCsv());
        QVERIFY2(csv.contains("\n1,\"" + QString::fromStdString(best.run->fabric)), qPrintable(csv));
        // They cannot be told apart, so they share the rank; the larger comes first.
        const QString second = "\n1,\"" + QString::fromStdString(worse.run->fabric);
        QVERIFY2(csv.indexOf(second) > csv.indexOf("\n1,\"" + QString::fromStdString(best.run->fabric)), qPrintable(csv));
    }

    void runsOfOneFabricAreNumbered()
    {
        Workplace place;
        auto& [document, recovery, history, project, queue, runs, view] = place;
        KeptRun again = thick_;
        again.path = folder_.filePath("again.hygrorec");
        QVERIFY(QFile::copy(thick_.path, again.path));
        for (const KeptRun& run : {thick_, thin_, again}) { history.keep(run); }
        view.choose(thick_.path, true);
        const QString fabric = QString::fromStdString(thick_.run->fabric);
        const auto* list = view.findChild<QTreeWidget*>();
        QCOMPARE(list->topLevelItem(0)->text(0), "1: " + fabric);
        QCOMPARE(list->topLevelItem(1)->text(0), QString::fromStdString(thin_.run->fabric));
        QCOMPARE(list->topLevelItem(2)->text(0), "3: " + fabric);
        QVERIFY(rowOf(view, "1: " + thick_.run->fabric) >= 0 && rowOf(view, "3: " + thick_.run->fabric) >= 0);
        QVERIFY(QString::fromStdString(view.tableCsv()).contains("\"3: " + fabric));
        QCOMPARE(view.maps()[0]->accessibleName(), "Water on 1: " + fabric);
    }

    void aRecordingThatWasReplacedIsNotDrawnAsTheOldRun()
    {
        Workplace place;
        auto& [document, recovery, history, project, queue, runs, view] = place;
        view.resize(900, 600);
        view.show();
        KeptRun replaced = thick_;
        replaced.path = folder_.filePath("replaced.hygrorec");
        QVERIFY(QFile::copy(thin_.path, replaced.path));
        history.keep(replaced);
        const auto reported = [&view] {
            const auto labels = view.findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(),
                               [](const QLabel* label) { return label->isVisible() && label->text().contains("holds another run now"); });
        };
        QTRY_VERIFY_WITH_TIMEOUT(reported(), 10000);
        history.forget(replaced.path);
        QVERIFY(history.runs().empty());
        QVERIFY(!reported());
    }

private:
    KeptRun ran(const Design& design, const QString& name)
    {
        RunOptions options;
        options.fidelity = Fidelity::draft;
        const QString path = folder_.filePath(name + ".hygrorec");
        options.recording = path.toStdString();
        MetricsCollector collector;
        RunCallbacks callbacks;
        callbacks.started = [&](const RunRecord& run) { collector.start(run); };
        callbacks.frame = [&](const std::shared_ptr<const Frame>& frame) { collector.add(*frame); };
        const auto backend = make_backend("cpu");
        RunControl control;
        auto run = std::make_shared<const RunRecord>(
            run_experiment(design, design.fabrics[0].name, design.experiments[0].name, options, *backend, control, callbacks));
        return {path, run, std::make_shared<const Metrics>(collector.metrics())};
    }

    QTemporaryDir folder_;
    KeptRun thick_, thin_, open_, hot_, cut_short_;
    Design three_;
};

QTEST_MAIN(TestCompareView)
#include "tst_compare_view.moc"
