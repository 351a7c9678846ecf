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

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string_view>
#include <tuple>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char *cost_key = "cost_per_m", *cost_title = "Yarn cost of a metre";

/// As reports name the program.
std::string made_by() { return fmt::format("Hygroloom {} ({})", program_version(), program_commit()); }

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json yarn_json(const YarnConsumption& use)
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

/// A number of the construction; key: as the card's CSV has it.
struct ConstructionNumber {
    std::string key, title;
    double value = 0;
    const char* unit = "";
    int digits = 3;
    std::string remark{};
};

std::vector<ConstructionNumber> construction_numbers(const Card& card)
{
    std::vector<ConstructionNumber> all{{"ends_per_cm", "Ends, finished", card.ends_per_cm, "/cm"},
                                        {"picks_per_cm", "Picks, finished", card.picks_per_cm, "/cm"}};
    const LoomState& loom = card.technical.loom;
    const auto add_if = [&](const char* key, const char* title, const std::optional<double>& value, const char* unit) {
        if (value) all.push_back({key, title, *value, unit, unit == std::string_view("%") ? 3 : 4});
    };
    add_if("loom_ends_per_cm", "Ends on the loom", loom.ends_per_cm, "/cm");
    add_if("loom_picks_per_cm", "Picks on the loom", loom.picks_per_cm, "/cm");
    add_if("loom_dents_per_10_cm", "Reed", loom.dents_per_10_cm, "dents/10 cm");
    add_if("loom_reed_width_cm", "Reed width", loom.reed_width_cm, "cm");
    add_if("loom_width_shrinks_percent", "Shrinks in width", loom.width_shrinks_percent, "%");
    add_if("loom_length_shrinks_percent", "Shrinks in length", loom.length_shrinks_percent, "%");
    all.push_back({"width_cm", "Width, finished", card.technical.width_cm, "cm", 4});
    constexpr int whole = 1; // digits of a whole number
    all.push_back({"ends", "Ends, all", card.technical.ends, "", whole});
    const FabricQuantities& q = card.quantities;
    for (const auto& [key, name, yarn] : {std::tuple("warp", "Warp", &q.warp), std::tuple("weft", "Weft", &q.weft)}) {
        all.push_back({fmt::format("{}_linear_density_tex", key), fmt::format("{}: count", name), yarn->linear_density_tex, "tex", 3,
                       fmt::format("Ne {}", rounded_text(ne_from_tex(yarn->linear_density_tex), 3))});
        all.push_back({fmt::format("{}_crimp_percent", key), fmt::format("{}: crimp", name), yarn->crimp_percent, "%"});
    }
    return all;
}

PageBlocks consumption_table(const Card& card, const ReaderUnits& units)
{
    const ReaderUnit count = reader_unit(units, "tex");
    const double length_m = told_length_m(card);
    const auto number = [](double value, int digits) { return PageCell{rounded_text(value, digits), PageCell::Kind::number}; };
    const bool costs = has_prices(card);
    std::vector<std::string> headings{
        "yarn", "count, " + count.unit, "share, %", "take-up, %", "g/m", fmt::format("kg for {:g} m", length_m)};
    if (costs) headings.emplace_back("cost of 1 m");
    PageRow head;
    for (const std::string& heading : headings) // as its numbers are
        head.push_back({heading, head.empty() ? PageCell::Kind::heading : PageCell::Kind::number});
    std::vector<PageRow> rows{std::move(head)};
    for (const YarnConsumption& use : card.technical.yarns) {
        PageRow line{
            {name_of(use), PageCell::Kind::heading}, number(count.of(use.tex), 3),   number(100 * use.share, 3),
            number(use.take_up_percent(), 3),        number(use.grams_per_metre, 4), number(1e-3 * use.grams_per_metre * length_m, 4)};
        if (costs) line.push_back(use.cost_per_metre ? number(*use.cost_per_metre, 3) : PageCell{"no price", PageCell::Kind::number});
        rows.push_back(std::move(line));
    }
    PageRow sum{{"together", PageCell::Kind::heading, {}, {}, 4},
                number(card.technical.grams_per_metre, 4),
                number(1e-3 * card.technical.grams_per_metre * length_m, 4)};
    if (const auto& cost = card.technical.yarn_cost_per_metre) sum.push_back(number(*cost, 3));
    rows.push_back(std::move(sum));
    const char* about = "The share is that of the threads of warp or weft; the take-up is of the yarn's length.";
    const char* currency = " Costs are in the currency in which the yarns' prices for a kilogram are given.";
    return joined({table(rows), sentence(std::string(about) + (costs ? currency : ""))});
}

