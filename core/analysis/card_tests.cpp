// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/card_tests.h"

#include "core/base/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace hygroloom {
namespace {

/// An outcome of a run as a card has it.
struct CardRow {
    std::string outcome, key, title, unit;
    double times = 1; ///< the outcome's value
};

struct TestRow {
    const char *key, *title, *standard;
    std::vector<CardRow> rows;
};

std::vector<CardRow> rises_along(const std::string& system)
{
    std::vector<CardRow> rows;
    for (const auto& [what, title, unit] : {std::tuple("height", "Wicking height", "mm"), std::tuple("water", "Water drawn in", "mg/mm")})
        for (const int minutes : rise_minutes) {
            const std::string ending = fmt::format("{}_min_{}", minutes, unit == std::string("mm") ? "mm" : "mg_mm");
            rows.push_back({fmt::format("wick_{}_{}", what, ending), fmt::format("wick_{}_{}_{}", what, system, ending),
                            fmt::format("{} along the {}, {} min", title, system, minutes), unit});
        }
    return rows;
}

const std::vector<TestRow>& all_tests()
{
    static const std::vector<TestRow> tests{
        {"absorbency",
         "Absorbency",
         "AATCC 79",
         {{"absorbency_time_s", "absorbency_time_s", "Absorbency time", "s"},
          {"wetted_area_mm2", "stain_area_1_min_mm2", "Area of the stain after 1 min", "mm²"}}},
        {"wicking_warp", "Wicking along the warp", "AATCC 197, DIN 53924", rises_along("warp")},
        {"wicking_weft", "Wicking along the weft", "AATCC 197, DIN 53924", rises_along("weft")},
        {"management",
         "Moisture management",
         "AATCC 195",
         {{"wetting_time_top_s", "wetting_time_top_s", "Wetting time, top", "s"},
          {"wetting_time_bottom_s", "wetting_time_bottom_s", "Wetting time, bottom", "s"},
          {"absorption_rate_top_pct_s", "absorption_rate_top_pct_s", "Absorption rate, top", "%/s"},
          {"absorption_rate_bottom_pct_s", "absorption_rate_bottom_pct_s", "Absorption rate, bottom", "%/s"},
          {"maximum_wetted_radius_top_ring_mm", "maximum_wetted_radius_top_ring_mm", "Wetted radius, top", "mm"},
          {"maximum_wetted_radius_bottom_ring_mm", "maximum_wetted_radius_bottom_ring_mm", "Wetted radius, bottom", "mm"},
          {"spreading_speed_top_mm_s", "spreading_speed_top_mm_s", "Spreading speed, top", "mm/s"},
          {"spreading_speed_bottom_mm_s", "spreading_speed_bottom_mm_s", "Spreading speed, bottom", "mm/s"},
          {"one_way_transport_pct", "one_way_transport_pct", "One-way transport", "%"},
          {"ommc", "ommc", "Overall capability (OMMC)", ""},
          {"fabric_class", "fabric_class", "Class", ""}}},
        {"drying",
         "Drying",
         "after ISO 17617, AATCC 200",
         {{"time_to_dry_s", "drying_time_min", "Drying time", "min", 1.0 / 60},
          {"drying_rate_g_m2_h", "drying_rate_g_m2_h", "Drying rate", "g/(m² h)"},
          {"drying_index_pct_min", "drying_index_pct_min", "Drying index", "%/min"}}},
        {"regain",
         "Regain",
         "ISO 139",
         {{"regain_end", "regain_percent", "Regain at 65 % humidity", "%", 100},
          {"regain_half_time_s", "regain_half_time_s", "Half-change time of the regain", "s"}}}};
    return tests;
}

const TestRow& row_of(const std::string& key)
{
    return *std::find_if(all_tests().begin(), all_tests().end(), [&](const TestRow& row) { return row.key == key; });
}

/// AATCC 79 lets a drop of some 50 ul fall.
Experiment absorbency_test()
{
    Experiment e = standard_experiment(ExperimentType::droplet);
    e.climate = {21, 0.65, 0.1};
    e.sample_mm = {60, 60};
    e.duration_s = 60;
    e.droplets = {Droplet{50, 0, {0, 0}, 2, 0}};
    return e;
}

/// Narrow, as all of its threads draw alike, and longer than water rises in 30 min.
Experiment wicking_test(const Fabric& fabric, bool along_weft)
{
    constexpr double least_mm = 2, threads = 12, length_mm = 400;
    Experiment e = standard_experiment(ExperimentType::vertical_wicking);
    const double per_cm = along_weft ? fabric.picks_per_cm : fabric.ends_per_cm;
    e.sample_mm = {std::max(least_mm, 10 * threads / per_cm), length_mm};
    e.duration_s = 60.0 * rise_minutes.back();
    e.along_weft = along_weft;
    return e;
}

/// As wet as it has drained, so long that it surely dries.
Experiment drying_test(const std::vector<LaboratoryNumber>& known)
{
    constexpr double least_g_m2 = 1, slow_g_m2_s = 50.0 / 3600; // slower than any cloth in such air
    const auto drained = std::find_if(known.begin(), known.end(), [](const auto& n) { return n.key == "absorption_drained_g_m2"; });
    if (drained == known.end() || drained->estimate.value < least_g_m2) throw Error("The cloth keeps no water that could dry.");
    Experiment e = standard_experiment(ExperimentType::drying);
    e.initial_water_g_m2 = std::round(10 * drained->estimate.value) / 10;
    e.duration_s = std::max(3600.0, std::ceil(e.initial_water_g_m2 / slow_g_m2_s / 60) * 60);
    return e;
}

std::string conditions_of(const Experiment& e)
{
    std::string text = fmt::format("{:g} °C, {:g} % humidity", e.climate.temperature_c, 100 * e.climate.relative_humidity);
    if (e.type == ExperimentType::droplet) text += fmt::format(", one drop of {:g} µl", e.droplets.front().volume_ul);
    if (e.type == ExperimentType::moisture_management) text += fmt::format(", {:g} µl of saline in {:g} s", e.volume_ul, e.feed_s);
    if (e.type == ExperimentType::vertical_wicking)
        text +=
            fmt::format(", strip hangs, {:g} mm of it in water; some cm up the rooms between the yarns empty, and the yarns draw alone; "
                        "water for each mm of the strip's width",
                        e.immersion_mm);
    if (e.type == ExperimentType::drying)
        text += fmt::format(", air {:g} m/s, {:g} g/m² at the start", e.climate.air_speed_m_s, e.initial_water_g_m2);
    if (e.type == ExperimentType::conditioning) text += ", from dry";
    return text;
}

LaboratoryNumber number_of(const CardTest& test, const CardRow& row)
{
    return {row.key, row.title, row.unit, row_of(test.key).standard, conditions_of(test.experiment), {}, ""};
}

} // namespace

