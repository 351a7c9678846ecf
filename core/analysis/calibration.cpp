// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/calibration.h"

#include "core/analysis/intervals.h"
#include "core/base/units.h"

#include <Eigen/Dense>
#include <fmt/format.h>
#include <unsupported/Eigen/NonLinearOptimization>

#include <algorithm>
#include <cmath>
#include <filesystem>

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
void judge(Calibration& result, const MatrixXd& jacobian, const VectorXd& residuals)
{
    const Index n = jacobian.cols();
    const VectorXd scale = jacobian.colwise().norm();
    for (Index k = 0; k < n; ++k)
        if (!(scale[k] > 1e-9 * std::max(1.0, scale.maxCoeff()))) {
            result.refusal = fmt::format("The data do not depend on the {}; nothing can be told of it.",
                                         result.inputs[static_cast<std::size_t>(k)].title);
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
    for (Index k = 0; k < n; ++k) {
        FittedInput& input = result.inputs[static_cast<std::size_t>(k)];
        input.half = halves[k] * (input.high - input.low);
    }
    result.refusal = refused_correlation(result);
    if (result.refusal.empty() && eigen[n - 1] / eigen[0] > largest_condition)
        result.refusal = "The data cannot tell the inputs apart: together they can change without changing what was measured. Fit fewer.";
    if (result.refusal.empty()) result.refusal = refused_values(result);
}

/// Goes on by plain Gauss-Newton steps from where the search stopped: it stops at the first dent that noise makes in the sum of squares,
/// which the wide differences do not see. Gives the Jacobian at the place that it moves to.
MatrixXd settle(const Fit& fit, const Model& model, VectorXd& places)
{
    constexpr int most = 3;
    MatrixXd jacobian = fit.by_place(places);
    for (int i = 0; i < most; ++i) {
        const VectorXd residuals = fit.weighed(model({fit.point(places)}).front());
        const VectorXd wanted = places - jacobian.colPivHouseholderQr().solve(residuals);
        const VectorXd next = wanted.cwiseMax(places - VectorXd::Constant(places.size(), step_share))
                                  .cwiseMin(places + VectorXd::Constant(places.size(), step_share))
                                  .cwiseMax(0)
                                  .cwiseMin(1);
        const double moved = (next - places).cwiseAbs().maxCoeff();
        places = next;
        if (moved < edge_share) break;
        jacobian = fit.by_place(places);
    }
    return jacobian;
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

Calibration calibrate(const MeasuredData& data, const std::vector<FreeInput>& inputs, const Model& model)
{
    Calibration result;
    result.data = data;
    for (const FreeInput& input : inputs) result.inputs.push_back({input, input.given, 0});
    result.refusal = refusal_of(data, inputs);
    if (!result.refusal.empty()) return result;

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
    MatrixXd jacobian = settle(fit, model, places);
    const auto squares = [&](const VectorXd& at) { return fit.weighed(model({fit.point(at)}).front()).squaredNorm(); };
    if (squares(places) > 2 * squares(found)) { // noise makes dents, not such a difference: the steps went astray
        places = found;
        jacobian = fit.by_place(places);
    }
    const std::vector<double> values = fit.point(places);
    for (std::size_t k = 0; k < values.size(); ++k) result.inputs[k].value = values[k];
    result.fitted = model({values}).front();
    const VectorXd residuals = fit.weighed(result.fitted);
    result.residual_rms = residual_rms(data, result.fitted, residuals);
    judge(result, jacobian, residuals);
    add_notes(result, residuals);
    return result;
}

Design calibrated_design(const Design& design, const Calibration& calibration)
{
    std::vector<FreeInput> inputs(calibration.inputs.begin(), calibration.inputs.end());
    std::vector<double> values;
    for (const FittedInput& input : calibration.inputs) values.push_back(input.value);
    Design other = with_inputs(design, calibration.fabric, inputs, values);
    Fabric& fabric = other.fabrics[static_cast<std::size_t>(find_fabric(other, calibration.fabric) - other.fabrics.data())];
    const std::string file = std::filesystem::path(calibration.data.file).filename().string(); // folders are this machine's
    Calibrated from{file, calibration.experiment, name_of(calibration.fidelity), calibration.data.quantity, calibration.residual_rms, {}};
    for (const FittedInput& input : calibration.inputs) {
        if (input.half > 0) uncertainty_of(fabric, input.key) = input.half; // else nothing is known of it
        before_of(from, input.key) = input.given;
    }
    fabric.calibrated = from;
    return other;
}

} // namespace hygroloom
