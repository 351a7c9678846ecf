// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A large sample is shown in cells: they hold what its segments hold, the numbers stay those of single yarns, and what is recorded grows
// with the cells.
#include "core/analysis/cell_map.h"
#include "core/base/error.h"
#include "core/plan/bundles.h"
#include "core/run/plan_run.h"
#include "core/run/recording.h"
#include "tests/support/run.h"
#include "tests/support/spot_design.h"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <map>
#include <numeric>
#include <tuple>

using namespace hygroloom;

namespace {

Design design_of(ExperimentType type, double duration)
{
    Design design = type == ExperimentType::droplet ? drop_design(35, duration) : spot_design("cotton", 0.6, duration);
    for (Yarn* yarn : yarns_of(design.fabrics[0])) yarn->irregularity_cv = 0; // the sum over faces needs no single yarns then
    if (type == ExperimentType::droplet) {
        design.experiments[0].droplets[0].at_mm = {1.5, -2};
        return design;
    }
    Experiment experiment = standard_experiment(type);
    experiment.name = "drop";
    experiment.sample_mm = {10, 12};
    experiment.duration_s = duration;
    design.experiments = {experiment};
    return design;
}

/// So that none comes on while running.
const ForcedParts all_parts{{"sorption", true}, {"vapour", true}, {"heat", true}};

RunOptions shown(double yarns, const Design& design, const RunOptions& options)
{
    RunOptions how = options;
    const Textile textile = textile_of_run(design, design.fabrics[0], design.experiments[0]);
    how.shown_side = yarns * std::sqrt(textile.warp.pitch * textile.weft.pitch);
    return how;
}

/// Of one experiment: shown in single yarns, and in cells of so many.
struct Both {
    Run all, cells;
};

/// Run once, for all tests that ask.
const Both& both_of(ExperimentType type, double duration, double yarns)
{
    static std::map<std::tuple<ExperimentType, double, double>, Both> known;
    const std::tuple asked{type, duration, yarns};
    if (!known.contains(asked)) {
        const Design design = design_of(type, duration);
        const RunOptions options = draft(all_parts, {{"particles_per_droplet", 300}, {"crossings_per_even_cell", 1}});
        known.insert({asked, {run(design, options), run(design, shown(yarns, design, options))}});
    }
    return known.at(asked);
}

/// Part of a yarn that lies in a cell, both laid out along one length.
double overlap(int yarn, int yarns, int cell, int cells)
{
    const double begin = std::max(double(yarn) / yarns, double(cell) / cells), end = std::min((yarn + 1.0) / yarns, (cell + 1.0) / cells);
    return std::max(0.0, end - begin) * yarns;
}

/// What the cells of a frame hold, added up from its single segments.
std::vector<double> in_cells_of(const Textile& fine, const std::vector<float>& values, const Textile& cells)
{
    std::vector<double> sums(static_cast<std::size_t>(cells.segments()));
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (int c = 0; c < cells.ends(); ++c)
            for (int d = 0; d < cells.picks(); ++d)
                for (int end = 0; end < fine.ends(); ++end)
                    for (int pick = 0; pick < fine.picks(); ++pick)
                        sums[static_cast<std::size_t>(cells.segment(kind, c, d))] +=
                            overlap(end, fine.ends(), c, cells.ends()) * overlap(pick, fine.picks(), d, cells.picks()) *
                            static_cast<double>(values[static_cast<std::size_t>(fine.segment(kind, end, pick))]);
    return sums;
}

double sum(const std::vector<float>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

bool near_to(double a, double b, double within)
{
    return std::isfinite(a) && std::isfinite(b) && std::abs(a - b) <= within * std::max(std::abs(a), std::abs(b));
}

const char* which_ledger_differs(const Ledger& a, const Ledger& b)
{
    const double scale = a.water_initial + a.water_delivered;
    for (const LedgerColumn& column : ledger_columns)
        if (std::abs(a.*column.value - b.*column.value) > 1e-12 * std::max(scale, std::abs(a.*column.value))) return column.name;
    return nullptr;
}

} // namespace

class TestShownCells : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cells_hold_what_segments_hold_data();
    void cells_hold_what_segments_hold();
    void numbers_stay_those_of_single_yarns_data() { cells_hold_what_segments_hold_data(); }
    void numbers_stay_those_of_single_yarns();
    void a_recording_holds_cells();
    void what_cannot_be_in_a_recording_is_refused();
    void larger_bundles_than_the_sample_are_read();
    void bundles_are_never_parted();
    void what_is_left_out_comes_on_at_the_same_frame_data();
    void what_is_left_out_comes_on_at_the_same_frame();
    void a_cloth_in_cells_weighs_the_same();
    void only_large_samples_are_shown_in_cells();
};

