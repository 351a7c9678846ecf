// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/study/points.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/project/project_value.h"
#include "core/study/quantiles.h"

#include <boost/random/sobol.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

constexpr std::size_t largest_matrix = 20'000'000;                                      // values of all points
constexpr std::uint64_t permutation_stream = 101, place_stream = 201, shift_stream = 1; // of the study's seed; factors add their number

[[noreturn]] void refuse_size(const std::string& what)
{
    throw Error(
        fmt::format("The study has {}; at most {} rows are allowed. Take fewer points, levels or replicates.", what, most_study_rows));
}

/// Of a list its places, of others numbers.
double entry(const Factor& factor, double probability)
{
    if (!factor.is_list()) return quantile(factor, probability).number;
    const double count = static_cast<double>(factor.values.size());
    return std::min(std::floor(probability * count), count - 1);
}

int steps_of(const Factor& factor)
{
    const double width = *factor.distribution.high - *factor.distribution.low;
    return static_cast<int>(std::floor(width / *factor.step + 1e-9)) + 1;
}

/// How many values the factor itself says that a grid has of it; 0: it leaves that open.
std::size_t own_levels(const Factor& factor)
{
    if (factor.is_list()) return factor.values.size();
    if (factor.levels) return static_cast<std::size_t>(*factor.levels);
    return factor.step ? static_cast<std::size_t>(steps_of(factor)) : 0;
}

/// Entries of a factor at that many levels: a range from end to end, others evenly from 5 to 95 % of probability.
std::vector<double> level_entries(const Factor& factor, std::size_t levels)
{
    std::vector<double> entries;
    using Type = FactorDistribution::Type;
    const bool bounded = factor.distribution.type == Type::uniform || factor.distribution.type == Type::log_uniform;
    for (std::size_t i = 0; i < levels; ++i) {
        if (factor.is_list()) {
            entries.push_back(static_cast<double>(i));
        } else {
            const double place = levels == 1 ? 0.5 : static_cast<double>(i) / static_cast<double>(levels - 1);
            entries.push_back(entry(factor, bounded ? place : 0.05 + 0.9 * place));
        }
    }
    return entries;
}

/// What all levels come to; most_study_rows + 1 stands for all that is more.
std::size_t product(const std::vector<std::size_t>& levels)
{
    std::size_t all = 1;
    for (const std::size_t count : levels) all = std::min(all * count, most_study_rows + 1); // each below 1e4 + 1
    return all;
}

/// Of each factor on the grid.
std::vector<std::size_t> grid_levels(const Study& study)
{
    std::vector<std::size_t> levels;
    for (const Factor& factor : study.factors) levels.push_back(std::max<std::size_t>(own_levels(factor), 1));
    const bool open = std::any_of(study.factors.begin(), study.factors.end(), [](const Factor& f) { return own_levels(f) == 0; });
    const std::size_t most = study.points > 0 ? study.points : most_study_rows;
    if (open && study.points == 0)
        throw Error("design: points: A grid needs its largest number of points, or \"levels\" of each range and distribution.");
    for (std::size_t count = 2; open; ++count) {
        std::vector<std::size_t> more = levels;
        for (std::size_t k = 0; k < more.size(); ++k)
            if (own_levels(study.factors[k]) == 0) more[k] = count;
        if (product(more) > most) {
            if (count > 2) break;
            throw Error(fmt::format("design: points: A grid with two levels of each range has {} points; at most {} are asked for.",
                                    product(more) > most_study_rows ? "too many" : fmt::format("{}", product(more)), most));
        }
        levels = more;
        if (count == 10000) break;
    }
    const std::size_t all = product(levels);
    if (all > most_study_rows) refuse_size(fmt::format("a grid of more than {} points", most_study_rows));
    if (all > most) throw Error(fmt::format("design: points: The grid has {} points; at most {} are asked for.", all, most));
    return levels;
}

std::vector<double> grid_numbers(const Study& study)
{
    const std::vector<std::size_t> levels = grid_levels(study);
    std::vector<std::vector<double>> entries;
    for (std::size_t k = 0; k < levels.size(); ++k) entries.push_back(level_entries(study.factors[k], levels[k]));
    std::vector<double> numbers;
    const std::size_t all = product(levels);
    for (std::size_t i = 0; i < all; ++i) {
        std::size_t left = i, stride = all;
        for (const auto& of : entries) { // the last factor changes first
            stride /= of.size();
            numbers.push_back(of[left / stride]);
            left %= stride;
        }
    }
    return numbers;
}

