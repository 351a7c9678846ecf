// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The smallest cell of a weave, and rooms drawn as it: as those of the whole period.
#include "core/room/kept_tables.h"
#include "core/room/room_flow.h"
#include "tests/room/square_cotton.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace hygroloom;

namespace {

/// Another weave of as many threads: at(end, pick) says where the warp is up.
template <typename At> Weave woven(int ends, int picks, const At& at)
{
    std::vector<std::uint8_t> up;
    for (int pick = 0; pick < picks; ++pick)
        for (int end = 0; end < ends; ++end) up.push_back(at(end, pick) ? 1 : 0);
    return {ends, picks, up};
}

double apart(double a, double b) { return std::abs(a - b) / std::max(1e-300, std::abs(b)); }
double apart(const DrawnRoom& a, const DrawnRoom& b)
{
    return std::max({apart(a.warp_skin, b.warp_skin), apart(a.weft_skin, b.weft_skin), apart(a.faces, b.faces),
                     apart(a.along_warp, b.along_warp), apart(a.along_weft, b.along_weft)});
}
float place(const RoomTables& tables, const std::vector<float>& places, int end, int pick)
{
    return places[WovenCell{tables.ends, tables.picks}.crossing(end, pick)];
}

} // namespace

class TestWovenCell : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theCellOfAWeaveIsWhatTheClothRepeats_data()
    {
        QTest::addColumn<int>("ends");
        QTest::addColumn<int>("picks");
        QTest::addColumn<int>("shift"); // less than 0: not by hand
        QTest::newRow("plain") << 1 << 2 << 1;
        QTest::newRow("twill 2/1 Z") << 1 << 3 << 1;
        QTest::newRow("twill 2/1 S") << 1 << 3 << 2;
        QTest::newRow("satin 5/2") << 1 << 5 << -1;
        QTest::newRow("satin 8/3") << 1 << 8 << -1;
        QTest::newRow("twill 3/2 Z steep 2") << 1 << 5 << 2;
        QTest::newRow("twill 3/2 Z reclined 2") << 1 << 5 << 3; // two ends are one pick
        QTest::newRow("rib 2/2 warp") << 1 << 4 << 2;
        QTest::newRow("rib 2/2 weft") << 2 << 2 << 1;
        QTest::newRow("basket 2/2") << 2 << 4 << 2;
        QTest::newRow("satin 4") << 4 << 4 << 0; // irregular
        QTest::newRow("pointed twill 2/2 Z 4") << 6 << 4 << 0;
    }
    void theCellOfAWeaveIsWhatTheClothRepeats()
    {
        QFETCH(int, ends);
        QFETCH(int, picks);
        QFETCH(int, shift);
        const Weave weave = weave_from_pattern(QTest::currentDataTag());
        const auto cell = smallest_cell(weave, 64);
        QVERIFY(cell.has_value());
        QCOMPARE(cell->ends, ends);
        QCOMPARE(cell->picks, picks);
        if (shift >= 0) QCOMPARE(cell->shift, shift);
        QCOMPARE(cell->ends_of_period(), weave.ends());
        for (int end = -9; end < 20; ++end)
            for (int pick = -9; pick < 20; ++pick) {
                const auto at = static_cast<int>(cell->crossing(end, pick));
                QCOMPARE(weave.warp_up(end, pick), weave.warp_up(at / picks, at % picks));
            }
        QVERIFY(!smallest_cell(weave, ends * picks - 1));
    }
    void distancesGoOnInTheNextCell()
    {
        const int wide = 5, high = 12, skew = 8, deep = 4;
        const VoxelGrid cell{wide, high, deep, true, false, skew}, whole{3 * wide, high, deep, true, false};
        std::mt19937 random(3);
        std::vector<std::uint8_t> marked(cell.size()), all(whole.size());
        for (int i = 0; i < 4; ++i) marked[random() % marked.size()] = 1;
        const auto each = [&](const auto& visit) {
            for (int z = 0; z < deep; ++z)
                for (int y = 0; y < high; ++y)
                    for (int x = 0; x < whole.nx; ++x) {
                        int u = x, v = y;
                        cell.wrap(u, v);
                        visit(whole.at(x, y, z), cell.at(u, v, z));
                    }
        };
        each([&](std::size_t in_whole, std::size_t in_cell) { all[in_whole] = marked[in_cell]; });
        const std::vector<int> found = squared_distances(cell, marked), expected = squared_distances(whole, all);
        each([&](std::size_t in_whole, std::size_t in_cell) { QCOMPARE(found[in_cell], expected[in_whole]); });
    }
    void aCellHasTheTablesOfThePeriod_data()
    {
        QTest::addColumn<int>("voxels");
        for (const char* weave : {"twill 2/2 Z", "twill 2/1 Z", "twill 3/1 S", "satin 5/2", "twill 3/2 Z steep 2"})
            QTest::newRow(weave) << 10;
        QTest::newRow("basket 2/2") << 10; // two ends wide
        QTest::newRow("satin 8/3") << 8;
        for (const char* fabric : {"Denim", "Drill", "Cotton sateen"}) QTest::newRow(fabric) << 8;
        QTest::newRow("twill 1/2 Z") << 24; // by Stokes flow
    }
    void aCellHasTheTablesOfThePeriod()
    {
        QFETCH(int, voxels);
        const std::string name = QTest::currentDataTag();
        const Textile textile = std::islower(name[0]) ? square_cotton(weave_from_pattern(name)) : patch_of(library_fabric(name));
        const auto smallest = smallest_cell(textile.weave, 64);
        const int ends = textile.weave.ends(), picks = textile.weave.picks();
        QVERIFY(smallest && smallest->crossings() < ends * picks);
        const RoomTables cell = tables_of_cell(textile, *smallest, voxels), whole = tables_of_cell(textile, {ends, picks}, voxels);
        constexpr double rounding = 1e-6;
        const auto near = [](double a, double b) { return apart(a, b) < rounding; };
        QVERIFY2(apart(cell.types[0], whole.types[0]) < rounding, qPrintable(QString::number(apart(cell.types[0], whole.types[0]))));
        QVERIFY(std::abs(cell.growth - whole.growth) < rounding * textile.thickness);
        QVERIFY(near(cell.falls_along_warp, whole.falls_along_warp) && near(cell.falls_along_weft, whole.falls_along_weft));
        QCOMPARE(cell.ends, whole.ends);
        QCOMPARE(cell.picks, whole.picks);
        QCOMPARE(cell.warp_places.size(), whole.warp_places.size());
        for (std::size_t i = 0; i < whole.warp_places.size(); ++i) {
            QVERIFY(near(double(cell.warp_places[i]), double(whole.warp_places[i])));
            QVERIFY(near(double(cell.weft_places[i]), double(whole.weft_places[i])));
        }
    }
    void mirroredTwillHasMirroredTables()
    {
        const Weave right = weave_from_pattern("twill 2/1/1/2 Z");
        const int n = right.ends();
        const auto turned = [n](int i) { return n - 1 - i; };
        const Weave left = woven(n, n, [&](int end, int pick) { return right.warp_up(end, turned(pick)); });
        QVERIFY(smallest_cell(left, 64)->shift == n - smallest_cell(right, 64)->shift);
        const RoomTables &z = *room_tables(square_cotton(right), 10), &s = *room_tables(square_cotton(left), 10);
        QVERIFY(apart(z.types[0], s.types[0]) < 1e-3);
        for (int end = 0; end < n; ++end)
            for (int pick = 0; pick < n; ++pick) {
                const double warp = apart(double(place(s, s.warp_places, end, pick)), double(place(z, z.warp_places, end, turned(pick))));
                QVERIFY(warp < 0.02); // along it flow is counted on the upper sides of voxels
                QVERIFY(apart(double(place(s, s.weft_places, end, pick)), double(place(z, z.weft_places, end, turned(pick)))) < 1e-3);
            }
    }
    void turnedClothSwapsWarpAndWeft()
    {
        const Weave satin = weave_from_pattern("satin 5/2");
        const int n = satin.ends();
        const Weave turned = woven(n, n, [&](int end, int pick) { return !satin.warp_up(pick, end); });
        const RoomTables &a = *room_tables(square_cotton(satin), 10), &b = *room_tables(square_cotton(turned), 10);
        const DrawnRoom &from = a.types[0], &to = b.types[0];
        QVERIFY(apart(from, {to.weft_skin, to.warp_skin, to.faces, to.along_weft, to.along_warp, {}}) < 1e-3);
        QVERIFY2(apart(a.falls_along_warp, b.falls_along_weft) < 1e-3,
                 qPrintable(QString("%1 for %2").arg(a.falls_along_warp).arg(b.falls_along_weft)));
        for (int end = 0; end < n; ++end)
            for (int pick = 0; pick < n; ++pick)
                QVERIFY(apart(double(place(a, a.warp_places, end, pick)), double(place(b, b.weft_places, pick, end))) < 1e-3);
    }
    void aLargeSatinIsDrawnByPlaces()
    {
        const RoomTables& tables = *room_tables(square_cotton("satin 12/5"), 8); // 144 crossings, of which 12 are drawn
        QCOMPARE(tables.ends, 12);
        QCOMPARE(tables.warp_places.size(), std::size_t(144));
    }
};

QTEST_APPLESS_MAIN(TestWovenCell)
#include "tst_woven_cell.moc"