void TestShownCells::cells_hold_what_segments_hold_data()
{
    QTest::addColumn<ExperimentType>("type");
    QTest::addColumn<double>("duration");
    QTest::addColumn<double>("yarns");
    QTest::newRow("a drop of particles") << ExperimentType::droplet << 0.2 << 2.4;
    QTest::newRow("a pool") << ExperimentType::horizontal_wicking << 2.0 << 3.0;
    QTest::newRow("drying") << ExperimentType::drying << 60.0 << 4.0;
    QTest::newRow("sweat") << ExperimentType::sweat << 5.0 << 5.0;
}

void TestShownCells::cells_hold_what_segments_hold()
{
    QFETCH(ExperimentType, type);
    QFETCH(double, duration);
    QFETCH(double, yarns);
    const auto& [all, cells] = both_of(type, duration, yarns);
    const Textile &fine = all.record.textile, &coarse = cells.record.textile;
    QCOMPARE(coarse.ends(), static_cast<int>(std::lround(fine.ends() / std::round(yarns))));
    QVERIFY(coarse.crossings() < fine.crossings());
    QCOMPARE(cells.frames.size(), all.frames.size());
    for (std::size_t k = 0; k < all.frames.size(); k += 10) {
        const Frame &a = all.frames[k], &b = cells.frames[k];
        QCOMPARE(which_ledger_differs(a.ledger, b.ledger), nullptr);
        QCOMPARE(b.saturation.size(), static_cast<std::size_t>(coarse.segments()));
        const double water = a.ledger.water_initial + a.ledger.water_delivered;
        QVERIFY(std::abs(a.water_top - b.water_top) < 1e-9 * water);
        QVERIFY(std::abs(a.water_bottom - b.water_bottom) < 1e-9 * water);
        const std::vector<double> liquid = in_cells_of(fine, a.liquid, coarse), between = in_cells_of(fine, a.between, coarse);
        for (std::size_t i = 0; i < liquid.size(); ++i) {
            // Frames are rounded.
            constexpr double steps = 0x1p-55 * (25 + 1); // kg; half of one for each segment, and for the cell
            QVERIFY(std::abs(liquid[i] - static_cast<double>(b.liquid[i])) < 2.5e-4 * liquid[i] + 1e-6 * sum(a.liquid) + steps);
            QVERIFY(std::abs(between[i] - static_cast<double>(b.between[i])) < 2.5e-4 * between[i] + 1e-6 * sum(a.between) + 1e-20);
            QVERIFY(b.saturation[i] >= 0 && b.saturation[i] <= 1.0001F);
        }
        const auto mean = [](const std::vector<float>& values) { return sum(values) / static_cast<double>(values.size()); };
        QVERIFY(std::abs(mean(a.temperature) - mean(b.temperature)) < 1.0 / 512); // K, a step of frames
        QVERIFY(near_to(mean(a.regain), mean(b.regain), 1e-3));
        const auto [least, most] = std::minmax_element(a.vapour.begin(), a.vapour.end());
        for (float vapour : b.vapour) QVERIFY(vapour >= 0.999F * *least && vapour <= 1.001F * *most);
    }
}

