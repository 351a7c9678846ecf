// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Parts that a plan left out come on while running when the cloth gets wetter than the plan's estimate took for granted, and only then.
#include "core/analysis/metrics_json.h"
#include "core/base/error.h"
#include "core/physics/heat_moisture.h"
#include "core/plan/expectation.h"
#include "core/plan/plan_json.h"
#include "core/run/part_watch.h"
#include "core/run/plan_run.h"
#include "core/run/recording.h"
#include "core/scene/scene.h"
#include "tests/support/device.h"
#include "tests/support/run.h"
#include "tests/support/spot_design.h"

#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

namespace tst_part_watch {
namespace {

/// A microlitre on polyester that it wets well. The estimate takes for granted that liquid stops where it fills a fifth of the pores; given
/// minutes, it does not.
Design spot(double humidity, double duration = 200)
{
    Design design = spot_design("polyester", humidity, duration);
    design.experiments[0].sample_mm = {24, 24}; // its edge stays dry
    return design;
}

/// Counts what a run asks of it, and fails or shows wet cloth when asked to.
class WatchedBackend : public Device {
public:
    void load(const Scene& scene) override
    {
        if (++loads == fails_at_load) throw DeviceError("The device failed.");
        if (loads == full_at_load) throw std::bad_alloc();
        cpu_->load(scene);
    }
    double advance(double until) override { return reached_ = cpu_->advance(until); }
    Frame frame() override
    {
        Frame frame = cpu_->frame();
        if (floods_at > 0 && reached_ >= floods_at) std::fill(frame.saturation.begin(), frame.saturation.end(), 1.0f);
        return frame;
    }
    std::vector<std::byte> state() override
    {
        if (++states == fails_at_state) throw DeviceError("The device failed.");
        if (states == full_at_state) throw std::bad_alloc();
        return cpu_->state();
    }

    int loads = 0, states = 0;
    int fails_at_load = 0, fails_at_state = 0;
    int full_at_load = 0, full_at_state = 0; // of memory
    double floods_at = 0;                    // s, from when on all of the cloth looks wet

private:
    double reached_ = 0;
};

const PlannedPart& part_of(const ModelPlan& plan, const std::string& name)
{
    return *std::find_if(plan.parts.begin(), plan.parts.end(), [&](const PlannedPart& part) { return part.name == name; });
}

bool same(const Frame& a, const Frame& b)
{
    return a.saturation == b.saturation && a.regain == b.regain && a.vapour == b.vapour && a.temperature == b.temperature &&
           a.positions == b.positions && a.ledger.water_evaporated == b.ledger.water_evaporated &&
           a.ledger.water_bound == b.ledger.water_bound;
}

void verify_balance(const Run& run)
{
    for (const Frame& frame : run.frames) {
        const Ledger& l = frame.ledger;
        QVERIFY2(std::abs(l.water_imbalance()) <= 1e-12 * (l.water_delivered + l.water_initial), qPrintable(QString::number(frame.time)));
        QVERIFY2(std::abs(l.energy_imbalance()) <= 1e-9 * (std::abs(l.energy_released) + std::abs(l.energy_lost)),
                 qPrintable(QString::number(frame.time)));
        QCOMPARE(l.water_initial, run.frames.front().ledger.water_initial);
    }
}

/// The first frame at which wet faces, counted crossing by crossing, would give more than a share of the water to the air by the end.
double first_over(const Run& dry, const Experiment& experiment, double share)
{
    const Textile& textile = dry.record.textile;
    const double temperature = kelvin_from_celsius(experiment.climate.temperature_c);
    const double air = mass_transfer(convective_heat_transfer(0, 1e-3 * experiment.sample_mm[0]), temperature) *
                       (1 - experiment.climate.relative_humidity) * saturation_concentration(temperature);
    double gone = 0, before = 0, time = 0;
    for (const Frame& frame : dry.frames) {
        double area = 0;
        for (int end = 0; end < textile.ends(); ++end)
            for (int pick = 0; pick < textile.picks(); ++pick)
                for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
                    const float s = frame.saturation[static_cast<std::size_t>(textile.segment(kind, end, pick))];
                    area += std::min(1.0, static_cast<double>(s) / 0.05) * textile.warp.pitch * textile.weft.pitch;
                }
        gone += 0.5 * (before + area) * air * (frame.time - time);
        before = area;
        time = frame.time;
        const double water = 1e-9 * experiment.volume_ul * find_liquid(dry.record.design, experiment.liquid)->density_kg_m3;
        if (time > 0 && gone + area * air * (experiment.duration_s - time) > share * water) return time;
    }
    return -1;
}

} // namespace

