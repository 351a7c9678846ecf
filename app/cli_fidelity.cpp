// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/cli_fidelity.h"

#include "core/plan/frame_times.h"
#include "core/run/plan_run.h"
#include "gpu/backends.h"

#include <fmt/format.h>

#include <array>
#include <optional>

namespace hygroloom {
namespace {

/// What --fidelity auto must keep; none for a named fidelity. Throws Stop when the options do not go together.
std::optional<FidelityTarget> target_of(const FidelityOptions& options)
{
    const bool error = !options.error.empty(), time = !options.time.empty();
    if (options.fidelity != "auto") {
        if (error || time) throw Stop(exit_usage, "--error and --time work with --fidelity auto.");
        return std::nullopt;
    }
    if (error == time) throw Stop(exit_usage, "--fidelity auto needs either --error (e.g. 5%) or --time (e.g. 10s).");
    FidelityTarget target;
    if (error) target.error = as_usage([&] { return parse_error_target(options.error); });
    if (time) target.seconds = as_usage([&] { return parse_time_target(options.time); });
    return target;
}

Fidelity named(const std::string& name)
try {
    return fidelity_from_name(name);
} catch (const Error&) {
    throw Stop(exit_usage, fmt::format("--fidelity: This must be live, draft, standard, reference or auto; given is \"{}\".", name));
}

} // namespace

void add_fidelity_options(CLI::App& verb, FidelityOptions& options, const std::string& whose)
{
    verb.add_option("--fidelity", options.fidelity, "How finely to compute; auto: chosen by --error or --time")
        ->type_name("{live,draft,standard,reference,auto}");
    verb.add_option("--error", options.error,
                    "With --fidelity auto: the fastest fidelity whose numbers (but time_of_arrest_s) err by less, e.g. 5%" + whose);
    verb.add_option("--time", options.time, "With --fidelity auto: the finest fidelity within this time, e.g. 10s or 2min" + whose);
}

void check_fidelity(const FidelityOptions& options)
{
    if (!target_of(options)) named(options.fidelity);
}

ModelPlan planned(const FidelityOptions& options, const Design& design, const Textile& textile, Fidelity fidelity,
                  const ForcedParts& forced, const KnobSettings& knobs)
{
    const std::string backend = as_usage([&] { return expected_backend(backend_for(options.backend, knobs)); });
    return plan_run(design, textile, chosen_experiment(design, options), fidelity, forced, knobs, backend);
}

FidelityChoice chosen_fidelity(const FidelityOptions& options, const Design& design, const std::vector<Textile>& textiles,
                               const ForcedParts& forced, const KnobSettings& knobs)
{
    const std::optional<FidelityTarget> target = target_of(options);
    if (!target) return {named(options.fidelity), ""};
    std::array<std::vector<ModelPlan>, std::size(all_fidelities)> plans;
    for (const Textile& textile : textiles) {
        try {
            std::vector<ModelPlan> own;
            own.reserve(plans.size());
            for (Fidelity fidelity : all_fidelities) {
                own.push_back(planned(options, design, textile, fidelity, forced, knobs));
                own.back().expected_seconds = seconds_to_wait(own.back(), options.recorded);
            }
            for (std::size_t k = 0; k < own.size(); ++k) plans[k].push_back(std::move(own[k]));
        } catch (const Stop&) {
            throw;
        } catch (const Error&) { // its own run will report it
            if (textiles.size() == 1) throw;
        }
    }
    if (plans[0].empty()) return {};
    std::vector<ModelPlan> ladder;
    ladder.reserve(plans.size());
    for (const std::vector<ModelPlan>& all : plans) ladder.push_back(expected_of_all(all));
    return choose_fidelity(ladder, *target);
}

std::string fidelity_text(const FidelityChoice& choice)
{
    return choice.reason.empty() ? "" : fmt::format("  fidelity {}: {}\n", name_of(choice.fidelity), choice.reason);
}

} // namespace hygroloom
