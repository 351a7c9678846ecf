// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Liquid at rest in the room between yarns: its energy, its scale, its directions, and what follows for real cloths.
#include "core/room/kept_tables.h"
#include "core/room/room_menisci.h"
#include "tests/room/square_cotton.h"

#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace {

Textile of_library(const char* name) { return patch_of(library_fabric(name)); }

struct Drawn {
    DrawnLayer layer;
    double growth; // m
};
Drawn drawn(const Textile& textile, int voxels)
{
    return {layer_of_cell(textile, drawn_cell(textile).value(), voxels), room_tables(textile, voxels)->growth};
}
RoomStates states_of(const Drawn& cloth, double cosine = reference_cosine)
{
    RestingLiquid liquid(cloth.layer, cloth.growth, cosine);
    return states_of_room(liquid);
}

/// Walls so many voxels apart across a layer twice as thick.
DrawnLayer slots(int width)
{
    DrawnLayer layer;
    layer.per_end = 2 * width;
    layer.per_pick = 2;
    layer.dx = layer.dy = layer.dz = 1e-5;
    layer.margin = width;
    layer.grid = {layer.per_end, layer.per_pick, 4 * width, true, false};
    layer.reach = width * layer.dx;
    layer.nearest_is_warp.assign(layer.grid.size(), 1);
    for (int z = 0; z < layer.grid.nz; ++z)
        for (int i = 0; i < layer.per_end * layer.per_pick; ++i) {
            const double in_slot = (0.5 * width - std::abs(i % layer.per_end + 0.5 - width)) * layer.dx,
                         up = (std::abs(z + 0.5 - 2 * width) - width) * layer.dz;
            layer.outside.push_back(static_cast<float>(std::max(in_slot, up)));
        }
    return layer;
}

} // namespace

class TestRoomMenisci : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aSlotHoldsAtOneSuction() // 2 cosine over its width, however full it is
    {
        const DrawnLayer layer = slots(32);
        for (const double cosine : {0.9, 0.5}) {
            RestingLiquid liquid(layer, 0, cosine);
            for (const double saturation : {0.9, 0.8, 0.7, 0.6, 0.5, 0.4}) {
                liquid.hold(saturation);
                if (saturation > 0.55) continue; // its menisci hang at the edges of the walls
                const double exact = 2 * cosine / (32 * layer.dx);
                QVERIFY2(near_to(liquid.curvature(), exact, 0.08), qPrintable(QString::number(liquid.curvature() / exact)));
            }
        }
    }
    void finerVoxelsFindTheSameStates()
    {
        const Textile textile = of_library("Poplin shirting");
        const RoomStates coarse = states_of(drawn(textile, 16)), fine = states_of(drawn(textile, 28));
        const auto ratio = [&](RestingState RoomStates::*state) { return (coarse.*state).at(0.9, 0.9) / (fine.*state).at(0.9, 0.9); };
        QVERIFY2(std::abs(ratio(&RoomStates::low) - 1) < 0.1, qPrintable(QString::number(ratio(&RoomStates::low))));
        QVERIFY2(std::abs(ratio(&RoomStates::knee) - 1) < 0.25, qPrintable(QString::number(ratio(&RoomStates::knee)))); // 18 of 93 Pa
        const double breaks = ratio(&RoomStates::breaks); // in wedges that are finer than its voxels
        QVERIFY2(breaks > 0.5 && breaks < 1.2, qPrintable(QString::number(breaks)));
    }
    void statesGoWithTheCosine() // which is why one is drawn for all angles
    {
        const Drawn cloth = drawn(of_library("Poplin shirting"), 16);
        const RoomStates states = states_of(cloth), other = states_of(cloth, 1.0);
        for (RestingState RoomStates::*state : {&RoomStates::knee, &RoomStates::low, &RoomStates::breaks}) {
            const double expected = (other.*state).curvature, found = (states.*state).at(1.0, 1.0);
            QVERIFY2(near_to(found, expected, 0.1), qPrintable(QString("%1 for %2").arg(found).arg(expected)));
        }
    }
    void statesGoWithTheScaleAndTheDirections()
    {
        Drawn cloth = drawn(square_cotton("rib 2/2 warp", {20, 14, 40}), 12);
        const RoomStates small = states_of(cloth);
        for (double* length : {&cloth.layer.dx, &cloth.layer.dy, &cloth.layer.dz, &cloth.layer.reach, &cloth.growth}) *length *= 3;
        for (float& outside : cloth.layer.outside) outside *= 3;
        const RoomStates large = states_of(cloth), turned = states_of(drawn(square_cotton("rib 2/2 weft", {14, 20, 40}), 12));
        const auto check = [](double found, double expected, double share) {
            QVERIFY2(near_to(found, expected, share), qPrintable(QString("%1 for %2").arg(found).arg(expected)));
        };
        check(3 * large.low.curvature, small.low.curvature, 1e-3);
        check(3 * large.low.warp, small.low.warp, 1e-3);
        check(turned.low.curvature, small.low.curvature, 0.02);
        check(turned.low.warp, small.low.weft, 0.02);
        QVERIFY(!near_to(small.low.warp, small.low.weft, 0.05));
    }
    /// Rings about the crossings of an open cloth lie too far apart to join by themselves. In a close one they do, at more than 5 cm of
    /// water.
    void aCloseRoomFillsByItselfAndAnOpenOneDoesNot()
    {
        const auto fills = [](const char* name) { return room_tables(of_library(name), 16)->types[0].states.fills.at(0.9, 0.9); };
        constexpr double tension = 0.0727;
        QVERIFY2(tension * fills("Sheeting") < 0, qPrintable(QString::number(tension * fills("Sheeting"))));
        QVERIFY2(tension * fills("Poplin shirting") > 500, qPrintable(QString::number(tension * fills("Poplin shirting"))));
    }
};

QTEST_APPLESS_MAIN(TestRoomMenisci)
#include "tst_room_menisci.moc"
