// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whether a study and a project go together.
#include "core/analysis/card.h"
#include "core/base/error.h"
#include "core/base/words.h"
#include "core/design/issue_list.h"
#include "core/project/project_json.h"
#include "core/project/project_value.h"
#include "core/study/points.h"
#include "core/study/quantiles.h"
#include "core/wear/wear_outcomes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace hygroloom {
namespace {

class Check {
public:
    Check(const Study& study, const Design& design) : study_(study), design_(design) {}

    std::vector<Issue> issues()
    {
        check_names("experiments", say("experiment"), study_.experiments, names_of(design_.experiments, design_.wears));
        const bool worn = issues_.empty() && is_of_garments(study_, design_);
        if (!worn || !study_.fabrics.empty()) check_names("fabrics", say("fabric"), study_.fabrics, names_in(design_.fabrics));
        if (issues_.empty()) check_kind(worn);
        const bool named = issues_.empty();
        if (named) check_metrics();
        for (std::size_t k = 0; k < study_.factors.size(); ++k) check_factor(k, named);
        if (issues_.empty()) check_places();
        if (issues_.empty()) check_size();
        return std::move(issues_);
    }

private:
    void add(Place where, Message message) { issues_.push_back({Severity::error, "study", std::move(where), std::move(message)}); }

    static std::vector<std::string> names_of(const std::vector<Experiment>& samples, const std::vector<WearExperiment>& wears)
    {
        std::vector<std::string> names = names_in(samples);
        for (const std::string& name : names_in(wears)) names.push_back(name);
        return names;
    }
    void check_names(const Place& key, const Message& what, const std::vector<std::string>& names, const std::vector<std::string>& known)
    {
        const std::string all = listed_in_quotes(known);
        if (names.empty() && known.size() == 1) return;
        if (known.empty()) return add(key, say("The project has no {} that a study can run.", what));
        if (names.empty()) return add(key, say("The project has several {}s; list those to run: {}.", what, all));
        for (std::size_t i = 0; i < names.size(); ++i)
            if (std::find(known.begin(), known.end(), names[i]) == known.end())
                add(key / i, say("The project has no {} \"{}\"{} It has {}.", what, names[i], or_near(names[i], known), all));
    }
    /// A sample and a garment have no number in common.
    void check_kind(bool worn)
    {
        for (const std::string& name : experiments_of(study_, design_))
            if ((find_wear(design_, name) != nullptr) != worn)
                return add("experiments",
                           say("A study runs samples of fabric or garments (type wear), not both; list experiments of one kind."));
        if (worn && !study_.fidelity) add("fidelity", say("The error of garments is not known; name a fidelity."));
    }
    /// "water_g", or of a part "panels/front/water_g".
    static bool is_number_of_garment(const std::string& key)
    {
        const std::size_t first = key.find('/'), last = key.rfind('/');
        const bool of_whole = first == std::string::npos;
        const std::string kind = of_whole ? "" : key.substr(0, first), number = of_whole ? key : key.substr(last + 1);
        if (!of_whole && (last < first + 2 || (kind != "panels" && kind != "zones"))) return false;
        const auto& all = wear_numbers();
        const auto found = std::find_if(all.begin(), all.end(), [&](const WearNumber& each) { return each.info.key == number; });
        return found != all.end() && (of_whole || !found->of_whole_only);
    }
    void check_metrics()
    {
        const bool worn = is_of_garments(study_, design_);
        std::vector<std::string> known;
        if (worn)
            for (const WearNumber& number : wear_numbers()) known.push_back(number.info.key);
        else {
            for (const std::string& name : experiments_of(study_, design_))
                for (const OutcomeInfo& info : reported_by(find_experiment(design_, name)->type))
                    if (std::find(known.begin(), known.end(), info.key) == known.end()) known.push_back(info.key);
            for (const OutcomeInfo& info : card_metrics()) known.push_back(info.key);
        }
        for (std::size_t i = 0; i < study_.metrics.size(); ++i) {
            const std::string& key = study_.metrics[i];
            if (worn ? is_number_of_garment(key) : std::find(known.begin(), known.end(), key) != known.end()) continue;
            add(Place("metrics") / i,
                say("No experiment of the study has the metric \"{}\"{} They have: {}.", key, or_near(key, known), listed(known)));
        }
    }
    /// The path must lead somewhere, and the first value must be one that may stand there.
    void check_factor(std::size_t k, bool named)
    {
        const Factor& factor = study_.factors[k];
        const FactorValue value = quantile(factor, 0.5);
        try {
            if (factor.path.starts_with(knob_prefix)) {
                KnobSettings knobs;
                set_knob(knobs, factor.path.substr(knob_prefix.size()), value.text);
            } else {
                with_values(design_, {{factor.path, value.text}});
            }
            check_base(k);
            check_bounds(k);
            if (const auto why = named ? out_of_reach(study_, design_, factor.path) : std::nullopt)
                add(Place("factors") / k / "path", *why);
        } catch (const Error& error) {
            add(Place("factors") / k / "path", quote(error.what()));
        }
    }
    /// Between bounds out in a tail there is nothing to draw.
    void check_bounds(std::size_t k)
    {
        using Type = FactorDistribution::Type;
        FactorDistribution whole = study_.factors[k].distribution;
        if (study_.factors[k].is_list() || (whole.type != Type::normal && whole.type != Type::lognormal)) return;
        const std::optional<double> low = std::exchange(whole.low, {}), high = std::exchange(whole.high, {});
        constexpr double least = 1e-9;
        const double lowest = quantile(whole, least), highest = quantile(whole, 1 - least);
        if (low && !(*low < highest))
            add(Place("factors") / k / "distribution" / "low",
                say("The distribution ends at about {:.6g}, below which this must be; given is {}.", highest, *low));
        if (high && !(*high > lowest))
            add(Place("factors") / k / "distribution" / "high",
                say("The distribution begins at about {:.6g}, above which this must be; given is {}.", lowest, *high));
    }
    /// One factor would undo what another sets.
    void check_places()
    {
        std::vector<std::string> paths;
        std::vector<std::size_t> factors;
        for (std::size_t k = 0; k < study_.factors.size(); ++k) {
            if (study_.factors[k].path.starts_with(knob_prefix)) continue;
            paths.push_back(study_.factors[k].path);
            factors.push_back(k);
        }
        if (const auto same = same_place(design_, paths))
            add(Place("factors") / factors[same->second] / "path",
                say("This is the same value as factors[{}], \"{}\"; leave one.", factors[same->first], paths[same->first]));
    }
    /// Beside which others change one at a time.
    void check_base(std::size_t k)
    {
        const Factor& factor = study_.factors[k];
        const auto in_list = [&](const FactorValue& value) {
            return std::find(factor.values.begin(), factor.values.end(), value) != factor.values.end();
        };
        if (factor.base && factor.is_list() && !in_list(*factor.base))
            add(Place("factors") / k / "base", say("This must be one of \"values\"; given is {}.", factor.base->text));
        if (factor.base && !factor.is_list() && !factor.base->is_number)
            add(Place("factors") / k / "base", say("This must be a number; given is \"{}\".", factor.base->text));
        if (factor.base || !factor.is_list() || study_.sampling != Sampling::one_at_a_time) return;
        const std::optional<FactorValue> own = own_value(study_, factor, design_);
        if (own && !in_list(*own))
            add(Place("factors") / k / "values",
                say("One at a time the others change beside the project's own value, {}, which is not in the list; add it, or give "
                    "\"base\".",
                    own->text));
    }
    void check_size()
    {
        try {
            const std::size_t points = count_points(study_);
            const std::size_t each =
                fabrics_of(study_, design_).size() * experiments_of(study_, design_).size() * static_cast<std::size_t>(study_.replicates);
            if (points > most_study_rows / each)
                add("design", say("{} points with {} runs each are more than {} rows; take fewer points, fabrics, experiments or "
                                  "replicates.",
                                  points, each, most_study_rows));
        } catch (const Error& error) {
            add("design", quote(error.what()));
        }
    }

