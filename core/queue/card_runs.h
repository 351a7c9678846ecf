// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The numbers of a card that need runs, by the one queue.
#pragma once

#include "core/analysis/card_tests.h"
#include "core/queue/compared_runs.h"

namespace hygroloom {

/// Which tests of a card are run, and how.
struct CardRuns {
    std::vector<std::string> tests; ///< of card_test_keys()
    RunOptions how;                 ///< without textile and recording
    int replicates = 1;
    std::filesystem::path kept{}; ///< folder of their recordings, by the test's key; empty: none are kept. None is replaced
};

/// Tests of a fabric that are ready to run.
struct CardJobs {
    std::vector<CardTest> tests;
    std::vector<NamedJob> jobs;    ///< of each a run; named as its test
    double bytes = 0;              ///< that the largest run takes
    LaboratoryNumbers numbers;     ///< what was known before, and of tests that cannot be done why
    std::vector<Candidate> kept{}; ///< of tests that have a recording, see card_jobs()
};

/// known: the card's numbers so far. A recording of the same test of the same cloth stands for its run where it is whole, its fidelity is
/// the same or a finer one, its seed the same, this program's numbers are the same, no part was forced, and one run is asked for.
/// Precondition: validate() found no error in the fabric.
CardJobs card_jobs(const Design& design, const Fabric& fabric, const LaboratoryNumbers& known, const CardRuns& what);

/// Runs them; numbers: told after each, what is known by then. The watch's callbacks are called as run_comparison() says. Returns the last.
LaboratoryNumbers run_card_jobs(const CardJobs& jobs, int replicates, RunQueue& queue, const std::shared_ptr<RunPlaces>& places,
                                const std::atomic<bool>& cancel, const ComparedWatch& watch = {},
                                const std::function<void(const LaboratoryNumbers&)>& numbers = {});

} // namespace hygroloom
