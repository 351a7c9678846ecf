// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Seams of panels that are cut on the bias: against the same cloth uncut, and by the size of cells.
#include "tests/wear/flat_garment.h"

#include <QTest>

#include <map>

using namespace hygroloom;

namespace tst_seams {
namespace {

constexpr double width = 0.128, height = 0.128, seam_at = 0.064; // m: 224 ends beside the seam, whole cells of 8 and 14
constexpr double rate = 3000, seconds = 300;                     // g/m2 h: 250 g/m2, of which cloth that is fed keeps about 150

/// Cells of so many crossings.
double side_of(const Fabric& fabric, int crossings) { return crossings * 1e-2 / std::sqrt(fabric.ends_per_cm * fabric.picks_per_cm); }

/// A square of one cloth, cut along its middle and stitched or not, sweats on one side of the cut. Returns the share of the sweat
/// that passes, which does not depend on how well cells fill the side.
double passed(int crossings, double left, double right, bool is_cut)
{
    Worn worn;
    GarmentPattern& pattern = worn.parts.pattern;
    const PanelCut cut = worn.garment.panels["*"];
    if (is_cut) {
        add_rectangle(pattern, "left", {0, 0}, seam_at, height);
        add_rectangle(pattern, "right", {seam_at, 0}, width - seam_at, height);
        pattern.seams.push_back({0, 1, 1, 3, true});
        worn.garment.panels["left"] = {cut.fabric, left};
        worn.garment.panels["right"] = {cut.fabric, right};
    } else {
        add_rectangle(pattern, "whole", {0, 0}, width, height);
        worn.garment.panels["whole"] = {cut.fabric, left};
    }
    GarmentScene garment = worn.scene(side_of(worn.design.fabrics[0], crossings));
    for (const GarmentCell& cell : garment.cells)
        garment.scene.supply.skin.rate[static_cast<std::size_t>(cell.crossing)] =
            cell.flat[0] < seam_at ? 1e-3 * rate / 3600 / garment.scene.climate.density : 0.0;
    garment.scene.rules.vapour = garment.scene.rules.sorption = garment.scene.rules.heat = false;
    const std::vector<double> water = water_in_cells(frame_at(garment.scene, seconds));
    double beyond = 0, all = 0;
    for (std::size_t k = 0; k < water.size(); ++k) {
        all += water[k];
        if (garment.shown.cells[k].flat[0] > seam_at) beyond += water[k];
    }
    return beyond / all;
}

/// kg in the cells of two panels that are sewn together on both sides, or of one that is sewn to itself, by where they lie flat, where it
/// sweats on the last 32 mm of the front half, or of the other.
std::map<std::pair<int, int>, double> water_in_tube(bool front, bool of_one, bool with_heat, double time)
{
    Worn worn;
    GarmentPattern& pattern = worn.parts.pattern;
    if (of_one) {
        add_rectangle(pattern, "all", {0, 0}, 0.128, 0.032);
        pattern.seams = {{0, 1, 0, 3, true}};
    } else {
        add_rectangle(pattern, "front", {0, 0}, 0.064, 0.032);
        add_rectangle(pattern, "back", {0.064, 0}, 0.064, 0.032);
        pattern.seams = {{0, 1, 1, 3, true}, {1, 1, 0, 3, true}};
    }
    GarmentScene garment = worn.scene(side_of(worn.design.fabrics[0], 8));
    for (const GarmentCell& cell : garment.cells) {
        const double end = front ? 0.064 : 0.128;
        const bool sweats = cell.flat[0] < end && cell.flat[0] > end - 0.032;
        garment.scene.supply.skin.rate[static_cast<std::size_t>(cell.crossing)] =
            sweats ? 1e-3 * rate / 3600 / garment.scene.climate.density : 0.0;
    }
    if (!with_heat) garment.scene.rules.vapour = garment.scene.rules.sorption = garment.scene.rules.heat = false;
    const std::vector<double> water = water_in_cells(frame_at(garment.scene, time));
    std::map<std::pair<int, int>, double> found;
    for (std::size_t k = 0; k < water.size(); ++k) {
        const std::array<double, 2>& flat = garment.shown.cells[k].flat;
        found[{static_cast<int>(std::lround(1e5 * flat[0])), static_cast<int>(std::lround(1e5 * flat[1]))}] += water[k];
    }
    return found;
}

} // namespace

class TestSeams : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Which of a cell's yarns are nearer to the way out at 45 degrees is rounding, and differs with the size of cells: 7, 14 and 28
    /// crossings round one way, others the other way. Yarns at angles meet the other system of the next panel.
    void any_grain_passes_as_uncut_data()
    {
        QTest::addColumn<double>("left");
        QTest::addColumn<double>("right");
        QTest::addColumn<double>("least");
        QTest::newRow("straight, straight") << 0.0 << 0.0 << 0.92;
        QTest::newRow("straight, across") << 0.0 << 90.0 << 0.92;
        QTest::newRow("straight, bias") << 0.0 << 45.0 << 0.78; // each system of the bias is cut by a third less often
        QTest::newRow("bias, straight") << 45.0 << 0.0 << 0.91;
        QTest::newRow("bias, bias") << 45.0 << 45.0 << 0.92;
        QTest::newRow("bias, other bias") << 45.0 << -45.0 << 0.92;
        QTest::newRow("30, -60") << 30.0 << -60.0 << 0.92;
    }
    void any_grain_passes_as_uncut()
    {
        QFETCH(double, left);
        QFETCH(double, right);
        QFETCH(double, least);
        double low = 1e300, high = 0;
        static std::map<double, double> uncut;
        if (!uncut.contains(left)) uncut[left] = passed(8, left, left, false);
        const double whole = uncut[left];
        for (int crossings : {8, 14}) {
            const double cut = passed(crossings, left, right, true);
            qInfo("%d crossings a cell: %.4f of the sweat pass the seam, uncut %.4f", crossings, cut, whole);
            QVERIFY(cut > least * whole && cut < 1.08 * whole);
            low = std::min(low, cut);
            high = std::max(high, cut);
        }
        QVERIFY(high < 1.08 * low);
    }

