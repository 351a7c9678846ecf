// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The lesson's file: strict, versioned JSON. Its fabrics are those of the library, changed at will, or projects of one fabric.
#include "core/lesson/lesson.h"

#include "core/base/words.h"
#include "core/design/validate.h"
#include "core/project/atomic_file.h"
#include "core/project/json_reader.h"
#include "core/project/library.h"
#include "core/project/project_json.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {
namespace {

constexpr int lesson_version = 1;
constexpr std::size_t longest_title = 80, longest_text = 1000;

double number_from(ObjectReader& reader, const std::string& key, double otherwise, double least, double most, const char* unit)
{
    double value = otherwise;
    reader.read(key, value);
    if (!(value >= least && value <= most))
        reader.refuse(key, fmt::format("This must be from {:g} to {:g}{}; given is {:g}.", least, most, unit, value));
    return value;
}

std::string words_from(ObjectReader& reader, const std::string& key, std::size_t longest, bool may_be_empty)
{
    if (!reader.find(key)) return {}; // finish() knows whether it must be there
    std::string text;
    reader.read(key, text);
    const bool plain = std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; });
    if (text.size() > longest || !plain || (text.empty() && !may_be_empty))
        reader.refuse(key, fmt::format("This must be a text of {} to {} bytes without line breaks; given are {} bytes.",
                                       may_be_empty ? 0 : 1, longest, text.size()));
    return text;
}

int cloth_from(ObjectReader& reader, const std::string& key, std::size_t cloths)
{
    int cloth = 0;
    reader.read(key, cloth);
    if (cloth < 0 || cloth >= static_cast<int>(cloths))
        reader.refuse(key, fmt::format("This must be a cloth's place from 0 to {}; given is {}.", cloths - 1, cloth));
    return cloth;
}

template <typename Change> void each_yarn(Fabric& fabric, const Change& change)
{
    change(fabric.warp);
    change(fabric.weft);
    for (Yarn& yarn : fabric.extra_yarns) change(yarn);
}

/// A preset of the library with what the lesson changes of it.
Design changed_preset(ObjectReader& reader)
{
    std::string name, material, weave;
    reader.read("library", name);
    const std::vector<Preset>& presets = shipped_presets();
    const auto found = std::find_if(presets.begin(), presets.end(), [&](const Preset& preset) { return preset.fabric().name == name; });
    if (found == presets.end()) {
        std::vector<std::string> known;
        known.reserve(presets.size());
        for (const Preset& preset : presets) known.push_back(preset.fabric().name);
        reader.refuse("library", fmt::format("The library has no fabric \"{}\"{}", name, did_you_mean(name, known)));
    }
    Design design = found->design;
    Fabric& fabric = design.fabrics[0];
    reader.read("contact_angle_deg", fabric.contact_angle_deg);
    reader.read("material", material);
    if (!material.empty()) each_yarn(fabric, [&](Yarn& yarn) { yarn.material = {{material, 1.0}}; });
    reader.read("weave", weave);
    if (!weave.empty()) {
        try {
            fabric.weave = weave_from_pattern(weave);
        } catch (const Error& error) {
            reader.refuse("weave", error.what());
        }
    }
    return design;
}

LessonCloth cloth_in(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader reader(value, file, path);
    LessonCloth cloth;
    cloth.title = words_from(reader, "title", longest_title, false);
    const ProjectJson *library = reader.find("library"), *project = reader.find("project");
    if ((library != nullptr) + (project != nullptr) != 1)
        reader.refuse("library", "A cloth needs one of: \"library\", the name of a fabric there, or \"project\", a project of one fabric.");
    if (project) {
        cloth.design = design_from_json(*project, file + ": " + reader.path_of("project"));
        if (cloth.design.fabrics.size() != 1)
            reader.refuse("project", fmt::format("This must have 1 fabric; given are {}.", cloth.design.fabrics.size()));
        cloth.design.experiments.clear();
        cloth.design.garments.clear();
        cloth.design.wears.clear();
    } else {
        cloth.design = changed_preset(reader);
    }
    reader.finish({"title"});
    if (const std::string why_not = why_not_on_table(cloth.design); !why_not.empty()) throw FileError(file + ": " + path + ": " + why_not);
    return cloth;
}

int metric_in(ObjectReader& reader)
{
    std::string key;
    reader.read("metric", key);
    std::vector<std::string> known;
    std::string all;
    for (const LessonMetric& metric : lesson_metrics()) {
        if (key == metric.key) return static_cast<int>(known.size());
        known.emplace_back(metric.key);
        all += fmt::format("{}\"{}\"", all.empty() ? "" : ", ", metric.key);
    }
    reader.refuse("metric", fmt::format("This must be one of {}; given is \"{}\"{}", all, key, did_you_mean(key, known)));
}

