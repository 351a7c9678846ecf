// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a calibration's fit says of its inputs, and what it does not.
#include "core/analysis/calibration_fit.h"
#include "core/analysis/intervals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double told_apart = 0.99; ///< largest correlation of two inputs
/// Of the scaled normal matrix; two inputs correlated by 0.99 have 199. Larger: three that only together cannot be told apart.
constexpr double largest_condition = 1e4;

/// How many values a number takes as an input moves: as many as there are runs unless it stands still and jumps.
int values_of(const std::vector<std::vector<double>>& simulated, std::size_t number)
{
    constexpr double same = 1e-9;
    int values = 1;
    for (std::size_t i = 1; i < simulated.size(); ++i) {
        const double before = simulated[i - 1][number], now = simulated[i][number];
        values += std::abs(now - before) > same * std::max(std::abs(now), std::abs(before)) ? 1 : 0;
    }
    return values;
}

bool has_spreads(const MeasuredData& data) { return data.numbers.front().spread.has_value(); }

/// By how much standard deviations widen as neighbours on a curve deviate alike: root of (1 + r) / (1 - r) of a series whose neighbours
/// are correlated by r (Bayley and Hammersley 1946).
double alike_neighbours(const MeasuredData& data, const VectorXd& residuals)
{
    const Index n = residuals.size();
    if (!data.is_curve() || n < 4) return 1;
    const double r = residuals.head(n - 1).dot(residuals.tail(n - 1)) / std::max(residuals.squaredNorm(), 1e-300);
    return std::sqrt((1 + std::clamp(r, 0.0, 0.95)) / (1 - std::clamp(r, 0.0, 0.95)));
}

/// Half widths of the places' intervals.
VectorXd half_widths(const MeasuredData& data, const MatrixXd& jacobian, const VectorXd& residuals, const MatrixXd& inverse)
{
    const int free = static_cast<int>(jacobian.rows() - jacobian.cols());
    const double variance = free > 0 ? residuals.squaredNorm() / free : 0;
    const VectorXd plain = inverse.diagonal().cwiseMax(0).cwiseSqrt();
    const double alike = alike_neighbours(data, residuals);
    if (has_spreads(data)) return of_intervals.normal * std::max(1.0, std::sqrt(variance) * alike) * plain;
    const MatrixXd reach = jacobian * inverse; // of each number on each input
    const VectorXd leverage = reach.cwiseProduct(jacobian).rowwise().sum();
    VectorXd left = residuals.array() / (1 - leverage.array()).max(1e-3);
    const VectorXd uneven = (left.asDiagonal() * reach).colwise().norm();
    return student_factor(of_intervals, free) * alike * (std::sqrt(variance) * plain).cwiseMax(uneven);
}

/// Whether a number stands still and jumps as an input moves, or changes by less than one of its jumps: its slope says where a jump lies.
bool jumps(const Surroundings::Line& line, std::size_t number, double step)
{
    constexpr int fewest_values = 4; // of five
    return values_of(line.simulated, number) < fewest_values ||
           std::abs(line.simulated.back()[number] - line.simulated.front()[number]) < step;
}

std::string jump_in_words(const Calibration& result, const Surroundings& about, std::size_t k, std::size_t number, double step)
{
    const MeasuredNumber& of = result.data.numbers[number];
    const FittedInput& input = result.inputs[k];
    const Surroundings::Line& line = about.lines[k];
    double low = line.simulated.front()[number], high = low;
    for (const std::vector<double>& each : line.simulated) {
        low = std::min(low, each[number]);
        high = std::max(high, each[number]);
    }
    const int values = values_of(line.simulated, number);
    return fmt::format(
        "{}{} jumps{}, so that it does not tell the {}: {} runs from {:.3g} to {:.3g}{} give {} of it, {:.4g}{} {}. Fit a curve "
        "over time, or a number that changes smoothly.",
        of.key, result.data.is_curve() ? fmt::format(" at {:g} s", of.time) : "",
        step > 0 ? fmt::format(" by {:.2g} {} from crossing to crossing", step, of.unit) : "", input.title, line.simulated.size(), line.low,
        line.high, input.unit, values == 1 ? "one value" : fmt::format("{} values", values), low,
        values == 1 ? "" : fmt::format(" to {:.4g}", high), of.unit);
}

