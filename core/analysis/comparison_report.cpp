// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/comparison_report.h"

#include "core/analysis/card.h"
#include "core/analysis/comparative.h"
#include "core/analysis/experiment_rows.h"
#include "core/analysis/line_chart.h"
#include "core/analysis/replicate_range.h"
#include "core/analysis/report_inputs.h"
#include "core/analysis/svg.h"
#include "core/analysis/why.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/project/project_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;
using Kind = PageCell::Kind;

const Experiment* experiment_of(const Candidate& candidate)
{
    return candidate.run ? find_experiment(candidate.run->design, candidate.run->experiment) : nullptr;
}

std::string question(const Comparison& comparison)
{
    return fmt::format("Which of {} {} is best on the experiment “{}”? They are ranked by {}; {} is better. The verdicts are against "
                       "{}. Those that share a rank cannot be told apart.",
                       comparison.candidates.size(), comparison.of_garments ? "garments" : "fabrics", comparison.experiment,
                       full_title(comparison.ranked_by), comparative(comparison.ranked_by, comparison.ranked_by.better == Better::more),
                       comparison.baseline);
}

/// Runs that are alike.
struct RunKind {
    ExperimentRows rows;
    std::string fabrics; ///< their names
};

/// Kinds may differ in which rows they have: a row that one lacks is a dash.
PageBlocks table_of_kinds(const std::vector<RunKind>& kinds)
{
    std::vector<std::string> names;
    for (const RunKind& kind : kinds)
        for (const auto& [name, text] : kind.rows)
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    std::vector<PageRow> rows;
    if (kinds.size() > 1) {
        rows.push_back(row_of_headings({""}));
        for (const RunKind& kind : kinds) rows.back().push_back({kind.fabrics, Kind::heading});
    }
    for (const std::string& name : names) {
        rows.push_back(row_of_headings({name}));
        for (const RunKind& kind : kinds) {
            const auto found = std::find_if(kind.rows.begin(), kind.rows.end(), [&](const auto& row) { return row.first == name; });
            rows.back().push_back({found == kind.rows.end() ? "–" : found->second});
        }
    }
    return table(rows);
}

/// Type, liquid, how it comes to the cloth, climate, sample, duration and fidelity: a column where all runs are alike in them, otherwise
/// one for each kind of run, headed by its fabrics.
PageBlocks experiment_table(const Comparison& comparison, const ReaderUnits& units)
{
    std::vector<RunKind> kinds;
    for (const Candidate& candidate : comparison.candidates) {
        const Experiment* e = experiment_of(candidate);
        if (!e && !candidate.worn) continue;
        ExperimentRows rows = e ? experiment_rows(*candidate.run, *e, units) : experiment_rows(*candidate.worn, units);
        if (comparison.replicates > 1)
            rows.emplace_back(e ? "replicates of each fabric" : "replicates of each garment", std::to_string(comparison.replicates));
        const auto same = std::find_if(kinds.begin(), kinds.end(), [&](const RunKind& kind) { return kind.rows == rows; });
        if (same == kinds.end())
            kinds.push_back({std::move(rows), candidate.fabric});
        else
            same->fabrics += ", " + candidate.fabric;
    }
    return table_of_kinds(kinds);
}

PageCell cell(const Comparison& comparison, const Candidate& candidate, const OutcomeInfo& criterion, const ReaderUnits& units)
{
    const auto found = candidate.intervals.find(criterion.key);
    PageCell made{found == candidate.intervals.end() ? "–" : with_interval(criterion, found->second, units), Kind::number};
    if (const Compared* verdict = verdict_of(comparison, candidate.fabric, criterion.key))
        made.strong.emplace_back(name_of(verdict->verdict));
    if (const LoneNumber* lone = lone_number_of(comparison, candidate.fabric, criterion.key)) made.strong.push_back(lone->words);
    if (const LaboratoryValue* value = measured_of(comparison, candidate.fabric, criterion.key)) {
        const ReaderUnit own = reader_unit(units, shown(criterion, 0).unit);
        made.below = fmt::format("measured {:.4g}{}", own.of(shown(criterion, value->value).value),
                                 value->spread ? fmt::format(" ± {:.2g}", own.per_one * *value->spread) : "");
    }
    return made;
}

