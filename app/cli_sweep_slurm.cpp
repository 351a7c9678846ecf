// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Studies on a cluster: sweep --slurm.
#include "app/cli_sweep.h"

#include "core/study/slurm.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace hygroloom {

int submit_to_slurm(const SweepOptions& options)
{
    if (options.sbatch.find('\n') != std::string::npos) throw Stop(exit_usage, "--sbatch: This must be one line; given are several.");
    const StudyFolder study = given_study(options);
    StudyOptions rows;
    rows.resume = options.resume || options.retry_failed;
    rows.retry_failed = options.retry_failed;
    const SlurmJob job = submit_study(study.design, study.study, options.folder, rows,
                                      {options.sbatch, options.backend, options.tasks, options.gpus, options.retry_failed, options.force,
                                       std::filesystem::canonical("/proc/self/exe")});
    if (options.json) {
        print_json({{"job", job.id}, {"submitted", job.submitted}, {"folder", options.folder}});
        return exit_ok;
    }
    print_result("Job {} with {} {}\n", job.id, job.submitted, job.submitted == 1 ? "task" : "tasks");
    if (!options.quiet)
        print_note("squeue -j {0} says how far it is, scancel {0} ends it.\nhygroloom-cli sweep -o {1} --merge makes the table of the runs "
                   "that have ended.\n",
                   job.id, shell_word(options.folder));
    return exit_ok;
}

} // namespace hygroloom
