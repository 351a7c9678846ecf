// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/measured_data.h"

#include "core/analysis/laboratory_table.h"
#include "core/analysis/series_keys.h"
#include "core/base/csv_table.h"
#include "core/base/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace hygroloom {
namespace {

constexpr const char *absorbed = "water_absorbed_g", *left_over = "water_left_g";

std::string unit_in(const std::string& key)
{
    const std::string end = key.substr(key.rfind('_') + 1);
    return end == "mm" || end == "g" ? end : end == "c" ? "°C" : end == "pct" ? "%" : "";
}

/// Amounts against the start may be: air may dry the cloth, or wet it.
bool can_be_negative(const std::string& curve) { return curve.ends_with("_c") || curve == "evaporated_g" || curve == absorbed; }

/// All have a spread above 0, or none has one.
void check_spreads(const MeasuredData& data)
{
    const auto with = std::count_if(data.numbers.begin(), data.numbers.end(), [](const MeasuredNumber& n) { return n.spread.has_value(); });
    for (const MeasuredNumber& number : data.numbers)
        if (number.spread && !(*number.spread > 0))
            throw Error(fmt::format("{}: A spread must be more than 0; given is {:g}.", data.file, *number.spread));
    if (with != 0 && with != static_cast<std::ptrdiff_t>(data.numbers.size()))
        throw Error(fmt::format("{}: Give all rows a spread or none; {} of {} have one.", data.file, with, data.numbers.size()));
    if (!data.is_curve() && with == 0 && data.numbers.size() > 1)
        throw Error(fmt::format("{}: Several metrics need a spread each, by which they are weighed against each other.", data.file));
}

MeasuredData read_curve(const std::string& text, const std::string& file, const std::string& key, const Experiment& experiment)
{
    const CsvTable csv = read_csv(text, file, {"time_s", key}, {"spread"});
    MeasuredData data{file, key, unit_in(key), {}};
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
        MeasuredNumber number{key, data.unit, number_in(csv, row, 0, "time_s"), number_in(csv, row, 1, key), {}};
        if (!(number.time >= 0 && number.time <= experiment.duration_s))
            throw Error(fmt::format("{}: line {}: time_s must be from 0 to {:g}, the end of \"{}\"; given is {:g}.", file, csv.lines[row],
                                    experiment.duration_s, experiment.name, number.time));
        if (number.value < 0 && !can_be_negative(key))
            throw Error(fmt::format("{}: line {}: {} must be 0 or more; given is {:g}.", file, csv.lines[row], key, number.value));
        if (!csv.rows[row][2].empty()) number.spread = number_in(csv, row, 2, "spread");
        data.numbers.push_back(std::move(number));
    }
    std::stable_sort(data.numbers.begin(), data.numbers.end(),
                     [](const MeasuredNumber& a, const MeasuredNumber& b) { return a.time < b.time; });
    return data;
}

MeasuredData read_metrics(const std::string& text, const std::string& file, const Design& design, const Fabric& fabric,
                          const Experiment& experiment)
{
    std::vector<std::string> fabrics;
    for (const Fabric& one : design.fabrics) fabrics.push_back(one.name);
    std::vector<std::pair<std::string, std::string>> metrics;
    for (const OutcomeInfo& info : compared_by(experiment.type)) metrics.emplace_back(info.key, info.unit);
    MeasuredData data{file, "metrics", {}, {}};
    for (const LaboratoryValue& value : read_laboratory_table(text, file, fabrics, metrics)) {
        if (value.fabric != fabric.name) continue;
        const auto metric = std::find_if(metrics.begin(), metrics.end(), [&](const auto& pair) { return pair.first == value.metric; });
        data.numbers.push_back({value.metric, metric->second, 0, value.value, value.spread});
    }
    return data;
}

