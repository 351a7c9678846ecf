// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The study file: strict, versioned JSON.
#include "core/study/study.h"

#include "core/base/error.h"
#include "core/base/words.h"
#include "core/plan/expectation.h"
#include "core/project/atomic_file.h"
#include "core/project/json_reader.h"
#include "core/project/project_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace hygroloom {
namespace {

constexpr const char* format_name = "hygroloom-study";
constexpr int study_version = 1;
constexpr std::size_t largest_study_bytes = std::size_t{16} << 20U;
constexpr std::size_t most_values = 10000, longest_word = 200;
constexpr int most_replicates_of_study = 1000, most_levels = 10000;

constexpr const char* sampling_names[] = {"grid", "latin_hypercube", "sobol", "one_at_a_time"};
constexpr const char* distribution_names[] = {"uniform", "log_uniform", "normal", "lognormal", "triangular"};

std::string quoted(std::span<const char* const> words)
{
    std::string all;
    for (const char* word : words) all += fmt::format("{}\"{}\"", all.empty() ? "" : ", ", word);
    return all;
}

/// Which of the words stands there.
std::size_t word_in(ObjectReader& reader, const std::string& key, std::span<const char* const> words)
{
    const ProjectJson& value = reader.require(key);
    for (std::size_t i = 0; i < words.size(); ++i)
        if (value == words[i]) return i;
    std::string meant;
    if (value.is_string()) meant = nearest_word(value.get<std::string>(), {words.begin(), words.end()});
    reader.refuse(key, fmt::format("This must be one of {}; given is {}{}", quoted(words), in_words(value),
                                   meant.empty() ? "." : "; did you mean \"" + meant + "\"?"));
}

int count_in(ObjectReader& reader, const std::string& key, int otherwise, int least, int most)
{
    int count = otherwise;
    reader.read(key, count);
    if (reader.find(key) && (count < least || count > most))
        reader.refuse(key, fmt::format("This must be from {} to {}; given is {}.", least, most, count));
    return count;
}

/// A word that may stand in a table.
std::string plain_text_in(const ProjectJson& value, const std::string& file, const std::string& path)
{
    const std::string text = text_in(value, file, path);
    const bool plain = std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; });
    if (text.empty() || text.size() > longest_word || !plain)
        throw FileError(fmt::format("{}: {}: This must be a text of 1 to {} bytes without line breaks; given is {}.", file, path,
                                    longest_word, in_words(value)));
    return text;
}

std::vector<std::string> names_in(ObjectReader& reader, const std::string& key)
{
    std::vector<std::string> names;
    const ProjectJson* list = reader.find(key);
    if (!list) return names;
    array_in(*list, reader.file(), reader.path_of(key));
    if (list->size() > 1000) reader.refuse(key, fmt::format("At most 1000 names are allowed; given are {}.", list->size()));
    for (std::size_t i = 0; i < list->size(); ++i) {
        names.push_back(plain_text_in((*list)[i], reader.file(), fmt::format("{}[{}]", reader.path_of(key), i)));
        if (std::count(names.begin(), names.end(), names.back()) > 1)
            reader.refuse(key, fmt::format("\"{}\" stands there twice; leave one.", names.back()));
    }
    return names;
}

FactorValue factor_value_in(const ProjectJson& value, const std::string& file, const std::string& path)
{
    if (value.is_number()) return factor_value(value.get<double>());
    if (value.is_boolean()) return factor_value(std::string(value.get<bool>() ? "true" : "false"));
    if (!value.is_string())
        throw FileError(fmt::format("{}: {}: This must be a number, a text, true or false; given is {}.", file, path, in_words(value)));
    return factor_value(plain_text_in(value, file, path));
}

double required_number(ObjectReader& reader, const std::string& key)
{
    return number_in(reader.require(key), reader.file(), reader.path_of(key));
}

void require_rising(ObjectReader& reader, double low, double high)
{
    if (!(low < high)) reader.refuse("high", fmt::format("This must be above \"low\", which is {}; given is {}.", low, high));
}