/// Each sentence once, in their order.
std::vector<std::string> comparisons(const std::vector<LaboratoryNumber>& numbers)
{
    std::vector<std::string> said;
    for (const LaboratoryNumber& number : numbers)
        if (!number.model.empty() && std::find(said.begin(), said.end(), number.model) == said.end()) said.push_back(number.model);
    return said;
}

PageBlocks laboratory_table(const Card& card, const ReaderUnits& units)
{
    std::vector<PageRow> rows{row_of_headings({"number", "value", "unit", "range", "standard and conditions"})};
    rows.front()[1].kind = PageCell::Kind::number;
    for (const LaboratoryNumber& number : card.numbers.found) {
        const LaboratoryNumber seen = in_units(number, units);
        std::string remark;
        for (const std::string& more :
             {grade_text(number), number.standard, number.conditions, number.run.empty() ? std::string() : "run: " + number.run})
            if (!more.empty()) remark += (remark.empty() ? "" : "; ") + more;
        rows.push_back(row(number.title, value_text(seen), seen.unit, range_text(seen.estimate)));
        rows.back().resize(4);
        rows.back().push_back({remark});
    }
    return joined({table(rows), list(sentences_below(card))});
}

/// Of the table, see card_csv().
std::string line_of(const LaboratoryNumber& number)
{
    const Estimate& in = number.estimate;
    const std::string values = number.text.empty() ? fmt::format("{},{},{}", in.value, in.low, in.high) : csv_field(number.text) + ",,";
    return fmt::format("{},{},{},{},{},{},{}\n", number.key, csv_field(number.title), values, csv_field(number.unit),
                       csv_field(number.standard), csv_field(number.conditions), csv_field(number.run));
}

/// The same cloth seen from behind: what lay on top lies below, and the first end is the last.
Fabric turned_over(const Fabric& fabric)
{
    const Weave& weave = fabric.weave;
    std::vector<std::uint8_t> up;
    for (int pick = 0; pick < weave.picks(); ++pick)
        for (int end = weave.ends() - 1; end >= 0; --end) up.push_back(weave.warp_up(end, pick) ? 0 : 1);
    Fabric turned = fabric;
    turned.weave = Weave(weave.ends(), weave.picks(), std::move(up));
    std::reverse(turned.warp_order.begin(), turned.warp_order.end());
    return turned;
}

constexpr int per_side = 3; // of a pixel, so many of the texture: else fine cloth would have stripes that it has not

/// Red, green and blue, 0 to 255, of the texture's pixels from a place on: over white, in light from the upper left.
std::array<double, 3> seen_in(const TexturePixels& pixels, int column, int row)
{
    constexpr double light[] = {-0.45, 0.45, 0.77}, ambient = 0.35, white = 255;
    std::array<double, 3> sum{};
    for (int y = row; y < row + per_side; ++y)
        for (int x = column; x < column + per_side; ++x) {
            const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.columns) + static_cast<std::size_t>(x);
            double facing = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) facing += light[axis] * (pixels.normal[3 * pixel + axis] / 127.5 - 1);
            const double lit = std::min(1.0, ambient + (1 - ambient) * std::max(0.0, facing) / light[2]);
            const double opacity = pixels.colour[4 * pixel + 3] / white;
            for (std::size_t part = 0; part < 3; ++part)
                sum[part] += (opacity * lit * pixels.colour[4 * pixel + part] + (1 - opacity) * white) / (per_side * per_side);
        }
    return sum;
}

/// As many repeats as make it so wide and high at least.
ReportPicture picture_of(const Fabric& fabric, const FittedFabric& fitted, double side_mm, double dpi, const std::string& caption)
{
    const TextileRegion one = region_of_repeats(fabric, 1, 1);
    const auto repeats = [side_mm](double mm) { return std::max(1, static_cast<int>(std::ceil(side_mm / mm))); };
    const TextileRegion shown =
        region_of_repeats(fabric, repeats(10 * one.ends / fabric.ends_per_cm), repeats(10 * one.picks / fabric.picks_per_cm));
    const Textile textile = build_textile(fabric, fitted, shown);
    const TextureSize size = texture_size(textile, per_side * dpi);
    const TexturePixels pixels = texture_pixels(textile, fabric, size, 1);
    ReportPicture picture{caption, {pixels.columns / per_side, pixels.rows / per_side, {}}, 0};
    picture.width_mm = size.width_mm * picture.image.width * per_side / pixels.columns;
    for (int row = 0; row < picture.image.height; ++row)
        for (int column = 0; column < picture.image.width; ++column)
            for (const double value : seen_in(pixels, per_side * column, per_side * row))
                picture.image.rgb.push_back(static_cast<std::uint8_t>(std::lround(value)));
    return picture;
}

} // namespace

std::string name_of(const YarnConsumption& use)
{
    const std::string system = use.warp ? "warp" : "weft";
    return use.yarn == 0 ? system : fmt::format("{}, extra yarn {}", system, use.yarn);
}

