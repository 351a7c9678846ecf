// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What replicates keep of their runs, and the ranges that follow.
#include "core/analysis/comparison_report.h"
#include "core/analysis/line_chart.h"
#include "core/analysis/replicate_file.h"
#include "core/analysis/replicate_range.h"
#include "core/base/error.h"
#include "gpu/backends.h"
#include "tests/support/drop_design.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace {

CellMap cells(const std::vector<double>& water)
{
    CellMap map;
    map.columns = 2;
    map.rows = static_cast<int>(water.size()) / 2;
    map.cell_width = map.cell_height = 1e-3;
    map.water = water;
    return map;
}

/// Radii of that many mm, times the share of the time; with one map.
ReplicateRun replicate(double radius_mm, const std::vector<double>& water = {})
{
    Metrics metrics;
    metrics.series.time = {0, 10};
    metrics.series.radius_top = {0, 1e-3 * radius_mm};
    metrics.ledger.water_initial = 2e-6;
    RunTrace trace = trace_of(metrics, 10);
    if (!water.empty()) trace.maps.push_back({1, cells(water), cells({0, 0, 0, 0})});
    ReplicateRun run;
    run.numbers["maximum_wetted_radius_top_mm"] = radius_mm;
    run.trace = std::make_shared<const RunTrace>(std::move(trace));
    return run;
}

Candidate candidate(const std::string& fabric, const std::vector<ReplicateRun>& runs)
{
    Candidate made;
    made.fabric = fabric;
    for (const ReplicateRun& run : runs) made.replicates.emplace_back(run);
    return made;
}

std::vector<ReplicateRun> replicates(int count)
{
    std::vector<ReplicateRun> runs;
    for (int i = 0; i < count; ++i) runs.push_back(replicate(1 + (i * 5) % count)); // 1 to count, in no order
    return runs;
}

std::optional<CurveRange> radius_range(const Candidate& candidate)
{
    const Plot& plot = plot_named(PlotName::radius);
    return curve_range(candidate, plot, plot.curves.front());
}

std::vector<ReplicateSet> one_set(const ReplicateRun& run)
{
    const Design design = drop_design();
    ReplicateSet set;
    set.key = {part_of_run(design, "cloth", design.experiments[0].name), "cloth", design.experiments[0].name, Fidelity::draft, 1, 4};
    set.runs[2] = run;
    return {set};
}

} // namespace

