// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/design.h"

#include <QTest>

#include <cmath>
#include <set>

using namespace hygroloom;

namespace tst_material {
namespace {

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

double gab(const Material& material, double humidity)
{
    const double ka = material.gab.k * humidity;
    return material.gab.monolayer_regain * material.gab.c * ka / ((1 - ka) * (1 - ka + material.gab.c * ka));
}

} // namespace

class TestMaterial : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theLibraryHasTheUsualFibres()
    {
        for (const char* name : {"cotton", "wool", "polyester", "hemp", "flax", "silk", "viscose", "nylon 6.6", "acrylic"})
            QVERIFY2(find_library_material(name), name);
        QVERIFY(!find_library_material("stone"));
    }
    void cottonAbsorbsSevenPercentAtStandardHumidity()
    {
        const Material& cotton = *find_library_material("cotton");
        QVERIFY(near(gab(cotton, 0.65), 0.0706, 0.0005));
        QVERIFY(near(gab(cotton, 1.0), 0.239, 0.001));
        QCOMPARE(cotton.density_kg_m3, 1550.0);
    }
    void isothermsAgreeWithStandardRegains()
    {
        for (const Material& material : material_library())
            if (material.gab.given()) QVERIFY2(near(gab(material, 0.65), material.standard_regain, 0.002), material.name.c_str());
    }
    void standardRegainsArePublishedAbsorptionValues()
    {
        // Morton & Hearle 2008, 65 % and 20 C, within 0.5 % of regain; commercial regains (flax, hemp 12 %) would fail.
        QVERIFY(near(find_library_material("flax")->standard_regain, 0.07, 0.0051));
        QVERIFY(near(find_library_material("hemp")->standard_regain, 0.08, 0.005));
        QVERIFY(near(find_library_material("silk")->standard_regain, 0.10, 0.005));
        QVERIFY(near(find_library_material("wool")->standard_regain, 0.14, 0.0051));
    }
    void projectMaterialsComeBeforeTheLibrary()
    {
        Design design;
        Material own = *find_library_material("cotton");
        own.density_kg_m3 = 1500;
        design.materials.push_back(own);
        QCOMPARE(find_material(design, "cotton")->density_kg_m3, 1500.0);
        QCOMPARE(find_material(design, "wool")->density_kg_m3, 1300.0);
        QVERIFY(!find_material(design, "stone"));
    }
    void aBlendsDensityIsByVolume()
    {
        // 0.6/1550 + 0.4/1390 = 6.748666e-4 m3/kg
        const Material blend = blended_material({}, {{"cotton", 0.6}, {"polyester", 0.4}});
        QVERIFY(near(blend.density_kg_m3, 1481.774, 0.01));
        QCOMPARE(blend.name, std::string("60 % cotton, 40 % polyester"));
    }
    void aBlendsRegainIsByMass()
    {
        const Material blend = blended_material({}, {{"cotton", 0.6}, {"polyester", 0.4}});
        QVERIFY(near(blend.standard_regain, 0.6 * 0.071 + 0.4 * 0.004, 1e-12));
        QVERIFY(near(gab(blend, 0.65), blend.standard_regain, 1e-12));
        QVERIFY(near(blend.gab.c, 10.48, 1e-9));
    }
    void aBlendOfOneFibreWithItselfIsThatFibre()
    {
        Design design;
        Material twin = *find_library_material("cotton");
        twin.name = "twin";
        design.materials.push_back(twin);
        const Material blend = blended_material(design, {{"cotton", 0.5}, {"twin", 0.5}});
        QVERIFY(near(blend.fibre_radius_um, 5.73, 1e-12));
        QVERIFY(near(blend.density_kg_m3, 1550, 1e-9));
        QVERIFY(near(gab(blend, 0.9), gab(twin, 0.9) * 0.071 / gab(twin, 0.65), 1e-12));
    }
    void aBlendKeepsTheSurfaceOfItsFibres()
    {
        // Surface per kg is 2/(density x radius): the blend's is the mass mean.
        const Material blend = blended_material({}, {{"wool", 0.25}, {"polyester", 0.75}});
        const double surface = 0.25 * 2 / (1300 * 10) + 0.75 * 2 / (1390 * 6.5);
        QVERIFY(near(2 / (blend.density_kg_m3 * blend.fibre_radius_um), surface, 1e-12));
    }
    void waterDrawsBackFromCelluloseAtNoAngleAndFromOthersTwentyDegreesLower()
    {
        for (const Material& fibre : material_library()) {
            const bool cellulose = std::set<std::string>{"cotton", "flax", "hemp", "viscose", "lyocell", "modal"}.contains(fibre.name);
            const double expected = cellulose ? 0 : fibre.contact_angle_deg - 20;
            QVERIFY2(receding_angle_under(fibre, fibre.contact_angle_deg) == expected, fibre.name.c_str());
            QVERIFY2(receding_angle_under(fibre, 10) == 0, fibre.name.c_str()); // never below 0
            QVERIFY2(receding_angle_under(fibre, 110) == (cellulose ? 0 : 90), fibre.name.c_str());
        }
    }
    void aMaterialOfTheProjectRecedesAsGivenElseAsItsBase()
    {
        Material own = *find_library_material("viscose");
        own.name = "my viscose";
        own.based_on = "viscose";
        own.contact_angle_deg = 60;
        QCOMPARE(receding_angle_under(own, 60), 0.0);
        own.based_on.clear();
        QCOMPARE(receding_angle_under(own, 60), 40.0); // what it is made of is not known
        own.receding_angle_deg = 30;
        QCOMPARE(receding_angle_under(own, 60), 30.0);
        QCOMPARE(receding_angle_under(own, 25), 25.0); // a finish: never above the contact angle
    }
    void aBlendRecedesAndHasSurfaceByItsShares()
    {
        // Polyester 45 - 20, cotton 0; under a finish of 70 degrees polyester 50, cotton 0.
        const std::vector<MaterialShare> shares{{"cotton", 0.6}, {"polyester", 0.4}};
        QVERIFY(near(*blended_material({}, shares).receding_angle_deg, 0.4 * 25, 1e-12));
        QVERIFY(near(receding_angle_of({}, shares, 70), 0.4 * 50, 1e-12));
        Design design;
        Material twin = *find_library_material("cotton");
        twin.name = "twin";
        twin.cross_section = {1.5, {}};
        design.materials.push_back(twin);
        QVERIFY(near(blended_material(design, {{"cotton", 0.5}, {"twin", 0.5}}).cross_section.perimeter_factor, 1.41, 1e-12));
        for (const Material& fibre : material_library())
            QCOMPARE(fibre.cross_section.perimeter_factor, fibre.name == "cotton" ? 1.32 : 1.0);
    }
    void theShapesOfFibresHaveTheFactorsOfTheirOutlines()
    {
        const auto factor = [](const char* name) {
            for (const CrossSection& one : cross_sections())
                if (one.shape == name) return one.perimeter_factor;
            return 0.0;
        };
        QCOMPARE(factor("round"), 1.0);
        QVERIFY(near(factor("bean"), 1 / std::sqrt(0.577), 0.005));
        QVERIFY(factor("channelled") > 1);
        double perimeter = 0, area = 0; // of r = 1 + cos(3 phi) / 3
        constexpr int steps = 3000;
        for (int i = 0; i < steps; ++i) {
            const double angle = 2 * M_PI * (i + 0.5) / steps, r = 1 + std::cos(3 * angle) / 3;
            perimeter += std::hypot(r, std::sin(3 * angle)) * 2 * M_PI / steps;
            area += 0.5 * r * r * 2 * M_PI / steps;
        }
        QVERIFY(near(factor("trilobal"), perimeter / std::sqrt(4 * M_PI * area), 0.005));
    }
    void blendsWithoutIsothermUseTheMasterCurve() { QVERIFY(!blended_material({}, {{"acrylic", 0.5}, {"polyester", 0.5}}).gab.given()); }
};

} // namespace tst_material

QTEST_APPLESS_MAIN(tst_material::TestMaterial)
#include "tst_material.moc"
