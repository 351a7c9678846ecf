// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the parts of the verb sweep share.
#pragma once

#include "app/cli_run.h"

#include "core/study/study_run.h"

namespace hygroloom {

struct SweepOptions : RunVerbOptions {
    std::string study;  ///< file
    std::string folder; ///< for the results
    bool resume = false, retry_failed = false;
    int jobs = 0;
    std::string task; ///< "3/64"
    bool merge = false, analyse = false;
    std::vector<std::string> predict; ///< "path=value"
    std::string suggest;              ///< a goal
    int count = 5;                    ///< of suggestions
    bool slurm = false, gpus = false;
    std::string sbatch; ///< options
    int tasks = 0;      ///< of the job array
};

/// The study's folder that exists. Throws Stop.
StudyFolder study_folder(const SweepOptions& options);
/// The project and the study of the command line, or of the folder where both are left out. Throws Stop.
StudyFolder given_study(const SweepOptions& options);

/// Each does what its option says and returns the exit code.
int merge_rows(const SweepOptions& options);
int analyse_rows(const SweepOptions& options);
int predict_rows(const SweepOptions& options);
int suggest_points(const SweepOptions& options);
int submit_to_slurm(const SweepOptions& options);

/// What the study's indices are, after a run whose study asks for them. Notes on stderr why there are none.
void analyse_after_run(const SweepOptions& options);

} // namespace hygroloom
