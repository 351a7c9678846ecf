// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A garment in the Compare workspace: cut from each fabric of the project and worn, with what samples have there.
#include "compare_test.h"
#include "core/wear/wear_outcomes.h"
#include "ui/basics/core_words.h"
#include "ui/compare/curves_view.h"
#include "ui/compare/garment_maps.h"
#include "ui/compare/study_report.h"
#include "ui/garment/garment_edits.h"
#include "ui/garment/garment_pane.h"
#include "ui/window/examples.h"

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

class TestCompareGarments : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        qputenv("XDG_DATA_HOME", folder_.path().toUtf8()); // unsaved work
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
        Document document;
        QVERIFY(document.openExample(QDir(examplesFolder()).filePath("three-candidates.hygro")));
        addBuiltInGarment(document, "singlet");
        document.edit("a child's, for a minute", {}, [](Design& design) {
            design.fabrics.resize(2);
            design.garments[0].built_in.chest_mm = 600;
            design.garments[0].built_in.length_mm = 350;
            design.wears[0].duration_s = 60;
            design.wears[0].activity = {{0, 10}};
        });
        design_ = *document.design();
        QVERIFY(document.saveAs(file()));
    }

    void aGarmentIsRunOnEachFabric()
    {
        Workplace place;
        open(place);
        CompareView& view = place.view;
        QCOMPARE(view.table()->grid().rows.size(), std::size_t{2});
        QCOMPARE(view.comparison().criteria.size(), compared_by_wear().size());
        QCOMPARE(view.table()->cellText(0, 0), QString("not run"));
        QTRY_VERIFY(view.bar()->runAll()->isEnabled());
        const auto* state = labelled(*view.bar(), "Missing runs");
        QTRY_VERIFY2(state->accessibleDescription().startsWith("2 runs, "), qPrintable(state->accessibleDescription())); // with their time
        runAll(place);
        QCOMPARE(place.history.runs().size(), std::size_t{2});
        for (const KeptRun& run : place.history.runs()) { QVERIFY(run.worn && run.own && run.current && run.numbers); }
        QVERIFY(view.comparison().of_garments && view.comparison().complete);
        for (const Candidate& candidate : view.comparison().candidates) {
            QVERIFY(candidate.intervals.at("most_water_g").centre > 0);
            QVERIFY(find_fabric(design_, candidate.fabric));
        }
        // One run of each shows no scatter: there is no verdict.
        QVERIFY(!verdict_of(view.comparison(), view.comparison().candidates[1].fabric, "most_water_g"));
        // The part that is chosen has columns of its own.
        auto* parts = boxNamed(*view.bar(), "Part of the garment");
        QVERIFY(parts->isVisible() && parts->count() > 3);
        const double whole = view.comparison().candidates[0].intervals.at("most_water_g").centre;
        choose(parts, coreWord("panel front"));
        QCOMPARE(view.comparison().criteria.front().key, std::string("panels/front/largest_wet_area_m2"));
        const double front = view.comparison().candidates[0].intervals.at("panels/front/most_water_g").centre;
        QVERIFY(front > 0 && front < whole);
        choose(boxNamed(*view.bar(), "Experiment"), "All experiments");
        QVERIFY(!parts->isVisible());
        QCOMPARE(view.table()->grid().rows.size(), std::size_t{2});
    }

    void itsRunsAreFoundAgainAndShown()
    {
        Workplace place;
        open(place);
        CompareView& view = place.view;
        QTRY_COMPARE_WITH_TIMEOUT(view.comparison().candidates.size(), std::size_t{2}, 20000); // of the test before
        QCOMPARE(view.chosen().size(), 2);
        GarmentMaps& maps = view.garmentMaps();
        const auto* tabs = static_cast<QTabWidget*>(maps.parentWidget()->parentWidget());
        QStringList seen;
        for (int i = 0; i < tabs->count(); ++i) {
            if (tabs->isTabVisible(i)) { seen << tabs->tabText(i); }
        }
        QCOMPARE(seen, (QStringList{"Maps", "Curves", "Fingerprint", "Scatter", "Why"}));
        QCOMPARE(maps.panes().size(), std::size_t{2});
        QTRY_VERIFY(maps.panes()[0]->drawing() && maps.panes()[1]->drawing());
        QCOMPARE(maps.panes()[0]->drawing()->panels.size(), std::size_t{2});
        QSignalSpy drawn(&maps, &GarmentMaps::mapsChanged);
        maps.show(GarmentMaps::Shown::water_difference);
        QTRY_VERIFY(!drawn.isEmpty());
        const QString base = QString::fromStdString(view.comparison().baseline);
        for (const GarmentPane* pane : maps.panes()) { QCOMPARE(pane->isHidden(), pane->accessibleName().endsWith(base)); }
        QCOMPARE(view.curves().lines(), 2);
        QCOMPARE(view.curves().bands(), 0);
        // An edit makes them outdated, and says of what.
        place.document.edit("finer", {}, [](Design& design) { design.fabrics[0].ends_per_cm *= 0.9; });
        QTRY_COMPARE(view.table()->cellText(rowOf(view, design_.fabrics[0].name), 0), QString("outdated"));
        QCOMPARE(differencesOf(*place.history.runs().front().run, *place.document.design()), QStringList{"fabric"});
        // Cutting the project's garment otherwise is no matter: it is cut from each fabric here.
        place.document.history()->undo();
        editGarment(place.document, "other cloth", 0, {}, [&](Garment& garment) { cut_all_from(garment, design_.fabrics[1].name); });
        QTRY_COMPARE(view.comparison().candidates.size(), std::size_t{2});
    }

    void replicatesAreKeptAndJudged()
    {
        {
            Workplace place;
            open(place);
            place.view.bar()->setReplicates(4);
            runAll(place);
            check(place);
        }
        Workplace again; // from the file
        open(again);
        again.view.bar()->setReplicates(4);
        QTRY_VERIFY_WITH_TIMEOUT(again.view.comparison().complete, 20000);
        check(again);
        std::map<std::string, QString> recordings;
        for (const KeptRun& run : again.history.runs()) { recordings[run.cloth()] = run.path; }
        const QString page = QString::fromStdString(html_of(studyReport(again.view.comparison(), recordings)));
        QVERIFY(page.contains("replicates of each garment") && page.count("<img") >= 4); // both panels of both
    }

    void aGarmentThatIsMissingIsSaid()
    {
        Workplace place;
        open(place);
        place.view.bar()->setReplicates(4); // of the test before
        QTRY_VERIFY_WITH_TIMEOUT(place.view.comparison().complete, 20000);
        place.document.edit("gone", {}, [](Design& design) { design.garments.clear(); });
        const auto* state = labelled(*place.view.bar(), "Missing runs");
        QTRY_VERIFY2(state->accessibleDescription().startsWith("Cannot run: "), qPrintable(state->accessibleDescription()));
        QVERIFY(!place.view.bar()->runAll()->isEnabled());
        place.document.history()->undo();
        QTRY_VERIFY(place.view.comparison().complete);
    }

