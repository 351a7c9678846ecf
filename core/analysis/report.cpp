// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/report.h"

#include "core/analysis/line_chart.h"
#include "core/analysis/svg.h"
#include "core/base/text.h"
#include "core/design/fabric_quantities.h"
#include "core/plan/plan_json.h"
#include "core/project/project_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* style = R"(
body { font: 15px/1.45 system-ui, sans-serif; color: #22262e; background: #fff; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1 { margin-bottom: 0; overflow-wrap: anywhere; } h2 { margin-top: 2rem; border-bottom: 1px solid #ccc; }
table { border-collapse: collapse; } td, th { padding: .15rem 1rem .15rem 0; text-align: left; vertical-align: top; }
td.number { text-align: right; font-variant-numeric: tabular-nums; }
figure { display: inline-block; margin: 0 1rem 1rem 0; vertical-align: top; } figure img { max-width: 28rem; } figcaption { color: #555; }
pre { background: #f4f4f2; padding: .7rem; overflow-x: auto; font-size: 12px; white-space: pre-wrap; }
@media print { body { margin: 0; max-width: none; } h2, figure, tr { break-inside: avoid; } h2 { break-after: avoid; } }
)";

struct Label {
    std::string name, unit;
    double factor = 1; ///< to the unit
};

/// Of a key that ends in its unit: "wick_height_mm" is "wick height" in mm.
Label label_of(const std::string& key)
{
    struct Unit {
        const char* ending;
        const char* name;
        double factor = 1;
    };
    constexpr Unit units[] = {{"_g_m2_h", "g/(m² h)"}, {"_g_m2", "g/m²"}, {"_mm_s05", "mm/√s"}, {"_mm2_s", "mm²/s"},
                              {"_pct_s", "%/s"},       {"_mm_s", "mm/s"}, {"_pct", "%"},        {"_mm", "mm"},
                              {"_kg", "mg", 1e6},      {"_s", "s"},       {"_c", "°C"},         {"_j", "mJ", 1e3}};
    Label label{key, ""};
    for (const Unit& unit : units)
        if (key.ends_with(unit.ending)) {
            label = {key.substr(0, key.size() - std::string_view(unit.ending).size()), unit.name, unit.factor};
            break;
        }
    if (label.name.ends_with("_rise")) label.unit = "K";
    std::replace(label.name.begin(), label.name.end(), '_', ' ');
    return label;
}

std::string in_words(const Json& value, double factor)
{
    if (value.is_null()) return "–";
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (value.is_number_float()) return fmt::format("{:.4g}", factor * value.get<double>());
    return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string row(const std::string& name, const std::string& value, const std::string& unit)
{
    return fmt::format("<tr><th>{}</th><td class=\"number\">{}</td><td>{}</td></tr>\n", escaped_markup(name), escaped_markup(value),
                       escaped_markup(unit));
}

std::string table(const std::string& rows) { return rows.empty() ? "" : "<table>\n" + rows + "</table>\n"; }

/// A row for each value of an object; what is inside another object or a list is left to others.
std::string rows_of(const Json& object)
{
    std::string rows;
    for (const auto& [key, value] : object.items()) {
        const Label label = label_of(key);
        if (!value.is_structured()) rows += row(label.name, in_words(value, label.factor), label.unit);
    }
    return rows;
}

std::string list(const std::vector<std::string>& sentences)
{
    std::string items;
    for (const std::string& sentence : sentences) items += "<li>" + escaped_markup(sentence) + "</li>\n";
    return items.empty() ? "" : "<ul>\n" + items + "</ul>\n";
}

std::string section(const char* title, const std::string& body) { return body.empty() ? "" : fmt::format("<h2>{}</h2>\n{}", title, body); }

std::string results(const Json& metrics)
{
    std::string body = table(rows_of(metrics));
    if (metrics.contains("grades")) body += "<p>Grades, 1 to 5:</p>\n" + table(rows_of(metrics["grades"]));
    if (metrics.contains("notes")) body += list(metrics["notes"].get<std::vector<std::string>>());
    return body;
}

std::string base64(std::string_view bytes)
{
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) { return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u; };
        const unsigned three = byte(0) << 16 | byte(1) << 8 | byte(2);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63u];
    }
    return text;
}

