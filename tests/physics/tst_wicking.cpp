// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Wetting and wicking against hand-worked numbers and limits.
#include "core/physics/finished_face.h"
#include "core/physics/scattered_gate.h"
#include "core/physics/water.h"
#include "core/physics/wetting.h"
#include "core/physics/wicking.h"

#include <QTest>

#include <limits>

using namespace hygroloom;

namespace tst_wicking {
namespace {
constexpr double tension = 0.07274, density = 998.2, viscosity = 1.0016e-3; // water at 20 C
bool within(double value, double expected, double relative) { return std::abs(value - expected) <= relative * std::abs(expected); }
} // namespace

class TestWicking : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aFifthOfAMillimetreSucksSevenHundredPascal()
    {
        QVERIFY(within(capillary_pressure(tension, 0, 0.2e-3), 727.4, 1e-3));
        QVERIFY(within(equilibrium_height(tension, 0, 0.2e-3, density), 74.3e-3, 2e-3));
        QVERIFY(within(equilibrium_height(tension, 0, 0.1e-3, density), 148.6e-3, 1e-3)); // Jurin
    }
    void adhesionTensionChangesSignAtNinetyDegrees()
    {
        QVERIFY(adhesion_tension(tension, radian_from_degree(89.9)) > 0);
        QVERIFY(adhesion_tension(tension, radian_from_degree(90.1)) < 0);
        QVERIFY(within(work_of_adhesion(tension, 0), 2 * tension, 1e-12));
        QVERIFY(std::abs(work_of_adhesion(tension, pi)) < 1e-15);
    }
    /// 8 um fibres packed to a half, 35 degrees in and 0 out, worked by hand.
    void poresBetweenFibresFillAndDrainByOneClosure()
    {
        const PoreClosure pores = pores_of_bundle(0.5, 8e-6, tension, radian_from_degree(35), 0);
        QCOMPARE(pores.shape, 4.0);
        QVERIFY(within(pores.entry_suction, 11172, 1e-4));
        QVERIFY(within(pores.hysteresis, 1.8006, 1e-4));
        QVERIFY(within(pores.threshold, 0.1770, 1e-4));
        QVERIFY(within(pores.front_suction, 17224, 1e-4));
        QCOMPARE(saturation_filling(pores, 0.99 * pores.entry_suction), 1.0);
        QVERIFY(within(imbibition_suction(pores, 0.5), 11172 * 1.189207, 1e-4)); // 2^(1/4)
        QVERIFY(within(saturation_filling(pores, imbibition_suction(pores, 0.5)), 0.5, 1e-12));
        QCOMPARE(imbibition_suction(pores, 0.01), pores.front_suction);
        QVERIFY(within(saturation_filling(pores, 1.025 * pores.front_suction), 0.5 * pores.threshold, 1e-9));
        QCOMPARE(saturation_filling(pores, 1.06 * pores.front_suction), 0.0);
        QCOMPARE(saturation_emptying(pores, 1.8 * 11171), 1.0);
        QVERIFY(within(saturation_emptying(pores, 1.8006 * 11172 * 1.189207), 0.5, 1e-3));
    }
    void closurePoresStayInTheirRangesAtAnyAngleAndPacking()
    {
        for (double packing = 0.05; packing <= 0.95; packing += 0.05)
            for (int degrees = 0; degrees < 90; ++degrees) {
                const double angle = radian_from_degree(degrees);
                const PoreClosure pores = pores_of_bundle(packing, 5e-6, tension, angle, 0.5 * angle);
                QVERIFY(pores.shape >= 3 && pores.shape <= 6 && pores.hysteresis >= 1.1);
                QVERIFY(pores.entry_suction > 0 && pores.front_suction > pores.entry_suction);
                QVERIFY(pores.threshold > 0 && pores.threshold <= 0.3);
                const double gate = gate_of_like_fibres(packing, angle);
                QVERIFY(gate >= 0 && gate < 1);
                QVERIFY(gate_of_like_fibres(packing, angle + 0.01) <= gate);
            }
    }
    void dryFibresTakeNothingInFromTheAngleOnAtWhichGapsNoLongerConnect()
    {
        QVERIFY(within(widest_gap(0), 0.5708, 1e-4)); // Princen: pi / 2 - 1
        QVERIFY(std::abs(widest_gap(0.5 * pi)) < 1e-15);
        QVERIFY(within(connected_gap(0.5), 0.10689, 1e-4));
        QVERIFY(within(gate_of_like_fibres(0.5, radian_from_degree(35)), 0.7030, 1e-4));
        QVERIFY(gate_of_like_fibres(0.5, radian_from_degree(62.7)) > 0);
        QCOMPARE(gate_of_like_fibres(0.5, radian_from_degree(62.8)), 0.0);
        QCOMPARE(gate_of_like_fibres(0.5, radian_from_degree(120)), 0.0);
    }
    void whereAnglesScatterTheGateClosesBySmallSteps()
    {
        for (double open : {0.0, 0.3, 0.4, 0.7, 1.0}) // of a mixture of open and closed pores (Kirkpatrick 1973)
            QVERIFY(std::abs(conductance_of_mixture({{open, 1}, {1 - open, 0}}) - std::max(0.0, 1.5 * open - 0.5)) < 1e-12);
        const auto gate = [](double packing, double degrees) { return gate_of_dry_fibres(packing, radian_from_degree(degrees)); };
        const struct {
            double degrees, loose, close; // at packings of 0.5 and 0.7, by Gauss and Hermite's quadrature
        } known[] = {{35, .647, .909},  {45, .482, .857}, {55, .246, .731}, {60, .128, .621}, {65, .038, .480},
                     {70, .0018, .317}, {75, 2e-6, .157}, {80, 0, .038},    {85, 0, .0009}};
        for (const auto& k : known)
            QVERIFY(std::abs(gate(0.5, k.degrees) - k.loose) < 0.005 && std::abs(gate(0.7, k.degrees) - k.close) < 0.005);
        QVERIFY(gate(0.5, 75) > 0 && gate(0.5, 80) == 0 && gate(0.5, 90) == 0);
        for (int degrees = 0; degrees < 89; ++degrees) QVERIFY(gate(0.6, degrees + 1) <= gate(0.6, degrees));
        QCOMPARE(gate_of_dry_fibres(0.5, 0.6, 0), gate_of_like_fibres(0.5, 0.6));
    }
    void aColumnBetweenTwoRodsStandsAsPrincenSays()
    {
        const RodColumn column = rod_column(100e-6, 30e-6, radian_from_degree(35), tension, 1e3);
        QVERIFY(within(column.contact_line, radian_from_degree(23.338), 1e-4));
        QVERIFY(within(column.area, 4058.8e-12, 1e-4));
        QCOMPARE(rod_column(100e-6, 60e-6, radian_from_degree(35), tension, 1e3).area, 0.0); // the meniscus is too narrow: 59.6 um
        for (double half_gap = 1e-6; half_gap < 1; half_gap *= 1.2) { // between thin rods both menisci meet before that
            const double area = rod_column(0.3e-6, half_gap, radian_from_degree(55), tension, 12).area;
            QVERIFY(half_gap < 45e-6 ? area > 0 : half_gap < 46e-6 || area == 0);
        }
    }
    void waterPassesAHoleAtThePressureOfItsNarrowestMeniscus()
    {
        const auto square = [](double degrees) {
            return breakthrough_pressure(tension, radian_from_degree(degrees), 1e-4, 43e-6, 1e-4, 43e-6);
        };
        QVERIFY(within(square(89), 1399.1, 1e-4));
        QVERIFY(within(square(60), 888.2, 1e-4));
        QVERIFY(within(square(110), 1976.9, 1e-4));
        const double slot =
            breakthrough_pressure(tension, radian_from_degree(89), 1e-4, 43e-6, 1e-4, std::numeric_limits<double>::infinity());
        QVERIFY(within(slot, 699.6, 1e-4));
        QVERIFY(within(1.0 / meniscus_curvature(1e-4, 43e-6, 0), 43e-6, 1e-12)); // between the nearest points
    }
    void aFinishCoversWhatSectionAndPathSay()
    {
        const FinishedYarn round{1, 1, 0.5}, spun{1.25, 1, 0.5};
        QVERIFY(within(share_of_section_above(round, 0.5), 0.5, 1e-12) && within(share_of_outline_above(spun, 0.5), 0.5, 1e-12));
        QVERIFY(within(share_of_section_above(round, 0.25), 1.0 / 3 - std::sqrt(3.0) / (4 * pi), 1e-12)); // a segment of 120 degrees
        QVERIFY(within(share_of_outline_above(round, 0.25), 1.0 / 3, 1e-12));
        QVERIFY(share_of_section_above(spun, 0) == 0 && share_of_section_above(spun, 1) == 1 && share_of_section_above(spun, 9) == 1);
        const struct {
            double depth, crown, all; // of a plain cloth of level faces, computed apart from drawn sections
        } known[] = {{.05, .054, .008}, {.10, .143, .028}, {.20, .362, .099}, {.25, .477, .147}, {.33, .672, .243}, {.50, .995, .50}};
        for (const auto& k : known) {
            const FinishedShares shares = shares_in_finish(spun, 2, 2 * k.depth);
            QVERIFY2(std::abs(shares.crown - k.crown) < 0.005 && std::abs(shares.all - k.all) < 0.002,
                     qPrintable(QString("%1: %2, %3").arg(k.depth).arg(shares.crown).arg(shares.all)));
        }
        QVERIFY(!shares_in_finish(spun, 2, 1).goes_through());
        const FinishedShares through = shares_in_finish(spun, 2, 2), none = shares_in_finish(spun, 2, 0);
        QVERIFY(through.goes_through() && within(through.section, 1, 1e-12) && within(through.outline, 1, 1e-12));
        QVERIFY(none.crown == 0 && none.outline == 0 && none.all == 0);
        QCOMPARE(shares_in_finish({1.25, 1, 0.3}, 2, 0.2).crown, 0.0); // a yarn that lies below the face
    }
    void liquidPassesAFinishAtThePressureOfTheWayToItsDepth()
    {
        const double depths[] = {.05, .10, .15, .20, .25, .33, .50};
        const struct {
            double degrees, half_gap_um, pressure[7]; // Pa, computed apart
        } known[] = {{100, 125, {0, 0, 0, 0, 106, 288, 611}},
                     {110, 125, {0, 0, 0, 86, 203, 385, 698}},
                     {120, 125, {0, 0, 60, 177, 295, 475, 779}},
                     {130, 125, {0, 26, 141, 259, 377, 557, 853}},
                     {110, 60, {0, 0, 0, 240, 572, 1059, 1631}}};
        for (const auto& k : known)
            for (int i = 0; i < 7; ++i) {
                const double found =
                    pressure_past_finish(0.0728, radian_from_degree(k.degrees), 62e-6, 1e-6 * k.half_gap_um, depths[i] * 250e-6);
                QVERIFY2(std::abs(found - k.pressure[i]) <= 3, qPrintable(QString("%1, %2: %3").arg(k.degrees).arg(depths[i]).arg(found)));
            }
        const auto past = [](double degrees, double depth) {
            return pressure_past_finish(tension, radian_from_degree(degrees), 62e-6, 125e-6, depth);
        };
        const double by_itself = 62e-6 * (1 + std::cos(radian_from_degree(120)));
        QVERIFY(past(120, 0.999 * by_itself) == 0 && past(120, 1.01 * by_itself) > 0);
        const double slot = breakthrough_pressure(tension, radian_from_degree(120), 62e-6, 125e-6, 62e-6, 125e-6);
        QVERIFY(within(past(120, 1), slot, 1e-5)); // all the way through: the hole's own
        for (double depth = 0; depth < 250e-6; depth += 5e-6) QVERIFY(past(120, depth + 5e-6) >= past(120, depth));
    }
    void hairsLeaveOpenWhatRandomCoverDoes()
    {
        QCOMPARE(share_between_hairs(0), 1.0);
        QVERIFY(within(share_between_hairs(4 * std::log(2.0)), 0.5, 1e-12));                             // a cover of ln 2
        QVERIFY(within(share_between_hairs(3), share_between_hairs(1) * share_between_hairs(2), 1e-12)); // one coat over another
    }
    void aDropStandsOnWhatItsAngleAndTheCoverLeaveIt()
    {
        QVERIFY(within(cosine_on_fabric(radian_from_degree(35), 1), std::cos(radian_from_degree(35)), 1e-12));
        QVERIFY(within(cosine_on_fabric(pi / 2, 0.5), -0.5, 1e-12));                  // half of it stands on air
        QVERIFY(within(base_of_drop(0), pi / std::cbrt(4.0 * pi * pi / 9.0), 1e-12)); // half a ball: pi r2 and 2/3 pi r3
        // A flat cap is nearly a paraboloid of a slope of its angle: pi r2 and pi r3 angle / 4.
        constexpr double angle = 0.05;
        QVERIFY(within(base_of_drop(std::cos(angle)), pi / std::pow(pi * angle / 4.0, 2.0 / 3.0), 1e-3));
        QVERIFY(within(base_of_drop(-0.98), pi * (1 - 0.98 * 0.98) / std::pow(4.0 / 3.0 * pi, 2.0 / 3.0), 1e-3)); // nearly a ball
    }
    void bundlePoresFollowFibreAndPacking()
    {
        QVERIFY(within(bundle_pore_radius(8e-6, 0.5), 8e-6, 1e-12));
        QVERIFY(within(bundle_pore_radius(8e-6, 0.6), 5.33e-6, 1e-3));
    }
    void permeabilityHasGebartsValues()
    {
        QVERIFY(within(permeability_along(8e-6, 0.5), 4.83e-12, 2e-3));
        QVERIFY(within(permeability_along(8e-6, 0.7), 5.32e-13, 2e-3));
        QVERIFY(within(permeability_across(8e-6, 0.5), 1.05e-12, 1e-2));
        QVERIFY(within(permeability_across(6e-6, 0.6), 2.10e-13, 1e-2));
        QCOMPARE(permeability_across(8e-6, 0.91), 0.0);
    }
    void rodsAtRandomLetMoreThroughAlong() // as flow past hard discs at random has it
    {
        const double packings[] = {0.35, 0.45, 0.5, 0.6, 0.7}, found[] = {0.349, 0.138, 0.0889, 0.0324, 0.0096};
        for (int i = 0; i < 5; ++i) QVERIFY(within(permeability_along_random(1, packings[i]), found[i], 0.035));
    }
    void liquidWaitsAtTheSkinOfFlatFilament()
    {
        const double angle = radian_from_degree(75), section = 8.6e-9;
        QCOMPARE(entry_across_fibres(0.7, angle, 6, section, 0), 1.0); // crimped fibres
        QVERIFY(within(entry_across_fibres(0.7, angle, 6, section, 0.04), 6.45e-5, 1e-2));
        QVERIFY(within(entry_across_fibres(0.7, angle, 6, section, 0.005), 64 * 6.45e-5, 1e-2));
        QCOMPARE(entry_across_fibres(0.7, angle, 6, 1, 0.005), 1.0);
        QCOMPARE(entry_across_fibres(0.8, radian_from_degree(24), 6, 0, 0.04), 1.0); // menisci merge from rod to rod
        QCOMPARE(entry_across_fibres(0.8, radian_from_degree(30), 6, 0, 0.04), 0.5);
        QCOMPARE(entry_across_fibres(0.8, radian_from_degree(36), 6, 0, 0.04), 0.0);
        QCOMPARE(entry_across_fibres(0.65, 0.0, 6, 0, 0.04), 0.0);
    }
    void bundlesOfAnyPackingHavePores() // from nearly none to nearly nothing but
    {
        double radius = 1, along = 1, across = 1;
        for (double packing : {0.01, 0.1, 0.5, 0.85, 0.906899, 0.9069, 0.95, 0.99}) {
            const double r = bundle_pore_radius(8e-6, packing), k = permeability_along(8e-6, packing);
            QVERIFY(r > 0 && r < radius && k > 0 && k < along);
            const double less = permeability_across(8e-6, packing);
            QVERIFY(less >= 0 && (less < across || less == 0));
            radius = r, along = k, across = less;
        }
        QCOMPARE(across, 0.0);
    }
    void diffusivityHasTheDerivedMagnitude()
    {
        QVERIFY(within(saturated_liquid_diffusivity(tension, 0, 10e-6, viscosity), 3.63e-5, 2e-3));
        QVERIFY(within(saturated_liquid_diffusivity(tension, 0, 2e-6, viscosity), 7.26e-6, 2e-3));
    }
    void nothingWicksFromNinetyDegrees_data()
    {
        QTest::addColumn<double>("degrees");
        for (double degrees : {90.0, 90.1, 120.0, 180.0}) QTest::addRow("%g", degrees) << degrees;
    }
    void nothingWicksFromNinetyDegrees()
    {
        QFETCH(double, degrees);
        QCOMPARE(saturated_liquid_diffusivity(tension, radian_from_degree(degrees), 8e-6, viscosity), 0.0);
    }
    void potentialIsTheIntegralOfTheDiffusivity()
    {
        double sum = 0;
        constexpr int n = 1000;
        for (int i = 0; i < n; ++i) sum += (i + 0.5) / n * 0.8 * 0.8 / n; // of D over that at saturation
        QVERIFY(within(spreading_potential(0.8), sum, 1e-9));
        QCOMPARE(spreading_potential(0.0), 0.0);
    }
    void warmWaterWicksTwoPerCentFasterPerKelvin()
    {
        const auto speed = [](double t) { return water_surface_tension(t) / water_viscosity(t); };
        QVERIFY(within(speed(293.15), 72.6, 5e-3));
        QVERIFY(within(speed(309.15), 99.6, 5e-3));
    }
};

} // namespace tst_wicking

QTEST_APPLESS_MAIN(tst_wicking::TestWicking)
#include "tst_wicking.moc"
