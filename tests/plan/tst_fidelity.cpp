// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The knobs behind a fidelity: each is set alone, is refused with a sentence, and reaches the plan, its JSON and the scene.
#include "core/base/error.h"
#include "core/plan/plan_json.h"
#include "core/plan/planning.h"
#include "core/run/plan_run.h"
#include "core/scene/scene.h"
#include "core/solver/backend.h"
#include "core/solver/steps/liquid_control.h"
#include "tests/support/drop_design.h"

#include <QTest>

#include <functional>

using namespace hygroloom;

namespace {

ModelPlan plan_with(const KnobSettings& settings, Fidelity fidelity = Fidelity::standard)
{
    const Design design = drop_design();
    return plan_run(design, design.fabrics[0], design.experiments[0], fidelity, {}, settings);
}

std::string refusal(const std::string& name, const std::string& value)
{
    KnobSettings settings;
    try {
        set_knob(settings, name, value);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// A drop that meets the cloth and is half absorbed, with one knob set.
struct ShortRun {
    Frame end;
    std::vector<std::byte> state;
    long steps = 0; ///< of the liquid
};
ShortRun drop_with(const KnobSettings& settings, Backend& backend, double until = 0.1)
{
    const Design design = drop_design();
    KnobSettings all{{"particles_per_droplet", 500}, {"settle_share", 0}};
    all.insert(settings.begin(), settings.end());
    const ModelPlan plan = plan_with(all, Fidelity::draft);
    backend.load(build_scene(design, build_textile(design, design.fabrics[0], plan.region), design.experiments[0], plan, 1));
    for (double reached = 0; reached < until;) reached = backend.advance(until);
    return {backend.frame(), backend.state(), backend.liquid_steps()};
}
ShortRun drop_with(const KnobSettings& settings) { return drop_with(settings, *make_cpu_backend()); }

} // namespace

class TestFidelity : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyFidelityLiesInTheRangesOfTheKnobs()
    {
        for (Fidelity fidelity : all_fidelities) {
            const Knobs knobs = knobs_of(fidelity);
            for (const KnobInfo& knob : knob_table()) require_in_range(knob, knobs.*knob.value);
        }
        for (const KnobInfo& knob : knob_table()) {
            require_in_range(knob, knob.cheaper);
            require_in_range(knob, knob.finer);
            const double standard = knobs_of(Fidelity::standard).*knob.value;
            const bool cheapest = knob.cheaper == standard && (standard == knob.most || standard == knob.least);
            const bool finest =
                (standard == knob.most || standard == knob.least) && (knob.cheaper - knob.finer) * (knob.finer - standard) > 0;
            QVERIFY2(cheapest || finest || (knob.cheaper - standard) * (knob.finer - standard) < 0, knob.name); // on either side of it
        }
    }
    void oneKnobChangesAloneAndReadsBack()
    {
        const ModelPlan plain = plan_with({});
        QVERIFY(changed_knobs(plain.knobs, knobs_of(Fidelity::standard)).empty());
        for (const KnobInfo& knob : knob_table()) {
            const ModelPlan plan = plan_with({{knob.name, knob.finer}});
            const auto changed = changed_knobs(plain.knobs, plan.knobs);
            QCOMPARE(changed.size(), std::size_t(1));
            QCOMPARE(changed[0]->name, knob.name);
            const ModelPlan back = plan_from_json(plan_json(plan));
            QVERIFY2(back.knobs == plan.knobs, knob.name);
            QCOMPARE(back.rest_tolerance, plan.rest_tolerance);
            QVERIFY(plan.resolution_reason.find("set by the user") != std::string::npos);
        }
    }
    void knobsReachTheScene()
    {
        const Design design = drop_design();
        const ModelPlan plan = plan_with({{"particles_per_droplet", 300},
                                          {"fibre_shells", 3},
                                          {"network_step_limit_s", 0.004},
                                          {"saturation_change", 0.07},
                                          {"step_error", 3e-4},
                                          {"liquid_step_factor", 0.3},
                                          {"steps_between_absorption", 5},
                                          {"density_tolerance", 0.03},
                                          {"settle_share", 0.04},
                                          {"rest_tolerance", 2e-4},
                                          {"double_precision", 1},
                                          {"room_voxels", 0}});
        const Scene scene = build_scene(design, build_textile(design, design.fabrics[0], plan.region), design.experiments[0], plan, 1);
        QCOMPARE(scene.rules.particles_per_droplet, 300);
        QCOMPARE(scene.rules.fibre_shells, 3);
        QCOMPARE(scene.rules.network_step, 0.004);
        QCOMPARE(scene.rules.saturation_change, 0.07);
        QCOMPARE(scene.rules.step_error, 3e-4);
        QCOMPARE(scene.rules.liquid_step_factor, 0.3);
        QCOMPARE(scene.rules.steps_between_absorption, 5);
        QCOMPARE(scene.rules.density_tolerance, 0.03);
        QCOMPARE(scene.rules.settle_share, 0.04);
        QCOMPARE(scene.rules.rest_tolerance, 2e-4);
        QVERIFY(scene.rules.double_precision);
        Design with_rooms = design;
        with_rooms.experiments[0].closure = Closure::pores;
        for (double voxels : {0.0, 8.0}) {
            const ModelPlan drawn = plan_with({{"room_voxels", voxels}});
            const Textile textile = build_textile(with_rooms, with_rooms.fabrics[0], drawn.region);
            const Scene woven = build_scene(with_rooms, textile, with_rooms.experiments[0], drawn, 1);
            QCOMPARE(woven.cloth.room_along.size(), voxels > 0 ? woven.cloth.length.size() : 0);
        }
    }
    void aPlanOfBeforeBundlesHadACellForEachCrossing()
    {
        std::string json = plan_json(plan_with({}));
        for (const std::string name : {"\"crossings_per_cell\"", "\"crossings_per_even_cell\""})
            for (std::size_t at = 0; (at = json.find(name)) != std::string::npos;) json.replace(at, name.size(), "\"unknown_then\"");
        const ModelPlan old = plan_from_json(json);
        QCOMPARE(old.crossings_per_cell, 1);
        QCOMPARE(old.knobs.crossings_per_cell, 1.0);
        QCOMPARE(old.knobs.crossings_per_even_cell, 1.0);
    }
    void theLiquidsStepsAreAsLongAsAsked()
    {
        const ShortRun whole = drop_with({}), half = drop_with({{"liquid_step_factor", 0.5}}),
                       tenth = drop_with({{"liquid_step_factor", 0.1}});
        QVERIFY2(half.steps > 1.7 * double(whole.steps) && half.steps < 2.3 * double(whole.steps),
                 qPrintable(QString("%1 %2").arg(whole.steps).arg(half.steps)));
        QVERIFY2(tenth.steps > 8 * double(whole.steps) && tenth.steps < 12 * double(whole.steps), qPrintable(QString::number(tenth.steps)));
        for (const ShortRun* run : {&half, &tenth}) {
            const Ledger &a = run->end.ledger, &b = whole.end.ledger;
            QVERIFY(std::abs(a.water_imbalance()) <= 1e-12 * a.water_delivered);
            QVERIFY2(a.water_liquid > 0 && std::abs(a.water_liquid - b.water_liquid) < 0.1 * b.water_delivered,
                     qPrintable(QString("%1 %2").arg(a.water_liquid).arg(b.water_liquid)));
        }
    }
    void particlesHaveThePrecisionThatIsAsked()
    {
        const auto backend = make_cpu_backend();
        const KnobSettings twice{{"double_precision", 1}};
        // The same fall, but for roundings.
        const ShortRun single = drop_with({}, *backend, 5e-3), precise = drop_with(twice, *backend, 5e-3),
                       again = drop_with({}, *backend, 5e-3);
        QVERIFY2(precise.state.size() > single.state.size() + 500 * 6 * sizeof(float),
                 qPrintable(QString("%1 %2").arg(single.state.size()).arg(precise.state.size())));
        QVERIFY(again.end.positions == single.end.positions && again.end.velocities == single.end.velocities);
        QCOMPARE(precise.end.positions.size(), single.end.positions.size());
        const auto height = [](const ShortRun& run) {
            double sum = 0;
            for (const auto& place : run.end.positions) sum += double(place[2]);
            return sum / double(run.end.positions.size());
        };
        QVERIFY2(std::abs(height(single) - height(precise)) < 1e-7, qPrintable(QString("%1 %2").arg(height(single)).arg(height(precise))));
        // And the yarns absorb it, within what rounding grows to.
        const Ledger a = drop_with({}).end.ledger, b = drop_with(twice).end.ledger;
        QVERIFY(std::abs(b.water_imbalance()) <= 1e-12 * b.water_delivered);
        QVERIFY2(b.water_liquid > 0 && std::abs(a.water_liquid - b.water_liquid) < 0.05 * b.water_delivered,
                 qPrintable(QString("%1 %2").arg(a.water_liquid).arg(b.water_liquid)));
    }
    void yarnsAbsorbAsOftenAsSet()
    {
        LiquidRules rules;
        rules.spacing = Real(1e-4);
        rules.capillary_dt = rules.viscous_dt = 1e-3;
        rules.courant = 0.4;
        for (int between : {1, 5, 64}) {
            rules.steps_between_absorption = between;
            LiquidControl control;
            control.count = 10;
            control.dt = 1e-6;
            control.sync_time = 1;
            for (int step = 1; step <= 128; ++step) {
                EndStep{&control, rules, true}(0);
                QCOMPARE(control.absorbs.on, step % between == 0 ? 1 : 0);
                if (control.absorbs.on) QVERIFY(std::abs(control.absorb_dt - between * 1e-6) < 1e-15); // for all the time since
            }
        }
        const ShortRun often = drop_with({{"steps_between_absorption", 1}}), seldom = drop_with({{"steps_between_absorption", 64}});
        QVERIFY(often.end.ledger.water_liquid != seldom.end.ledger.water_liquid);
        QVERIFY(std::abs(seldom.end.ledger.water_imbalance()) <= 1e-12 * seldom.end.ledger.water_delivered);
        QVERIFY2(std::abs(often.end.ledger.water_liquid - seldom.end.ledger.water_liquid) < 0.1 * often.end.ledger.water_delivered,
                 qPrintable(QString("%1 %2").arg(often.end.ledger.water_liquid).arg(seldom.end.ledger.water_liquid)));
    }
    void whatIsNeglectedDecidesTheParts()
    {
        QVERIFY(plan_with({}).on("heat"));
        Design polyester = drop_design();
        polyester.fabrics[0].warp.material = polyester.fabrics[0].weft.material = {{"polyester", 1.0}};
        for (double share : {0.0, 0.5})
            QCOMPARE(plan_run(polyester, polyester.fabrics[0], polyester.experiments[0], Fidelity::draft, {}, {{"neglected_share", share}})
                         .on("heat"),
                     share == 0);
        QVERIFY(plan_with({{"neglected_share", 0.0}}, Fidelity::draft).on("vapour"));
    }
    void aWrongKnobIsRefusedInASentence()
    {
        QCOMPARE(refusal("fibre_shells", "33"),
                 std::string("fidelity.fibre_shells: It must be a whole number from 1 to 32; 33 was given."));
        QCOMPARE(refusal("fibre_shells", "2.5"),
                 std::string("fidelity.fibre_shells: It must be a whole number from 1 to 32; 2.5 was given."));
        QCOMPARE(refusal("network_step_limit_s", "fast"),
                 std::string("fidelity.network_step_limit_s: It must be a number from 1e-05 to 1 s; \"fast\" was given."));
        QCOMPARE(refusal("liquid_step_factor", "1.5"),
                 std::string("fidelity.liquid_step_factor: It must be a number from 0.1 to 1; 1.5 was given."));
        QVERIFY(!refusal("liquid_step_factor", "0").empty());
        QCOMPARE(refusal("steps_between_absorption", "0"),
                 std::string("fidelity.steps_between_absorption: It must be a whole number from 1 to 64; 0 was given."));
        QVERIFY(!refusal("steps_between_absorption", "65").empty() && !refusal("steps_between_absorption", "1.5").empty());
        for (const char* wrong : {"nan", "-1", "", "1e-4x", "inf"}) QVERIFY2(!refusal("step_error", wrong).empty(), wrong);
        const std::string unknown = refusal("fibre_shels", "4");
        QVERIFY2(unknown.starts_with("fidelity.fibre_shels: There is no such knob; did you mean \"fibre_shells\"?"), unknown.c_str());
        QVERIFY(unknown.find("neglected_share") != std::string::npos);
        QVERIFY_EXCEPTION_THROWN(plan_with({{"fibre_shells", 40}}), Error);
    }
    void aKnobOfWordsTakesThem()
    {
        KnobSettings settings;
        set_knob(settings, "free_liquid", "cap");
        QCOMPARE(settings.at("free_liquid"), 1.0);
        QCOMPARE(text_of(knob_named("free_liquid"), 1), std::string("cap"));
        for (const char* wrong : {"1", "drop", ""})
            QCOMPARE(refusal("free_liquid", wrong),
                     std::string("fidelity.free_liquid: It must be auto or cap or particles; \"") + wrong + "\" was given.");
        const ModelPlan plan = plan_with(settings);
        QVERIFY(plan_json(plan).find("\"free_liquid\": \"cap\"") != std::string::npos);
        QCOMPARE(plan_from_json(plan_json(plan)).knobs.free_liquid, 1.0);
    }
    void dropsAreCapsWhereTheSceneAllowsIt()
    {
        const auto plan_of = [](const std::function<void(Experiment&)>& change, double model) {
            Design design = drop_on_cotton(5, 1, 35);
            change(design.experiments[0]);
            const Textile textile = textile_of_run(design, design.fabrics[0], design.experiments[0]);
            return plan_model(design, textile, design.experiments[0], Fidelity::standard, {}, {{"free_liquid", model}});
        };
        const auto as_is = [](Experiment&) {};
        for (double model : {0.0, 1.0}) {
            const ModelPlan plan = plan_of(as_is, model);
            QVERIFY(plan.on("cap") && plan.particles_per_droplet == 0);
            QCOMPARE(plan.idle_knobs.at("settle_share"), std::string("drops are caps"));
        }
        QVERIFY(!plan_of(as_is, 2).on("cap"));
        const std::pair<std::function<void(Experiment&)>, const char*> without[] = {
            {[](Experiment& e) { e.closure = Closure::paper; }, "closure pores"},
            {[](Experiment& e) { e.droplets[0].volume_ul = 300; }, "over the sample's edge"},
            {[](Experiment& e) {
                 e.droplets[0].at_mm = {5.5, 0};
             },
             "over the sample's edge"},
            {[](Experiment& e) { e.droplets[0].speed_m_s = 5; }, "may splash"}};
        for (const auto& [change, why] : without) {
            const ModelPlan plan = plan_of(change, 1);
            QVERIFY2(!plan.on("cap") && plan.particles_per_droplet > 0, why);
            const auto part = std::find_if(plan.parts.begin(), plan.parts.end(), [](const PlannedPart& p) { return p.name == "cap"; });
            QVERIFY(part != plan.parts.end());
            QVERIFY2(part->reason.find(why) != std::string::npos, part->reason.c_str());
        }
    }
    void aDropThatRepellentYarnsCannotHoldIsNoCap()
    {
        const auto reason_at = [](double angle, double speed) {
            Design design = drop_on_cotton(0.5, 1, angle);
            design.fabrics[0].ends_per_cm = 8; // open, and more so along the weft
            design.fabrics[0].picks_per_cm = 12;
            design.experiments[0].droplets[0].speed_m_s = speed;
            const Textile textile = textile_of_run(design, design.fabrics[0], design.experiments[0]);
            const ModelPlan plan = plan_model(design, textile, design.experiments[0], Fidelity::live);
            const auto part = std::find_if(plan.parts.begin(), plan.parts.end(), [](const PlannedPart& p) { return p.name == "cap"; });
            return part->on ? std::string() : part->reason;
        };
        QCOMPARE(reason_at(100, 0.3), std::string()); // 50 Pa
        const Design open = [] {
            Design design = drop_on_cotton(0.5, 1, 100);
            design.fabrics[0].ends_per_cm = 8;
            design.fabrics[0].picks_per_cm = 12;
            return design;
        }();
        const Textile textile = textile_of_run(open, open.fabrics[0], open.experiments[0]);
        const auto half_gap = [](const YarnSystem& system) { return 0.5 * (system.pitch - system.types[0].section.width); };
        const auto half_height = [](const YarnSystem& system) { return 0.5 * system.types[0].section.height; };
        const double holds = breakthrough_pressure(0.072, radian_from_degree(100), half_height(textile.warp), half_gap(textile.warp),
                                                   half_height(textile.weft), half_gap(textile.weft));
        QCOMPARE(reason_at(100, std::sqrt(2 * 0.95 * holds / 998 - 2 * gravity_acceleration * 1e-3)), std::string());
        const std::string reason = reason_at(100, std::sqrt(2 * 1.05 * holds / 998));
        QVERIFY2(reason.find("through the holes between the yarns") != std::string::npos, reason.c_str());
        QCOMPARE(reason_at(0, 0.3), std::string()); // which yarns draw in from below
    }
    void anOldNameOfAKnobIsStillRead()
    {
        KnobSettings settings;
        set_knob(settings, "steps_between_drinks", "3");
        QVERIFY((settings == KnobSettings{{"steps_between_absorption", 3}}));
        QCOMPARE(with_settings(knobs_of(Fidelity::draft), {{"steps_between_drinks", 3}}).steps_between_absorption, 3.0);
        ModelPlan plan = plan_with({{"steps_between_absorption", 5}});
        plan.idle_knobs["steps_between_absorption"] = "no drop falls";
        std::string text = plan_json(plan);
        const std::string now = "steps_between_absorption", before = "steps_between_drinks";
        QVERIFY(text.find(now) != std::string::npos);
        for (std::size_t at = text.find(now); at != std::string::npos; at = text.find(now)) text.replace(at, now.size(), before);
        QVERIFY(plan_from_json(text).knobs == plan.knobs && plan_from_json(text).idle_knobs == plan.idle_knobs);
        QVERIFY_EXCEPTION_THROWN(knob_named(""), Error);
    }
    void plansOfOlderRecordingsStillRead()
    {
        std::string text = plan_json(plan_with({{"fibre_shells", 3}}, Fidelity::draft));
        text.erase(text.find("  \"knobs\""), text.find("  \"parts\"") - text.find("  \"knobs\""));
        const ModelPlan plan = plan_from_json(text);
        QCOMPARE(plan.knobs.fibre_shells, 3.0);
        QCOMPARE(plan.knobs.neglected_share, knobs_of(Fidelity::draft).neglected_share);
        QCOMPARE(plan.knobs.steps_between_absorption, knobs_of(Fidelity::draft).steps_between_absorption);
        text = plan_json(plan_with({{"settle_share", 0}}, Fidelity::draft)); // yarns absorbed such liquid at each step
        QCOMPARE(plan_from_json(text).knobs.steps_between_absorption, knobs_of(Fidelity::draft).steps_between_absorption);
        text.erase(text.find("  \"knobs\""), text.find("  \"parts\"") - text.find("  \"knobs\""));
        QCOMPARE(plan_from_json(text).knobs.steps_between_absorption, 1.0);
    }
};

QTEST_APPLESS_MAIN(TestFidelity)
#include "tst_fidelity.moc"
