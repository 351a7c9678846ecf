// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Panels of a garment as one cloth: against the same cloth as a sample, uncut, turned and in larger cells.
#include "core/base/units.h"
#include "core/run/plan_run.h"
#include "tests/wear/flat_garment.h"

#include <QTest>

#include <numeric>

using namespace hygroloom;

namespace {

constexpr double rate = 40'000; // g/m2 h: fills textile F in a quarter of a minute

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// Over the larger root of squares.
double difference(const std::vector<double>& a, const std::vector<double>& b)
{
    double apart = 0, squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        apart += (a[i] - b[i]) * (a[i] - b[i]);
        squares += a[i] * a[i];
    }
    return std::sqrt(apart / squares);
}

/// Second moments of the water about its middle, along flat x and y, m2.
std::array<double, 2> spread(const GarmentScene& garment, const std::vector<double>& water)
{
    std::array<double, 2> middle{}, moment{};
    const double all = sum(water);
    for (std::size_t k = 0; k < 2; ++k) {
        for (std::size_t i = 0; i < water.size(); ++i) middle[k] += water[i] * garment.cells[i].flat[k] / all;
        for (std::size_t i = 0; i < water.size(); ++i) moment[k] += water[i] * std::pow(garment.cells[i].flat[k] - middle[k], 2) / all;
    }
    return moment;
}

} // namespace

