// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Many runs for one answer: which run when, what is kept of them, and what an interrupt or a failure leaves.
#include "core/analysis/sweep.h"
#include "core/base/error.h"
#include "tests/support/drop_design.h"

#include <QTest>

using namespace hygroloom;

namespace {

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
