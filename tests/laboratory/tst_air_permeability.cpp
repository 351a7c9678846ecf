// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Air through holes that are known and through drawn cloth.
#include "core/laboratory/air_permeability.h"

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/physics/laboratory.h"
#include "core/room/room_tables.h"
#include "tests/room/square_cotton.h"

#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace {

/// A square tube, so many voxels of 1 um wide and long, through a solid layer with air above and below.
DrawnLayer tube(int width, int length)
{
    constexpr int margin = 4, solid = 6;
    DrawnLayer layer;
    layer.per_end = layer.per_pick = width + solid;
    layer.dx = layer.dy = layer.dz = 1e-6;
    layer.margin = margin;
    layer.grid = {layer.per_end, layer.per_pick, length + 2 * margin, true, false};
    layer.reach = 1e-5;
    layer.outside.resize(layer.grid.size());
    for (int z = 0; z < layer.grid.nz; ++z)
        for (int y = 0; y < layer.grid.ny; ++y)
            for (int x = 0; x < layer.grid.nx; ++x) {
                const auto inside = [&](int at) { return 0.5 * width - std::abs(at + 0.5 - 0.5 * layer.per_end); };
                const double over = std::max(layer.first() - (z + 0.5), z + 0.5 - layer.last() - 1); // the solid's faces
                layer.outside[layer.grid.at(x, y, z)] = static_cast<float>(1e-6 * std::max(over, std::min(inside(x), inside(y))));
            }
    return layer;
}

AirPermeability air_of(const Textile& textile) { return AirPermeability(textile, false); }
double speed_of(const char* fabric) { return air_of(patch_of(library_fabric(fabric))).speed(100).value; }

} // namespace

