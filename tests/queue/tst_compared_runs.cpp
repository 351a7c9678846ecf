// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Many runs for one answer: which run when, what is kept of them, and what a failure leaves.
#include "core/analysis/comparison_report.h"
#include "core/base/error.h"
#include "core/queue/compared_runs.h"
#include "tests/support/places.h"
#include "tests/support/quick_job.h"

#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

namespace {

Comparison of_drops(int replicates = 1)
{
    Comparison comparison;
    comparison.criteria = compared_by(ExperimentType::droplet);
    comparison.ranked_by = comparison.criteria[0];
    comparison.replicates = replicates;
    return comparison;
}

/// Two that run, and one between whose fabric the project lacks.
std::vector<NamedJob> candidates()
{
    std::vector<NamedJob> all{{"A", quick_job()}, {"no yarn", quick_job()}, {"B", quick_job()}};
    all[1].job.fabric = "no yarn";
    return all;
}

void run(Comparison& comparison, const std::vector<NamedJob>& candidates, const ComparedWatch& watch = {})
{
    RunQueue queue;
    run_comparison(comparison, candidates, queue, cpu_places(), false, watch);
}

} // namespace

class TestComparedRuns : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aFailedCandidateIsRankedLast()
    {
        Comparison comparison = of_drops();
        std::vector<std::size_t> known, came;
        ComparedWatch watch;
        watch.came = [&](std::size_t i, const RunResult& result) {
            QVERIFY(result.sample);
            came.push_back(i);
        };
        watch.ended = [&](std::size_t) { known.push_back(comparison.candidates.size()); };
        run(comparison, candidates(), watch);
        QVERIFY((known == std::vector<std::size_t>{1, 2, 3}));
        QVERIFY((came == std::vector<std::size_t>{0, 2}));
        QVERIFY(comparison.complete);
        QCOMPARE(comparison.candidates[0].fabric, std::string("A"));
        QCOMPARE(comparison.candidates[1].fabric, std::string("B"));
        QCOMPARE(comparison.candidates[2].failure, std::string("There is no fabric named \"no yarn\" in the project."));
    }
    void everyCandidateHasItsReplicates()
    {
        Comparison comparison = of_drops(3);
        std::vector<std::size_t> order;
        std::vector<std::string> recordings;
        std::vector<NamedJob> two{{"A", quick_job()}, {"B", quick_job()}};
        const QTemporaryDir folder;
        for (NamedJob& each : two) each.job.how.recording = folder.filePath(each.name.c_str()).toStdString();
        ComparedWatch watch;
        watch.begins = [&](std::size_t i, RunJob& job) {
            recordings.push_back(job.how.recording.filename().string());
            if (i == 3) throw Error("no yarn");
        };
        watch.ended = [&](std::size_t i) {
            order.push_back(i);
            QCOMPARE(comparison.complete, order.size() == 6);
        };
        run(comparison, two, watch);
        QVERIFY((order == std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
        QVERIFY((recordings == std::vector<std::string>{"A", "B", "", "", "", ""}));
        const Candidate& b = comparison.candidates[comparison.candidates[0].fabric == "B" ? 0 : 1];
        QCOMPARE(b.replicates.size(), std::size_t(3));
        QVERIFY(b.replicates[0] && !b.replicates[1] && b.replicates[2]);
        QVERIFY(!b.unknowns.empty() && b.replicates[2]->places.size() == b.unknowns.size());
    }
    void whatCannotBeWrittenEndsTheComparison()
    {
        Comparison comparison = of_drops();
        ComparedWatch watch;
        watch.ended = [](std::size_t) { throw FileError("the disk is full"); };
        QVERIFY_EXCEPTION_THROWN(run(comparison, candidates(), watch), FileError);
        QVERIFY(!comparison.complete);
    }
    void theReportSaysWhatTheFabricsWeigh()
    {
        Comparison comparison = of_drops();
        const RunJob job = quick_job();
        const Textile textile = textile_of_run(*job.design, job.design->fabrics[0], job.design->experiments[0]);
        run(comparison, jobs_of(*job.design, {"cloth"}, "drop", {textile}, job.how));
        const Textile& kept = comparison.candidates.at(0).run->textile;
        QCOMPARE(kept.ends(), 0); // which is large
        QVERIFY(kept.quantities.areal_density_g_m2 > 0);
        QCOMPARE(kept.quantities.areal_density_g_m2, textile.quantities.areal_density_g_m2);
        QVERIFY(html_of(comparison_report(comparison, {})).find("mass per area, g/m²") != std::string::npos);
    }
};

QTEST_GUILESS_MAIN(TestComparedRuns)
#include "tst_compared_runs.moc"
