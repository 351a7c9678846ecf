// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Water and air against tables: IAPWS, physics handbooks.
#include "core/physics/heat_moisture.h"
#include "core/physics/liquid.h"

#include <QTest>

using namespace hygroloom;

namespace {
bool within(double value, double expected, double relative) { return std::abs(value - expected) <= relative * std::abs(expected); }
} // namespace

class TestFluids : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void saturationFollowsTheReferenceTable_data()
    {
        QTest::addColumn<double>("celsius");
        QTest::addColumn<double>("pascal");
        QTest::addColumn<double>("grams");
        QTest::newRow("-10 C") << -10.0 << 286.45 << 2.359;
        QTest::newRow("0 C") << 0.0 << 611.7 << 4.852;
        QTest::newRow("20 C") << 20.0 << 2339.2 << 17.290;
        QTest::newRow("36 C") << 36.0 << 5948.0 << 41.688;
        QTest::newRow("60 C") << 60.0 << 19947.0 << 129.73;
    }
    void saturationFollowsTheReferenceTable()
    {
        QFETCH(double, celsius);
        QFETCH(double, pascal);
        QFETCH(double, grams);
        QVERIFY(within(saturation_pressure(kelvin_from_celsius(celsius)), pascal, 1.2e-3));
        QVERIFY(within(1e3 * saturation_concentration(kelvin_from_celsius(celsius)), grams, 1.2e-3));
    }
    void waterFollowsTheSteamTables_data()
    {
        QTest::addColumn<double>("celsius");
        QTest::addColumn<double>("tension");
        QTest::addColumn<double>("viscosity");
        QTest::addColumn<double>("density");
        QTest::addColumn<double>("heat");
        QTest::newRow("0 C") << 0.0 << 75.65 << 1.792 << 999.84 << 2501.0;
        QTest::newRow("20 C") << 20.0 << 72.74 << 1.0016 << 998.20 << 2453.8;
        QTest::newRow("36 C") << 36.0 << 70.24 << 0.705 << 993.68 << 2416.0;
        QTest::newRow("60 C") << 60.0 << 66.24 << 0.466 << 983.2 << 2359.3;
    }
    void waterFollowsTheSteamTables()
    {
        QFETCH(double, celsius);
        QFETCH(double, tension);
        QFETCH(double, viscosity);
        QFETCH(double, density);
        QFETCH(double, heat);
        const double t = kelvin_from_celsius(celsius);
        QVERIFY(within(1e3 * water_surface_tension(t), tension, 2e-4));
        QVERIFY(within(1e3 * water_viscosity(t), viscosity, 1e-3));
        QVERIFY(within(water_density(t), density, 5e-5));
        QVERIFY(within(1e-3 * heat_of_evaporation(t), heat, 1e-3));
    }
    void saturationHasItsSlope()
    {
        for (double celsius : {-10.0, 20.0, 60.0}) {
            const double temperature = kelvin_from_celsius(celsius), h = 1e-3;
            QVERIFY(within(saturation_at(temperature).concentration, saturation_concentration(temperature), 1e-13));
            const double slope = (saturation_concentration(temperature + h) - saturation_concentration(temperature - h)) / (2 * h);
            QVERIFY(within(saturation_concentration_slope(temperature), slope, 1e-7));
        }
    }
    void airAndRadiationHaveTheirTableValues()
    {
        QVERIFY(within(air_density(293.15), 1.204, 1e-3)); // dry air at 20 C and 101 325 Pa
        QVERIFY(within(air_density(273.15), 1.293, 1e-3));
        // A grey body 1 K warmer than its surroundings, by the difference of fourth powers.
        const double warm = std::pow(293.65, 4), cold = std::pow(292.65, 4);
        QVERIFY(within(radiative_heat_transfer(293.15), 0.95 * 5.670374419e-8 * (warm - cold), 1e-5));
    }
    void poresComeToSaturationAtTheRateOfTheirSurface()
    {
        // Half fibre, half pores, fibres of 8 um: 2 x 0.5 / 8e-6 = 125 000 m2 of surface per m3, into half a m3 of pores, at 0.17 m/s.
        QVERIFY(within(phase_change_rate(0.5, 8e-6, 0.5), 0.17 * 125000 / 0.5, 1e-9));
        QVERIFY(within(phase_change_rate(0.5 * 3e-8, 8e-6, 0.5 * 3e-8), phase_change_rate(0.5, 8e-6, 0.5), 1e-9)); // by areas
    }
    void aLiquidIsItselfAtTwentyDegreesAndChangesAsWaterDoes()
    {
        const LiquidAt syrup{60e-3, 10e-3, 1200};
        const LiquidAt known = liquid_at(syrup, 293.15), warm = liquid_at(syrup, kelvin_from_celsius(36));
        QVERIFY(within(known.surface_tension, 60e-3, 1e-12));
        QVERIFY(within(known.viscosity, 10e-3, 1e-12));
        QVERIFY(within(known.density, 1200, 1e-12));
        QVERIFY(within(warm.surface_tension, 60e-3 * 70.24 / 72.74, 5e-4));
        QVERIFY(within(warm.viscosity, 10e-3 * 0.705 / 1.0016, 2e-3));
        QVERIFY(within(warm.density, 1200 * 993.68 / 998.20, 1e-4));
    }
    void fiveMicrolitresOfWaterFindTheirShapeInEightMilliseconds()
    {
        // sqrt(998.2 kg/m3 x 5e-9 m3 / 72.74e-3 N/m) = sqrt(6.8614e-5 s2) = 8.283 ms.
        QVERIFY(within(capillary_time(5e-9, 998.2, 72.74e-3), 8.283e-3, 2e-4));
        QVERIFY(within(capillary_time(5e-9, 1.0, 72.74e-3 / 998.2), 8.283e-3, 2e-4));
    }
    void warmLiquidFlowsAsSurfaceTensionOverViscositySays()
    {
        // From the steam tables above: (70.24 / 0.705) / (72.74 / 1.0016) = 1.3719 at 36 C over its value at 20 C.
        const FlowOfWarmLiquid flow = flow_of_warm_liquid(kelvin_from_celsius(20));
        QCOMPARE(flow_factor(flow, 0), 1.0);
        QVERIFY(within(flow_factor(flow, 16), 1.3719, 5e-3));
        QCOMPARE(flow_factor({0.02, 0}, 1e3), 5.0);
        QCOMPARE(flow_factor({0.02, 0}, -1e3), 0.2);
    }
    void vapourDiffusesAsMassmanFound()
    {
        QVERIFY(within(vapour_diffusivity(293.15), 2.475e-5, 2e-3));
        QVERIFY(within(vapour_diffusivity(333.15), 3.120e-5, 2e-3));
    }
    void vapourDiffusesSlowerBetweenYarnsAsBruggemanSays()
    {
        // 0.25^1.5 = 0.125; 2.475e-5 m2/s at 20 C.
        QVERIFY(within(vapour_diffusivity_between(293.15, 0.25), 0.125 * 2.475e-5, 2e-3));
        QCOMPARE(vapour_diffusivity_between(293.15, 0.0), 0.0);
        QCOMPARE(vapour_diffusivity_between(293.15, 1.0), vapour_diffusivity(293.15));
    }
    void airAtAMetrePerSecondOverEightCentimetresTakesFourteenWatts()
    {
        QVERIFY(within(convective_heat_transfer(1.0, 0.08), 13.9, 0.01));
        QVERIFY(within(mass_transfer(13.9, 293.15), 1.26e-2, 0.01));
    }
    void aWetFaceSettlesAsThePsychrometersConstantSays()
    {
        // FAO 56 (Allen and others 1998), tables 2.2 and 2.4: 66.5 Pa/K at 101.3 kPa for heat and vapour that pass alike; slopes of 82, 145
        // and 244 Pa/K at 10, 20 and 30 C. Here vapour passes the easier by Lewis' number, and its concentration drives it: slope - e/T.
        for (const auto& [celsius, slope] : {std::pair(10.0, 82.0), std::pair(20.0, 145.0), std::pair(30.0, 244.0)}) {
            const double temperature = kelvin_from_celsius(celsius), transfer = 20.0, pressure = saturation_pressure(temperature);
            const double rises = slope - pressure / temperature, holds = 66.5 * std::pow(0.865, 2.0 / 3.0);
            const double slows = cooling_slows_evaporation(transfer, mass_transfer(transfer, temperature), temperature);
            QVERIFY2(std::abs(slows / (rises / (rises + holds)) - 1) < 0.03, qPrintable(QString("%1 at %2 C").arg(slows).arg(celsius)));
            const double colder = wet_bulb_depression(transfer, mass_transfer(transfer, temperature), temperature, 0.98);
            QVERIFY2(std::abs(colder / (0.02 * pressure / (rises + holds)) - 1) < 0.03,
                     qPrintable(QString("%1 K at %2 C").arg(colder).arg(celsius)));
        }
        QCOMPARE(wet_bulb_depression(20, 0.02, 293.15, 1.0), 0.0);
    }
    void stillAirIsTheLeast() { QCOMPARE(convective_heat_transfer(0.0, 0.08), still_air_heat_transfer); }
    void conductivityOfCottonLiesBetweenItsParts()
    {
        QVERIFY(within(mean_conductivity(0.3, 0.35, 0.0), 0.057, 0.02));
        QVERIFY(within(mean_conductivity(0.3, 0.35, 0.7), 0.51, 0.02));
        QVERIFY(parallel_conductivity(0.3, 0.35, 0.0) > mean_conductivity(0.3, 0.35, 0.0));
    }
    void wetShareRisesFromNoneToAll()
    {
        QCOMPARE(wet_share(0.0), 0.0);
        QCOMPARE(wet_share(0.025), 0.5);
        QCOMPARE(wet_share(0.6), 1.0);
    }
};

QTEST_APPLESS_MAIN(TestFluids)
#include "tst_fluids.moc"
