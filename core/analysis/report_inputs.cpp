// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Numbers by the labels of their rows, with the unit that their key ends in.
#include "core/analysis/report_inputs.h"

#include "core/base/text.h"
#include "core/base/trade_units.h"
#include "core/design/field_labels.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace hygroloom {
namespace {

/// Those whose key says too little or too much.
constexpr std::pair<const char*, const char*> own_words[] = {
    {"closure", "wicking model"}, {"at_mm", "place"}, {"color", "colour"}, {"material", "fibre"}};

/// Those of two lengths that are a place, not a size.
constexpr const char* places[] = {"at_mm", "outline_mm"};

struct KeyWords {
    std::string name, unit;
    bool is_size = false; ///< two numbers are its width and height
};

KeyWords words_of(const std::string& key)
{
    const std::string_view unit = trade_units(stored_kind(key)).front().spellings.front();
    KeyWords words{label_of_key(key), std::string(unit)};
    if (words.name.empty()) words.name = key.ends_with("_mm") ? key.substr(0, key.size() - 3) : key;
    for (const auto& [from, to] : own_words)
        if (key == from) words.name = to;
    words.is_size = words.unit == "mm" && std::find(std::begin(places), std::end(places), key) == std::end(places);
    std::replace(words.name.begin(), words.name.end(), '_', ' ');
    return words;
}

class Writer {
public:
    explicit Writer(const ReaderUnits& units) : units_(units) {}

    std::vector<std::pair<std::string, std::string>> rows;

    void add(const ProjectJson& value, const std::string& before)
    {
        for (const auto& [key, member] : value.items()) {
            const KeyWords words = words_of(key);
            const std::string own = key != "*" ? words.name : value.size() > 1 ? "all others" : "all"; // panels of a garment
            const std::string name = before.empty() ? own : before + ", " + own;
            if (member.is_object())
                add(member, name);
            else if (std::string said = text(member, words); !said.empty()) {
                if (key == "type") std::replace(said.begin(), said.end(), '_', ' '); // no name that somebody gave
                rows.emplace_back(name, std::move(said));
            }
        }
    }

private:
    std::string number(double value, const std::string& unit, bool with_unit = true) const
    {
        const ReaderUnit own = reader_unit(units_, unit);
        const std::string digits = brief_text(own.of(value), own.unit == unit ? 6 : 4); // converted ones have endlessly many
        if (!with_unit || own.unit.empty()) return digits;
        return digits + (own.unit == "°" ? "" : " ") + own.unit;
    }

    static bool is_share(const ProjectJson& value) { return value.is_object() && value.contains("name") && value.contains("share"); }

    /// "65 % polyester, 35 % cotton"; "15 × 20 mm" of a size and "15, 20 mm" of a place; of others their parts, in turn.
    std::string list(const ProjectJson& values, const KeyWords& words) const
    {
        std::string said;
        const bool numbers = std::all_of(values.begin(), values.end(), [](const ProjectJson& value) { return value.is_number(); });
        const bool is_size = words.is_size && numbers && values.size() == 2;
        for (const ProjectJson& value : values) {
            if (!said.empty()) said += is_size ? " × " : value.is_array() || (value.is_object() && !is_share(value)) ? "; " : ", ";
            if (is_share(value))
                said += fmt::format("{:.4g} % {}", 100 * value.at("share").get<double>(), value.at("name").get<std::string>());
            else if (value.is_number())
                said += number(value.get<double>(), words.unit, &value == &values.back());
            else
                said += text(value, words);
        }
        return said;
    }

    std::string text(const ProjectJson& value, const KeyWords& words) const
    {
        if (value.is_null()) return {};
        if (value.is_string()) return value.get<std::string>();
        if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
        if (value.is_number()) return number(value.get<double>(), words.unit);
        if (value.is_array()) return list(value, words);
        std::string said;
        for (const auto& [key, member] : value.items()) {
            const KeyWords own = words_of(key);
            if (const std::string part = text(member, own); !part.empty()) said += (said.empty() ? "" : ", ") + own.name + " " + part;
        }
        return said;
    }

    const ReaderUnits& units_;
};

} // namespace

std::vector<std::pair<std::string, std::string>> inputs_in_words(const ProjectJson& value, const ReaderUnits& units)
{
    Writer writer(units);
    writer.add(value, {});
    return std::move(writer.rows);
}

PageBlocks table_of_inputs(const char* title, const ProjectJson& value, const ReaderUnits& units)
{
    std::vector<PageRow> rows;
    for (const auto& [name, text] : inputs_in_words(value, units)) rows.push_back({{name, PageCell::Kind::heading}, {text}});
    return section(title, table(rows), 3);
}

} // namespace hygroloom
