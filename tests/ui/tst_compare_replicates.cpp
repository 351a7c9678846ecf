// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Replicates that are really run: what is kept of them, and what the curves, maps and report make of it.
#include "compare_test.h"
#include "core/project/project_file.h"
#include "ui/compare/compare_maps.h"
#include "ui/compare/curves_view.h"
#include "ui/compare/map_reader.h"
#include "ui/compare/study_report.h"
#include "ui/document/run_folder.h"

#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

class TestCompareReplicates : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        qputenv("XDG_DATA_HOME", folder_.path().toUtf8()); // unsaved work
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
        design_ = read_project(std::string(HYGROLOOM_SOURCE_DIR) + "/resources/examples/three-candidates.hygro");
        design_.experiments.resize(1);
        design_.fabrics.resize(2);
        design_.experiments[0].duration_s = 0.2;
        design_.experiments[0].sample_mm = {5, 5};
        design_.experiments[0].droplets = {Droplet{0.8, 0, {0, 0}, 0.05, 0}};
        design_.fabrics[1] = design_.fabrics[0];
        design_.fabrics[1].name = "water-repellent";
        design_.fabrics[1].contact_angle_deg = 85;
        design_.fabrics[0].uncertainty = design_.fabrics[1].uncertainty = {2, 0, 0.01};
    }

    void replicatesAreKeptWithCurvesAndMapsAndShown()
    {
        const QString path = folder_.filePath("cloth.hygro");
        write_project(design_, path.toStdString());
        {
            Workplace place;
            QVERIFY(place.document.open(path));
            runAll(place);
            for (const ReplicateSet& set : place.runs.store().sets()) {
                QCOMPARE(set.runs.size(), std::size_t{replicates - 1}); // the first is the project's own run
                for (const auto& [number, run] : set.runs) { QVERIFY(run.trace && run.trace->maps.size() == std::size(traced_shares)); }
            }
            check(place);
        }
        QVERIFY(QFileInfo(replicatesIn(runFolderOf(path))).size() < 2 * replicates * 30000);
        Workplace again; // from the file
        QVERIFY(again.document.open(path));
        again.view.resize(1000, 800);
        again.view.show();
        again.project.setCompared(true);
        again.view.bar()->setReplicates(replicates);
        QTRY_VERIFY_WITH_TIMEOUT(again.view.comparison().candidates.size() == 2, 20000);
        check(again);
    }

private:
    static constexpr int replicates = 4;

    static void runAll(Workplace& place)
    {
        CompareView& view = place.view;
        view.resize(1000, 800);
        view.show();
        view.bar()->setReplicates(replicates);
        QTRY_VERIFY(view.bar()->runAll()->isEnabled());
        view.bar()->runAll()->click();
        QTRY_VERIFY_WITH_TIMEOUT(!place.runs.running() && view.comparison().complete, 200000);
    }

    static bool says(const CompareView& view, const QString& text)
    {
        const auto labels = view.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&text](const QLabel* label) { return !label->isHidden() && label->text().contains(text); });
    }

    /// The maps of the first replicate, the project's own run, are in its recording alone.
    static Candidate withMaps(const Workplace& place, const Candidate& candidate)
    {
        const auto& runs = place.history.runs();
        const auto own =
            std::find_if(runs.begin(), runs.end(), [&candidate](const KeptRun& run) { return run.run->fabric == candidate.fabric; });
        return readMaps({{*own}, {candidate}}, [] { return false; }).candidates.front();
    }

    static void check(Workplace& place)
    {
        CompareView& view = place.view;
        auto* curves = view.findChild<CurvesView*>();
        QTRY_COMPARE(curves->bandNames(), QStringList(2, "least to most of 4 replicates"));
        auto* maps = view.findChild<CompareMaps*>();
        QTRY_VERIFY_WITH_TIMEOUT(says(view, "Under the pointer also the range of its replicates"), 20000);
        QVERIFY(says(view, "% as is typical"));
        QVERIFY(!says(view, "rest on the numerical error alone"));
        maps->show(CompareMaps::Shown::differences);
        QTRY_VERIFY_WITH_TIMEOUT(says(view, "Mean of at least 4 pairs of replicates after 0.2") && says(view, "holds 0."), 20000);
        maps->setTime(0.3); // the nearest time with maps is a quarter
        QTRY_VERIFY_WITH_TIMEOUT(says(view, "Mean of at least 4 pairs of replicates after 0.05"), 20000);
        const auto shown = std::find_if(maps->maps().begin(), maps->maps().end(), [](const WaterMap* map) { return !map->isHidden(); });
        const auto baseline = std::find_if(view.comparison().candidates.begin(), view.comparison().candidates.end(),
                                           [&view](const Candidate& each) { return each.fabric == view.comparison().baseline; });
        const auto& other =
            baseline == view.comparison().candidates.begin() ? view.comparison().candidates.back() : view.comparison().candidates.front();
        const auto paired = paired_map(withMaps(place, other), withMaps(place, *baseline), MapSide::top, 1, 0);
        QVERIFY(paired && paired->pairs == replicates);
        QCOMPARE((*shown)->map().water, paired->cells.water); // of the replicates, not of the cloths as given
        std::map<std::string, QString> recordings;
        for (const KeptRun& run : place.history.runs()) { recordings[run.run->fabric] = run.path; }
        const QString report = QString::fromStdString(html_of(studyReport(view.comparison(), recordings)));
        QVERIFY(report.contains("Band: least to most of 4 replicates.") && report.contains("as given, top"));
        maps->show(CompareMaps::Shown::maps);
        maps->setTime(1);
    }

    QTemporaryDir folder_;
    Design design_;
};

QTEST_MAIN(TestCompareReplicates)
#include "tst_compare_replicates.moc"
