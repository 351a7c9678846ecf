// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A study as a job array of Slurm: each task runs a slice of the rows and leaves them in the study's folder.
#pragma once

#include "core/study/study_folder.h"

namespace hygroloom {

struct SlurmOptions {
    std::string sbatch;            ///< options for it, as they stand behind #SBATCH
    std::string backend = "auto";  ///< of each task
    int tasks = 0;                 ///< slices; 0: of 16 rows each, at most 1000
    bool gpus = false;             ///< one for each task
    bool retry_failed = false;     ///< also runs the rows that failed
    bool force = false;            ///< runs that take more memory than is free begin all the same
    std::filesystem::path program; ///< hygroloom-cli
};

struct SlurmJob {
    std::string id;
    int submitted = 0; ///< slices that lacked rows
};

/// Writes the study's folder and its slurm/job.sh, and submits that with sbatch, for the slices that lack rows. Throws Error: sbatch is
/// missing or refuses, nothing is missing; and what run_study() throws before the first run.
SlurmJob submit_study(const Design& design, const Study& study, const std::filesystem::path& folder, const StudyOptions& options,
                      const SlurmOptions& how);

/// A word for the shell; in quotes unless it is plain.
std::string shell_word(const std::string& word);

} // namespace hygroloom
