// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A calibration as text, JSON and a page.
#include "core/analysis/calibration.h"
#include "core/analysis/intervals.h"
#include "core/analysis/line_chart.h"
#include "core/analysis/outcomes.h"
#include "core/analysis/page.h"
#include "core/analysis/series_keys.h"
#include "core/analysis/svg.h"
#include "core/base/version.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

std::string value_text(double value, const std::string& unit) { return fmt::format("{:.4g}{}", value, unit); }

/// "45.2 ± 1.3°"; without an interval where there is none.
std::string fitted_text(const FittedInput& input)
{
    return input.half > 0 ? fmt::format("{:.4g} ± {:.2g}{}", input.value, input.half, input.unit) : value_text(input.value, input.unit);
}

std::string range_text(const FreeInput& input) { return fmt::format("{:.4g} to {:.4g}{}", input.low, input.high, input.unit); }

/// "wick_height_mm at 4 s", or the metric.
std::string name_of(const Calibration& calibration, const MeasuredNumber& number)
{
    return calibration.data.is_curve() ? fmt::format("{} at {:.4g} s", number.key, number.time) : number.key;
}

/// The same in words: "Height at 4 s", "wetted radius, top".
std::string title_of(const Calibration& calibration, const MeasuredNumber& number)
{
    if (calibration.data.is_curve()) return fmt::format("{} at {:.4g} s", title_of_series(number.key), number.time);
    for (int type = 0; type < experiment_types; ++type)
        for (const OutcomeInfo& info : reported_by(static_cast<ExperimentType>(type)))
            if (info.key == number.key) return full_title(info);
    return number.key;
}

/// Of the curve, or that the residuals are in spreads.
std::string residual_unit(const Calibration& calibration)
{
    if (calibration.data.is_curve()) return calibration.data.unit;
    return calibration.data.numbers.front().spread ? "spreads" : calibration.data.numbers.front().unit;
}

std::string residual_text(const Calibration& calibration)
{
    return fmt::format("Residual (root mean square): {:.3g} {unit} before, {:.3g} {unit} after.", calibration.residual_rms_before,
                       calibration.residual_rms, fmt::arg("unit", residual_unit(calibration)));
}

std::string basis_text(const Calibration& calibration)
{
    const bool with_runs =
        std::any_of(calibration.inputs.begin(), calibration.inputs.end(), [](const FittedInput& input) { return input.numerical > 0; });
    return fmt::format("Intervals of {:.0f} %, from {}, how unevenly the runs follow the input{}.", 100 * of_intervals.held,
                       calibration.data.numbers.front().spread ? "the spreads that the file gives" : "the residuals by Student's law",
                       with_runs ? ", and their numerical error" : "");
}

/// A chart of the data's times; its curves are to be added.
LineChart chart_of(const Calibration& calibration, const std::string& title)
{
    LineChart chart{title, "time, s", calibration.data.unit.empty() ? "1" : calibration.data.unit, {}, {}};
    for (const MeasuredNumber& number : calibration.data.numbers) chart.x.push_back(number.time);
    return chart;
}

bool has_picture(const Calibration& calibration)
{
    const MeasuredData& data = calibration.data;
    return data.is_curve() && !calibration.fitted.empty() && data.numbers.back().time > data.numbers.front().time;
}

std::string residuals_svg(const Calibration& calibration)
{
    LineChart chart = chart_of(calibration, "Measured less simulated");
    LineChart::Curve off{"residual", {}, true}, none{"0", {}};
    for (std::size_t i = 0; i < calibration.fitted.size(); ++i) {
        off.values.push_back(calibration.data.numbers[i].value - calibration.fitted[i]);
        none.values.push_back(0);
    }
    chart.curves = {none, off};
    return svg_of(chart);
}

PageBlocks inputs_of(const Calibration& calibration)
{
    using Kind = PageCell::Kind;
    std::vector<PageRow> rows{row_of_headings({"", "before", "fitted", "range"})};
    for (const FittedInput& input : calibration.inputs)
        rows.push_back({{input.title, Kind::heading},
                        {value_text(input.given, input.unit), Kind::number},
                        {calibration.fitted.empty() ? "–" : fitted_text(input), Kind::number},
                        {range_text(input)}});
    return table(rows);
}

PageBlocks numbers_of(const Calibration& calibration)
{
    using Kind = PageCell::Kind;
    if (calibration.fitted.empty()) return {};
    std::vector<PageRow> rows{row_of_headings({"", "measured", "before", "fitted", "residual", ""})};
    for (std::size_t i = 0; i < calibration.fitted.size(); ++i) {
        const MeasuredNumber& number = calibration.data.numbers[i];
        rows.push_back(
            {{title_of(calibration, number), Kind::heading},
             {fmt::format("{:.4g}{}", number.value, number.spread ? fmt::format(" ± {:.2g}", *number.spread) : ""), Kind::number},
             {fmt::format("{:.4g}", calibration.before[i]), Kind::number},
             {fmt::format("{:.4g}", calibration.fitted[i]), Kind::number},
             {fmt::format("{:.2g}", number.value - calibration.fitted[i]), Kind::number},
             {number.unit}});
    }
    return table(rows);
}

} // namespace

std::string fit_svg(const Calibration& calibration)
{
    if (!has_picture(calibration)) return {};
    LineChart chart = chart_of(calibration, title_of_series(calibration.data.quantity));
    LineChart::Curve measured{"measured", {}, true};
    for (const MeasuredNumber& number : calibration.data.numbers) measured.values.push_back(number.value);
    chart.curves = {{"fitted", calibration.fitted}, {"before", calibration.before}, measured};
    return svg_of(chart);
}