double told_length_m(const Card& card)
{
    constexpr double usual = 100;
    return card.length_m > 0 ? card.length_m : usual;
}

bool has_prices(const Card& card)
{
    const auto& yarns = card.technical.yarns;
    return std::any_of(yarns.begin(), yarns.end(), [](const YarnConsumption& use) { return use.cost_per_metre.has_value(); });
}

std::vector<std::string> sentences_below(const Card& card)
{
    std::vector<std::string> all = card.technical.notes;
    for (const auto& some : {comparisons(card.numbers.found), card.numbers.missing, card.numbers.notes})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

LaboratoryNumber in_units(LaboratoryNumber number, const ReaderUnits& units)
{
    const ReaderUnit unit = reader_unit(units, number.unit);
    Estimate& of = number.estimate;
    of = {unit.of(of.value), unit.of(of.low), unit.of(of.high)};
    if (unit.inverse) std::swap(of.low, of.high);
    number.unit = unit.unit;
    return number;
}

std::string value_text(const LaboratoryNumber& number)
{
    return number.text.empty() ? rounded_text(number.estimate.value, 3) : number.text;
}

std::string grade_text(const LaboratoryNumber& number)
{
    return number.grade > 0 ? fmt::format("grade {} of 5", number.grade) : std::string();
}

std::string range_text(const Estimate& estimate)
{
    if (!(estimate.low < estimate.high)) return {};
    return fmt::format("{} to {}", rounded_text(estimate.low, 3), rounded_text(estimate.high, 3));
}

std::vector<PageRow> construction_rows(const Card& card, const ReaderUnits& units)
{
    std::vector<PageRow> rows;
    for (const ConstructionNumber& number : construction_numbers(card)) {
        const ReaderUnit unit = reader_unit(units, number.unit);
        rows.push_back(row(number.title, rounded_text(unit.of(number.value), number.digits), unit.unit, number.remark));
    }
    return rows;
}

Card card_without_numbers(const Design& design, const Fabric& fabric, const FittedFabric& fitted, const CardRequest& request)
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
    return card;
}

Card card_of(const Design& design, const Fabric& fabric, const FittedFabric& fitted, const CardRequest& request)
{
    Card card = card_without_numbers(design, fabric, fitted, request);
    const auto start = std::chrono::steady_clock::now();
    card.numbers = laboratory_numbers(design, fabric, fitted);
    card.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return card;
}

const std::vector<OutcomeInfo>& card_metrics()
{
    static const std::vector<OutcomeInfo> infos = [] {
        std::vector<OutcomeInfo> all;
        for (const LaboratoryNumber& number : numbers_of_cards()) all.push_back({number.key, number.title, "", number.unit});
        all.push_back({cost_key, cost_title, "", "", Better::less});
        return all;
    }();
    return infos;
}

LaboratoryNumbers compared_numbers(const Design& design, const Fabric& fabric, const FittedFabric& fitted)
{
    LaboratoryNumbers numbers = laboratory_numbers(design, fabric, fitted);
    const TechnicalCard card = technical_card(fabric, fitted);
    if (const auto& cost = card.yarn_cost_per_metre)
        numbers.found.push_back(
            {cost_key, cost_title, "", "", fmt::format("{:.4g} cm wide, without waste", card.width_cm), {*cost, *cost, *cost}, ""});
    return numbers;
}

std::vector<ReportPicture> card_pictures(const Design& design, const Fabric& fabric, const FittedFabric& fitted)
{
    constexpr double side_mm = 20, most_mm = 100, fine_mm = 40, fine_dpi = 400, near_mm = 3, near_dpi = 2400;
    const TextileRegion one = region_of_repeats(fabric, 1, 1);
    const double wide = 10 * one.ends / fabric.ends_per_cm, high = 10 * one.picks / fabric.picks_per_cm; // mm
    if (wide > most_mm || high > most_mm) return {};
    const double dpi = fine_dpi * std::min(1.0, fine_mm / std::max(wide, high)); // of large repeats less: they take long
    const Fabric turned = turned_over(fabric);
    const FittedFabric behind = fit_fabric(design, turned);
    std::vector<ReportPicture> pictures{picture_of(fabric, fitted, side_mm, dpi, fabric.name + ", top face"),
                                        picture_of(turned, behind, side_mm, dpi, fabric.name + ", back, turned over about its ends")};
    if (std::max(wide, high) > 4 * near_mm) return pictures;
    pictures.push_back(picture_of(fabric, fitted, near_mm, near_dpi, fabric.name + ", top face"));
    ReportPicture& near = pictures.back();
    near.caption += fmt::format(", {} mm wide", rounded_text(near.width_mm, 2));
    near.width_mm = 0;
    return pictures;
}