/// Where more than half of what tells an input comes from numbers that jump.
std::string refused_jumps(const Calibration& result, const Surroundings& about, const std::vector<NumberError>& errors)
{
    for (std::size_t k = 0; k < result.inputs.size(); ++k) {
        const VectorXd told = about.jacobian.col(static_cast<Index>(k)).cwiseAbs2();
        double by_jumps = 0, most = 0;
        std::size_t worst = 0;
        for (std::size_t i = 0; i < result.data.numbers.size(); ++i) {
            const double by_it = told[static_cast<Index>(i)];
            if (!jumps(about.lines[k], i, errors.empty() ? 0 : errors[i].step)) continue;
            by_jumps += by_it;
            if (by_it > most) worst = i;
            most = std::max(most, by_it);
        }
        if (by_jumps > 0.5 * told.sum()) return jump_in_words(result, about, k, worst, errors.empty() ? 0 : errors[worst].step);
    }
    return {};
}

/// Whether a tried point differs from the fit in no input but one.
bool moves_only(const Calibration& result, const std::vector<double>& point, std::size_t k)
{
    constexpr double rounding = 1e-9; // of the range
    for (std::size_t i = 0; i < point.size(); ++i) {
        const FittedInput& input = result.inputs[i];
        if (i != k && std::abs(point[i] - input.value) > rounding * (input.high - input.low)) return false;
    }
    return true;
}

/// Of an input that changed nothing about the fit: whether the numbers changed anywhere as it alone moved.
std::string refused_silence(const Calibration& result, const Fit& fit, const Surroundings& about, std::size_t k,
                            const std::vector<NumberError>& errors)
{
    for (const auto& [point, simulated] : fit.tried())
        for (std::size_t i = 0; moves_only(result, point, k) && i < simulated.size(); ++i)
            if (values_of({result.fitted, simulated}, i) > 1)
                return jump_in_words(result, about, k, i, errors.empty() ? 0 : errors[i].step);
    return fmt::format("The data do not depend on the {}; nothing can be told of it.", result.inputs[k].title);
}

/// How far from each fitted value a point was tried that the data allow as well as the ends of a linear interval: where the numbers do not
/// follow an input evenly, other values may fit as well. In the inputs' units.
std::vector<double> reaches(const Calibration& result, const Fit& fit, const VectorXd& residuals)
{
    const auto free = static_cast<int>(residuals.size()) - fit.inputs();
    double least = residuals.squaredNorm();
    for (const auto& [point, simulated] : fit.tried()) least = std::min(least, fit.weighed(simulated).squaredNorm());
    const double variance = free > 0 ? least / free : 0;
    const double own = has_spreads(result.data) ? std::max(1.0, variance) : variance;
    const double factor = has_spreads(result.data) ? of_intervals.normal : student_factor(of_intervals, free);
    const double allowed = least + own * std::pow(factor * alike_neighbours(result.data, residuals), 2);
    std::vector<double> far(result.inputs.size(), 0.0);
    for (const auto& [point, simulated] : fit.tried()) {
        if (fit.weighed(simulated).squaredNorm() > allowed) continue;
        for (std::size_t k = 0; k < far.size(); ++k) far[k] = std::max(far[k], std::abs(point[k] - result.inputs[k].value));
    }
    return far;
}

/// Half widths of the places' intervals by how unevenly the numbers follow the input: what five runs would be fitted as, by the same linear
/// fit, scatters about where they were made. It contains what all numbers do alike, which no residual shows.
VectorXd uneven_halves(const Surroundings& about, const MatrixXd& moved)
{
    constexpr int free = Surroundings::runs - 2; // a line's level and slope
    VectorXd halves(moved.rows());
    for (Index k = 0; k < moved.rows(); ++k) {
        const Eigen::RowVectorXd fitted = moved.row(k) * about.lines[static_cast<std::size_t>(k)].residuals;
        double squares = 0;
        for (int i = 0; i < Surroundings::runs; ++i) squares += std::pow(fitted[i] - fitted.mean() - Surroundings::offset(i), 2);
        halves[k] = student_factor(of_intervals, free) * std::sqrt(squares / free);
    }
    return halves;
}