std::string calibration_table(const Calibration& calibration)
{
    std::string text = fmt::format("{:<18}{:>12}{:>20}    {}\n", "", "before", "fitted", "range");
    for (const FittedInput& input : calibration.inputs)
        text += fmt::format("{:<18}{:>12}{:>20}    {}\n", input.title, value_text(input.given, input.unit),
                            calibration.fitted.empty() ? "–" : fitted_text(input), range_text(input));
    if (calibration.fitted.empty()) return text;
    text += fmt::format("\n{:<34}{:>10}{:>10}{:>10}{:>10}\n", "", "measured", "before", "fitted", "residual");
    for (std::size_t i = 0; i < calibration.fitted.size(); ++i) {
        const MeasuredNumber& number = calibration.data.numbers[i];
        text += fmt::format("{:<34}{:>10.4g}{:>10.4g}{:>10.4g}{:>10.2g}\n", name_of(calibration, number), number.value,
                            calibration.before[i], calibration.fitted[i], number.value - calibration.fitted[i]);
    }
    text += "\n" + residual_text(calibration) + "\n" + basis_text(calibration) + "\n";
    for (const std::string& note : calibration.notes) text += note + "\n";
    return text;
}

std::string calibration_json(const Calibration& calibration)
{
    Json parameters = Json::object(), data = Json::array();
    const bool fitted = !calibration.fitted.empty();
    for (const FittedInput& input : calibration.inputs) {
        const bool known = fitted && input.half > 0; // otherwise there is no interval
        parameters[input.key] = {{"value", fitted ? Json(input.value) : Json(nullptr)},
                                 {"low", known ? Json(input.value - input.half) : Json(nullptr)},
                                 {"high", known ? Json(input.value + input.half) : Json(nullptr)},
                                 {"uneven", known ? Json(input.uneven) : Json(nullptr)},
                                 {"numerical", known ? Json(input.numerical) : Json(nullptr)},
                                 {"before", input.given},
                                 {"range", {input.low, input.high}}};
    }
    for (std::size_t i = 0; i < calibration.fitted.size(); ++i) {
        const MeasuredNumber& number = calibration.data.numbers[i];
        Json row{{"key", number.key}, {"unit", number.unit}};
        if (calibration.data.is_curve()) row["time_s"] = number.time;
        row.update({{"measured", number.value}, {"before", calibration.before[i]}, {"fitted", calibration.fitted[i]}});
        if (number.spread) row["spread"] = *number.spread;
        data.push_back(row);
    }
    Json json{{"fabric", calibration.fabric},
              {"experiment", calibration.experiment},
              {"fidelity", hygroloom::name_of(calibration.fidelity)},
              {"file", calibration.data.file},
              {"quantity", calibration.data.quantity},
              {"level", of_intervals.held},
              {"parameters", parameters},
              {"residual_rms_before", calibration.residual_rms_before},
              {"residual_rms", calibration.residual_rms},
              {"correlation", calibration.correlation},
              {"identifiable", calibration.identifiable()}};
    if (!calibration.refusal.empty()) json["error"] = calibration.refusal;
    json["notes"] = calibration.notes;
    json["data"] = data;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

ReportPage calibration_report(const Calibration& calibration)
{
    PageBlocks answer;
    if (!calibration.identifiable()) answer = {PageText{calibration.refusal, "The data do not tell these inputs."}};
    PageBlocks drawings;
    if (has_picture(calibration)) drawings = {PageDrawing{fit_svg(calibration)}, PageDrawing{residuals_svg(calibration)}};
    std::vector<std::string> basis = calibration.notes;
    if (!calibration.fitted.empty()) basis.insert(basis.begin(), {residual_text(calibration), basis_text(calibration)});
    return {
        "Calibration: " + calibration.fabric,
        joined({sentence(fmt::format("Which inputs of “{}” does the measurement {} tell, by the experiment “{}”, {}?", calibration.fabric,
                                     calibration.data.file, calibration.experiment, hygroloom::name_of(calibration.fidelity))),
                answer, section("Inputs", inputs_of(calibration)), section("Fit", drawings), section("Numbers", numbers_of(calibration)),
                section("What it rests on", list(basis)),
                section("Computation",
                        table({row("program", std::string("Hygroloom ") + program_version(), ""), row("commit", program_commit(), "")}))})};
}

Design calibrated_design(const Design& design, const Calibration& calibration)
{
    std::vector<FreeInput> inputs(calibration.inputs.begin(), calibration.inputs.end());
    std::vector<double> values;
    for (const FittedInput& input : calibration.inputs) values.push_back(input.value);
    Design other = with_inputs(design, calibration.fabric, inputs, values);
    Fabric& fabric = other.fabrics[static_cast<std::size_t>(find_fabric(other, calibration.fabric) - other.fabrics.data())];
    const std::string file = std::filesystem::path(calibration.data.file).filename().string(); // folders are this machine's
    Calibrated from{file, calibration.experiment, name_of(calibration.fidelity), calibration.data.quantity, calibration.residual_rms, {}};
    for (const FittedInput& input : calibration.inputs) {
        if (input.half > 0) uncertainty_of(fabric, input.key) = input.half; // else nothing is known of it
        before_of(from, input.key) = input.given;
    }
    fabric.calibrated = from;
    return other;
}

} // namespace hygroloom
