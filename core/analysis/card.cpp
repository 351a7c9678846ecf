// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/card.h"

#include "core/analysis/report_inputs.h"
#include "core/base/moment.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/base/version.h"
#include "core/project/mesh_file.h"
#include "core/project/project_file.h"
#include "core/project/texture_files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

/// As reports name the program.
std::string made_by() { return fmt::format("Hygroloom {} ({})", program_version(), program_commit()); }

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json yarn_json(const YarnUse& use)
{
    return {{"yarn", name_of(use)},
            {"share", use.share},
            {"linear_density_tex", use.tex},
            {"crimp_percent", use.crimp_percent},
            {"take_up_percent", use.take_up_percent()},
            {"g_per_m", use.grams_per_metre},
            {"cost_per_m", or_null(use.cost_per_metre)}};
}

Json loom_json(const LoomState& loom)
{
    return {{"reed_width_cm", or_null(loom.reed_width_cm)},
            {"ends_per_cm", or_null(loom.ends_per_cm)},
            {"picks_per_cm", or_null(loom.picks_per_cm)},
            {"dents_per_10_cm", or_null(loom.dents_per_10_cm)},
            {"width_shrinks_percent", or_null(loom.width_shrinks_percent)},
            {"length_shrinks_percent", or_null(loom.length_shrinks_percent)}};
}

std::string text(double value) { return rounded_text(value, 3); }

void add_if(std::vector<PageRow>& rows, const char* name, const std::optional<double>& value, const char* unit)
{
    if (value) rows.push_back(row(name, rounded_text(*value, 4), unit));
}

PageBlocks consumption_table(const Card& card)
{
    std::vector<PageRow> rows;
    for (const YarnUse& use : card.technical.yarns) {
        std::string remark =
            fmt::format("{:.3g} % of the threads, {:.3g} tex, take-up {:.3g} %", 100 * use.share, use.tex, use.take_up_percent());
        if (use.cost_per_metre) remark += fmt::format(", costs {:.4g} a metre", *use.cost_per_metre);
        if (card.length_m > 0) remark += fmt::format(", {:.4g} kg for {:g} m", 1e-3 * use.grams_per_metre * card.length_m, card.length_m);
        rows.push_back(row(name_of(use), rounded_text(use.grams_per_metre, 4), "g/m", remark));
    }
    rows.push_back(row("Together", rounded_text(card.technical.grams_per_metre, 4), "g/m"));
    add_if(rows, "Yarn cost", card.technical.yarn_cost_per_metre, "a metre");
    return joined({table(rows), list(card.technical.notes)});
}

PageBlocks laboratory_table(const Card& card)
{
    std::vector<PageRow> rows;
    for (const LaboratoryNumber& number : card.numbers) {
        const Estimate& in = number.estimate;
        std::string remark = in.low < in.high ? fmt::format("{} to {}", text(in.low), text(in.high)) : std::string();
        for (const std::string& more :
             {number.standard, number.conditions, number.model.empty() ? std::string() : "Compared: " + number.model})
            if (!more.empty()) remark += (remark.empty() ? "" : "; ") + more;
        rows.push_back(row(number.title, text(in.value), number.unit, remark));
    }
    return table(rows);
}

} // namespace

std::string name_of(const YarnUse& use)
{
    const std::string system = use.warp ? "warp" : "weft";
    return use.yarn == 0 ? system : fmt::format("{}, extra yarn {}", system, use.yarn);
}

std::vector<PageRow> construction_rows(const Card& card)
{
    const FabricQuantities& q = card.quantities;
    const LoomState& loom = card.technical.loom;
    std::vector<PageRow> rows{row("Ends, finished", text(card.ends_per_cm), "/cm"), row("Picks, finished", text(card.picks_per_cm), "/cm")};
    add_if(rows, "Ends on the loom", loom.ends_per_cm, "/cm");
    add_if(rows, "Picks on the loom", loom.picks_per_cm, "/cm");
    add_if(rows, "Reed", loom.dents_per_10_cm, "dents/10 cm");
    add_if(rows, "Reed width", loom.reed_width_cm, "cm");
    add_if(rows, "Shrinks in width", loom.width_shrinks_percent, "%");
    add_if(rows, "Shrinks in length", loom.length_shrinks_percent, "%");
    rows.push_back(row("Width, finished", rounded_text(card.technical.width_cm, 4), "cm"));
    rows.push_back(row("Ends, all", fmt::format("{:.0f}", card.technical.ends), ""));
    for (const auto& [name, yarn] : {std::pair("Warp", &q.warp), std::pair("Weft", &q.weft)}) {
        rows.push_back(row(fmt::format("{}: count", name), text(yarn->linear_density_tex), "tex",
                           fmt::format("Ne {:.3g}", ne_from_tex(yarn->linear_density_tex))));
        rows.push_back(row(fmt::format("{}: crimp", name), text(yarn->crimp_percent), "%"));
    }
    return rows;
}

