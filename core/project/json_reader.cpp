// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/project/json_reader.h"

#include "core/base/text.h"
#include "core/base/words.h"
#include "core/design/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace hygroloom {

namespace {

constexpr std::size_t deepest = 32;
constexpr std::size_t most_keys = 1000;

[[noreturn]] void refuse_at(const std::string& file, const std::string& path, const std::string& sentence)
{
    throw FileError(fmt::format("{}: {}: {}", file, path.empty() ? "the project" : path, sentence));
}

std::string line_and_column(std::string_view text, std::size_t byte)
{
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t start = before.rfind('\n');
    const std::size_t column = start == std::string_view::npos ? before.size() : before.size() - start - 1;
    return fmt::format("line {}, column {}", line, std::max<std::size_t>(column, 1));
}

/// The reason without the library's own number and position.
std::string reason(const std::string& message)
{
    std::string text = message;
    if (const auto close = text.find("] "); text.starts_with('[') && close != std::string::npos) text.erase(0, close + 2);
    if (const auto tail = text.find(" - "); tail != std::string::npos)
        text = text.substr(tail + 3);
    else if (const auto colon = text.rfind(": "); colon != std::string::npos)
        text = text.substr(colon + 2);
    for (char& letter : text)
        if (static_cast<unsigned char>(letter) >= 0x80) letter = '?'; // it may quote half a character
    if (text.size() > 200) text = text.substr(0, 120) + " ... " + text.substr(text.size() - 70);
    return text;
}

/// A value as it stands, cut where it is long.
std::string shortened(const std::string& text) { return text.size() > 60 ? cut_text(text, 57) + "..." : text; }

/// Refuses what JSON allows and a project never has. A pass of its own: the library's parser with a callback goes through every list again
/// for each of its elements.
class Watch : public nlohmann::json_sax<ProjectJson> {
public:
    Watch(std::string_view text, const std::string& name) : text_(text), name_(name) {}
    bool start_object(std::size_t) override { return deeper(false); }
    bool start_array(std::size_t) override { return deeper(true); }
    bool end_object() override { return shallower(); }
    bool end_array() override { return shallower(); }
    bool key(std::string& key) override
    {
        Level& level = levels_.back();
        if (level.keys.size() > most_keys)
            throw FileError(fmt::format("{}: An object has more than {} keys; this is no project.", name_, most_keys));
        if (!level.keys.insert(key).second)
            throw FileError(fmt::format("{}: The key {} stands twice in one object; leave one.", name_, in_words(key)));
        level.key = key;
        return true;
    }
    bool null() override { return passed(); }
    bool boolean(bool) override { return passed(); }
    bool number_integer(std::int64_t) override { return passed(); }
    bool number_unsigned(std::uint64_t) override { return passed(); }
    bool number_float(double, const std::string&) override { return passed(); }
    bool string(std::string& text) override
    {
        if (!levels_.empty() && levels_.back().key == "type") levels_.back().worn = text == "wear";
        return passed();
    }
    bool binary(nlohmann::json::binary_t&) override { return passed(); }
    /// parse() reports all but numbers.
    bool parse_error(std::size_t end, const std::string& token, const nlohmann::json::exception& failure) override
    {
        if (dynamic_cast<const nlohmann::json::out_of_range*>(&failure) == nullptr || token.size() > end) return false;
        const std::optional<Message> allowed = allowed_at(place_of_row());
        const std::string path = place().text();
        throw NumberTooLarge(fmt::format("{}: {}: {}: The number {} is beyond those that there are, up to {:.2g}.{}", name_,
                                         line_and_column(text_, end - token.size() + 1), path.empty() ? "the project" : path,
                                         shortened(token), std::numeric_limits<double>::max(), allowed ? " " + english(*allowed) : ""));
    }

private:
    struct Level {
        bool list = false;
        std::set<std::string> keys;
        std::string key;         ///< the last
        bool worn = false;       ///< an experiment on a garment, as far as that is read
        std::size_t members = 0; ///< of a list, so far
    };
    bool deeper(bool list)
    {
        if (levels_.size() >= deepest)
            throw FileError(fmt::format("{}: Values are nested deeper than {} levels; this is no project.", name_, deepest));
        levels_.push_back({list, {}, {}, false, 0});
        return true;
    }
    bool shallower()
    {
        levels_.pop_back();
        return passed();
    }
    bool passed()
    {
        if (!levels_.empty()) ++levels_.back().members;
        return true;
    }
    Place place() const
    {
        Place place;
        for (const Level& level : levels_) place = level.list ? place / level.members : place / level.key;
        return place;
    }
    /// As allowed_at() looks for the number's row: experiments on garments have rows of their own.
    Place place_of_row() const
    {
        const Place at = place();
        const bool worn = std::any_of(levels_.begin(), levels_.end(), [](const Level& level) { return level.worn; });
        return worn && at.key(0) == "experiments" ? at.with(0, std::string("wears")) : at;
    }