PageBlocks results(const Comparison& comparison, const ReaderUnits& units)
{
    std::vector<PageRow> rows{row_of_headings({"", comparison.of_garments ? "garment" : "fabric"})};
    for (const OutcomeInfo& criterion : comparison.criteria) {
        const std::string unit = reader_unit(units, shown(criterion, 0).unit).unit;
        rows.back().push_back({full_title(criterion) + (unit.empty() ? "" : ", " + unit), Kind::heading});
    }
    for (const Candidate& candidate : comparison.candidates) {
        rows.push_back({{candidate.rank == 0 ? "–" : rank_text(candidate)}, {candidate.fabric, Kind::heading}});
        if (!candidate.failure.empty()) {
            rows.back().push_back({candidate.failure});
            rows.back().back().columns = static_cast<int>(comparison.criteria.size());
        } else {
            for (const OutcomeInfo& criterion : comparison.criteria) rows.back().push_back(cell(comparison, candidate, criterion, units));
        }
    }
    std::vector<std::string> sentences{basis_text(comparison)};
    for (const LoneNumber& lone : comparison.lone) sentences.push_back(lone.sentence);
    return joined({table(rows), list(sentences)});
}

/// The intervals of one number, a line a candidate; what was measured is a hollow diamond.
PageBlocks whiskers(const Comparison& comparison, const OutcomeInfo& criterion, const ReaderUnits& units)
{
    constexpr double left = 170, width = 380, line = 22;
    double low = 0, high = 0;
    bool any = false, measured = false;
    const auto widen = [&](double a, double b) {
        low = any ? std::min(low, a) : a;
        high = any ? std::max(high, b) : b;
        any = true;
    };
    for (const Candidate& candidate : comparison.candidates) {
        if (const auto found = candidate.intervals.find(criterion.key); found != candidate.intervals.end())
            widen(found->second.low, found->second.high);
        if (const LaboratoryValue* value = measured_of(comparison, candidate.fabric, criterion.key)) {
            widen(value->value, value->value);
            measured = true;
        }
    }
    if (!any || !(high > low)) return {};
    const auto x_of = [&](double value) { return left + width * (value - low) / (high - low); };
    std::string body;
    double y = 20;
    for (const Candidate& candidate : comparison.candidates) {
        body += svg_text(left - 10, y + 4, "end", candidate.fabric.substr(0, 24));
        if (const auto found = candidate.intervals.find(criterion.key); found != candidate.intervals.end())
            body += fmt::format("<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#2a5ca8\" stroke-width=\"2\"/>"
                                "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"#2a5ca8\"/>\n",
                                x_of(found->second.low), x_of(found->second.high), y, y, x_of(found->second.centre), y);
        if (const LaboratoryValue* value = measured_of(comparison, candidate.fabric, criterion.key))
            body += fmt::format("<path d=\"M{:.1f} {:.1f} l5 5 l-5 5 l-5 -5 z\" fill=\"none\" stroke=\"#b03020\" stroke-width=\"1.5\"/>\n",
                                x_of(value->value), y - 5);
        y += line;
    }
    const ReaderUnit own = reader_unit(units, shown(criterion, 0).unit);
    body += svg_text(left, y + 4, "start", fmt::format("{:.4g}", own.of(shown(criterion, low).value)));
    body += svg_text(left + width, y + 4, "end", fmt::format("{:.4g} {}", own.of(shown(criterion, high).value), own.unit));
    return {PageDrawing{svg_begin(580, y + 14) + body + "</svg>",
                        fmt::format("{}. Point and line: simulated, with its interval.{}", full_title(criterion),
                                    measured ? " Hollow diamond: measured." : "")}};
}

