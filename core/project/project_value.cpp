// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One value of a project by its path, for --set and for scripts that sweep a parameter.
#include "core/project/project_value.h"
#include "core/base/trade_units.h"
#include "core/base/words.h"
#include "core/design/yarn_count.h"
#include "core/project/json_reader.h"
#include "core/project/project_file.h"
#include "core/project/project_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>

namespace hygroloom {

namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& sentence) { throw Error(fmt::format("{}: {}", path, sentence)); }

/// How much of a text is a name, and not the beginning of a longer one: its length there; 0: the text goes on otherwise. Blanks may stand
/// after a backslash, as a shell wants them.
std::size_t length_of_name(std::string_view text, const std::string& name)
{
    std::string quoted;
    for (char letter : name) quoted += letter == ' ' ? std::string("\\ ") : std::string(1, letter);
    for (const std::string& form : {name, quoted})
        if (text.starts_with(form) && (text.size() == form.size() || text[form.size()] == '.' || text[form.size()] == '['))
            return form.size();
    return 0;
}

/// Walks down a path, one piece at a time: keys, [numbers], and names of list members, which may hold dots and spaces.
class PathWalk {
public:
    PathWalk(ProjectJson& root, const std::string& path) : path_(path), rest_(path), at_(&root) {}

    /// Goes down to the object that holds the last key, and returns that key.
    std::string walk()
    {
        while (true) {
            if (at_->is_array()) {
                const std::size_t number = index();
                if (!member_) member_ = {path_.substr(0, path_.find_first_of(".[")), number};
                enter(at_->at(number));
            } else if (at_->is_object()) {
                const std::size_t end = std::min(rest_.find_first_of(".["), rest_.size());
                const std::string key(rest_.substr(0, end));
                rest_.remove_prefix(end);
                if (rest_.empty()) return key;
                if (!at_->contains(key)) make(key);
                enter((*at_)[key]);
            } else {
                refuse(path_, fmt::format("The path goes on after a plain value, at \"{}\".", rest_));
            }
            if (rest_.empty()) return {};
            if (rest_.front() == '.') rest_.remove_prefix(1);
            if (rest_.empty()) refuse(path_, "The path ends with a dot.");
        }
    }

    ProjectJson& here() { return *at_; }
    /// The first list that the path went into, and its member.
    const std::optional<std::pair<std::string, std::size_t>>& member() const { return member_; }

private:
    void enter(ProjectJson& child) { at_ = &child; }

    void make(const std::string& key)
    {
        if (key != "flyaway" && key != "climate" && key != "uncertainty" && key != "loom" && key != "seams") {
            std::vector<std::string> keys;
            for (const auto& [known, value] : at_->items()) keys.push_back(known);
            refuse(path_, fmt::format("There is no \"{}\" here{}", key, did_you_mean(key, keys)));
        }
        (*at_)[key] = ProjectJson::object();
    }

    [[noreturn]] void refuse_number(long number) const
    {
        const std::string list = path_.substr(0, path_.size() - rest_.size());
        const std::size_t size = at_->size();
        std::string known = size == 0 ? "none" : fmt::format("{} ({}[0]", size, list);
        if (size > 0) known += size == 1 ? ")" : fmt::format(" to {}[{}])", list, size - 1);
        refuse(path_, fmt::format("There is no {}[{}]; this project has {}.", list, number, known));
    }

    std::size_t index()
    {
        const bool bracketed = !rest_.empty() && rest_.front() == '[';
        std::string_view text = rest_;
        if (bracketed) {
            const std::size_t close = rest_.find(']');
            if (close == std::string_view::npos) refuse(path_, "A \"]\" is missing.");
            text = rest_.substr(1, close - 1);
        }
        long number = 0;
        const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (bracketed && failure == std::errc() && end == text.data() + text.size()) {
            const long size = static_cast<long>(at_->size()), place = number < 0 ? number + size : number; // -1 is the last
            if (place < 0 || place >= size) refuse_number(number);
            rest_.remove_prefix(text.size() + 2);
            return static_cast<std::size_t>(place);
        }
        return named(text, bracketed);
    }

