// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Many runs for one answer: which run when, what is kept of them, and what an interrupt or a failure leaves.
#include "core/analysis/sweep.h"
#include "core/base/error.h"
#include "tests/support/drop_design.h"

#include <QTest>

using namespace hygroloom;

namespace {

ModelPlan plan_with(int shells)
{
    ModelPlan plan;
    plan.fibre_shells = shells;
    return plan;
}

/// draft, the same once more, reference, and half of it, which is not timed.
void add_variants(TradeoffSweep& sweep)
{
    sweep.add({"draft", Fidelity::draft, {}, true}, plan_with(1));
    sweep.add({"fibre_shells=1", Fidelity::standard, {}, true}, plan_with(1));
    sweep.add({"reference", Fidelity::reference, {}, true}, plan_with(8));
    sweep.add({"reference x 2", Fidelity::reference, {}, false}, plan_with(16));
}

TradeoffOutcome outcome(double radius, double wall)
{
    TradeoffOutcome outcome;
    outcome.metrics["radius_mm"] = radius;
    outcome.wall = wall;
    outcome.backend = "cpu";
    return outcome;
}

Candidate candidate_with(const std::string& fabric, const std::string& key, double number)
{
    Candidate candidate;
    candidate.fabric = fabric;
    candidate.replicates = {ReplicateRun{{{key, number}}, {}}};
    candidate.numerical[key] = 0;
    return candidate;
}

Comparison of_drops()
{
    Comparison comparison;
    comparison.criteria = compared_by(ExperimentType::droplet);
    comparison.ranked_by = comparison.criteria[0];
    return comparison;
}

} // namespace

class TestSweep : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void variantsTakeTurnsAndAreComparedWithTheReference()
    {
        Tradeoff result;
        result.repeats = 2;
        TradeoffSweep sweep(result);
        add_variants(sweep);
        QCOMPARE(result.points.size(), std::size_t(3));
        QCOMPARE(result.points[0].stands_for, std::vector<std::string>{"fibre_shells=1"});
        std::vector<std::pair<std::size_t, int>> order;
        int changes = 0;
        const double radii[] = {9, 10, 9.5}, walls[] = {1, 7, 3};
        sweep.run(
            [&](std::size_t i, int repeat) {
                order.emplace_back(i, repeat);
                return outcome(radii[i], walls[i] + repeat);
            },
            [&] { ++changes; });
        QVERIFY((order == std::vector<std::pair<std::size_t, int>>{{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}}));
        QCOMPARE(changes, 6);
        QVERIFY(result.complete);
        QCOMPARE(result.backend, std::string("cpu"));
        QCOMPARE(result.points[0].walls, (std::vector<double>{1, 2}));
        QVERIFY(result.points[2].walls.empty());
        QVERIFY(std::abs(result.points[0].errors->largest - 0.1) < 1e-12); // 9 for 10
        QCOMPARE(result.convergence.size(), std::size_t(1));
        QVERIFY(std::abs(result.convergence[0].errors.largest - 0.5 / 9.5) < 1e-12); // 10 for 9.5
    }
    void anInterruptedTradeoffKeepsItsRuns()
    {
        Tradeoff result;
        result.repeats = 1;
        TradeoffSweep sweep(result);
        add_variants(sweep);
        const auto run = [](std::size_t i, int) {
            if (i == 1) throw Cancelled();
            return outcome(9, 1);
        };
        QVERIFY_EXCEPTION_THROWN(sweep.run(run, [] {}), Cancelled);
        QVERIFY(!result.complete && result.points[0].walls.size() == 1 && !result.points[0].errors && result.points[1].walls.empty());
    }
    void aFailedCandidateIsRankedLast()
    {
        Comparison comparison = of_drops();
        std::vector<std::unique_ptr<Backend>> backends;
        backends.push_back(make_cpu_backend());
        RunControl control;
        const std::vector<std::string> fabrics{"A", "B", "C"};
        std::vector<std::size_t> known;
        run_comparison(
            comparison, fabrics, backends, control,
            [&](std::size_t i, Backend&) {
                if (i == 0) throw Error("no yarn");
                return CandidateRun{candidate_with(fabrics[i], comparison.ranked_by.key, 5), false};
            },
            [&](std::size_t) { known.push_back(comparison.candidates.size()); });
        QVERIFY((known == std::vector<std::size_t>{1, 2, 3}));
        QVERIFY(comparison.complete);
        QCOMPARE(comparison.candidates[0].fabric, std::string("B"));
        QCOMPARE(comparison.candidates[1].fabric, std::string("C"));
        QCOMPARE(comparison.candidates[2].failure, std::string("no yarn"));
    }
    void everyFabricHasItsReplicates()
    {
        Comparison comparison = of_drops();
        comparison.replicates = 3;
        std::vector<std::unique_ptr<Backend>> backends;
        backends.push_back(make_cpu_backend());
        RunControl control;
        const std::vector<std::string> fabrics{"A", "B"};
        std::vector<std::size_t> order;
        run_comparison(
            comparison, fabrics, backends, control,
            [&](std::size_t i, Backend&) {
                if (i == 3) throw Error("no yarn");
                return CandidateRun{
                    candidate_with(fabrics[i % 2], comparison.ranked_by.key, 10.0 * static_cast<double>(i % 2) + static_cast<double>(i)),
                    false};
            },
            [&](std::size_t i) {
                order.push_back(i);
                QCOMPARE(comparison.complete, order.size() == 6);
            });
        QVERIFY((order == std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
        const Candidate& b = comparison.candidates[comparison.candidates[0].fabric == "B" ? 0 : 1];
        QCOMPARE(b.replicates.size(), std::size_t(3));
        QVERIFY(b.replicates[0] && !b.replicates[1] && b.replicates[2]);
        QCOMPARE(b.replicates[2]->numbers.at(comparison.ranked_by.key), 15.0);
    }
    void whatCannotBeWrittenEndsTheComparison()
    {
        Comparison comparison = of_drops();
        std::vector<std::unique_ptr<Backend>> backends;
        backends.push_back(make_cpu_backend());
        RunControl control;
        const auto run = [&](std::size_t, Backend&) { return CandidateRun{candidate_with("A", comparison.ranked_by.key, 5), false}; };
        const auto fail = [](std::size_t) { throw FileError("the disk is full"); };
        QVERIFY_EXCEPTION_THROWN(run_comparison(comparison, {"A", "B"}, backends, control, run, fail), FileError);
        QVERIFY(!comparison.complete);
    }
    void aRunIsMeasuredBesideItsCallbacks()
    {
        const auto backend = make_cpu_backend();
        RunControl control;
        RunOptions options;
        options.fidelity = Fidelity::draft;
        options.knobs = {{"particles_per_droplet", 100}};
        int frames = 0;
        RunCallbacks beside;
        beside.frame = [&](const std::shared_ptr<const Frame>&) { ++frames; };
        const FinishedRun finished = run_and_measure(drop_design(35, 0.02), "cloth", "drop", options, *backend, control, beside);
        QVERIFY(frames > 1 && finished.device_failure.empty());
        QCOMPARE(finished.run.fabric, std::string("cloth"));
        QVERIFY(std::abs(finished.metrics.ledger.water_delivered / 2e-6 - 1) < 0.01); // 2 ul of water
    }
};

QTEST_GUILESS_MAIN(TestSweep)
#include "tst_sweep.moc"
