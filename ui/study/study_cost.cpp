// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/study_cost.h"

#include "core/base/error.h"
#include "core/plan/expectation.h"
#include "core/run/plan_run.h"
#include "core/study/points.h"
#include "core/wear/worn_candidate.h"
#include "gpu/backends.h"
#include "ui/basics/preferences.h"
#include "ui/basics/quantity.h"
#include "ui/results/device_choice.h"
#include "ui/results/plan_dialog.h"

#include <QCoreApplication>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int runs_on_gpu = 16;
constexpr double gain_on_gpu = 3; // of that many drops side by side, against one after the other

/// What a run is expected to take.
struct RunCost {
    double seconds = 0, bytes = 0;
};

/// Of each fabric on each experiment; those that cannot be planned fail when they are run.
std::vector<ModelPlan> plansOf(const Design& design, const Study& study, Fidelity fidelity, const std::string& backend,
                               const std::function<bool()>& outdated)
{
    std::vector<ModelPlan> plans;
    for (const std::string& fabric : fabrics_of(study, design)) {
        for (const std::string& experiment : experiments_of(study, design)) {
            if (outdated()) { return {}; }
            try {
                plans.push_back(plan_run(design, *find_fabric(design, fabric), *find_experiment(design, experiment), fidelity, {},
                                         study.knobs, backend));
            } catch (const Error&) {
            }
        }
    }
    return plans;
}

/// The same of garments.
std::vector<RunCost> costsOfGarments(const Design& design, const Study& study, const std::string& backend,
                                     const std::function<bool()>& outdated)
{
    RunOptions how;
    how.fidelity = *study.fidelity;
    how.knobs = study.knobs;
    std::vector<RunCost> costs;
    for (const std::string& fabric : fabrics_of(study, design)) {
        for (const std::string& experiment : experiments_of(study, design)) {
            if (outdated()) { return {}; }
            try {
                const WearPlan plan = plan_worn(cut_from(design, experiment, fabric), experiment, {}, how, backend);
                costs.push_back({plan.time.seconds, plan.bytes});
            } catch (const Error&) {
            }
        }
    }
    return costs;
}

std::vector<RunCost> costsOfSamples(const Design& design, const Study& study, const std::string& backend,
                                    const std::function<bool()>& outdated)
{
    std::vector<ModelPlan> plans;
    if (study.fidelity) {
        plans = plansOf(design, study, *study.fidelity, backend, outdated);
    } else {
        FidelityTarget target;
        target.error = study.error;
        std::vector<std::vector<ModelPlan>> all;
        std::vector<ModelPlan> ladder;
        for (const Fidelity fidelity : all_fidelities) {
            all.push_back(plansOf(design, study, fidelity, backend, outdated));
            if (all.back().empty()) { break; }
            ladder.push_back(expected_of_all(all.back()));
        }
        if (ladder.size() == all_fidelities.size()) { plans = all[static_cast<std::size_t>(choose_fidelity(ladder, target).fidelity)]; }
    }
    std::vector<RunCost> costs;
    for (const ModelPlan& plan : plans) { costs.push_back({plan.expected_seconds, plan.expected_bytes}); }
    return costs;
}

} // namespace

StudyShares sharesOf(const Study& study, std::size_t runs, double bytes_each)
{
    const std::string backend = expected_backend(backend_for(backendOfMany(), study.knobs));
    if (backend != "cpu") { return {0, 1}; }
    const int all = usable_threads(), own = preferences().threads;
    const int cores = own > 0 ? std::min(own, all) : all;
    return shares_on_cpu(0, 0, cores, {runs, static_cast<std::size_t>(bytes_each)});
}

StudyCost foretellCost(const Design& design, const Study& study, const std::function<bool()>& outdated)
{
    StudyCost cost;
    cost.points = count_points(study);
    const std::size_t pairs = fabrics_of(study, design).size() * experiments_of(study, design).size();
    cost.runs = cost.points * pairs * static_cast<std::size_t>(study.replicates);
    const std::string backend = expected_backend(backend_for(backendOfMany(), study.knobs));
    const std::vector<RunCost> costs = is_of_garments(study, design) ? costsOfGarments(design, study, backend, outdated)
                                                                     : costsOfSamples(design, study, backend, outdated);
    if (costs.empty()) {
        cost.missing = QCoreApplication::translate("hygroloom", "no run can be planned");
        return cost;
    }
    for (const RunCost& each : costs) {
        cost.seconds += each.seconds;
        cost.bytes_each = std::max(cost.bytes_each, each.bytes);
    }
    cost.seconds *= static_cast<double>(cost.runs) / static_cast<double>(costs.size());
    const StudyShares shares = sharesOf(study, cost.runs, cost.bytes_each);
    cost.at_once =
        static_cast<int>(std::min<std::size_t>(cost.runs, static_cast<std::size_t>(shares.jobs > 0 ? shares.jobs : runs_on_gpu)));
    if (backend != "cpu") { cost.seconds /= std::clamp(gain_on_gpu * cost.at_once / runs_on_gpu, 1.0, gain_on_gpu); }
    return cost;
}

QString costText(const StudyCost& cost)
{
    const auto tr = [](const char* text) { return QCoreApplication::translate("hygroloom", text); };
    const QString runs = cost.runs == 1 ? tr("1 run") : tr("%1 runs").arg(cost.runs);
    const QString points = cost.points == 1 ? tr("1 point") : tr("%1 points").arg(cost.points);
    if (!cost.missing.isEmpty()) { return tr("%1 (%2); time not known: %3.").arg(runs, points, cost.missing); }
    return tr("%1 (%2), %3, %4 at a time with %5 each.")
        .arg(runs, points, roughDuration(cost.seconds))
        .arg(cost.at_once)
        .arg(bytesText(cost.bytes_each));
}

} // namespace hygroloom