LessonGoal goal_in(const ProjectJson& value, const std::string& file, const std::string& path, std::size_t cloths)
{
    constexpr const char* words[] = {"at_least", "at_most", "greater_than_cloth", "less_than_cloth"};
    ObjectReader reader(value, file, path);
    LessonGoal goal;
    goal.after_s = number_from(reader, "after_s", 0, 0, 3600, " s");
    if (!reader.find("metric")) {
        if (!reader.find("after_s")) reader.refuse("metric", "What counts as seen needs a \"metric\", or \"after_s\" alone.");
        reader.finish();
        return goal;
    }
    goal.metric = metric_in(reader);
    const bool of_table = lesson_metrics()[static_cast<std::size_t>(goal.metric)].of_table != nullptr;
    int given = 0;
    for (int k = 0; k < 4; ++k) {
        if (!reader.find(words[k])) continue;
        ++given;
        goal.compare = static_cast<LessonGoal::Compare>(k);
        if (k < 2)
            goal.limit = number_from(reader, words[k], 0, -1e6, 1e6, "");
        else
            goal.other = cloth_from(reader, words[k], cloths);
        if (k >= 2 && of_table) reader.refuse(words[k], "This number is the table's, not a cloth's; compare it by at_least or at_most.");
    }
    if (given != 1)
        reader.refuse("metric", "A metric needs one of \"at_least\", \"at_most\", \"greater_than_cloth\", \"less_than_cloth\".");
    if (reader.find("cloth")) {
        goal.cloth = cloth_from(reader, "cloth", cloths);
        if (of_table) reader.refuse("cloth", "This number is the table's, not a cloth's.");
        if (goal.compare >= LessonGoal::Compare::greater_than_cloth && *goal.cloth == goal.other)
            reader.refuse("cloth", fmt::format("A cloth is compared with another; given is cloth {} twice.", goal.other));
    }
    reader.finish();
    return goal;
}

LessonStep step_in(const ProjectJson& value, const std::string& file, const std::string& path, std::size_t cloths)
{
    ObjectReader reader(value, file, path);
    LessonStep step;
    step.text = words_from(reader, "text", longest_text, false);
    step.ask = words_from(reader, "ask", longest_text, true);
    if (const ProjectJson* seen = reader.find("seen")) step.seen = goal_in(*seen, file, reader.path_of("seen"), cloths);
    reader.finish({"text"});
    return step;
}

Climate air_in(ObjectReader& lesson, Climate air)
{
    const ProjectJson* value = lesson.find("air");
    if (!value) return air;
    ObjectReader reader(*value, lesson.file(), "air");
    air.temperature_c = number_from(reader, "temperature_c", air.temperature_c, 5, 60, " °C");
    air.relative_humidity = number_from(reader, "relative_humidity", air.relative_humidity, 0, 1, "");
    air.air_speed_m_s = number_from(reader, "air_speed_m_s", air.air_speed_m_s, 0, 5, " m/s");
    reader.finish();
    return air;
}

const ProjectJson& list_in(ObjectReader& reader, const std::string& key, std::size_t least, std::size_t most)
{
    const ProjectJson& list = array_in(reader.require(key), reader.file(), key);
    if (list.size() < least || list.size() > most)
        reader.refuse(key, fmt::format("This must be a list of {} to {} entries; given are {}.", least, most, list.size()));
    return list;
}

} // namespace

Experiment table_experiment(const Climate& air)
{
    Experiment experiment = standard_experiment(ExperimentType::droplet);
    experiment.name = "lesson";
    experiment.climate = air;
    experiment.sample_mm = {lesson_cloth_mm, lesson_cloth_mm};
    experiment.duration_s = 600;
    experiment.droplets.clear();
    return experiment;
}

std::string why_not_on_table(const Design& design)
{
    if (design.fabrics.size() != 1) return fmt::format("A cloth on the table is 1 fabric; given are {}.", design.fabrics.size());
    Design whole = design;
    whole.experiments = {table_experiment(Climate{})};
    whole.experiments[0].droplets = {Droplet{}};
    const std::vector<Issue> issues = validate(whole);
    if (const Issue* error = first_error(issues)) return error->text();
    const double side = 0.1 * lesson_cloth_mm, crossings = design.fabrics[0].ends_per_cm * design.fabrics[0].picks_per_cm * side * side;
    if (crossings > most_lesson_crossings)
        return fmt::format("A cloth of {:g} x {:g} mm may have {} crossings; this fabric has {:.0f}.", lesson_cloth_mm, lesson_cloth_mm,
                           most_lesson_crossings, crossings);
    return {};
}

Lesson parse_lesson(std::string_view text, const std::string& name)
{
    const ProjectJson json = parse_json(text, name);
    ObjectReader reader(json, name, {});
    require_format(reader, "hygroloom-lesson", lesson_version, "lessons");
    Lesson lesson;
    lesson.title = words_from(reader, "title", longest_title, false);
    lesson.air = air_in(reader, lesson.air);
    lesson.drop_ul = number_from(reader, "drop_ul", lesson.drop_ul, least_drop_ul, most_drop_ul, " ul");
    const ProjectJson& cloths = list_in(reader, "cloths", fewest_lesson_cloths, most_lesson_cloths);
    for (std::size_t i = 0; i < cloths.size(); ++i) lesson.cloths.push_back(cloth_in(cloths[i], name, fmt::format("cloths[{}]", i)));
    const ProjectJson& steps = list_in(reader, "steps", 0, most_lesson_steps);
    for (std::size_t i = 0; i < steps.size(); ++i)
        lesson.steps.push_back(step_in(steps[i], name, fmt::format("steps[{}]", i), lesson.cloths.size()));
    reader.finish({"title"});
    return lesson;
}

Lesson read_lesson(const std::filesystem::path& path) { return parse_lesson(read_file(path, largest_lesson_bytes), path.string()); }

} // namespace hygroloom
