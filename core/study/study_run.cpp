// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/study/study_run.h"

#include "core/analysis/card.h"
#include "core/analysis/replicate_file.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/design/unknowns.h"
#include "core/design/validate.h"
#include "core/plan/expectation.h"
#include "core/project/atomic_file.h"
#include "core/project/project_json.h"
#include "core/run/plan_run.h"
#include "core/wear/wear_outcomes.h"
#include "core/wear/worn_candidate.h"

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
    StudyWork(const StudyFolder& study, const std::filesystem::path& folder, const StudyOptions& options, const StudyCallbacks& callbacks)
        : study_(study), options_(options), callbacks_(callbacks), frame_(study.study, study.design),
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

    StudyOutcome run(RunQueue& queue, const std::shared_ptr<RunPlaces>& places, const std::atomic<bool>& cancel)
    {
        report();
        RunBatch batch;
        batch.name = options_.name;
        batch.count = rows_.size();
        batch.places = places;
        batch.job = [this](std::size_t i) { return job_of(rows_[i]); };
        batch.ended = [this](std::size_t i, RunResult& result) { take(rows_[i], result); };
        batch.paused = callbacks_.paused;
        queue.run(std::move(batch), cancel);
        outcome_.cancelled = outcome_.progress.ended < outcome_.progress.rows;
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
    /// Throws Error where the row's point makes no run.
    RunJob job_of(std::size_t row)
    {
        const StudyRun of = frame_.row(row);
        const PointSetting setting = with_point(study_.study, project_, points_, of.point);
        const std::string &fabric = frame_.fabrics()[of.fabric], &experiment = frame_.experiments()[of.experiment];
        const bool worn = is_of_garments(study_.study, study_.design);
        const Design part = worn ? part_of_garment(setting.design, experiment, fabric) : part_of_sample(setting.design, fabric, experiment);
        const std::string error = first_error(part, setting.design);
        if (!error.empty()) throw Error(error);
        RunJob job{std::make_shared<const Design>(part), experiment, worn ? std::string() : fabric};
        job.replicate = of.replicate;
        job.replicates = study_.study.replicates;
        job.how.fidelity = fidelity_.fidelity;
        job.how.fidelity_reason = fidelity_.reason;
        job.how.knobs = setting.knobs;
        job.how.seed = study_.study.seed;
        job.how.threads = options_.threads;
        job.how.may_go_on_on_cpu = true;
        job.how.memory = options_.memory;
        job.beside.progress = [this, row](const RunProgress& progress) { under_way(row, progress); };
        job.worn.frame = [this](const std::shared_ptr<const WearFrame>& frame, const WearMetrics& metrics) {
            if (frame->time == 0) require_parts(metrics); // now rather than at the end of the run
        };
        return job;
    }
    static Design part_of_sample(const Design& design, const std::string& fabric, const std::string& experiment)
    {
        if (!find_fabric(design, fabric) || !find_experiment(design, experiment)) throw Error(renamed);
        return part_of_run(design, fabric, experiment);
    }
    static Design part_of_garment(const Design& design, const std::string& experiment, const std::string& fabric)
    {
        const WearExperiment* const wear = find_wear(design, experiment);
        if (!wear || !find_garment(design, wear->garment)) throw Error(renamed);
        return part_of_run(cut_from(design, experiment, fabric), experiment);
    }
    static void fail(StudyRowResult& result, const std::string& reason)
    {
        result.failed = true;
        result.reason = cut_text(reason, longest_reason);
        for (char& letter : result.reason)
            if (letter == '\n' || letter == '\r') letter = ' ';
    }
    /// Which parts a garment has is known when its pattern has been read.
    void require_parts(const WearMetrics& metrics) const
    {
        const std::vector<Outcome> outcomes = outcomes_of(metrics);
        for (const std::string& metric : frame_.metrics())
            if (std::none_of(outcomes.begin(), outcomes.end(), [&](const Outcome& outcome) { return outcome.key == metric; }))
                throw Error(fmt::format("The garment has no part with the metric \"{}\".", metric));
    }
    /// Of a run that was stopped there is no row.
    void take(std::size_t row, const RunResult& run)
    {
        const std::string failure = run.failure();
        if (!run.ended() && failure.empty()) return;
        StudyRowResult result;
        result.row = row;
        result.wall = run.wall;
        result.device = run.device;
        result.metrics.assign(frame_.metrics().size(), std::numeric_limits<double>::quiet_NaN());
        if (!failure.empty()) fail(result, failure);
        if (run.sample) take(outcomes_of(run.sample->run, run.sample->metrics), result);
        if (run.sample) take_card(run.sample->run, result);
        if (run.garment) take(outcomes_of(*run.garment->metrics), result);
        journal_->add(result);
        if (run.ended() && !run.device_failure().empty() && callbacks_.note) {
            const std::lock_guard lock(mutex_);
            callbacks_.note(run.device_failure());
        }
        ended(result);
    }
    void take(const std::vector<Outcome>& outcomes, StudyRowResult& result) const
    {
        for (const Outcome& outcome : outcomes)
            if (outcome.value) set(result, outcome.key, *outcome.value);
    }
    /// Numbers of the cloth's technical card, where the study lists some.
    void take_card(const RunRecord& run, StudyRowResult& result) const
    {
        const auto is_of_card = [](const std::string& key) {
            return std::any_of(card_metrics().begin(), card_metrics().end(), [&](const OutcomeInfo& info) { return info.key == key; });
        };
        if (std::none_of(frame_.metrics().begin(), frame_.metrics().end(), is_of_card)) return;
        const Fabric* fabric = find_fabric(run.design, run.fabric);
        const Validation fitted = validate_and_fit(run.design);
        const auto& own = fitted.fabrics[static_cast<std::size_t>(fabric - run.design.fabrics.data())];
        try {
            for (const LaboratoryNumber& number : compared_numbers(run.design, *fabric, *own).found)
                set(result, number.key, number.estimate.value);
        } catch (const Error&) { // its card says why
        }
    }
    void set(StudyRowResult& result, const std::string& key, double value) const
    {
        const auto found = std::find(frame_.metrics().begin(), frame_.metrics().end(), key);
        if (found != frame_.metrics().end()) result.metrics[static_cast<std::size_t>(found - frame_.metrics().begin())] = value;
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
    const StudyCallbacks& callbacks_;
    const StudyFrame frame_;
    const StudyPoints points_;
    const ProjectJson project_;
    const FidelityChoice fidelity_;
    std::unique_ptr<ChangeLock> alone_; ///< until the folder has the study and a part of it
    const KeptRows kept_;
    std::optional<Journal> journal_;
    std::vector<std::size_t> rows_; ///< to run
    std::mutex mutex_;
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
    RunOptions how;
    how.fidelity = *study.fidelity;
    how.knobs = study.knobs;
    how.memory = options.memory;
    for (const std::string& fabric : frame.fabrics())
        for (const std::string& experiment : frame.experiments())
            most = std::max(most, plan_worn(cut_from(design, experiment, fabric), experiment, {}, how, "cpu").bytes);
    needs.bytes_each = static_cast<std::size_t>(most);
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
                       RunQueue& queue, const std::shared_ptr<RunPlaces>& places, const std::atomic<bool>& cancel,
                       const StudyCallbacks& callbacks)
{
    const StudyFolder all = folder_of(design, study);
    return StudyWork(all, folder, options, callbacks).run(queue, places, cancel);
}

} // namespace hygroloom
