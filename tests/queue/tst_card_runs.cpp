// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The tests of a card: how they are done, what is said of those that cannot be, and when a recording stands for a run.
#include "core/analysis/card.h"
#include "core/base/error.h"
#include "core/design/validate.h"
#include "core/project/library.h"
#include "core/queue/card_runs.h"
#include "tests/support/places.h"
#include "tests/support/run.h"

#include <fmt/format.h>

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace hygroloom;

namespace {

/// A poplin of the library, and what its card says without runs.
struct TestedCloth {
    Design design;
    LaboratoryNumbers known;
    const Fabric& fabric() const { return design.fabrics.front(); }
};

const TestedCloth& poplin()
{
    static const TestedCloth cloth = [] {
        TestedCloth made;
        for (const Preset& preset : shipped_presets())
            if (preset.fabric().name == "Poplin shirting") made.design = preset.design;
        made.known = laboratory_numbers(made.design, made.fabric(), *validate_and_fit(made.design).fabrics.front());
        return made;
    }();
    return cloth;
}

/// These tests, at `live`.
CardRuns quick(const std::vector<std::string>& tests)
{
    CardRuns what{tests, {}};
    what.how.fidelity = Fidelity::live;
    return what;
}

const LaboratoryNumber* number_of(const LaboratoryNumbers& numbers, const std::string& key)
{
    const auto found = std::find_if(numbers.found.begin(), numbers.found.end(), [&](const auto& number) { return number.key == key; });
    return found == numbers.found.end() ? nullptr : &*found;
}

LaboratoryNumbers run(const CardJobs& jobs, const std::atomic<bool>& cancel, int* told = nullptr)
{
    RunQueue queue;
    return run_card_jobs(jobs, 1, queue, cpu_places(), cancel, {}, [told](const LaboratoryNumbers&) {
        if (told) ++*told;
    });
}

} // namespace