class TestPartWatch : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

private Q_SLOTS:
    void vapourComesOnWhereMoreGetsWetThanExpected()
    {
        const Design design = spot(0.9955);
        const Run left = run(design, draft({{"heat", false}})), on = run(design, draft({{"heat", false}, {"vapour", true}})),
                  off = run(design, draft({{"heat", false}, {"vapour", false}}));
        const PlannedPart& planned = part_of(left.record.plan, "vapour");
        QVERIFY(!planned.on && planned.watched && planned.share && *planned.share < 0.01);
        QVERIFY2(planned.reason.find("Watched while running: what would evaporate") != std::string::npos, planned.reason.c_str());
        QVERIFY(!part_of(off.record.plan, "vapour").watched);
        QVERIFY(on.record.switched_on.empty() && off.record.switched_on.empty());

        QCOMPARE(left.record.switched_on.size(), std::size_t(1));
        const SwitchedPart& part = left.record.switched_on[0];
        QCOMPARE(part.name, std::string("vapour"));
        QCOMPARE(part.limit, 0.01);
        QCOMPARE(part.estimate, *planned.share);
        QVERIFY(part.share > part.limit);
        QCOMPARE(part.time, first_over(off, design.experiments[0], 0.01));
        QVERIFY(part.time > 0 && part.time < 0.5 * design.experiments[0].duration_s);
        for (std::size_t k = 0; k < left.frames.size(); ++k) {
            QCOMPARE(same(left.frames[k], off.frames[k]), left.frames[k].time <= part.time);
            QCOMPARE(left.frames[k].ledger.water_evaporated > 0, left.frames[k].time > part.time);
        }
        verify_balance(left);

        const double water = on.end().ledger.water_delivered, wanted = on.end().ledger.water_evaporated;
        QVERIFY(wanted > 0.01 * water); // the estimate was wrong
        QVERIFY(std::abs(left.end().ledger.water_evaporated - wanted) < 0.01 * water);
        QVERIFY(std::abs(left.end().ledger.water_evaporated - wanted) < 0.2 * std::abs(off.end().ledger.water_evaporated - wanted));
        QVERIFY(std::abs(left.end().ledger.water_liquid - on.end().ledger.water_liquid) <
                0.2 * std::abs(off.end().ledger.water_liquid - on.end().ledger.water_liquid));
    }
    void fibresThatComeOnBeginWithTheRegainTheyHad()
    {
        const Design design = spot(0.65);
        const KnobSettings knobs{{"neglected_share", 0.045}};
        const Run left = run(design, draft({{"vapour", false}}, knobs)),
                  on = run(design, draft({{"vapour", false}, {"sorption", true}}, knobs)),
                  off = run(design, draft({{"vapour", false}, {"sorption", false}}, knobs));
        QCOMPARE(left.record.plan.fibre_shells, 1);
        QCOMPARE(on.record.plan.fibre_shells, 5);
        QCOMPARE(rough_bytes(left.record.plan), rough_bytes(on.record.plan)); // the shells may come on
        QVERIFY(rough_bytes(left.record.plan) > rough_bytes(off.record.plan));
        QVERIFY(!left.record.switched_on.empty());
        const SwitchedPart& part = left.record.switched_on[0];
        QCOMPARE(part.name, std::string("sorption"));
        for (std::size_t k = 0; k < left.frames.size(); ++k)
            QCOMPARE(same(left.frames[k], off.frames[k]), left.frames[k].time <= part.time);
        verify_balance(left);
        const double start = left.frames.front().ledger.water_bound;
        QVERIFY(left.end().ledger.water_bound > start);
        const double missed = std::abs(left.end().ledger.water_bound - on.end().ledger.water_bound);
        QVERIFY2(missed < 0.2 * std::abs(off.end().ledger.water_bound - on.end().ledger.water_bound), qPrintable(QString::number(missed)));
    }
    void heatComesOnWithTheFibresThatWarm() // not when most of the heat has been set free
    {
        const Run left = run(spot(0.2), draft({{"vapour", false}}, {{"neglected_share", 0.08}}));
        const auto& parts = left.record.switched_on;
        QCOMPARE(parts.size(), std::size_t(2));
        QCOMPARE(parts[0].name, std::string("sorption"));
        QCOMPARE(parts[1].name, std::string("heat"));
        QCOMPARE(parts[1].time, parts[0].time);
        QVERIFY(in_words(parts[0]).find("the plan had expected") != std::string::npos);
        QVERIFY2(in_words(parts[1]).find("the plan had expected") == std::string::npos, in_words(parts[1]).c_str());
        float warmest = 0;
        for (const Frame& frame : left.frames)
            warmest = std::max(warmest, *std::max_element(frame.temperature.begin(), frame.temperature.end()));
        QVERIFY2(warmest > 294.15f + 0.03f, qPrintable(QString::number(warmest)));
        verify_balance(left);
    }
    void vapourFollowsFibresInAirThatChanges_data()
    {
        QTest::addColumn<bool>("changes");
        QTest::addColumn<ForcedParts>("forced");
        QTest::addColumn<QString>("due");
        QTest::newRow("as in the plan") << true << ForcedParts{} << "sorption vapour heat";
        QTest::newRow("not if it is forced off") << true << ForcedParts{{"vapour", false}} << "sorption heat";
        QTest::newRow("not in steady air") << false << ForcedParts{} << "sorption heat";
    }
    void vapourFollowsFibresInAirThatChanges()
    {
        QFETCH(bool, changes);
        QFETCH(ForcedParts, forced);
        QFETCH(QString, due);
        Design design = spot(0.2, 1);
        Experiment& experiment = design.experiments[0];
        if (changes) experiment.climates = {{0.5, {21, 0.3, 0}}};
        const ModelPlan plan = plan_run(design, design.fabrics[0], experiment, Fidelity::draft, forced, {{"neglected_share", 0.08}});
        QVERIFY(plan.watches("sorption") && !plan.on("vapour"));
        const Scene scene = build_scene(design, build_textile(design, design.fabrics[0], plan.region), experiment, plan, 1);
        const auto backend = make_cpu_backend();
        backend->load(scene);
        Frame frame = backend->frame();
        PartWatch watch(scene, plan);
        QVERIFY(watch.see(frame).empty());
        std::fill(frame.saturation.begin(), frame.saturation.end(), 0.05f);
        frame.time = 0.9;
        QStringList names;
        for (const SwitchedPart& part : watch.see(frame)) {
            names << QString::fromStdString(part.name);
            QVERIFY(part.share > part.limit);
            QCOMPARE(part.estimate.has_value(), part.name == "sorption");
        }
        QCOMPARE(names.join(' '), due);
        QVERIFY(watch.see(frame).empty());
    }
    void whatComesOverTheLimitAtTheEndIsReported()
    {
        WatchedBackend backend;
        backend.floods_at = 50;
        RunOptions options = draft({{"vapour", false}}, {{"neglected_share", 0.1}});
        options.recording = folder_.filePath("end.hygrorec").toStdString();
        Design design = spot(0.65, 50);
        design.experiments[0].closure = Closure::pores; // its stain stops
        const Run left = run(design, options, backend);
        QVERIFY(!left.record.switched_on.empty());
        const SwitchedPart& part = left.record.switched_on[0];
        QCOMPARE(part.name, std::string("sorption"));
        QCOMPARE(part.time, 50.0);
        QCOMPARE(part.kept_off, std::string("the run was over"));
        QVERIFY2(in_words(part).starts_with("Sorption came over the limit at 50 s; it was not modelled"), in_words(part).c_str());
        QCOMPARE(left.metrics.notes.at(0), in_words(part));
        QCOMPARE(backend.loads, 1);
        const Recording recording(options.recording);
        QCOMPARE(in_words(recording.run().switched_on.at(0)), in_words(part));
    }
    void theRunGoesOnWithoutAPartThatFindsNoMemory_data()
    {
        QTest::addColumn<int>("atLoad");
        QTest::addColumn<int>("atState");
        QTest::newRow("when the scene is loaded with it") << 2 << 0;
        QTest::newRow("when asked what it has come to") << 0 << 1;
    }
    void theRunGoesOnWithoutAPartThatFindsNoMemory()
    {
        QFETCH(int, atLoad);
        QFETCH(int, atState);
        const Design design = spot(0.9955);
        WatchedBackend backend;
        backend.full_at_load = atLoad;
        backend.full_at_state = atState;
        const Run left = run(design, draft({{"heat", false}, {"sorption", false}}), backend),
                  off = run(design, draft({{"heat", false}, {"sorption", false}, {"vapour", false}}));
        QCOMPARE(left.record.switched_on.size(), std::size_t(1));
        QCOMPARE(left.record.switched_on[0].kept_off, std::string("the memory did not suffice"));
        QCOMPARE(left.metrics.notes, std::vector<std::string>{in_words(left.record.switched_on[0])});
        QCOMPARE(left.frames.size(), off.frames.size());
        QCOMPARE(left.end().ledger.water_evaporated, 0.0);
        const double moved = std::abs(left.end().ledger.water_liquid - off.end().ledger.water_liquid);
        QVERIFY2(moved < 1e-3 * off.end().ledger.water_delivered, qPrintable(QString::number(moved)));
    }
    void heatFollowsTheVapourThatComesOn()
    {
        Design design = spot(0.98);
        design.fabrics[0].warp.packing_factor = design.fabrics[0].weft.packing_factor = 0.3; // the stain grows until it cools
        const KnobSettings knobs{{"neglected_share", 0.025}};
        const Run left = run(design, draft({}, knobs)), without = run(design, draft({{"heat", false}}, knobs));
        const auto& parts = left.record.switched_on;
        QCOMPARE(parts.size(), std::size_t(2));
        QCOMPARE(parts[0].name, std::string("vapour"));
        QCOMPARE(parts[1].name, std::string("heat"));
        QVERIFY(parts[0].time < parts[1].time && parts[1].share > 0.025);
        QCOMPARE(without.record.switched_on.size(), std::size_t(1)); // what is forced off stays off
        verify_balance(left);
        for (const Frame& frame : left.frames) {
            const float coldest = *std::min_element(frame.temperature.begin(), frame.temperature.end());
            QCOMPARE(coldest<294.15f - 0.05f, frame.time> parts[1].time);
        }
        QVERIFY(left.end().ledger.water_evaporated < without.end().ledger.water_evaporated); // cooler, it dries slower
    }
    void aDropThatLiesOnTheClothGoesOn()
    {
        const Design design = drop_design(35, 0.2);
        ModelPlan plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft,
                                  {{"sorption", false}, {"vapour", false}, {"heat", false}});
        Scene scene = build_scene(design, build_textile(design, design.fabrics[0], plan.region), design.experiments[0], plan, 1);
        const auto advance = [](Backend& backend, double until) {
            for (double reached = 0; reached < until;) reached = backend.advance(until);
            return backend.frame();
        };
        const auto one = make_cpu_backend(), other = make_cpu_backend();
        one->load(scene);
        const Frame before = advance(*one, 0.1);
        one->stay();
        QVERIFY(!before.positions.empty() && before.ledger.water_liquid > 0);
        for (const char* part : {"sorption", "vapour", "heat"}) plan = with_part(std::move(plan), part);
        set_parts(scene, plan);
        QCOMPARE(scene.rules.fibre_shells, 5);
        other->load(scene);
        other->go_on_from(one->state());
        Frame begun = other->frame();
        begun.vapour = before.vapour; // what the liquid has squeezed is shown only now, and condenses in the first exchange
        QVERIFY(same(begun, before));
        const Frame without = advance(*one, 0.2), with = advance(*other, 0.2);
        QVERIFY(std::abs(with.ledger.water_imbalance()) <= 1e-12 * (with.ledger.water_initial + with.ledger.water_delivered));
        QVERIFY(std::abs(with.ledger.energy_imbalance()) <= 1e-9 * std::abs(with.ledger.energy_released));
        QCOMPARE(with.ledger.water_delivered, without.ledger.water_delivered);
        QCOMPARE(without.ledger.water_bound, before.ledger.water_bound);
        QVERIFY(with.ledger.water_bound > before.ledger.water_bound);
        QVERIFY(*std::max_element(with.temperature.begin(), with.temperature.end()) > 298.15f + 0.1f);
        // Going on lists neighbours anew, which alone moves water by up to 1 % of the drop (begun anew at 0.06 to 0.12 s); what fibres
        // take, and the warmer liquid, draw 1 to 2 % more into the yarns.
        const double moved = without.ledger.water_free - with.ledger.water_free;
        QVERIFY2(moved > -0.02 * with.ledger.water_delivered && moved < 0.05 * with.ledger.water_delivered,
                 qPrintable(QString::number(moved)));
        other->load(scene);
        Scene larger = scene;
        larger.rules.particles_per_droplet *= 2;
        one->load(larger);
        QVERIFY_EXCEPTION_THROWN(one->go_on_from(other->state()), Error);
    }
    void whatKeepsToItsEstimateCostsNothing()
    {
        const Design design = spot(0.999, 50);
        WatchedBackend backend;
        const Run left = run(design, draft({{"sorption", false}}), backend);
        QVERIFY(part_of(left.record.plan, "vapour").watched && part_of(left.record.plan, "heat").watched);
        QVERIFY(left.record.switched_on.empty() && left.metrics.notes.empty());
        QCOMPARE(backend.loads, 1);
        QCOMPARE(backend.states, 0);
        const Run off = run(design, draft({{"vapour", false}, {"heat", false}, {"sorption", false}}));
        QCOMPARE(left.frames.size(), off.frames.size());
        for (std::size_t k = 0; k < left.frames.size(); ++k) QVERIFY(same(left.frames[k], off.frames[k]));
    }
    void whatIsNotThereIsNotWatched()
    {
        const auto watched = [](const Design& design, Fidelity fidelity = Fidelity::draft) {
            QStringList names;
            for (const PlannedPart& part : plan_run(design, design.fabrics[0], design.experiments[0], fidelity).parts)
                if (part.watched) names << QString::fromStdString(part.name);
            return names.join(' ');
        };
        QCOMPARE(watched(spot(0.9955)), QString("vapour heat"));
        QCOMPARE(watched(spot(1.0)), QString(""));                         // nothing dries, and the fibres are full
        QCOMPARE(watched(spot(0.9955), Fidelity::reference), QString("")); // nothing is left out
        QCOMPARE(watched(drop_design(120)), QString("vapour heat"));       // the drop dries; no water gets to the fibres
        QCOMPARE(watched(drop_design(35)), QString("vapour"));
    }
    void theRecordingSaysWhenAndWhy()
    {
        RunOptions options = draft({{"heat", false}, {"sorption", false}});
        options.recording = folder_.filePath("watched.hygrorec").toStdString();
        const Run left = run(spot(0.9955), options);
        const Recording recording(options.recording);
        QCOMPARE(recording.run().switched_on.size(), std::size_t(1));
        const SwitchedPart &part = left.record.switched_on[0], &read = recording.run().switched_on[0];
        QCOMPARE(read.name, part.name);
        QCOMPARE(read.time, part.time);
        QCOMPARE(read.share, part.share);
        QCOMPARE(read.limit, part.limit);
        QCOMPARE(read.estimate, part.estimate);
        QVERIFY(part_of(recording.run().plan, "vapour").watched && !recording.run().plan.on("vapour"));
        MetricsCollector again;
        again.start(recording.run());
        for (int i = 0; i < recording.frames(); ++i) again.add(recording.frame(i));
        QCOMPARE(again.metrics().notes, left.metrics.notes);
        QCOMPARE(left.metrics.notes, std::vector<std::string>{in_words(part)});
        QVERIFY2(in_words(part).starts_with("Vapour was left out until "), in_words(part).c_str());
        const QString json = QString::fromStdString(metrics_json(recording.run(), again.metrics()));
        QVERIFY(json.contains("\"switched_on\": [") && json.contains("\"name\": \"vapour\""));
    }
    void aDeviceMayFailWhileAPartComesOn_data()
    {
        QTest::addColumn<int>("failsAtLoad");
        QTest::addColumn<int>("failsAtState");
        QTest::newRow("when the scene is loaded with it") << 2 << 0;
        QTest::newRow("when asked what it has come to") << 0 << 1;
    }
    void aDeviceMayFailWhileAPartComesOn()
    {
        QFETCH(int, failsAtLoad);
        QFETCH(int, failsAtState);
        const Design design = spot(0.9955);
        WatchedBackend backend;
        backend.fails_at_load = failsAtLoad;
        backend.fails_at_state = failsAtState;
        QVERIFY_EXCEPTION_THROWN(run(design, draft({{"heat", false}, {"sorption", false}}), backend), DeviceError);
        backend.loads = backend.states = 0;
        RunOptions options = draft({{"heat", false}, {"sorption", false}});
        options.may_go_on_on_cpu = true;
        const Run moved = run(design, options, backend), whole = run(design, draft({{"heat", false}, {"sorption", false}}));
        QVERIFY2(moved.record.device.starts_with("a device; from "), moved.record.device.c_str());
        QCOMPARE(moved.record.switched_on.size(), std::size_t(1));
        QCOMPARE(moved.record.switched_on[0].time, whole.record.switched_on[0].time);
        QCOMPARE(moved.frames.size(), whole.frames.size());
        for (std::size_t k = 0; k < moved.frames.size(); ++k) QVERIFY(same(moved.frames[k], whole.frames[k])); // no drops, so to the byte
    }
    void aCourseOfTheClimateDoesNotHideEvaporation() // of cloth whose fibres exchange nothing that counts
    {
        Design design = spot(0.5);
        Experiment drying = standard_experiment(ExperimentType::drying);
        drying.sample_mm = {5, 5};
        drying.climates = {{60, {30, 0.4, 1}}};
        design.experiments = {drying};
        const ModelPlan plan = plan_run(design, design.fabrics[0], drying, Fidelity::draft, {{"sorption", false}});
        QVERIFY(plan.on("vapour") && plan.on("heat"));
    }
    void coolingCountsByWhatItKeepsFromEvaporating() // near saturation a little cooling takes half of what drives it
    {
        Design design = spot(0.97);
        Experiment drying = standard_experiment(ExperimentType::drying);
        drying.sample_mm = {5, 5};
        drying.climate = {21, 0.97, 0};
        drying.duration_s = 4 * 3600;
        design.experiments = {drying};
        const ModelPlan plan = plan_run(design, design.fabrics[0], drying, Fidelity::draft);
        QVERIFY(plan.on("vapour") && plan.on("heat"));
        // h = 3.5 + 5.49 W/(m2 K); h_m = 3.5 / (1.200 * 1006 * 0.865^(2/3)) = 3.19 mm/s; 2.452 MJ/kg; 18.34 - 17.30 g/m3 over the last K.
        const double held = cooling_slows_evaporation(3.5 + 5.49, 3.19e-3, 294.15);
        const double by_hand = 3.19e-3 * 2.452e6 * 1.04e-3 / (8.99 + 3.19e-3 * 2.452e6 * 1.04e-3);
        QVERIFY2(std::abs(held - by_hand) < 0.01, qPrintable(QString("%1 %2").arg(held).arg(by_hand)));
        const double dries = std::min(1.0, *part_of(plan, "vapour").share);
        QVERIFY2(dries > 0.5 && std::abs(*part_of(plan, "heat").share / (by_hand * dries) - 1) < 0.03, qPrintable(QString::number(dries)));
    }
};

} // namespace tst_part_watch

QTEST_GUILESS_MAIN(tst_part_watch::TestPartWatch)
#include "tst_part_watch.moc"
