// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/calibration.h"

#include "core/analysis/intervals.h"
#include "core/base/units.h"

#include <Eigen/Dense>
#include <fmt/format.h>
#include <unsupported/Eigen/NonLinearOptimization>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace hygroloom {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Difference step as a share of the range. Simulated numbers change in small steps: a front reaches one crossing more or not, a drop's
/// particles settle another way. Differences over a step of the size of that noise would be noise; over 10 % either way it is small.
constexpr double step_share = 0.1;
constexpr double edge_share = 0.01; ///< of the range: that close to an end is at the end
constexpr double told_apart = 0.99; ///< largest correlation of two inputs
/// Of the scaled normal matrix; two inputs correlated by 0.99 have 199. Larger: three that only together cannot be told apart.
constexpr double largest_condition = 1e4;

/// Places in the ranges, 0 to 1; the fit's own variable u has place = (1 + sin u) / 2, which never leaves the range.
class Fit {
public:
    using Scalar = double;
    using InputType = VectorXd;
    using ValueType = VectorXd;
    using JacobianType = MatrixXd;
    enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

    Fit(const MeasuredData& data, const std::vector<FreeInput>& inputs, const Model& model) : data_(data), inputs_(inputs), model_(model) {}

    int inputs() const { return static_cast<int>(inputs_.size()); }
    int values() const { return static_cast<int>(data_.numbers.size()); }

    static VectorXd places(const VectorXd& u) { return 0.5 * (1 + u.array().sin()); }

    int operator()(const VectorXd& u, VectorXd& residuals) const
    {
        residuals = weighed(model_({point(places(u))}).front());
        return 0;
    }
    int df(const VectorXd& u, MatrixXd& jacobian) const
    {
        jacobian = by_place(places(u)) * (0.5 * u.array().cos()).matrix().asDiagonal();
        return 0;
    }

    /// Measured less simulated, in spreads if given.
    VectorXd weighed(const std::vector<double>& simulated) const
    {
        VectorXd residuals(values());
        for (Index i = 0; i < residuals.size(); ++i) {
            const MeasuredNumber& number = data_.numbers[static_cast<std::size_t>(i)];
            residuals[i] = (number.value - simulated[static_cast<std::size_t>(i)]) / number.spread.value_or(1);
        }
        return residuals;
    }
    /// Derivatives of the residuals by the places, from central differences whose runs go side by side.
    MatrixXd by_place(const VectorXd& places) const
    {
        std::vector<std::vector<double>> points;
        VectorXd widths(places.size());
        for (Index k = 0; k < places.size(); ++k) {
            VectorXd low = places, high = places;
            low[k] = std::max(0.0, places[k] - step_share);
            high[k] = std::min(1.0, places[k] + step_share);
            widths[k] = high[k] - low[k];
            points.push_back(point(low));
            points.push_back(point(high));
        }
        const std::vector<std::vector<double>> simulated = model_(points);
        MatrixXd jacobian(values(), places.size());
        for (Index k = 0; k < places.size(); ++k) {
            const auto at = static_cast<std::size_t>(2 * k);
            jacobian.col(k) = (weighed(simulated[at + 1]) - weighed(simulated[at])) / widths[k];
        }
        return jacobian;
    }
    std::vector<double> point(const VectorXd& places) const
    {
        std::vector<double> values;
        for (std::size_t k = 0; k < inputs_.size(); ++k)
            values.push_back(inputs_[k].low + places[static_cast<Index>(k)] * (inputs_[k].high - inputs_[k].low));
        return values;
    }

private:
    const MeasuredData& data_;
    const std::vector<FreeInput>& inputs_;
    const Model& model_;
};

/// As the model, but runs each point once.
Model remembering(const Model& model)
{
    return [&model, known = std::make_shared<std::map<std::vector<double>, std::vector<double>>>()](const auto& points) {
        std::vector<std::vector<double>> fresh;
        for (const std::vector<double>& point : points)
            if (!known->contains(point)) fresh.push_back(point);
        const std::vector<std::vector<double>> found = fresh.empty() ? fresh : model(fresh);
        for (std::size_t i = 0; i < fresh.size(); ++i) (*known)[fresh[i]] = found[i];
        std::vector<std::vector<double>> all;
        for (const std::vector<double>& point : points) all.push_back(known->at(point));
        return all;
    };
}

/// Runs about the fit, five evenly over 10 % of the range either way.
struct Surroundings {
    MatrixXd jacobian;                                       ///< by the lines of least squares through them
    std::vector<std::vector<std::vector<double>>> simulated; ///< of each input, at each of its places: the numbers
    std::vector<std::array<double, 2>> ends;                 ///< values of each input
};

