// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Studies on a cluster: sweep --slurm, --status and --cancel.
#include "app/cli_sweep.h"

#include "core/study/slurm.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

} // namespace

int submit_to_slurm(const SweepOptions& options)
{
    if (const std::string reason = why_no_slurm(); !reason.empty()) throw Stop(exit_failed, reason);
    const StudyFolder study = given_study(options);
    StudyOptions rows;
    rows.resume = options.resume || options.retry_failed;
    rows.retry_failed = options.retry_failed;
    SlurmOptions how;
    how.sbatch = options.sbatch;
    how.backend = options.backend;
    how.tasks = options.tasks;
    how.gpus = options.gpus;
    how.retry_failed = options.retry_failed;
    how.force = options.force;
    how.program = std::filesystem::canonical("/proc/self/exe");
    const SlurmJob job = submit_study(study.design, study.study, options.folder, rows, how);
    if (options.json) {
        print_json({{"job", job.id}, {"tasks", job.tasks}, {"submitted", job.submitted}, {"folder", options.folder}});
        return exit_ok;
    }
    print_result("Job {} with {} of {} tasks\n", job.id, job.submitted, job.tasks);
    if (!options.quiet)
        print_note("hygroloom-cli sweep -o {0} --status says how far it is, --cancel ends it, --merge makes the table at the end.\n",
                   options.folder);
    return exit_ok;
}

int slurm_status(const SweepOptions& options)
{
    study_folder(options); // says what is wrong with it
    const SlurmStatus status = study_status(options.folder);
    if (!status.problem.empty()) print_note("{}\n", status.problem);
    const int code = status.problem.empty() ? exit_ok : exit_failed;
    if (options.json) {
        print_json({{"job", status.id.empty() ? Json() : Json(status.id)},
                    {"states", status.problem.empty() ? Json(status.states) : Json()},
                    {"rows", status.rows},
                    {"done", status.done},
                    {"failed", status.failed},
                    {"missing", status.rows - status.done - status.failed}});
        return code;
    }
    print_result("{} of {} runs done, {} failed\n", status.done, status.rows, status.failed);
    if (status.id.empty() || code != exit_ok) return code;
    std::string states;
    for (const auto& [state, tasks] : status.states) states += fmt::format("{}{} {}", states.empty() ? "" : ", ", tasks, state);
    print_result("job {}: {}\n", status.id, states.empty() ? "no task is in the queue" : states);
    return exit_ok;
}

int slurm_cancel(const SweepOptions& options)
{
    cancel_study(options.folder);
    if (!options.quiet) print_note("The job has been told to end. {} keeps the runs that have ended.\n", options.folder);
    return exit_ok;
}

} // namespace hygroloom