FactorDistribution distribution_in(const ProjectJson& value, const std::string& file, const std::string& path)
{
    using Type = FactorDistribution::Type;
    ObjectReader reader(value, file, path);
    FactorDistribution made;
    made.type = static_cast<Type>(word_in(reader, "type", distribution_names));
    reader.read("low", made.low);
    reader.read("high", made.high);
    if (made.type == Type::normal || made.type == Type::lognormal) {
        made.mean = required_number(reader, "mean");
        made.sd = required_number(reader, "sd");
        if (!(made.sd > 0)) reader.refuse("sd", fmt::format("This must be above 0; given is {}.", made.sd));
        if (made.type == Type::lognormal && !(made.mean > 0))
            reader.refuse("mean", fmt::format("Of a lognormal distribution this must be above 0; given is {}.", made.mean));
    } else {
        reader.require("low");
        reader.require("high");
    }
    if (made.low && made.high) require_rising(reader, *made.low, *made.high);
    if (made.type == Type::log_uniform && !(*made.low > 0))
        reader.refuse("low", fmt::format("Of a log_uniform distribution this must be above 0; given is {}.", *made.low));
    if (made.type == Type::triangular) {
        made.mode = required_number(reader, "mode");
        if (!(made.mode >= *made.low && made.mode <= *made.high))
            reader.refuse("mode", fmt::format("This must be from {} to {}; given is {}.", *made.low, *made.high, made.mode));
    }
    reader.finish();
    return made;
}

void read_range(ObjectReader& reader, Factor& factor)
{
    factor.distribution.low = required_number(reader, "low");
    factor.distribution.high = required_number(reader, "high");
    require_rising(reader, *factor.distribution.low, *factor.distribution.high);
    reader.read("step", factor.step);
    if (!factor.step) return;
    const double width = *factor.distribution.high - *factor.distribution.low;
    if (!(*factor.step > 0 && *factor.step <= width && width / *factor.step <= most_levels))
        reader.refuse("step", fmt::format("This must be above {} and at most {}; given is {}.", width / most_levels, width, *factor.step));
}

Factor factor_in(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader reader(value, file, path);
    Factor factor;
    factor.path = plain_text_in(reader.require("path"), file, reader.path_of("path"));
    const bool range = reader.find("low") || reader.find("high");
    const ProjectJson *list = reader.find("values"), *distribution = reader.find("distribution");
    if (range + (list != nullptr) + (distribution != nullptr) != 1)
        reader.refuse("path", "A factor needs one of: \"low\" and \"high\", \"values\", or \"distribution\".");
    if (range) read_range(reader, factor);
    if (distribution) factor.distribution = distribution_in(*distribution, file, reader.path_of("distribution"));
    if (list) {
        const std::string where = reader.path_of("values");
        array_in(*list, file, where);
        if (list->empty() || list->size() > most_values)
            reader.refuse("values", fmt::format("This must be a list of 1 to {} values; given are {}.", most_values, list->size()));
        std::set<std::string> seen;
        for (std::size_t i = 0; i < list->size(); ++i) {
            factor.values.push_back(factor_value_in((*list)[i], file, fmt::format("{}[{}]", where, i)));
            if (!seen.insert(factor.values.back().text).second)
                reader.refuse("values", fmt::format("{} stands there twice; leave one.", factor.values.back().text));
        }
    } else if (!factor.step && reader.find("levels")) {
        factor.levels = count_in(reader, "levels", 2, 2, most_levels);
    }
    if (const ProjectJson* base = reader.find("base")) factor.base = factor_value_in(*base, file, reader.path_of("base"));
    reader.finish();
    return factor;
}

void read_factors(ObjectReader& reader, Study& study)
{
    const ProjectJson& list = array_in(reader.require("factors"), reader.file(), reader.path_of("factors"));
    if (list.size() > most_study_factors)
        reader.refuse("factors", fmt::format("At most {} factors are allowed; given are {}.", most_study_factors, list.size()));
    for (std::size_t i = 0; i < list.size(); ++i) {
        study.factors.push_back(factor_in(list[i], reader.file(), fmt::format("factors[{}]", i)));
        for (std::size_t k = 0; k < i; ++k)
            if (study.factors[k].path == study.factors[i].path)
                reader.refuse("factors", fmt::format("factors[{}] and factors[{}] have the same path \"{}\"; leave one.", k, i,
                                                     study.factors[i].path));
    }
}

