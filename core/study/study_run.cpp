// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/study/study_run.h"

#include "core/analysis/replicate_file.h"
#include "core/analysis/sweep.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/design/unknowns.h"
#include "core/design/validate.h"
#include "core/plan/expectation.h"
#include "core/project/atomic_file.h"
#include "core/project/project_json.h"
#include "core/run/plan_run.h"
#include "core/run/side_by_side.h"
#include "core/wear/garment_jobs.h"
#include "core/wear/wear_outcomes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

namespace hygroloom {
namespace {

constexpr std::size_t longest_reason = 300, most_named_failures = 1000;
constexpr const char* renamed = "The point renames what it is to run.";

WearOptions wear_options(Fidelity fidelity, const KnobSettings& knobs, const MemoryRule& memory)
{
    WearOptions how;
    how.fidelity = fidelity;
    how.knobs = knobs;
    how.memory = memory;
    return how;
}

/// Plans of each fabric on each experiment, as the project has them.
std::vector<ModelPlan> plans_of(const StudyFrame& frame, const Design& design, const Study& study, Fidelity fidelity)
{
    std::vector<ModelPlan> plans;
    if (is_of_garments(study, design)) return plans;
    for (const std::string& fabric : frame.fabrics())
        for (const std::string& experiment : frame.experiments()) try {
                plans.push_back(
                    plan_run(design, *find_fabric(design, fabric), *find_experiment(design, experiment), fidelity, {}, study.knobs));
            } catch (const Error&) {
                // Its rows will say it.
            }
    return plans;
}

/// One for the whole study, so that its rows differ by their factors alone.
FidelityChoice fidelity_of(const StudyFrame& frame, const Design& design, const Study& study)
{
    if (study.fidelity) return {*study.fidelity, ""};
    std::vector<ModelPlan> ladder;
    for (const Fidelity fidelity : all_fidelities) {
        const std::vector<ModelPlan> plans = plans_of(frame, design, study, fidelity);
        if (plans.empty()) return {};
        ladder.push_back(expected_of_all(plans));
    }
    FidelityTarget target;
    target.error = study.error;
    return choose_fidelity(ladder, target);
}

/// Where a member of a list of the whole design stands that is the part's number `index`.
template <typename Item> std::size_t place_in(const std::vector<Item>& whole, const std::vector<Item>& part, std::size_t index)
{
    const auto same = [&](const Item& item) { return item.name == part[index].name; };
    return static_cast<std::size_t>(std::find_if(whole.begin(), whole.end(), same) - whole.begin());
}

/// The first error of a design that is part of another one, where its places are those of that one.
std::string first_error(const Design& part, const Design& whole)
{
    for (const Issue& issue : validate(part)) {
        if (issue.severity != Severity::error) continue;
        const std::string list = issue.where.key(0);
        const std::size_t at = issue.where.number(0).value_or(0), samples = part.experiments.size();
        std::optional<std::size_t> place;
        if (issue.where.number(0) && list == "fabrics") place = place_in(whole.fabrics, part.fabrics, at);
        if (issue.where.number(0) && list == "garments") place = place_in(whole.garments, part.garments, at);
        if (issue.where.number(0) && list == "experiments") // garments follow the samples
            place = at < samples ? place_in(whole.experiments, part.experiments, at)
                                 : whole.experiments.size() + place_in(whole.wears, part.wears, at - samples);
        return (place ? issue.where.with(1, *place) : issue.where).text() + ": " + issue.text();
    }
    return {};
}

/// The garment of a row: of the experiment, cut from a fabric unless its name is empty.
GarmentCandidate garment_of(const Design& design, const std::string& experiment, const std::string& fabric)
{
    return fabric.empty() ? GarmentCandidate{fabric, design, experiment, {}} : cut_from(design, experiment, {}, fabric);
}

/// Others that begin a study in the folder wait for it, so that the folder never has the study of one and the rows of another. None where
/// the folder has a part: its study stays as it is from then on, and a thousand tasks need not wait for each other.
std::unique_ptr<ChangeLock> lock_of(const std::filesystem::path& folder)
{
    std::error_code none; // write_study_folder() says it
    std::filesystem::create_directories(folder, none);
    const auto has_part = [&] { return !std::filesystem::is_empty(folder / "parts", none) && !none; };
    if (has_part()) return nullptr;
    auto lock = std::make_unique<ChangeLock>(folder / "study.json");
    if (has_part()) lock.reset(); // of one that was faster
    return lock;
}

/// The runs of a study, side by side.
class StudyWork {
public:
    StudyWork(const StudyFolder& study, const std::filesystem::path& folder, const StudyOptions& options, RunControl& control,
              const StudyCallbacks& callbacks)
        : study_(study), options_(options), control_(control), callbacks_(callbacks), frame_(study.study, study.design),
          points_(study_points(study.study, study.design)), project_(json_from_design(study.design)),
          fidelity_(fidelity_of(frame_, study.design, study.study)), alone_(lock_of(folder)), kept_(prepared_rows(study, folder, options))
    {
        for (auto row = static_cast<std::size_t>(options.task - 1); row < frame_.rows(); row += static_cast<std::size_t>(options.tasks)) {
            ++outcome_.progress.rows;
            const bool failed = kept_.state(row) == KeptRows::State::failed;
            if (kept_.state(row) == KeptRows::State::missing || (failed && options.retry_failed)) {
                rows_.push_back(row);
                continue;
            }
            ++outcome_.progress.kept;
            if (failed) note_failure(row, kept_.word(row, 2));
        }
        outcome_.progress.ended = outcome_.progress.kept;
        write_study_folder(study, folder);
        journal_.emplace(folder / "parts" / fmt::format("{:06}-of-{:06}.csv", options.task, options.tasks),
                         mark_of(study.project_text, study.study_text));
        alone_.reset();
    }

