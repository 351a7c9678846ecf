// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/queue/run_job.h"

#include "core/base/error.h"
#include "core/run/learned_times.h"
#include "core/run/plan_run.h"
#include "core/wear/worn_candidate.h"

namespace hygroloom {
namespace {

Replicate replicate_of(const RunJob& job) { return {job.how.seed, job.replicate, job.replicates}; }

RunResult run_sample(const RunJob& job, Backend& backend, RunControl& control)
{
    RunResult result;
    result.drawn = drawn(*job.design, job.fabric, job.experiment, replicate_of(job));
    RunOptions how = job.how;
    how.seed = result.drawn.seed;
    if (job.replicates > 1) how.textile = nullptr; // that of the cloth as it is described
    result.sample = run_and_measure(result.drawn.design, job.fabric, job.experiment, how, backend, control, job.beside, job.measured);
    result.device = result.sample->run.device;
    if (job.times_count && !control.was_paused && result.device_failure().empty()) learn_time(result.sample->run);
    return result;
}

RunResult run_worn(const RunJob& job, Backend& backend, RunControl& control)
{
    const Design cut = cut_from(*job.design, job.experiment, job.fabric);
    const std::string& garment = find_wear(cut, job.experiment)->garment;
    RunResult result;
    result.drawn = drawn(cut, fabrics_of(*find_garment(cut, garment)), replicate_of(job));
    const Design& own = result.drawn.design;
    const GarmentParts parts = garment_parts(own, *find_wear(own, job.experiment), job.base, [&control] { return control.cancel.load(); });
    result.garment = run_garment(parts, job.how, backend, control, job.beside, job.worn);
    result.device = result.garment->record->device;
    if (job.times_count && !control.was_paused) learn_time(*result.garment);
    return result;
}

} // namespace

std::string RunResult::failure() const
{
    if (!error) return {};
    try {
        std::rethrow_exception(error);
    } catch (const Cancelled&) {
        return {};
    } catch (const std::bad_alloc&) {
        return "The memory does not suffice for this run.";
    } catch (const std::exception& reason) {
        return reason.what();
    }
}

RunResult run_job(const RunJob& job, Backend& backend, RunControl& control)
{
    return find_wear(*job.design, job.experiment) ? run_worn(job, backend, control) : run_sample(job, backend, control);
}

double bytes_of(const RunJob& job)
{
    const Design& design = *job.design;
    if (find_wear(design, job.experiment))
        return plan_worn(cut_from(design, job.experiment, job.fabric), job.experiment, job.base, job.how, "cpu").bytes;
    const Experiment& experiment = *find_experiment(design, job.experiment);
    const Textile textile = job.how.textile ? *job.how.textile : textile_of_run(design, *find_fabric(design, job.fabric), experiment);
    return static_cast<double>(bytes_of_largest(design, experiment, {textile}, job.how));
}

} // namespace hygroloom