Surroundings look_about(const Fit& fit, const Model& model, const VectorXd& places)
{
    constexpr int about = 5, middle = 2;
    constexpr double apart = step_share / middle;
    Surroundings found;
    found.jacobian = MatrixXd::Zero(fit.values(), fit.inputs());
    std::vector<std::vector<double>> points;
    for (Index k = 0; k < places.size(); ++k)
        for (int i = 0; i < about; ++i) {
            VectorXd at = places;
            at[k] = i == middle && places[k] == std::clamp(places[k], step_share, 1 - step_share)
                        ? places[k]
                        : std::clamp(places[k], step_share, 1 - step_share) + (i - middle) * apart;
            points.push_back(fit.point(at));
        }
    const std::vector<std::vector<double>> simulated = model(points);
    for (Index k = 0; k < places.size(); ++k) {
        const auto first = static_cast<std::ptrdiff_t>(k * about);
        const std::vector<std::vector<double>> own(simulated.begin() + first, simulated.begin() + first + about);
        double squares = 0;
        for (int i = 0; i < about; ++i) {
            const double off = (i - middle) * apart;
            squares += off * off;
            found.jacobian.col(k) += off * fit.weighed(own[static_cast<std::size_t>(i)]);
        }
        found.jacobian.col(k) /= squares;
        const auto input = static_cast<std::size_t>(k);
        found.ends.push_back({points[input * about][input], points[input * about + about - 1][input]});
        found.simulated.push_back(own);
    }
    return found;
}

/// How many values a number takes as an input moves: as many as there are runs unless it jumps.
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

/// A number that takes fewer values than that in five runs stands still and jumps: its slope says where the jump lies.
constexpr int fewest_values = 4;

/// Where more than half of what tells an input comes from numbers that jump.
std::string refused_jumps(const Calibration& result, const Surroundings& about)
{
    for (std::size_t k = 0; k < result.inputs.size(); ++k) {
        const VectorXd told = about.jacobian.col(static_cast<Index>(k)).cwiseAbs2();
        double by_jumps = 0, most = 0;
        std::size_t worst = 0;
        for (std::size_t i = 0; i < result.data.numbers.size(); ++i) {
            const double by_it = told[static_cast<Index>(i)];
            if (by_it == 0 || values_of(about.simulated[k], i) >= fewest_values) continue;
            by_jumps += by_it;
            if (by_it > most) worst = i;
            most = std::max(most, by_it);
        }
        if (!(by_jumps > 0.5 * told.sum())) continue;
        const MeasuredNumber& number = result.data.numbers[worst];
        const auto [low, high] = std::minmax(about.simulated[k].front()[worst], about.simulated[k].back()[worst]);
        const FittedInput& input = result.inputs[k];
        return fmt::format(
            "{}{} jumps: {} runs with the {} from {:.3g} to {:.3g}{} give {} values of it, {:.4g} to {:.4g} {}. Between jumps "
            "it tells nothing. Fit a curve over time, or a number that changes smoothly.",
            number.key, result.data.is_curve() ? fmt::format(" at {:g} s", number.time) : "", about.simulated[k].size(), input.title,
            about.ends[k][0], about.ends[k][1], input.unit, values_of(about.simulated[k], worst), low, high, number.unit);
    }
    return {};
}

