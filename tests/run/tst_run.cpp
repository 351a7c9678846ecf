// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whole runs: the ledger closes at every frame, threads change nothing, a wetting cloth absorbs and a repellent one does not.
#include "core/base/error.h"
#include "core/plan/model_plan.h"
#include "core/run/plan_run.h"
#include "core/run/recording.h"
#include "core/run/runner.h"
#include "core/scene/scene.h"
#include "core/solver/backend.h"
#include "core/verify/set_ups.h"
#include "tests/support/device.h"
#include "tests/support/drop_design.h"
#include "tests/support/run.h"

#include <QDir>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include <thread>

using namespace hygroloom;

namespace tst_run {
namespace {

// What is checked here does not depend on how fine a drop is.
const KnobSettings few_particles{{"particles_per_droplet", 300}};

std::vector<Frame> run(const Design& design, int threads, const ForcedParts& forced = {})
{
    RunOptions options = draft(forced, few_particles);
    options.threads = threads;
    return run(design, options).frames;
}

/// A device that fails: when it is to load, or at the given call of advance().
class FailingBackend : public Device {
public:
    explicit FailingBackend(int fails_at) : left_(fails_at) {}
    void load(const Scene& scene) override
    {
        if (left_ == 0) fail();
        cpu_->load(scene);
    }
    double advance(double until) override
    {
        if (--left_ == 0) fail();
        std::this_thread::sleep_for(pause);
        return cpu_->advance(until);
    }
    std::vector<std::byte> state() override
    {
        ++states;
        return cpu_->state();
    }

