// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A study of a garment on the page of studies: its factors, its numbers, its cost, its rows.
#include "tests/support/drop_design.h"
#include "tests/support/worn_tee.h"
#include "ui/document/document.h"
#include "ui/study/field_picker.h"
#include "ui/study/study_page.h"
#include "ui/study/study_setup.h"
#include "ui/study/study_table.h"

#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace {

/// A child's tee, worn for a minute, beside the drop on its fabric.
Design wornDesign()
{
    Design design = drop_design(35, 0.05);
    Garment& tee = add_worn_tee(design, design.fabrics[0].name, 60);
    tee.built_in.chest_mm = 600;
    tee.built_in.length_mm = 350;
    design.wears[0].activity = {{0, 10}};
    return design;
}

constexpr const char* skin = "garments[0].wearer.skin_temperature_c";

/// A page with that project, and a study of two points on the garment.
struct WornBench {
    WornBench() : page(document, queue)
    {
        document.take(wornDesign(), "tee");
        QObject::connect(&page, &StudyPage::failed, [this](const QString& sentence) { sentences << sentence; });
        page.resize(1280, 700);
        page.show();
        page.setFolder(folder.filePath("out"));
        StudySetup& setup = page.setup();
        setup.tick("wear", true);
        setup.tick(QString::fromStdString(document.design()->experiments[0].name), false);
        setup.addFactors({fieldAt(*document.design(), skin)});
        for (const auto& [field, text] : {std::pair("low", "32"), std::pair("high", "36")}) {
            QLineEdit* edit = setup.form().field(field);
            edit->clear();
            QTest::keyClicks(edit, text);
            QTest::keyClick(edit, Qt::Key_Return);
        }
        setup.setPoints(Sampling::latin_hypercube, 2);
        setup.setFidelity(Fidelity::live);
    }
    void tickFabric(bool on) { page.setup().tick(QString::fromStdString(document.design()->fabrics[0].name), on); }
    void run()
    {
        QSignalSpy shown(&page, &StudyPage::shown);
        page.run();
        QTRY_VERIFY_WITH_TIMEOUT(!page.job().running() && !shown.isEmpty() && page.results() && page.results()->table.rows() == 2, 60000);
    }

    QTemporaryDir folder;
    Document document;
    WindowQueue queue;
    StudyPage page;
    QStringList sentences;
};

QStringList texts(const QListWidget& list)
{
    QStringList all;
    for (int i = 0; i < list.count(); ++i) { all << list.item(i)->text(); }
    return all;
}

} // namespace

class TestStudyPageGarments : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings_.path());
    }

    void whatIsOfferedIsWhatAStudyOfAGarmentMayChange()
    {
        const Design design = wornDesign();
        Study study;
        study.experiments = {"wear"};
        study.points = 4;
        QStringList groups;
        int offered = 0;
        for (const StudyField& field : studyFields(design)) {
            if (!groups.contains(field.group)) { groups << field.group; }
            if (!field.value || out_of_reach(study, design, field.path)) { continue; }
            ++offered;
            study.factors = {proposedFactor(field.path, field.value)};
            study.factors[0].distribution.low = *field.value;
            study.factors[0].distribution.high = std::nextafter(*field.value, 1e9);
            for (const Issue& issue : validate(study, design)) {
                QVERIFY2(!QString::fromStdString(issue.where.text()).endsWith("path"), (field.path + ": " + issue.text()).c_str());
            }
        }
        QVERIFY(offered > 20);
        QVERIFY(groups.contains("wear") && groups.contains("tee"));
        const auto title = [&](const char* path) { return fieldTitle(fieldAt(design, path), true); };
        QCOMPARE(title("garments[0].source.chest_mm"), QString("tee: source, chest (mm)"));
        QCOMPARE(title("experiments[1].duration_s"), QString("wear: duration (s)"));
        QCOMPARE(metricTitle("most_water_g"), QString("most water (g)"));
        QCOMPARE(metricTitle("panels/left sleeve/most_water_g"), QString("most water, panel left sleeve (g)"));
        QCOMPARE(metricTitle("zones/chest/temperature_c"), QString::fromUtf8("temperature, zone chest (°C)"));
    }

    void aStudyOfAGarmentIsSetUpAndRun()
    {
        WornBench bench;
        StudySetup& setup = bench.page.setup();
        const QList<QListWidget*> lists = setup.findChildren<QListWidget*>();
        const auto is_metrics = [](const QListWidget* list) { return list->accessibleName() == "Metrics of the study"; };
        const QStringList metrics = texts(**std::find_if(lists.begin(), lists.end(), is_metrics));
        QVERIFY(metrics.contains("largest wet area (m²)"));
        QVERIFY2(metrics.contains("most water, panel front (g)"), qPrintable(metrics.join("; ")));
        QVERIFY(!metrics.join(' ').contains("wetted radius"));
        setup.tickMetric("panels/front/most_water_g", true);
        bench.tickFabric(false); // the garment stays as it is cut
        QVERIFY2(setup.problems().isEmpty(), qPrintable(setup.problems().join("; ")));
        QCOMPARE(setup.study().fabrics.size(), std::size_t{0});
        QTRY_VERIFY2(bench.page.cost().startsWith("2 runs (2 points), "), qPrintable(bench.page.cost()));
        QVERIFY2(bench.page.cost().contains("at a time with"), qPrintable(bench.page.cost())); // time and memory are known
        bench.run();
        QVERIFY2(bench.sentences.isEmpty(), qPrintable(bench.sentences.join("; ")));
        QCOMPARE(bench.page.results()->failed, std::size_t{0});
        QStringList heads;
        const StudyTableModel& table = bench.page.table();
        for (int i = 0; i < table.columnCount(); ++i) { heads << table.headerData(i, Qt::Horizontal, Qt::DisplayRole).toString(); }
        QVERIFY2(heads.contains("wearer, skin temperature (°C)"), qPrintable(heads.join("; ")));
        const auto front = static_cast<int>(heads.indexOf("most water, panel front (g)"));
        QVERIFY(front >= 0 && table.index(0, front).data().toString().toDouble() > 0);
        bench.page.choose(0);
        bench.page.makeCandidate(); // no one fabric made the row
        QCOMPARE(bench.sentences.size(), 1);
        QVERIFY2(bench.sentences[0].contains("as it is cut"), qPrintable(bench.sentences[0]));
    }

    void aRowOfAFabricBecomesACandidate()
    {
        WornBench bench;
        bench.tickFabric(true);
        bench.run();
        bench.page.choose(1);
        bench.page.makeCandidate();
        QVERIFY2(bench.sentences.isEmpty(), qPrintable(bench.sentences.join("; ")));
        QCOMPARE(bench.document.design()->fabrics.size(), std::size_t{2});
    }

private:
    QTemporaryDir settings_;
};

QTEST_MAIN(TestStudyPageGarments)
#include "tst_study_page_garments.moc"
