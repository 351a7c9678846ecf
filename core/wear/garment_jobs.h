// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Garments that are compared: candidates, and the runs of their replicates.
#pragma once

#include "core/analysis/run_trace.h"
#include "core/analysis/sweep.h"
#include "core/wear/garment_run.h"

namespace hygroloom {

/// A garment that is compared: one experiment of a project.
struct GarmentCandidate {
    std::string name; ///< of the fabric, or of the project
    Design design;
    std::string experiment;
    std::filesystem::path base; ///< folder of the project
};

/// The garment of the experiment with each panel cut from the fabric; linings stay. Precondition: the design has all three.
GarmentCandidate cut_from(const Design& design, const std::string& experiment, const std::filesystem::path& base,
                          const std::string& fabric);

/// What of the project the run of an experiment on a garment depends on. Precondition: the design has both.
Design part_of_run(const Design& design, const std::string& experiment);
/// The same design from another folder: the files of its garments by their whole paths.
Design with_absolute_files(Design design, const std::filesystem::path& base);

/// What a run of a garment gave, as the first replicate, with its curves; the name is that of the one fabric that it is cut from, else of
/// the garment. Throws Error where the record's design lacks the experiment or the garment, or there is no frame.
Candidate candidate_of(const WearRecord& record, const WearMetrics& metrics, double wall);
/// The error of the numbers of several replicates, which their scatter is added to: that of the size of cells. One run of each shows no
/// scatter, so there is no verdict.
void add_error_of_cells(Candidate& candidate);

/// What its run takes on the backend, as learned. Cuts the garment into cells, which takes a while. Throws as bytes_of_largest().
WearPlan plan_of(const GarmentCandidate& candidate, const WearOptions& how, const std::string& backend);
/// The memory (bytes) that the largest of the runs takes. Throws FileError of what a garment names, NotEnoughMemory, Error.
std::size_t bytes_of_largest(const std::vector<GarmentCandidate>& candidates, const WearOptions& how);

/// Runs every candidate as often as the comparison has replicates, side by side, each run on one of the backends, and judges it: see
/// run_comparison() of samples. Replicate 0 of each comes first; it alone is recorded. callbacks(i): those of run i, of candidate i modulo
/// their number; ended(i) as there. Returns what the first run of each gave, empty where it failed or was cancelled.
std::vector<FinishedGarment> run_comparison(Comparison& comparison, const std::vector<GarmentCandidate>& candidates,
                                            const GarmentRunOptions& how, std::uint64_t seed,
                                            const std::vector<std::unique_ptr<Backend>>& backends, RunControl& control,
                                            const std::function<GarmentRunCallbacks(std::size_t)>& callbacks,
                                            const std::function<void(std::size_t)>& ended);

} // namespace hygroloom