/// Radius, ellipse, edge and time of absorption come from the segments themselves, whatever frames show.
void TestShownCells::numbers_stay_those_of_single_yarns()
{
    QFETCH(ExperimentType, type);
    QFETCH(double, duration);
    QFETCH(double, yarns);
    const auto& [all, cells] = both_of(type, duration, yarns);
    const Metrics &a = all.metrics, &b = cells.metrics;
    for (std::size_t k = 0; k < a.series.time.size(); ++k) {
        // A segment that is just wet or just dry is one or the other by the rounding of frames.
        for (const auto& [in_all, in_cells] :
             {std::pair{a.series.radius_top[k], b.series.radius_top[k]}, std::pair{a.series.radius_bottom[k], b.series.radius_bottom[k]}})
            QVERIFY2(near_to(in_all, in_cells, 0.03), qPrintable(QString("%1 %2 at %3 s").arg(in_all).arg(in_cells).arg(a.series.time[k])));
        QVERIFY(near_to(a.series.yarn_water[k], b.series.yarn_water[k], 1e-12));
        QVERIFY(std::abs(a.series.water_top[k] - b.series.water_top[k]) <= 1e-6 * (a.ledger.water_delivered + a.ledger.water_initial));
    }
    QVERIFY(near_to(a.wetted_area_ellipse_weft, b.wetted_area_ellipse_weft, 1e-4));
    QVERIFY(near_to(a.wetted_area_ellipse_warp, b.wetted_area_ellipse_warp, 1e-4));
    QCOMPARE(a.edge_time.has_value(), b.edge_time.has_value());
    if (a.edge_time) QCOMPARE(*a.edge_time, *b.edge_time);
    QCOMPARE(a.absorbency_time, b.absorbency_time);
    QCOMPARE(a.time_of_arrest, b.time_of_arrest);
    if (type == ExperimentType::droplet) QVERIFY(a.maximum_wetted_radius_top > 1e-3);
}

void TestShownCells::a_recording_holds_cells()
{
    QTemporaryDir folder;
    Design design = design_of(ExperimentType::horizontal_wicking, 0.5);
    design.experiments[0].sample_mm = {16, 16};
    RunOptions options = draft(all_parts);
    options.recording = folder.filePath("all.hygrorec").toStdString();
    const Run all = run(design, options);
    RunOptions how = shown(4, design, options);
    how.recording = folder.filePath("cells.hygrorec").toStdString();
    const Run cells = run(design, how);
    const Recording recording(how.recording);
    QCOMPARE(recording.run().textile.ends(), cells.record.textile.ends());
    MetricsCollector collector;
    collector.start(recording.run());
    for (int k = 0; k < recording.frames(); ++k) collector.add(recording.frame(k));
    QCOMPARE(collector.metrics().maximum_wetted_radius_top, cells.metrics.maximum_wetted_radius_top);
    QCOMPARE(collector.metrics().wetted_area_ellipse_weft, cells.metrics.wetted_area_ellipse_weft);
    QCOMPARE(collector.metrics().series.water_top, cells.metrics.series.water_top);
    QVERIFY(std::filesystem::file_size(how.recording) < std::filesystem::file_size(options.recording));
    // Maps: finer than cells are is not to be had; by faces each cell counts with what lies there.
    QCOMPARE(cell_map(cells.record.textile, cells.end(), cells.frames.front(), MapSide::total, 2).crossings_per_cell, 4);
    for (int crossings : {4, 8})
        for (MapSide side : {MapSide::top, MapSide::bottom, MapSide::total}) {
            const CellMap fine = cell_map(all.record.textile, all.end(), all.frames.front(), side, crossings);
            const CellMap map = cell_map(cells.record.textile, cells.end(), cells.frames.front(), side, crossings);
            QCOMPARE(map.columns, fine.columns);
            QCOMPARE(map.rows, fine.rows);
            QCOMPARE(map.crossings_per_cell, crossings);
            for (std::size_t i = 0; i < map.water.size(); ++i)
                QVERIFY(std::isfinite(map.water[i]) && std::abs(map.water[i] - fine.water[i]) < 0.02 * fine.maximum());
        }
}