    int states = 0; ///< asked for
    std::chrono::milliseconds pause{0};

private:
    [[noreturn]] static void fail() { throw DeviceError("The device failed."); }
    int left_;
};

} // namespace

class TestRun : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aSeedPlacesTheParticlesOfADrop()
    {
        // On even yarns nothing else depends on it.
        const Design design = drop_design(35, 0.1);
        const auto with = [&](std::uint64_t seed) {
            RunOptions options = draft({}, few_particles);
            options.seed = seed;
            return run(design, options).frames;
        };
        const auto first = with(1), second = with(2), again = with(2);
        double apart = 0;
        for (std::size_t k = 0; k < first.size(); ++k) {
            QCOMPARE(second[k].liquid, again[k].liquid);
            for (std::size_t i = 0; i < first[k].liquid.size(); ++i)
                apart = std::max(apart, static_cast<double>(std::abs(first[k].liquid[i] - second[k].liquid[i])));
            const Ledger &a = first[k].ledger, &b = second[k].ledger;
            QCOMPARE(a.water_delivered, b.water_delivered);
            QVERIFY(std::abs(a.water_liquid - b.water_liquid) <= 0.1 * a.water_delivered); // alike on the whole
            QVERIFY(std::abs(b.water_imbalance()) <= 1e-9 * std::max(1e-12, b.water_delivered));
        }
        QVERIFY(apart > 0);
    }
    void vapourThatCameAndWentIsNotLost()
    {
        Design design = drop_design(90.1, 0.5);
        Experiment& experiment = design.experiments[0];
        experiment.type = ExperimentType::moisture_management;
        experiment.droplets.clear();
        experiment.volume_ul = 0.2;
        experiment.feed_s = 4;
        experiment.drop_ul = 1000; // none comes in this time
        experiment.climate.relative_humidity = 0;
        experiment.climates = {{0.008, {20, 1, 20}}, {0.016, {20, 1, 20}}, {0.03, {20, 0, 1}}};
        const std::vector<Frame> frames = run(design, 0, {{"sorption", false}, {"wicking", false}, {"vapour", true}});
        double most = 0;
        for (const Frame& frame : frames) most = std::max(most, -frame.ledger.water_evaporated);
        QVERIFY(most > 0);
        QCOMPARE(frames.back().ledger.water_delivered, 0.0);
        QVERIFY(std::abs(frames.back().ledger.water_evaporated) < 1e-12 * most); // it came to nothing that its rounding can be a share of
        QVERIFY(std::abs(frames.back().ledger.water_imbalance()) <= 1e-14 * most);
    }
    void ledgerClosesAndContentsStayInBounds_data()
    {
        QTest::addColumn<double>("angle");
        for (double angle : {0.0, 35.0, 89.9, 90.0, 120.0, 180.0}) QTest::addRow("%g degrees", angle) << angle;
    }
    void ledgerClosesAndContentsStayInBounds()
    {
        QFETCH(double, angle);
        const std::vector<Frame> frames = run(drop_design(angle, 0.2), 0, {{"vapour", true}, {"heat", true}});
        QCOMPARE(int(frames.size()), 101);
        for (const Frame& f : frames) {
            QVERIFY(std::abs(f.ledger.water_imbalance()) <= 1e-9 * 2e-6);
            for (std::size_t i = 0; i < f.saturation.size(); ++i) {
                QVERIFY(f.saturation[i] >= 0 && f.saturation[i] <= 1.000001f);
                QVERIFY(f.regain[i] >= 0 && f.regain[i] <= 0.2401f);
                QVERIFY(f.vapour[i] >= 0 && std::isfinite(f.temperature[i]));
            }
        }
        const Ledger& end = frames.back().ledger;
        if (angle >= 90) QCOMPARE(end.water_liquid, 0.0);
        if (angle < 60) QVERIFY(end.water_liquid > 0.2 * end.water_delivered);
    }
    void swollenYarnsGiveBackWhatTheyHaveNoRoomFor()
    {
        Design design = drop_design(35, 0.5);
        Experiment& experiment = design.experiments[0];
        ModelPlan plan = plan_run(design, design.fabrics[0], experiment, Fidelity::draft, {{"sorption", true}, {"growth", false}});
        plan.particles_per_droplet = 1000;
        const Textile textile = build_textile(design, design.fabrics[0], plan.region);
        for (bool swelling : {false, true}) {
            experiment.swelling = swelling;
            Scene scene = build_scene(design, textile, experiment, plan, 1);
            for (YarnParameters& yarn : scene.cloth.yarns) yarn.diffusivity = {DiffusionLaw::constant, 1e-10, 0.0}; // fibres fill at once
            for (int i = 0; i < scene.cloth.segments(); ++i)                                                        // full from the start
                scene.cloth.start.liquid.push_back(scene.climate.density *
                                                   scene.cloth.yarns[i < scene.cloth.crossings() ? 0 : 1].pore_area *
                                                   scene.cloth.length[static_cast<std::size_t>(i)]);
            const auto backend = make_cpu_backend();
            std::size_t most = 0;
            for (const Frame& f : frames_at(*backend, scene, {0.05, 0.1})) {
                most = std::max(most, f.positions.size());
                QVERIFY(std::abs(f.ledger.water_imbalance()) <= 1e-12 * (f.ledger.water_initial + f.ledger.water_delivered));
                QVERIFY(std::abs(f.ledger.energy_imbalance()) <= 1e-9 * std::abs(f.ledger.energy_released));
                for (float s : f.saturation) QVERIFY(s >= 0 && s <= 1.000001f);
            }
            if (swelling) QVERIFY2(most > 1000, qPrintable(QString("%1 particles").arg(most)));
            if (!swelling) QVERIFY(most <= 1000);
        }
    }
    void energyLedgerCloses()
    {
        const Ledger end = run(drop_design(35, 0.3), 0, {{"vapour", true}, {"heat", true}}).back().ledger;
        QVERIFY(end.energy_released != 0);
        QVERIFY(std::abs(end.energy_imbalance()) < 1e-9 * (std::abs(end.energy_released) + std::abs(end.energy_lost)));
    }
    void threadsDoNotChangeAByte()
    {
        const std::vector<Frame> one = run(drop_design(35, 0.3), 1), all = run(drop_design(35, 0.3), 0),
                                 four = run(drop_design(35, 0.3), 4);
        QCOMPARE(one.size(), all.size());
        for (std::size_t k = 0; k < one.size(); ++k)
            for (const std::vector<Frame>* other : {&all, &four}) {
                QCOMPARE((*other)[k].saturation, one[k].saturation);
                QCOMPARE((*other)[k].regain, one[k].regain);
                QCOMPARE((*other)[k].temperature, one[k].temperature);
                QVERIFY((*other)[k].positions == one[k].positions);
            }
    }
    void stateGoesOnWhereItWasTaken()
    {
        const Design design = drop_design(35, 0.2);
        const ModelPlan plan =
            plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft, {{"vapour", true}, {"heat", true}});
        const Textile textile = build_textile(design, design.fabrics[0], plan.region);
        const Scene scene = build_scene(design, textile, design.experiments[0], plan, 1);
        const auto one = make_cpu_backend(), other = make_cpu_backend();
        const auto advance = [](Backend& backend, double until) {
            for (double reached = 0; reached < until;) reached = backend.advance(until);
        };
        one->load(scene);
        advance(*one, 0.1);
        other->load(scene);
        other->go_on_from(one->state());
        const Frame a = one->frame(), b = other->frame();
        QVERIFY(!a.positions.empty() && a.ledger.water_liquid > 0);
        QCOMPARE(b.time, a.time);
        QCOMPARE(b.saturation, a.saturation);
        QCOMPARE(b.regain, a.regain);
        QCOMPARE(b.temperature, a.temperature);
        QVERIFY(b.positions == a.positions && b.velocities == a.velocities);
        QCOMPARE(b.ledger.water_imbalance(), a.ledger.water_imbalance());

