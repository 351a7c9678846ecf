// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Yarns spun round a core: what the core is counted in, what it leaves to the fibres, how files and checks have it.
#include "core/base/units.h"
#include "core/design/validate.h"
#include "core/design/yarn_quantities.h"
#include "core/geometry/textile.h"
#include "core/project/library.h"
#include "core/project/project_file.h"
#include "core/verify/set_ups.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace hygroloom;

namespace {

bool near(double a, double b, double within) { return std::abs(a - b) <= within; }

Yarn spun_round(double share)
{
    Yarn yarn;
    yarn.material = {{"cotton", 1}};
    yarn.linear_density_tex = 30;
    yarn.packing_factor = 0.6;
    if (share > 0) yarn.core = YarnCore{"elastane", share};
    return yarn;
}

Design cloth(double share)
{
    Design design = drop_on_cotton(2, 0.1, 35);
    Fabric& fabric = design.fabrics[0];
    fabric.ends_per_cm = fabric.picks_per_cm = 20;
    fabric.thickness_mm.reset();
    fabric.warp = spun_round(0);
    fabric.weft = spun_round(share);
    return design;
}

std::vector<Issue> errors_of(const Design& design)
{
    std::vector<Issue> errors;
    for (const Issue& issue : validate(design))
        if (issue.severity == Severity::error) errors.push_back(issue);
    return errors;
}

} // namespace

class TestCoreSpun : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aCoreCountsByItsMass()
    {
        // Per kg of yarn 0.05/1200 + 0.95/1550 m3 = 41.667e-6 + 612.903e-6.
        const Material mean = yarn_substance({}, spun_round(0.05));
        QVERIFY(near(mean.density_kg_m3, 1 / 654.570e-6, 0.1));
        QVERIFY(near(core_of_solids({}, spun_round(0.05)), 41.667 / 654.570, 1e-5));
        QVERIFY(near(mean.standard_regain, 0.95 * 0.071 + 0.05 * 0.01, 1e-9));
        QCOMPARE(mean.name, std::string("95 % cotton, 5 % elastane"));
        QCOMPARE(core_of_solids({}, spun_round(0)), 0.0);
        QCOMPARE(yarn_substance({}, spun_round(0)), *find_library_material("cotton"));
    }
    void waterMeetsTheFibresRoundIt()
    {
        const Material mean = yarn_substance({}, spun_round(0.2));
        const Material& cotton = *find_library_material("cotton");
        QCOMPARE(mean.fibre_radius_um, cotton.fibre_radius_um);
        QCOMPARE(mean.contact_angle_deg, cotton.contact_angle_deg);
        QCOMPARE(mean.diffusion, cotton.diffusion);
        // As a blend the elastane would make the fibres thicker and harder to wet.
        const Material blend = blended_material({}, {{"cotton", 0.8}, {"elastane", 0.2}});
        QVERIFY(blend.fibre_radius_um > mean.fibre_radius_um && blend.contact_angle_deg > mean.contact_angle_deg);
    }
    void theCoreTakesRoomFromThePores()
    {
        // A tenth of 30 tex is 3 tex of 1200 kg/m3: 2.5e-9 m2 of core, a solid disc. The rest is 27 tex of 1550 kg/m3.
        const Design design = cloth(0.1);
        const Textile textile = build_textile(design, design.fabrics[0], {0, 0, 4, 4});
        const YarnType &plain = textile.warp.types[0], &spun = textile.weft.types[0];
        QVERIFY(near(spun.core_area(), 3e-6 / 1200, 1e-13));
        const double fibres = 27e-6 / 1550, pores = spun.area - fibres - spun.core_area();
        QVERIFY(near(spun.area * (1 - spun.packing), pores, 1e-3 * pores));
        QVERIFY(near(spun.packing_round_core(), fibres / (spun.area - spun.core_area()), 1e-4));
        QVERIFY(near(spun.pore_radius, pores / fibres * 1e-6 * spun.fibre.fibre_radius_um, 1e-3 * spun.pore_radius));
        QCOMPARE(plain.core, 0.0);
        QCOMPARE(plain.packing_round_core(), plain.packing);
    }
    void fibresRoundACoreWindFarther() // the ring's mean squared radius is (1 + core) / 2 of the skin's
    {
        Yarn yarn = spun_round(0);
        yarn.twist_per_m = 800;
        const double plain = helix_tortuosity(yarn, 0.25) - 1;
        QVERIFY(near(plain, 0.5 * std::pow(pi * 0.25e-3 * 800, 2), 1e-12));
        QVERIFY(near(helix_tortuosity(yarn, 0.25, 0.1) - 1, 1.1 * plain, 1e-12));
    }
    void projectsKeepTheCore()
    {
        const Design design = cloth(0.07);
        const std::string text = format_project(design);
        QVERIFY(parse_project(text, "text") == design);
        QCOMPARE(QString::fromStdString(text).count("\"core\""), 1);
        QVERIFY(!QString::fromStdString(format_project(cloth(0))).contains("\"core\""));
    }
    void whatIsWrongWithACoreIsSaid()
    {
        QVERIFY(errors_of(cloth(0.05)).empty());
        const std::vector<Issue> thick = errors_of(cloth(0.6));
        QCOMPARE(thick.size(), std::size_t(1));
        QCOMPARE(thick[0].where.text(), std::string("fabrics[0].weft.core.share"));
        QVERIFY2(QString::fromStdString(thick[0].text()).contains("0.005") && QString::fromStdString(thick[0].text()).contains("0.6"),
                 thick[0].text().c_str());
        Design unknown = cloth(0.05);
        unknown.fabrics[0].weft.core->material = "elastan";
        const std::vector<Issue> name = errors_of(unknown);
        QCOMPARE(name.size(), std::size_t(1));
        QCOMPARE(name[0].where.text(), std::string("fabrics[0].weft.core.material"));
        QVERIFY2(QString::fromStdString(name[0].text()).contains("elastane"), name[0].text().c_str());
    }
    void theLibraryHasAStretchFabric()
    {
        const auto& presets = shipped_presets();
        const auto found = std::find_if(presets.begin(), presets.end(), [](const Preset& p) { return p.fabric().weft.core.has_value(); });
        QVERIFY(found != presets.end());
        QCOMPARE(found->fabric().weft.core->material, std::string("elastane"));
        QVERIFY(errors_of(found->design).empty());
    }
    void aPresetBringsTheFibreOfItsCore()
    {
        Design from = cloth(0.05), to;
        Material own = *find_library_material("elastane");
        own.name = "soft elastane";
        own.based_on = "elastane";
        own.density_kg_m3 = 1150;
        from.materials.push_back(own);
        from.fabrics[0].weft.core->material = own.name;
        add_preset(to, preset_of(from, from.fabrics[0], "mine", ""));
        QVERIFY(std::any_of(to.materials.begin(), to.materials.end(), [](const Material& m) { return m.density_kg_m3 == 1150; }));
        QVERIFY(errors_of(to).empty());
    }
};

QTEST_APPLESS_MAIN(TestCoreSpun)
#include "tst_core_spun.moc"
