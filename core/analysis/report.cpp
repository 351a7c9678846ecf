// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/report.h"

#include "core/analysis/line_chart.h"
#include "core/analysis/outcomes.h"
#include "core/analysis/plots.h"
#include "core/analysis/report_inputs.h"
#include "core/analysis/report_outcomes.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/design/fabric_quantities.h"
#include "core/project/project_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

/// A number with so many digits, in the reader's unit.
PageRow row_of(const ReaderUnits& units, const std::string& name, double value, int digits, const std::string& unit)
{
    const ReaderUnit own = reader_unit(units, unit);
    return row(name, rounded_text(own.of(value), digits), own.unit);
}

/// Which of the stain's sizes is which.
constexpr const char* sizes_of_stain = "The wetted radius is that of the smallest circle around all wet crossings of a face. The ellipse "
                                       "of equal moments is the filled one that "
                                       "spreads as widely as the wet crossings on top; single fingers count little in it.";

PageBlocks results(const RunRecord& run, const Metrics& metrics, const ReaderUnits& units)
{
    const std::vector<Outcome> outcomes = outcomes_of(run, metrics);
    const std::map<std::string, Interval> intervals = numerical_intervals(run, metrics);
    const OutcomeRows found = outcome_rows(outcomes, intervals, units);
    std::vector<std::string> notes = notes_of(metrics);
    notes.insert(notes.end(), found.notes.begin(), found.notes.end());
    const bool ellipse = std::any_of(outcomes.begin(), outcomes.end(),
                                     [](const Outcome& outcome) { return outcome.key.starts_with("wetted_area_ellipse"); });
    if (ellipse) notes.insert(notes.begin(), sizes_of_stain);
    const PageBlocks assumed = metrics.assumed.empty() ? PageBlocks() : joined({sentence("Assumed:"), list(metrics.assumed)});
    const PageBlocks about = intervals.empty() ? PageBlocks() : sentence("After ±: the numerical error, as measured on runs of this kind.");
    return joined({table(found.rows), about, list(notes), assumed});
}

PageBlocks balance(const Ledger& ledger)
{
    std::vector<PageRow> rows;
    for (const auto& part : {water_balance(ledger), balance_check(ledger)})
        for (const BalanceRow& of : part) rows.push_back(row(of.title, fmt::format("{:.4g}", of.value), of.unit));
    return table(rows);
}

/// Curves that are empty or all 0 are left out, and so is a plot without curves.
PageBlocks charts(const Metrics& metrics, const ReaderUnits& units)
{
    PageBlocks figures;
    for (const Plot& plot : all_plots()) {
        const ReaderUnit own = reader_unit(units, plot.unit);
        LineChart chart{plot.title, "time, s", own.unit, metrics.series.time, {}};
        for (const Curve& curve : plot.curves) {
            std::vector<double> values = plotted(plot, curve, metrics);
            if (std::none_of(values.begin(), values.end(), [](double value) { return value != 0; })) continue;
            for (double& value : values) value = own.of(value);
            chart.curves.push_back({curve.name, values});
        }
        if (!chart.curves.empty() && chart.x.size() > 1) figures.emplace_back(PageDrawing{svg_of(chart)});
    }
    return figures;
}

std::vector<PageRow> derived(const ReaderUnits& units, const FabricQuantities& q)
{
    return {row("cover factor", rounded_text(q.cover_factor, 3), ""),
            row("mass per area", rounded_text(q.areal_density_g_m2, 4), "g/m²"),
            row_of(units, "thickness", q.thickness_mm, 3, "mm"),
            row("porosity", rounded_text(q.porosity, 3), ""),
            row("fibres in the yarn layer", rounded_text(q.fibre_volume_fraction, 3), "m³/m³"),
            row_of(units, "gap between ends", q.gap_warp_mm, 3, "mm"),
            row_of(units, "gap between picks", q.gap_weft_mm, 3, "mm"),
            row("smoothness", rounded_text(q.smoothness, 3), "")};
}

void add_derived(std::vector<PageRow>& rows, const ReaderUnits& units, const char* which, const YarnQuantities& q)
{
    const std::string yarn = std::string(which) + ", ";
    const ReaderUnit length = reader_unit(units, "mm");
    const auto side = [&length](double mm) { return rounded_text(length.of(mm), 3); };
    rows.insert(rows.end(), {row_of(units, yarn + "linear density", q.linear_density_tex, 3, "tex"),
                             row(yarn + "section", side(q.section_mm.width) + " x " + side(q.section_mm.height), length.unit),
                             row(yarn + "fibre share", rounded_text(q.packing_factor_in_fabric, 3), "m³/m³"),
                             row(yarn + "crimp", rounded_text(q.crimp_percent, 3), "%"),
                             row(yarn + "pore radius", rounded_text(q.pore_radius_um, 3), "µm"),
                             row(yarn + "contact angle", rounded_text(q.contact_angle_deg, 3), "°")});
}