    const Study& study_;
    const Design& design_;
    std::vector<Issue> issues_;
};

std::optional<Message> not_run(const Message& what, const std::string& name, const std::vector<std::string>& run)
{
    if (std::find(run.begin(), run.end(), name) != run.end()) return {};
    return say("The study does not run the {} \"{}\", so this changes nothing. It runs {}.", what, name, listed_in_quotes(run));
}

/// Of what the fabrics' yarns are.
std::vector<std::string> fibres_of(const std::vector<std::string>& fabrics, const Design& design)
{
    std::vector<std::string> fibres;
    const auto add = [&fibres](const Yarn& yarn) {
        for (const std::string& name : materials_in(yarn))
            if (std::find(fibres.begin(), fibres.end(), name) == fibres.end()) fibres.push_back(name);
    };
    for (const std::string& name : fabrics) {
        const Fabric* fabric = find_fabric(design, name);
        if (!fabric) continue;
        add(fabric->warp);
        add(fabric->weft);
        for (const Yarn& yarn : fabric->extra_yarns) add(yarn);
    }
    return fibres;
}

/// Whether a factor chooses among fibres, liquids, fabrics or garments: then any may come to be used.
bool chooses(const Study& study, const std::string& list)
{
    const std::pair<const char*, const char*> keys[] = {
        {"materials", "material"}, {"liquids", ".liquid"}, {"fabrics", ".fabric"}, {"fabrics", ".lining"}, {"garments", ".garment"}};
    return std::any_of(std::begin(keys), std::end(keys), [&](const auto& each) {
        return list == each.first && std::any_of(study.factors.begin(), study.factors.end(), [&](const Factor& factor) {
                   return !factor.path.starts_with(list) && factor.path.find(each.second) != std::string::npos;
               });
    });
}

std::vector<std::string> liquids_of(const std::vector<std::string>& experiments, const Design& design)
{
    std::vector<std::string> liquids;
    for (const std::string& name : experiments)
        if (const Experiment* experiment = find_experiment(design, name))
            liquids.push_back(experiment->liquid);
        else if (const WearExperiment* wear = find_wear(design, name))
            liquids.push_back(wear->liquid);
    return liquids;
}

/// The garments that the study runs, cut as it says.
std::vector<Garment> garments_of(const Study& study, const Design& design)
{
    std::vector<Garment> garments;
    for (const std::string& name : experiments_of(study, design))
        if (const WearExperiment* wear = find_wear(design, name))
            for (const std::string& fabric : fabrics_of(study, design)) {
                garments.push_back(*find_garment(design, wear->garment));
                if (!fabric.empty()) cut_all_from(garments.back(), fabric);
            }
    return garments;
}

/// Also linings.
std::vector<std::string> used_fabrics(const Study& study, const Design& design)
{
    std::vector<std::string> used;
    if (!is_of_garments(study, design)) return fabrics_of(study, design);
    for (const Garment& garment : garments_of(study, design))
        for (const std::string& name : fabrics_of(garment))
            if (std::find(used.begin(), used.end(), name) == used.end()) used.push_back(name);
    return used;
}

} // namespace

