// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Flow through the layer, its two halves, and down to how little liquid runs on.
#include "core/room/room_details.h"
#include "core/room/room_flow.h"
#include "tests/room/square_cotton.h"

#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace {

/// A square hole through a solid layer, as wide as said, in voxels of 1 um.
DrawnLayer square_hole(int width)
{
    DrawnLayer layer;
    layer.per_end = layer.per_pick = width + 4;
    layer.dx = layer.dy = layer.dz = 1e-6;
    layer.grid = {layer.per_end, layer.per_pick, 6, true, false};
    layer.reach = 1e-5;
    layer.outside.resize(layer.grid.size());
    for (int z = 0; z < layer.grid.nz; ++z)
        for (int y = 0; y < layer.grid.ny; ++y)
            for (int x = 0; x < layer.grid.nx; ++x) {
                const auto inside = [&](int at) { return 0.5 * width - std::abs(at + 0.5 - 0.5 * layer.per_end); };
                layer.outside[layer.grid.at(x, y, z)] = static_cast<float>(1e-6 * std::min(inside(x), inside(y)));
            }
    return layer;
}

RoomDetails details(const Textile& textile, int voxels = 14) { return room_details(textile, *room_tables(textile, 14), voxels).value(); }

} // namespace

class TestRoomDetails : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aHoleConductsAsASquareTube()
    {
        const double exact = 0.035144 * std::pow(12, 4) / (16 * 16) * 1e-12, found = permeability_through(square_hole(12), 0);
        QVERIFY2(near_to(found, exact, 0.03), qPrintable(QString::number(found / exact)));
        QVERIFY(room_permeability(square_hole(12), 0).warp.mean < 1e-6 * exact); // solid on all its sides
    }
    void facesOfPlainClothAreAlike()
    {
        const Textile textile = square_cotton("plain");
        const RoomDetails found = details(textile);
        const DrawnRoom& room = room_tables(textile, 14)->types[0];
        QVERIFY(near_to(found.upper.open, found.lower.open, 1e-3));
        for (const RoomHalf& half : {found.upper, found.lower}) {
            QVERIFY2(near_to(half.along_warp, room.along_warp, 0.01), qPrintable(QString::number(half.along_warp / room.along_warp)));
            QVERIFY(near_to(half.along_weft, room.along_weft, 0.01));
        }
        QVERIFY2(found.through > 0.5 * room.along_warp && found.through < 5 * room.along_warp, qPrintable(QString::number(found.through)));
    }
    /// Of satin the ends lie on one face and the picks on the other: each lets liquid run along its own grooves.
    void facesOfSatinAreEachOthers()
    {
        const RoomDetails found = details(square_cotton("satin 5/2"));
        QVERIFY2(near_to(found.upper.along_warp, found.lower.along_weft, 0.02),
                 qPrintable(QString::number(found.upper.along_warp / found.lower.along_weft)));
        QVERIFY2(found.upper.along_warp > 1.3 * found.lower.along_warp,
                 qPrintable(QString::number(found.upper.along_warp / found.lower.along_warp)));
        const double mean = 0.5 * (found.upper.along_warp + found.lower.along_warp);
        QVERIFY(near_to(mean, room_tables(square_cotton("satin 5/2"), 14)->types[0].along_warp, 1e-3));
    }
    void theThickerYarnsTakeRoomOnTheirFace()
    {
        const RoomDetails found = details(square_cotton("satin 5/2", {20, 40}));
        QVERIFY2(found.upper.open > found.lower.open + 0.02,
                 qPrintable(QString::number(found.upper.open - found.lower.open))); // picks lie below
    }
    void liquidRunsOnDownToAThreshold()
    {
        for (const char* weave : {"plain", "twill 2/2 Z", "rib 2/2 warp"}) {
            const RoomDetails found = details(square_cotton(weave));
            for (double least : {found.connected_along_warp, found.connected_along_weft}) QVERIFY(least > 0.005 && least < 0.5);
        }
        const RoomDetails rib = details(square_cotton("rib 2/2 warp"), 32);
        QVERIFY2(rib.connected_along_weft < 0.75 * rib.connected_along_warp, "the groove between two picks in one shed");
    }
};

QTEST_APPLESS_MAIN(TestRoomDetails)
#include "tst_room_details.moc"
