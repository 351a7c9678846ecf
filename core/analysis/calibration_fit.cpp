// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/calibration_fit.h"

#include "core/base/units.h"

#include <unsupported/Eigen/NonLinearOptimization>

#include <algorithm>
#include <cmath>

namespace hygroloom {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Goes on by plain Gauss-Newton steps from where the search stopped: it stops at the first dent that noise makes in the sum of squares,
/// which the wide differences do not see.
void settle(const Fit& fit, VectorXd& places)
{
    constexpr int most = 3;
    for (int i = 0; i < most; ++i) {
        const MatrixXd jacobian = fit.by_place(places);
        const VectorXd residuals = fit.residuals(places);
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

} // namespace

int Fit::operator()(const VectorXd& u, VectorXd& residuals) const
{
    residuals = this->residuals(places(u));
    return 0;
}

int Fit::df(const VectorXd& u, MatrixXd& jacobian) const
{
    jacobian = by_place(places(u)) * (0.5 * u.array().cos()).matrix().asDiagonal();
    return 0;
}

std::vector<std::vector<double>> Fit::simulated(const std::vector<std::vector<double>>& points) const
{
    std::vector<std::vector<double>> fresh;
    for (const std::vector<double>& point : points)
        if (!tried_.contains(point)) fresh.push_back(point);
    const std::vector<std::vector<double>> found = fresh.empty() ? fresh : model_(fresh);
    for (std::size_t i = 0; i < fresh.size(); ++i) tried_[fresh[i]] = found[i];
    std::vector<std::vector<double>> all;
    all.reserve(points.size());
    for (const std::vector<double>& point : points) all.push_back(tried_.at(point));
    return all;
}

VectorXd Fit::weighed(const std::vector<double>& simulated) const
{
    VectorXd residuals(values());
    for (Index i = 0; i < residuals.size(); ++i) {
        const MeasuredNumber& number = data_.numbers[static_cast<std::size_t>(i)];
        residuals[i] = (number.value - simulated[static_cast<std::size_t>(i)]) / number.spread.value_or(1);
    }
    return residuals;
}

MatrixXd Fit::by_place(const VectorXd& places) const
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
    const std::vector<std::vector<double>> found = simulated(points);
    MatrixXd jacobian(values(), places.size());
    for (Index k = 0; k < places.size(); ++k) {
        const auto at = static_cast<std::size_t>(2 * k);
        jacobian.col(k) = (weighed(found[at + 1]) - weighed(found[at])) / widths[k];
    }
    return jacobian;
}

std::vector<double> Fit::point(const VectorXd& places) const
{
    std::vector<double> values;
    for (std::size_t k = 0; k < inputs_.size(); ++k)
        values.push_back(inputs_[k].low + places[static_cast<Index>(k)] * (inputs_[k].high - inputs_[k].low));
    return values;
}

VectorXd search(Fit& fit, const std::vector<FreeInput>& inputs)
{
    VectorXd u(static_cast<Index>(inputs.size()));
    for (Index k = 0; k < u.size(); ++k) {
        const FreeInput& input = inputs[static_cast<std::size_t>(k)];
        // At the very end of a range sin is flat: the fit would not leave it.
        const double place = std::clamp((input.given - input.low) / (input.high - input.low), 0.02, 0.98);
        u[k] = std::asin(2 * place - 1) + 2 * pi; // a turn on, as the search takes its first step as a share of the distance from 0
    }
    Eigen::LevenbergMarquardt<Fit> levenberg_marquardt(fit);
    levenberg_marquardt.parameters.factor = 0.1;
    levenberg_marquardt.parameters.ftol = 1e-4;
    levenberg_marquardt.parameters.xtol = 1e-4;
    levenberg_marquardt.parameters.maxfev = 20;
    levenberg_marquardt.minimize(u);
    const VectorXd found = Fit::places(u);
    VectorXd places = found;
    settle(fit, places);
    // Noise makes dents, not such a difference: the steps went astray.
    return fit.residuals(places).squaredNorm() > 2 * fit.residuals(found).squaredNorm() ? found : places;
}

Surroundings look_about(const Fit& fit, const VectorXd& places)
{
    constexpr int runs = Surroundings::runs;
    std::vector<std::vector<double>> points;
    for (Index k = 0; k < places.size(); ++k)
        for (int i = 0; i < runs; ++i) {
            VectorXd at = places;
            at[k] = std::clamp(places[k], step_share, 1 - step_share) + Surroundings::offset(i);
            points.push_back(fit.point(at));
        }
    const std::vector<std::vector<double>> simulated = fit.simulated(points);
    Surroundings found;
    found.jacobian = MatrixXd::Zero(fit.values(), fit.inputs());
    for (Index k = 0; k < places.size(); ++k) {
        const auto first = static_cast<std::size_t>(k * runs), input = static_cast<std::size_t>(k);
        Surroundings::Line line{points[first][input], points[first + runs - 1][input], {}, MatrixXd(fit.values(), runs)};
        for (int i = 0; i < runs; ++i) {
            line.simulated.push_back(simulated[first + static_cast<std::size_t>(i)]);
            line.residuals.col(i) = fit.weighed(line.simulated.back());
            found.jacobian.col(k) += Surroundings::offset(i) / Surroundings::squares() * line.residuals.col(i);
        }
        found.lines.push_back(std::move(line));
    }
    return found;
}

} // namespace hygroloom