private:
    QString file() const { return folder_.filePath("singlet.hygro"); }

    void open(Workplace& place) const
    {
        QVERIFY(place.document.open(file()));
        place.view.resize(1100, 800);
        place.view.show();
        place.project.setCompared(true);
        place.view.bar()->setFidelity(Fidelity::live);
        Q_EMIT place.view.bar()->fidelityChosen();
        place.view.showExperiment(design_.wears[0].name);
        QTRY_VERIFY(!place.history.listing());
    }

    static void runAll(Workplace& place)
    {
        QTRY_VERIFY(place.view.bar()->runAll()->isEnabled());
        QSignalSpy failed(&place.view, &CompareView::failed);
        place.view.bar()->runAll()->click();
        QTRY_VERIFY_WITH_TIMEOUT(!place.runs.running() && place.view.comparison().complete, 200000);
        QVERIFY(failed.isEmpty());
    }

    static void check(Workplace& place)
    {
        const Comparison& comparison = place.view.comparison();
        for (const Candidate& candidate : comparison.candidates) {
            QCOMPARE(runs_of(candidate), 4);
            QVERIFY(!candidate.unknowns.empty());
            const Interval& water = candidate.intervals.at("most_water_g");
            QVERIFY(water.low < water.centre && water.centre < water.high);
        }
        QVERIFY(verdict_of(comparison, comparison.candidates[1].fabric, "most_water_g") ||
                verdict_of(comparison, comparison.candidates[0].fabric, "most_water_g"));
        QCOMPARE(place.view.curves().lines(), 2);
        QCOMPARE(place.view.curves().bands(), 2);
    }

    static const QLabel* labelled(const QWidget& widget, const QString& name)
    {
        for (const QLabel* label : widget.findChildren<QLabel*>()) {
            if (label->accessibleName() == name) { return label; }
        }
        return nullptr;
    }

    static QComboBox* boxNamed(const QWidget& widget, const QString& name)
    {
        for (QComboBox* box : widget.findChildren<QComboBox*>()) {
            if (box->accessibleName() == name) { return box; }
        }
        return nullptr;
    }

    static void choose(QComboBox* box, const QString& text)
    {
        QVERIFY2(box->findText(text) >= 0, qPrintable(text));
        box->setCurrentIndex(box->findText(text));
        Q_EMIT box->activated(box->currentIndex());
    }

    QTemporaryDir folder_;
    Design design_;
};

QTEST_MAIN(TestCompareGarments)
#include "tst_compare_garments.moc"
