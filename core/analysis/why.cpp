// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/why.h"

#include "core/base/error.h"
#include "core/design/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace hygroloom {
namespace {

Mixture bit(std::size_t part) { return Mixture{1} << part; }
Mixture all_parts(std::size_t count) { return bit(count) - 1; }

/// Why a mixture is no fabric, in a sentence; empty: it is one.
std::string fault_of(const Design& design, const WhyPlan& plan, Mixture mixture)
{
    const std::vector<Issue> issues = validate(mixed(design, plan, mixture));
    const Issue* error = first_error(issues);
    return error ? error->text() : std::string();
}

void choose_mixtures(WhyPlan& plan)
{
    const std::size_t count = plan.parts.size();
    plan.all_orders = count <= most_parts_in_all_orders;
    plan.mixtures.clear();
    const Mixture all = all_parts(count);
    if (plan.all_orders)
        for (Mixture m = 1; m < all; ++m) plan.mixtures.push_back(m);
    else
        for (std::size_t i = 0; i < count; ++i) plan.mixtures.insert(plan.mixtures.end(), {bit(i), all ^ bit(i)});
}

std::string titles_of(const WhyPlan& plan, Mixture mixture)
{
    std::string text;
    for (std::size_t i = 0; i < plan.parts.size(); ++i)
        if (mixture & bit(i)) text += (text.empty() ? "" : ", ") + plan.parts[i].title;
    return text;
}

void join(WhyPlan& plan, std::size_t one, std::size_t other)
{
    Exchange &kept = plan.parts[std::min(one, other)], &added = plan.parts[std::max(one, other)];
    const auto named = [](const Exchange& each, const std::string& text) { return each.several ? text : each.title + " " + text; };
    kept.first = named(kept, kept.first) + ", " + named(added, added.first);
    kept.second = named(kept, kept.second) + ", " + named(added, added.second);
    kept.title += " and " + added.title;
    kept.fields.insert(kept.fields.end(), added.fields.begin(), added.fields.end());
    kept.several = true;
    plan.parts.erase(plan.parts.begin() + static_cast<std::ptrdiff_t>(std::max(one, other)));
}

/// Joins a part of the mixture with one that is missing in it, which it needs.
void heal(const Design& design, WhyPlan& plan, Mixture mixture, const std::string& fault)
{
    std::optional<std::size_t> in, out; // the first without, or with which it is sound; else the first
    bool heals = false;
    for (const bool must_heal : {true, false}) {
        for (std::size_t i = 0; i < plan.parts.size(); ++i) {
            auto& place = mixture & bit(i) ? in : out;
            if (!place && (!must_heal || fault_of(design, plan, mixture ^ bit(i)).empty())) place = i;
        }
        if (must_heal) heals = in && out;
    }
    if (heals)
        plan.notes.push_back(fmt::format("{} and {} are exchanged together: {} with {} of {} alone is refused ({})", plan.parts[*in].title,
                                         plan.parts[*out].title, plan.fabric, titles_of(plan, mixture), plan.against, fault));
    else
        plan.notes.push_back(fmt::format("{} with {} of {} alone is refused ({}), and no other single part makes it sound: more parts are "
                                         "exchanged together than may be needed",
                                         plan.fabric, titles_of(plan, mixture), plan.against, fault));
    join(plan, *in, *out);
}

/// Each exchange that a part's contribution consists of: step(weight, before, after).
void for_each_step(std::size_t parts, bool all_orders, std::size_t part, const std::function<void(double, Mixture, Mixture)>& step)
{
    const Mixture all = all_parts(parts), own = bit(part);
    if (!all_orders) {
        step(0.5, 0, own);
        step(0.5, all ^ own, all);
        return;
    }
    const auto factorial = [](std::size_t n) { return std::tgamma(static_cast<double>(n) + 1); };
    for (Mixture others = 0; others <= all; ++others) {
        if (others & own) continue;
        const auto count = static_cast<std::size_t>(std::popcount(others));
        step(std::round(factorial(count) * factorial(parts - count - 1)) / factorial(parts), others, others | own);
    }
}

/// The runs of the two fabrics and of their mixtures.
struct Runs {
    std::map<Mixture, const Candidate*> of;
    std::string key;

