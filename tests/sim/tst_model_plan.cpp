// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The plan: what it leaves out, and that it says why with a number.
#include "core/base/error.h"
#include "core/sim/plan_json.h"
#include "tests/support/drop_design.h"

#include <QTest>

using namespace hygroloom;

namespace {
ModelPlan plan_of(const Design& d, Fidelity fidelity = Fidelity::standard, const ForcedParts& forced = {})
{
    return plan_model(d, d.fabrics[0], d.experiments[0], fidelity, forced);
}
} // namespace

class TestModelPlan : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aDropOnCottonNeedsLiquidWickingSorptionAndHeat()
    {
        const ModelPlan plan = plan_of(drop_design());
        for (const char* part : {"liquid", "wicking", "sorption", "heat"}) QVERIFY(plan.on(part));
        for (const PlannedPart& part : plan.parts) QVERIFY(!part.reason.empty());
        QCOMPARE(plan.segments, 2 * plan.region.ends * plan.region.picks);
    }
    void repellentClothNeedsOnlyTheLiquid()
    {
        const ModelPlan plan = plan_of(drop_design(120));
        QVERIFY(plan.on("liquid"));
        for (const char* part : {"wicking", "sorption", "vapour", "heat"}) QVERIFY(!plan.on(part));
    }
    void polyesterSorbsTooLittleToMatterInADraft()
    {
        Design design = drop_design();
        design.fabrics[0].warp.material = design.fabrics[0].weft.material = {{"polyester", 1.0}};
        QVERIFY(!plan_of(design, Fidelity::draft).on("vapour"));
        QVERIFY(plan_of(design, Fidelity::reference).on("sorption"));
    }
    void saturatedAirDriesNothing()
    {
        Design design = drop_design();
        design.experiments[0].climate.relative_humidity = 1.0;
        QVERIFY(!plan_of(design, Fidelity::reference).on("vapour"));
    }
    void noDropNoLiquid()
    {
        Design design = drop_design();
        design.experiments[0].droplets.clear();
        QVERIFY(!plan_of(design).on("liquid"));
        QVERIFY(!plan_of(design).on("wicking"));
    }
    void partsCanBeForcedBothWays()
    {
        const ModelPlan plan = plan_of(drop_design(), Fidelity::standard, parse_forced_parts("heat=off,vapour=on"));
        QVERIFY(!plan.on("heat"));
        QVERIFY(plan.on("vapour"));
        QVERIFY(plan.parts.back().forced);
        for (const char* wrong : {"heat", "heat=maybe", "warmth=on", "=on", "heat=on,,x"})
            QVERIFY_EXCEPTION_THROWN(parse_forced_parts(wrong), Error);
    }
    void finerFidelityResolvesMore()
    {
        const ModelPlan draft = plan_of(drop_design(), Fidelity::draft), reference = plan_of(drop_design(), Fidelity::reference);
        QVERIFY(draft.particles_per_droplet < reference.particles_per_droplet);
        QVERIFY(draft.fibre_shells < reference.fibre_shells);
        QVERIFY(draft.expected_seconds < reference.expected_seconds);
    }
    void planSurvivesJson()
    {
        const ModelPlan plan = plan_of(drop_design());
        QCOMPARE(plan_json(plan_from_json(plan_json(plan))), plan_json(plan));
        QVERIFY_EXCEPTION_THROWN(plan_from_json("{}"), Error);
        QVERIFY_EXCEPTION_THROWN(plan_from_json("[1"), Error);
    }
};

QTEST_APPLESS_MAIN(TestModelPlan)
#include "tst_model_plan.moc"