/// Half widths of the places' intervals by the numerical errors of the numbers, carried through the fit. Those of a curve are one error.
VectorXd numerical_halves(Calibration& result, const std::vector<NumberError>& errors, const MatrixXd& moved)
{
    VectorXd weighed = VectorXd::Zero(moved.cols());
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const MeasuredNumber& number = result.data.numbers[i];
        weighed[static_cast<Index>(i)] = errors[i].half.value_or(0) / number.spread.value_or(1);
        if (!errors[i].half && (i == 0 || !result.data.is_curve()))
            result.notes.push_back(fmt::format("The numerical error of {} is not known; the intervals lack it.", number.key));
    }
    const MatrixXd each = moved * weighed.asDiagonal(); // of each input by each number's error
    return result.data.is_curve() ? VectorXd(each.rowwise().sum().cwiseAbs()) : VectorXd(each.rowwise().norm());
}

std::string refused_correlation(const Calibration& result)
{
    for (std::size_t i = 0; i < result.inputs.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (std::abs(result.correlation[i][k]) > told_apart)
                return fmt::format("The data cannot tell the {} from the {}: raising one does the same as changing the other (correlation "
                                   "{:.3f}). Fit one of them, or measure something else besides.",
                                   result.inputs[k].title, result.inputs[i].title, result.correlation[i][k]);
    return {};
}

std::string refused_values(const Calibration& result)
{
    for (const FittedInput& input : result.inputs)
        if (2 * input.half > input.high - input.low)
            return fmt::format("The data do not tell the {}: its interval, {:.3g} ± {:.2g}{}, is wider than its range, {:.3g} to {:.3g}{}.",
                               input.title, input.value, input.half, input.unit, input.low, input.high, input.unit);
    for (const FittedInput& input : result.inputs) {
        const double range = input.high - input.low;
        for (const double end : {input.low, input.high})
            if (std::abs(input.value - end) < edge_share * range)
                return fmt::format(
                    "The {} ends at the edge of its range, {:.3g}{}: the measured numbers lie beyond what {:.3g} to {:.3g}{} "
                    "gives. Check the measurement, or give the fabric a wider uncertainty.{}.",
                    input.title, end, input.unit, input.low, input.high, input.unit, input.key);
    }
    return {};
}

/// Intervals and correlations, and what they do not allow to say.
void judge(Calibration& result, const Fit& fit, const Surroundings& about, const VectorXd& residuals,
           const std::vector<NumberError>& errors)
{
    const MatrixXd& jacobian = about.jacobian;
    const Index n = jacobian.cols();
    const VectorXd scale = jacobian.colwise().norm();
    for (Index k = 0; k < n; ++k)
        if (!(scale[k] > 1e-9 * std::max(1.0, scale.maxCoeff()))) {
            result.refusal = refused_silence(result, fit, about, static_cast<std::size_t>(k), errors);
            return;
        }
    const MatrixXd scaled = jacobian * scale.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> normal(scaled.transpose() * scaled);
    const VectorXd eigen = normal.eigenvalues().cwiseMax(1e-15);
    const MatrixXd scaled_inverse = normal.eigenvectors() * eigen.cwiseInverse().asDiagonal() * normal.eigenvectors().transpose();
    const VectorXd deviation = scaled_inverse.diagonal().cwiseSqrt();
    for (Index i = 0; i < n; ++i) {
        result.correlation.emplace_back();
        for (Index k = 0; k < n; ++k) result.correlation.back().push_back(scaled_inverse(i, k) / (deviation[i] * deviation[k]));
    }
    const MatrixXd inverse = scale.cwiseInverse().asDiagonal() * scaled_inverse * scale.cwiseInverse().asDiagonal();
    const MatrixXd moved = inverse * jacobian.transpose(); // of each input by each number
    const VectorXd by_residuals = half_widths(result.data, jacobian, residuals, inverse), by_unevenness = uneven_halves(about, moved),
                   by_runs = numerical_halves(result, errors, moved);
    const std::vector<double> as_good = reaches(result, fit, residuals);
    for (Index k = 0; k < n; ++k) {
        FittedInput& input = result.inputs[static_cast<std::size_t>(k)];
        const double range = input.high - input.low;
        input.uneven = by_unevenness[k] * range;
        input.numerical = by_runs[k] * range;
        input.half = std::hypot(std::max(by_residuals[k] * range, as_good[static_cast<std::size_t>(k)]), input.uneven, input.numerical);
    }
    result.refusal = refused_jumps(result, about, errors);
    if (result.refusal.empty()) result.refusal = refused_correlation(result);
    if (result.refusal.empty() && eigen[n - 1] / eigen[0] > largest_condition)
        result.refusal = "The data cannot tell the inputs apart: together they can change without changing what was measured. Fit fewer.";
    if (result.refusal.empty()) result.refusal = refused_values(result);
}

double rms(const VectorXd& residuals) { return std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.size())); }