/// The order in which a factor goes through the strata: Fisher and Yates's shuffle.
std::vector<std::uint32_t> shuffled(std::size_t count, std::uint64_t seed, std::size_t factor)
{
    std::vector<std::uint32_t> order(count);
    for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<std::uint32_t>(i);
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random_bits(seed, permutation_stream + factor, i) % i]);
    return order;
}

/// In each of as many strata as there are points each factor has one (McKay, Beckman and Conover 1979).
std::vector<double> hypercube(std::size_t count, std::size_t dimensions, std::uint64_t seed)
{
    std::vector<double> places(count * dimensions);
    for (std::size_t k = 0; k < dimensions; ++k) {
        const std::vector<std::uint32_t> order = shuffled(count, seed, k);
        for (std::size_t i = 0; i < count; ++i)
            places[i * dimensions + k] = (order[i] + random_uniform(seed, place_stream + k, i)) / static_cast<double>(count);
    }
    return places;
}

/// Sobol's sequence from its origin, each dimension shifted digit by digit by bits of the seed.
std::vector<double> sobol_points(std::size_t count, std::size_t dimensions, std::uint64_t seed)
{
    boost::random::sobol sequence(dimensions);
    std::vector<double> places(count * dimensions);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < dimensions; ++k) {
            const std::uint64_t bits = (i == 0 ? 0 : sequence()) ^ random_bits(seed, shift_stream, k);
            places[i * dimensions + k] = (static_cast<double>(bits >> 11U) + 0.5) * 0x1.0p-53;
        }
    return places;
}

std::vector<double> sampled(const Study& study, std::size_t count, std::size_t dimensions)
{
    return study.sampling == Sampling::sobol ? sobol_points(count, dimensions, study.seed) : hypercube(count, dimensions, study.seed);
}

std::vector<double> drawn_numbers(const Study& study)
{
    const std::size_t d = study.factors.size();
    const std::vector<double> places = sampled(study, study.points, d);
    std::vector<double> numbers(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) numbers[i] = entry(study.factors[i % d], places[i]);
    return numbers;
}

/// Two samples A and B of one sampling in twice the dimensions; then A with one column of B, for each (Saltelli 2002).
std::vector<double> saltelli_numbers(const Study& study)
{
    const std::size_t d = study.factors.size(), base = saltelli_base(study);
    const std::vector<double> places = sampled(study, base, 2 * d);
    std::vector<double> numbers;
    for (std::size_t block = 0; block < d + 2; ++block)
        for (std::size_t i = 0; i < base; ++i)
            for (std::size_t k = 0; k < d; ++k) {
                const bool of_b = block == 1 || block == k + 2;
                numbers.push_back(entry(study.factors[k], places[i * 2 * d + k + (of_b ? d : 0)]));
            }
    return numbers;
}

/// The value that others change beside: as told, as the project has it, or the middle, of a list the first.
double base_entry(const Study& study, const Factor& factor, const Design& design)
{
    const std::optional<FactorValue> base = factor.base ? factor.base : own_value(study, factor, design);
    if (!factor.is_list()) return base && base->is_number ? base->number : quantile(factor, 0.5).number;
    const auto found = base ? std::find(factor.values.begin(), factor.values.end(), *base) : factor.values.end();
    return found == factor.values.end() ? 0.0 : static_cast<double>(found - factor.values.begin());
}

/// The base, then each factor's levels but the base.
std::vector<double> one_at_a_time_numbers(const Study& study, const Design& design)
{
    std::vector<double> base;
    for (const Factor& factor : study.factors) base.push_back(base_entry(study, factor, design));
    std::vector<double> numbers = base;
    for (std::size_t k = 0; k < base.size(); ++k) {
        const std::size_t own = own_levels(study.factors[k]);
        for (const double value : level_entries(study.factors[k], own > 0 ? own : 2)) {
            if (value == base[k]) continue;
            numbers.insert(numbers.end(), base.begin(), base.end());
            numbers[numbers.size() - base.size() + k] = value;
        }
    }
    return numbers;
}