    std::string_view text_;
    const std::string& name_;
    std::vector<Level> levels_;
};

/// What a file is that begins so and is no text; empty: nothing that is known.
const char* looks_like(std::string_view text)
{
    using namespace std::string_view_literals;
    struct Kind {
        std::string_view begin;
        const char* is;
    };
    static constexpr std::array kinds{Kind{"\x89PNG"sv, "a PNG picture"},
                                      Kind{"\xff\xd8\xff"sv, "a JPEG picture"},
                                      Kind{"GIF8"sv, "a GIF picture"},
                                      Kind{"SQLite format 3"sv, "an SQLite database, such as a recording"},
                                      Kind{"PK\x03\x04"sv, "a zip archive"},
                                      Kind{"\x1f\x8b"sv, "a gzip archive"},
                                      Kind{"%PDF"sv, "a PDF document"},
                                      Kind{"glTF"sv, "a GLB mesh"},
                                      Kind{"<"sv, "HTML or XML"}};
    for (const Kind& kind : kinds)
        if (text.starts_with(kind.begin)) return kind.is;
    return "";
}

} // namespace

ProjectJson parse_json(std::string_view text, const std::string& name)
{
    if (const std::string is = looks_like(text); !is.empty()) throw FileError(fmt::format("{}: This is {}, not JSON text.", name, is));
    Watch watch(text, name);
    try {
        ProjectJson::sax_parse(text, &watch);
        return ProjectJson::parse(text);
    } catch (const ProjectJson::parse_error& failure) {
        throw FileError(
            fmt::format("{}: {}: This is not valid JSON: {}.", name, line_and_column(text, failure.byte), reason(failure.what())));
    } catch (const ProjectJson::exception& failure) {
        throw FileError(fmt::format("{}: This is not valid JSON: {}.", name, reason(failure.what())));
    }
}

std::string in_words(const ProjectJson& value)
{
    if (value.is_object()) return "an object";
    if (value.is_array()) return fmt::format("a list of {}", value.size());
    return shortened(value.dump(-1, ' ', false, ProjectJson::error_handler_t::replace));
}

void require_format(ObjectReader& file, const std::string& format, int version, const char* things)
{
    std::string given;
    int of_file = 0;
    file.require("format");
    file.read("format", given);
    if (given != format) file.refuse("format", fmt::format("This must be \"{}\"; given is \"{}\".", format, given));
    file.require("version");
    file.read("version", of_file);
    if (of_file != version)
        file.refuse("version", fmt::format("This program reads version {} of {}; the file has {}.", version, things, of_file));
}

double number_in(const ProjectJson& value, const std::string& file, const std::string& path)
{
    if (!value.is_number()) refuse_at(file, path, fmt::format("This must be a number; given is {}.", in_words(value)));
    return value.get<double>();
}

std::string text_in(const ProjectJson& value, const std::string& file, const std::string& path)
{
    if (!value.is_string()) refuse_at(file, path, fmt::format("This must be a text in quotes; given is {}.", in_words(value)));
    return value.get<std::string>();
}

const ProjectJson& array_in(const ProjectJson& value, const std::string& file, const std::string& path)
{
    if (!value.is_array()) refuse_at(file, path, fmt::format("This must be a list in [ ]; given is {}.", in_words(value)));
    return value;
}