/// In the curve's unit, whatever the weights.
double residual_rms(const MeasuredData& data, const std::vector<double>& simulated, const VectorXd& weighed)
{
    if (!data.is_curve()) return rms(weighed);
    VectorXd off(weighed.size());
    for (Index i = 0; i < off.size(); ++i)
        off[i] = data.numbers[static_cast<std::size_t>(i)].value - simulated[static_cast<std::size_t>(i)];
    return rms(off);
}

void add_notes(Calibration& result, const VectorXd& residuals)
{
    double largest = 0;
    for (const MeasuredNumber& number : result.data.numbers) largest = std::max(largest, std::abs(number.value));
    if (result.data.is_curve() && result.residual_rms > 0.1 * largest)
        result.notes.emplace_back("The simulated curve does not follow the measured one: what is left is more than a tenth of its largest "
                                  "value. The fitted values may stand for something else that the model lacks.");
    if (alike_neighbours(result.data, residuals) > 2)
        result.notes.emplace_back("Neighbours on the curve deviate alike, so the intervals are wider: the shape of the simulated curve is "
                                  "not that of the measured one.");
    result.notes.emplace_back("The fitted values take up the numerical error of this fidelity; predict with the same fidelity.");
}

} // namespace

std::string refusal_of(const MeasuredData& data, const std::vector<FreeInput>& inputs)
{
    const std::size_t numbers = data.numbers.size();
    if (numbers < inputs.size())
        return fmt::format("{} measured {} cannot tell {} inputs; measure more, or fit fewer.", numbers,
                           numbers == 1 ? "number" : "numbers", inputs.size());
    if (numbers == inputs.size() && !has_spreads(data))
        return fmt::format("{} measured {} and {} {} leave nothing to judge the error by; measure more, or give a spread.", numbers,
                           numbers == 1 ? "number" : "numbers", inputs.size(), inputs.size() == 1 ? "input" : "inputs");
    const auto [least, most] = std::minmax_element(data.numbers.begin(), data.numbers.end(),
                                                   [](const MeasuredNumber& a, const MeasuredNumber& b) { return a.value < b.value; });
    if (data.is_curve() && numbers > 1 && least->value == most->value)
        return fmt::format("The measured curve is constant at {:g} {}; it tells nothing of how the fabric takes up water.", most->value,
                           data.unit);
    return {};
}

Calibration calibrate(const MeasuredData& data, const std::vector<FreeInput>& inputs, const Model& model, const NumberErrors& errors)
{
    Calibration result;
    result.data = data;
    for (const FreeInput& input : inputs) result.inputs.push_back({input, input.given, 0});
    result.refusal = refusal_of(data, inputs);
    if (!result.refusal.empty()) return result;

    Fit fit(data, inputs, model);
    std::vector<double> given;
    for (const FreeInput& input : inputs) given.push_back(input.given);
    result.before = fit.simulated({given}).front();
    result.residual_rms_before = residual_rms(data, result.before, fit.weighed(result.before));
    const VectorXd places = search(fit, inputs);
    const std::vector<double> values = fit.point(places);
    for (std::size_t k = 0; k < values.size(); ++k) result.inputs[k].value = values[k];
    result.fitted = fit.simulated({values}).front();
    const VectorXd residuals = fit.weighed(result.fitted);
    result.residual_rms = residual_rms(data, result.fitted, residuals);
    judge(result, fit, look_about(fit, places), residuals, errors ? errors(result.fitted) : std::vector<NumberError>());
    add_notes(result, residuals);
    return result;
}

} // namespace hygroloom
