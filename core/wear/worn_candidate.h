// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Garments that are compared: cut from another fabric, what their runs depend on, take and give.
#pragma once

#include "core/analysis/comparison.h"
#include "core/analysis/run_trace.h"
#include "core/wear/garment_run.h"

namespace hygroloom {

/// The project with the garment of the experiment cut from the fabric in each panel; linings stay. An empty name cuts nothing.
/// Precondition: the design has all three.
Design cut_from(const Design& design, const std::string& experiment, const std::string& fabric);

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

/// What the run of an experiment on its garment takes on the backend, as learned. Cuts the garment into cells, which takes a while. base:
/// folder of the project. Throws FileError of what the garment names, NotEnoughMemory, Error.
WearPlan plan_worn(const Design& design, const std::string& experiment, const std::filesystem::path& base, const RunOptions& how,
                   const std::string& backend);

} // namespace hygroloom