    /// The member with the longest name that the path goes on with.
    std::size_t named(std::string_view text, bool bracketed)
    {
        std::size_t best = at_->size(), longest = 0;
        std::string known;
        for (std::size_t i = 0; i < at_->size(); ++i) {
            const ProjectJson& member = at_->at(i);
            if (!member.is_object() || !member.contains("name")) continue;
            const std::string name = member.at("name").get<std::string>();
            known += (known.empty() ? "\"" : ", \"") + name + "\"";
            const std::size_t length = length_of_name(text, name);
            if (length > longest && (!bracketed || length == text.size())) {
                best = i;
                longest = length;
            }
        }
        if (best == at_->size())
            refuse(path_, known.empty() ? fmt::format("A list needs an index such as [0]; given is \"{}\".", text)
                                        : fmt::format("Nothing in the list is called as \"{}\" begins. There are: {}.", text, known));
        rest_.remove_prefix(bracketed ? text.size() + 2 : longest);
        return best;
    }

    const std::string& path_;
    std::string_view rest_;
    ProjectJson* at_;
    std::optional<std::pair<std::string, std::size_t>> member_;
};

ProjectJson value_from(const std::string& path, const std::string& text, const ProjectJson* old)
{
    ProjectJson value;
    try {
        value = parse_json(text, {});
    } catch (const NumberTooLarge&) {
        if (old && old->is_string()) return text; // a name that looks like a number
        refuse(path, fmt::format("This must be a number up to {:.2g}; given is {}.", std::numeric_limits<double>::max(), text));
    } catch (const FileError&) {
        return text; // a bare word
    }
    if (old && old->is_string() && value.is_number()) return text; // a name made of digits
    return value;
}

/// Digits, one comma, digits.
bool has_decimal_comma(const std::string& text)
{
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos || comma == 0 || comma + 1 == text.size()) return false;
    double number = 0;
    const std::string pointed = std::string(text).replace(comma, 1, ".");
    const auto [end, failure] = std::from_chars(pointed.data(), pointed.data() + pointed.size(), number);
    return failure == std::errc() && end == pointed.data() + pointed.size();
}

/// The number that a text with a unit means where the key has one: "60 epi" of ends_per_cm.
ProjectJson number_of(const std::string& path, const std::string& key, const std::string& text)
{
    const Stored kind = stored_kind(key);
    if (const auto number = number_with_unit(text, kind)) return *number;
    if (has_decimal_comma(text))
        refuse(path, fmt::format("Numbers are written with a decimal point: {}.", std::string(text).replace(text.find(','), 1, ".")));
    const std::string_view unit = trade_units(kind).front().spellings.front();
    const char* advice = key == "linear_density_tex" ? " Set count for a count such as Ne 60/2." : "";
    refuse(path, unit.empty() ? fmt::format("This must be a number; given is {}.", in_words(text))
                              : fmt::format("This must be a number in {}; given is {}.{}", unit, in_words(text), advice));
}

/// Whether a key is that of a yarn's count; that of a stripe says how many threads it has.
bool is_count(const ProjectJson& holder, const std::string& key) { return key == "count" && holder.contains("material"); }

/// null where the yarn has a diameter only.
ProjectJson count_in(const ProjectJson& yarn)
{
    if (!yarn.contains("linear_density_tex")) return {};
    const auto whole = [&](const char* key) { return yarn.contains(key) ? std::optional(yarn.at(key).get<int>()) : std::nullopt; };
    return count_text(yarn.at("linear_density_tex").get<double>(), whole("plies").value_or(1), whole("filament_count"), CountSystem::tex);
}

