// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The room between the yarns of a drawn cloth: flow in slots, weaves against each other, and what must not matter.
#include "core/base/units.h"
#include "core/room/kept_tables.h"
#include "core/room/room_flow.h"

#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace {

/// Walls across x that leave a slot between them, as wide as said, in voxels of 1 um.
DrawnLayer slot(int width)
{
    DrawnLayer layer;
    layer.per_end = width + 4;
    layer.per_pick = 4;
    layer.dx = layer.dy = layer.dz = 1e-6;
    layer.grid = {layer.per_end, 8, 6, true, false};
    layer.reach = 1e-5;
    layer.outside.resize(layer.grid.size());
    for (int z = 0; z < 6; ++z)
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < layer.per_end; ++x) {
                const double from_middle = std::abs(x + 0.5 - 0.5 * layer.per_end);
                layer.outside[layer.grid.at(x, y, z)] = static_cast<float>(1e-6 * (0.5 * width - from_middle));
            }
    return layer;
}

/// Square cotton of 20 tex in this weave, 24 x 24 to the cm; wider: all lengths by this factor.
/// round: yarns keep their section, in floats too.
Textile cloth(const std::string& weave, double ends_per_cm = 24, double picks_per_cm = 24, double wider = 1, bool round = false,
              int threads = 20)
{
    Fabric fabric;
    fabric.name = "Square";
    for (Yarn* yarn : {&fabric.warp, &fabric.weft}) {
        *yarn = Yarn{};
        yarn->material = {{"cotton"}};
        yarn->linear_density_tex = 20 * wider * wider;
        yarn->packing_factor = 0.5;
        yarn->twist_per_m = 700 / wider; // as flat as a finer one
        yarn->diameter_mm.reset();
        if (round) {
            yarn->diameter_mm = 0.18 * wider;
            yarn->linear_density_tex.reset();
        }
    }
    fabric.ends_per_cm = ends_per_cm / wider;
    fabric.picks_per_cm = picks_per_cm / wider;
    fabric.weave = weave_from_pattern(weave);
    Design design;
    design.fabrics = {fabric};
    return build_textile(design, design.fabrics[0], {0, 0, threads, threads});
}

} // namespace

