// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A garment that is worn: its numbers, its cells' size, its weight on a slope, its recording and its files.
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/project/project_file.h"
#include "core/wear/wear_map.h"
#include "core/wear/wear_outcomes.h"
#include "tests/support/vtp.h"
#include "tests/wear/flat_garment.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include <numeric>

using namespace hygroloom;

namespace tst_wear {
namespace {

constexpr double rate = 40'000; // g/m2 h

struct Finished {
    WearLayout layout;
    std::vector<WearFrame> frames;
    std::optional<WearMetrics> metrics;
};

void go(const Tee& tee, const GarmentScene& garment, Finished& finished)
{
    finished.layout = wear_layout(tee.parts, garment);
    finished.metrics.emplace(finished.layout);
    const std::unique_ptr<Backend> cpu = make_cpu_backend();
    RunControl control;
    run_wear(garment, tee.wear, *cpu, control,
             {[&](const std::shared_ptr<const WearFrame>& frame) {
                  finished.frames.push_back(*frame);
                  finished.metrics->add(*frame);
              },
              {}});
}

/// Water (g/m2) by squares of a side (m).
std::map<std::array<int, 2>, double> squares(const GarmentScene& garment, const std::vector<double>& water, double side)
{
    std::map<std::array<int, 2>, double> sums;
    for (std::size_t i = 0; i < water.size(); ++i)
        sums[{static_cast<int>(garment.cells[i].flat[0] / side), static_cast<int>(garment.cells[i].flat[1] / side)}] += water[i];
    return sums;
}

} // namespace

class TestWear : public QObject {
    Q_OBJECT