/// A yarn's count, written as what it stands for; the diameter then follows from it.
void write_count(const std::string& path, ProjectJson& yarn, const std::string& text)
try {
    const YarnCount count = read_yarn_count(text);
    yarn.erase("diameter_mm");
    yarn["linear_density_tex"] = count.tex();
    yarn["plies"] = count.plies;
    if (count.filaments) yarn["filament_count"] = *count.filaments * count.plies;
} catch (const Error& error) {
    refuse(path, error.what());
}

/// Of keys that say the same, one replaces the others; null only takes back the own one, but both names of what is one value.
void erase_others(ProjectJson& holder, const std::string& key, bool is_null)
{
    const std::vector<std::string> ways{"pattern", "rows", "draft"}, names{"heat_of_wetting_j_g", "sorption_heat_j_g"};
    for (const std::vector<std::string>& keys : {ways, names}) {
        if (std::find(keys.begin(), keys.end(), key) == keys.end() || (is_null && keys == ways)) continue;
        for (const std::string& other : keys)
            if (other != key) holder.erase(other);
    }
}

/// Changes the JSON, which is not read yet.
void set_value(ProjectJson& project, const std::string& path, const std::string& value)
{
    if (path.empty()) refuse("--set", "The path is empty; give one such as fabrics[0].contact_angle_deg.");
    PathWalk walk(project, path);
    const std::string key = walk.walk();
    ProjectJson& holder = walk.here();
    if (!key.empty()) erase_others(holder, key, value == "null");
    if (key.empty()) {
        holder = value_from(path, value, &holder);
    } else if (value == "null") {
        holder.erase(key); // back to what the program derives
    } else {
        const auto old = holder.find(key);
        ProjectJson fresh = value_from(path, value, old == holder.end() ? nullptr : &*old);
        if (is_count(holder, key) && fresh.is_string()) {
            write_count(path, holder, fresh.get<std::string>());
            return;
        }
        const bool number = old != holder.end() ? old->is_number() : stored_kind(key) != Stored::number || has_decimal_comma(value);
        if (fresh.is_string() && number) fresh = number_of(path, key, fresh.get<std::string>());
        holder[key] = std::move(fresh);
    }
}

} // namespace

Design with_value(const Design& design, const std::string& path, const std::string& value)
{
    ProjectJson project = json_from_design(design);
    set_value(project, path, value);
    return parse_project(text_from_json(project), "--set");
}

Design with_values(ProjectJson project, const std::vector<std::pair<std::string, std::string>>& values)
{
    for (const auto& [path, value] : values) set_value(project, path, value);
    return design_from_json(std::move(project), "the project");
}

Design with_values(const Design& design, const std::vector<std::pair<std::string, std::string>>& values)
{
    return values.empty() ? design : with_values(json_from_design(design), values);
}

ProjectJson value_at(const Design& design, const std::string& path)
{
    ProjectJson project = json_from_design(design);
    PathWalk walk(project, path);
    const std::string key = walk.walk();
    if (key.empty()) return walk.here();
    if (is_count(walk.here(), key)) return count_in(walk.here());
    const auto found = walk.here().find(key);
    return found == walk.here().end() ? ProjectJson() : *found;
}

std::optional<std::pair<std::size_t, std::size_t>> same_place(const Design& design, const std::vector<std::string>& paths)
{
    ProjectJson project = json_from_design(design);
    for (const std::string& path : paths) PathWalk(project, path).walk(); // makes what is left out, which moves what is there
    std::map<std::pair<const void*, std::string>, std::size_t> places;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        PathWalk walk(project, paths[i]);
        std::string key = walk.walk();
        if (is_count(walk.here(), key)) key = "linear_density_tex"; // written otherwise
        const auto [at, fresh] = places.try_emplace({&walk.here(), key}, i);
        if (!fresh) return std::pair{at->second, i};
    }
    return std::nullopt;
}

std::optional<std::pair<std::string, std::size_t>> member_at(const Design& design, const std::string& path)
{
    ProjectJson project = json_from_design(design);
    PathWalk walk(project, path);
    walk.walk();
    return walk.member();
}

} // namespace hygroloom