class TestGarmentScene : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// The sample of a `sweat` experiment is the same cloth.
    void a_rectangle_is_a_sample()
    {
        Worn worn;
        const Fabric& fabric = worn.design.fabrics[0];
        const double width = 40 * 10 / fabric.ends_per_cm, height = 36 * 10 / fabric.picks_per_cm; // mm
        add_rectangle(worn.parts.pattern, "front", {0, 0}, 1e-3 * width, 1e-3 * height);
        Experiment experiment = standard_experiment(ExperimentType::sweat);
        experiment.climate = worn.wear.climate;
        experiment.liquid = worn.wear.liquid;
        experiment.sample_mm = {width, height};
        experiment.rate_g_m2_h = rate;
        experiment.duration_s = worn.wear.duration_s;
        const ModelPlan plan =
            plan_run(worn.design, fabric, experiment, Fidelity::standard,
                     {{"wicking", true}, {"sorption", true}, {"vapour", true}, {"heat", true}}, {{"crossings_per_even_cell", 1}});
        const Textile textile = textile_of_run(worn.design, fabric, experiment);
        Scene sample = build_scene(worn.design, textile, experiment, plan, 1);
        sample.cloth.pores.clear(); // garments have even yarns
        worn.parts.sweat.g_m2_h.assign(body_zones().size(), rate);
        GarmentScene garment = worn.scene(1e-6);
        QCOMPARE(garment.scene.cloth.ends, sample.cloth.ends);
        QCOMPARE(garment.scene.cloth.picks, sample.cloth.picks);
        garment.scene.rules.shows_segments = true;
        sample.rules = garment.scene.rules;
        sample.cloth.face_only = true;
        garment.scene.cloth.panels.airs[0] = {0, sample.climate.vapour, sample.climate.heat_transfer, sample.climate.mass_transfer};
        const Frame a = frame_at(sample, 5), b = frame_at(garment.scene, 5);
        QVERIFY(a.ledger.water_liquid > 0.1 * a.ledger.water_delivered);
        QVERIFY(a.liquid == b.liquid);
        QVERIFY(a.regain == b.regain);
        QVERIFY(a.temperature == b.temperature);
    }

    /// What is of the warp in a cloth is of the weft in the same cloth turned, and turned twice it is as it was.
    void turned_cloth_has_its_yarns_exchanged()
    {
        Worn worn;
        Fabric fabric = worn.design.fabrics[0];
        fabric.weft.packing_factor = 0.7; // unlike the warp
        const FabricCells cells = fabric_cells(worn.design, fabric, worn.wear, knobs_of(Fidelity::draft), 2e-3), across = turned(cells),
                          back = turned(across);
        const BetweenParameters &of = cells.tile.cloth.crossing[0].between, &other = across.tile.cloth.crossing[0].between,
                                &again = back.tile.cloth.crossing[0].between;
        QVERIFY(of.retention[1].front != of.retention[2].front); // beside a wet warp, beside a wet weft
        QCOMPARE(other.retention[1].front, of.retention[2].front);
        QCOMPARE(other.retention[2].front, of.retention[1].front);
        QCOMPARE(other.retention[both_wet].front, of.retention[both_wet].front);
        QCOMPARE(other.along_warp, of.along_weft);
        QCOMPARE(again.retention[1].front, of.retention[1].front);
        QCOMPARE(again.on_warp[1], of.on_warp[1]);
    }

    /// Water in a panel that hangs sinks as in a strip of a sample that stands, and half as far in one that slopes by 30 degrees.
    void a_hanging_panel_is_a_strip()
    {
        const auto sunk = [](double slope, bool as_sample) {
            Worn worn;
            add_rectangle(worn.parts.pattern, "front", {0, 0}, 0.004, 0.15);
            for (Vec3d& place : worn.parts.pattern.shape.places)
                place = Vec3d{place.x, place.y * slope, place.y * std::sqrt(1 - slope * slope)};
            worn.wear.initial_water_g_m2 = 60; // the yarns are not full, which would hold it
            GarmentScene garment = worn.scene(2e-3, !as_sample);
            Scene& scene = garment.scene;
            scene.rules.vapour = scene.rules.sorption = scene.rules.heat = false;
            if (as_sample) {
                scene.cloth.panels = {};
                scene.supply.skin = {};
                scene.cloth.gravity_along_warp = gravity_acceleration * slope;
            }
            const Frame end = frame_at(scene, 120);
            std::vector<double> water(garment.cells.size());
            for (std::size_t i = 0; i < water.size(); ++i) {
                const GarmentCell& cell = garment.cells[i];
                const auto weft = static_cast<std::size_t>(scene.cloth.crossings() + cell.pick * scene.cloth.ends + cell.end);
                const auto warp = static_cast<std::size_t>(cell.crossing);
                water[i] = as_sample ? static_cast<double>(end.liquid[warp] + end.liquid[weft]) : end.cells[i].liquid;
            }
            double moment = 0;
            for (std::size_t i = 0; i < water.size(); ++i) moment += water[i] * (0.075 - garment.cells[i].flat[1]);
            return moment / sum(water); // m, of the middle of the water
        };
        const double strip = sunk(1, true), panel = sunk(1, false), sloping = sunk(0.5, false);
        qInfo("the middle of the water sank %.3f mm in a strip, %.3f mm in a panel, %.3f mm in one of half the slope", 1e3 * strip,
              1e3 * panel, 1e3 * sloping);
        QVERIFY(strip > 3e-5);
        QVERIFY(std::abs(panel - strip) < 0.03 * strip);
        QVERIFY(sloping > 0.3 * panel && sloping < 0.7 * panel);
    }

    void water_is_accounted_for()
    {
        Worn worn;
        add_rectangle(worn.parts.pattern, "front", {0, 0}, 0.06, 0.05);
        add_rectangle(worn.parts.pattern, "back", {0.1, 0}, 0.04, 0.05);
        worn.parts.pattern.seams.push_back({0, 1, 1, 3, true});
        worn.parts.sweat.g_m2_h.assign(body_zones().size(), rate);
        const GarmentScene garment = worn.scene(2e-3, true, true);
        const Frame frame = frame_at(garment.scene, 40);
        const Ledger& ledger = frame.ledger;
        QVERIFY(ledger.water_dripped > 0 && ledger.water_free > 0 && ledger.water_evaporated > 0);
        QVERIFY(std::abs(ledger.water_imbalance()) < 1e-9 * ledger.water_delivered);
        QVERIFY(std::abs(ledger.energy_imbalance()) < 1e-9 * std::abs(ledger.energy_lost));
        double skin = 0;
        for (const CellSums& cell : frame.cells) skin += cell.on_skin;
        QVERIFY(std::abs(skin - ledger.water_free) < 1e-12 * skin);
        const double vapour = ledger.water_vapour - frame_at(garment.scene, 0).ledger.water_vapour;
        const double held = sum(water_in_cells(frame)), came = ledger.water_delivered - ledger.water_dripped - ledger.water_free;
        QVERIFY(std::abs(held + vapour + ledger.water_evaporated - came) < 1e-9 * came);
    }

    /// A panel cut along its middle and stitched behaves as uncut.
    void cut_and_stitched_data()
    {
        QTest::addColumn<bool>("across_warp");
        QTest::newRow("across the warp") << true;
        QTest::newRow("along the warp") << false;
    }
    void cut_and_stitched()
    {
        QFETCH(bool, across_warp);
        Worn whole, cut;
        const Fabric& fabric = whole.design.fabrics[0];
        constexpr int cells = 40, k = 4;
        const double width = cells * k * 1e-2 / fabric.ends_per_cm, height = cells * k * 1e-2 / fabric.picks_per_cm;
        const double side = k * 1e-2 / std::sqrt(fabric.ends_per_cm * fabric.picks_per_cm);
        add_rectangle(whole.parts.pattern, "whole", {0, 0}, width, height);
        if (across_warp) {
            add_rectangle(cut.parts.pattern, "low", {0, 0}, width, 0.5 * height);
            add_rectangle(cut.parts.pattern, "high", {0, 0.5 * height}, width, 0.5 * height);
            cut.parts.pattern.seams.push_back({0, 2, 1, 0, true});
        } else {
            add_rectangle(cut.parts.pattern, "left", {0, 0}, 0.5 * width, height);
            add_rectangle(cut.parts.pattern, "right", {0.5 * width, 0}, 0.5 * width, height);
            cut.parts.pattern.seams.push_back({0, 1, 1, 3, true});
        }
        GarmentScene one = whole.scene(side), two = cut.scene(side);
        QCOMPARE(one.cells.size(), two.cells.size());
        const FlatPlace middle{0.45 * width, 0.45 * height};
        for (GarmentScene* garment : {&one, &two}) sweat_in_circle(*garment, middle, 3e-3, 4 * rate);
        const std::vector<double> uncut = water_in_cells(frame_at(one.scene, 10)), stitched = water_in_cells(frame_at(two.scene, 10));
        std::vector<double> sorted(stitched.size());
        std::map<std::array<int, 2>, double> by_place;
        const auto key = [&](const FlatPlace& flat) {
            return std::array{static_cast<int>(flat[0] * 1e5 + 0.5), static_cast<int>(flat[1] * 1e5 + 0.5)};
        };
        for (std::size_t i = 0; i < stitched.size(); ++i) by_place[key(two.cells[i].flat)] = stitched[i];
        for (std::size_t i = 0; i < uncut.size(); ++i) sorted[i] = by_place.at(key(one.cells[i].flat));
        double beyond = 0, beyond_uncut = 0; // the seam, from the fed side
        for (std::size_t i = 0; i < uncut.size(); ++i)
            if (across_warp ? one.cells[i].flat[1] > 0.5 * height : one.cells[i].flat[0] > 0.5 * width) {
                beyond += sorted[i];
                beyond_uncut += uncut[i];
            }
        qInfo("beyond the seam %.4g mg, uncut %.4g mg; all %.4g and %.4g mg; maps differ by %.2f %%", 1e6 * beyond, 1e6 * beyond_uncut,
              1e6 * sum(sorted), 1e6 * sum(uncut), 100 * difference(uncut, sorted));
        QVERIFY(beyond_uncut > 0.1 * sum(uncut));
        QVERIFY(std::abs(sum(sorted) - sum(uncut)) < 0.01 * sum(uncut));
        QVERIFY(std::abs(beyond - beyond_uncut) < 0.03 * beyond_uncut);
        QVERIFY(difference(uncut, sorted) < 0.03);
    }

    /// However large cells are, a panel has about its area in them, and its left half as many as its right one.
    void cells_have_their_panels_area_data()
    {
        QTest::addColumn<double>("side");
        QTest::addColumn<double>("within");
        QTest::newRow("20 mm") << 0.020 << 0.03;
        QTest::newRow("12 mm") << 0.012 << 0.02;
        QTest::newRow("6 mm") << 0.006 << 0.01;
    }
    void cells_have_their_panels_area()
    {
        QFETCH(double, side);
        QFETCH(double, within);
        for (const std::string& kind : built_in_garments()) {
            Garment garment;
            garment.built_in = standard_garment(kind);
            const GarmentPattern pattern = read_pattern(garment, {});
            for (const PatternPanel& panel : pattern.panels) {
                for (const double wider : {1.0, 1.1, 1.2}) { // so that panels are of other numbers of cells
                    const double pitch = wider * side;
                    const PanelGrid grid = panel_grid(panel, 0, pitch, pitch);
                    const auto cells = static_cast<double>(std::count(grid.there.begin(), grid.there.end(), 1));
                    const double off = cells * pitch * pitch / area_of(panel) - 1;
                    QVERIFY2(std::abs(off) < within, qPrintable(QString("%1, %2: %3").arg(kind.c_str(), panel.name.c_str()).arg(off)));
                    if (kind == "leggings") continue; // whose panels are not symmetric
                    for (int end = 0; end < grid.ends; ++end)
                        for (int pick = 0; pick < grid.picks; ++pick) QCOMPARE(grid.has(end, pick), grid.has(grid.ends - 1 - end, pick));
                }
            }
        }
    }
    void a_taped_seam_passes_nothing()
    {
        Worn worn;
        add_rectangle(worn.parts.pattern, "low", {0, 0}, 0.02, 0.02);
        add_rectangle(worn.parts.pattern, "high", {0, 0.02}, 0.02, 0.02);
        worn.parts.pattern.seams.push_back({0, 2, 1, 0, true});
        worn.garment.seams["high|low"] = 0;
        GarmentScene garment = worn.scene(1e-3);
        sweat_in_circle(garment, {0.01, 0.016}, 3e-3, 60 * rate);
        garment.scene.rules.shows_segments = true;
        const Frame frame = frame_at(garment.scene, 10);
        const std::vector<double> water = water_in_cells(frame);
        double low = 0;
        for (std::size_t i = 0; i < water.size(); ++i) {
            if (garment.cells[i].panel == 0)
                low += water[i];
            else
                QCOMPARE(frame.saturation[static_cast<std::size_t>(garment.cells[i].crossing)], 0.0F);
        }
        QVERIFY(low > 0);
    }

    /// Textile C spreads farther along one system than along the other.
    void grain_turns_the_stain()
    {
        const auto moments = [](double grain) {
            Worn worn("Textile C");
            worn.garment.panels["*"].grain_deg = grain;
            add_rectangle(worn.parts.pattern, "piece", {-0.02, -0.02}, 0.04, 0.04);
            GarmentScene garment = worn.scene(0.6e-3);
            sweat_in_circle(garment, {0, 0}, 2e-3, 60 * rate);
            return spread(garment, water_in_cells(frame_at(garment.scene, 5)));
        };
        const std::array<double, 2> straight = moments(0), turned = moments(90), oblique = moments(45);
        qInfo("grain 0: %.4g %.4g mm2; 90: %.4g %.4g; 45: %.4g %.4g", 1e6 * straight[0], 1e6 * straight[1], 1e6 * turned[0],
              1e6 * turned[1], 1e6 * oblique[0], 1e6 * oblique[1]);
        QVERIFY(straight[1] > 1.3 * straight[0] || straight[0] > 1.3 * straight[1]);
        for (std::size_t k = 0; k < 2; ++k) QVERIFY(std::abs(turned[k] - straight[1 - k]) < 0.02 * straight[1 - k]);
        QVERIFY(std::abs(oblique[0] - oblique[1]) < 0.02 * oblique[0]);
    }
};

QTEST_GUILESS_MAIN(TestGarmentScene)
#include "tst_garment_scene.moc"