    /// No seam of a ring is its last: wherever a tube is fed, water spreads from there alike.
    void a_tube_is_alike_all_around_data()
    {
        QTest::addColumn<bool>("of_one");
        QTest::addColumn<bool>("with_heat");
        QTest::addColumn<double>("time");
        QTest::addColumn<double>("passes");
        QTest::addColumn<double>("most_elsewhere");
        QTest::newRow("two panels") << false << false << 60.0 << 0.001 << 1e-9; // later rounding grows at bends
        QTest::newRow("two panels, longer") << false << false << seconds << 0.2 << 0.02;
        QTest::newRow("one panel") << true << false << seconds << 0.2 << 0.01;
        QTest::newRow("two panels that warm up") << false << true << 120.0 << 0.001 << 1e-3;
    }
    void a_tube_is_alike_all_around()
    {
        QFETCH(bool, of_one);
        QFETCH(bool, with_heat);
        QFETCH(double, time);
        QFETCH(double, passes);
        QFETCH(double, most_elsewhere);
        constexpr int half = 6400; // of the way around, in 10 um
        const auto one = water_in_tube(true, of_one, with_heat, time), other = water_in_tube(false, of_one, with_heat, time);
        QCOMPARE(one.size(), other.size());
        double all = 0, apart = 0, beyond = 0;
        for (const auto& [at, mass] : one) {
            const auto turned = other.find({(at.first + half) % (2 * half), at.second});
            QVERIFY(turned != other.end());
            all += mass;
            apart += std::abs(turned->second - mass);
            if (at.first > half) beyond += mass;
        }
        qInfo("%.4f of the water passes to the other half; fed there, %.2g lies elsewhere", beyond / all, 0.5 * apart / all);
        QVERIFY(beyond > passes * all);
        QVERIFY(0.5 * apart < most_elsewhere * all);
    }

    /// However a panel lies in the cloth, its cells are counted by the ends and picks of its fabric.
    void cells_are_shown_as_woven()
    {
        Worn worn;
        add_rectangle(worn.parts.pattern, "left", {0, 0}, 0.05, 0.03);
        add_rectangle(worn.parts.pattern, "right", {0.05, 0}, 0.04, 0.03);
        worn.parts.pattern.seams.push_back({0, 1, 1, 3, true});
        worn.garment.panels["right"] = {worn.garment.panels["*"].fabric, 90};
        const GarmentScene garment = worn.scene(3e-3);
        QVERIFY(!garment.fabrics[static_cast<std::size_t>(garment.fabric[0])].turned);
        QVERIFY(garment.fabrics[static_cast<std::size_t>(garment.fabric[1])].turned);
        QVERIFY(garment.scene.cloth.seams.joints.empty()); // all became chains
        const std::vector<PanelGrid>& grids = garment.shown.grids;
        QVERIFY(grids[0].along[1] > 2e-3 && std::abs(grids[0].along[0]) < 1e-9);
        QVERIFY(grids[1].along[0] < -2e-3 && std::abs(grids[1].along[1]) < 1e-9); // the warp, turned by a right angle
        for (const GarmentCell& cell : garment.shown.cells) {
            const PanelGrid& grid = grids[static_cast<std::size_t>(cell.panel)];
            QVERIFY(grid.has(cell.end, cell.pick));
            QVERIFY(std::hypot(grid.middle(cell.end, cell.pick)[0] - cell.flat[0], grid.middle(cell.end, cell.pick)[1] - cell.flat[1]) <
                    1e-9);
        }
    }
};

} // namespace tst_seams

QTEST_GUILESS_MAIN(tst_seams::TestSeams)
#include "tst_seams.moc"