/// Half widths of the places' intervals by the numerical errors of the numbers, carried through the fit. Those of a curve are one error.
VectorXd numerical_halves(Calibration& result, const MatrixXd& jacobian, const MatrixXd& inverse, const NumericalErrors& numerical)
{
    VectorXd halves = VectorXd::Zero(jacobian.cols());
    if (!numerical) return halves;
    const std::vector<std::optional<double>> errors = numerical(result.fitted);
    VectorXd weighed = VectorXd::Zero(jacobian.rows());
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const MeasuredNumber& number = result.data.numbers[i];
        weighed[static_cast<Index>(i)] = errors[i].value_or(0) / number.spread.value_or(1);
        if (!errors[i] && (i == 0 || !result.data.is_curve()))
            result.notes.push_back(fmt::format("The numerical error of {} is not known; the intervals lack it.", number.key));
    }
    const MatrixXd moved = inverse * jacobian.transpose() * weighed.asDiagonal(); // of each input by each number's error
    return result.data.is_curve() ? VectorXd(moved.rowwise().sum().cwiseAbs()) : VectorXd(moved.rowwise().norm());
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
void judge(Calibration& result, const Surroundings& about, const VectorXd& residuals, const NumericalErrors& numerical)
{
    const MatrixXd& jacobian = about.jacobian;
    const Index n = jacobian.cols();
    const VectorXd scale = jacobian.colwise().norm();
    for (Index k = 0; k < n; ++k)
        if (!(scale[k] > 1e-9 * std::max(1.0, scale.maxCoeff()))) {
            const FittedInput& input = result.inputs[static_cast<std::size_t>(k)];
            const std::array<double, 2>& ends = about.ends[static_cast<std::size_t>(k)];
            result.refusal = fmt::format("The data do not depend on the {} from {:.3g} to {:.3g}{}; nothing can be told of it.",
                                         input.title, ends[0], ends[1], input.unit);
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
    const VectorXd halves = half_widths(result.data, jacobian, residuals, inverse);
    const VectorXd by_runs = numerical_halves(result, jacobian, inverse, numerical);
    for (Index k = 0; k < n; ++k) {
        FittedInput& input = result.inputs[static_cast<std::size_t>(k)];
        input.numerical = by_runs[k] * (input.high - input.low);
        input.half = std::hypot(halves[k] * (input.high - input.low), input.numerical);
    }
    result.refusal = refused_jumps(result, about);
    if (result.refusal.empty()) result.refusal = refused_correlation(result);
    if (result.refusal.empty() && eigen[n - 1] / eigen[0] > largest_condition)
        result.refusal = "The data cannot tell the inputs apart: together they can change without changing what was measured. Fit fewer.";
    if (result.refusal.empty()) result.refusal = refused_values(result);
}

/// Goes on by plain Gauss-Newton steps from where the search stopped: it stops at the first dent that noise makes in the sum of squares,
/// which the wide differences do not see.
void settle(const Fit& fit, const Model& model, VectorXd& places)
{
    constexpr int most = 3;
    for (int i = 0; i < most; ++i) {
        const MatrixXd jacobian = fit.by_place(places);
        const VectorXd residuals = fit.weighed(model({fit.point(places)}).front());
        const VectorXd wanted = places - jacobian.colPivHouseholderQr().solve(residuals);
        const VectorXd next = wanted.cwiseMax(places - VectorXd::Constant(places.size(), step_share))
                                  .cwiseMin(places + VectorXd::Constant(places.size(), step_share))
                                  .cwiseMax(0)
                                  .cwiseMin(1);
        const double moved = (next - places).cwiseAbs().maxCoeff();
        places = next;
        if (moved < edge_share) break;
    }
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

Calibration calibrate(const MeasuredData& data, const std::vector<FreeInput>& inputs, const Model& runs, const NumericalErrors& numerical)
{
    Calibration result;
    result.data = data;
    for (const FreeInput& input : inputs) result.inputs.push_back({input, input.given, 0});
    result.refusal = refusal_of(data, inputs);
    if (!result.refusal.empty()) return result;

    const Model model = remembering(runs);
    Fit fit(data, inputs, model);
    VectorXd u(static_cast<Index>(inputs.size()));
    for (Index k = 0; k < u.size(); ++k) {
        const FreeInput& input = inputs[static_cast<std::size_t>(k)];
        // At the very end of a range sin is flat: the fit would not leave it.
        const double place = std::clamp((input.given - input.low) / (input.high - input.low), 0.02, 0.98);
        u[k] = std::asin(2 * place - 1) + 2 * pi; // a turn on, as the search takes its first step as a share of the distance from 0
    }
    std::vector<double> given;
    for (const FreeInput& input : inputs) given.push_back(input.given);
    result.before = model({given}).front();
    result.residual_rms_before = residual_rms(data, result.before, fit.weighed(result.before));

    Eigen::LevenbergMarquardt<Fit> search(fit);
    search.parameters.factor = 0.1;
    search.parameters.ftol = 1e-4;
    search.parameters.xtol = 1e-4;
    search.parameters.maxfev = 20;
    search.minimize(u);

    VectorXd places = Fit::places(u);
    const VectorXd found = places;
    settle(fit, model, places);
    const auto squares = [&](const VectorXd& at) { return fit.weighed(model({fit.point(at)}).front()).squaredNorm(); };
    if (squares(places) > 2 * squares(found)) places = found; // noise makes dents, not such a difference: the steps went astray
    const std::vector<double> values = fit.point(places);
    for (std::size_t k = 0; k < values.size(); ++k) result.inputs[k].value = values[k];
    result.fitted = model({values}).front();
    const VectorXd residuals = fit.weighed(result.fitted);
    result.residual_rms = residual_rms(data, result.fitted, residuals);
    judge(result, look_about(fit, model, places), residuals, numerical);
    add_notes(result, residuals);
    return result;
}

} // namespace hygroloom
