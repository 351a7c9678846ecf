// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Numbers and maps from made-up frames whose answers are known.
#include "core/analysis/cell_map.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/run/plan_run.h"
#include "core/scene/scene.h"
#include "tests/support/drop_design.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <functional>
#include <numeric>

using namespace hygroloom;

namespace {

Frame dry_frame(const Textile& t)
{
    Frame f;
    const auto n = static_cast<std::size_t>(t.segments());
    for (auto* v : {&f.saturation, &f.liquid, &f.regain, &f.vapour}) v->assign(n, 0.0f);
    f.temperature.assign(n, 298.15f);
    return f;
}

/// Every segment within a radius of a point is wet.
Frame stained_frame(const Textile& t, double x, double y, double radius)
{
    Frame f = dry_frame(t);
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (int end = 0; end < t.ends(); ++end)
            for (int pick = 0; pick < t.picks(); ++pick)
                if (std::hypot(t.x_of_end(end) - x, t.y_of_pick(pick) - y) <= radius) {
                    f.saturation[static_cast<std::size_t>(t.segment(kind, end, pick))] = 0.5f;
                    f.liquid[static_cast<std::size_t>(t.segment(kind, end, pick))] = 1e-9f;
                }
    return f;
}

Textile cloth(int ends, int picks)
{
    const Design design = drop_design();
    return build_textile(design, design.fabrics[0], {0, 0, ends, picks});
}

/// A strip of three yarns and 35 crossings, 35 per cm, that hangs in the liquid by 1 mm, and what is read of it when its yarns are filled
/// so.
struct HangingStrip {
    RunRecord run;
    bool along_weft;

    explicit HangingStrip(bool weft) : along_weft(weft)
    {
        run.design = drop_design();
        Experiment& strip = run.design.experiments[0];
        strip.type = ExperimentType::vertical_wicking;
        strip.along_weft = weft;
        strip.immersion_mm = 1;
        run.experiment = strip.name;
        run.textile = weft ? cloth(35, 3) : cloth(3, 35);
    }
    /// In crossings above the liquid.
    double height(const std::function<double(int yarn, int crossing)>& saturation) const
    {
        const Textile& t = run.textile;
        Frame f = dry_frame(t);
        for (int yarn = 0; yarn < 3; ++yarn)
            for (int at = 0; at < 35; ++at)
                f.saturation[static_cast<std::size_t>(along_weft ? t.segment(YarnKind::weft, at, yarn)
                                                                 : t.segment(YarnKind::warp, yarn, at))] =
                    static_cast<float>(saturation(yarn, at));
        MetricsCollector collector;
        collector.start(run);
        collector.add(f);
        return collector.metrics().series.wick_height.back() / t.weft.pitch;
    }
};

} // namespace

