// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What laboratories read from the curves of wicking, drying and conditioning tests. All from time series; SI.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace hygroloom {

/// How far a strip's liquid has come by one time.
struct Rise {
    double height = 0; ///< m
    double water = 0;  ///< kg for each m of the strip's width, drawn from the bath
};
constexpr std::array<int, 3> rise_minutes{5, 10, 30}; ///< that laboratories wait

/// Of a strip that hangs in liquid (AATCC 197).
struct WickingResult {
    double height = 0;          ///< m, at the end
    std::optional<double> rate; ///< m/s^0.5, slope of height against the root of time, least squares from its first rise to where it stops
    std::array<std::optional<Rise>, rise_minutes.size()> after{}; ///< after rise_minutes; none: the test ended earlier
};
/// water: kg for each m of width, at each time.
WickingResult wicking_result(const std::vector<double>& time, const std::vector<double>& height, const std::vector<double>& water);

/// Shares of the water that are left where the constant-rate period begins and ends. Where fibres hold much of the water it ends earlier:
/// as soon as the drying rate falls below 98 % of its mean over the period.
constexpr double steady_from = 0.8, steady_to = 0.3;

constexpr double g_m2_h_per_kg_m2_s = 3.6e6; ///< rates of drying

/// Of a wet sample in an air stream (AATCC 199 and 201).
struct DryingResult {
    std::optional<double> rate;               ///< kg/(m2 s) of sample, mean over the constant-rate period
    std::optional<double> steady_temperature; ///< K, mean over that period
    std::optional<double> time_to_dry;        ///< s, until 4 % of the water is left
    std::optional<double> index;              ///< 1/s: the rate over the water at the start
};
/// left: kg of the water that was added and is still there; area in m2.
DryingResult drying_result(const std::vector<double>& time, const std::vector<double>& left, const std::vector<double>& temperature,
                           double area);

/// Of a sample in a new climate.
struct ConditioningResult {
    double regain_start = 0, regain_end = 0;
    std::optional<double> half_time; ///< s, until half of the change; none where nothing changed
    double peak_rise = 0;            ///< K, of the sample's mean temperature over the air's, at most
    bool settled = false;            ///< whether the last tenth of the time changed the regain by less than 2 % of the whole change
};
ConditioningResult conditioning_result(const std::vector<double>& time, const std::vector<double>& regain,
                                       const std::vector<double>& temperature, const std::vector<double>& air_temperature);

} // namespace hygroloom
