// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whether a study and a project go together.
#include "core/analysis/outcomes.h"
#include "core/base/error.h"
#include "core/base/words.h"
#include "core/project/project_json.h"
#include "core/project/project_value.h"
#include "core/study/points.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {
namespace {

constexpr std::string_view knob_prefix = "fidelity.";

class Check {
public:
    Check(const Study& study, const Design& design) : study_(study), design_(design) {}

    std::vector<Issue> issues()
    {
        check_names("fabrics", "fabric", study_.fabrics, design_.fabrics);
        check_names("experiments", "experiment", study_.experiments, design_.experiments);
        if (issues_.empty()) check_metrics();
        for (std::size_t k = 0; k < study_.factors.size(); ++k) check_factor(k);
        if (issues_.empty()) check_size();
        return std::move(issues_);
    }

private:
    void add(const std::string& where, const std::string& text) { issues_.push_back({Severity::error, "study", where, text}); }

    template <typename Item>
    void check_names(const std::string& key, const char* what, const std::vector<std::string>& names, const std::vector<Item>& items)
    {
        std::vector<std::string> known;
        std::string all;
        for (const Item& item : items) {
            known.push_back(item.name);
            all += (all.empty() ? "\"" : ", \"") + item.name + "\"";
        }
        if (names.empty() && items.size() == 1) return;
        if (items.empty()) return add(key, fmt::format("The project has no {} that a study can run.", what));
        if (names.empty()) return add(key, fmt::format("The project has several {}s; list those to run: {}.", what, all));
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (std::find(known.begin(), known.end(), names[i]) != known.end()) continue;
            const char* hint = find_wear(design_, names[i]) ? " It is one on a garment, which studies do not run yet." : "";
            add(fmt::format("{}[{}]", key, i),
                fmt::format("The project has no {} \"{}\"{}{} It has {}.", what, names[i], did_you_mean(names[i], known), hint, all));
        }
    }
    void check_metrics()
    {
        std::vector<std::string> known;
        for (const std::string& name : experiments_of(study_, design_))
            for (const OutcomeInfo& info : reported_by(find_experiment(design_, name)->type))
                if (std::find(known.begin(), known.end(), info.key) == known.end()) known.push_back(info.key);
        std::string all;
        for (const std::string& key : known) all += (all.empty() ? "" : ", ") + key;
        for (std::size_t i = 0; i < study_.metrics.size(); ++i)
            if (std::find(known.begin(), known.end(), study_.metrics[i]) == known.end())
                add(fmt::format("metrics[{}]", i), fmt::format("No experiment of the study has the metric \"{}\"{} They have: {}.",
                                                               study_.metrics[i], did_you_mean(study_.metrics[i], known), all));
    }
    /// The path must lead somewhere, and the first value must be one that may stand there.
    void check_factor(std::size_t k)
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
        } catch (const Error& error) {
            add(fmt::format("factors[{}].path", k), error.what());
        }
    }
    void check_size()
    {
        try {
            const std::size_t points = count_points(study_);
            const std::size_t each =
                fabrics_of(study_, design_).size() * experiments_of(study_, design_).size() * static_cast<std::size_t>(study_.replicates);
            if (points > most_study_rows / each)
                add("design", fmt::format("{} points with {} runs each are more than {} rows; take fewer points, fabrics, experiments or "
                                          "replicates.",
                                          points, each, most_study_rows));
        } catch (const Error& error) {
            add("design", error.what());
        }
    }

    const Study& study_;
    const Design& design_;
    std::vector<Issue> issues_;
};

} // namespace

std::vector<Issue> validate(const Study& study, const Design& design) { return Check(study, design).issues(); }

std::vector<std::string> fabrics_of(const Study& study, const Design& design)
{
    return study.fabrics.empty() ? std::vector{design.fabrics.front().name} : study.fabrics;
}

std::vector<std::string> experiments_of(const Study& study, const Design& design)
{
    return study.experiments.empty() ? std::vector{design.experiments.front().name} : study.experiments;
}

std::vector<std::string> metrics_of(const Study& study, const Design& design)
{
    if (!study.metrics.empty()) return study.metrics;
    std::vector<std::string> keys;
    for (const std::string& name : experiments_of(study, design))
        for (const OutcomeInfo& info : compared_by(find_experiment(design, name)->type))
            if (std::find(keys.begin(), keys.end(), info.key) == keys.end()) keys.push_back(info.key);
    return keys;
}

} // namespace hygroloom