class TestAirPermeability : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Flow in a long square duct: 0.035144 a4 over its section, and profile factors of energy 2.154 and of momentum 1.378 (Shah and
    /// London).
    void aLongTubeResistsAsPoiseuilleSaysAndLosesItsJet()
    {
        constexpr int width = 18, length = 90;
        const FlowThrough flow = flow_through(tube(width, length), 0);
        const double side = (width + 6) * 1e-6, open = width * 1e-6, share = open * open / (side * side);
        const double alone = 1e-6 * length * side * side / (0.035144 * std::pow(open, 4)); // both ends add less than 0.6 x its width
        QVERIFY2(flow.resistance > 0.97 * alone && flow.resistance < 1.1 * alone, qPrintable(QString::number(flow.resistance / alone)));
        const double loss = 2.154 / (share * share) - 2 * 1.378 / share + 1;
        QVERIFY2(near_to(flow.loss, loss, 0.05), qPrintable(QString::number(flow.loss / loss)));
    }
    /// Brinkman's drag alone where it is strong: Darcy's law over the open share.
    void hairsThatFillAHoleResistAsDarcySays()
    {
        constexpr double drag = 1e14; // 1/m2; k = 1e-14, far below that of the tube
        const DrawnLayer layer = tube(12, 72);
        const double share = 144.0 / 324, with = flow_through(layer, 0, drag).resistance;
        QVERIFY2(with > 72e-6 * drag / share && with < 1.4 * 72e-6 * drag / share,
                 qPrintable(QString::number(with * share / drag / 72e-6)));
    }
    void whatIsNotSolvedIsNoNumber() { QVERIFY_THROWS_EXCEPTION(Error, flow_through(tube(2, 2), 0, std::nan(""))); }
    void speedSolvesBothTerms()
    {
        QCOMPARE(speed_of_air(100, 50, 0), 2.0);
        QVERIFY(near_to(speed_of_air(12, 2, 2), 2, 1e-12)); // 2 x 2 + 2 x 4
    }
    void hairsAreAsOpenAsJacksonAndJamesSay()
    {
        QVERIFY(near_to(permeability_of_hairs(1e-6, 0.01), 15 * (std::log(100.0) - 0.931) * 1e-12, 1e-12));
    }
    void layersAddUp()
    {
        const AirWays one{{1e6, 50}, 1e-7};
        QVERIFY(near_to(one.in_series(4).speed(200), one.speed(50), 1e-12));
        QVERIFY(near_to(one.pressure(one.speed(50)), 50, 1e-9));
    }
    /// Twice as large, the same cloth lets half the resistance stand.
    void resistanceGoesWithOneOverLength()
    {
        const DrawnRepeat repeat = drawn_repeat(square_cotton("plain"), 16);
        DrawnLayer twice = repeat.layer;
        for (double* length : {&twice.dx, &twice.dy, &twice.dz, &twice.reach}) *length *= 2;
        for (float& outside : twice.outside) outside *= 2;
        const FlowThrough small = flow_through(repeat.layer, repeat.growth), large = flow_through(twice, 2 * repeat.growth);
        QVERIFY2(near_to(small.resistance, 2 * large.resistance, 1e-6), qPrintable(QString::number(small.resistance / large.resistance)));
        QVERIFY(near_to(small.loss, large.loss, 1e-6));
    }
    /// Wider yarns leave the volume of the drawn ones where it is and close the holes.
    void widerYarnsCloseHoles()
    {
        const Textile textile = square_cotton("plain");
        const DrawnRepeat as_drawn = drawn_repeat(textile, 16), wider = drawn_repeat(textile, 16, {3e-5, 3e-5});
        QCOMPARE(wider.growth, as_drawn.growth);
        QVERIFY(flow_through(wider.layer, wider.growth).resistance > 2 * flow_through(as_drawn.layer, as_drawn.growth).resistance);
    }
    void closerSettLetsLessThrough()
    {
        const auto speed = [](double threads) { return air_of(square_cotton("plain", {20, 20, threads})).speed(100).value; };
        const double open = speed(18), middle = speed(24), close = speed(30);
        QVERIFY2(open > 1.5 * middle && middle > 1.5 * close, qPrintable(QString("%1 %2 %3").arg(open).arg(middle).arg(close)));
    }
    void floatsLetMoreThroughThanPlainWeaveDoes()
    {
        const auto speed = [](const char* weave) { return air_of(square_cotton(weave, {30, 30, 26})).speed(100).value; };
        QVERIFY(speed("twill 2/2 Z") > speed("plain"));
    }
    /// Ranges that mills give; not those of taffeta, voile, denim and sateen, see core/verify/README.md.
    void clothsOfTheLibraryAreAsOpenAsWeaversKnowThem()
    {
        const struct {
            const char* fabric;
            double low, high;
        } known[] = {{"Poplin shirting", 0.05, 0.3}, {"Sheeting", 0.3, 1.2}, {"Oxford", 0.3, 0.9}, {"Drill", 0.03, 0.1}};
        for (const auto& cloth : known) {
            const double speed = speed_of(cloth.fabric);
            QVERIFY2(speed > cloth.low && speed < cloth.high, qPrintable(QString("%1: %2 m/s").arg(cloth.fabric).arg(speed)));
        }
    }
    void intervalsHoldTheirValues()
    {
        const AirPermeability air = air_of(patch_of(library_fabric("Poplin shirting")));
        for (const double pressure : {100.0, 125.0, 200.0}) {
            const Estimate speed = air.speed(pressure);
            QVERIFY(speed.low < speed.value && speed.value < speed.high);
        }
        QVERIFY(air.speed(200).value > 1.5 * air.speed(100).value && air.speed(200).value < 2 * air.speed(100).value);
        QVERIFY(near_to(estimate_of(2, {{1, 4}, {2, 6}}).high, 2 * std::exp(std::hypot(std::log(2.0), std::log(3.0))), 1e-12));
        QVERIFY(near_to(estimate_of(2, {{1, 4}, {2, 6}}).low, 1, 1e-12));
    }
};

QTEST_APPLESS_MAIN(TestAirPermeability)
#include "tst_air_permeability.moc"