class TestMetrics : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void circleHoldsEveryPointAndNoSmallerOneDoes()
    {
        for (std::uint64_t trial = 0; trial < 50; ++trial) {
            std::vector<std::array<double, 2>> points;
            const std::uint64_t n = 1 + trial % 9;
            for (std::uint64_t i = 0; i < n; ++i) points.push_back({random_uniform(trial, 0, i), random_uniform(trial, 1, i)});
            const Circle circle = smallest_enclosing_circle(points);
            for (const auto& p : points) QVERIFY(std::hypot(p[0] - circle.x, p[1] - circle.y) <= circle.radius + 1e-12);
            // The smallest circle is spanned by two or by three of the points: try them all.
            double best = n == 1 ? 0.0 : 1e9;
            const auto holds = [&](double x, double y, double r) {
                return std::all_of(points.begin(), points.end(), [&](const auto& p) { return std::hypot(p[0] - x, p[1] - y) <= r + 1e-9; });
            };
            for (const auto& a : points)
                for (const auto& b : points) {
                    const double x = 0.5 * (a[0] + b[0]), y = 0.5 * (a[1] + b[1]), r = 0.5 * std::hypot(a[0] - b[0], a[1] - b[1]);
                    if (holds(x, y, r)) best = std::min(best, r);
                    for (const auto& c : points) {
                        const double d = 2 * (a[0] * (b[1] - c[1]) + b[0] * (c[1] - a[1]) + c[0] * (a[1] - b[1]));
                        if (std::abs(d) < 1e-12) continue;
                        const double a2 = a[0] * a[0] + a[1] * a[1], b2 = b[0] * b[0] + b[1] * b[1], c2 = c[0] * c[0] + c[1] * c[1];
                        const double ux = (a2 * (b[1] - c[1]) + b2 * (c[1] - a[1]) + c2 * (a[1] - b[1])) / d;
                        const double uy = (a2 * (c[0] - b[0]) + b2 * (a[0] - c[0]) + c2 * (b[0] - a[0])) / d;
                        const double ur = std::hypot(a[0] - ux, a[1] - uy);
                        if (holds(ux, uy, ur)) best = std::min(best, ur);
                    }
                }
            QVERIFY(std::abs(circle.radius - best) < 1e-9);
        }
    }
    void noPointsHaveNoCircleAndPointsOnALineHaveTheirHalf()
    {
        QVERIFY(smallest_enclosing_circle({}).radius < 0);
        QCOMPARE(smallest_enclosing_circle({{1, 2}, {1, 2}, {1, 2}}).radius, 0.0);
        QVERIFY(std::abs(smallest_enclosing_circle({{0, 0}, {1, 1}, {2, 2}, {4, 4}}).radius - std::sqrt(8.0)) < 1e-12);
    }
    void wettedCircleFindsTheStain()
    {
        const Textile t = cloth(60, 60);
        const Circle circle = wetted_circle(t, stained_frame(t, 1e-3, -2e-3, 4e-3), Face::top);
        QVERIFY(std::abs(circle.x - 1e-3) < 3e-4 && std::abs(circle.y + 2e-3) < 3e-4);
        QVERIFY(std::abs(circle.radius - 4e-3) < 3e-4);
        QVERIFY(wetted_circle(t, dry_frame(t), Face::bottom).radius < 0);
    }
    void metricsFollowTheFrames()
    {
        RunRecord run;
        run.textile = cloth(60, 60);
        MetricsCollector collector;
        collector.start(run);
        double radius = 0;
        for (int i = 0; i <= 10; ++i) {
            Frame f = stained_frame(run.textile, 0, 0, 5e-4 * i);
            f.time = i;
            f.ledger.water_delivered = i == 0 ? 0.0 : 1e-5;
            f.ledger.water_free = i > 0 && i < 7 ? 1e-6 : 0.0;
            collector.add(f);
            radius = 5e-4 * i;
        }
        const Metrics m = collector.metrics();
        QVERIFY(std::abs(m.maximum_wetted_radius_top - radius) < 3e-4);
        QCOMPARE(m.absorbency_time.value(), 7.0);
        QCOMPARE(int(m.series.time.size()), 11);
        QVERIFY(std::abs(m.wetted_area_ellipse_warp - radius) < 2e-4); // a filled disc's semi-axis is its radius
        QVERIFY(m.series.radius_top[10] > m.series.radius_top[5]);
    }
    void aStripsHeightIsReadBetweenCrossings_data()
    {
        QTest::addColumn<bool>("weft");
        QTest::newRow("along the warp") << false;
        QTest::newRow("along the weft") << true;
    }
    void aStripsHeightIsReadBetweenCrossings()
    {
        QFETCH(bool, weft);
        const HangingStrip strip(weft);
        constexpr double in_liquid = 3.5; // crossings
        // From the middle of crossing 19, at 0.8, to that of crossing 20: 0.05 is met after 0.75 of 0.8 of the way.
        const auto filled = [](int, int at) { return at < 20 ? 0.8 : 0.0; };
        QVERIFY(std::abs(strip.height(filled) - (19.5 + 0.75 / 0.8 - in_liquid)) < 1e-5);
        const auto at_threshold = [](int, int at) { return at < 20 ? 0.8 : at == 20 ? 0.0500001 : 0.0; }; // a float may lie below 0.05
        QVERIFY(std::abs(strip.height(at_threshold) - (20.5 - in_liquid)) < 1e-5);
        const auto one_further = [](int yarn, int at) { return at < 20 || (yarn == 1 && at < 26) ? 0.8 : 0.0; };
        QVERIFY(std::abs(strip.height(one_further) - (19.5 + 0.75 / 0.8 + 2 - in_liquid)) < 1e-5); // the mean of three yarns
        QVERIFY(std::abs(strip.height([](int, int) { return 0.8; }) - (35 - in_liquid)) < 1e-5);
        QCOMPARE(strip.height([](int, int) { return 0.04; }), 0.0);
        QCOMPARE(strip.height([](int, int at) { return at < 3 ? 0.8 : 0.0; }), 0.0); // 2.5 + 0.9: below the surface
    }
    void aStripInBundlesIsReadBetweenTheirMiddles()
    {
        HangingStrip strip(false);
        strip.run.plan.crossings_per_cell = 4; // of 35: eight cells of 4.375
        const double cell = 35.0 / 8;
        // From the middle of cell 3 to that of cell 4: 0.05 is met after 0.55 of 0.6 - 0.01 of a cell.
        const double height = strip.height([cell](int, int at) { return at + 0.5 < 4 * cell ? 0.6 : at + 0.5 < 5 * cell ? 0.01 : 0.0; });
        QVERIFY2(std::abs(height - (3.5 * cell + cell * 0.55 / 0.59 - 3.5)) < 1e-5, qPrintable(QString::number(height, 'g', 9)));
    }
    void aStripsHeightNeitherJumpsNorFallsAsWaterRises()
    {
        const HangingStrip strip(false);
        const auto wet_to = [&](double front) {
            return strip.height([front](int, int at) { return std::clamp(0.8 * (front - at), 0.0, 0.8); });
        };
        // The line's steepest is where a segment has just got wet: 0.05 / 0.05^2 = 20 crossings per unit of saturation.
        constexpr double step = 0.002, steepest = 20 * 0.8;
        for (double front = 5; front < 36; front += step) {
            const double further = wet_to(front + step) - wet_to(front);
            QVERIFY2(further > -1e-9 && further < steepest * step, qPrintable(QString("%1 at %2").arg(further).arg(front)));
            // Ahead of a front this sharp by 1.5 - 0.05 / s - s / 0.8 of its segment's saturation s, at most 1, at s = 0.2.
            const double ahead = wet_to(front) - std::min(31.5, front - 3.5);
            QVERIFY2(ahead > -1e-5 && ahead < 1 + 1e-5, qPrintable(QString("%1 at %2").arg(ahead).arg(front)));
        }
    }
    void aStainRestsFromItsLastNewlyWetSegmentOn()
    {
        RunRecord run;
        run.textile = cloth(30, 30);
        MetricsCollector collector;
        collector.start(run);
        const auto at = [&](double time, double radius, float between) {
            Frame f = stained_frame(run.textile, 0, 0, radius);
            f.time = time;
            f.between.assign(f.liquid.size(), between);
            collector.add(f);
        };
        at(0, 0, 0);
        at(1, 1e-3, 2e-9f);
        at(3, 2e-3, 2e-9f);
        at(4, 1.5e-3, 2e-9f); // what dries is not newly wet
        at(5, 2e-3, 2e-9f);
        at(12.9, 2e-3, 2e-9f);
        QVERIFY(!collector.metrics().time_of_arrest);
        at(13, 2e-3, 1e-9f);
        QCOMPARE(collector.metrics().time_of_arrest.value(), 3.0);
        QVERIFY(std::abs(collector.metrics().water_between_yarns / (1e-9 * run.textile.segments()) - 1) < 1e-6);
        at(14, 3e-3, 1e-9f);
        QVERIFY(!collector.metrics().time_of_arrest);
        collector.start(run); // anew
        at(0, 1e-3, 0);
        at(10, 1e-3, 0);
        QCOMPARE(collector.metrics().time_of_arrest.value(), 0.0);
    }
    void absorbencyEndsBetweenFramesAsTheLedgerSays()
    {
        RunRecord run;
        run.textile = cloth(10, 10);
        MetricsCollector collector;
        collector.start(run);
        const auto at = [&](double time, double delivered, double free, double free_until) {
            Frame f = dry_frame(run.textile);
            f.time = time;
            f.ledger.water_delivered = delivered;
            f.ledger.water_free = free;
            f.ledger.free_until = free_until;
            collector.add(f);
        };
        at(0, 1e-6, 1e-6, 0);
        at(1, 1e-6, 4e-7, 1);
        at(2, 1e-6, 0, 1.25);
        QCOMPARE(collector.metrics().absorbency_time.value(), 1.25);
        at(3, 2e-6, 1e-6, 3); // a later drop
        QVERIFY(!collector.metrics().absorbency_time);
        at(4, 2e-6, 0, 3.5);
        QCOMPARE(collector.metrics().absorbency_time.value(), 3.5);
        at(5, 3e-6, 0, 4.75); // one that came and was absorbed between two frames
        QCOMPARE(collector.metrics().absorbency_time.value(), 4.75);
        at(6, 5e-6, 1e-6, 6);
        at(7, 5e-6, 1e-7, 6.5); // the rest hangs below
        QCOMPARE(collector.metrics().absorbency_time.value(), 6.5);
        at(8, 6e-6, 0, -1); // as older recordings
        QCOMPARE(collector.metrics().absorbency_time.value(), 8.0);
        for (double time : {9.0, 10.0}) { // it still stands: the ledger's time is a sum of steps, a little less than the frame's
            at(time, 7e-6, 1e-6, time * (1 - 1e-15));
            QVERIFY(!collector.metrics().absorbency_time);
        }
        at(11, 7e-6, 0, 10.5);
        QCOMPARE(collector.metrics().absorbency_time.value(), 10.5);
    }
    void waterLeftOverMeansNoAbsorbencyTime()
    {
        RunRecord run;
        run.textile = cloth(10, 10);
        MetricsCollector collector;
        collector.start(run);
        Frame f = dry_frame(run.textile);
        f.ledger.water_delivered = f.ledger.water_free = 1e-6;
        collector.add(f);
        QVERIFY(!collector.metrics().absorbency_time);
    }
    void waterAtTheEdgeIsReported_data()
    {
        QTest::addColumn<ExperimentType>("type");
        QTest::addColumn<bool>("along_weft");
        QTest::addColumn<double>("x"); // mm, of the stain's middle on a sample of 10 mm
        QTest::addColumn<double>("y");
        QTest::addColumn<QString>("note");
        const QString edge = "Water reached the edge of the sample after 3 s; the radius afterwards is limited by the sample's size.";
        const QString strip = "Water reached the upper end of the strip after 3 s; the height afterwards is limited by the strip's length.";
        using Type = ExperimentType;
        QTest::newRow("a drop's stain inside") << Type::droplet << false << 0.0 << 0.0 << QString();
        QTest::newRow("a drop's stain at the left") << Type::droplet << false << -3.0 << 0.0 << edge;
        QTest::newRow("at the right") << Type::moisture_management << false << 3.0 << 0.0 << edge;
        QTest::newRow("at the bottom") << Type::horizontal_wicking << false << 0.0 << -3.0 << edge;
        QTest::newRow("at the top") << Type::horizontal_wicking << false << 0.0 << 3.0 << edge;
        QTest::newRow("a strip's sides are always wet") << Type::vertical_wicking << false << -3.0 << 0.0 << QString();
        QTest::newRow("a strip's lower end hangs in the liquid") << Type::vertical_wicking << false << 0.0 << -3.0 << QString();
        QTest::newRow("a strip's upper end") << Type::vertical_wicking << false << 0.0 << 3.0 << strip;
        QTest::newRow("of a strip along the weft") << Type::vertical_wicking << true << 3.0 << 0.0 << strip;
        QTest::newRow("sweat comes everywhere") << Type::sweat << false << 3.0 << 0.0 << QString();
        QTest::newRow("a wet sample dries") << Type::drying << false << 3.0 << 0.0 << QString();
    }
    void waterAtTheEdgeIsReported()
    {
        QFETCH(ExperimentType, type);
        QFETCH(bool, along_weft);
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(QString, note);
        RunRecord run;
        run.design = drop_design();
        run.design.experiments[0].type = type;
        run.design.experiments[0].along_weft = along_weft;
        run.experiment = run.design.experiments[0].name;
        run.textile = cloth(35, 35); // 35 per cm
        MetricsCollector collector;
        collector.start(run);
        for (int i = 1; i <= 4; ++i) { // the edge is 2 mm from the stain's middle
            Frame f = stained_frame(run.textile, 1e-3 * x, 1e-3 * y, 0.7e-3 * i);
            f.time = i;
            collector.add(f);
        }
        const std::vector<std::string> notes = collector.metrics().notes;
        QCOMPARE(notes.empty() ? QString() : QString::fromStdString(notes.front()), note);
        QVERIFY(notes.size() <= 1);
    }
    void mapKeepsTheWater_data()
    {
        QTest::addColumn<int>("n");
        for (int n : {1, 2, 3, 7, 100}) QTest::addRow("%d x %d crossings", n, n) << n;
    }
    void mapKeepsTheWater()
    {
        QFETCH(int, n);
        const Textile t = cloth(21, 16);
        const Frame frame = stained_frame(t, 0, 0, 2e-3);
        double sides = 0;
        for (MapSide side : {MapSide::top, MapSide::bottom, MapSide::total}) {
            const CellMap map = cell_map(t, frame, dry_frame(t), side, n);
            QCOMPARE(map.columns, (21 + n - 1) / n);
            double water = 0;
            for (int row = 0; row < map.rows; ++row)
                for (int column = 0; column < map.columns; ++column)
                    water += map.at(column, row) * std::min(n, 21 - column * n) * std::min(n, 16 - row * n) * t.warp.pitch * t.weft.pitch;
            if (side == MapSide::total)
                QVERIFY(std::abs(water - sides) < 1e-15);
            else
                sides += water;
        }
        const auto wet = std::count_if(frame.liquid.begin(), frame.liquid.end(), [](float m) { return m > 0; });
        QVERIFY(std::abs(sides - 1e-9 * static_cast<double>(wet)) < 1e-14);
    }
    void aDryingSampleIsWetOnTheMap()
    {
        RunRecord run;
        run.design = drop_design();
        run.experiment = run.design.experiments[0].name;
        run.textile = cloth(8, 8);
        const Frame wet = stained_frame(run.textile, 0, 0, 1);
        QCOMPARE(cell_map(run.textile, wet, start_of_maps(run, wet), MapSide::total, 1).maximum(), 0.0);
        run.design.experiments[0].type = ExperimentType::drying;
        const CellMap map = cell_map(run.textile, wet, start_of_maps(run, wet), MapSide::total, 1);
        const double area = run.textile.warp.pitch * run.textile.weft.pitch; // of a crossing, with 1e-9 kg in its end and in its pick
        for (double water : map.water) QVERIFY(std::abs(water * area - 2e-9) < 1e-15);
    }
    void aDryingMapStartsWithAllWaterOfTheTest() // whatever the fibres absorbed of it
    {
        RunRecord run;
        run.design = drop_design();
        for (Yarn* yarn : yarns_of(run.design.fabrics[0])) yarn->irregularity_cv = 0; // maps take a yarn's fibres for even
        Experiment& experiment = run.design.experiments[0];
        experiment = standard_experiment(ExperimentType::drying);
        experiment.sample_mm = {5, 5};
        experiment.initial_water_g_m2 = 60;
        run.experiment = experiment.name;
        run.plan = plan_run(run.design, run.design.fabrics[0], experiment, Fidelity::draft);
        run.textile = build_textile(run.design, run.design.fabrics[0], run.plan.region);
        const Scene scene = build_scene(run.design, run.textile, experiment, run.plan, 1);
        QVERIFY(scene.cloth.start.bound > 0);
        Frame first = dry_frame(run.textile);
        first.liquid.assign(scene.cloth.start.liquid.begin(), scene.cloth.start.liquid.end());
        first.regain.assign(first.liquid.size(), static_cast<float>(scene.cloth.yarns[0].initial_regain)); // warp and weft are alike
        const CellMap map = cell_map(run.textile, first, start_of_maps(run, first), MapSide::total, 1);
        const double mean = std::accumulate(map.water.begin(), map.water.end(), 0.0) / static_cast<double>(map.water.size());
        QVERIFY2(std::abs(mean - 0.06) < 1e-6, qPrintable(QString::number(mean)));
        Frame last = first;
        last.liquid.assign(first.liquid.size(), 0.0f);
        last.regain.assign(first.liquid.size(), static_cast<float>(scene.cloth.yarns[0].resting_regain));
        for (double water : cell_map(run.textile, last, start_of_maps(run, first), MapSide::total, 1).water) QCOMPARE(water, 0.0);
    }
    void mapIsWrittenWithItsProvenance()
    {
        QTemporaryDir folder;
        RunRecord run;
        run.textile = cloth(6, 4);
        run.fabric = "cloth";
        const CellMap map = cell_map(run.textile, stained_frame(run.textile, 0, 0, 1), dry_frame(run.textile), MapSide::top, 2);
        write_cell_map_csv(map, run, 1.5, MapSide::top, folder.filePath("map.csv").toStdString());
        QFile file(folder.filePath("map.csv"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArrayList lines = file.readAll().trimmed().split('\n');
        QVERIFY(lines.contains("# time_s=1.5"));
        QVERIFY(lines.contains("column,row,x_mm,y_mm,water_g_m2"));
        QCOMPARE(int(std::count_if(lines.begin(), lines.end(), [](const QByteArray& l) { return !l.startsWith('#'); })), 1 + 3 * 2);
        QVERIFY_EXCEPTION_THROWN(write_cell_map_csv(map, run, 0, MapSide::top, folder.filePath("no/map.csv").toStdString()), FileError);
    }
};

QTEST_APPLESS_MAIN(TestMetrics)
#include "tst_metrics.moc"
