// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/page.h"

#include "core/base/base64.h"
#include "core/base/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kinds[] = {"text", "number", "heading"}; // as PageCell::Kind has them

Json json_of_cell(const PageCell& cell)
{
    Json json{{"text", cell.text}, {"kind", kinds[static_cast<std::size_t>(cell.kind)]}};
    if (!cell.strong.empty()) json["strong"] = cell.strong;
    if (!cell.below.empty()) json["below"] = cell.below;
    if (cell.columns > 1) json["columns"] = cell.columns;
    return json;
}

struct JsonWriter {
    Json operator()(const PageHeading& heading) const { return {{"heading", heading.text}, {"level", heading.level}}; }
    Json operator()(const PageText& block) const { return {{"text", block.text}, {"strong", block.strong}}; }
    Json operator()(const PageList& block) const { return {{"list", block.sentences}}; }
    Json operator()(const PageTable& block) const
    {
        Json rows = Json::array();
        for (const PageRow& row : block.rows) {
            rows.push_back(Json::array());
            for (const PageCell& cell : row) rows.back().push_back(json_of_cell(cell));
        }
        return {{"table", rows}};
    }
    Json operator()(const PageDrawing& block) const { return {{"drawing", block.svg}, {"caption", block.caption}}; }
    Json operator()(const PagePicture& block) const
    {
        return {{"picture", base64_of(block.png)}, {"caption", block.caption}, {"width_mm", block.width_mm}};
    }
};

PageCell cell_from(const Json& json)
{
    PageCell cell{json.at("text")};
    const auto kind = std::find(std::begin(kinds), std::end(kinds), json.at("kind").get<std::string>());
    if (kind == std::end(kinds)) throw Error("A cell of the page has an unknown kind.");
    cell.kind = static_cast<PageCell::Kind>(kind - std::begin(kinds));
    cell.strong = json.value("strong", std::vector<std::string>());
    cell.below = json.value("below", "");
    cell.columns = json.value("columns", 1);
    return cell;
}

PageBlock block_from(const Json& json)
{
    if (json.contains("heading")) return PageHeading{json.at("heading"), json.at("level")};
    if (json.contains("list")) return PageList{json.at("list")};
    if (json.contains("drawing")) return PageDrawing{json.at("drawing"), json.at("caption")};
    if (json.contains("picture")) {
        const auto png = from_base64(json.at("picture").get<std::string>());
        if (!png) throw Error("A picture of the page is no base64.");
        return PagePicture{*png, json.at("caption"), json.value("width_mm", 0.0)};
    }
    if (!json.contains("table")) return PageText{json.at("text"), json.at("strong")};
    PageTable table;
    for (const Json& row : json.at("table")) {
        table.rows.emplace_back();
        for (const Json& cell : row) table.rows.back().push_back(cell_from(cell));
    }
    return table;
}

} // namespace

std::string json_of(const ReportPage& page)
{
    Json blocks = Json::array();
    for (const PageBlock& block : page.blocks) blocks.push_back(std::visit(JsonWriter(), block));
    return Json{{"title", page.title}, {"blocks", blocks}}.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

ReportPage page_from_json(const std::string& json)
try {
    const Json all = Json::parse(json);
    ReportPage page{all.at("title"), {}};
    for (const Json& block : all.at("blocks")) page.blocks.push_back(block_from(block));
    return page;
} catch (const Json::exception& error) {
    throw Error(std::string("This is no page of a report: ") + error.what());
}

} // namespace hygroloom
