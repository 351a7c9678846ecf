// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The search of a calibration, in places: 0 to 1 from end to end of each input's range.
#pragma once

#include "core/analysis/calibration.h"

#include <Eigen/Dense>

#include <map>

namespace hygroloom {

/// Difference step as a share of the range. Simulated numbers change in small steps: a front reaches one crossing more or not, a drop's
/// particles settle another way. Differences over a step of the size of that noise would be noise; over 10 % either way it is small.
constexpr double step_share = 0.1;
constexpr double edge_share = 0.01; ///< of the range: that close to an end is at the end

/// The residuals that are made small. Each point is run once.
class Fit {
public:
    using Scalar = double;
    using InputType = Eigen::VectorXd;
    using ValueType = Eigen::VectorXd;
    using JacobianType = Eigen::MatrixXd;
    enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

    Fit(const MeasuredData& data, const std::vector<FreeInput>& inputs, const Model& model) : data_(data), inputs_(inputs), model_(model) {}

    int inputs() const { return static_cast<int>(inputs_.size()); }
    int values() const { return static_cast<int>(data_.numbers.size()); }

    /// The search's own variable u has place = (1 + sin u) / 2, which never leaves the range.
    static Eigen::VectorXd places(const Eigen::VectorXd& u) { return 0.5 * (1 + u.array().sin()); }
    int operator()(const Eigen::VectorXd& u, Eigen::VectorXd& residuals) const;
    int df(const Eigen::VectorXd& u, Eigen::MatrixXd& jacobian) const;

    std::vector<double> point(const Eigen::VectorXd& places) const;
    std::vector<std::vector<double>> simulated(const std::vector<std::vector<double>>& points) const;
    /// Measured less simulated, in spreads if given.
    Eigen::VectorXd weighed(const std::vector<double>& simulated) const;
    Eigen::VectorXd residuals(const Eigen::VectorXd& places) const { return weighed(simulated({point(places)}).front()); }
    /// Derivatives of the residuals by the places, from central differences whose runs go side by side.
    Eigen::MatrixXd by_place(const Eigen::VectorXd& places) const;
    /// Values of the inputs, and what they gave.
    const std::map<std::vector<double>, std::vector<double>>& tried() const { return tried_; }

private:
    const MeasuredData& data_;
    const std::vector<FreeInput>& inputs_;
    const Model& model_;
    mutable std::map<std::vector<double>, std::vector<double>> tried_;
};

/// The places of least squares, from the given values on.
Eigen::VectorXd search(Fit& fit, const std::vector<FreeInput>& inputs);

/// Runs about the fit, for each input five evenly over 10 % of the range either way.
struct Surroundings {
    static constexpr int runs = 5, middle = 2;
    static constexpr double apart = step_share / middle; ///< of places
    struct Line {
        double low = 0, high = 0;                   ///< values of the input
        std::vector<std::vector<double>> simulated; ///< of each run the numbers
        Eigen::MatrixXd residuals;                  ///< of each number in each run, weighed
    };
    std::vector<Line> lines;  ///< of each input
    Eigen::MatrixXd jacobian; ///< by the lines of least squares through them

    static double offset(int run) { return (run - middle) * apart; }
    static double squares() { return 2 * (1 + 4) * apart * apart; } ///< of the offsets, summed
};
Surroundings look_about(const Fit& fit, const Eigen::VectorXd& places);

} // namespace hygroloom