void read_design(ObjectReader& reader, Study& study)
{
    ObjectReader design(reader.require("design"), reader.file(), "design");
    study.sampling = static_cast<Sampling>(word_in(design, "type", sampling_names));
    const bool draws = study.sampling == Sampling::latin_hypercube || study.sampling == Sampling::sobol;
    if (draws) design.require("points");
    study.points = static_cast<std::size_t>(count_in(design, "points", 0, 1, int{most_study_rows}));
    design.finish();
    if (const ProjectJson* value = reader.find("sensitivity")) {
        const bool sobol = *value == "sobol";
        if (!sobol && *value != "surrogate")
            reader.refuse("sensitivity", fmt::format("This must be \"sobol\" or \"surrogate\"; given is {}.", in_words(*value)));
        study.sensitivity = sobol && draws ? Sensitivity::saltelli : Sensitivity::surrogate;
    }
    constexpr std::size_t least_base = 8; // fewer samples give indices that are noise
    const std::size_t least = least_base * (study.factors.size() + 2);
    if (study.sensitivity == Sensitivity::saltelli && study.points < least)
        design.refuse("points", fmt::format("With \"sensitivity\": \"sobol\" and {} factors this must be {} or more; given is {}.",
                                            study.factors.size(), least, study.points));
    if (study.sensitivity != Sensitivity::none && study.factors.empty())
        reader.refuse("sensitivity", "A sensitivity needs one factor at least; given are none.");
}

void read_fidelity(ObjectReader& reader, Study& study)
{
    std::string name = "standard", error;
    reader.read("fidelity", name);
    const ProjectJson* limit = reader.find("error");
    if (name != "auto") {
        if (limit) reader.refuse("error", "This goes with \"fidelity\": \"auto\" only.");
        try {
            study.fidelity = fidelity_from_name(name);
        } catch (const Error&) {
            reader.refuse("fidelity",
                          fmt::format("This must be \"live\", \"draft\", \"standard\", \"reference\" or \"auto\"; given is \"{}\".", name));
        }
        return;
    }
    study.fidelity.reset();
    if (!limit) reader.refuse("error", "\"fidelity\": \"auto\" needs a largest numerical error, such as \"5%\".");
    try {
        study.error = parse_error_target(limit->is_number() ? fmt::format("{}", limit->get<double>())
                                                            : text_in(*limit, reader.file(), reader.path_of("error")));
    } catch (const FileError&) {
        throw;
    } catch (const Error&) {
        reader.refuse("error", fmt::format("This must be a share over 0 and up to 100 %, such as \"5%\"; given is {}.", in_words(*limit)));
    }
}

void read_knobs(ObjectReader& reader, Study& study)
{
    const ProjectJson* value = reader.find("knobs");
    if (!value) return;
    if (!value->is_object()) reader.refuse("knobs", fmt::format("This must be an object in {{ }}; given is {}.", in_words(*value)));
    for (const auto& [name, setting] : value->items()) {
        try {
            set_knob(study.knobs, name, setting.is_string() ? setting.get<std::string>() : setting.dump());
        } catch (const Error& error) {
            reader.refuse("knobs", error.what());
        }
    }
}

void read_seed(ObjectReader& reader, Study& study)
{
    const ProjectJson* value = reader.find("seed");
    if (!value) return;
    if (!value->is_number_unsigned())
        reader.refuse("seed", fmt::format("This must be a whole number from 0 to 18446744073709551615; given is {}.", in_words(*value)));
    study.seed = value->get<std::uint64_t>();
}

ProjectJson json_of(const FactorValue& value)
{
    if (value.is_number) return value.number;
    if (value.text == "true" || value.text == "false") return value.text == "true";
    return value.text;
}

