// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A library's yarns as CSV, a row each.
#include "core/base/csv_table.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/project/color_text.h"
#include "core/project/field_json.h"
#include "core/project/library.h"
#include "core/project/project_json.h"

#include <charconv>

namespace hygroloom {
namespace {

std::vector<std::string> number_keys()
{
    std::vector<std::string> keys;
    for (const Field<Yarn>& field : fields_of<Yarn>()) keys.emplace_back(field.key);
    return keys;
}

std::string trimmed(const std::string& text)
{
    const auto first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
    return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

/// "a + b" -> "a", "b"
std::vector<std::string> parts_of(const std::string& text)
{
    std::vector<std::string> parts;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('+', at), text.size());
        if (const std::string part = trimmed(text.substr(at, end - at)); !part.empty()) parts.push_back(part);
        at = end + 1;
    }
    return parts;
}

/// "navy blue #101a40" -> "navy blue", "#101a40"; no blank: the second is empty.
std::pair<std::string, std::string> last_word_apart(const std::string& text)
{
    const std::size_t blank = text.rfind(' ');
    return blank == std::string::npos ? std::pair(text, std::string()) : std::pair(trimmed(text.substr(0, blank)), text.substr(blank + 1));
}

std::optional<double> number_of(const std::string& text)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// "cotton 60 + polyester 40"
ProjectJson material_json(const std::string& text)
{
    ProjectJson shares = ProjectJson::array();
    for (const std::string& part : parts_of(text)) {
        const auto [name, percent] = last_word_apart(part);
        if (const auto share = number_of(percent))
            shares.push_back({{"name", name}, {"share", *share / 100}});
        else
            shares.push_back({{"name", part}, {"share", 1.0}});
    }
    return shares;
}

std::string material_text(const Yarn& yarn)
{
    std::string text;
    for (const MaterialShare& part : yarn.material)
        text += (text.empty() ? "" : " + ") + (yarn.material.size() == 1 ? part.name : fmt::format("{} {:g}", part.name, 100 * part.share));
    return text;
}

std::string colours_text(const LibraryYarn& yarn)
{
    std::string text;
    for (const YarnColour& colour : yarn.colours) text += (text.empty() ? "" : " + ") + colour.name + " " + text_of(colour.color);
    return text;
}

/// A field of the table as the project file has it: a number or a word.
ProjectJson value_json(const std::string& text)
{
    const auto number = number_of(text);
    if (!number) return text;
    return *number == static_cast<int>(*number) ? ProjectJson(static_cast<int>(*number)) : ProjectJson(*number);
}

const std::vector<std::string>& columns()
{
    static const std::vector<std::string> all = [] {
        std::vector<std::string> names{"supplier", "material", "core", "count", "colours", "currency"};
        for (const std::string& key : number_keys()) names.push_back(key);
        return names;
    }();
    return all;
}

} // namespace

std::string csv_of_yarns(const std::vector<LibraryYarn>& yarns)
{
    std::string csv = "name,supplier,material,core";
    for (const std::string& key : number_keys()) csv += "," + key;
    csv += ",colours,currency\n";
    for (const LibraryYarn& each : yarns) {
        const Yarn& yarn = each.yarn();
        const std::string core = yarn.core ? fmt::format("{} {:g}", yarn.core->material, 100 * yarn.core->share) : std::string();
        csv += csv_field(each.name) + "," + csv_field(each.supplier) + "," + csv_field(material_text(yarn)) + "," + csv_field(core);
        for (const Field<Yarn>& field : fields_of<Yarn>()) {
            csv += ",";
            if (!field_value(field, yarn)) continue;
            const ProjectJson value = json_of_field(field, yarn);
            csv += value.is_string() ? value.get<std::string>() : value.dump();
        }
        csv += "," + csv_field(colours_text(each)) + "," + csv_field(each.currency) + "\n";
    }
    return csv;
}

std::vector<LibraryYarn> yarns_of_csv(const std::string& text, const std::string& file)
{
    const CsvTable table = read_csv(text, file, {"name"}, columns());
    std::vector<LibraryYarn> yarns;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const std::string at = fmt::format("line {}", table.lines[i]);
        const auto refuse = [&](const std::string& sentence) { throw Error(fmt::format("{}: {}: {}", file, at, sentence)); };
        const auto field = [&](const std::string& name) {
            const auto column = std::find(columns().begin(), columns().end(), name) - columns().begin();
            return trimmed(table.rows[i][static_cast<std::size_t>(column) + 1]);
        };
        if (table.rows[i][0].empty()) refuse("The yarn has no name.");
        ProjectJson json = ProjectJson::object();
        if (const std::string material = field("material"); !material.empty()) json["material"] = material_json(material);
        if (const std::string core = field("core"); !core.empty()) {
            const auto [name, percent] = last_word_apart(core);
            const auto share = number_of(percent);
            if (!share) refuse(fmt::format("core: This must be a fibre and its percent, such as \"elastane 5\"; given is \"{}\".", core));
            json["core"] = {{"material", name}, {"share", *share / 100}};
        }
        if (const std::string count = field("count"); !count.empty()) json["count"] = count;
        for (const std::string& key : number_keys())
            if (const std::string value = field(key); !value.empty()) json[key] = value_json(value);
        LibraryYarn yarn = library_yarn({}, yarn_from_json(json, file, at), table.rows[i][0]);
        yarn.supplier = field("supplier");
        yarn.currency = field("currency");
        for (const std::string& part : parts_of(field("colours"))) {
            const auto [name, code] = last_word_apart(part);
            const auto color = color_of(code);
            if (!color) refuse(fmt::format("colours: This must be a name and \"#rrggbb\"; given is \"{}\".", part));
            yarn.colours.push_back({name, *color});
        }
        keep_yarn(yarns, std::move(yarn));
    }
    return yarns;
}

} // namespace hygroloom