/// The middle of the replicates with their band; of a single run its curve.
LineChart::Curve curve_of(const Candidate& candidate, const Plot& plot, const Curve& curve, const std::vector<double>& times)
{
    LineChart::Curve made{candidate.fabric, {}};
    if (const auto range = curve_range(candidate, plot, curve)) {
        made.values = values_at(times, range->time, range->middle);
        made.low = values_at(times, range->time, range->low);
        made.high = values_at(times, range->time, range->high);
    } else if (candidate.metrics && candidate.metrics->series.time.size() > 1) {
        const std::vector<double> values = plotted(plot, curve, *candidate.metrics);
        if (values.size() == candidate.metrics->series.time.size()) made.values = values_at(times, candidate.metrics->series.time, values);
    }
    return made;
}

/// What the bands of a figure are; empty: it has none.
std::string bands_text(const Comparison& comparison, const Plot& plot, const Curve& curve)
{
    std::map<int, std::string> by_runs; // the fabrics' names
    std::string without;
    for (const Candidate& candidate : comparison.candidates) {
        const auto range = curve_range(candidate, plot, curve);
        if (!range && (!candidate.metrics || candidate.metrics->series.time.size() < 2)) continue; // it failed, and has no curve
        std::string& names = range ? by_runs[range->runs] : without;
        names += (names.empty() ? "" : ", ") + candidate.fabric;
    }
    std::string text;
    for (const auto& [runs, names] : by_runs)
        text += (text.empty() ? "Line: the middle of the replicates. Band: " : "; ") + range_words(runs) +
                (by_runs.size() > 1 ? " of " + names : "");
    if (text.empty()) return {};
    return text + (without.empty() ? "." : ". Without a band, one run each: " + without + ".");
}

/// Curves of what the type of experiment measures, a figure for each with all fabrics in it.
PageBlocks curves(const Comparison& comparison, const ReaderUnits& units)
{
    const auto first = std::find_if(comparison.candidates.begin(), comparison.candidates.end(),
                                    [](const Candidate& c) { return experiment_of(c) && c.metrics && c.metrics->series.time.size() > 1; });
    if (first == comparison.candidates.end()) return {};
    const Experiment& experiment = *experiment_of(*first);
    const bool replicates = comparison.replicates > 1;
    const std::vector<double> times = replicates ? trace_times(experiment.duration_s) : first->metrics->series.time;
    const Plot& plot = subject_plot(experiment.type);
    const ReaderUnit own = reader_unit(units, plot.unit);
    PageBlocks figures;
    for (const Curve& curve : plot.curves) {
        if (curve.in_reports_only) continue;
        LineChart chart{fmt::format("{}, {}", plot.title, curve.name), "time, s", own.unit, times, {}};
        for (const Candidate& candidate : comparison.candidates)
            if (auto made = curve_of(candidate, plot, curve, times); !made.values.empty()) {
                for (std::vector<double>* values : {&made.values, &made.low, &made.high})
                    for (double& value : *values) value = own.of(value);
                chart.curves.push_back(std::move(made));
            }
        if (chart.curves.empty()) continue;
        figures.emplace_back(PageDrawing{svg_of(chart), bands_text(comparison, plot, curve)});
    }
    return figures;
}

/// With replicates, what the maps are of.
PageBlocks maps_of(const Comparison& comparison, const std::vector<ReportPicture>& maps)
{
    if (maps.empty()) return {};
    const char* about = comparison.of_garments
                            ? "The first run of each garment, at the end of the experiment. The other replicates have no pictures."
                            : "The first run of each cloth, at the end of the experiment. The other replicates have no "
                              "pictures here; their ranges stand round the curves.";
    return joined({comparison.replicates > 1 ? sentence(about) : PageBlocks(), blocks_of(maps)});
}

