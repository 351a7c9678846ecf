// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A number that has one name has one value, wherever it stands: results, maps, Compare's table, the saved table. Needs a display.
#include "core/analysis/outcomes.h"
#include "project_runs_test.h"
#include "ui/basics/preferences.h"
#include "ui/basics/quantity.h"
#include "ui/compare/candidate_table.h"
#include "ui/compare/number_delegate.h"
#include "ui/results/results_panel.h"
#include "ui/results/water_map_view.h"

#include <QTextStream>

using namespace hygroloom;

class TestSameNumbers : public ProjectRunsTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        useOwnSettings();
        setPreferences(quickPreferences());
        openProject();
        run();
        QTRY_VERIFY_WITH_TIMEOUT(playback().metrics(), 20000);
        for (const Outcome& outcome : outcomes_of(*playback().run(), *playback().metrics())) {
            if (outcome.key == "maximum_wetted_radius_top_mm") { radius_ = *outcome.value; }
            if (outcome.key == "equal_area_radius_mm") { stain_ = *outcome.value; }
        }
        QVERIFY(radius_ > 0.1 && stain_ > 0.1 && stain_ < radius_);
    }

    void cleanupTestCase() { closeProject(); }

    void theResultsHaveTheExactRadius()
    {
        QVERIFY2(results().text().contains("Largest wetted radius\t" + valueText(radius_, "mm")), qPrintable(results().text()));
        QVERIFY(!results().text().contains("rings")); // no tester read this run
    }

    /// A drop that only spreads is largest at the end; the map says that it is of the time shown.
    void theMapHasItAtTheEnd()
    {
        window_->setWorkspace(Workspace::simulate);
        const double now = mm_of(wetted_circle(playback().run()->textile, *playback().frame(), Face::top).radius);
        QTRY_VERIFY_WITH_TIMEOUT(waterMaps().top().accessibleDescription().contains("wetted radius now " + valueText(now, "mm")), 10000);
        QVERIFY2(now <= radius_ * (1 + 1e-9), qPrintable(QString::number(now)));
        QCOMPARE(valueText(now, "mm"), valueText(radius_, "mm"));
    }

    void compareHasTheSameNumber()
    {
        window_->setWorkspace(Workspace::compare);
        CandidateTable* table = compareView().table();
        QTRY_VERIFY_WITH_TIMEOUT(number(*table) > 0, 20000);
        QCOMPARE(table->horizontalHeaderItem(CandidateTable::first_number)->text(), QString("Stain radius by area, top (mm)"));
        QVERIFY2(std::abs(number(*table) - stain_) < 0.01 * stain_, qPrintable(cell(*table)->text()));
        QVERIFY2(cell(*table)->toolTip().contains(valueText(stain_, "mm", true).toHtmlEscaped()), qPrintable(cell(*table)->toolTip()));
    }

    void theSavedTableHasTheSameNumber()
    {
        window_->setWorkspace(Workspace::compare);
        QTRY_VERIFY_WITH_TIMEOUT(number(*compareView().table()) > 0, 20000);
        QStringList lines = QString::fromStdString(compareView().tableCsv()).split("\n");
        lines.removeIf([](const QString& line) { return line.startsWith("#"); });
        for (const auto& [key, value] : {std::pair("equal_area_radius_mm", stain_), std::pair("maximum_wetted_radius_top_mm", radius_)}) {
            const qsizetype column = lines[0].split(',').indexOf(key);
            QVERIFY2(column >= 0, qPrintable(lines[0]));
            const double saved = lines[1].split(',')[column].toDouble();
            QVERIFY2(std::abs(saved - value) < 1e-4 * value, qPrintable(lines[1]));
        }
    }

    /// What a tester's rings give has a name that says so, also where fabrics are ranked by it.
    void whatIsOfRingsSaysSo()
    {
        for (const OutcomeInfo& info : reported_by(ExperimentType::moisture_management)) {
            const bool of_rings = info.in_rings || info.key.starts_with("spreading_speed");
            QCOMPARE(QString::fromStdString(info.title).contains("5 mm rings"), of_rings);
        }
    }

private:
    static double mm_of(double metres) { return std::max(0.0, 1000 * metres); }
    static QTableWidgetItem* cell(const CandidateTable& table)
    {
        return table.rowCount() > 0 && table.columnCount() > CandidateTable::first_number ? table.item(0, CandidateTable::first_number)
                                                                                          : nullptr;
    }
    static double number(const CandidateTable& table)
    {
        const QTableWidgetItem* found = cell(table);
        return found ? found->text().section(QRegularExpression("[\\s\\x{a0}]"), 0, 0).toDouble() : 0;
    }

    double radius_ = 0, stain_ = 0; ///< mm: of the smallest circle, by area
};

QTEST_MAIN(TestSameNumbers)
#include "tst_same_numbers.moc"
