// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The network's stages alone: conserved, bounded, and in agreement with what they approximate.
#include "core/solver/state_archive.h"
#include "tests/solver/network.h"

#include <QTest>

using namespace hygroloom;

class TestYarnSteps : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aStateOfAnotherSceneIsRefusedWithTheFieldThatDiffers()
    {
        StateWriter writer(64);
        writer.values(std::vector<double>(3), "liquid");
        const std::vector<std::byte> state = writer.take();
        StateReader reader(state);
        std::vector<double> four(4);
        try {
            reader.values(four, "liquid");
            QFAIL("three values were read as four");
        } catch (const Error& e) {
            QCOMPARE(QString(e.what()), QString("The state of a run is of another scene: it has 3 values of \"liquid\", the scene 4."));
        }
    }
    void segmentsFindTheirYarns()
    {
        const std::vector<std::uint8_t> type{0, 1, 0, 2, 4, 3, 2}; // three ends of two types, four picks of three
        std::vector<YarnParameters> yarns(5);
        for (std::size_t i = 0; i < 5; ++i) yarns[i].pore_area = static_cast<double>(i);
        std::vector<CrossingParameters> crossings(6);
        for (std::size_t i = 0; i < 6; ++i) crossings[i].heat_conductance = static_cast<double>(10 * (i / 3) + i % 3 + 2);
        const Yarns y{3, 4, 2, 3, type.data(), yarns.data(), crossings.data(), {}, {}};
        for (int end = 0; end < 3; ++end)
            for (int pick = 0; pick < 4; ++pick) {
                const double warp = type[static_cast<std::size_t>(end)], weft = type[static_cast<std::size_t>(3 + pick)];
                QCOMPARE(y.yarn_of(end * 4 + pick).pore_area, warp);
                QCOMPARE(y.yarn_of(12 + pick * 3 + end).pore_area, weft);
                QCOMPARE(y.crossing_at(end, pick).heat_conductance, 10 * warp + weft);
            }
        for (int line = 0; line < y.visited_lines(); ++line) {
            const YarnLine found = y.visited_line(line);
            QCOMPARE(found.yarn.pore_area, double(type[static_cast<std::size_t>(line)]));
            QCOMPARE(found.last - found.first, line < 3 ? 4 : 3);
            for (int i = found.first; i < found.last; ++i) QCOMPARE(y.line_of(i), line);
        }
    }
    void everyCrossingIsVisitedOnce()
    {
        for (int ends : {1, 7, 8, 9, 30})
            for (const Unvisited out : {Unvisited{}, Unvisited{0, 0, 1, 2}, Unvisited{ends / 2, ends / 3, 2, 0}}) {
                Yarns y;
                y.ends = ends;
                y.picks = 5;
                y.unvisited = out;
                std::vector<int> visits(static_cast<std::size_t>(ends * 5), 0);
                for (int k = 0; k < y.visited_crossings(); ++k) {
                    const Crossing c = y.visited_place(k);
                    QVERIFY(c.end >= out.ends_before && c.end < ends - out.ends_after);
                    QVERIFY(c.pick >= out.picks_before && c.pick < 5 - out.picks_after);
                    QCOMPARE(++visits[static_cast<std::size_t>(c.end * 5 + c.pick)], 1);
                }
            }
    }
    void wickingKeepsTheLiquidAndItsBounds_data()
    {
        QTest::addColumn<double>("dt");
        for (double dt : {1e-9, 1e-6, 1e-3, 1.0, 1e3}) QTest::addRow("dt %g", dt) << dt;
    }
    void wickingKeepsTheLiquidAndItsBounds()
    {
        QFETCH(double, dt);
        const YarnParameters yarn = cotton();
        Network n(1, 97, yarn, yarn);
        const double capacity = 997 * yarn.pore_area * n.length[0];
        for (int i = 0; i < 97; ++i) n.liquid[static_cast<std::size_t>(i)] = capacity * (i % 7 == 0 ? 1.0 : i % 3 == 0 ? 0.4 : 0.0);
        const double before = total(n.liquid);
        for (int step = 0; step < 20; ++step) along(WickAlongYarn{n.views(), room(), dt, 0, 0});
        QVERIFY(std::abs(total(n.liquid) - before) < 1e-14 * before);
        for (int i = 0; i < 97; ++i) {
            QVERIFY(n.liquid[static_cast<std::size_t>(i)] >= 0);
            QVERIFY(n.liquid[static_cast<std::size_t>(i)] <= capacity * (1 + 1e-12));
        }
    }
    void wickingEvensOutInTheEnd()
    {
        const YarnParameters yarn = cotton();
        Network n(1, 30, yarn, yarn);
        const double capacity = 997 * yarn.pore_area * n.length[0];
        for (int i = 0; i < 15; ++i) n.liquid[static_cast<std::size_t>(i)] = capacity;
        for (int step = 0; step < 400; ++step) along(WickAlongYarn{n.views(), room(), 10, 0, 0});
        for (int i = 0; i < 30; ++i) QVERIFY(std::abs(n.liquid[static_cast<std::size_t>(i)] / capacity - 0.5) < 1e-3);
    }
    void wickingAgreesWithTinyExplicitSteps()
    {
        const YarnParameters yarn = cotton();
        Network n(1, 40, yarn, yarn);
        const double capacity = 997 * yarn.pore_area * n.length[0], h = n.length[0];
        std::vector<double> s(40, 0.0);
        for (std::size_t i = 15; i < 25; ++i) s[i] = 0.9;
        for (std::size_t i = 0; i < 40; ++i) n.liquid[i] = capacity * s[i];
        const double time = 0.1, dt = 2e-5;
        for (int step = 0; step < 5000; ++step) {
            std::vector<double> flux(41, 0.0);
            for (std::size_t i = 0; i + 1 < 40; ++i)
                flux[i + 1] = yarn.liquid_diffusivity * (s[i] * s[i] - s[i + 1] * s[i + 1]) / 2.0 / (h * h);
            for (std::size_t i = 0; i < 40; ++i) s[i] += dt * (flux[i] - flux[i + 1]);
        }
        for (int step = 0; step < 1000; ++step) along(WickAlongYarn{n.views(), room(), time / 1000, 0, 0});
        for (std::size_t i = 0; i < 40; ++i) QVERIFY(std::abs(n.liquid[i] / capacity - s[i]) < 2e-3);
    }
    void heatAlongAYarnIsConservedWhileLiquidCarriesIt()
    {
        const YarnParameters yarn = cotton();
        Network n(1, 33, yarn, yarn);
        const double capacity = 997 * yarn.pore_area * n.length[0];
        for (std::size_t i = 0; i < 33; ++i) {
            n.liquid[i] = i < 12 ? capacity : 0;
            n.warmth[i] = i < 6 ? 5.0 : i == 20 ? -3.0 : 0.0;
        }
        Segments s = n.views();
        const auto heat = [&] {
            double sum = 0;
            for (int i = 0; i < 33; ++i) sum += heat_capacity(yarn, s.length[i], s.liquid[i] + bound_water(s, yarn, i)) * s.warmth[i];
            return sum;
        };
        const double before = heat();
        ClimateParameters still = room();
        still.heat_transfer = 0;
        for (double dt : {1e-4, 1e-2, 1.0}) {
            along(WickAlongYarn{s, room(), dt, 0, 0});
            along(ConductAlongYarn{s, still, dt});
            QVERIFY(std::abs(heat() - before) < 1e-12 * std::abs(before));
            for (double w : n.warmth) QVERIFY(w <= 5.0 + 1e-12 && w >= -3.0 - 1e-12);
        }
    }
    void liquidInAHangingYarnStandsAsJurinSays() // s = 1 - z / h
    {
        const ClimateParameters climate = room();
        YarnParameters yarn = cotton();
        const double suction = 200, height = suction / (climate.density * gravity_acceleration); // 20 mm
        const PoreFlow flow = pore_flow(2e-5, suction, climate.density);
        yarn.liquid_diffusivity = flow.diffusivity;
        yarn.fall = flow.fall;
        Network n(1, 100, yarn, yarn); // 30 mm
        n.fed.assign(200, 0);
        n.fed[0] = 1;
        for (int step = 0; step < 3000; ++step) {
            KeepFed{n.views(), climate.density}(0);
            along(WickAlongYarn{n.views(), climate, 10, gravity_acceleration, 0});
        }
        const double capacity = climate.density * n.pores[0];
        for (std::size_t i = 1; i < 100; ++i) {
            const double expected = std::max(0.0, 1 - static_cast<double>(i) * n.length[0] / height), found = n.liquid[i] / capacity;
            QVERIFY2(std::abs(found - expected) < 0.03, qPrintable(QString("%1: %2, not %3").arg(i).arg(found).arg(expected)));
        }
        double warp = 0;
        for (std::size_t i = 0; i < 100; ++i) warp += n.liquid[i];
        QVERIFY(std::abs(n.supplied[0] - warp) < 1e-12 * warp); // all of it came from the bath
    }
    void warmLiquidFlowsFaster() // 2 % a kelvin: surface tension over viscosity
    {
        ClimateParameters climate = room();
        climate.flow.slope = 0.02;
        const YarnParameters yarn = cotton();
        const auto moved = [&](double warmth) {
            Network n(1, 2, yarn, yarn);
            n.liquid[0] = climate.density * n.pores[0];
            n.warmth[0] = n.warmth[1] = warmth;
            along(WickAlongYarn{n.views(), climate, 1e-9, 0, 0});
            return n.liquid[1];
        };
        QVERIFY(std::abs(moved(10) / moved(0) - 1.2) < 1e-6);
    }
    void aBathKeepsItsYarnsFullAndCool()
    {
        const ClimateParameters climate = room();
        const YarnParameters yarn = cotton();
        Network n(1, 3, yarn, yarn);
        n.fed = {1, 0, 0, 0, 0, 0};
        n.warmth[0] = 4;
        n.liquid[0] = 1e-12;
        Segments s = n.views();
        const double heat = heat_capacity(yarn, s.length[0], 1e-12) * 4;
        for (int i = 0; i < 6; ++i) KeepFed{s, climate.density}(i);
        QCOMPARE(n.warmth[0], 0.0);
        QCOMPARE(n.lost[0], heat);
        QCOMPARE(n.liquid[0], climate.density * n.pores[0]);
        QCOMPARE(n.supplied[0], climate.density * n.pores[0] - 1e-12);
        QCOMPARE(n.liquid[1], 0.0);
    }
    void finerPoresSuckLiquidOver()
    {
        YarnParameters coarse = cotton(), fine = cotton();
        coarse.suction_radius = 2e-5;
        fine.suction_radius = 1e-5;
        Network n(1, 1, coarse, fine);
        const double capacity = 997 * coarse.pore_area * n.length[0];
        n.liquid = {0.3 * capacity, 0.3 * capacity};
        n.crossing.liquid_conductance = 1e-6;
        for (int i = 0; i < 200; ++i) ExchangeAtCrossing{n.views(), room(), 1.0, true, false}(0);
        QVERIFY(n.liquid[1] > 0.5 * capacity);
        QVERIFY(std::abs(n.liquid[0] + n.liquid[1] - 0.6 * capacity) < 1e-14 * capacity);
        // Equal suction: the pore filled is equally wide in both, r ~ s^(1/3).
        QVERIFY(std::abs(2.0 * std::cbrt(n.liquid[0] / capacity) - std::cbrt(n.liquid[1] / capacity)) < 1e-3);
    }
    void crossingNeverOverfillsOrEmptiesBelowNothing()
    {
        const YarnParameters yarn = cotton();
        Network n(1, 1, yarn, yarn);
        const double capacity = 997 * yarn.pore_area * n.length[0];
        n.liquid = {capacity, 0.999 * capacity};
        n.crossing.liquid_conductance = 1.0;
        ExchangeAtCrossing{n.views(), room(), 1e3, true, false}(0);
        for (double m : n.liquid) QVERIFY(m >= 0 && m <= capacity * (1 + 1e-12));
    }
    void liquidThatStandsInTheBathDoesNotFall() // else what the bath gives at its surface and takes back below would pile up in the ledger
    {
        YarnParameters yarn = cotton();
        yarn.fall = 1e3; // s, of very coarse fibres
        Network n(1, 4, yarn, cotton());
        n.fed.assign(n.liquid.size(), 0);
        n.fed[0] = n.fed[1] = 1;
        for (std::size_t i : {0, 1}) n.liquid[i] = room().density * n.pores[i];
        for (int step = 0; step < 100; ++step) along(WickAlongYarn{n.views(), room(), 1.0, gravity_acceleration, 0});
        QCOMPARE(n.supplied[0], 0.0);
        QCOMPARE(n.flux[0], 0.0);
    }
    void absorbedQuantaBecomeLiquid()
    {
        Network n(1, 2, cotton(), cotton());
        n.absorbed[1] = 1 << 30;
        n.warmth[1] = 4.0;
        TakeAbsorbed{n.views()}(1);
        QCOMPARE(n.liquid[1], std::ldexp(1.0, 30 - 64));
        QCOMPARE(n.absorbed[1], std::int64_t(0));
        QVERIFY(n.warmth[1] < 4.0);
    }
};

QTEST_APPLESS_MAIN(TestYarnSteps)
#include "tst_yarn_steps.moc"