    /// In space each is as large as its cell (the built-in tee does not stretch), but where the cloth bends.
    static void check_quads(const Vtp& vtp, const std::vector<double>& area)
    {
        const auto points = vtp.values<float>("Points");
        const auto corners = vtp.values<std::int32_t>("connectivity"), ends = vtp.values<std::int32_t>("offsets");
        QVERIFY(corners.size() == 4 * area.size() && ends.size() == area.size());
        QVERIFY(points.size() == 3 * static_cast<std::size_t>(vtp.count.at("NumberOfPoints")));
        QVERIFY(points.size() / 3 < 2 * area.size()); // shared
        double drawn = 0, all = 0;
        for (std::size_t i = 0; i < area.size(); ++i) {
            QCOMPARE(ends[i], static_cast<std::int32_t>(4 * (i + 1)));
            const auto at = [&](std::size_t k) {
                const auto p = 3 * static_cast<std::size_t>(corners[4 * i + k]);
                return Vec3d{static_cast<double>(points[p]), static_cast<double>(points[p + 1]), static_cast<double>(points[p + 2])};
            };
            drawn += 0.5 * length(cross(at(2) - at(0), at(3) - at(1)));
            all += area[i];
        }
        qInfo("quadrilaterals of %.4g mm2 for cells of %.4g mm2", drawn, all);
        QVERIFY(std::abs(drawn - all) < 0.02 * all);
    }

private Q_SLOTS:
    void panels_and_zones_add_up()
    {
        Tee tee(600);
        Finished run;
        const GarmentScene garment = tee.scene(20e-3, true, true);
        go(tee, garment, run);
        const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); };
        const WearPart& all = run.metrics->all();
        for (const auto& parts : {run.metrics->panels(), run.metrics->zones()}) {
            double area = 0, water = 0, evaporated = 0, skin = 0;
            for (const WearPart& part : parts) {
                area += part.area;
                water += part.course.back().water;
                evaporated += part.course.back().evaporated;
                skin += part.course.back().on_skin;
            }
            QVERIFY(same(area, all.area));
            QVERIFY(same(water, all.course.back().water));
            QVERIFY(same(evaporated, all.course.back().evaporated));
            QVERIFY(same(skin, all.course.back().on_skin));
        }
        QVERIFY(run.metrics->zones().size() >= 4);
        QVERIFY(all.course.back().water > 0);
        const double pattern_area = std::accumulate(tee.parts.pattern.panels.begin(), tee.parts.pattern.panels.end(), 0.0,
                                                    [](double sum, const PatternPanel& panel) { return sum + area_of(panel); });
        qInfo("area %.4f m2 of cells, %.4f m2 of panels\n%s", all.area, pattern_area, table_of_parts(*run.metrics).c_str());
        QVERIFY(std::abs(all.area - pattern_area) < 0.02 * pattern_area);
    }

    /// What is shown in larger cells is the sum of what smaller ones hold, and the ledger is the same.
    void shown_cells_are_sums()
    {
        Tee tee(60);
        Finished fine, coarse;
        go(tee, tee.scene(10e-3, true, true), fine);
        const GarmentScene summed = tee.scene(10e-3, true, true, {40e-3, {"front"}});
        go(tee, summed, coarse);
        const WearFrame &a = fine.frames.back(), &b = coarse.frames.back();
        QVERIFY(b.inside.size() < a.inside.size() / 2);
        QCOMPARE(summed.shown.cells.size(), b.inside.size());
        std::map<std::array<int, 3>, double> sums; // by panel, end and pick of a shown cell
        for (std::size_t i = 0; i < a.inside.size(); ++i) {
            const GarmentCell& cell = fine.layout.cells[i];
            const int per_cell = summed.shown.computed_per_cell[static_cast<std::size_t>(cell.panel)];
            QCOMPARE(per_cell, fine.layout.panels[static_cast<std::size_t>(cell.panel)].name == "front" ? 1 : 4);
            sums[{cell.panel, cell.end / per_cell, cell.pick / per_cell}] += a.water(i);
        }
        QCOMPARE(sums.size(), b.inside.size());
        double area = 0;
        for (std::size_t i = 0; i < b.inside.size(); ++i) {
            const GarmentCell& cell = coarse.layout.cells[i];
            const double sum = sums.at({cell.panel, cell.end, cell.pick});
            QVERIFY(std::abs(b.water(i) - sum) <= 1e-12 * std::abs(sum));
            area += cell.area;
        }
        QVERIFY(std::abs(area - fine.metrics->all().in_cells) < 1e-9 * area);
        QVERIFY(std::abs(a.ledger.water_liquid - b.ledger.water_liquid) <= 1e-12 * a.ledger.water_liquid);
        QVERIFY(std::abs(a.ledger.energy_lost - b.ledger.energy_lost) <= 1e-9 * std::abs(a.ledger.energy_lost));
        QVERIFY_THROWS_EXCEPTION(Error, tee.scene(10e-3, true, true, {40e-3, {"frnt"}}));
    }

    /// Without wicking and air each zone keeps its dose.
    void without_wicking_zones_keep_their_doses()
    {
        Tee tee(60);
        GarmentScene garment = tee.scene(20e-3, false, true);
        StepRules& rules = garment.scene.rules;
        rules.wicking = rules.sorption = rules.vapour = rules.heat = false;
        Finished run;
        go(tee, garment, run);
        for (const WearPart& zone : run.metrics->zones()) {
            const auto number = std::find(body_zones().begin(), body_zones().end(), zone.name) - body_zones().begin();
            const double dose = 1e-3 * tee.parts.sweat.g_m2_h[static_cast<std::size_t>(number)] / 3600 * 60 * zone.in_cells;
            QVERIFY(std::abs(zone.course.back().water + zone.course.back().on_skin - dose) < 1e-9 * dose);
        }
    }

    /// Larger cells against single crossings: fed in a spot, and evenly.
    void larger_cells_data()
    {
        QTest::addColumn<int>("per_cell");
        QTest::addColumn<bool>("evenly");
        QTest::addColumn<double>("most_contents");
        QTest::addColumn<double>("most_apart");
        for (int k : {2, 4, 8, 12}) QTest::addRow("%d, evenly", k) << k << true << 0.005 << 0.01;
        for (int k : {2, 4, 8, 12}) QTest::addRow("%d, a spot", k) << k << false << 0.005 << 0.03;
    }
    void larger_cells()
    {
        QFETCH(int, per_cell);
        QFETCH(bool, evenly);
        QFETCH(double, most_contents);
        QFETCH(double, most_apart);
        const auto run = [&](int k, double& total) {
            Worn worn;
            const Fabric& fabric = worn.design.fabrics[0];
            const double pitch = 1e-2 / fabric.ends_per_cm, size = 96 * pitch;
            add_rectangle(worn.parts.pattern, "piece", {0, 0}, size, size);
            GarmentScene garment = worn.scene(k * pitch);
            if (garment.fabrics[0].crossings_per_cell != k) throw Error("cells of another size");
            for (const GarmentCell& cell : garment.cells) { // in the middle a square that cells of any size fill
                const bool inside = std::abs(cell.flat[0] - 0.5 * size) < 0.25 * size && std::abs(cell.flat[1] - 0.5 * size) < 0.25 * size;
                garment.scene.supply.skin.rate[static_cast<std::size_t>(cell.crossing)] =
                    evenly || inside ? 1e-3 * 0.5 * rate / 3600 / garment.scene.climate.density : 0.0;
            }
            const std::vector<double> water = water_in_cells(frame_at(garment.scene, 10));
            total = std::accumulate(water.begin(), water.end(), 0.0);
            return squares(garment, water, 24 * pitch);
        };
        double fine_total = 0, coarse_total = 0;
        static std::map<bool, std::pair<std::map<std::array<int, 2>, double>, double>> known;
        if (!known.contains(evenly)) {
            known[evenly].first = run(1, fine_total);
            known[evenly].second = fine_total;
        }
        const auto& fine = known[evenly].first;
        fine_total = known[evenly].second;
        const auto coarse = run(per_cell, coarse_total);
        double apart = 0, squares_sum = 0;
        for (const auto& [at, water] : fine) {
            const double other = coarse.contains(at) ? coarse.at(at) : 0.0;
            apart += (water - other) * (water - other);
            squares_sum += water * water;
        }
        qInfo("contents differ by %.2f %%, maps by %.2f %%", 100 * (coarse_total / fine_total - 1), 100 * std::sqrt(apart / squares_sum));
        QVERIFY(std::abs(coarse_total - fine_total) < most_contents * fine_total);
        QVERIFY(std::sqrt(apart / squares_sum) < most_apart);
    }

    void water_runs_down_a_hanging_panel()
    {
        Worn worn;
        add_rectangle(worn.parts.pattern, "piece", {0, 0}, 0.02, 0.2);
        const auto lower_share = [&](bool hangs) {
            GarmentScene garment = worn.scene(4e-3, hangs);
            sweat_in_circle(garment, {0.01, 0.1}, 1, 0.06 * rate); // evenly
            const std::vector<double> water = water_in_cells(frame_at(garment.scene, 300));
            double low = 0, all = 0;
            for (std::size_t i = 0; i < water.size(); ++i) {
                all += water[i];
                if (garment.cells[i].flat[1] < 0.1) low += water[i];
            }
            return low / all;
        };
        const double flat = lower_share(false), hanging = lower_share(true);
        qInfo("lower half holds %.2f %% lying, %.2f %% hanging", 100 * flat, 100 * hanging);
        QVERIFY(std::abs(flat - 0.5) < 1e-6);
        QVERIFY(hanging > 0.502);
    }

    void recordings_keep_frames()
    {
        Tee tee(60);
        const GarmentScene garment = tee.scene(40e-3, true, true);
        Finished run;
        go(tee, garment, run);
        QTemporaryDir folder;
        const std::string path = folder.filePath("tee.hygrorec").toStdString();
        {
            WearWriter writer(path, {tee.design, run.layout, "draft", "cpu", "a CPU", "2026-01-01T00:00:00Z"});
            for (const WearFrame& frame : run.frames) writer.append(frame);
            writer.finish(1);
        }
        QVERIFY(WearRecording::is_one(path));
        const WearRecording recording{path};
        QVERIFY(recording.finished());
        QCOMPARE(recording.frames(), static_cast<int>(run.frames.size()));
        const WearFrame frame = recording.frame(recording.frames() - 1);
        QCOMPARE(frame.inside.size(), run.layout.cells.size());
        for (std::size_t i = 0; i < frame.inside.size(); ++i)
            QCOMPARE(static_cast<float>(frame.inside[i]), static_cast<float>(run.frames.back().inside[i]));
        WearMetrics again(recording.record().layout);
        for (int k = 0; k < recording.frames(); ++k) again.add(recording.frame(k));
        QVERIFY(std::abs(again.all().course.back().water - run.metrics->all().course.back().water) <
                1e-6 * again.all().course.back().water);

        QFile file(QString::fromStdString(path));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray whole = file.readAll();
        for (int cut : {0, 100, 4000, static_cast<int>(whole.size()) / 2, static_cast<int>(whole.size()) - 100}) {
            QFile part(folder.filePath("cut.hygrorec"));
            QVERIFY(part.open(QIODevice::WriteOnly));
            part.write(whole.left(cut));
            part.close();
            QVERIFY_EXCEPTION_THROWN(
                {
                    const WearRecording damaged{part.fileName().toStdString()};
                    for (int k = 0; k < damaged.frames(); ++k) damaged.frame(k);
                },
                FileError);
        }
    }

    void maps_are_written()
    {
        Tee tee(60);
        const GarmentScene garment = tee.scene(20e-3, true, true);
        Finished run;
        go(tee, garment, run);
        QTemporaryDir folder;
        const std::filesystem::path path = folder.path().toStdString();
        const WearMap map = wear_map(run.layout, run.frames.back(), {});
        QVERIFY(map.most() > 0);
        const std::vector<std::string> files = write_wear_map(run.layout, run.frames.back(), map, path);
        for (const std::string& file : files) QVERIFY2(std::filesystem::file_size(path / file) > 0, file.c_str());
        for (const char* name : {"garment.glb", "garment.obj"}) {
            Assimp::Importer importer;
            const aiScene* scene = importer.ReadFile((path / name).string(), 0);
            QVERIFY2(scene != nullptr, importer.GetErrorString());
            QCOMPARE(static_cast<std::size_t>(scene->mNumMeshes), run.layout.panels.size());
        }
        const std::string csv = wear_csv(run.layout, run.frames.back());
        QCOMPARE(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), run.layout.cells.size() + 1);
    }

    /// As the table of cells says, to all its digits; and cells of a panel hang together.
    void cells_open_in_paraview()
    {
        Tee tee(60);
        const GarmentScene garment = tee.scene(20e-3, true, true);
        Finished run;
        go(tee, garment, run);
        QTemporaryDir folder;
        const std::filesystem::path path = std::filesystem::path(folder.path().toStdString()) / "cells.vtp";
        write_cells_vtk(run.layout, run.frames.back(), path);
        const Vtp vtp(QString::fromStdString(path.string()));
        QVERIFY(vtp.well_formed);
        const std::size_t cells = run.layout.cells.size();
        QCOMPARE(static_cast<std::size_t>(vtp.count.at("NumberOfPolys")), cells);

        const QStringList lines = QString::fromStdString(wear_csv(run.layout, run.frames.back())).split('\n', Qt::SkipEmptyParts);
        const QStringList names = lines[0].split(',');
        const auto area = vtp.values<double>("area_mm2");
        for (const char* name : {"water_g_m2", "inside_g_m2", "outside_g_m2", "share_of_capacity", "temperature_c", "evaporated_g_m2",
                                 "on_skin_g_m2", "area_mm2"}) {
            const auto values = vtp.values<double>(name);
            QCOMPARE(values.size(), cells);
            double printed = 0, written = 0;
            for (std::size_t i = 0; i < cells; ++i) {
                const QString text = lines[static_cast<qsizetype>(i) + 1].split(',')[names.indexOf(name)];
                const bool is_fixed = std::string(name) == "temperature_c" || std::string(name) == "area_mm2";
                printed += text.toDouble() * area[i];
                written += QString::number(values[i], is_fixed ? 'f' : 'g', is_fixed ? 4 : 6).toDouble() * area[i];
            }
            QVERIFY2(printed > 0 && std::abs(written - printed) <= 1e-9 * printed, name);
        }
        double water = 0;
        const auto per_area = vtp.values<double>("water_g_m2");
        for (std::size_t i = 0; i < cells; ++i) water += 1e-9 * area[i] * per_area[i];
        QVERIFY(std::abs(water - run.metrics->all().course.back().water) <= 1e-9 * water);

        const auto panel = vtp.values<std::int32_t>("panel"), zone = vtp.values<std::int32_t>("zone");
        for (std::size_t i = 0; i < cells; ++i) QVERIFY(panel[i] == run.layout.cells[i].panel && zone[i] == run.layout.cells[i].zone);
        check_quads(vtp, area);
    }

    void projects_keep_wear()
    {
        Tee tee(600);
        tee.wear.activity = {{0, 1}, {300, 0.25}};
        tee.wear.initial_water_g_m2 = 20;
        Design design = tee.design;
        design.garments.push_back(tee.garment);
        design.wears.push_back(tee.wear);
        QVERIFY(!has_error(validate(design)));
        QVERIFY(parse_project(format_project(design), "a test") == design);
        for (const auto& [wrong, where] : std::map<std::string, void (*)(WearExperiment&)>{
                 {"garment", [](WearExperiment& wear) { wear.garment = "none"; }},
                 {"liquid", [](WearExperiment& wear) { wear.liquid = "none"; }},
                 {"duration_s", [](WearExperiment& wear) { wear.duration_s = 0; }},
                 {"activity", [](WearExperiment& wear) { wear.activity.clear(); }},
                 {"factor", [](WearExperiment& wear) { wear.activity[0].factor = -1; }},
                 {"time_s", [](WearExperiment& wear) { wear.activity[1].time_s = 600; }},
                 {"initial_water_g_m2", [](WearExperiment& wear) { wear.initial_water_g_m2 = -1; }},
                 {"air_speed_m_s", [](WearExperiment& wear) { wear.climate.air_speed_m_s = 30; }}}) {
            Design bad = design;
            where(bad.wears[0]);
            const std::vector<Issue> issues = validate(bad);
            QVERIFY2(std::any_of(issues.begin(), issues.end(),
                                 [&](const Issue& issue) { return issue.where.text().find(wrong) != std::string::npos; }),
                     wrong.c_str());
        }
    }
};

} // namespace tst_wear

QTEST_GUILESS_MAIN(tst_wear::TestWear)
#include "tst_wear.moc"