/// Of a whole run, at its frames.
std::vector<double> curve_of(const std::string& key, const Metrics& metrics)
{
    const Series& s = metrics.series;
    for (const SeriesKey& series : series_keys())
        if (key == series.key) return values_of(series, s);
    std::vector<double> grams;
    for (std::size_t i = 0; i < s.time.size(); ++i)
        grams.push_back(1e3 * (key == left_over ? metrics.ledger.water_delivered - s.evaporated[i]
                                                : s.yarn_water[i] + s.bound_water[i] - metrics.ledger.water_initial));
    return grams;
}

/// On the line of least squares through the frames within a tenth of the time, through the two beside it at least. A simulated front waits
/// and leaps from crossing to crossing: the frames about it tell where it would be.
double at_time(const std::vector<double>& times, const std::vector<double>& values, double time)
{
    constexpr double about = 0.1;
    auto first = std::lower_bound(times.begin(), times.end(), (1 - about) * time) - times.begin();
    auto last = std::upper_bound(times.begin(), times.end(), (1 + about) * time) - times.begin(); // one after
    const auto after = std::lower_bound(times.begin(), times.end(), time) - times.begin(), frames = std::ssize(times);
    first = std::max(std::ptrdiff_t{0}, std::min(first, after - 1));
    last = std::min(frames, std::max(last, after + 1));
    double n = 0, t = 0, v = 0, tt = 0, tv = 0; // from the asked time on
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
        const double later = times[i] - time;
        n += 1;
        t += later;
        v += values[i];
        tt += later * later;
        tv += later * values[i];
    }
    const double spread = n * tt - t * t;
    return spread > 0 ? (tt * v - t * tv) / spread : v / n;
}

double metric_of(const std::string& key, const std::vector<Outcome>& outcomes)
{
    for (const Outcome& outcome : outcomes) {
        if (outcome.key != key) continue;
        if (outcome.value) return *outcome.value;
        throw Error(fmt::format("The simulation gives no {}: {}.", full_title(outcome), outcome.missing));
    }
    throw Error(fmt::format("The experiment gives no {}.", key));
}

} // namespace

std::vector<std::string> measurable_curves(ExperimentType type)
{
    std::vector<std::string> keys;
    for (const SeriesKey& series : series_keys()) {
        const std::string key = series.key;
        const bool has = series.of_all || (key == "wick_height_mm" ? is_strip(type) : uses_field(type, "feed_s"));
        if (has && key != "time_s" && key != "air_temperature_c") keys.push_back(key);
    }
    keys.emplace_back(absorbed);
    if (starts_wet(type)) keys.emplace_back(left_over);
    return keys;
}

MeasuredData read_measured_data(const std::string& text, const std::string& file, const Design& design, const Fabric& fabric,
                                const Experiment& experiment)
{
    const std::vector<std::string> header = csv_header(text, file), curves = measurable_curves(experiment.type);
    const auto has = [&](const std::string& name) { return std::find(header.begin(), header.end(), name) != header.end(); };
    MeasuredData data;
    if (has("metric")) {
        data = read_metrics(text, file, design, fabric, experiment);
    } else {
        std::vector<std::string> given;
        std::copy_if(curves.begin(), curves.end(), std::back_inserter(given), has);
        if (given.size() != 1)
            throw Error(fmt::format("{}: A curve has the columns time_s and one of {}, which \"{}\" gives; the columns here are {}.", file,
                                    fmt::join(curves, ", "), experiment.name, column_list(header)));
        data = read_curve(text, file, given.front(), experiment);
    }
    if (data.numbers.empty()) throw Error(fmt::format("{}: There is no number of {}.", file, fabric.name));
    check_spreads(data);
    return data;
}

std::vector<double> simulated_of(const MeasuredData& data, const RunRecord& run, const Metrics& metrics)
{
    const std::vector<double> curve = data.is_curve() ? curve_of(data.quantity, metrics) : std::vector<double>();
    const std::vector<Outcome> outcomes = data.is_curve() ? std::vector<Outcome>() : outcomes_of(run, metrics);
    std::vector<double> values;
    for (const MeasuredNumber& number : data.numbers)
        values.push_back(data.is_curve() ? at_time(metrics.series.time, curve, number.time) : metric_of(number.key, outcomes));
    return values;
}

} // namespace hygroloom