ObjectReader::ObjectReader(const ProjectJson& value, std::string file, std::string path)
    : value_(value), file_(std::move(file)), path_(std::move(path))
{
    if (!value.is_object()) refuse_at(file_, path_, fmt::format("This must be an object in {{ }}; given is {}.", in_words(value)));
}

const ProjectJson* ObjectReader::find(const std::string& key)
{
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
    const auto at = value_.find(key);
    return at == value_.end() ? nullptr : &*at;
}

const ProjectJson& ObjectReader::require(const std::string& key)
{
    const ProjectJson* member = find(key);
    if (!member) refuse_missing(key);
    return *member;
}

void ObjectReader::read(const std::string& key, double& value)
{
    if (const ProjectJson* member = find(key)) value = number_in(*member, file_, path_of(key));
}

void ObjectReader::read(const std::string& key, std::optional<double>& value)
{
    if (const ProjectJson* member = find(key)) value = number_in(*member, file_, path_of(key));
}

void ObjectReader::read(const std::string& key, std::optional<int>& value)
{
    if (find(key)) read(key, value.emplace());
}

void ObjectReader::read(const std::string& key, int& value)
{
    const ProjectJson* member = find(key);
    if (!member) return;
    const double number = number_in(*member, file_, path_of(key));
    if (!(number == std::floor(number) && std::abs(number) <= std::numeric_limits<int>::max()))
        refuse(key, fmt::format("This must be a whole number; given is {}.", in_words(*member)));
    value = static_cast<int>(number);
}

void ObjectReader::read(const std::string& key, bool& value)
{
    const ProjectJson* member = find(key);
    if (!member) return;
    if (!member->is_boolean()) refuse(key, fmt::format("This must be true or false; given is {}.", in_words(*member)));
    value = member->get<bool>();
}

void ObjectReader::read(const std::string& key, std::string& value)
{
    if (const ProjectJson* member = find(key)) value = text_in(*member, file_, path_of(key));
}

int ObjectReader::word(const std::string& key, std::span<const char* const> words)
{
    const std::string given = text_in(require(key), file_, path_of(key));
    const auto found = std::find(words.begin(), words.end(), given);
    if (found != words.end()) return static_cast<int>(found - words.begin());
    std::string all;
    for (std::size_t i = 0; i < words.size(); ++i)
        all += fmt::format("{}\"{}\"", i == 0 ? "" : words.size() == 2 ? " or " : ", ", words[i]);
    refuse(key, fmt::format("This must be {}{}; given is {}{}", words.size() == 2 ? "" : "one of ", all, in_words(given),
                            did_you_mean(given, std::vector<std::string>(words.begin(), words.end()))));
}

void ObjectReader::read(const std::string& key, std::array<double, 2>& value)
{
    const ProjectJson* member = find(key);
    if (!member) return;
    array_in(*member, file_, path_of(key));
    if (member->size() != 2) refuse(key, fmt::format("This must be a list of 2 numbers; given is {}.", in_words(*member)));
    for (std::size_t i = 0; i < 2; ++i) value[i] = number_in((*member)[i], file_, fmt::format("{}[{}]", path_of(key), i));
}

void ObjectReader::finish(const std::vector<std::string>& required) const
{
    for (const auto& [key, member] : value_.items()) {
        if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
        const std::string near = nearest_word(key, known_);
        refuse_at(file_, path_,
                  near.empty() ? fmt::format("The key {} is not known here. Known are: {}.", in_words(key), listed(known_))
                               : fmt::format("The key {} is not known here; did you mean \"{}\"?", in_words(key), near));
    }
    for (const std::string& key : required)
        if (!value_.contains(key)) refuse_missing(key);
}

void ObjectReader::refuse_missing(const std::string& key) const { refuse_at(file_, path_, fmt::format("The key \"{}\" is missing.", key)); }

std::string ObjectReader::path_of(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }

void ObjectReader::refuse(const std::string& key, const std::string& sentence) const { refuse_at(file_, path_of(key), sentence); }

} // namespace hygroloom