class TestCardRuns : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyTestIsOfTheStandard()
    {
        const CardJobs jobs = card_jobs(poplin().design, poplin().fabric(), poplin().known, quick(card_test_keys({"all"})));
        QCOMPARE(jobs.tests.size(), std::size_t{6});
        QCOMPARE(jobs.jobs.size(), jobs.tests.size());
        QVERIFY(jobs.bytes > 0);
        const auto test = [&](const char* key) {
            return std::find_if(jobs.tests.begin(), jobs.tests.end(), [&](const CardTest& each) { return each.key == key; })->experiment;
        };
        QCOMPARE(test("absorbency").duration_s, 60.0);
        QCOMPARE(test("wicking_warp").duration_s, 1800.0);
        QVERIFY(test("wicking_weft").along_weft && !test("wicking_warp").along_weft);
        QCOMPARE(test("management"), [] {
            Experiment e = standard_experiment(ExperimentType::moisture_management);
            e.name = "management";
            return e;
        }());
        // It dries from what it holds when it has drained.
        QVERIFY(std::abs(test("drying").initial_water_g_m2 - number_of(poplin().known, "absorption_drained_g_m2")->estimate.value) < 0.06);
    }
    void theirNumbersFollowThoseThatNeedNoRun()
    {
        const CardJobs jobs = card_jobs(poplin().design, poplin().fabric(), poplin().known, quick({"drying", "regain"}));
        int told = 0;
        const LaboratoryNumbers numbers = run(jobs, false, &told);
        QCOMPARE(told, 2);
        QVERIFY(numbers.missing.empty());
        QCOMPARE(numbers.found.size(), poplin().known.found.size() + 5);
        const LaboratoryNumber &time = *number_of(numbers, "drying_time_min"), &rate = *number_of(numbers, "drying_rate_g_m2_h"),
                               &index = *number_of(numbers, "drying_index_pct_min");
        QCOMPARE(time.run, std::string("live, cpu"));
        QVERIFY(time.estimate.low < time.estimate.value && time.estimate.value < time.estimate.high);
        const double water = jobs.tests[0].experiment.initial_water_g_m2;
        QVERIFY(std::abs(index.estimate.value * water * 60 / 100 / rate.estimate.value - 1) < 1e-6);
        QVERIFY(time.estimate.value > 60 * water / rate.estimate.value * 0.96 * 0.9); // never much faster than the steady rate
        // Cotton of 65 % humidity holds 7 to 8 %.
        QVERIFY(number_of(numbers, "regain_percent")->estimate.value > 6.5 && number_of(numbers, "regain_percent")->estimate.value < 8);
    }
    void aClothThatTakesNoWaterDoesNotDry()
    {
        TestedCloth repellent = poplin();
        repellent.design.fabrics.front().contact_angle_deg = 120;
        repellent.known = laboratory_numbers(repellent.design, repellent.fabric(), *validate_and_fit(repellent.design).fabrics.front());
        const CardJobs jobs = card_jobs(repellent.design, repellent.fabric(), repellent.known, quick({"drying"}));
        QVERIFY(jobs.jobs.empty());
        const LaboratoryNumbers numbers = run(jobs, false);
        QCOMPARE(numbers.found.size(), repellent.known.found.size());
        QVERIFY(numbers.missing.back().find("no water that could dry") != std::string::npos);
    }
    void aRecordingOfTheSameClothStandsForARun()
    {
        const QTemporaryDir folder;
        CardRuns what = quick({"regain"});
        what.kept = folder.path().toStdString();
        const TestedCloth& cloth = poplin();
        const LaboratoryNumbers first = run(card_jobs(cloth.design, cloth.fabric(), cloth.known, what), false);
        const CardJobs again = card_jobs(cloth.design, cloth.fabric(), cloth.known, what);
        QVERIFY(again.jobs.empty());
        const LaboratoryNumber kept = *number_of(run(again, false), "regain_percent");
        QCOMPARE(kept.estimate.value, number_of(first, "regain_percent")->estimate.value);
        QCOMPARE(kept.run, std::string("live, cpu, kept run"));
        what.how.fidelity = Fidelity::draft; // finer than what is kept
        QCOMPARE(card_jobs(cloth.design, cloth.fabric(), cloth.known, what).jobs.size(), std::size_t{1});
        what.how.fidelity = Fidelity::live;
        Design labelled = cloth.design;
        labelled.fabrics.front().warp.library_yarn = "Ne 40 of the mill";
        labelled.fabrics.front().weft.price = 6.5;
        labelled.fabrics.front().weft.color = Color{1, 2, 3};
        labelled.fabrics.front().weft.twist_direction = TwistDirection::s;
        QVERIFY(card_jobs(labelled, labelled.fabrics.front(), cloth.known, what).jobs.empty()); // a look makes no other cloth
        Design other = cloth.design;
        other.fabrics.front().ends_per_cm *= 0.9;
        QCOMPARE(card_jobs(other, other.fabrics.front(), cloth.known, what).jobs.size(), std::size_t{1});
        CardRuns seeded = what, forced = what;
        seeded.how.seed = 7;
        forced.how.forced["heat"] = false;
        for (const CardRuns& otherwise : {seeded, forced}) {
            const CardJobs jobs = card_jobs(cloth.design, cloth.fabric(), cloth.known, otherwise);
            QCOMPARE(jobs.jobs.size(), std::size_t{1});
            QCOMPARE(jobs.jobs.front().job.how.recording, what.kept / "regain-2.hygrorec"); // none is replaced
        }
    }
    /// Water rises as fast as it goes in a level strip, along either system, while its weight hardly counts; in two seconds it has passed
    /// so many crossings that one more or less is little.
    void aLevelStripGoesAsAHangingOneBegins()
    {
        for (const char* system : {"warp", "weft"}) {
            Design design = poplin().design;
            design.experiments = {card_test(std::string("wicking_") + system, poplin().fabric(), poplin().known.found).experiment};
            design.experiments[0].duration_s = 2;
            RunOptions how;
            how.fidelity = Fidelity::live;
            const double risen = 1e3 * run(design, how).metrics.wicking->height / std::sqrt(2.0); // mm/s^(1/2)
            const Estimate level = number_of(poplin().known, fmt::format("wicking_speed_{}_mm_sqrt_s", system))->estimate;
            QVERIFY2(level.low < risen && risen < level.high,
                     qPrintable(QString("%1: %2, %3 to %4").arg(system).arg(risen).arg(level.low).arg(level.high)));
        }
    }
    void aCardSaysShortlyThatAStepDidNotSettle()
    {
        LaboratoryNumbers numbers;
        Candidate candidate;
        Metrics metrics;
        metrics.unsettled = 4;
        metrics.notes = {"The strip was wet to its end."};
        candidate.metrics = std::make_shared<const Metrics>(metrics);
        add_test_numbers(numbers, card_test("wicking_warp", poplin().fabric(), poplin().known.found), candidate, "live, cpu");
        QCOMPARE(numbers.notes, (std::vector<std::string>{"Wicking along the warp: The strip was wet to its end.",
                                                          "Wicking along the warp: 4 times the computation did not settle along a yarn."}));
        QCOMPARE(notes_of(metrics).size(), std::size_t{2}); // the run's own report has it, too
        QVERIFY(notes_of(metrics).back().find("4 times the suctions along a yarn") != std::string::npos);
    }
    void aBatchIsPausedAndSharesMemory()
    {
        const CardJobs jobs = card_jobs(poplin().design, poplin().fabric(), poplin().known, quick({"regain"}));
        RunQueue queue;
        std::atomic<bool> asked = false, paused = false, cancel = false;
        ComparedWatch watch;
        watch.room = [&] {
            asked = true;
            return 1e12;
        };
        watch.paused = [&](bool on) { paused = on; };
        watch.begins = [&](std::size_t, RunJob&) {
            if (!cancel) queue.set_paused(queue.list().front().id, true);
            cancel = true;
        };
        run_card_jobs(jobs, 1, queue, cpu_places(), cancel, watch);
        QVERIFY(asked && paused);
    }
    void whatWasStoppedIsMissing()
    {
        const CardJobs jobs = card_jobs(poplin().design, poplin().fabric(), poplin().known, quick({"drying"}));
        QCOMPARE(run(jobs, true).found.size(), poplin().known.found.size());
    }
    void testsAreAskedForByName()
    {
        QCOMPARE(card_test_keys({"all"}), card_test_keys());
        QCOMPARE(card_test_keys({"regain", "absorbency"}), (std::vector<std::string>{"absorbency", "regain"})); // in the card's order
        QVERIFY(card_test_keys(std::vector<std::string>{}).empty());
        QVERIFY_EXCEPTION_THROWN(card_test_keys({"sweat"}), Error);
    }
};

QTEST_GUILESS_MAIN(TestCardRuns)
#include "tst_card_runs.moc"