std::size_t points_of_design(const Study& study)
{
    if (study.factors.empty()) return 1;
    if (study.sampling == Sampling::grid) return product(grid_levels(study));
    if (study.sampling == Sampling::one_at_a_time) {
        std::size_t all = 1;
        for (const Factor& factor : study.factors) all += std::max<std::size_t>(own_levels(factor), 2);
        if (study.points > 0 && all > study.points)
            throw Error(fmt::format("design: points: One at a time makes {} points; at most {} are asked for.", all, study.points));
        return all;
    }
    return study.sensitivity == Sensitivity::saltelli ? saltelli_base(study) * (study.factors.size() + 2) : study.points;
}

} // namespace

FactorValue quantile(const Factor& factor, double probability)
{
    if (factor.is_list()) return factor.values[static_cast<std::size_t>(entry(factor, probability))];
    if (factor.step) {
        const int steps = steps_of(factor);
        const int place = std::min(static_cast<int>(probability * steps), steps - 1);
        return factor_value(rounded_for_all(*factor.distribution.low + place * *factor.step));
    }
    return factor_value(rounded_for_all(quantile(factor.distribution, probability)));
}

std::optional<FactorValue> own_value(const Study& study, const Factor& factor, const Design& design)
{
    if (factor.path.starts_with(knob_prefix)) {
        const KnobInfo& knob = knob_named(factor.path.substr(knob_prefix.size()));
        const auto set = study.knobs.find(knob.name);
        const double number = set != study.knobs.end() ? set->second : knobs_of(study.fidelity.value_or(Fidelity::standard)).*knob.value;
        const auto place = static_cast<std::size_t>(number);
        return place < knob.words.size() ? factor_value(std::string(knob.words[place])) : factor_value(number);
    }
    const ProjectJson there = value_at(design, factor.path);
    if (there.is_number()) return factor_value(there.get<double>());
    if (there.is_boolean()) return factor_value(std::string(there.get<bool>() ? "true" : "false"));
    if (there.is_string()) return factor_value(there.get<std::string>());
    return std::nullopt;
}

FactorValue StudyPoints::value(std::size_t point, std::size_t factor) const
{
    const double number = numbers_[point * factors_.size() + factor];
    const Factor& of = factors_[factor];
    return of.is_list() ? of.values[static_cast<std::size_t>(number)] : factor_value(number);
}

std::size_t saltelli_base(const Study& study) { return study.points / (study.factors.size() + 2); }

std::size_t count_points(const Study& study)
{
    const std::size_t points = points_of_design(study);
    if (points > most_study_rows) refuse_size(fmt::format("{} points", points));
    if (points * study.factors.size() > largest_matrix)
        throw Error(fmt::format("The study has {} points of {} factors, {} values; at most {} are allowed. Take fewer points or factors.",
                                points, study.factors.size(), points * study.factors.size(), largest_matrix));
    return points;
}

StudyPoints study_points(const Study& study, const Design& design)
{
    count_points(study); // refuses what is too large
    if (study.factors.empty()) return {{}, {}};
    switch (study.sampling) {
    case Sampling::grid: return {study.factors, grid_numbers(study)};
    case Sampling::one_at_a_time: return {study.factors, one_at_a_time_numbers(study, design)};
    case Sampling::latin_hypercube:
    case Sampling::sobol: break;
    }
    return {study.factors, study.sensitivity == Sensitivity::saltelli ? saltelli_numbers(study) : drawn_numbers(study)};
}

PointSetting with_point(const Study& study, const ProjectJson& project, const StudyPoints& points, std::size_t point)
{
    PointSetting setting;
    setting.knobs = study.knobs;
    std::vector<std::pair<std::string, std::string>> values;
    for (std::size_t k = 0; k < points.factors().size(); ++k) {
        const std::string& path = points.factors()[k].path;
        const std::string text = points.value(point, k).text;
        if (path.starts_with(knob_prefix))
            set_knob(setting.knobs, path.substr(knob_prefix.size()), text);
        else
            values.emplace_back(path, text);
    }
    setting.design = with_values(project, values);
    return setting;
}

} // namespace hygroloom