/// What the fabrics of the candidates weigh, and what else follows from their descriptions.
PageBlocks calculated(const Comparison& comparison, const ReaderUnits& units)
{
    std::vector<PageRow> rows{
        row_of_headings({"fabric", "mass per area, g/m²", "thickness, " + reader_unit(units, "mm").unit, "porosity"})};
    for (const Candidate& candidate : comparison.candidates) {
        if (!candidate.run || !(candidate.run->textile.quantities.areal_density_g_m2 > 0)) continue;
        const FabricQuantities& q = candidate.run->textile.quantities;
        rows.push_back(row_of_headings({candidate.fabric}));
        for (const std::string& number : {rounded_text(q.areal_density_g_m2, 4),
                                          rounded_text(reader_unit(units, "mm").of(q.thickness_mm), 3), rounded_text(q.porosity, 3)})
            rows.back().push_back({number, Kind::number});
    }
    return rows.size() > 1 ? table(rows) : PageBlocks();
}

/// What their technical cards say: a row a number, a column a fabric, ranges below.
PageBlocks cards(const Comparison& comparison, const ReaderUnits& units)
{
    if (comparison.cards.empty()) return {};
    std::vector<PageRow> rows{row_of_headings({""})};
    for (const Candidate& candidate : comparison.candidates) rows.front().push_back({candidate.fabric, Kind::heading});
    for (const LaboratoryNumber* number : card_numbers(comparison)) {
        const std::string unit = reader_unit(units, number->unit).unit;
        rows.push_back(row_of_headings({number->title + (unit.empty() ? "" : ", " + unit)}));
        for (const Candidate& candidate : comparison.candidates) {
            const LaboratoryNumber* own = card_number_of(comparison, candidate.fabric, number->key);
            PageCell made{"–", Kind::number};
            if (own) {
                const LaboratoryNumber seen = in_units(*own, units);
                made.text = value_text(seen);
                made.below = range_text(seen.estimate);
            }
            rows.back().push_back(made);
        }
    }
    return table(rows);
}

/// The fabrics that its runs were of, in the design that has them.
std::pair<const Design*, std::vector<const Fabric*>> fabrics_of(const Candidate& candidate)
{
    std::pair<const Design*, std::vector<const Fabric*>> found;
    if (candidate.worn) {
        found.first = &candidate.worn->used;
        for (const Fabric& fabric : candidate.worn->used.fabrics) found.second.push_back(&fabric);
    } else if (candidate.run) {
        found.first = &candidate.run->design;
        if (const Fabric* fabric = find_fabric(candidate.run->design, candidate.run->fabric)) found.second.push_back(fabric);
    }
    return found;
}

/// Of a garment its own keys, then those of its fabrics, after their names where there are several.
std::vector<std::pair<std::string, std::string>> description(const Candidate& candidate, const ReaderUnits& units)
{
    std::vector<std::pair<std::string, std::string>> words;
    if (candidate.worn) words = inputs_in_words(json_from_design(candidate.worn->used).at("garments").at(0), units);
    const std::vector<const Fabric*> fabrics = fabrics_of(candidate).second;
    for (const Fabric* fabric : fabrics) {
        Design alone;
        alone.fabrics.push_back(*fabric);
        Json value = json_from_design(alone).at("fabrics").at(0);
        if (!candidate.worn || fabrics.size() > 1) value.erase("name");
        const std::string whose = fabrics.size() > 1 ? fabric->name + ": " : std::string();
        for (auto& [name, text] : inputs_in_words(value, units)) words.emplace_back(whose + name, std::move(text));
    }
    return words;
}