Card card_of(const Design& design, const Fabric& fabric, const FittedFabric& fitted, const CardRequest& request)
{
    Card card;
    card.fabric = fabric.name;
    Design alone = design;
    alone.fabrics = {fabric};
    card.description = Json::parse(format_project(alone)).at("fabrics").at(0).dump();
    card.quantities = fitted.measured;
    card.ends_per_cm = fabric.ends_per_cm;
    card.picks_per_cm = fabric.picks_per_cm;
    card.technical = technical_card(fabric, fitted, request);
    card.length_m = request.length_m;
    card.made_at = date_now();
    const auto start = std::chrono::steady_clock::now();
    card.numbers = laboratory_numbers(design, fabric, fitted);
    card.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return card;
}

std::vector<ReportPicture> card_pictures(const Fabric& fabric, const FittedFabric& fitted)
{
    constexpr double side_mm = 20, most_mm = 100, dpi = 400;
    const TextileRegion one = region_of_repeats(fabric, 1, 1);
    const double wide = 10 * one.ends / fabric.ends_per_cm, high = 10 * one.picks / fabric.picks_per_cm; // mm
    if (wide > most_mm || high > most_mm) return {};
    const auto repeats = [](double mm) { return std::max(1, static_cast<int>(std::ceil(side_mm / mm))); };
    const Textile textile = build_textile(fabric, fitted, region_of_repeats(fabric, repeats(wide), repeats(high)));
    const TextureSize size = texture_size(textile, dpi);
    const TexturePixels pixels = texture_pixels(textile, fabric, size, 1);
    ReportPicture picture{fabric.name + ", top face", {pixels.columns, pixels.rows, {}}, size.width_mm};
    for (std::size_t i = 0; i < pixels.colour.size(); i += 4)
        for (std::size_t part = 0; part < 3; ++part) {
            const int opacity = pixels.colour[i + 3], white = 255;
            picture.image.rgb.push_back(static_cast<std::uint8_t>((pixels.colour[i + part] * opacity + white * (white - opacity)) / white));
        }
    return {picture};
}

Json laboratory_json(const std::vector<LaboratoryNumber>& numbers)
{
    Json json = Json::object();
    for (const LaboratoryNumber& number : numbers)
        json[number.key] = {
            {"value", number.estimate.value}, {"low", number.estimate.low},      {"high", number.estimate.high}, {"unit", number.unit},
            {"standard", number.standard},    {"conditions", number.conditions}, {"compared", number.model}};
    return json;
}

Json card_json(const Card& card)
{
    Json yarns = Json::array();
    for (const YarnUse& use : card.technical.yarns) yarns.push_back(yarn_json(use));
    const FabricQuantities& q = card.quantities;
    return {{"format", "hygroloom-card"},
            {"version", 1},
            {"program", made_by()},
            {"fabric", card.fabric},
            {"construction",
             {{"ends_per_cm", card.ends_per_cm},
              {"picks_per_cm", card.picks_per_cm},
              {"width_cm", card.technical.width_cm},
              {"ends", card.technical.ends},
              {"areal_density_g_m2", q.areal_density_g_m2},
              {"thickness_mm", q.thickness_1kpa_mm},
              {"loom", loom_json(card.technical.loom)},
              {"yarns", yarns},
              {"g_per_m", card.technical.grams_per_metre},
              {"yarn_cost_per_m", or_null(card.technical.yarn_cost_per_metre)},
              {"notes", card.technical.notes}}},
            {"laboratory", laboratory_json(card.numbers)},
            {"seconds", card.seconds}};
}

std::string card_csv(const Card& card)
{
    std::string csv = "key,title,value,low,high,unit,standard,conditions\n";
    const auto line = [&](const std::string& key, const std::string& title, const Estimate& in, const std::string& unit,
                          const std::string& standard, const std::string& conditions) {
        csv += fmt::format("{},{},{},{},{},{},{},{}\n", key, csv_field(title), in.value, in.low, in.high, csv_field(unit),
                           csv_field(standard), csv_field(conditions));
    };
    const auto exact = [](double value) { return Estimate{value, value, value}; };
    for (const YarnUse& use : card.technical.yarns) line("yarn_g_per_m", name_of(use), exact(use.grams_per_metre), "g/m", "", "");
    line("yarn_g_per_m", "together", exact(card.technical.grams_per_metre), "g/m", "", "");
    if (card.technical.yarn_cost_per_metre)
        line("yarn_cost_per_m", "Yarn cost", exact(*card.technical.yarn_cost_per_metre), "a metre", "", "");
    for (const LaboratoryNumber& number : card.numbers)
        line(number.key, number.title, number.estimate, number.unit, number.standard, number.conditions);
    return csv;
}

ReportPage card_page(const Card& card, const std::vector<ReportPicture>& pictures)
{
    const char* about =
        "Computed from the drawn cloth, not measured. The range after a value holds what the description leaves open and the error of the "
        "computation, not what the physics leaves out. Where a number was compared with measurements, it says so.";
    return {card.fabric,
            joined({sentence(fmt::format("Technical card. {}, {}", made_by(), card.made_at)),
                    pictures.empty() ? sentence("No picture: a repeat is more than 10 cm wide or high.") : blocks_of(pictures),
                    section("Construction", table(construction_rows(card))), section("Yarn for a metre", consumption_table(card)),
                    section("Laboratory", joined({sentence(about), laboratory_table(card)})),
                    table_of_inputs("The fabric as the project has it", Json::parse(card.description))})};
}

} // namespace hygroloom
