// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A library's yarns as CSV, a row each.
#include "core/base/csv_table.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/words.h"
#include "core/design/validate.h"
#include "core/design/yarn_count.h"
#include "core/project/color_text.h"
#include "core/project/field_json.h"
#include "core/project/library.h"
#include "core/project/project_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

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

/// A comma is a decimal one where fields stand between semicolons.
std::optional<double> number_of(std::string text, bool by_semicolons)
{
    const std::size_t comma = text.find(',');
    if (by_semicolons && comma != std::string::npos && text.find('.') == std::string::npos) text[comma] = '.';
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// "cotton 60 + polyester 40"; a name alone is all of the yarn, also where it ends with a number, as "nylon 6.6".
ProjectJson material_json(const std::string& text, bool by_semicolons)
{
    ProjectJson shares = ProjectJson::array();
    for (const std::string& part : parts_of(text)) {
        const auto [name, percent] = last_word_apart(part);
        const auto share = find_library_material(part) ? std::nullopt : number_of(percent, by_semicolons);
        if (share)
            shares.push_back({{"name", name}, {"share", *share / 100}});
        else
            shares.push_back({{"name", part}, {"share", 1.0}});
    }
    return shares;
}

/// In which the trade counts spun yarns of the fibre that is most of it; tex where there is no custom.
CountSystem usual_system(const Yarn& yarn)
{
    using enum CountSystem;
    static const std::map<std::string, CountSystem> usual{{"cotton", ne}, {"wool", nm}, {"flax", nm}, {"hemp", nm}, {"silk", dtex}};
    const auto most = std::max_element(yarn.material.begin(), yarn.material.end(),
                                       [](const MaterialShare& a, const MaterialShare& b) { return a.share < b.share; });
    const auto found = most == yarn.material.end() ? usual.end() : usual.find(most->name);
    return found == usual.end() ? tex : found->second;
}

/// As the trade counts its fibre where it is read as it is so; else in the fewest digits.
std::optional<std::string> exact_count(const Yarn& yarn)
{
    if (!yarn.linear_density_tex) return {};
    using enum CountSystem;
    const auto digits = [](const std::string& text) {
        return std::count_if(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    };
    std::optional<std::string> best;
    const CountSystem usual = usual_system(yarn);
    const bool is_drawn = yarn.filament_count || usual == dtex;
    for (const CountSystem system : is_drawn ? std::array{denier, dtex, tex} : std::array{ne, tex, nm}) {
        const std::string text = count_text(*yarn.linear_density_tex, yarn.plies, yarn.filament_count, system);
        Yarn read = yarn;
        set_count(read, read_yarn_count(text));
        read.diameter_mm = yarn.diameter_mm;
        if (read != yarn) continue;
        if (!is_drawn && usual != tex && system == usual) return text;
        if (!best || digits(text) < digits(*best)) best = text;
    }
    return best;
}

std::string colours_text(const LibraryYarn& yarn)
{
    std::string text;
    for (const YarnColour& colour : yarn.colours) text += (text.empty() ? "" : " + ") + colour.name + " " + text_of(colour.color);
    return text;
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

/// Throws Error where the shares are not all of the yarn.
void require_all_of_it(const ProjectJson& shares, const std::string& where)
{
    constexpr double rounding = 1e-6;
    double sum = 0;
    for (const ProjectJson& part : shares) sum += part["share"].get<double>();
    if (std::abs(sum - 1) > rounding)
        throw Error(fmt::format("{}: material: The shares of the blend must sum to 100 %; they sum to {:g} %.", where, 100 * sum));
}

/// What a table that lacks columns leaves of the yarn that it describes. Its count stands for linear density, plies and filaments.
ProjectJson kept_of(const LibraryYarn& before, const std::vector<std::string>& given)
{
    const auto is_given = [&](const std::string& column) { return std::find(given.begin(), given.end(), column) != given.end(); };
    ProjectJson kept = json_from_design(before.design)["fabrics"][0]["warp"];
    for (const std::string& key : columns())
        if (is_given(key)) kept.erase(key);
    for (const char* key : {"linear_density_tex", "plies", "filament_count"})
        if (is_given("count")) kept.erase(key);
    return kept;
}

/// Whether fibres or count are other ones, so that what was spun of them before says nothing.
bool is_spun_otherwise(const LibraryYarn& before, const Yarn& now)
{
    const std::vector<YarnChange> changes = changes_of_yarn(before.design, now, before);
    return std::any_of(changes.begin(), changes.end(), [](const YarnChange& each) {
        return each.key == "material" || each.key == "core" || each.key == "linear_density_tex" || each.key == "plies" ||
               each.key == "filament_count";
    });
}

/// A field of the table as the project file has it: a number or a word.
ProjectJson value_json(const std::string& text, bool by_semicolons)
{
    constexpr double most_whole = 1e9;
    const auto number = number_of(text, by_semicolons);
    if (!number) return text;
    const bool is_whole = std::abs(*number) <= most_whole && *number == std::floor(*number);
    return is_whole ? ProjectJson(static_cast<int>(*number)) : ProjectJson(*number);
}

/// Throws Error where one is unknown.
void require_columns(const std::string& text, const std::string& file)
{
    for (const std::string& given : csv_header(text, file))
        if (given != "name" && std::find(columns().begin(), columns().end(), given) == columns().end())
            throw Error(fmt::format("{}: A table of yarns has no column \"{}\"{} It has name, {}.", file, cut_text(given, 40),
                                    did_you_mean(given, columns()), listed(columns())));
}

/// Throws Error with what is wrong with the yarn itself.
void require_valid(const LibraryYarn& yarn, const std::string& where)
{
    const Place own = Place("fabrics") / std::size_t{0} / "warp";
    for (const Issue& issue : validate(yarn.design)) {
        if (issue.severity != Severity::error || !issue.where.is_in(own)) continue;
        const std::string field = issue.where == own ? std::string() : issue.where.text().substr(own.text().size() + 1) + ": ";
        throw Error(fmt::format("{}: {}{}", where, field, issue.text()));
    }
}

} // namespace

std::string fibres_text(const Yarn& yarn)
{
    std::string text;
    for (const MaterialShare& part : yarn.material)
        text += (text.empty() ? "" : " + ") + fmt::format("{} {:g}", part.name, 100 * part.share);
    return text;
}

std::string size_text(const Yarn& yarn)
{
    if (!yarn.linear_density_tex) return yarn.diameter_mm ? fmt::format("{:g} mm", *yarn.diameter_mm) : std::string();
    return exact_count(yarn).value_or(count_text(*yarn.linear_density_tex, yarn.plies, yarn.filament_count, CountSystem::tex));
}

std::string csv_of_yarns(const std::vector<LibraryYarn>& yarns, bool for_programs)
{
    std::string csv = "name,supplier,material,core,count";
    for (const std::string& key : number_keys()) csv += "," + key;
    csv += ",colours,currency\n";
    for (const LibraryYarn& each : yarns) {
        const Yarn& yarn = each.yarn();
        const std::string core = yarn.core ? fmt::format("{} {:g}", yarn.core->material, 100 * yarn.core->share) : std::string();
        csv += csv_field(each.name) + "," + csv_field(each.supplier) + "," + csv_field(fibres_text(yarn)) + "," + csv_field(core);
        const std::optional<std::string> count = exact_count(yarn);
        std::vector<std::string> elsewhere = each.unsaid; // or nowhere
        if (count && !for_programs) elsewhere.insert(elsewhere.end(), {"linear_density_tex", "plies"});
        if (count && !for_programs && read_yarn_count(*count).filaments) elsewhere.emplace_back("filament_count");
        csv += "," + csv_field(count.value_or(""));
        for (const Field<Yarn>& field : fields_of<Yarn>()) {
            csv += ",";
            if (!field_value(field, yarn) || std::find(elsewhere.begin(), elsewhere.end(), field.key) != elsewhere.end()) continue;
            const ProjectJson value = json_of_field(field, yarn);
            csv += value.is_string() ? value.get<std::string>() : value.dump();
        }
        csv += "," + csv_field(colours_text(each)) + "," + csv_field(each.currency) + "\n";
    }
    return csv;
}

std::vector<LibraryYarn> yarns_of_csv(const std::string& text, const std::string& file, const std::vector<LibraryYarn>& known)
{
    require_columns(text, file);
    const CsvTable table = read_csv(text, file, {"name"}, columns());
    if (table.rows.empty()) throw Error(file + ": The table holds no yarn: below the line that names the columns there is none.");
    const std::vector<std::string> given = csv_header(text, file);
    const auto is_given = [&](const std::string& column) { return std::find(given.begin(), given.end(), column) != given.end(); };
    const bool by_semicolons = table.by_semicolons;
    std::vector<LibraryYarn> yarns;
    std::map<std::string, std::size_t> lines; // of each name
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const std::string at = fmt::format("line {}", table.lines[i]);
        const auto refuse = [&](const std::string& sentence) { throw Error(fmt::format("{}: {}: {}", file, at, sentence)); };
        const auto field = [&](const std::string& name) {
            const auto column = std::find(columns().begin(), columns().end(), name) - columns().begin();
            return trimmed(table.rows[i][static_cast<std::size_t>(column) + 1]);
        };
        if (table.rows[i][0].empty()) refuse("The yarn has no name.");
        const auto [first, is_new] = lines.emplace(table.rows[i][0], table.lines[i]);
        if (!is_new) refuse(fmt::format("The yarn \"{}\" stands in line {} already.", cut_text(first->first, 40), first->second));
        const auto before = std::find_if(known.begin(), known.end(), [&](const auto& yarn) { return yarn.name == table.rows[i][0]; });
        ProjectJson json = ProjectJson::object();
        if (const std::string material = field("material"); !material.empty()) {
            json["material"] = material_json(material, by_semicolons);
            require_all_of_it(json["material"], fmt::format("{}: {}", file, at));
        }
        if (const std::string core = field("core"); !core.empty()) {
            const auto [name, percent] = last_word_apart(core);
            const auto share = number_of(percent, by_semicolons);
            if (!share) refuse(fmt::format("core: This must be a fibre and its percent, such as \"elastane 5\"; given is \"{}\".", core));
            json["core"] = {{"material", name}, {"share", *share / 100}};
        }
        if (const std::string count = field("count"); !count.empty()) json["count"] = count;
        for (const Field<Yarn>& each : fields_of<Yarn>())
            if (const std::string value = field(each.key); !value.empty())
                json[each.key] = each.is_number() ? value_json(value, by_semicolons) : ProjectJson(value);
        const bool is_known = before != known.end();
        ProjectJson whole = is_known ? kept_of(*before, given) : ProjectJson::object();
        whole.update(json);
        const bool is_other = is_known && is_spun_otherwise(*before, yarn_from_json(whole, file, at));
        std::vector<std::string> unsaid;
        for (const std::string& key : unsaid_keys()) {
            if (json.contains(key)) continue;
            if (is_other) whole.erase(key);
            if (!is_known || is_other || is_given(key) ||
                std::find(before->unsaid.begin(), before->unsaid.end(), key) != before->unsaid.end())
                unsaid.push_back(key);
        }
        Yarn read = yarn_from_json(whole, file, at);
        if (is_known) read.color = before->yarn().color;
        LibraryYarn yarn = library_yarn(is_known ? before->design : Design(), read, table.rows[i][0]);
        yarn.unsaid = unsaid;
        yarn.supplier = is_known && !is_given("supplier") ? before->supplier : field("supplier");
        yarn.currency = is_known && !is_given("currency") ? before->currency : field("currency");
        if (is_known && !is_given("colours")) yarn.colours = before->colours;
        for (const std::string& part : parts_of(field("colours"))) {
            const auto [name, code] = last_word_apart(part);
            const auto color = color_of(code);
            if (!color) refuse(fmt::format("colours: This must be a name and \"#rrggbb\"; given is \"{}\".", part));
            yarn.colours.push_back({name, *color});
        }
        require_valid(yarn, fmt::format("{}: {}", file, at));
        yarns.push_back(std::move(yarn));
    }
    return yarns;
}

} // namespace hygroloom
