// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A study as a job array of Slurm: each task runs a slice of the rows and leaves them in the study's folder. It is spoken to by its own
// programs: sbatch, squeue, scancel.
#pragma once

#include "core/study/study_folder.h"

#include <map>

namespace hygroloom {

struct SlurmOptions {
    std::string sbatch;            ///< options for it, as a shell would split them
    std::string backend;           ///< of each task
    int tasks = 0;                 ///< slices; 0: of 16 rows each, at most 1000 and what the cluster takes
    bool gpus = false;             ///< one for each task
    bool retry_failed = false;     ///< also runs the rows that failed
    bool force = false;            ///< runs that take more memory than is free begin all the same
    std::filesystem::path program; ///< hygroloom-cli
};

struct SlurmJob {
    std::string id;
    int tasks = 0;     ///< slices of the study
    int submitted = 0; ///< of those: that lacked rows
};

/// Why jobs cannot be submitted here, in a sentence; empty: they can.
std::string why_no_slurm();

/// Writes DIR/slurm/job.sh and submits it, for the slices that lack rows. Throws Error: Slurm is missing or refuses, a job of the study is
/// still on, nothing is missing; and what run_study() throws before the first run.
SlurmJob submit_study(const Design& design, const Study& study, const std::filesystem::path& folder, const StudyOptions& options,
                      const SlurmOptions& how);

struct SlurmStatus {
    std::string id;                    ///< empty: nothing was submitted
    std::map<std::string, int> states; ///< of Slurm -> tasks in the queue; empty: all have ended
    std::string problem;               ///< why the states are not known, in a sentence; empty: they are
    std::size_t rows = 0, done = 0, failed = 0;
};
SlurmStatus study_status(const std::filesystem::path& folder);

/// Throws Error where nothing was submitted.
void cancel_study(const std::filesystem::path& folder);

/// As a shell splits words, with quotes. Throws Error where one is not closed.
std::vector<std::string> shell_words(const std::string& text);

} // namespace hygroloom