/// The materials and the liquid that the run used, also where the project takes them from the library.
Design with_what_was_used(const RunRecord& run, const Fabric& fabric, const Experiment& experiment)
{
    Design used;
    const auto add = [&](const Yarn& yarn) {
        for (const std::string& name : materials_in(yarn)) {
            const Material* material = find_material(run.design, name);
            const auto is_there = [&](const Material& other) { return other.name == name; };
            if (material && std::none_of(used.materials.begin(), used.materials.end(), is_there)) used.materials.push_back(*material);
        }
    };
    add(fabric.warp);
    add(fabric.weft);
    for (const Yarn& yarn : fabric.extra_yarns) add(yarn);
    if (const Liquid* liquid = find_liquid(run.design, experiment.liquid)) used.liquids.push_back(*liquid);
    used.fabrics.push_back(fabric);
    used.experiments.push_back(experiment);
    return used;
}

PageBlocks input(const RunRecord& run, const ReaderUnits& units)
{
    const FabricQuantities& q = run.textile.quantities;
    std::vector<PageRow> rows = derived(units, q);
    add_derived(rows, units, "warp", q.warp);
    add_derived(rows, units, "weft", q.weft);
    PageBlocks body = joined({table(rows), list(english(q.notes))});
    const Fabric* fabric = find_fabric(run.design, run.fabric);
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    if (!fabric || !experiment) return body;
    const Json project = json_from_design(with_what_was_used(run, *fabric, *experiment));
    constexpr std::pair<const char*, const char*> parts[] = {
        {"fabrics", "Fabric"}, {"materials", "Fibres"}, {"experiments", "Experiment"}, {"liquids", "Liquid"}};
    for (const auto& [key, name] : parts)
        for (const Json& value : project.value(key, Json::array())) body = joined({body, table_of_inputs(name, value, units)});
    return body;
}

/// The parts of the physics, and why each was modelled or not.
PageBlocks parts(const RunRecord& run)
{
    std::vector<PageRow> rows;
    for (const PlannedPart& part : run.plan.parts)
        rows.push_back({{part.name, PageCell::Kind::heading}, {part.on ? "on" : "off"}, {part.reason}});
    std::vector<std::string> sentences;
    for (const SwitchedPart& part : run.switched_on) sentences.push_back(in_words(part));
    return joined({table(rows), list(sentences)});
}

/// The knobs that the user changed.
PageBlocks knobs(const ModelPlan& plan)
{
    const Knobs usual = knobs_of(plan.fidelity);
    std::vector<PageRow> rows;
    for (const KnobInfo& knob : knob_table()) {
        const double value = plan.knobs.*knob.value;
        const std::string meaning = knob.meaning; // its first part, before what is said of single values
        if (value != usual.*knob.value)
            rows.push_back(row(meaning.substr(0, meaning.find(';')), text_of(knob, value),
                               fmt::format("(instead of {})", text_of(knob, usual.*knob.value))));
    }
    return rows.empty() ? PageBlocks() : joined({sentence("Knobs that differ from this fidelity:"), table(rows)});
}

PageBlocks origin(const RunRecord& run, const Ledger& ledger, bool finished)
{
    std::vector<PageRow> rows{row("program", std::string("Hygroloom ") + program_version(), ""),
                              row("commit", program_commit(), ""),
                              row("fabric", run.fabric, ""),
                              row("experiment", run.experiment, ""),
                              row("backend", run.backend, ""),
                              row("device", run.device, ""),
                              row("fidelity", name_of(run.plan.fidelity), ""),
                              row("seed", std::to_string(run.seed), "")};
    if (finished) rows.push_back(row("computing time", fmt::format("{:.4g}", run.wall), "s"));
    rows.push_back(row("simulated time", fmt::format("{:.4g}", ledger.time), "s"));
    if (run.plan.expected_error)
        rows.push_back(
            row("largest numerical error of all numbers but “stain at rest from”", rounded_text(100 * *run.plan.expected_error, 2), "%"));
    if (!run.date.empty()) rows.push_back(row("started", run.date, ""));
    return joined({table(rows), knobs(run.plan), parts(run), list(notes_of(run.plan))});
}

} // namespace

ReportPage report_of(const RunRecord& run, const Metrics& metrics, const std::vector<ReportPicture>& pictures, bool finished,
                     const ReaderUnits& units)
{
    const std::string origin_of_all =
        "Simulated, not measured." + (finished ? "" : fmt::format(" The run was stopped at {:.4g} s.", metrics.ledger.time));
    return {run.fabric + ", " + run.experiment,
            joined({sentence(origin_of_all), section("Results", results(run, metrics, units)), section("Maps", blocks_of(pictures)),
                    section("Over time", charts(metrics, units)), section("Balance", balance(metrics.ledger)),
                    section("Inputs", input(run, units)), section("Computation", origin(run, metrics.ledger, finished))})};
}

} // namespace hygroloom
