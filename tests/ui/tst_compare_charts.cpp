// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the maps and charts of the compare workspace draw.
#include "ui/compare/chart_data.h"
#include "ui/compare/curves_view.h"
#include "ui/compare/fingerprint_view.h"
#include "ui/compare/scatter_view.h"
#include "ui/results/curve_legend.h"
#include "ui/results/map_difference.h"
#include "ui/results/pointed_chart_view.h"
#include "ui/results/water_map.h"

#include <QChart>
#include <QLineSeries>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>

using namespace hygroloom;

class TestCompareCharts : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void differencesWithinTheErrorAreGrey()
    {
        const CellMap baseline = map({0, 10, 100, 0}), other = map({0, 10.4, 90, 2});
        const MapDifference found = differenceOf(other, baseline, {0.05, "it"});
        QCOMPARE(found.real, (std::vector<bool>{false, false, true, true}));
        QCOMPARE(found.cells.water[2], -10.0);
        QCOMPARE(found.cells.water[3], 2.0);
        QCOMPARE(largestOf(found), 10.0);
        QCOMPARE(differenceOf(other, baseline, {}).real, (std::vector<bool>{false, true, true, true})); // no error is known
        QVERIFY(!differenceOf(map({0.5, 0, 0, 0}), baseline, {}).real[0]); // both are dry: below 1 % of the wettest cell
        QCOMPARE(largestOf(differenceOf(baseline, baseline, {})), 0.0);
    }

    void greyCellsAreDrawnGreyAndTheOthersBySign()
    {
        WaterMap shown("cloth");
        shown.resize(220, 240);
        shown.setRange(10, WaterColors::blue);
        shown.setDifference(differenceOf(map({0, 10.4, 90, 12}), map({0, 10, 100, 2}), {0.05, "it"}), QSizeF(0.002, 0.002));
        const QImage image = shown.grab().toImage();
        const auto at = [&image](double x, double y) { return image.pixelColor(static_cast<int>(x * 220), static_cast<int>(y * 240)); };
        QCOMPARE(at(0.6, 0.7).rgb(), noDifferenceColor().rgb()); // below: no difference, and 0.4 of 10.4
        QCOMPARE(at(0.3, 0.3).rgb(), differenceColor(-1).rgb()); // above: 10 less, and 10 more
        QCOMPARE(at(0.7, 0.3).rgb(), differenceColor(1).rgb());
        QVERIFY(differenceColor(0).lightness() > differenceColor(0.5).lightness());
        QVERIFY(differenceColor(0) != noDifferenceColor());
    }

    void mapsOfOtherCellsCannotBeCompared()
    {
        const CellMap baseline = map({0, 1, 2, 3});
        QVERIFY(whyNoDifference(baseline, baseline).isEmpty());
        CellMap other = baseline;
        other.cell_width *= 1.01;
        QVERIFY(whyNoDifference(other, baseline).contains("setts"));
        other = baseline;
        other.rows = 1;
        QVERIFY(whyNoDifference(other, baseline).contains("another size"));
    }

    void theErrorOfAMapIsThatOfItsFacesStain()
    {
        RunRecord run, baseline;
        run.plan.expected_errors["maximum_wetted_radius_top_mm"] = 0.02;
        baseline.plan.expected_errors["maximum_wetted_radius_top_mm"] = 0.03;
        run.plan.expected_error = baseline.plan.expected_error = 0.2;
        QCOMPARE(errorOfMaps(run, baseline, MapSide::top).share, std::optional(0.03));
        QCOMPARE(errorOfMaps(run, baseline, MapSide::bottom).share, std::optional(0.2));
        baseline.plan.expected_error.reset();
        QVERIFY(!errorOfMaps(run, baseline, MapSide::bottom).share);
    }

    void theFrontHasWhatNoOtherBeats()
    {
        const std::vector<QPointF> points{{1, 5}, {2, 4}, {3, 3}, {2, 2}, {4, 1}, {1, 1}};
        QCOMPARE(paretoFront(points, Better::more, Better::more), (std::vector<std::size_t>{0, 1, 2, 4}));
        QCOMPARE(paretoFront(points, Better::less, Better::less), (std::vector<std::size_t>{5}));
        QCOMPARE(paretoFront(points, Better::more, Better::less), (std::vector<std::size_t>{4}));
        QCOMPARE(paretoFront({{1, 1}, {1, 1}}, Better::more, Better::more).size(), std::size_t{2}); // alike: neither beats the other
        QVERIFY(paretoFront({}, Better::more, Better::more).empty());
    }

    void theScatterMarksTheFront()
    {
        ScatterView view;
        const Comparison numbers = comparison();
        view.setComparison(numbers);
        int time = -1;
        for (std::size_t i = 0; i < numbers.criteria.size(); ++i) {
            if (numbers.criteria[i].key == "absorbency_time_s") { time = static_cast<int>(i); }
        }
        view.choose(0, time);
        QCOMPARE(view.front(), (QStringList{"quick", "wide"}));
    }

    void namesInTheScatterDoNotLieOverEachOther()
    {
        Comparison numbers = comparison();
        numbers.candidates.push_back(candidate("hardly slower than slow", 4.1, 3.05));
        judge(numbers);
        ScatterView view;
        view.resize(700, 400);
        view.show();
        view.setComparison(numbers);
        for (std::size_t i = 0; i < numbers.criteria.size(); ++i) {
            if (numbers.criteria[i].key == "absorbency_time_s") { view.choose(0, static_cast<int>(i)); }
        }
        QTRY_COMPARE(view.labels().size(), 3);
        QVERIFY(view.labels().contains("wide") && view.labels().contains("quick")); // those of the front
        view.resize(60000, 40000);                                                  // where there is room for all
        QTRY_COMPARE(view.labels().size(), 4);
    }

    void aCurveHasTheBandOfItsNumbersError()
    {
        const auto metrics = std::make_shared<Metrics>();
        metrics->series.time = {0, 1};
        metrics->series.radius_top = {0.002, 0.004};
        metrics->series.radius_bottom = {0, 0};
        metrics->series.free_water = {1e-6, 0};
        const auto choices = curvesOf(ExperimentType::droplet, {metrics});
        QCOMPARE(choices.front().title, QString("Wetted radius, top (mm)"));
        QVERIFY(std::none_of(choices.begin(), choices.end(), [](const CurveChoice& each) { return each.title.contains("bottom"); }));
        RunRecord run;
        run.plan.expected_errors["maximum_wetted_radius_top_mm"] = 0.1;
        CurvePoints points = pointsOf(run, *metrics, choices.front());
        QCOMPARE(points.values, (std::vector<QPointF>{{0, 2}, {1, 4}}));
        QCOMPARE(points.high.size(), std::size_t{2});
        QVERIFY(std::abs(points.high[1] - 4.4) < 1e-12 && std::abs(points.low[1] - 3.6) < 1e-12 && points.replicates == 0);
        points = pointsOf(run, *metrics, choices[1]);
        QVERIFY(points.high.empty() && bandText(choices[1]).isEmpty()); // no error of it is measured
        const KeptRun kept{"path", std::make_shared<RunRecord>(run), metrics};
        CurvesView view;
        view.setRuns({kept, kept}, {"one", "two"});
        QCOMPARE(view.lines(), 2);
        QCOMPARE(view.bands(), 2);
        QCOMPARE(view.bandNames(), (QStringList{"numerical error", "numerical error"}));
    }

    void aCurveHasTheBandOfItsReplicatesAndSaysSo()
    {
        const KeptRun one = runOfRadius(4), other = runOfRadius(2);
        Comparison numbers;
        numbers.replicates = 4;
        numbers.candidates = {replicated("one", {4, 6, 5, 9}), replicated("other", {2})};
        CurvesView view;
        view.resize(900, 500);
        view.show();
        view.setRuns({one, other}, {"one", "other"}, numbers);
        QCOMPARE(view.bands(), 1); // of the other no error is known
        QCOMPARE(view.bandNames(), QStringList{"least to most of 4 replicates"});
        QVERIFY2(view.note().contains("the line is their middle") && view.note().contains("Of other the cloth as given"),
                 qPrintable(view.note()));
        numbers.candidates[0].replicates[2]->trace.reset(); // as an older version left it
        view.setRuns({one, other}, {"one", "other"}, numbers);
        QCOMPARE(view.bandNames(), QStringList{"least to most of 3 replicates"});
        QVERIFY(view.note().contains("Of one some replicates"));
    }

    void theCurveUnderThePointerTellsItsNumber()
    {
        Comparison numbers;
        numbers.candidates = {replicated("one", {4, 6, 5, 9}), replicated("other", {2})};
        CurvesView view;
        view.resize(900, 500);
        view.show();
        view.setRuns({runOfRadius(4), runOfRadius(2)}, {"one", "other"}, numbers);
        PointedChartView* chart = view.view();
        QTRY_VERIFY(chart->chart()->plotArea().width() > 100);
        const auto at = [&](double x, double y) { // in the chart's numbers
            return chart->mapFromScene(
                chart->chart()->mapToScene(chart->chart()->mapToPosition(QPointF(x, y), chart->chart()->series()[1])));
        };
        QTRY_VERIFY2(chart->wordsAt(at(0.5, 2.7)).startsWith("one: 2.7"), qPrintable(chart->wordsAt(at(0.5, 2.7))));
        QSignalSpy pointed(chart, &PointedChartView::pointed);
        const QPoint place = at(0.5, 2.7); // near the middle of 4 replicates, 5.5 mm after 1 s
        QMouseEvent move(QEvent::MouseMove, place, chart->viewport()->mapToGlobal(place), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
        QCoreApplication::sendEvent(chart->viewport(), &move);
        QCOMPARE(pointed.count(), 1);
        const QString words = pointed.back()[0].toString();
        QVERIFY2(words.contains("one: 2.7") && words.contains(" mm at 0.5") && words.contains("(least to most of 4 replicates: 2 to 4.5)"),
                 qPrintable(words));
        QVERIFY(chart->wordsAt(at(0.5, 1)).startsWith("other: 1")); // 1 where a pixel hits it
        QVERIFY(chart->wordsAt(QPointF(2, 2)).isEmpty());           // beside the plot
    }

    void theMarkersOfScatterAndFingerprintTellTheirNumbersWithUnits()
    {
        Comparison numbers = comparison();
        for (Candidate& each : numbers.candidates) { each.replicates.front()->numbers["equal_area_radius_bottom_mm"] = 3; }
        judge(numbers);
        ScatterView scatter;
        scatter.resize(900, 500);
        scatter.show();
        scatter.setComparison(numbers);
        scatter.choose(0, 0);
        const auto wordsOf = [](PointedChartView* view, const QString& begin) {
            for (int y = 0; y < view->height(); y += 4) {
                for (int x = 0; x < view->width(); x += 4) {
                    if (const QString words = view->wordsAt(QPointF(x, y)); words.startsWith(begin)) { return words; }
                }
            }
            return QString();
        };
        QTRY_VERIFY(wordsOf(scatter.view(), "wide").contains("Stain radius by area, top: 9 mm"));
        FingerprintView finger;
        finger.resize(900, 600);
        finger.show();
        finger.setCandidates(numbers, {"wide", "slow"});
        QTRY_VERIFY2(wordsOf(finger.view(), "slow\nStain radius by area, top").endsWith(": 4 mm"),
                     qPrintable(wordsOf(finger.view(), "slow\nStain radius by area, top")));
    }

    void aMapTellsTheRangeOfItsReplicates()
    {
        WaterMap shown("cloth");
        shown.resize(220, 240);
        shown.setMap(map({0.1, 0, 0, 0}), {}, QSizeF(0.002, 0.002));
        const QPointF low_left(40, 200);
        QVERIFY2(shown.wordsAt(low_left).startsWith("cloth: 100 g/m² at"), qPrintable(shown.wordsAt(low_left)));
        shown.setReplicates(MapRange{map({0.05, 0, 0, 0}), map({0.2, 0, 0, 0}), 4});
        const QString words = shown.wordsAt(low_left);
        QVERIFY2(words.startsWith("cloth: 100 g/m² (least to most of 4 replicates, in cells of ") && words.contains(" mm: 50 to 200) at"),
                 qPrintable(words));
    }

    void mapsInARowHaveOneScaleAndBarsOfOneLength()
    {
        WaterMap large("large"), small("small");
        for (WaterMap* each : {&large, &small}) { each->setRow({&large, &small}); }
        large.resize(220, 240);
        small.resize(221, 240); // as a layout shares a row of pixels
        for (WaterMap* each : {&large, &small}) { each->show(); }
        large.setMap(map({0.1, 0, 0, 0}), {}, QSizeF(0.02, 0.02));
        small.setMap(map({0.1, 0, 0, 0}), {}, QSizeF(0.01, 0.01));
        QCOMPARE(small.pixelsPerMetre(), large.pixelsPerMetre());
        QVERIFY(std::abs(large.pixelsPerMetre() * 0.02 - 204) < 1e-9); // the larger fills its room
        QCOMPARE(small.roomOfBar(), large.roomOfBar());
        QVERIFY(std::abs(small.roomOfBar() - 102) < 1e-9);                                               // and the bar fits on the smaller
        QVERIFY(small.wordsAt(QPointF(40, 80)).isEmpty() && !small.wordsAt(QPointF(110, 80)).isEmpty()); // the pointer follows
        large.hide();
        QVERIFY(std::abs(small.pixelsPerMetre() * 0.01 - 205) < 1e-9);
    }

    void linesThatLieOnEachOtherAreAllSeen()
    {
        Comparison numbers = comparison();
        numbers.candidates.push_back(candidate("same", 4, 3)); // as slow
        for (Candidate& each : numbers.candidates) {
            each.replicates[0]->numbers["equal_area_radius_bottom_mm"] = each.replicates[0]->numbers[numbers.criteria[0].key];
        }
        judge(numbers);
        FingerprintView finger;
        finger.resize(900, 600);
        finger.setCandidates(numbers, {"wide", "slow", "same"});
        const auto lines = finger.view()->chart()->series();
        const auto width = [&](int i) { return qobject_cast<QLineSeries*>(lines[i])->pen().widthF(); };
        QCOMPARE(lines.size(), 3);
        QCOMPARE(width(0), width(2));
        QVERIFY(width(1) > width(2)); // the one below
        const QImage legend = finger.findChild<CurveLegend*>()->grab().toImage();
        std::vector<int> rows(3); // of pixels with each line's colour
        for (int y = 0; y < legend.height(); ++y) {
            for (int i = 0; i < 3; ++i) {
                bool seen = false;
                for (int x = 0; x < 40; ++x) {
                    seen = seen || legend.pixelColor(x, y) == qobject_cast<QLineSeries*>(lines[i])->pen().color();
                }
                rows[static_cast<std::size_t>(i)] += seen ? 1 : 0;
            }
        }
        QVERIFY2(rows[1] > rows[0] && rows[1] > rows[2], qPrintable(QString("%1 %2 %3").arg(rows[0]).arg(rows[1]).arg(rows[2])));
        const Fingerprint apart = fingerprintOf(numbers, {"wide", "slow"});
        QCOMPARE(laterOn(apart, 0.03), (std::vector<int>{0, 0}));
    }

    void aFingerprintGoesFromTheWorstToTheBest()
    {
        const Comparison numbers = comparison();
        const Fingerprint found = fingerprintOf(numbers, {"wide", "slow"});
        QVERIFY(!found.grades);
        QCOMPARE(found.spokes.size(), static_cast<qsizetype>(numbers.criteria.size()));
        const auto spoke = [&](const char* key) {
            for (std::size_t i = 0; i < numbers.criteria.size(); ++i) {
                if (numbers.criteria[i].key == key) { return i; }
            }
            return std::size_t{99};
        };
        QCOMPARE(found.runs[0][spoke("equal_area_radius_mm")], 1.0);
        QCOMPARE(found.runs[0][spoke("absorbency_time_s")], 0.5); // a smaller time is better
        QCOMPARE(found.runs[1][spoke("absorbency_time_s")], 0.0);
        QCOMPARE(found.runs[0][spoke("maximum_wetted_radius_bottom_mm")], -1.0); // it has no such number
    }

private:
    /// Two by two cells of a millimetre, the first row below.
    static CellMap map(const std::vector<double>& water)
    {
        CellMap made;
        made.columns = made.rows = 2;
        made.cell_width = made.cell_height = 1e-3;
        made.water = water;
        return made;
    }

    static Candidate candidate(const std::string& name, double radius, double time)
    {
        Candidate made;
        made.fabric = name;
        made.run = std::make_shared<RunRecord>();
        made.metrics = std::make_shared<Metrics>();
        made.replicates = {ReplicateRun{{{"equal_area_radius_mm", radius}, {"absorbency_time_s", time}}, {}}};
        return made;
    }

    /// Its radius grows to that many mm within 1 s.
    static KeptRun runOfRadius(double radius_mm)
    {
        auto metrics = std::make_shared<Metrics>();
        metrics->series.time = {0, 1};
        metrics->series.radius_top = {0, 1e-3 * radius_mm};
        return {QString::number(radius_mm), std::make_shared<RunRecord>(), metrics};
    }

    static Candidate replicated(const std::string& name, const std::vector<double>& radii)
    {
        Candidate made;
        made.fabric = name;
        for (const double radius : radii) {
            made.replicates.emplace_back(ReplicateRun{});
            made.replicates.back()->trace = std::make_shared<const RunTrace>(trace_of(*runOfRadius(radius).metrics, 1));
        }
        return made;
    }

    static Comparison comparison()
    {
        Comparison made;
        made.criteria = compared_by(ExperimentType::droplet);
        made.ranked_by = made.criteria.front();
        made.baseline = "wide";
        made.candidates = {candidate("wide", 9, 2), candidate("quick", 5, 1), candidate("slow", 4, 3)};
        judge(made);
        return made;
    }
};

QTEST_MAIN(TestCompareCharts)
#include "tst_compare_charts.moc"