void TestShownCells::what_cannot_be_in_a_recording_is_refused()
{
    QTemporaryDir folder;
    const Design design = design_of(ExperimentType::horizontal_wicking, 0.2);
    const Run good = run(design, shown(4, design, draft(all_parts)));
    const std::string path = folder.filePath("crafted.hygrorec").toStdString();
    const auto write = [&](const RunRecord& record, const std::function<void(Frame&)>& change) {
        RecordingWriter writer(path, record);
        for (std::size_t k = 0; k < 3; ++k) {
            Frame frame = good.frames[k];
            if (k == 1) change(frame);
            writer.append(frame);
        }
        writer.finish(1);
    };
    const auto frames_left = [&](const std::function<void(Frame&)>& change) {
        write(good.record, change);
        Recording recording(path);
        recording.read_frames([](const Frame&) { return true; });
        return recording.frames();
    };
    QCOMPARE(frames_left([](Frame&) {}), 3);
    QCOMPARE(frames_left([](Frame& frame) { frame.wet[3].first[0] = frame.wet[3].last[0] = 1e6F; }), 2);
    QCOMPARE(frames_left([](Frame& frame) { frame.wet[3] = {{7, -1}, {6, -1}, {2, 0}, {0, 0}, {0, 0}}; }), 2);
    QCOMPARE(frames_left([](Frame& frame) {
                 frame.wet[3].count[1] = 5;
                 frame.wet[3].first[1] = -1;
             }),
             2);
    QCOMPARE(frames_left([](Frame& frame) { frame.wet[0] = {{-1, -1}, {1e30F, -1}, {0, 0}, {0, 0}, {0, 0}}; }), 2);
    QCOMPARE(frames_left([](Frame& frame) { frame.wet[3] = {{2, -1}, {4, -1}, {3, 0}, {3, 0}, {1e20F, 0}}; }), 2);
    QCOMPARE(frames_left([](Frame& frame) { frame.wet.pop_back(); }), 2);
    QCOMPARE(frames_left([](Frame& frame) { frame.wet.clear(); }), 2);
    for (const auto& [ends, picks, per_cell] : {std::tuple{10'000, 4, 1},
                                                {4, 10'000, 1},
                                                {-4, 4, 1},
                                                {4, 0, 1},
                                                {12, 12, 30},
                                                {4, 4, 0},
                                                {0, 0, 0},
                                                {65536, 32768, 2147479552}}) {
        RunRecord record = good.record;
        record.plan.shown_ends = ends;
        record.plan.shown_picks = picks;
        record.plan.crossings_per_cell = per_cell;
        write(record, [](Frame&) {});
        QVERIFY_EXCEPTION_THROWN(Recording{path}, FileError);
    }
}

void TestShownCells::larger_bundles_than_the_sample_are_read()
{
    QTemporaryDir folder;
    RunOptions options = draft({}, {{"crossings_per_cell", 8}});
    options.recording = folder.filePath("one.hygrorec").toStdString();
    Design design = design_of(ExperimentType::drying, 20);
    design.experiments[0].sample_mm = {1, 1};
    const Run one = run(design, options);
    QVERIFY(one.record.plan.crossings_per_cell > std::max(one.record.textile.ends(), one.record.textile.picks()));
    QCOMPARE(Recording(options.recording).frames(), static_cast<int>(one.frames.size()));
}

void TestShownCells::bundles_are_never_parted()
{
    const Design design = design_of(ExperimentType::drying, 60);
    const RunOptions options = draft(all_parts, {{"crossings_per_even_cell", 4}});
    const Run all = run(design, options), alike = run(design, shown(2, design, options)), few = run(design, shown(8, design, options));
    const Textile& fine = all.record.textile;
    QCOMPARE(all.record.plan.crossings_per_cell, 4);
    QCOMPARE(alike.record.textile.ends(), bundles_of(fine.ends(), {4}).count);
    QCOMPARE(few.record.textile.ends(), static_cast<int>(std::lround(fine.ends() / 8.0)));
    for (const Run* cells : {&alike, &few}) {
        QCOMPARE(which_ledger_differs(all.end().ledger, cells->end().ledger), nullptr);
        QVERIFY(near_to(sum(all.end().liquid), sum(cells->end().liquid), 1e-4));
        QVERIFY(std::abs(all.end().water_top - cells->end().water_top) < 5e-5 * all.end().ledger.water_initial); // frames are rounded
    }
    Design pool = design_of(ExperimentType::horizontal_wicking, 2);
    pool.experiments[0].sample_mm = {9.2, 11.5}; // 32 ends and 40 picks: all bundles have two yarns
    const RunOptions pairs = draft(all_parts, {{"crossings_per_cell", 2}});
    const Run single = run(pool, pairs), cells = run(pool, shown(4, pool, pairs));
    QCOMPARE(single.record.plan.crossings_per_cell, 2);
    const double pitch = single.record.textile.warp.pitch + single.record.textile.weft.pitch;
    for (std::size_t k = 0; k < single.metrics.series.time.size(); ++k)
        QVERIFY(std::abs(single.metrics.series.radius_top[k] - cells.metrics.series.radius_top[k]) < 0.5 * pitch);
    QVERIFY(single.metrics.maximum_wetted_radius_top > 4 * pitch);
    QVERIFY(std::abs(single.metrics.wetted_area_ellipse_warp - cells.metrics.wetted_area_ellipse_warp) < 0.25 * pitch);
}

void TestShownCells::what_is_left_out_comes_on_at_the_same_frame_data()
{
    QTest::addColumn<double>("humidity");
    QTest::addColumn<ForcedParts>("forced");
    QTest::addColumn<double>("neglected");
    QTest::addColumn<QString>("due");
    QTest::newRow("vapour") << 0.9955 << ForcedParts{{"heat", false}} << 0.01 << "vapour";
    QTest::newRow("sorption and heat") << 0.2 << ForcedParts{{"vapour", false}} << 0.08 << "sorption heat";
}

void TestShownCells::what_is_left_out_comes_on_at_the_same_frame()
{
    QFETCH(double, humidity);
    QFETCH(ForcedParts, forced);
    QFETCH(double, neglected);
    QFETCH(QString, due);
    const Design design = spot_design("polyester", humidity, 200);
    const RunOptions options = draft(forced, {{"neglected_share", neglected}});
    const Run all = run(design, options), cells = run(design, shown(3, design, options));
    QVERIFY(cells.record.plan.shown_ends > 0 && cells.record.plan.not_in_cells.empty());
    const auto &a = all.record.switched_on, &b = cells.record.switched_on;
    QStringList names;
    for (const SwitchedPart& part : b) names += QString::fromStdString(part.name);
    QCOMPARE(names.join(' '), due);
    QCOMPARE(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        QCOMPARE(a[k].name, b[k].name);
        QCOMPARE(a[k].time, b[k].time);
        QVERIFY2(near_to(a[k].share, b[k].share, 1e-5), qPrintable(QString("%1 and %2").arg(a[k].share).arg(b[k].share)));
    }
    QCOMPARE(which_ledger_differs(all.end().ledger, cells.end().ledger), nullptr);
}

void TestShownCells::a_cloth_in_cells_weighs_the_same()
{
    const Design design = design_of(ExperimentType::droplet, 1);
    const Textile fine = textile_of_run(design, design.fabrics[0], design.experiments[0]);
    const Textile cells = in_cells(fine, fine.ends() / 3, 2 * fine.picks() / 5);
    const auto fibres = [](const Textile& textile) {
        double volume = 0;
        for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
            for (int end = 0; end < textile.ends(); ++end)
                for (int pick = 0; pick < textile.picks(); ++pick) {
                    const YarnType& type = textile.type(kind, kind == YarnKind::warp ? end : pick);
                    volume += type.area * type.packing * textile.segment_length(kind, end, pick);
                }
        return volume;
    };
    QVERIFY(near_to(fibres(fine), fibres(cells), 1e-12));
    QVERIFY(near_to(fine.ends() * fine.warp.pitch, cells.ends() * cells.warp.pitch, 1e-12));
    QVERIFY(near_to(fine.x_of_end(0) - 0.5 * fine.warp.pitch, cells.x_of_end(0) - 0.5 * cells.warp.pitch, 1e-12));
    QCOMPARE(cells.thickness, fine.thickness);
}

void TestShownCells::only_large_samples_are_shown_in_cells()
{
    Design design = design_of(ExperimentType::droplet, 1);
    const auto plan = [&](double side_mm) {
        design.experiments[0].sample_mm = {side_mm, side_mm};
        return plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::standard);
    };
    QCOMPARE(plan(20).shown_ends, 0);
    const ModelPlan large = plan(600);
    QVERIFY(large.region.ends * double(large.region.picks) > 500'000);
    QVERIFY(large.shown_ends > 0 && double(large.shown_ends) * large.shown_picks <= 510'000);
    QVERIFY(double(large.shown_ends) * large.shown_picks > 100'000);
    design.fabrics[0].extra_yarns = {design.fabrics[0].warp};
    Yarn& thin = design.fabrics[0].extra_yarns[0];
    (thin.diameter_mm ? *thin.diameter_mm : *thin.linear_density_tex) *= 0.8;
    design.fabrics[0].warp_order = {{0, 2}, {1, 2}};
    QCOMPARE(plan(600).shown_ends, 0); // a cell would mix the types
    QVERIFY(plan(600).not_in_cells.find("types") != std::string::npos);
    design = design_of(ExperimentType::vertical_wicking, 1);
    QCOMPARE(plan(600).shown_ends, 0);
    design = design_of(ExperimentType::moisture_management, 1);
    QCOMPARE(plan(600).shown_ends, 0);
}

QTEST_GUILESS_MAIN(TestShownCells)
#include "tst_shown_cells.moc"
