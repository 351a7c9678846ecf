// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/units.h"
#include "core/design/fitted_fabric.h"
#include "core/design/validate.h"
#include "core/design/yarn_class.h"
#include "core/project/project_file.h"

#include <QTest>

#include <cmath>

using namespace hygroloom;

namespace tst_quantities {
namespace {

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

Yarn yarn(const char* material, double diameter_mm)
{
    Yarn made;
    made.material = {{material, 1.0}};
    made.diameter_mm = diameter_mm;
    return made;
}

Fabric square_cloth(const Yarn& both, double per_cm)
{
    Fabric fabric;
    fabric.name = "cloth";
    fabric.warp = fabric.weft = both;
    fabric.ends_per_cm = fabric.picks_per_cm = per_cm;
    return fabric;
}

Design example(const std::string& file) { return read_project(std::string(HYGROLOOM_SOURCE_DIR) + "/resources/examples/" + file); }

} // namespace

class TestQuantities : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aCottonYarnOfAFifthMillimetreIsTwentyFourTex()
    {
        // 0.5 x 1550 kg/m3 x pi/4 x 0.04 mm2 = 24.347 g/km
        const FreeYarn free = free_yarn(yarn("cotton", 0.2), 1550, 0.5);
        QVERIFY(near(free.linear_density_tex, 24.347, 0.001));
        QCOMPARE(free.packing_factor, 0.5);
    }
    void peircesDiameterFollowsFromHisSpecificVolume()
    {
        // d[mm] = 0.0375 sqrt(tex) is a specific volume of 1.1 cm3/g: a packing of 1/(1.1 x 1.55).
        for (double tex : {10.0, 29.525, 100.0}) {
            Yarn given;
            given.linear_density_tex = tex;
            given.packing_factor = 1 / (1.1 * 1.55);
            QVERIFY(near(free_yarn(given, 1550, 0.5).diameter, 0.0375 * std::sqrt(tex), 0.003 * 0.0375 * std::sqrt(tex)));
        }
    }
    void countTwentyIsAFifthMillimetre()
    {
        Yarn given;
        given.linear_density_tex = tex_from_ne(20);
        given.packing_factor = 0.6;
        QVERIFY(near(free_yarn(given, 1520, 0.5).diameter, 0.203, 0.001));
    }
    void diameterAndLinearDensityGiveThePacking()
    {
        Yarn given = yarn("cotton", 0.2);
        given.linear_density_tex = 0.6 * 48.694;
        QVERIFY(near(free_yarn(given, 1550, 0.5).packing_factor, 0.6, 1e-4));
    }
    void packingFollowsFromHowAYarnIsMade()
    {
        const auto packing = [](const Yarn& given) { return free_yarn({}, given).packing_factor; };
        const auto kind = [](const Yarn& given) { return yarn_class_of({}, given); };
        Yarn given;
        given.linear_density_tex = 25;
        given.twist_per_m = 760; // a twist factor of 3800
        QVERIFY(kind(given) == YarnClass::ring && near(packing(given), 0.60, 1e-12));
        given.twist_per_m = 400;
        QVERIFY(near(packing(given), 0.60 * std::pow(2000.0 / 3800, 0.25), 1e-12));
        given.twist_per_m = 5000;
        QCOMPARE(packing(given), 0.68);
        given.twist_per_m = 50;
        QCOMPARE(packing(given), 0.45);
        given.plies = 2;
        QVERIFY(kind(given) == YarnClass::plied && packing(given) == 0.58);
        given.yarn_class = YarnClass::rotor; // what the yarn says counts
        QVERIFY(kind(given) == YarnClass::rotor && packing(given) == 0.55);
        given.packing_factor = 0.5;
        QCOMPARE(packing(given), 0.5);

        Yarn filament;
        filament.material = {{"polyester", 1.0}};
        filament.linear_density_tex = 8.3;
        filament.twist_per_m = 100;
        QVERIFY(kind(filament) == YarnClass::flat && packing(filament) == 0.70);
        filament.material = {{"silk", 1.0}};
        QCOMPARE(packing(filament), 0.65);
        filament.yarn_class = YarnClass::textured;
        QCOMPARE(packing(filament), 0.50);
        filament.yarn_class.reset();
        filament.packing_factor = 0.5;
        QVERIFY(kind(filament) == YarnClass::textured);
        filament.packing_factor.reset();
        filament.diameter_mm = 0.1;
        QVERIFY2(kind(filament) == YarnClass::textured, "as the packing of 0.5 says that its diameter assumes");
        filament.diameter_mm.reset();
        filament.packing_factor = 0.5;
        filament.yarn_class = YarnClass::monofilament;
        QCOMPARE(usual_shape({}, filament, free_yarn({}, filament)), 1.0);
        Design nets;
        nets.fabrics.resize(1);
        nets.fabrics[0].warp = filament;
        const FittedYarn one = fit_yarns(nets, nets.fabrics[0]).warp[0];
        QVERIFY2(near(one.fibre.fibre_radius_um, 500 * one.free.diameter * std::sqrt(one.free.packing_factor), 1e-6), "one fibre");
        nets.fabrics[0].warp.plies = 3;
        const std::vector<Issue> issues = validate(nets);
        QVERIFY(
            std::any_of(issues.begin(), issues.end(), [](const Issue& issue) { return issue.where.text() == "fabrics[0].warp.plies"; }));
        filament.yarn_class = YarnClass::ring; // of staple, though hardly twisted
        QVERIFY(!is_filament({}, filament) && typical_unevenness({}, filament).cv > 0.05);

        given = Yarn();
        given.diameter_mm = 0.2;
        QCOMPARE(packing(given), 0.5);
    }
    void clothPressesYarnsThatAreGivenByTheirCount()
    {
        Fabric fabric = square_cloth(Yarn(), 15);
        fabric.warp.linear_density_tex = fabric.weft.linear_density_tex = 20;
        const Yarn& given = fabric.warp;
        const FreeYarn free = free_yarn({}, given);
        const double shape = usual_shape({}, given, free), area = 0.25 * pi * free.diameter * free.diameter;
        const double height = std::sqrt(area * shape / (1 - (1 - 0.25 * pi) * shape)); // of a racetrack of that shape
        const FabricQuantities q = derive_quantities({}, fabric);
        QVERIFY(near(q.warp.section_mm.height, 0.925 * height, 1e-9));
        QVERIFY(near(section_area(q.warp.section_mm), area, 1e-9));
        QVERIFY(near(q.thickness_1kpa_mm, q.yarn_layer_thickness_mm + 0.02, 1e-12));
        fabric.warp.yarn_class = YarnClass::rotor; // its fibres stand out further
        QVERIFY(near(derive_quantities({}, fabric).thickness_1kpa_mm - derive_quantities({}, fabric).yarn_layer_thickness_mm, 0.03, 1e-12));
        fabric.warp.yarn_class = YarnClass::monofilament; // nothing presses it
        const FabricQuantities mono = derive_quantities({}, fabric);
        QVERIFY(near(mono.warp.section_mm.height, mono.warp.diameter_mm, 1e-9));
    }
    void aGivenThicknessLoosensYarnsBeforeItBecomesLoops()
    {
        Fabric fabric = square_cloth(Yarn(), 24);
        fabric.picks_per_cm = 22;
        for (Yarn* yarn : {&fabric.warp, &fabric.weft}) {
            yarn->linear_density_tex = 20;
            yarn->packing_factor = 0.55;
        }
        const FabricQuantities natural = derive_quantities({}, fabric);
        fabric.thickness_mm = 1.05 * natural.yarn_layer_thickness_mm + 0.02; // fibres that stand out are 0.02 mm of it
        const FabricQuantities a_little = derive_quantities({}, fabric);
        QVERIFY2(near(a_little.yarn_layer_thickness_mm, 1.05 * natural.yarn_layer_thickness_mm, 1e-5),
                 qPrintable(QString::number(a_little.yarn_layer_thickness_mm / natural.yarn_layer_thickness_mm)));
        QVERIFY(a_little.warp.packing_factor_in_fabric < 0.53 && a_little.warp.pore_radius_um > 1.05 * natural.warp.pore_radius_um);
        QVERIFY(std::any_of(a_little.notes.begin(), a_little.notes.end(), [](const Message& note) {
            return english(note).find("loosened from a packing of 0.55") != std::string::npos;
        }));
        fabric.thickness_mm = 1.4 * natural.yarn_layer_thickness_mm;
        const FabricQuantities much = derive_quantities({}, fabric);
        QVERIFY(near(much.warp.packing_factor_in_fabric * much.warp.area_share, loosest_in_cloth, 1e-9));
        QVERIFY(much.yarn_layer_thickness_mm < 1.2 * natural.yarn_layer_thickness_mm); // the rest are loops
    }
    void arealDensityIsMassOfBothSystemsWithCrimp()
    {
        const Fabric fabric = square_cloth(yarn("cotton", 0.2), 20);
        const FabricQuantities q = derive_quantities({}, fabric);
        // tex per cm is 0.1 g/m2: 2 x 20 x 24.347 / 10 = 97.39 before crimp.
        QVERIFY(near(q.areal_density_g_m2, 97.388 * (1 + 0.01 * q.warp.crimp_percent), 0.01));
        QVERIFY(near(q.warp.crimp_percent, q.weft.crimp_percent, 1e-9));
        QVERIFY(q.warp.crimp_percent > 5 && q.warp.crimp_percent < 15);
        QVERIFY(!q.jammed);
    }
    void squareJammedClothHasTheTextbooksCrimp()
    {
        // Round yarns just jammed: pitch / (d1 + d2) = 0.866, crimp 20.9 %.
        const double pitch = 0.5 * std::sqrt(3.0) * 0.4;
        const FabricQuantities q = derive_quantities({}, square_cloth(yarn("cotton", 0.2), 10 / (pitch * 1.000001)));
        QVERIFY(near(q.warp.crimp_percent, 20.9, 0.1));
        QVERIFY(derive_quantities({}, square_cloth(yarn("cotton", 0.2), 10 / (0.99 * pitch))).jammed);
    }
    void coverAndGapsFollowFromSettAndDiameter()
    {
        const FabricQuantities q = derive_quantities({}, square_cloth(yarn("cotton", 0.2), 25));
        QVERIFY(near(q.warp.cover, 0.5, 1e-12));
        QVERIFY(near(q.cover_factor, 0.75, 1e-12));
        QVERIFY(near(q.gap_warp_mm, 0.2, 1e-12));
        QVERIFY(near(q.inter_yarn_pore_radius_um, 100, 1e-9)); // 2A/P of a square hole is half its side
    }
    void poresBetweenFibresFollowThePacking()
    {
        // r (1 - phi)/phi: 5.73 um at 0.5, 3.82 um at 0.6
        QVERIFY(near(derive_quantities({}, square_cloth(yarn("cotton", 0.2), 25)).warp.pore_radius_um, 5.73, 1e-9));
        Yarn compact = yarn("cotton", 0.2);
        compact.packing_factor = 0.6;
        QVERIFY(near(derive_quantities({}, square_cloth(compact, 25)).warp.pore_radius_um, 3.82, 1e-9));
    }
    void porosityIsTheShareWithoutFibre()
    {
        const Fabric fabric = square_cloth(yarn("wool", 0.2), 25);
        const FabricQuantities q = derive_quantities({}, fabric);
        QVERIFY(near(q.thickness_mm, 0.4, 1e-12));
        QVERIFY(near(q.porosity, 1 - q.areal_density_g_m2 / (0.4e-3 * 1300e3), 1e-12));
        QVERIFY(near(q.porosity, 1 - q.fibre_volume_fraction, 1e-12));
    }
    void loopsAddToTheThickness()
    {
        Fabric fabric = square_cloth(yarn("wool", 0.2), 25);
        fabric.flyaway.loop_height_mm = 0.1;
        QVERIFY(near(derive_quantities({}, fabric).thickness_mm, 0.6, 1e-12));
    }
    void thicknessBeyondTheYarnsIsHair()
    {
        const Design design = example("textile-E.hygro");
        const FabricQuantities q = derive_quantities(design, design.fabrics[0]);
        QCOMPARE(q.yarn_layer_thickness_mm, 0.4);
        QCOMPARE(q.thickness_mm, 1.46);
        QVERIFY(!q.warp.flattened);
        QVERIFY(std::any_of(q.notes.begin(), q.notes.end(), [](const Message& note) {
            return english(note).find("1.06 mm of the given thickness are flyaway fibres") != std::string::npos;
        }));
    }
    void thinFabricFlattensItsYarnsAndKeepsTheirArea()
    {
        Fabric fabric = square_cloth(yarn("cotton", 0.2), 20);
        fabric.thickness_mm = 0.3;
        const FabricQuantities q = derive_quantities({}, fabric);
        QVERIFY(q.warp.flattened);
        QVERIFY(near(q.warp.section_mm.height, 0.15, 1e-12));
        QVERIFY(near(section_area(q.warp.section_mm), 0.25 * pi * 0.04, 1e-12));
        QVERIFY(near(q.warp.packing_factor_in_fabric, 0.5, 1e-12));
        QVERIFY(near(q.yarn_layer_thickness_mm, 0.3, 1e-12));
    }
    void textileDOfThePaperIsFlattenedAndNarrowed()
    {
        const Design design = example("textile-D.hygro");
        const FabricQuantities q = derive_quantities(design, design.fabrics[0]);
        // 0.30 x 1480 x pi/4 x 0.16 = 55.8 tex; b = 0.215 mm; a = 0.98 of 0.3030 and of 0.3571 mm.
        QVERIFY(near(q.warp.linear_density_tex, 55.79, 0.01));
        QVERIFY(near(q.warp.section_mm.height, 0.215, 1e-9));
        QVERIFY(near(q.warp.section_mm.width, 0.29697, 1e-4));
        QVERIFY(near(q.weft.section_mm.width, 0.35, 1e-4));
        // Racetrack of 0.297 x 0.215: pi/4 x 0.215^2 + 0.082 x 0.215 = 0.05393 mm2; 0.0377/0.05393 = 0.699.
        QVERIFY(near(q.warp.area_share * q.warp.packing_factor_in_fabric, 0.699, 0.001)); // where they cross
        QVERIFY(q.warp.packing_factor_in_fabric <= densest_squeezed);
        QVERIFY(q.porosity > 0);
        QVERIFY(q.notes.size() >= 4);
    }
    void linearDensityIsKeptWhateverTheSection()
    {
        for (const char* file : {"textile-A.hygro", "textile-C.hygro", "textile-D.hygro", "textile-G.hygro"}) {
            const Design design = example(file);
            const FabricQuantities q = derive_quantities(design, design.fabrics[0]);
            const double density = find_material(design, design.fabrics[0].warp.material[0].name)->density_kg_m3;
            QVERIFY(near(q.warp.packing_factor_in_fabric * density * q.warp.area_share * section_area(q.warp.section_mm),
                         q.warp.linear_density_tex, 1e-9));
        }
    }
    void yarnsWiderThanTheirPitchAreSqueezedWithoutAThickness()
    {
        const FabricQuantities q = derive_quantities({}, square_cloth(yarn("cotton", 0.2), 55)); // pitch 0.1818 mm
        QVERIFY(near(q.warp.section_mm.width, 0.98 * 10 / 55, 1e-12));
        QVERIFY(q.warp.packing_factor_in_fabric > 0.5);
        QVERIFY(q.warp.section_mm.height <= q.warp.section_mm.width + 1e-12);
    }
    void crimpIsOnlyWhereAYarnChangesSides()
    {
        Fabric fabric = square_cloth(yarn("cotton", 0.2), 20);
        const double plain = derive_quantities({}, fabric).warp.crimp_percent;
        fabric.weave = weave_from_pattern("twill 2/2 Z");
        QVERIFY(near(derive_quantities({}, fabric).warp.crimp_percent, 0.5 * plain, 1e-12));
        fabric.weave = weave_from_pattern("satin 5/2");
        QVERIFY(near(derive_quantities({}, fabric).warp.crimp_percent, 0.4 * plain, 1e-12));
    }
    void laboratoryValuesAreUsedAndLeaveTheDerivedOnesAlone()
    {
        Fabric fabric = square_cloth(yarn("cotton", 0.2), 20);
        const FabricQuantities derived = derive_quantities({}, fabric);
        fabric.measured.areal_density_g_m2 = 0.9 * derived.areal_density_g_m2;
        QCOMPARE(derive_quantities({}, fabric).areal_density_g_m2, derived.areal_density_g_m2);
        const FabricQuantities used = quantities_in_use({}, fabric);
        QVERIFY(near(used.areal_density_g_m2, 0.9 * derived.areal_density_g_m2, 1e-9));
        QVERIFY(near(used.warp.packing_factor_in_fabric, 0.45, 1e-12)); // 0.9 x 0.5: the sections stay
        QVERIFY(near(1 - used.porosity, 0.9 * (1 - derived.porosity), 1e-12));

        Fabric porous = square_cloth(yarn("cotton", 0.2), 20);
        porous.measured.porosity = 1 - 1.2 * (1 - derived.porosity);
        QVERIFY(near(quantities_in_use({}, porous).areal_density_g_m2, 1.2 * derived.areal_density_g_m2, 1e-9));
        Fabric crimped = square_cloth(yarn("cotton", 0.2), 20);
        crimped.measured.crimp_percent = 4;
        QVERIFY(near(quantities_in_use({}, crimped).warp.crimp_percent, 4, 0.05));
        QVERIFY(near(derive_quantities({}, crimped).warp.crimp_percent, derived.warp.crimp_percent, 1e-12));
    }
    void laboratoryWeightIsMetWhateverTheCrimp()
    {
        Fabric fabric = square_cloth(yarn("cotton", 0.2), 20);
        fabric.measured.areal_density_g_m2 = 100;
        fabric.measured.crimp_percent = 20;
        const FabricQuantities q = quantities_in_use({}, fabric);
        QVERIFY(near(q.areal_density_g_m2, 100, 1e-9));
        QVERIFY(near(2 * 20 * q.warp.linear_density_tex * (1 + 0.01 * q.warp.crimp_percent) / 10, 100, 1e-6));
        QVERIFY(near(fit_fabric({}, fabric).fibre_scale, q.warp.packing_factor_in_fabric / 0.5, 1e-12));
    }
    void coverOfStraightYarnsIsTheTextbooks()
    {
        Fabric fabric = square_cloth(yarn("cotton", 0.2), 20);
        fabric.weave = Weave(1, 1, {1});                                       // nothing interlaces
        QVERIFY(near(derive_quantities({}, fabric).cover_factor, 0.64, 1e-9)); // 0.4 + 0.4 - 0.16
        fabric.ends_per_cm = fabric.picks_per_cm = 0.5;
        QVERIFY(near(derive_quantities({}, fabric).cover_factor, 0.0199, 1e-9));
    }
    void stripesWeighWhatTheirThreadsDo()
    {
        Fabric fabric = square_cloth(yarn("cotton", 0.2), 20);
        fabric.extra_yarns = {yarn("cotton", 0.1)};
        fabric.weave = Weave(1, 2, {1, 0}); // ends change at every pick, all alike; picks are straight
        fabric.warp_order = {{0, 1}, {1, 3}};
        fabric.warp_crimp_percent = 0;
        const FabricQuantities q = derive_quantities({}, fabric);
        // 24.347 tex and a quarter of it: (20 x 24.347 x (1 + 3/4)/4 + 20 x 24.347) / 10
        const double mean = 24.347 * (1 + 0.75) / 4;
        QVERIFY2(near(q.areal_density_g_m2, 2 * mean + 2 * 24.347 * (1 + 0.01 * q.weft.crimp_percent), 0.3),
                 qPrintable(QString::number(q.areal_density_g_m2)));
    }
    void aStripesYarnIsDescribedWhereItLies()
    {
        Fabric fabric = square_cloth(yarn("cotton", 0.2), 20);
        fabric.extra_yarns = {yarn("cotton", 0.1), yarn("wool", 0.3)};
        fabric.warp_order = {{0, 1}, {1, 3}};
        const std::vector<StripeYarn> stripes = fit_fabric({}, fabric).stripes;
        QCOMPARE(stripes.size(), std::size_t(2));
        QVERIFY(stripes[0].as_end && !stripes[0].as_pick);
        QVERIFY(near(stripes[0].as_end->linear_density_tex, 24.347 / 4, 0.001));
        QCOMPARE(stripes[0].as_end->diameter_mm, 0.1);
        // Unsqueezed, half of it fibre: pores are as wide as the fibres are thick.
        QCOMPARE(stripes[0].as_end->packing_factor_in_fabric, 0.5);
        QCOMPARE(stripes[0].as_end->pore_radius_um, blended_material({}, {{"cotton", 1}}).fibre_radius_um);
        QVERIFY(!stripes[1].as_end && !stripes[1].as_pick);
        QCOMPARE(stripes[1].free.diameter, 0.3);
        QCOMPARE(stripes[1].contact_angle_deg, 55.0);
    }
    void theFabricsContactAngleReplacesTheFibres()
    {
        Fabric fabric = square_cloth(yarn("wool", 0.2), 20);
        QCOMPARE(derive_quantities({}, fabric).warp.contact_angle_deg, 55.0);
        fabric.contact_angle_deg = 20;
        QCOMPARE(derive_quantities({}, fabric).warp.contact_angle_deg, 20.0);
    }
    void waterDrawsBackFromAFinishNoLaterThanItAdvances()
    {
        Fabric fabric = square_cloth(yarn("wool", 0.2), 20);
        QCOMPARE(derive_quantities({}, fabric).warp.receding_angle_deg, 35.0);
        fabric.contact_angle_deg = 80;
        QCOMPARE(derive_quantities({}, fabric).warp.receding_angle_deg, 60.0);
        fabric.weft.material = {{"cotton", 1.0}};
        QCOMPARE(derive_quantities({}, fabric).weft.receding_angle_deg, 0.0);
        Design design;
        design.materials.push_back(*find_library_material("wool"));
        design.materials[0].receding_angle_deg = 50; // the project's wool
        fabric.contact_angle_deg = 20;
        QCOMPARE(derive_quantities(design, fabric).warp.receding_angle_deg, 20.0);
    }
    void twistMakesTheWayAlongTheFibresLonger()
    {
        // 0.2 mm, 800 turns/m: (pi x 0.16)2 / 2 = 0.1263.
        Yarn single = yarn("cotton", 0.2);
        single.twist_per_m = 800;
        QVERIFY(near(helix_tortuosity(single, 0.2), 1.1263, 5e-5));
        single.twist_direction = TwistDirection::s;
        QVERIFY(near(helix_tortuosity(single, 0.2), 1.1263, 5e-5));
        // Two plies of 0.4 / sqrt 2 mm at 500 turns/m, 300 turns/m round each other: (1 + 0.07106) x (1 + 0.09870).
        Yarn plied = yarn("cotton", 0.4);
        plied.plies = 2;
        plied.twist_per_m = 500;
        plied.ply_twist_per_m = 300;
        QVERIFY(near(helix_tortuosity(plied, 0.4), 1.07106 * 1.09870, 5e-5));
        plied.twist_per_m = plied.ply_twist_per_m = 0;
        QCOMPARE(helix_tortuosity(plied, 0.4), 1.0);
        QVERIFY(near(derive_quantities({}, square_cloth(single, 20)).weft.helix_tortuosity, 1.1263, 5e-5));
    }
    void theMeanOverTheSectionOfAnIdealHelixIsThatTortuosity()
    {
        // Mean of 1 + (2 pi r T)2 over rings of equal area of a disc of 0.1 mm.
        double sum = 0;
        constexpr int rings = 1000;
        for (int i = 0; i < rings; ++i) {
            const double radius = 1e-4 * std::sqrt((i + 0.5) / rings), cosine = std::cos(std::atan(2 * pi * radius * 800));
            sum += 1 / (cosine * cosine) / rings;
        }
        Yarn single = yarn("cotton", 0.2);
        single.twist_per_m = 800;
        QVERIFY(near(helix_tortuosity(single, 0.2), sum, 1e-9));
    }
};

} // namespace tst_quantities

QTEST_APPLESS_MAIN(tst_quantities::TestQuantities)
#include "tst_quantities.moc"
