// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A segment's exchange with its fibres and the air: balanced at the extremes, and in agreement with what it approximates.
#include "tests/solver/network.h"

#include <QTest>

#include <functional>
#include <limits>

using namespace hygroloom;

class TestSegmentExchange : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void bracketsCloseInOnAnyBalance()
    {
        const double root = 0.00484016, thousandth = 1e-3 * root;
        int most = 0;
        for (const auto& balance : {std::function<double(double)>([&](double x) { return x < root ? -2e-9 : 3e-13; }), // a step
                                    std::function<double(double)>([&](double x) { return std::expm1((x - root) / thousandth); }),
                                    std::function<double(double)>([&](double x) { return std::min(x - root, 1e-12); }),
                                    std::function<double(double)>([&](double x) { return x - root; })}) {
            Bracket bracket{0, 250, balance(0), balance(250)};
            int trials = 0;
            for (; trials < 256 && bracket.high - bracket.low > 1e-14 * root; ++trials) {
                const double trial = bracket.next();
                QVERIFY(trial >= bracket.low && trial <= bracket.high);
                if (balance(trial) == 0) break;
                bracket.narrow(trial, balance(trial));
            }
            QVERIFY(bracket.low <= root && bracket.high >= root);
            most = std::max(most, trials);
        }
        QVERIFY2(most <= 4 * 63, qPrintable(QString::number(most))); // 250 halved to 1e-14 of the root
    }
    void withoutVapourFibresTakeWhatLiquidThereIsAndGiveNoneBack() // and are as warm as what they took has made them
    {
        ClimateParameters climate = room();
        climate.vapour = climate.humidity = 0;
        for (double radius : {8e-6, 1e-9})
            for (double full : {1e-6, 0.01, 0.5}) {
                Network n(1, 1, cotton(), cotton());
                n.yarns[0].fibre_radius = radius;
                const double liquid = full * climate.density * n.pores[0];
                n.liquid[0] = liquid;
                Segments s = n.views();
                for (int step = 0; step < 20; ++step) {
                    const double bound = s.bound[0], before = s.warmth[0], lost = s.lost[0];
                    ExchangeInSegment{s, climate, 9e-8, 0.05, true, false, true}(0);
                    QVERIFY(s.bound[0] >= bound * (1 - 1e-12) && s.liquid[0] >= 0);
                    QVERIFY(std::abs(s.bound[0] + s.liquid[0] - liquid) <= 1e-14 * liquid);
                    const double warmest = std::max(before, s.warmth[0]) - climate.air_warmth;
                    QVERIFY2(s.lost[0] - lost <= 1.01 * 0.05 * climate.heat_transfer * 9e-8 * std::max(0.0, warmest) + 1e-15,
                             qPrintable(QString("%1 %2: %3").arg(radius).arg(full).arg(warmest)));
                }
            }
    }
    void supersaturatedPoresCondenseAndWarm() // no more and no less than their heat of condensation says, and not to and fro
    {
        const ClimateParameters climate = room();
        for (double radius : {200e-6, 8e-6, 1e-9}) {
            Network n(1, 1, cotton(), cotton());
            n.yarns[0].fibre_radius = radius;
            const double air = n.pores[0], before = 2 * saturation_concentration(climate.temperature) * air;
            n.vapour[0] = before;
            Segments s = n.views();
            double warmth = 0;
            for (int step = 0; step < 100; ++step) {
                ExchangeInSegment{s, climate, 0.0, 1e-3, false, true, true}(0); // no face: nothing leaves
                QVERIFY(s.warmth[0] >= warmth - 1e-8);                          // K, as exact as rounds are
                warmth = s.warmth[0];
                const double holds =
                    saturation_concentration(climate.temperature + warmth) * pore_air(s.pores[0], s.liquid[0], climate.density);
                QVERIFY(s.vapour[0] <= holds * (1 + 1e-8));
                QVERIFY(std::abs(s.vapour[0] + s.liquid[0] + s.evaporated[0] - before) <= 1e-14 * before);
                QVERIFY(std::abs(s.evaporated[0]) <= 1e-12 * before);
                const double heat = heat_of_evaporation(climate.temperature + warmth) * s.liquid[0];
                const double taken = heat_capacity(n.yarns[0], s.length[0], s.liquid[0]) * warmth;
                QVERIFY2(std::abs(taken - heat) < 1e-3 * heat, qPrintable(QString("%1 %2").arg(taken).arg(heat)));
            }
            QVERIFY2(warmth > 0.01 && warmth < 0.1, qPrintable(QString::number(warmth))); // 23 g/m3 of air for 1.9e6 J/(m3 K) of fibres
        }
    }
    void whatCondensesAtOnceLeavesItsPlaceInTheAir()
    {
        const ClimateParameters climate = room();
        const double saturated = saturation_concentration(climate.temperature);
        for (double full : {0.0, 0.9, 0.998, 0.9995, 1.0})
            for (double pressed : {2.0, 1e2, 1e4, 1e6}) { // of saturation
                Network n(1, 1, cotton(), cotton());
                n.liquid[0] = full * climate.density * n.pores[0];
                n.vapour[0] = pressed * saturated * pore_air(n.pores[0], n.liquid[0], climate.density);
                const double before = n.liquid[0] + n.vapour[0];
                n.yarns[0].fibre_radius = 1; // m: next to nothing condenses in the step itself
                ExchangeInSegment{n.views(), climate, 0.0, 1e-9, false, true, false}(0);
                const double holds = saturated * pore_air(n.pores[0], n.liquid[0], climate.density);
                QVERIFY2(n.vapour[0] <= holds * (1 + 1e-12),
                         qPrintable(QString("%1 %2: %3").arg(full).arg(pressed).arg(n.vapour[0] / holds)));
                QVERIFY(n.liquid[0] <= climate.density * n.pores[0] * (1 + 1e-12));
                QVERIFY(std::abs(n.liquid[0] + n.vapour[0] + n.evaporated[0] - before) <= 1e-14 * before);
            }
    }
    void segmentInBalanceStaysAsItIs()
    {
        const ClimateParameters climate = room();
        YarnParameters yarn = cotton();
        yarn.initial_regain = yarn.resting_regain = equilibrium_regain(yarn.isotherm, 0.65, climate.temperature);
        Network n(1, 1, yarn, yarn);
        std::fill(n.regain.begin(), n.regain.end(), yarn.initial_regain);
        for (std::size_t i = 0; i < 2; ++i) n.vapour[i] = climate.vapour * pore_air(n.pores[i], 0, climate.density);
        const Network before = n;
        for (int step = 0; step < 100; ++step) ExchangeInSegment{n.views(), climate, 8e-8, 10.0, true, true, true}(0);
        QCOMPARE(n.regain, before.regain);
        QCOMPARE(n.vapour, before.vapour);
        QCOMPARE(n.warmth, before.warmth);
    }
    void exchangeBalancesAtTheExtremes_data()
    {
        QTest::addColumn<double>("celsius");
        QTest::addColumn<double>("humidity");
        QTest::addColumn<double>("saturation");
        QTest::addColumn<double>("dt");
        QTest::addColumn<double>("radius");
        for (double celsius : {-10.0, 0.0, 25.0, 60.0})
            for (double humidity : {0.0, 0.65, 1.0})
                for (double saturation : {0.0, 1e-6, 0.3, 1.0})
                    for (double dt : {1e-9, 1e-6, 1e-2, 10.0})
                        for (double radius : {8e-6, 1e-9})
                            QTest::addRow("%g C, %g, s %g, dt %g, %g um", celsius, humidity, saturation, dt, 1e6 * radius)
                                << celsius << humidity << saturation << dt << radius;
    }
    void exchangeBalancesAtTheExtremes()
    {
        QFETCH(double, celsius);
        QFETCH(double, humidity);
        QFETCH(double, saturation);
        QFETCH(double, dt);
        QFETCH(double, radius);
        ClimateParameters climate = room();
        climate.temperature = kelvin_from_celsius(celsius);
        climate.humidity = humidity;
        climate.vapour = humidity * saturation_concentration(climate.temperature);
        YarnParameters yarn = cotton();
        yarn.fibre_radius = radius;
        yarn.resting_regain = equilibrium_regain(yarn.isotherm, humidity, climate.temperature);
        yarn.initial_regain = 0.03;
        Network n(1, 1, yarn, yarn);
        std::fill(n.regain.begin(), n.regain.end(), 0.03);
        const double capacity = climate.density * yarn.pore_area * n.length[0];
        n.liquid = {saturation * capacity, 0};
        n.vapour[0] = 0.5 * saturation_concentration(climate.temperature) * pore_air(n.pores[0], n.liquid[0], climate.density);
        n.warmth[0] = 2.0;
        Segments s = n.views();
        const auto water = [&] { return s.liquid[0] + s.vapour[0] + bound_water(s, yarn, 0) + s.evaporated[0]; };
        const auto energy = [&] {
            return heat_capacity(yarn, s.length[0], s.liquid[0] + bound_water(s, yarn, 0)) * s.warmth[0] - s.released[0] + s.lost[0];
        };
        const double water_before = water(), energy_before = energy();
        for (int step = 0; step < 200; ++step) {
            ExchangeInSegment{s, climate, 8e-8, dt, true, true, true}(0);
            const double held = bound_water(s, yarn, 0); // of its shells, which the exchange has changed
            QVERIFY(std::abs(s.bound[0] - held) <= 1e-14 * held + std::numeric_limits<double>::min());
            QVERIFY(std::isfinite(s.warmth[0]) && std::isfinite(s.vapour[0]));
            QVERIFY(s.liquid[0] >= 0 && s.liquid[0] <= capacity * (1 + 1e-12) && s.vapour[0] >= 0);
            const double holds = saturation_concentration(climate.temperature + s.warmth[0]) * // to how exact saturated_near() is
                                 pore_air(s.pores[0], s.liquid[0], climate.density);
            QVERIFY2(s.vapour[0] <= holds * (1 + 1e-8), qPrintable(QString("%1 of %2").arg(s.vapour[0]).arg(holds)));
            for (int k = 0; k < s.shells; ++k) QVERIFY(s.regain[k] >= 0 && s.regain[k] <= 0.24);
            const double temperature = celsius + s.warmth[0];
            QVERIFY2(temperature > -40 && temperature < 120, qPrintable(QString::number(temperature)));
            QVERIFY(std::abs(water() - water_before) < 1e-12 * (water_before + std::abs(s.evaporated[0])));
            QVERIFY(std::abs(energy() - energy_before) < 1e-10 * (std::abs(energy_before) + std::abs(s.released[0]) + std::abs(s.lost[0])));
        }
    }
    void wetYarnInHotDryAirComesToItsWetBulb() // and never below
    {
        ClimateParameters climate = room();
        climate.temperature = kelvin_from_celsius(60);
        climate.humidity = climate.vapour = 0;
        climate.mass_transfer = mass_transfer(climate.heat_transfer, climate.temperature);
        double low = -60, high = 0; // K, of the air
        for (int i = 0; i < 60; ++i) {
            const double warmth = 0.5 * (low + high), temperature = climate.temperature + warmth;
            const double taken = climate.mass_transfer * heat_of_evaporation(temperature) * saturation_concentration(temperature);
            (climate.heat_transfer * warmth + taken > 0 ? high : low) = warmth;
        }
        QVERIFY2(std::abs(60 + low - 18.9) < 0.25, qPrintable(QString::number(60 + low)));
        for (double radius : {8e-6, 1e-9})
            for (double dt : {1e-3, 0.1, 10.0}) {
                YarnParameters yarn = cotton();
                yarn.fibre_radius = radius;
                Network n(1, 1, yarn, yarn);
                std::fill(n.regain.begin(), n.regain.end(), 0.2);
                n.liquid[0] = 0.9 * climate.density * n.pores[0];
                Segments s = n.views();
                double coldest = 0;
                while (s.liquid[0] > 0.3 * climate.density * n.pores[0]) {
                    ExchangeInSegment{s, climate, 8e-8, dt, false, true, true}(0);
                    coldest = std::min(coldest, s.warmth[0]);
                    if (s.warmth[0] > coldest + 1e-3) break;
                }
                // In air without vapour the pores' own is what is a little less than saturated, so that it may be some hundredths colder.
                QVERIFY2(coldest > low - 0.05, qPrintable(QString("%1 %2: %3").arg(radius).arg(dt).arg(coldest - low)));
                if (dt < 10) QVERIFY2(coldest < low + 0.05, qPrintable(QString("%1 %2: %3").arg(radius).arg(dt).arg(coldest - low)));
            }
    }
    void dryAirEmptiesFibresAndSaturatedAirFillsThem() // one way all along, and without liquid
    {
        for (double humidity : {0.0, 1.0})
            for (double radius : {8e-6, 1e-9})
                for (double dt : {1e-3, 1.0, 100.0}) {
                    ClimateParameters climate = room();
                    climate.humidity = humidity;
                    climate.vapour = humidity * saturation_concentration(climate.temperature);
                    YarnParameters yarn = cotton();
                    yarn.fibre_radius = radius;
                    yarn.resting_regain = equilibrium_regain(yarn.isotherm, humidity, climate.temperature);
                    Network n(1, 1, yarn, yarn);
                    std::fill(n.regain.begin(), n.regain.end(), equilibrium_regain(yarn.isotherm, 0.65, climate.temperature));
                    n.vapour[0] = 0.65 * saturation_concentration(climate.temperature) * n.pores[0];
                    Segments s = n.views();
                    double before = s.bound[0];
                    const double exact = 1e-8 * before; // rounds leave 1e-8 of saturation
                    for (double time = 0; time < 2e3 * dt; time += dt) {
                        ExchangeInSegment{s, climate, 8e-8, dt, true, true, true}(0);
                        const double change = s.bound[0] - before;
                        QVERIFY2(humidity > 0 ? change >= -exact : change <= exact, qPrintable(QString::number(change)));
                        QVERIFY(s.liquid[0] <= exact);
                        before = s.bound[0];
                    }
                    const double regain = before / (s.length[0] * yarn.fibre_area * yarn.fibre_density);
                    if (dt > 1) QVERIFY2(std::abs(regain - yarn.resting_regain) < 1e-3, qPrintable(QString::number(regain)));
                }
    }
    void squeezedVapourDoesNotFloodTheNeighbours() // liquid that fills a pore presses its vapour together; fibres have not met that
    {
        const ClimateParameters climate = room();
        const double saturated = saturation_concentration(climate.temperature);
        double left[2];
        for (bool squeezed : {false, true}) {
            Network n(1, 2, cotton(), cotton());
            n.yarns[0].vapour_diffusivity = 2e-5;
            n.yarns[0].open_vapour = 1e-12;
            n.liquid[0] = 0.95 * climate.density * n.pores[0];
            for (std::size_t i = 0; i < 2; ++i) {
                const double air = pore_air(n.pores[i], n.liquid[i], climate.density);
                n.uptake[i] = 1e3 * n.pores[i];
                n.vapour[i] = (i > 0 ? climate.vapour : squeezed ? 20 * saturated : saturated) * air;
            }
            const double before = n.vapour[1];
            along(DiffuseVapourAlongYarn{n.views(), climate, 0.3, 8e-8, true});
            left[squeezed] = n.vapour[1] - before;
        }
        QVERIFY(left[0] > 0);
        // No more than the vapour itself that was pressed together, a pore full.
        const double pore_full = cotton().pore_area * 3e-4 * saturated;
        QVERIFY2(left[1] - left[0] < pore_full, qPrintable(QString("%1 %2 %3").arg(left[0]).arg(left[1]).arg(pore_full)));
    }
    void newtonAndTheBracketedSearchAgree_data()
    {
        QTest::addColumn<double>("radius");
        for (double radius : {200e-6, 8e-6, 1e-6, 1e-9}) QTest::addRow("fibres of %g um", 1e6 * radius) << radius;
    }
    void newtonAndTheBracketedSearchAgree()
    {
        QFETCH(double, radius);
        const ClimateParameters climate = room();
        YarnParameters yarn = cotton();
        yarn.fibre_radius = radius;
        const double full = saturation_concentration(climate.temperature);
        struct Try {
            double vapour, foreseen; // of saturation
            double warmth;           // K
        };
        int closed = 0, tried = 0;
        for (double regain : {0.0, 0.02, 0.07, 0.15})
            for (double saturation : {0.0, 0.01, 0.5, 0.99, 0.9998})
                for (const auto& [dt, from] :
                     {std::pair{1e-3, Try{0.3, 0.65, 0}}, std::pair{0.1, Try{0.3, 0.65, 0}}, std::pair{20.0, Try{0.3, 0.65, 0}},
                      std::pair{0.1, Try{1.5, 1.3, 0}}, std::pair{1.0, Try{1.2, 0.3, 4}}, std::pair{5.0, Try{0.9, 1.1, -3}}}) {
                    Network n(1, 1, yarn, yarn);
                    std::fill(n.regain.begin(), n.regain.end(), regain);
                    n.liquid[0] = saturation * climate.density * n.pores[0];
                    n.vapour[0] = from.vapour * full * pore_air(n.pores[0], n.liquid[0], climate.density);
                    n.warmth[0] = from.warmth;
                    const ExchangeInSegment stage{n.views(), climate, 8e-8, dt, true, true, true};
                    n.work2[0] = from.foreseen * full;
                    ShellRows rows;
                    const double air = pore_air(n.pores[0], n.liquid[0], climate.density);
                    const ExchangeInSegment::Start start = stage.start_of(0, yarn, air, rows);
                    ExchangeInSegment::Warm found = stage.at_warmth(0);
                    ExchangeInSegment::Outcome fast{};
                    ++tried;
                    if (!stage.newton(start, 0, found, fast)) continue;
                    ++closed;
                    const ExchangeInSegment::Warm searched = stage.at_warmth(stage.find_warmth(start));
                    const auto slow = stage.pore_balance(start, searched);
                    // Rounds end where they leave 1e-5 of saturation at most.
                    QVERIFY2(std::abs(found.warmth - searched.warmth) * searched.saturated.slope < 1e-5 * full,
                             qPrintable(QString("%1 %2").arg(found.warmth).arg(searched.warmth)));
                    QVERIFY(std::abs(fast.pore_vapour - slow.pore_vapour) < 1e-5 * full);
                }
        QVERIFY2(closed == tried, qPrintable(QString("%1 of %2").arg(closed).arg(tried)));
    }
    void dryFibreInSaturatedAirWarms() // the heat of sorption leaves through the face
    {
        ClimateParameters climate = room();
        climate.humidity = 1.0;
        climate.vapour = saturation_concentration(climate.temperature);
        YarnParameters yarn = cotton();
        yarn.resting_regain = 0.2;
        Network n(1, 1, yarn, yarn);
        Segments s = n.views();
        double warmest = 0;
        for (int step = 0; step < 2000; ++step) {
            ExchangeInSegment{s, climate, 8e-8, 0.1, true, true, true}(0);
            warmest = std::max(warmest, s.warmth[0]);
        }
        QVERIFY(warmest > 3 && warmest < 40);
        QVERIFY(s.released[0] > 0);
    }
};

QTEST_APPLESS_MAIN(TestSegmentExchange)
#include "tst_segment_exchange.moc"
