// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Isotherms, heats and diffusion in fibres against Morton and Hearle's tables and each formula's own limits.
#include "core/design/material.h"
#include "core/physics/sorption.h"

#include <QTest>

using namespace hygroloom;

namespace {

Isotherm isotherm_of(const Material& m) { return {m.standard_regain, m.saturation_regain, m.gab.monolayer_regain, m.gab.c, m.gab.k}; }

Isotherm isotherm_of(const char* name)
{
    for (const Material& m : material_library())
        if (m.name == name) return isotherm_of(m);
    qFatal("no such material");
}

} // namespace

class TestSorption : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void fibresThatTakeUpNothingHaveNoSlope()
    {
        Isotherm nothing;
        nothing.standard_regain = nothing.saturation_regain = 0;
        const RegainLaw law = regain_law(nothing);
        for (double regain : {0.0, 1e-12}) {
            const WithSlope humidity = humidity_at_reference(law, regain);
            QVERIFY(std::isfinite(humidity.value) && std::isfinite(humidity.slope));
        }
        QCOMPARE(regain_at_reference(nothing, 0.7), 0.0);
    }
    void masterCurvePassesItsTable_data()
    {
        QTest::addColumn<double>("humidity");
        QTest::addColumn<double>("ratio");
        QTest::newRow("5 %") << 0.05 << 0.1017;
        QTest::newRow("20 %") << 0.2 << 0.3307;
        QTest::newRow("65 %") << 0.65 << 1.0008;
        QTest::newRow("90 %") << 0.9 << 1.8631;
        QTest::newRow("100 %") << 1.0 << 2.6437;
    }
    void masterCurvePassesItsTable()
    {
        QFETCH(double, humidity);
        QFETCH(double, ratio);
        QVERIFY(std::abs(regain_at_reference({1.0, 10.0, 0, 0, 0}, humidity) - ratio) < 2e-4);
    }
    void fibresHoldTheirStandardRegain_data()
    {
        QTest::addColumn<double>("regain");
        QTest::newRow("cotton") << 0.0706;
        QTest::newRow("wool") << 0.1444;
        QTest::newRow("polyester") << 0.004;
        QTest::newRow("nylon 6.6") << 0.0407;
    }
    void fibresHoldTheirStandardRegain()
    {
        QFETCH(double, regain);
        QVERIFY(std::abs(equilibrium_regain(isotherm_of(QTest::currentDataTag()), 0.65, 293.15) - regain) < 0.01 * regain);
    }
    void regainRisesWithHumidityAndNeverPassesSaturation()
    {
        for (const Material& m : material_library()) {
            const Isotherm isotherm = isotherm_of(m);
            for (double temperature : {263.15, 293.15, 333.15}) {
                double before = -1e-12;
                for (int i = 0; i <= 200; ++i) {
                    const double regain = equilibrium_regain(isotherm, i / 200.0, temperature);
                    QVERIFY2(regain >= before, m.name.c_str());
                    QVERIFY2(regain <= m.saturation_regain, m.name.c_str());
                    before = regain;
                }
            }
            QCOMPARE(equilibrium_regain(isotherm, 1.5, 293.15), equilibrium_regain(isotherm, 1.0, 293.15));
            QCOMPARE(equilibrium_regain(isotherm, -0.5, 293.15), 0.0);
        }
    }
    void warmFibresHoldLessAtTheSameHumidity() // Wiegerink 1940: falls with temperature
    {
        const Isotherm cotton = isotherm_of("cotton");
        QVERIFY(equilibrium_regain(cotton, 0.65, 309.15) < equilibrium_regain(cotton, 0.65, 293.15) - 0.005);
        QVERIFY(equilibrium_regain(cotton, 0.65, 333.15) < equilibrium_regain(cotton, 0.65, 309.15));
    }
    void heatOfSorptionPassesItsTable()
    {
        QVERIFY(std::abs(1e-3 * heat_of_sorption(0.0) - 1161) < 1);
        QVERIFY(std::abs(1e-3 * heat_of_sorption(0.5) - 317) < 1);
        QVERIFY(std::abs(1e-3 * heat_of_sorption(0.9) - 148) < 1);
        QCOMPARE(heat_of_sorption(1.0), 0.0);
    }
    void heatOfWettingAgreesWithMortonAndHearle_data()
    {
        QTest::addColumn<double>("joules"); // table 8.1
        QTest::newRow("cotton") << 46.0;
        QTest::newRow("flax") << 55.0;
        QTest::newRow("wool") << 113.0;
        QTest::newRow("nylon 6.6") << 31.0;
        QTest::newRow("viscose") << 106.0;
        QTest::newRow("silk") << 69.0;
    }
    void heatOfWettingAgreesWithMortonAndHearle()
    {
        QFETCH(double, joules);
        // The law by itself, with the master curve it was made for; what a material is scaled to is the table's value.
        Isotherm master = isotherm_of(QTest::currentDataTag());
        master.monolayer_regain = 0;
        master.saturation_regain = 1;
        const double found = 1e-3 * heat_of_wetting(master);
        QVERIFY2(std::abs(found - joules) < 0.2 * joules, qPrintable(QString::number(found)));
        QCOMPARE(find_library_material(QTest::currentDataTag())->heat_of_wetting_j_g, joules);
    }
    void isothermsHaveTheirInverseAndSlope()
    {
        for (const char* name : {"cotton", "polyester", "acrylic"}) { // fitted, and by the master curve
            const Isotherm isotherm = isotherm_of(name);
            const RegainLaw law = regain_law(isotherm);
            for (double humidity : {0.001, 0.05, 0.3, 0.65, 0.8, 0.9}) {
                const WithSlope regain = regain_at_reference(law, isotherm.saturation_regain, humidity);
                QCOMPARE(regain.value, regain_at_reference(isotherm, humidity));
                if (regain.value >= isotherm.saturation_regain) continue;
                const WithSlope back = humidity_at_reference(law, regain.value);
                QVERIFY(std::abs(back.value - humidity) < 1e-9);
                const double slope =
                    (regain_at_reference(isotherm, humidity + 1e-6) - regain_at_reference(isotherm, humidity - 1e-6)) / 2e-6;
                QVERIFY(std::abs(regain.slope - slope) < 1e-5 * slope);
                QVERIFY(std::abs(back.slope - 1 / slope) < 1e-5 / slope);
            }
            QCOMPARE(humidity_at_reference(law, 0).value, 0.0);
            QVERIFY(humidity_at_reference(law, 10).value <= 1.0);
        }
        QVERIFY(std::abs(sorption_heat_at(0.4).slope - (heat_of_sorption(0.4 + 1e-6) - heat_of_sorption(0.4 - 1e-6)) / 2e-6) < 1.0);
    }
    void regainIsGuggenheimAndersonDeBoersOrTheMasterCurves() // as printed
    {
        const Isotherm cotton = isotherm_of("cotton"), master{0.071, 0.3, 0, 0, 0};
        for (double a : {0.0, 1e-6, 0.1, 0.5, 0.9, 0.99}) {
            const double ka = cotton.gab_k * a;
            const double gab = cotton.monolayer_regain * cotton.gab_c * ka / ((1 - ka) * (1 - ka + cotton.gab_c * ka));
            QVERIFY(std::abs(regain_at_reference(cotton, a) - std::min(gab, cotton.saturation_regain)) <= 1e-14 * gab);
            const double lotens = 0.578 * 0.071 * a * (1 / (a + 0.321) + 1 / (1.262 - a));
            QVERIFY(std::abs(regain_at_reference(master, a) - lotens) <= 1e-14 * lotens);
        }
    }
    void referenceHumidityHoldsTheSameWater() // ln r + q(r) shift = ln a
    {
        for (double celsius : {-10.0, 5.0, 20.0, 29.0, 35.0, 60.0, 90.0})
            for (double a : {1e-9, 1e-3, 0.2, 0.65, 0.95, 0.9999}) {
                const double shift = isotherm_shift(273.15 + celsius);
                for (double guess : {0.0, -0.9 * shift * heat_of_sorption(a), 5.0}) {
                    const ReferenceHumidity r = reference_humidity(a, shift, guess);
                    QVERIFY2(std::abs(std::log(r.humidity / a) + heat_of_sorption(r.humidity) * shift) < 1e-9,
                             qPrintable(QString("%1 C, %2").arg(celsius).arg(a)));
                    QVERIFY(std::abs(r.ratio * a - r.humidity) <= 1e-14 * a);
                    QVERIFY(r.humidity > 0 && r.humidity <= 1);
                }
            }
        QCOMPARE(reference_humidity(0.0, 1e-7, 0.0).humidity, 0.0);
        QCOMPARE(reference_humidity(1.0, -1e-7, 0.0).humidity, 1.0);
    }
    void exponentialOfLittleIsExact()
    {
        for (double x : {-2.0, -0.03, -0.0299, -1e-3, 0.0, 1e-9, 0.01, 0.0299, 0.03, 1.5})
            QVERIFY(std::abs(exp_of_little(x) / std::exp(x) - 1) < 1e-14);
    }
    void twoStageDiffusionIsNeverNegativeAndNeverJumps()
    {
        for (DiffusionLaw law : {DiffusionLaw::cotton_two_stage, DiffusionLaw::wool_two_stage}) {
            double before = fibre_diffusivity({law, 0}, 0, 293.15);
            for (int i = 1; i <= 4000; ++i) {
                const double now = fibre_diffusivity({law, 0}, i * 1e-4, 293.15);
                QVERIFY(now >= 5e-16);
                QVERIFY(std::abs(now - before) < 2e-16);
                before = now;
            }
        }
    }
    void constantDiffusionDoublesInSixteenKelvin()
    {
        const FibreDiffusivity d{DiffusionLaw::constant, 5e-14};
        QCOMPARE(fibre_diffusivity(d, 0.1, 293.15), 5e-14);
        QVERIFY(std::abs(fibre_diffusivity(d, 0.1, 309.15) / 5e-14 - 2.1) < 0.05);
    }
};

QTEST_APPLESS_MAIN(TestSorption)
#include "tst_sorption.moc"