ProjectJson json_of(const Factor& factor)
{
    ProjectJson json;
    json["path"] = factor.path;
    const FactorDistribution& d = factor.distribution;
    using Type = FactorDistribution::Type;
    if (factor.is_list()) {
        json["values"] = ProjectJson::array();
        for (const FactorValue& value : factor.values) json["values"].push_back(json_of(value));
    } else if (d.type == Type::uniform) {
        json["low"] = *d.low;
        json["high"] = *d.high;
        if (factor.step) json["step"] = *factor.step;
    } else {
        ProjectJson& of = json["distribution"];
        of["type"] = name_of(d.type);
        if (d.type == Type::normal || d.type == Type::lognormal) {
            of["mean"] = d.mean;
            of["sd"] = d.sd;
        }
        if (d.low) of["low"] = *d.low;
        if (d.high) of["high"] = *d.high;
        if (d.type == Type::triangular) of["mode"] = d.mode;
    }
    if (factor.levels) json["levels"] = *factor.levels;
    if (factor.base) json["base"] = json_of(*factor.base);
    return json;
}

} // namespace

FactorValue factor_value(double number) { return {number, true, fmt::format("{}", number)}; }
FactorValue factor_value(const std::string& word) { return {0, false, word}; }

const char* name_of(Sampling sampling) { return sampling_names[static_cast<int>(sampling)]; }
const char* name_of(FactorDistribution::Type type) { return distribution_names[static_cast<int>(type)]; }

Study parse_study(std::string_view text, const std::string& name)
try {
    const ProjectJson json = parse_json(text, name);
    ObjectReader reader(json, name, "");
    const ProjectJson& format = reader.require("format");
    if (format != format_name) reader.refuse("format", fmt::format("This must be \"{}\"; given is {}.", format_name, in_words(format)));
    const ProjectJson& version = reader.require("version");
    if (version != study_version)
        reader.refuse("version", fmt::format("This program reads version {}; given is {}.", study_version, in_words(version)));
    Study study;
    study.fabrics = names_in(reader, "fabrics");
    study.experiments = names_in(reader, "experiments");
    study.metrics = names_in(reader, "metrics");
    read_factors(reader, study);
    read_design(reader, study);
    read_fidelity(reader, study);
    read_knobs(reader, study);
    study.replicates = count_in(reader, "replicates", 1, 1, most_replicates_of_study);
    read_seed(reader, study);
    reader.finish();
    return study;
} catch (const FileError& error) { // which calls the whole of a file a project
    const std::string_view sentence = error.what(), whole = ": the project: ";
    if (!sentence.starts_with(name) || !sentence.substr(name.size()).starts_with(whole)) throw;
    throw FileError(fmt::format("{}: {}", name, sentence.substr(name.size() + whole.size())));
}

Study read_study(const std::filesystem::path& path) { return parse_study(read_file(path, largest_study_bytes), path.string()); }

std::string format_study(const Study& study)
{
    ProjectJson json;
    json["format"] = format_name;
    json["version"] = study_version;
    if (!study.fabrics.empty()) json["fabrics"] = study.fabrics;
    if (!study.experiments.empty()) json["experiments"] = study.experiments;
    json["fidelity"] = study.fidelity ? name_of(*study.fidelity) : "auto";
    if (!study.fidelity) json["error"] = study.error;
    for (const auto& [name, value] : study.knobs) {
        const KnobInfo& knob = knob_named(name);
        if (const auto place = static_cast<std::size_t>(value); place < knob.words.size())
            json["knobs"][name] = knob.words[place];
        else
            json["knobs"][name] = value;
    }
    json["replicates"] = study.replicates;
    json["seed"] = study.seed;
    json["factors"] = ProjectJson::array();
    for (const Factor& factor : study.factors) json["factors"].push_back(json_of(factor));
    json["design"]["type"] = name_of(study.sampling);
    if (study.points > 0) json["design"]["points"] = study.points;
    if (!study.metrics.empty()) json["metrics"] = study.metrics;
    if (study.sensitivity == Sensitivity::saltelli) json["sensitivity"] = "sobol";
    if (study.sensitivity == Sensitivity::surrogate) json["sensitivity"] = "surrogate";
    return text_from_json(json);
}

void write_study(const Study& study, const std::filesystem::path& path) { write_file(path, format_study(study)); }

} // namespace hygroloom