    const double* number(Mixture mixture, std::size_t replicate) const
    {
        const auto& replicates = of.at(mixture)->replicates;
        if (replicate >= replicates.size() || !replicates[replicate]) return nullptr;
        const auto found = replicates[replicate]->numbers.find(key);
        return found == replicates[replicate]->numbers.end() ? nullptr : &found->second;
    }
    /// Replicates in which all have the number.
    std::vector<std::size_t> complete(int replicates) const
    {
        std::vector<std::size_t> found;
        for (std::size_t r = 0; r < static_cast<std::size_t>(replicates); ++r)
            if (std::all_of(of.begin(), of.end(), [&](const auto& each) { return number(each.first, r) != nullptr; })) found.push_back(r);
        return found;
    }
    double numerical(Mixture mixture, double otherwise) const
    {
        const auto& known = of.at(mixture)->numerical;
        const auto found = known.find(key);
        return found == known.end() ? otherwise : found->second;
    }
    /// Of all unknown inputs of all, by name.
    std::vector<double> places(std::size_t replicate) const
    {
        std::map<std::string, double> by_name;
        for (const auto& [mixture, candidate] : of)
            for (std::size_t i = 0; i < candidate->unknowns.size() && i < candidate->replicates[replicate]->places.size(); ++i)
                by_name.emplace(candidate->unknowns[i], candidate->replicates[replicate]->places[i]);
        std::vector<double> places;
        places.reserve(by_name.size());
        for (const auto& [name, place] : by_name) places.push_back(place);
        return places;
    }
};

Compared compared_with_nothing(const std::vector<double>& values, const std::vector<std::vector<double>>& places, double numerical,
                               const Why& why)
{
    Compared found = compare_pairs(values, std::vector<double>(values.size(), 0.0), places, numerical, why.metric.better);
    found.metric = why.metric.key;
    found.fabric = why.fabric;
    found.baseline = why.against;
    return found;
}

/// Of one exchange, in those replicates; none: it shows nothing.
std::optional<Compared> shown_step(const Runs& runs, const std::vector<std::size_t>& replicates,
                                   const std::vector<std::vector<double>>& places, double numerical_otherwise, Mixture before,
                                   Mixture after, const Why& why)
{
    std::vector<double> differences;
    differences.reserve(replicates.size());
    for (const std::size_t r : replicates) differences.push_back(*runs.number(before, r) - *runs.number(after, r));
    const double numerical = std::max(runs.numerical(before, numerical_otherwise), runs.numerical(after, numerical_otherwise));
    Compared found = compared_with_nothing(differences, places, numerical, why);
    return found.verdict == Verdict::no_difference ? std::nullopt : std::optional(std::move(found));
}

/// Which mixtures lack the number, and why nothing can be said.
std::string missing_text(const WhyPlan& plan, const Why& why, const Runs& runs)
{
    for (const auto& [mixture, candidate] : runs.of) {
        const bool none = !runs.number(mixture, 0);
        if (!none) continue;
        const std::string reason = candidate->failure.empty() ? "" : " (" + candidate->failure + ")";
        return fmt::format("The parts cannot be told apart: {} with {} of {} has no {}{}.", plan.fabric, titles_of(plan, mixture),
                           plan.against, full_title(why.metric), reason);
    }
    return fmt::format("The parts cannot be told apart: too few replicates have the {} in all mixtures.", full_title(why.metric));
}

/// Inputs in the reader's units.
NumberText in_units(const ReaderUnits& units)
{
    if (!units) return {};
    return [units](double number, const std::string& unit) {
        const std::size_t per = unit.find("/cm"), begin = per == std::string::npos ? unit.find_first_not_of(' ') : per; // of " ends/cm"
        const std::string own = begin == std::string::npos ? unit : unit.substr(begin);
        const ReaderUnit read = units(own);
        const bool same = read.unit == own;
        return fmt::format("{:.4g}{}{}", same ? number : read.of(number), unit.substr(0, unit.size() - own.size()), same ? own : read.unit);
    };
}

} // namespace

WhyPlan plan_why(const Design& design, const std::string& fabric, const std::string& against, const std::string& experiment,
                 bool replicates, const ReaderUnits& units)
{
    WhyPlan plan{fabric, against, experiment, {}, true, {}, {}};
    for (PartDifference& each :
         part_differences(design, *find_fabric(design, fabric), *find_fabric(design, against), replicates, in_units(units)))
        plan.parts.push_back({each.title, each.first, each.second, each.fields, false});
    for (bool sound = false; !sound;) {
        choose_mixtures(plan);
        sound = true;
        for (const Mixture mixture : plan.mixtures)
            if (const std::string fault = fault_of(design, plan, mixture); !fault.empty()) {
                heal(design, plan, mixture, fault);
                sound = false;
                break;
            }
    }
    return plan;
}

Design mixed(const Design& design, const WhyPlan& plan, Mixture mixture)
{
    Design own{design.materials, design.liquids, {*find_fabric(design, plan.fabric)}, {*find_experiment(design, plan.experiment)}, {}, {}};
    const Fabric& other = *find_fabric(design, plan.against);
    for (std::size_t i = 0; i < plan.parts.size(); ++i)
        if (mixture & bit(i))
            for (const PartField* field : plan.parts[i].fields) field->copy(own.fabrics.front(), other);
    return own;
}