    StudyOutcome run(const std::vector<std::unique_ptr<Backend>>& backends)
    {
        report();
        run_side_by_side(backends, rows_.size(), control_, [this](std::size_t i, Backend& backend) { return run_row(rows_[i], backend); });
        outcome_.cancelled = control_.cancel && outcome_.progress.ended < outcome_.progress.rows;
        report();
        return std::move(outcome_);
    }

private:
    using Clock = std::chrono::steady_clock;
    static double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

    void note_failure(std::size_t row, const std::string& reason)
    {
        ++outcome_.progress.failed;
        if (outcome_.failures.size() < most_named_failures) outcome_.failures.emplace_back(row, reason);
    }
    /// Whether the device failed.
    bool run_row(std::size_t row, Backend& backend)
    {
        StudyRowResult result;
        result.row = row;
        result.metrics.assign(frame_.metrics().size(), std::numeric_limits<double>::quiet_NaN());
        const auto start = Clock::now();
        bool device_failed = false;
        try {
            device_failed = run_point(frame_.row(row), row, backend, result);
        } catch (const Cancelled&) {
            throw;
        } catch (const std::bad_alloc&) {
            fail(result, "The memory does not suffice for this run.");
        } catch (const std::exception& error) {
            fail(result, error.what());
        }
        result.wall = since(start);
        if (result.device.empty()) result.device = backend.device();
        journal_->add(result);
        ended(result);
        return device_failed;
    }
    static void fail(StudyRowResult& result, const std::string& reason)
    {
        result.failed = true;
        result.reason = cut_text(reason, longest_reason);
        for (char& letter : result.reason)
            if (letter == '\n' || letter == '\r') letter = ' ';
    }
    bool run_point(const StudyRun& of, std::size_t row, Backend& backend, StudyRowResult& result)
    {
        const PointSetting setting = with_point(study_.study, project_, points_, of.point);
        return is_of_garments(study_.study, study_.design) ? run_garment_at(of, setting, row, backend, result)
                                                           : run_sample_at(of, setting, row, backend, result);
    }
    bool run_sample_at(const StudyRun& of, const PointSetting& setting, std::size_t row, Backend& backend, StudyRowResult& result)
    {
        const std::string &fabric = frame_.fabrics()[of.fabric], &experiment = frame_.experiments()[of.experiment];
        if (!find_fabric(setting.design, fabric) || !find_experiment(setting.design, experiment)) throw Error(renamed);
        const Design part = part_of_run(setting.design, fabric, experiment);
        const std::string error = first_error(part, setting.design);
        if (!error.empty()) throw Error(error);
        const Drawn drawing = drawn(part, fabric, experiment, {study_.study.seed, of.replicate, study_.study.replicates});
        RunOptions how;
        how.fidelity = fidelity_.fidelity;
        how.fidelity_reason = fidelity_.reason;
        how.knobs = setting.knobs;
        how.seed = drawing.seed;
        how.threads = options_.threads;
        how.may_go_on_on_cpu = true;
        how.memory = options_.memory;
        how.one_on_cpu = &one_on_cpu_;
        RunCallbacks beside;
        beside.progress = [&](const RunProgress& progress) { under_way(row, progress); };
        const FinishedRun finished = run_and_measure(drawing.design, fabric, experiment, how, backend, control_, beside);
        return take(outcomes_of(finished.run, finished.metrics), finished.run.device, finished.device_failure, result);
    }
    bool run_garment_at(const StudyRun& of, const PointSetting& setting, std::size_t row, Backend& backend, StudyRowResult& result)
    {
        const std::string &fabric = frame_.fabrics()[of.fabric], &experiment = frame_.experiments()[of.experiment];
        const WearExperiment* const wear = find_wear(setting.design, experiment);
        if (!wear || !find_garment(setting.design, wear->garment)) throw Error(renamed);
        const Design part = part_of_run(garment_of(setting.design, experiment, fabric).design, experiment);
        const std::string error = first_error(part, setting.design);
        if (!error.empty()) throw Error(error);
        const Drawn drawing = drawn(part, fabrics_of(part.garments.front()), {study_.study.seed, of.replicate, study_.study.replicates});
        GarmentRunOptions how;
        how.how = wear_options(fidelity_.fidelity, setting.knobs, options_.memory);
        how.threads = options_.threads;
        how.may_go_on_on_cpu = true;
        how.one_on_cpu = &one_on_cpu_;
        GarmentRunCallbacks beside;
        beside.progress = [&](const RunProgress& progress) { under_way(row, progress); };
        beside.frame = [&](const std::shared_ptr<const WearFrame>& frame, const WearMetrics& metrics) {
            if (frame->time == 0) require_parts(metrics); // now rather than at the end of the run
        };
        const GarmentParts parts = garment_parts(drawing.design, drawing.design.wears.front(), {});
        const FinishedGarment finished = run_garment(parts, how, backend, control_, beside);
        return take(outcomes_of(*finished.metrics), finished.record->device, finished.device_failure, result);
    }
    /// Which parts a garment has is known when its pattern has been read.
    void require_parts(const WearMetrics& metrics) const
    {
        const std::vector<Outcome> outcomes = outcomes_of(metrics);
        for (const std::string& metric : frame_.metrics())
            if (std::none_of(outcomes.begin(), outcomes.end(), [&](const Outcome& outcome) { return outcome.key == metric; }))
                throw Error(fmt::format("The garment has no part with the metric \"{}\".", metric));
    }
    /// Whether the device failed.
    bool take(const std::vector<Outcome>& outcomes, const std::string& device, const std::string& device_failure, StudyRowResult& result)
    {
        for (const Outcome& outcome : outcomes) {
            const auto found = std::find(frame_.metrics().begin(), frame_.metrics().end(), outcome.key);
            if (found != frame_.metrics().end() && outcome.value)
                result.metrics[static_cast<std::size_t>(found - frame_.metrics().begin())] = *outcome.value;
        }
        result.device = device;
        if (!device_failure.empty() && callbacks_.note) {
            const std::lock_guard lock(mutex_);
            callbacks_.note(device_failure);
        }
        return !device_failure.empty();
    }
    void under_way(std::size_t row, const RunProgress& progress)
    {
        const std::lock_guard lock(mutex_);
        shares_[row] = progress.duration > 0 ? std::min(progress.simulated / progress.duration, 1.0) : 0.0;
        report();
    }
    void ended(const StudyRowResult& result)
    {
        const std::lock_guard lock(mutex_);
        shares_.erase(result.row);
        ++outcome_.progress.ended;
        if (result.failed) note_failure(result.row, result.reason);
        if (callbacks_.ended) callbacks_.ended(result);
        report();
    }
    void report()
    {
        StudyProgress& progress = outcome_.progress;
        progress.wall = since(start_);
        double done = static_cast<double>(progress.ended - progress.kept);
        for (const auto& [row, share] : shares_) done += share;
        progress.share = rows_.empty() ? 1.0 : done / static_cast<double>(rows_.size());
        const bool last = progress.ended == progress.rows;
        if (!callbacks_.progress || (!last && since(reported_) < 0.09)) return;
        reported_ = Clock::now();
        callbacks_.progress(progress);
    }