class TestReplicateRange : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void curvesAreKeptAtTimesThatCrowdAtTheStart()
    {
        const std::vector<double> times = trace_times(8);
        QCOMPARE(times.size(), std::size_t{trace_points});
        QVERIFY(times.front() == 0 && times.back() == 8 && times[1] < 0.002 && times[trace_points / 2] == 2);
        const RunTrace trace = *replicate(4).trace;
        for (std::size_t i = 0; i < trace.series.time.size(); ++i)
            QVERIFY(std::abs(trace.series.radius_top[i] - 4e-4 * trace.series.time[i]) < 1e-12);
        QVERIFY(trace.series.wick_height.empty());
        QCOMPARE(values_at({-1, 0.5, 9}, {0, 1, 2}, {4, 6, 7}), (std::vector<double>{4, 5, 7}));
    }
    void theBandOfFewGoesFromTheLeastToTheMost()
    {
        const auto range = radius_range(candidate("a", replicates(4)));
        QVERIFY(range && range->runs == 4);
        QVERIFY(std::abs(range->low.back() - 1) < 1e-9 && std::abs(range->high.back() - 4) < 1e-9);
        QVERIFY(std::abs(range->middle.back() - 2.5) < 1e-9 && range->middle.front() == 0);
        QCOMPARE(range_words(4), std::string("least to most of 4 replicates"));
        QVERIFY(!radius_range(candidate("a", replicates(1))));
    }
    void theBandOfManyGoesFromPercentileToPercentile()
    {
        const auto range = radius_range(candidate("a", replicates(21))); // 1 to 21: a percentile is 0.2
        QVERIFY(std::abs(range->low.back() - 2) < 1e-9 && std::abs(range->high.back() - 20) < 1e-9);
        QVERIFY(std::abs(range->middle.back() - 11) < 1e-9);
        QCOMPARE(range_words(21), std::string("5th to 95th percentile of 21 replicates"));
    }
    void replicatesWithoutCurvesDoNotCount()
    {
        Candidate made = candidate("a", replicates(3));
        made.replicates[1]->trace.reset();
        made.replicates.emplace_back();
        QCOMPARE(radius_range(made)->runs, 2);
        made.replicates[0]->trace.reset();
        QVERIFY(!radius_range(made));
    }
    void aRunsCurvesAndMapsAreReadAsTheyWereWritten()
    {
        const ReplicateRun run = replicate(3.21987, {0, 0.1234, 0, 0.25});
        const auto back = parse_replicates(format_replicates(one_set(run)), "file");
        const RunTrace& read = *back.at(0).runs.at(2).trace;
        for (std::size_t i = 0; i < read.series.time.size(); ++i) {
            QVERIFY(std::abs(read.series.time[i] - run.trace->series.time[i]) < 1e-12);
            QVERIFY(std::abs(read.series.radius_top[i] - run.trace->series.radius_top[i]) <= 6e-4 * run.trace->series.radius_top[i]);
        }
        QVERIFY(read.series.wick_height.empty() && read.series.tester.empty());
        QVERIFY(std::abs(read.water_initial - 2e-6) < 1e-15);
        QCOMPARE(read.maps.size(), std::size_t{1});
        QCOMPARE(read.maps[0].time, 1.0);
        for (std::size_t i = 0; i < 4; ++i) {
            QVERIFY(std::abs(read.maps[0].top.water[i] - run.trace->maps[0].top.water[i]) < 5.1e-5);
            QCOMPARE(read.maps[0].bottom.water[i], 0.0);
        }
        QVERIFY(std::abs(read.maps[0].top.cell_width - 1e-3) < 1e-12);
    }
    void curvesOfAGarmentAreReadAsTheyWereWritten()
    {
        ReplicateSet set = one_set(replicate(3)).front();
        WearExperiment wear;
        wear.name = set.key.experiment;
        wear.garment = "tee";
        Garment tee;
        tee.name = "tee";
        cut_all_from(tee, set.key.fabric);
        set.key.design.experiments.clear();
        set.key.design.wears = {wear};
        set.key.design.garments = {tee};
        Candidate garment;
        for (const double factor : {1.0, 2.0, 3.0}) {
            RunTrace trace;
            trace.series.time = trace_times(8);
            for (const double time : trace.series.time) trace.worn["panels/front/water_g"].push_back(factor * time);
            ReplicateRun run;
            run.trace = std::make_shared<const RunTrace>(std::move(trace));
            garment.replicates.emplace_back(std::move(run));
        }
        set.runs = {{2, *garment.replicates.front()}};
        set.runs[2].places.assign(set.unknowns.size(), 0.5);
        const auto back = parse_replicates(format_replicates({set}), "file");
        QVERIFY(back.at(0).key == set.key);
        const std::vector<double>& read = back.at(0).runs.at(2).trace->worn.at("panels/front/water_g");
        for (std::size_t i = 0; i < read.size(); ++i) QVERIFY(std::abs(read[i] - trace_times(8)[i]) <= 6e-4 * trace_times(8)[i]);
        const auto range = curve_range(garment, "panels/front/water_g");
        QVERIFY(range && range->runs == 3 && range->low.back() == 8 && range->middle.back() == 16 && range->high.back() == 24);
        QVERIFY(!curve_range(garment, "panels/back/water_g"));
        set.key.design.garments.clear();
        QVERIFY_EXCEPTION_THROWN(parse_replicates(format_replicates({set}), "file"), FileError);
    }
    void filesOfAnOlderProgramStayReadable()
    {
        ReplicateRun run = replicate(3);
        run.trace.reset();
        const std::string text = format_replicates(one_set(run));
        QVERIFY(text.find("trace") == std::string::npos);
        const auto back = parse_replicates(text, "file");
        QCOMPARE(back.at(0).runs.at(2).numbers, run.numbers);
        QVERIFY(!back.at(0).runs.at(2).trace);
    }
    void aDamagedTraceIsRefusedInASentence_data()
    {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("said");
        QTest::newRow("a curve too short") << "\"wetted_radius_top_mm\": [0.0, "
                                           << "\"wetted_radius_top_mm\": ["
                                           << "given are 80";
        QTest::newRow("an unknown curve") << "wetted_radius_top_mm\": ["
                                          << "wetted_radius_top\": ["
                                          << "wetted_radius_top";
        QTest::newRow("cells too few") << "[1234, 0, 2500]"
                                       << "[1234, 0]"
                                       << "3 cells";
        QTest::newRow("cells beyond the map") << "\"from\": [0, 0]"
                                              << "\"from\": [2, 0]"
                                              << "beyond the map";
        QTest::newRow("too many columns") << "\"columns\": 2"
                                          << "\"columns\": 4800"
                                          << "1 to 48";
        QTest::newRow("half a column") << "\"size\": [1, 3]"
                                       << "\"size\": [0.5, 3]"
                                       << "whole numbers";
        QTest::newRow("a cell without width") << "\"cell_mm\": [1.0"
                                              << "\"cell_mm\": [0.0"
                                              << "more than 0";
        QTest::newRow("a time before the start") << "\"duration_s\": 10"
                                                 << "\"duration_s\": -10"
                                                 << "0 to";
        QTest::newRow("water beyond all") << "[1234,"
                                          << "[12340000000,"
                                          << "allowed is";
    }
    void aDamagedTraceIsRefusedInASentence()
    {
        QFETCH(const QString, from);
        QFETCH(const QString, to);
        QFETCH(const QString, said);
        QString text = QString::fromStdString(format_replicates(one_set(replicate(3, {0.1234, 0, 0, 0, 0.25, 0}))));
        QVERIFY2(text.contains(from), qPrintable(text.left(8000)));
        text.replace(text.indexOf(from), from.size(), to);
        try {
            parse_replicates(text.toStdString(), "file");
            QFAIL("It was taken.");
        } catch (const FileError& error) {
            QVERIFY2(QString::fromStdString(error.what()).contains(said), error.what());
        }
    }
    void ofOldRunsOnlyTheNumbersAreKept()
    {
        std::vector<ReplicateSet> sets = one_set(replicate(3));
        sets[0].key.of = most_replicates;
        sets[0].runs.clear();
        for (int i = 0; i < static_cast<int>(most_kept_traces) + 5; ++i) sets[0].runs[i] = replicate(3);
        sets = without_leftovers(std::move(sets), drop_design());
        const auto traced =
            std::count_if(sets[0].runs.begin(), sets[0].runs.end(), [](const auto& run) { return run.second.trace != nullptr; });
        QCOMPARE(traced, static_cast<std::ptrdiff_t>(most_kept_traces));
        QCOMPARE(sets[0].runs.size(), most_kept_traces + 5);
    }
    void aDifferenceWithinWhatReplicatesScatterIsGrey()
    {
        // Cells: more each time; more on the average, but not each time; dry in both; more, but less than the numerical error.
        Candidate a, base;
        for (int i = 0; i < 6; ++i) {
            const double leap = i % 2 == 0 ? 0.06 : -0.04;
            a.replicates.emplace_back(replicate(3, {0.11 + 0.0005 * i, 0.1 + leap, 0.0002, 0.102}));
            base.replicates.emplace_back(replicate(3, {0.1, 0.1, 0, 0.1}));
            for (Candidate* each : {&a, &base}) each->replicates.back()->places = {0.5};
        }
        a.unknowns = base.unknowns = {"contact angle"};
        const auto paired = paired_map(a, base, MapSide::top, 0, 0.05);
        QVERIFY(paired && paired->pairs == 6 && paired->time == 1);
        QCOMPARE(paired->real, (std::vector<bool>{true, false, false, false}));
        QVERIFY(std::abs(paired->cells.water[0] - 0.01125) < 1e-9 && std::abs(paired->cells.water[1] - 0.01) < 1e-9);
        QVERIFY(paired_map(a, base, MapSide::top, 0, 0)->real[3]); // without a numerical error it counts
        QVERIFY(!paired_map(a, base, MapSide::top, 1, 0));         // they keep no other map
        base.replicates.resize(1);
        QVERIFY(!paired_map(a, base, MapSide::top, 0, 0)); // one pair
    }
    void aMapsCellsHaveTheirRange()
    {
        const Candidate a = candidate("a", {replicate(3, {0.1, 0, 0, 0}), replicate(3, {0.3, 0, 0, 0}), replicate(3, {0.2, 0.1, 0, 0})});
        const auto range = map_range(a, MapSide::top, 0);
        QVERIFY(range && range->runs == 3);
        QCOMPARE(range->low.water, (std::vector<double>{0.1, 0, 0, 0}));
        QCOMPARE(range->high.water, (std::vector<double>{0.3, 0.1, 0, 0}));
        QVERIFY(!map_range(a, MapSide::top, 1));
    }
    void mapsOfARunAreThoseOfItsRecording()
    {
        QTemporaryDir folder;
        constexpr double duration = 0.1;
        const Design design = drop_design(35, duration);
        RunOptions options;
        options.fidelity = Fidelity::draft;
        options.recording = folder.filePath("a.hygrorec").toStdString();
        MapTracer tracer;
        RunCallbacks callbacks;
        callbacks.started = [&](const RunRecord& run) { tracer.start(run); };
        callbacks.frame = [&](const std::shared_ptr<const Frame>& frame) { tracer.add(*frame); };
        RunControl control;
        run_experiment(design, "cloth", design.experiments[0].name, options, *make_backend("cpu"), control, callbacks);
        const std::vector<TracedMap> live = tracer.take(), recorded = traced_maps(Recording(options.recording));
        QCOMPARE(live.size(), std::size(traced_shares));
        QCOMPARE(recorded.size(), live.size());
        for (std::size_t i = 0; i < live.size(); ++i) {
            QVERIFY(std::abs(live[i].time - duration * traced_shares[i]) < 0.02);
            QCOMPARE(recorded[i].top.water, live[i].top.water);
            QCOMPARE(recorded[i].bottom.water, live[i].bottom.water);
        }
        QVERIFY(live.back().top.maximum() > 0 && live.back().top.columns <= most_traced_cells);
    }
    void aChartDrawsTheBandAndHasRoomForIt()
    {
        LineChart chart{"Radius", "time, s", "mm", {0, 1}, {{"a", {0, 1}}}};
        QVERIFY(svg_of(chart).find("fill-opacity") == std::string::npos);
        chart.curves[0].low = {0, 0.5};
        chart.curves[0].high = {0, 40};
        const std::string svg = svg_of(chart);
        QVERIFY(svg.find("fill-opacity=\"0.18\"") != std::string::npos);
        QVERIFY(svg.find(">40</text>") != std::string::npos); // the axis reaches the band
    }
    void theReportHasBandsAndSaysOfWhat()
    {
        Comparison comparison;
        comparison.replicates = 3;
        comparison.criteria = compared_by(ExperimentType::droplet);
        comparison.ranked_by = comparison.criteria.front();
        for (const char* name : {"a", "b"}) {
            Candidate each = candidate(name, replicates(3));
            auto run = std::make_shared<RunRecord>();
            run->design = drop_design(35, 10);
            run->fabric = "cloth";
            run->experiment = run->design.experiments[0].name;
            each.run = run;
            auto metrics = std::make_shared<Metrics>();
            metrics->series.time = {0, 10};
            metrics->series.radius_top = metrics->series.radius_bottom = {0, 0.002};
            each.metrics = metrics;
            comparison.candidates.push_back(each);
        }
        judge(comparison);
        const std::vector<ReportPicture> maps{{map_caption(comparison, "a", "top"), Image{1, 1, {0, 0, 0}}}};
        const std::string report = html_of(comparison_report(comparison, maps));
        for (const char* part : {"Line: the middle of the replicates. Band: least to most of 3 replicates.", "fill-opacity",
                                 "The first run of each cloth", "a, as given, top"})
            QVERIFY2(report.find(part) != std::string::npos, part);
        comparison.replicates = 1;
        for (Candidate& each : comparison.candidates) each.replicates.resize(1);
        QVERIFY(html_of(comparison_report(comparison, {})).find("fill-opacity") == std::string::npos);
        QCOMPARE(map_caption(comparison, "a", "top"), std::string("a, top"));
    }
};

QTEST_GUILESS_MAIN(TestReplicateRange)
#include "tst_replicate_range.moc"
