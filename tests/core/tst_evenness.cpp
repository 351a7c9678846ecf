// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How uneven yarns are that say nothing of it.
#include "core/design/evenness.h"
#include "core/design/fitted_fabric.h"
#include "core/design/validate.h"
#include "core/project/library.h"
#include "tests/support/drop_design.h"

#include <QTest>

#include <cmath>

namespace hygroloom {
namespace {

Yarn spun(const char* fibre, double tex)
{
    Yarn yarn;
    yarn.material = {{fibre, 1.0}};
    yarn.linear_density_tex = tex;
    return yarn;
}

double typical(const Yarn& yarn) { return typical_unevenness(drop_design(), yarn).cv; }

} // namespace

class TestEvenness : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aStapleYarnIsAsUnevenAsItsFibresAreFew()
    {
        // 14.76 tex of 0.16 tex are 92.25 fibres: 1.25 x 1.06 / 9.605
        QVERIFY(std::abs(typical(spun("cotton", 14.76)) - 0.1380) < 2e-4);
        QVERIFY(std::abs(limit_irregularity(1.12, 40, 0.4) - 0.112) < 1e-12);
        QVERIFY(std::abs(typical(spun("cotton", 59.04)) - 0.0690) < 2e-4); // four times the fibres, half as uneven
    }
    void pliesEvenEachOtherOut()
    {
        Yarn two = spun("cotton", 29.52);
        two.plies = 2;
        QVERIFY(std::abs(typical(two) - 0.1380 / std::sqrt(2.0)) < 2e-4);
    }
    void filamentsAreNearlyEven()
    {
        Yarn yarn = spun("polyester", 8.3333);
        yarn.twist_per_m = 100;
        QCOMPARE(typical(yarn), 0.015);
        yarn.filament_count = 72;
        QCOMPARE(typical(yarn), 0.015); // not by the key alone
        yarn.filament_count.reset();
        yarn.twist_per_m = 900;
        QVERIFY(typical(yarn) > 0.08); // spun polyester
        Yarn cotton = spun("cotton", 20);
        cotton.twist_per_m = 100;
        QVERIFY(typical(cotton) > 0.1); // cotton has no filaments
    }
    void nothingIsMoreUnevenThanAQuarter() { QCOMPARE(typical(spun("flax", 1)), 0.25); }
    void whatIsGivenCounts()
    {
        Design design = drop_design();
        design.fabrics[0].warp.irregularity_cv = 0;
        design.fabrics[0].weft.irregularity_cv = 0.2;
        const auto fitted = validate_and_fit(design).fabrics[0];
        QVERIFY(fitted != nullptr);
        QCOMPARE(fitted->yarns.warp[0].unevenness.cv, 0.0);
        QCOMPARE(fitted->yarns.weft[0].unevenness.cv, 0.2);
    }
    void everyClothOfTheLibraryOfFilamentsCountsThem()
    {
        int filament = 0;
        for (const Preset& preset : shipped_presets()) {
            if (preset.group != "Filament") continue;
            ++filament;
            for (const Yarn* yarn : {&preset.fabric().warp, &preset.fabric().weft})
                QVERIFY2(yarn->filament_count.has_value(), preset.fabric().name.c_str());
        }
        QVERIFY(filament >= 5);
    }
};

} // namespace hygroloom

QTEST_APPLESS_MAIN(hygroloom::TestEvenness)
#include "tst_evenness.moc"