std::string maps(const std::vector<ReportPicture>& pictures)
{
    std::string body;
    for (const ReportPicture& picture : pictures)
        body += fmt::format("<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n",
                            escaped_markup(picture.caption), base64(png_bytes(picture.image)));
    return body;
}

/// A chart of those series that are there and not all nothing; none if there are none.
std::string chart(const Json& series, const char* title, const char* unit, double factor,
                  const std::vector<std::pair<const char*, const char*>>& curves)
{
    LineChart chart{title, "time, s", unit, series["time_s"].get<std::vector<double>>(), {}};
    for (const auto& [key, name] : curves) {
        if (!series.contains(key)) continue;
        std::vector<double> values;
        for (const Json& value : series[key]) // null is what JSON has for a number that is none
            values.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN() : factor * value.get<double>());
        if (std::any_of(values.begin(), values.end(), [](double value) { return value != 0; })) chart.curves.push_back({name, values});
    }
    return chart.curves.empty() || chart.x.size() < 2 ? "" : "<figure>" + svg_of(chart) + "</figure>\n";
}

std::string charts(const Json& series)
{
    return chart(series, "Wetted radius", "mm", 1, {{"wetted_radius_top_mm", "top"}, {"wetted_radius_bottom_mm", "bottom"}}) +
           chart(series, "Height", "mm", 1, {{"wick_height_mm", "height"}}) +
           chart(series, "Water content near the middle", "%", 1,
                 {{"water_content_top_pct", "top"}, {"water_content_bottom_pct", "bottom"}}) +
           chart(series, "Where the water is", "mg", 1e3,
                 {{"free_water_g", "free"},
                  {"yarn_water_g", "in pores"},
                  {"bound_water_g", "in fibres"},
                  {"evaporated_g", "evaporated"},
                  {"dripped_g", "dripped"}}) +
           chart(series, "Water on the faces, over the start", "mg", 1e3, {{"water_top_g", "top"}, {"water_bottom_g", "bottom"}}) +
           chart(series, "Temperature", "°C", 1,
                 {{"temperature_min_c", "lowest"},
                  {"temperature_mean_c", "mean"},
                  {"temperature_max_c", "highest"},
                  {"air_temperature_c", "air"}}) +
           chart(series, "Mean regain", "kg/kg", 1, {{"regain_mean", "regain"}});
}

std::string derived(const FabricQuantities& q)
{
    return row("cover factor", rounded_text(q.cover_factor, 3), "") + row("areal density", rounded_text(q.areal_density_g_m2, 4), "g/m²") +
           row("thickness", rounded_text(q.thickness_mm, 3), "mm") + row("porosity", rounded_text(q.porosity, 3), "") +
           row("fibres in the yarn layer", rounded_text(q.fibre_volume_fraction, 3), "m³/m³") +
           row("gap between ends", rounded_text(q.gap_warp_mm, 3), "mm") + row("gap between picks", rounded_text(q.gap_weft_mm, 3), "mm") +
           row("smoothness", rounded_text(q.smoothness, 3), "");
}

std::string derived(const char* which, const YarnQuantities& q)
{
    const std::string yarn = std::string(which) + ", ";
    return row(yarn + "linear density", rounded_text(q.linear_density_tex, 3), "tex") +
           row(yarn + "section", rounded_text(q.section_mm.width, 3) + " x " + rounded_text(q.section_mm.height, 3), "mm") +
           row(yarn + "fibre share", rounded_text(q.packing_factor_in_fabric, 3), "m³/m³") +
           row(yarn + "crimp", rounded_text(q.crimp_percent, 3), "%") + row(yarn + "pore radius", rounded_text(q.pore_radius_um, 3), "µm") +
           row(yarn + "contact angle", rounded_text(q.contact_angle_deg, 3), "°");
}