/// What the candidates' descriptions do not share.
PageBlocks differences(const Comparison& comparison, const ReaderUnits& units)
{
    std::vector<std::string> names; // in the order in which a description has them
    std::map<std::string, std::vector<std::string>> rows;
    const std::size_t count = comparison.candidates.size();
    for (std::size_t i = 0; i < count; ++i)
        for (const auto& [name, text] : description(comparison.candidates[i], units)) {
            if (!rows.contains(name)) names.push_back(name);
            rows[name].resize(count);
            rows[name][i] = text;
        }
    std::vector<PageRow> differing{row_of_headings({""})};
    for (const Candidate& candidate : comparison.candidates) differing.front().push_back({candidate.fabric, Kind::heading});
    for (const std::string& name : names) {
        const std::vector<std::string>& texts = rows[name];
        if (std::all_of(texts.begin(), texts.end(), [&](const std::string& text) { return text == texts.front(); })) continue;
        differing.push_back(row_of_headings({name}));
        for (const std::string& text : texts) differing.back().push_back({text.empty() ? "–" : text});
    }
    return differing.size() > 1 ? table(differing) : sentence("Nothing: the descriptions are the same.");
}

/// Whose time it is.
std::string time_words(const Candidate& candidate)
{
    const int runs = runs_of(candidate);
    if (candidate.timed == 0) return "not known";
    if (candidate.timed < runs)
        return fmt::format("{:.3g} s for the run of the cloth as given; no times of its {} replicates are kept", candidate.wall, runs);
    return candidate.timed == 1 ? fmt::format("{:.3g} s for 1 run", candidate.wall)
                                : fmt::format("{:.3g} s for {} runs together", candidate.wall, candidate.timed);
}

PageBlocks computation(const Comparison& comparison)
{
    std::vector<PageRow> rows{row_of_headings({"fabric", "fidelity and backend", "device", "computing time"})};
    std::vector<std::string> notes;
    for (const Candidate& candidate : comparison.candidates) {
        if (candidate.worn) rows.push_back(row(candidate.fabric, candidate.worn->how, candidate.worn->device, time_words(candidate)));
        if (candidate.run)
            rows.push_back(row(candidate.fabric, fmt::format("{}, {}", name_of(candidate.run->plan.fidelity), candidate.run->backend),
                               candidate.run->device, time_words(candidate)));
        for (const std::string& note : all_notes(comparison, candidate)) notes.push_back(candidate.fabric + ": " + note);
    }
    return joined({table(rows), list(notes),
                   table({row("program", std::string("Hygroloom ") + program_version(), ""), row("commit", program_commit(), "")})});
}

PageBlocks unknown(const Comparison& comparison)
{
    std::vector<std::string> sentences;
    for (const Candidate& candidate : comparison.candidates) {
        const auto& [design, fabrics] = fabrics_of(candidate);
        for (const Fabric* fabric : fabrics)
            for (const UnknownInput& input : unknown_inputs(*design, *fabric))
                sentences.push_back(fmt::format("{}: {} from {:.3g} to {:.3g}{} ({}).", candidate.fabric, input.name, input.low, input.high,
                                                input.unit, input.source));
    }
    sentences.emplace_back("The intervals do not hold the error of the model itself; the guide's page on limits names it.");
    return list(sentences);
}

} // namespace

std::string map_caption(const Comparison& comparison, const std::string& fabric, const std::string& side)
{
    return fabric + (comparison.replicates > 1 ? ", as given, " : ", ") + side;
}

ReportPage comparison_report(const Comparison& comparison, const std::vector<ReportPicture>& maps, const ReaderUnits& units)
{
    PageBlocks intervals;
    for (const OutcomeInfo& criterion : comparison.criteria) intervals = joined({intervals, whiskers(comparison, criterion, units)});
    return {"Comparison: " + comparison.experiment,
            joined({sentence("All numbers are simulated, except those marked as measured."), sentence(question(comparison)),
                    section("Experiment", experiment_table(comparison, units)), section("Results", results(comparison, units)),
                    section("Intervals", intervals), section("Why", comparison.why ? why_blocks(*comparison.why, units) : PageBlocks()),
                    section("Maps", maps_of(comparison, maps)), section("Over time", curves(comparison, units)),
                    section("Fabrics", calculated(comparison, units)), section("Technical cards", cards(comparison, units)),
                    section("What differs in the descriptions", differences(comparison, units)),
                    section("Computation", computation(comparison)), section("What is not known", unknown(comparison))})};
}

} // namespace hygroloom
