// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The plan: what it leaves out, and that it says why with a number.
#include "core/base/error.h"
#include "core/plan/idle_keys.h"
#include "core/plan/plan_json.h"
#include "core/run/plan_run.h"
#include "core/scene/scene.h"
#include "tests/support/drop_design.h"

#include <QRegularExpression>
#include <QTest>

using namespace hygroloom;

namespace {
ModelPlan plan_of(const Design& d, Fidelity fidelity = Fidelity::standard, const ForcedParts& forced = {})
{
    return plan_run(d, d.fabrics[0], d.experiments[0], fidelity, forced);
}

/// The number after some words of a reason.
double number_after(const std::string& reason, const QString& words)
{
    const QRegularExpressionMatch match = QRegularExpression(words + " ([0-9.e+-]+)").match(QString::fromStdString(reason));
    return match.hasMatch() ? match.captured(1).toDouble() : std::nan("");
}

/// Ends in stripes of cotton and polyester, the picks of cotton.
Design striped(int cotton, int polyester)
{
    Design design = drop_design();
    Fabric& fabric = design.fabrics[0];
    fabric.contact_angle_deg.reset();
    fabric.extra_yarns.push_back(fabric.warp);
    fabric.extra_yarns[0].material = {{"polyester", 1.0}};
    fabric.extra_yarns[0].diameter_mm = 0.15;
    design.experiments[0].sample_mm = {20, 20}; // more than the drop can wet
    if (cotton > 0) fabric.warp_order.push_back({0, cotton});
    if (polyester > 0) fabric.warp_order.push_back({1, polyester});
    return design;
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
    void onRepellentClothADropDriesAndNothingWicks()
    {
        const ModelPlan plan = plan_of(drop_design(120));
        QVERIFY(plan.on("liquid"));
        for (const char* part : {"wicking", "sorption"}) QVERIFY(!plan.on(part));
    }
    void anAngleJustUnder90IsPrintedInFull()
    {
        const ModelPlan plan = plan_of(drop_design(89.96));
        const auto wicking = std::find_if(plan.parts.begin(), plan.parts.end(), [](const PlannedPart& p) { return p.name == "wicking"; });
        QVERIFY2(wicking->on && wicking->reason.find("89.96 degrees, under 90") != std::string::npos, wicking->reason.c_str());
    }
    void thePapersClosureTakesAllFibresForAlikeButForTheirRegain()
    {
        const auto warp_of = [](const char* fibre, Closure closure, std::optional<double> angle) {
            Design design = drop_design();
            Fabric& fabric = design.fabrics[0];
            fabric.warp.material = fabric.weft.material = {{fibre, 1.0}};
            fabric.contact_angle_deg = angle;
            Experiment& experiment = design.experiments[0];
            experiment.closure = closure;
            const ModelPlan plan = plan_of(design);
            return build_scene(design, textile_of_run(design, fabric, experiment, plan.region), experiment, plan, 1).cloth.yarns[0];
        };
        const YarnParameters cotton = warp_of("cotton", Closure::paper, {});
        constexpr double cosine = 0.81915204428899179; // of cotton's 35 degrees
        QVERIFY(std::abs(cotton.suction_radius / (0.2e-3 / cosine) - 1) < 1e-12);
        for (const auto& [fibre, share] : {std::pair("wool", 0.145 / 0.071), std::pair("polyester", 0.004 / 0.071)}) {
            const YarnParameters yarn = warp_of(fibre, Closure::paper, {});
            QCOMPARE(yarn.liquid_diffusivity, cotton.liquid_diffusivity);
            QCOMPARE(yarn.suction_radius, cotton.suction_radius);
            QCOMPARE(yarn.adhesion, cotton.adhesion);
            QVERIFY2(std::abs(yarn.intake_flux / cotton.intake_flux / share - 1) < 1e-12, fibre);
            QCOMPARE(warp_of(fibre, Closure::pores, {}).liquid_diffusivity, 0.0); // suction moves liquid there
        }
        // 3 sin2(20 deg) gamma cos(60 deg) 0.2 mm / (20 mu 1.2) at 25 C: 0.07197 N/m, 0.8900 mPa s (IAPWS).
        const YarnParameters finished = warp_of("wool", Closure::paper, 60);
        QVERIFY2(std::abs(finished.liquid_diffusivity / 1.1826e-4 - 1) < 0.005, qPrintable(QString::number(finished.liquid_diffusivity)));
    }
    void thePapersClosureWetsFibresThatRepel()
    {
        Design design = drop_design();
        design.materials.push_back(*find_library_material("wool"));
        design.materials[0].name = "raw wool";
        design.materials[0].based_on = "wool";
        design.materials[0].contact_angle_deg = 95;
        design.fabrics[0].warp.material = design.fabrics[0].weft.material = {{"raw wool", 1.0}};
        design.fabrics[0].contact_angle_deg.reset();
        design.experiments[0].closure = Closure::pores;
        QVERIFY(!plan_of(design).on("wicking"));
        design.experiments[0].closure = Closure::paper;
        QVERIFY(plan_of(design).on("wicking"));
    }
    void polyesterSorbsTooLittleToMatterInADraft()
    {
        Design design = drop_design();
        design.fabrics[0].warp.material = design.fabrics[0].weft.material = {{"polyester", 1.0}};
        QVERIFY(!plan_of(design, Fidelity::draft).on("vapour"));
        QVERIFY(plan_of(design, Fidelity::reference).on("sorption"));
    }
    void boundsOfStripesAreThoseOfTheWorstYarn() // a drop may fall on a narrow stripe
    {
        const auto bound = [](const Design& design, const std::string& name) {
            const ModelPlan plan = plan_of(design);
            for (const PlannedPart& part : plan.parts)
                if (part.name == name) return number_after(part.reason, name == "sorption" ? "at most" : "takes at most");
            throw Error("There is no such part.");
        };
        const Design cotton = striped(1, 0), polyester = striped(0, 1);
        for (const Design& mixed : {striped(3, 1), striped(1, 3), striped(1, 40)}) {
            QCOMPARE(bound(mixed, "sorption"), bound(cotton, "sorption"));                      // thirstier than polyester, however few
            const double worst = std::max(bound(cotton, "vapour"), bound(polyester, "vapour")); // the finer yarn gives less room
            QVERIFY(bound(mixed, "vapour") >= 0.999 * std::min(bound(cotton, "vapour"), bound(polyester, "vapour")));
            QVERIFY(bound(mixed, "vapour") <= 1.2 * worst); // the coarser one's thickness with the finer one's room
        }
    }
    void theThinnestYarnSetsHowFinelyATinyDropIsResolved()
    {
        Design thick = striped(1, 0), mixed = striped(9, 1);
        for (Design* design : {&thick, &mixed}) design->experiments[0].droplets[0].volume_ul = 1e-3;
        QVERIFY(plan_of(mixed).particles_per_droplet > 1.5 * plan_of(thick).particles_per_droplet);
    }
    void oneYarnThatWicksIsEnough()
    {
        Design design = drop_design();
        design.experiments[0].closure = Closure::pores; // the closure paper gives wax the angle of cotton
        Fabric& fabric = design.fabrics[0];
        fabric.contact_angle_deg.reset();
        Material waxed = *find_library_material("cotton");
        waxed.name = "waxed cotton";
        waxed.based_on = "cotton";
        waxed.contact_angle_deg = 110;
        design.materials.push_back(waxed);
        fabric.warp.material = fabric.weft.material = {{"waxed cotton", 1.0}};
        QVERIFY(!plan_of(design).on("wicking"));
        fabric.extra_yarns.push_back(drop_design().fabrics[0].warp);
        fabric.warp_order = {{0, 13}, {1, 2}};
        QVERIFY(plan_of(design).on("wicking"));
    }
    void saturatedAirDriesNothing()
    {
        Design design = drop_design();
        design.experiments[0].climate.relative_humidity = 1.0;
        QVERIFY(!plan_of(design, Fidelity::reference).on("vapour"));
    }
    void moreThanSaturatedAirCondensesOnAllOfTheCloth()
    {
        Design design = drop_design(120);
        const auto condenses = [&] {
            const ModelPlan plan = plan_of(design);
            return plan.on("vapour") && plan.on("heat") && !plan.on("growth");
        };
        QVERIFY(!condenses());
        design.experiments[0].climate.relative_humidity = 1.01;
        QVERIFY(condenses());
        design.experiments[0].droplets.clear();
        QVERIFY(condenses());
        design.experiments[0].climate.relative_humidity = 0.65;
        design.experiments[0].climates = {{0.1, {25, 1.5, 0}}}; // later
        QVERIFY(condenses());
        Experiment conditioning = standard_experiment(ExperimentType::conditioning);
        conditioning.name = "test";
        conditioning.initial.relative_humidity = 1; // the fibres are full
        conditioning.climate.relative_humidity = 1.2;
        design.experiments = {conditioning};
        QVERIFY(condenses());
    }
    void noDropNoLiquid()
    {
        Design design = drop_design();
        design.experiments[0].droplets.clear();
        QVERIFY(!plan_of(design).on("liquid"));
        QVERIFY(!plan_of(design).on("wicking"));
    }
    void aFeedComesInDropsThatAreNotFollowedAsTheyFall()
    {
        Design design = drop_design();
        design.experiments[0] = standard_experiment(ExperimentType::moisture_management);
        design.experiments[0].sample_mm = {8, 8};
        design.experiments[0].drop_ul = 25;
        const ModelPlan drops = plan_of(design);
        QVERIFY(!drops.on("liquid") && drops.on("wicking"));
        QCOMPARE(drops.particles_per_droplet, 0);
        const std::string& reason = drops.parts[0].reason;
        QVERIFY2(reason.starts_with("8 drops of 25 ul, "), reason.c_str());
        QVERIFY2(std::abs(number_after(reason, "ul,") / (200 * find_liquid(design, "saline")->density_kg_m3 * 1e-3) - 1) < 1e-3,
                 reason.c_str());
        design.experiments[0].drop_ul = 300;
        QVERIFY(plan_of(design).parts[0].reason.starts_with("One drop of 200 ul, "));
        design.experiments[0].drop_ul = 0;
        QVERIFY(!plan_of(design).on("liquid") && plan_of(design).on("wicking"));
    }
    void aFeedIsCutIntoEqualDrops()
    {
        Experiment feed = standard_experiment(ExperimentType::moisture_management);
        QCOMPARE(drops_of_feed(feed), 8); // of 25 ul
        feed.drop_ul = 0;
        QCOMPARE(drops_of_feed(feed), 0);
        feed.volume_ul = 0.3;
        feed.drop_ul = 0.1; // 0.3 / 0.1 is a little more than 3 in binary
        QCOMPARE(drops_of_feed(feed), 3);
        feed.drop_ul = 0.14; // the last would be smaller: all are
        QCOMPARE(drops_of_feed(feed), 3);
        feed.type = ExperimentType::horizontal_wicking;
        QCOMPARE(drops_of_feed(feed), 0);
    }
    void partsCanBeForcedBothWays()
    {
        const ModelPlan plan = plan_of(drop_design(), Fidelity::standard, parse_forced_parts("heat=off,vapour=on"));
        QVERIFY(!plan.on("heat"));
        QVERIFY(plan.on("vapour"));
        QVERIFY(!plan.parts.front().forced);
        for (const PlannedPart& part : plan.parts) QCOMPARE(part.forced, part.name == "heat" || part.name == "vapour");
        for (const char* wrong : {"heat", "heat=maybe", "warmth=on", "=on", "heat=on,,x"})
            QVERIFY_EXCEPTION_THROWN(parse_forced_parts(wrong), Error);
    }
    void theReferenceLeavesNothingOutForBeingSmall()
    {
        const auto reasons = [](Fidelity fidelity) {
            std::string all;
            for (const PlannedPart& part : plan_of(drop_design(), fidelity).parts) all += part.reason;
            return all;
        };
        QVERIFY(reasons(Fidelity::draft).find("below 1 % are left out") != std::string::npos);
        const std::string reference = reasons(Fidelity::reference);
        QVERIFY2(reference.find("nothing that has an effect is left out") != std::string::npos, reference.c_str());
        QVERIFY2(reference.find("below 0 %") == std::string::npos, reference.c_str());
    }
    void finerFidelityResolvesMore()
    {
        const ModelPlan draft = plan_of(drop_design(), Fidelity::draft), reference = plan_of(drop_design(), Fidelity::reference);
        QVERIFY(draft.particles_per_droplet < reference.particles_per_droplet);
        QVERIFY(draft.fibre_shells < reference.fibre_shells);
        QVERIFY(draft.expected_seconds < reference.expected_seconds);
    }
    void keysAreIdleWhereWhatTheirRowsNeedIsMissing()
    {
        Design design = drop_design();
        design.experiments[0].closure = Closure::pores;
        const auto idle = idle_keys(design.fabrics[0], design.experiments[0], plan_of(design, Fidelity::draft, {{"heat", false}}));
        const auto because = [&](const std::string& key) {
            const auto found = std::find_if(idle.begin(), idle.end(), [&](const IdleKey& each) { return each.key == key; });
            return found == idle.end() ? std::string() : found->because;
        };
        QCOMPARE(because("material.specific_heat_j_kgk"), std::string("heat is left out"));
        QCOMPARE(because("fabric.finish_holes"), std::string("no face has a finish of its own"));
        QCOMPARE(because("liquid.viscosity_mpa_s"), std::string());
        QCOMPARE(because("fabric.ends_per_cm"), std::string()); // whose row needs nothing
    }
    void knobsOfWhatIsNotThereAreIdle()
    {
        const auto idle = [](const ModelPlan& plan, const char* knob) { return plan.idle_knobs.contains(knob); };
        const ModelPlan drop = plan_of(drop_design());
        for (const KnobInfo& knob : knob_table())
            QCOMPARE(idle(drop, knob.name), QByteArray(knob.name).startsWith("crossings_")); // free liquid meets single yarns
        Design design = drop_design(120);
        QVERIFY(idle(plan_of(design), "steps_between_absorption") && idle(plan_of(design), "fibre_shells"));
        QVERIFY(!idle(plan_of(design), "settle_share"));
        design = drop_design();
        Experiment& experiment = design.experiments[0];
        experiment = standard_experiment(ExperimentType::drying);
        const ModelPlan drying = plan_of(design);
        for (const char* knob : {"particles_per_droplet", "settle_share", "saturation_change", "rest_tolerance", "crossings_per_cell"})
            QVERIFY2(idle(drying, knob), knob);
        for (const char* knob : {"crossings_per_even_cell", "step_error", "fibre_shells", "neglected_share"})
            QVERIFY2(!idle(drying, knob), knob);
        experiment = standard_experiment(ExperimentType::moisture_management);
        QVERIFY(!idle(plan_of(design), "saturation_change") && !idle(plan_of(design), "crossings_per_cell"));
        QVERIFY(idle(plan_of(design), "crossings_per_even_cell"));
        QCOMPARE(plan_from_json(plan_json(drying)).idle_knobs, drying.idle_knobs);
    }
    void whatWasSetInVainIsNoted()
    {
        Design design = drop_design();
        design.experiments[0] = standard_experiment(ExperimentType::drying);
        const auto notes = [&](const KnobSettings& settings) {
            return notes_of(plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft, {}, settings));
        };
        QVERIFY(notes({{"crossings_per_even_cell", 1}}).empty());
        const std::vector<std::string> reported = notes({{"crossings_per_even_cell", 4}, {"settle_share", 0.1}});
        QCOMPARE(reported.size(), std::size_t(2));
        QVERIFY2(reported[0].starts_with("Yarns side by side went in bundles: "), reported[0].c_str());
        QCOMPARE(reported[1], std::string("settle_share was set and had no effect: no drop falls."));
    }
    /// By the scatter of angles next to nothing runs between dry fibres from a mean of 76 degrees on where half of the yarn is fibre.
    void yarnsThatStayDryAreNoted()
    {
        Design design = drop_design();
        const auto notes = [&](double angle, Closure closure) {
            design.fabrics[0].contact_angle_deg = angle;
            design.experiments[0].closure = closure;
            design.fabrics[0].warp.packing_factor = design.fabrics[0].weft.packing_factor = 0.35; // flattened in the cloth to 0.46
            return notes_of(plan_of(design));
        };
        const std::vector<std::string> dry = notes(80, Closure::pores);
        QCOMPARE(dry.size(), std::size_t(1));
        QVERIFY2(dry[0].starts_with("Dry yarns take no liquid in: at a contact angle of 80 degrees "), dry[0].c_str());
        for (double angle : {35.0, 55.0, 95.0}) QVERIFY2(notes(angle, Closure::pores).empty(), qPrintable(QString::number(angle)));
        QVERIFY(notes(80, Closure::paper).empty());
    }
    /// With the closure of pores the rooms between yarns have their part of it, too.
    void aFeedIsSaidToBeAbsorbedByTheClothNotByItsYarns()
    {
        Design design = drop_design();
        design.experiments[0] = standard_experiment(ExperimentType::moisture_management);
        design.experiments[0].volume_ul = 50;
        for (Closure closure : {Closure::pores, Closure::paper}) {
            design.experiments[0].closure = closure;
            for (double drop : {0.0, 10.0}) {
                design.experiments[0].drop_ul = drop;
                const ModelPlan plan = plan_of(design);
                const auto liquid =
                    std::find_if(plan.parts.begin(), plan.parts.end(), [](const auto& part) { return part.name == "liquid"; });
                QVERIFY2(QString::fromStdString(liquid->reason).contains("pool that the cloth absorbs"), liquid->reason.c_str());
                QVERIFY2(number_after(" " + liquid->reason, drop > 0 ? "ul," : "") > 49, liquid->reason.c_str());
            }
        }
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