const std::vector<std::string>& card_test_keys()
{
    static const std::vector<std::string> keys = [] {
        std::vector<std::string> all;
        for (const TestRow& row : all_tests()) all.emplace_back(row.key);
        return all;
    }();
    return keys;
}

std::vector<std::string> card_test_keys(const std::vector<std::string>& given)
{
    const std::vector<std::string>& all = card_test_keys();
    if (given == std::vector<std::string>{"all"}) return all;
    std::vector<std::string> chosen;
    for (const std::string& key : given)
        if (std::find(all.begin(), all.end(), key) == all.end())
            throw Error(fmt::format("A card has no test \"{}\". It has {}; all stands for all of them.", key, fmt::join(all, ", ")));
    for (const std::string& key : all)
        if (std::find(given.begin(), given.end(), key) != given.end()) chosen.push_back(key);
    return chosen;
}

CardTest card_test(const std::string& key, const Fabric& fabric, const std::vector<LaboratoryNumber>& known)
{
    CardTest test{key, row_of(key).title, {}};
    if (key == "absorbency") test.experiment = absorbency_test();
    if (key == "wicking_warp" || key == "wicking_weft") test.experiment = wicking_test(fabric, key == "wicking_weft");
    if (key == "management") test.experiment = standard_experiment(ExperimentType::moisture_management);
    if (key == "drying") test.experiment = drying_test(known);
    if (key == "regain") test.experiment = standard_experiment(ExperimentType::conditioning);
    test.experiment.name = key;
    return test;
}

std::vector<LaboratoryNumber> unknown_numbers(const CardTest& test)
{
    std::vector<LaboratoryNumber> numbers;
    for (const CardRow& row : row_of(test.key).rows) numbers.push_back(number_of(test, row));
    return numbers;
}

void add_test_numbers(LaboratoryNumbers& numbers, const CardTest& test, const Candidate& candidate, const std::string& run)
{
    if (!candidate.failure.empty()) {
        numbers.missing.push_back(fmt::format("{} is missing. {}", test.title, candidate.failure));
        return;
    }
    for (const CardRow& row : row_of(test.key).rows) {
        const auto outcome =
            std::find_if(candidate.outcomes.begin(), candidate.outcomes.end(), [&](const Outcome& one) { return one.key == row.outcome; });
        const auto interval = candidate.intervals.find(row.outcome);
        LaboratoryNumber number = number_of(test, row);
        number.run = run;
        if (outcome != candidate.outcomes.end()) {
            number.text = outcome->text;
            number.grade = outcome->grade.value_or(0);
        }
        if (interval != candidate.intervals.end()) {
            const Interval& of = interval->second;
            number.estimate = scaled({of.centre, of.low, of.high}, row.times);
            if (!of.numerical_known) number.conditions += "; the error of the computation is not known";
        } else if (number.text.empty()) {
            const std::string why = outcome == candidate.outcomes.end() ? std::string() : outcome->missing;
            numbers.missing.push_back(fmt::format("{} is missing{}.", row.title, why.empty() ? why : ": " + why));
            continue;
        }
        numbers.found.push_back(std::move(number));
    }
    if (!candidate.metrics) return;
    for (const std::string& note : candidate.metrics->notes) numbers.notes.push_back(fmt::format("{}: {}", test.title, note));
    if (const double times = candidate.metrics->unsettled; times > 0)
        numbers.notes.push_back(
            fmt::format("{}: {:.0f} {} the computation did not settle along a yarn.", test.title, times, times > 1 ? "times" : "time"));
}

} // namespace hygroloom