Json laboratory_json(const std::vector<LaboratoryNumber>& numbers)
{
    Json json = Json::object();
    for (const LaboratoryNumber& number : numbers) {
        Json& own = json[number.key];
        if (number.text.empty())
            own = {{"value", number.estimate.value}, {"low", number.estimate.low}, {"high", number.estimate.high}};
        else
            own = {{"value", number.text}, {"low", nullptr}, {"high", nullptr}};
        own.update({{"unit", number.unit},
                    {"standard", number.standard},
                    {"conditions", number.conditions},
                    {"compared", number.model},
                    {"run", number.run}});
        if (number.grade > 0) own["grade"] = number.grade;
    }
    return json;
}

Json card_json(const Card& card)
{
    Json yarns = Json::array();
    for (const YarnConsumption& use : card.technical.yarns) yarns.push_back(yarn_json(use));
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
            {"laboratory", laboratory_json(card.numbers.found)},
            {"missing", card.numbers.missing},
            {"notes", card.numbers.notes},
            {"seconds", card.seconds}};
}

std::string card_csv(const Card& card)
{
    std::string csv = "key,title,value,low,high,unit,standard,conditions,run\n";
    const auto line = [&](const std::string& key, const std::string& title, const Estimate& in, const std::string& unit,
                          const std::string& standard, const std::string& conditions) {
        csv += fmt::format("{},{},{},{},{},{},{},{},\n", key, csv_field(title), in.value, in.low, in.high, csv_field(unit),
                           csv_field(standard), csv_field(conditions));
    };
    const auto exact = [](double value) { return Estimate{value, value, value}; };
    const char* currency = "in the currency of the yarns' prices";
    const auto kilograms = [&](const std::string& title, double grams_per_metre) {
        const double length_m = told_length_m(card);
        line("yarn_kg", title, exact(1e-3 * grams_per_metre * length_m), "kg", "", fmt::format("for {:g} m", length_m));
    };
    for (const ConstructionNumber& number : construction_numbers(card))
        line(number.key, number.title, exact(number.value), number.unit, "", number.remark);
    for (const YarnConsumption& use : card.technical.yarns) {
        line("yarn_share_percent", name_of(use), exact(100 * use.share), "%", "", "of the system's threads");
        line("yarn_linear_density_tex", name_of(use), exact(use.tex), "tex", "", "");
        line("yarn_take_up_percent", name_of(use), exact(use.take_up_percent()), "%", "", "");
        line("yarn_g_per_m", name_of(use), exact(use.grams_per_metre), "g/m", "", "");
        kilograms(name_of(use), use.grams_per_metre);
        if (use.cost_per_metre)
            line("yarn_cost_per_m", name_of(use), exact(*use.cost_per_metre), "per m", "", currency);
        else if (has_prices(card))
            csv += fmt::format("yarn_cost_per_m,{},,,,per m,,no price,\n", csv_field(name_of(use)));
    }
    line("yarn_g_per_m", "together", exact(card.technical.grams_per_metre), "g/m", "", "");
    kilograms("together", card.technical.grams_per_metre);
    if (const auto& cost = card.technical.yarn_cost_per_metre) line("yarn_cost_per_m", "together", exact(*cost), "per m", "", currency);
    for (const LaboratoryNumber& number : card.numbers.found) csv += line_of(number);
    const std::vector<std::string>& missing = card.numbers.missing;
    for (const std::string& sentence : sentences_below(card)) {
        const bool is_missing = std::find(missing.begin(), missing.end(), sentence) != missing.end();
        csv += fmt::format("{},{},,,,,,,\n", is_missing ? "missing" : "note", csv_field(sentence));
    }
    return csv;
}

ReportPage card_page(const Card& card, const std::vector<ReportPicture>& pictures, const ReaderUnits& units)
{
    constexpr std::size_t day = 10; // letters of a date
    const char* about =
        "Computed from the drawn cloth, not measured. The range after a value holds what the description leaves open and the error of the "
        "computation, not what the physics leaves out; of a test that ran once, the error of the computation alone. Below the numbers "
        "stands how far off they were where they were compared with measurements.";
    return {card.fabric, joined({sentence(fmt::format("Technical card of {}. {}", card.made_at.substr(0, day), made_by())),
                                 pictures.empty() ? sentence("No picture: a repeat is more than 10 cm wide or high.") : blocks_of(pictures),
                                 section("Construction", table(construction_rows(card, units))),
                                 section("Yarn for a metre", consumption_table(card, units)),
                                 section("Laboratory", joined({sentence(about), laboratory_table(card, units)})),
                                 table_of_inputs("The fabric as the project has it", Json::parse(card.description))})};
}

} // namespace hygroloom