        advance(*one, 0.2);
        advance(*other, 0.2);
        const Ledger end = one->frame().ledger, moved = other->frame().ledger;
        QVERIFY(std::abs(moved.water_imbalance()) <= 1e-12 * moved.water_delivered);
        QVERIFY(std::abs(moved.water_liquid - end.water_liquid) < 0.01 * end.water_delivered); // neighbours in another order
        Scene larger = scene;
        larger.rules.particles_per_droplet *= 2;
        other->load(larger);
        QVERIFY_EXCEPTION_THROWN(other->go_on_from(one->state()), Error);
    }
    void dryingGoesOnToTheSameBytes()
    {
        Design design = drop_design(35, 1);
        Experiment drying = standard_experiment(ExperimentType::drying);
        drying.sample_mm = {4, 4};
        design.experiments = {drying};
        const ModelPlan plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft);
        const Textile textile = build_textile(design, design.fabrics[0], plan.region);
        const Scene scene = build_scene(design, textile, design.experiments[0], plan, 1);
        QVERIFY(scene.rules.step_error > 0);
        const auto one = make_cpu_backend(), other = make_cpu_backend();
        const auto advance = [](Backend& backend, double until) {
            for (double reached = 0; reached < until;) reached = backend.advance(until);
        };
        one->load(scene);
        advance(*one, 30);
        other->load(scene);
        other->go_on_from(one->state());
        for (double until : {60.0, 200.0, 500.0}) {
            advance(*one, until);
            advance(*other, until);
            const Frame a = one->frame(), b = other->frame();
            QCOMPARE(b.saturation, a.saturation);
            QCOMPARE(b.regain, a.regain);
            QCOMPARE(b.vapour, a.vapour);
            QCOMPARE(b.temperature, a.temperature);
            QCOMPARE(b.ledger.water_evaporated, a.ledger.water_evaporated);
            QCOMPARE(b.ledger.energy_imbalance(), a.ledger.energy_imbalance());
            QVERIFY(other->state() == one->state()); // all of it, to the byte
        }
        QVERIFY(one->frame().ledger.water_evaporated > 0);
    }
    void runGoesOnOnTheCpu_data()
    {
        QTest::addColumn<int>("failsAt");
        QTest::addColumn<int>("pauseMs");
        QTest::addColumn<bool>("keepsState");
        QTest::newRow("not enough memory") << 0 << 0 << false;
        QTest::newRow("at once") << 1 << 0 << false;
        QTest::newRow("before anything was kept") << 5 << 0 << false;
        QTest::newRow("after some seconds") << 60 << 60 << true;
    }
    void runGoesOnOnTheCpu()
    {
        QFETCH(int, failsAt);
        QFETCH(int, pauseMs);
        QFETCH(bool, keepsState);
        const Design design = drop_design(35, 0.2);
        RunOptions options;
        options.fidelity = Fidelity::draft;
        options.knobs = few_particles;
        options.recording = QDir(folder_.path()).filePath("moved.hygrorec").toStdString();
        RunControl control;
        std::vector<Frame> frames;
        QString reported;
        RunCallbacks callbacks;
        callbacks.frame = [&](const std::shared_ptr<const Frame>& frame) { frames.push_back(*frame); };
        callbacks.device_failed = [&](const std::string& sentence) { reported += QString::fromStdString(sentence); };
        {
            FailingBackend gives_up(failsAt);
            QVERIFY_EXCEPTION_THROWN(run_experiment(design, "cloth", "drop", options, gives_up, control, callbacks), DeviceError);
        }
        QVERIFY(reported.isEmpty());
        frames.clear();
        options.may_go_on_on_cpu = true;
        FailingBackend fails(failsAt);
        fails.pause = std::chrono::milliseconds(pauseMs);
        const RunRecord record = run_experiment(design, "cloth", "drop", options, fails, control, callbacks);
        QCOMPARE(fails.states > 0, keepsState);
        QCOMPARE(reported.count("goes on on the CPU"), 1);
        QVERIFY2(reported.contains("The device failed."), qPrintable(reported));
        const Recording recording(options.recording);
        QVERIFY(recording.finished());
        QCOMPARE(recording.run().device, record.device);
        QVERIFY(QString::fromStdString(record.device).startsWith("a device; from "));
        const std::vector<Frame> expected = run(design, 0);
        QCOMPARE(recording.frames(), int(expected.size()));
        QCOMPARE(frames.size(), expected.size());
        for (std::size_t k = 0; k < frames.size(); ++k) {
            QCOMPARE(frames[k].time, expected[k].time);
            QVERIFY(std::abs(frames[k].ledger.water_liquid - expected[k].ledger.water_liquid) <
                    0.02 * expected.back().ledger.water_delivered);
        }
    }
    void lessWettingClothAbsorbsMoreSlowly()
    {
        double before = 1e9;
        for (double angle : {70.0, 75.0, 80.0, 88.0}) {
            Design design = drop_design(angle, 0.25);
            design.experiments[0].closure = Closure::pores; // of the paper's, fibres have one angle
            const double absorbed = run(design, 0).back().ledger.water_liquid;
            QVERIFY(absorbed < before);
            before = absorbed;
        }
    }
    void stainOfABalancedPlainWeaveIsRound()
    {
        const Frame end = run(drop_design(35, 0.5), 0).back();
        const int n = static_cast<int>(end.saturation.size() / 2);
        double warp = 0, weft = 0;
        for (int i = 0; i < n; ++i) {
            warp += static_cast<double>(end.liquid[static_cast<std::size_t>(i)]);
            weft += static_cast<double>(end.liquid[static_cast<std::size_t>(n + i)]);
        }
        QVERIFY2(std::abs(warp - weft) < 0.1 * (warp + weft), qPrintable(QString("%1 %2").arg(warp).arg(weft)));
    }
    void cancellingEndsTheRunSoon()
    {
        Design design = drop_design(35, 100);
        RunControl control;
        QElapsedTimer since;
        std::atomic<bool> cancelled{false};
        std::thread run_thread([&] {
            const auto backend = make_cpu_backend();
            try {
                run_experiment(design, "cloth", "drop", {}, *backend, control, {});
            } catch (const Cancelled&) {
                cancelled = true;
            }
        });
        QTest::qSleep(400);
        since.start();
        control.cancel = true;
        run_thread.join();
        QVERIFY(cancelled);
        // A fifth of a second on a machine that does nothing else; here only a run that does not hear at all shall fail.
        QVERIFY2(since.elapsed() < 5000, qPrintable(QString::number(since.elapsed())));
    }

private:
    QTemporaryDir folder_;
};

} // namespace tst_run

QTEST_APPLESS_MAIN(tst_run::TestRun)
#include "tst_run.moc"