class TestDrawnRoom : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aSlotConductsAsItsWidthCubed_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<double>("most"); // error
        QTest::newRow("4") << 4 << 0.14;
        QTest::newRow("8") << 8 << 0.04;
        QTest::newRow("16") << 16 << 0.01;
    }
    void aSlotConductsAsItsWidthCubed()
    {
        QFETCH(int, width);
        QFETCH(double, most);
        const RoomPermeability found = room_permeability(slot(width), 0);
        const double exact = std::pow(1e-6 * width, 3) / 12 / (1e-6 * (width + 4));
        QVERIFY2(std::abs(found.warp.mean / exact - 1) < most, qPrintable(QString::number(found.warp.mean / exact)));
        QVERIFY(found.weft.mean < 1e-6 * exact); // walls stand in the way
        for (double place : found.warp.places) QVERIFY(std::abs(place / found.warp.mean - 1) < 1e-3);
    }
    void growingYarnsCloseASlot()
    {
        const DrawnLayer layer = slot(16);
        QVERIFY(std::abs(growth_to_share(layer, 16.0 / 20) / 1e-6) < 0.01);
        QVERIFY(std::abs(growth_to_share(layer, 10.0 / 20) / 1e-6 - 3) < 0.01);
        const double narrow = room_permeability(layer, 3e-6).warp.mean, exact = std::pow(10e-6, 3) / 12 / 20e-6;
        QVERIFY2(std::abs(narrow / exact - 1) < 0.03, qPrintable(QString::number(narrow / exact)));
    }
    void theSkinOfLooseYarnsIsTheirOutline()
    {
        Textile textile = cloth("plain", 6, 6); // far apart
        textile.warp.count = textile.weft.count = 2;
        const RoomSkin skin = skin_of_room(textile, 0);
        const YarnType& yarn = textile.warp.types[0];
        const double outline = pi * yarn.section.height + 2 * (yarn.section.width - yarn.section.height),
                     all = outline * yarn.length_per_pitch[0] * textile.weft.pitch, hidden = yarn.section.width * yarn.section.width;
        for (const std::vector<double>* of : {&skin.warp, &skin.weft})
            for (double area : *of) QVERIFY2(area < all && area > all - 1.3 * hidden, qPrintable(QString::number(area / all)));
        for (double faces : skin.faces)
            QVERIFY(faces <= 2 * textile.warp.pitch * textile.weft.pitch && faces > 1.9 * textile.warp.pitch * textile.weft.pitch);
    }
    void theRoomHasTheVolumeThatYarnsLeave()
    {
        const Textile textile = cloth("plain", 24, 24, 1, false, 4);
        const DrawnLayer layer = drawn_layer(textile, 16);
        QCOMPARE(layer.ends(), 4);
        const YarnType& yarn = textile.warp.types[0];
        const double share = 1 - 2 * yarn.area * yarn.length_per_pitch[0] / (textile.thickness * textile.warp.pitch);
        const RoomTables& tables = *room_tables(textile, 16);
        QCOMPARE(tables.ends, 2);
        QVERIFY2(std::abs(tables.growth - growth_to_share(layer, share)) < 1e-3 * textile.thickness, "of any number of periods");
        const double finer = share_outside(drawn_layer(textile, 28), tables.growth);
        QVERIFY2(std::abs(finer - share) < 0.005, qPrintable(QString("%1 for %2").arg(finer).arg(share)));
    }
    void longerFloatsLetMoreThrough()
    {
        const auto along = [](const char* weave) { return room_tables(cloth(weave, 24, 24, 1, true), 12)->types[0].along_warp; };
        const double plain = along("plain"), rib = along("rib 2/2 warp"), twill = along("twill 2/2 Z"), satin = along("satin 5/2");
        QVERIFY2(plain > 2e-10 && plain < 9e-10, qPrintable(QString::number(plain)));
        QVERIFY2(rib > 0.9 * plain && twill > 1.1 * plain && satin > 1.1 * plain,
                 qPrintable(QString("%1 %2 %3 %4").arg(plain).arg(rib).arg(twill).arg(satin)));
    }
    void turnedClothHasTurnedTables()
    {
        const RoomTables &rib = *room_tables(cloth("rib 2/2 warp"), 12), &turned = *room_tables(cloth("rib 2/2 weft"), 12);
        const auto near = [](double a, double b) { return std::abs(a / b - 1) < 1e-3; };
        QVERIFY(rib.types[0].along_weft > 1.2 * rib.types[0].along_warp);
        QVERIFY(near(rib.types[0].along_warp, turned.types[0].along_weft));
        QVERIFY(near(rib.types[0].along_weft, turned.types[0].along_warp));
        QVERIFY(near(rib.types[0].warp_skin, turned.types[0].weft_skin));
        const RoomTables& plain = *room_tables(cloth("plain"), 12);
        QVERIFY(near(plain.types[0].along_warp, plain.types[0].along_weft));
        for (float place : plain.warp_places) QVERIFY(std::abs(double(place) - 1) < 1e-2); // all places are alike
    }
    void permeabilityGoesWithTheSquareOfLengths()
    {
        const DrawnRoom small = room_tables(cloth("twill 2/2 Z"), 12)->types[0],
                        large = room_tables(cloth("twill 2/2 Z", 24, 24, 2), 12)->types[0];
        QVERIFY(std::abs(large.along_warp / small.along_warp / 4 - 1) < 0.02);
        QVERIFY(std::abs(large.warp_skin / small.warp_skin / 4 - 1) < 0.02);
    }
    void placesOfAFloatDifferAndJoinToTheMean()
    {
        const RoomTables& tables = *room_tables(cloth("satin 5/2"), 12);
        QCOMPARE(tables.warp_places.size(), std::size_t(25));
        const auto [least, most] = std::minmax_element(tables.warp_places.begin(), tables.warp_places.end());
        QVERIFY2(*most > 1.2F * *least, qPrintable(QString("%1 %2").arg(double(*least)).arg(double(*most))));
        QVERIFY(tables.falls_along_warp >= 1 && tables.falls_along_warp <= 4);
    }
    void aLargeWeaveIsDrawnInPart()
    {
        std::vector<std::uint8_t> up(20 * 20);
        for (int pick = 0; pick < 20; ++pick)
            for (int end = 0; end < 20; ++end) up[static_cast<std::size_t>(20 * pick + end)] = (end + pick) % 2;
        Textile textile = cloth("plain");
        const double plain = room_tables(textile, 8)->types[0].along_warp;
        up[399] ^= 1;
        textile.weave = Weave(20, 20, up);
        const RoomTables& tables = *room_tables(textile, 8);
        QVERIFY(tables.warp_places.empty());
        QVERIFY(std::abs(tables.types[0].along_warp / plain - 1) < 0.02);
    }
};

QTEST_APPLESS_MAIN(TestDrawnRoom)
#include "tst_drawn_room.moc"