std::optional<Message> out_of_reach(const Study& study, const Design& design, const std::string& path)
{
    if (path.starts_with(knob_prefix)) return {};
    const auto member = member_at(design, path);
    if (!member) return {};
    const auto& [list, index] = *member;
    if (is_of_garments(study, design)) {
        if (!study.fabrics.empty() && path.starts_with("garments") && path.ends_with(".fabric"))
            return say("The study cuts the garment from its own list of fabrics, so this changes nothing.");
        if ((list == "fabrics" || list == "garments") && chooses(study, list)) return {};
    }
    const std::vector<std::string> fabrics = used_fabrics(study, design), experiments = experiments_of(study, design);
    if (list == "fabrics") return not_run(say("fabric"), design.fabrics[index].name, fabrics);
    if (list == "experiments") {
        const std::size_t samples = design.experiments.size();
        return not_run(say("experiment"), index < samples ? design.experiments[index].name : design.wears[index - samples].name,
                       experiments);
    }
    if (list == "garments") {
        const std::vector<std::string> garments = names_in(garments_of(study, design));
        if (garments.empty()) return say("The study runs no garment, so this changes nothing.");
        return not_run(say("garment"), design.garments[index].name, garments);
    }
    const bool fibre = list == "materials";
    if ((!fibre && list != "liquids") || chooses(study, list)) return {};
    const std::string& name = fibre ? design.materials[index].name : design.liquids[index].name;
    const std::vector<std::string> used = fibre ? fibres_of(fabrics, design) : liquids_of(experiments, design);
    if (std::find(used.begin(), used.end(), name) != used.end()) return {};
    return say("No {} of the study has \"{}\", so this changes nothing. They have {}.", fibre ? say("fabric") : say("experiment"), name,
               listed_in_quotes(used));
}

std::vector<Issue> validate(const Study& study, const Design& design) { return Check(study, design).issues(); }

bool is_of_garments(const Study& study, const Design& design)
{
    return find_wear(design, experiments_of(study, design).front()) != nullptr;
}

std::vector<std::string> fabrics_of(const Study& study, const Design& design)
{
    if (!study.fabrics.empty()) return study.fabrics;
    return {is_of_garments(study, design) ? std::string() : design.fabrics.front().name};
}

std::vector<std::string> experiments_of(const Study& study, const Design& design)
{
    if (!study.experiments.empty()) return study.experiments;
    return {design.experiments.empty() ? design.wears.front().name : design.experiments.front().name};
}

std::vector<std::string> metrics_of(const Study& study, const Design& design)
{
    if (!study.metrics.empty()) return study.metrics;
    std::vector<std::string> keys;
    for (const std::string& name : experiments_of(study, design)) {
        const Experiment* const sample = find_experiment(design, name);
        for (const OutcomeInfo& info : sample ? compared_by(sample->type) : compared_by_wear())
            if (std::find(keys.begin(), keys.end(), info.key) == keys.end()) keys.push_back(info.key);
    }
    return keys;
}

} // namespace hygroloom