std::vector<double> contributions_of(std::size_t parts, bool all_orders, const std::function<double(Mixture)>& value)
{
    std::vector<double> found(parts, 0.0);
    for (std::size_t part = 0; part < parts; ++part)
        for_each_step(parts, all_orders, part,
                      [&](double weight, Mixture before, Mixture after) { found[part] += weight * (value(before) - value(after)); });
    return found;
}

Why why_of(const WhyPlan& plan, const OutcomeInfo& metric, const Candidate& fabric, const Candidate& against, int replicates)
{
    Why why;
    why.fabric = plan.fabric;
    why.against = plan.against;
    why.metric = metric;
    why.replicates = replicates;
    why.all_orders = plan.all_orders;
    why.fabrics = 2 + static_cast<int>(plan.mixtures.size());
    why.notes = plan.notes;
    why.whole = compared(fabric, against, metric, replicates);
    if (const auto lone = lone_number(fabric, against, metric, replicates))
        why.nothing = lone->sentence + " What only one of them has cannot be shared out among parts.";
    else if (!why.whole)
        why.nothing =
            fmt::format("Whether {} and {} differ in {} is not known: one of them has no such number, or its numerical error is not "
                        "known and there is one replicate.",
                        plan.fabric, plan.against, full_title(metric));
    else if (plan.parts.empty())
        why.nothing = "No difference: all inputs that act are the same in both fabrics.";
    else if (why.whole->verdict == Verdict::no_difference) {
        why.not_shown = true;
        why.nothing = nothing_of(why);
    }
    if (!why.nothing.empty()) why.fabrics = 2;
    return why;
}

Why explain(const WhyPlan& plan, const OutcomeInfo& metric, const Candidate& fabric, const Candidate& against,
            const std::map<Mixture, Candidate>& mixtures, int replicates)
{
    Why why = why_of(plan, metric, fabric, against, replicates);
    if (!why.nothing.empty()) return why;
    const std::size_t parts = plan.parts.size();
    Runs runs{{{0, &fabric}, {all_parts(parts), &against}}, metric.key};
    for (const Mixture mixture : plan.mixtures) runs.of[mixture] = &mixtures.at(mixture);
    const std::vector<std::size_t> complete = runs.complete(replicates);
    if (complete.empty() || 2 * static_cast<int>(complete.size()) < replicates) {
        why.nothing = missing_text(plan, why, runs);
        return why;
    }
    const double ends = std::max(runs.numerical(0, 0), runs.numerical(all_parts(parts), 0));
    std::vector<std::vector<double>> places, values(parts + 2); // of each part, of what is left, of the whole
    for (const std::size_t r : complete) {
        places.push_back(runs.places(r));
        const auto number = [&](Mixture mixture) { return *runs.number(mixture, r); };
        const std::vector<double> own = contributions_of(parts, plan.all_orders, number);
        for (std::size_t i = 0; i < parts; ++i) values[i].push_back(own[i]);
        const double whole = number(0) - number(all_parts(parts));
        values[parts].push_back(whole - std::accumulate(own.begin(), own.end(), 0.0));
        values[parts + 1].push_back(whole);
    }
    if (complete.size() < static_cast<std::size_t>(replicates)) {
        why.whole = compared_with_nothing(values[parts + 1], places, ends, why);
        why.notes.push_back(
            fmt::format("{} of {} replicates count: in the others a mixture has no such number.", complete.size(), replicates));
        if (why.whole->verdict == Verdict::no_difference) {
            why.nothing = "In these replicates there is no difference that this simulation can show: there is nothing to explain.";
            return why;
        }
    }
    const auto alone = [&](Mixture before, Mixture after) { return shown_step(runs, complete, places, ends, before, after, why); };
    const Mixture all = all_parts(parts);
    double squares = ends * ends;
    for (std::size_t i = 0; i < parts; ++i) {
        double numerical = 0;
        for_each_step(parts, plan.all_orders, i, [&](double weight, Mixture before, Mixture after) {
            numerical += weight * std::max(runs.numerical(before, ends), runs.numerical(after, ends));
        });
        squares += numerical * numerical;
        const Exchange& part = plan.parts[i];
        Contribution made{part.title,       part.first,
                          part.second,      {},
                          part.several,     compared_with_nothing(values[i], places, numerical, why),
                          alone(0, bit(i)), alone(all ^ bit(i), all)};
        for (const PartField* field : part.fields) made.keys.emplace_back(field->key);
        why.parts.push_back(std::move(made));
    }
    if (!plan.all_orders) why.together = compared_with_nothing(values[parts], places, std::sqrt(squares), why);
    return why;
}

} // namespace hygroloom