    const StudyFolder& study_;
    const StudyOptions& options_;
    RunControl& control_;
    const StudyCallbacks& callbacks_;
    const StudyFrame frame_;
    const StudyPoints points_;
    const ProjectJson project_;
    const FidelityChoice fidelity_;
    std::unique_ptr<ChangeLock> alone_; ///< until the folder has the study and a part of it
    const KeptRows kept_;
    std::optional<Journal> journal_;
    std::vector<std::size_t> rows_; ///< to run
    std::mutex mutex_, one_on_cpu_;
    std::map<std::size_t, double> shares_; ///< of rows under way
    StudyOutcome outcome_;
    Clock::time_point start_ = Clock::now(), reported_{};
};

} // namespace

StudyNeeds study_needs(const Design& design, const Study& study, const std::filesystem::path& folder, const StudyOptions& options)
{
    const StudyFolder all = folder_of(design, study);
    const StudyFrame frame(study, design);
    const KeptRows kept = prepared_rows(all, folder, options);
    StudyNeeds needs;
    for (auto row = static_cast<std::size_t>(options.task - 1); row < frame.rows(); row += static_cast<std::size_t>(options.tasks))
        needs.rows += kept.state(row) == KeptRows::State::missing || (options.retry_failed && kept.state(row) == KeptRows::State::failed);
    double most = 0;
    for (const ModelPlan& plan : plans_of(frame, design, study, fidelity_of(frame, design, study).fidelity))
        most = std::max(most, plan.expected_bytes);
    needs.bytes_each = static_cast<std::size_t>(most);
    if (!is_of_garments(study, design)) return needs;
    std::vector<GarmentCandidate> garments;
    for (const std::string& fabric : frame.fabrics())
        for (const std::string& experiment : frame.experiments()) garments.push_back(garment_of(design, experiment, fabric));
    needs.bytes_each = bytes_of_largest(garments, wear_options(*study.fidelity, study.knobs, options.memory));
    return needs;
}

StudyShares shares_on_cpu(int jobs, int threads, int cores, const StudyNeeds& needs)
{
    const int wanted = jobs > 0 ? jobs : static_cast<int>(std::min(needs.rows, static_cast<std::size_t>(cores)));
    StudyShares shares;
    shares.jobs = jobs_that_fit(wanted, static_cast<double>(needs.bytes_each));
    shares.threads = threads > 0 ? threads : std::max(1, cores / shares.jobs);
    return shares;
}

StudyOutcome run_study(const Design& design, const Study& study, const std::filesystem::path& folder, const StudyOptions& options,
                       const std::vector<std::unique_ptr<Backend>>& backends, RunControl& control, const StudyCallbacks& callbacks)
{
    const StudyFolder all = folder_of(design, study);
    return StudyWork(all, folder, options, control, callbacks).run(backends);
}

} // namespace hygroloom