/// The materials and the liquid that the run used, also where the project takes them from the library.
Design with_what_was_used(const RunRecord& run, const Fabric& fabric, const Experiment& experiment)
{
    Design used;
    const auto add = [&](const Yarn& yarn) {
        for (const MaterialShare& share : yarn.material) {
            const Material* material = find_material(run.design, share.name);
            const auto is_there = [&](const Material& other) { return other.name == share.name; };
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

std::string input(const RunRecord& run)
{
    const FabricQuantities& q = run.textile.quantities;
    std::string body = table(derived(q) + derived("warp", q.warp) + derived("weft", q.weft)) + list(q.notes);
    const Fabric* fabric = find_fabric(run.design, run.fabric);
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    if (!fabric || !experiment) return body;
    const Json project = json_from_design(with_what_was_used(run, *fabric, *experiment));
    constexpr std::pair<const char*, const char*> parts[] = {
        {"fabrics", "Fabric"}, {"materials", "Fibres"}, {"experiments", "Experiment"}, {"liquids", "Liquid"}};
    for (const auto& [key, name] : parts)
        for (const Json& value : project.value(key, Json::array()))
            body +=
                fmt::format("<details open><summary>{}</summary><pre>{}</pre></details>\n", name, escaped_markup(text_from_json(value)));
    return body;
}

/// The parts of the physics, and why each was modelled or not.
std::string parts(const RunRecord& run)
{
    std::string rows;
    for (const PlannedPart& part : run.plan.parts)
        rows += fmt::format("<tr><th>{}</th><td>{}</td><td>{}</td></tr>\n", escaped_markup(part.name), part.on ? "on" : "off",
                            escaped_markup(part.reason));
    std::vector<std::string> sentences;
    for (const SwitchedPart& part : run.switched_on) sentences.push_back(hygroloom::in_words(part));
    return table(rows) + list(sentences);
}

/// What the user set otherwise than the fidelity has it.
std::string knobs(const ModelPlan& plan)
{
    const Knobs usual = knobs_of(plan.fidelity);
    std::string rows;
    for (const KnobInfo& knob : knob_table()) {
        const double value = plan.knobs.*knob.value;
        if (value != usual.*knob.value)
            rows += row(knob.name, fmt::format("{:.6g}", value), fmt::format("{} (in place of {:.6g})", knob.unit, usual.*knob.value));
    }
    return rows.empty() ? "" : "<p>Set otherwise than this fidelity has it:</p>\n" + table(rows);
}

std::string origin(Json provenance, const RunRecord& run, bool finished)
{
    provenance.erase("simulated");
    if (!finished) provenance.erase("wall_s"); // not known
    std::string rows = rows_of(provenance);
    if (run.plan.expected_error) rows += row("error to be expected", rounded_text(100 * *run.plan.expected_error, 2), "%");
    if (!run.date.empty()) rows += row("began", run.date, "");
    return table(rows) + knobs(run.plan) + parts(run) + list(notes_of(run.plan));
}

} // namespace

std::string report_html(const RunRecord& run, const Metrics& metrics, const std::vector<ReportPicture>& pictures, bool finished)
{
    const Json json = Json::parse(metrics_json(run, metrics));
    const std::string title = escaped_markup(run.fabric + ", " + run.experiment);
    return fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
                       "content=\"width=device-width\">\n<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n"
                       "<p>Simulated, not measured.{2}</p>\n",
                       title, style, finished ? "" : fmt::format(" The run was cut short at {:.4g} s.", metrics.ledger.time)) +
           section("Results", results(json["metrics"])) + section("Maps", maps(pictures)) + section("Over time", charts(json["series"])) +
           section("Balance", table(rows_of(json["ledger"]))) + section("What went in", input(run)) +
           section("How it was computed", origin(json["provenance"], run, finished)) + "</body>\n</html>\n";
}

} // namespace hygroloom
