// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/verify/swing_fit.h"

#include "core/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace hygroloom {
namespace {

/// Least squares of y over x with three functions.
struct Fit {
    std::array<double, 3> factors{};
    double rest = 0; ///< sum of the squares of the residuals
};

Fit fit_three(const std::vector<double>& x, const std::vector<double>& y, const std::function<std::array<double, 3>(double)>& functions)
{
    double m[3][4] = {};
    double squares = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const std::array<double, 3> f = functions(x[i]);
        for (std::size_t a = 0; a < 3; ++a) {
            for (std::size_t b = 0; b < 3; ++b) m[a][b] += f[a] * f[b];
            m[a][3] += f[a] * y[i];
        }
        squares += y[i] * y[i];
    }
    double u[3][4];
    std::copy(&m[0][0], &m[0][0] + 12, &u[0][0]);
    for (int a = 0; a < 3; ++a)
        for (int b = a + 1; b < 3; ++b) {
            const double q = u[b][a] / u[a][a];
            for (int c = a; c < 4; ++c) u[b][c] -= q * u[a][c];
        }
    Fit fit;
    for (int a = 2; a >= 0; --a) {
        double sum = u[a][3];
        for (int b = a + 1; b < 3; ++b) sum -= u[a][b] * fit.factors[b];
        fit.factors[a] = sum / u[a][a];
    }
    fit.rest = squares;
    for (std::size_t a = 0; a < 3; ++a) fit.rest -= fit.factors[a] * m[a][3];
    return fit;
}

} // namespace

Swing fit_swing(const std::vector<double>& times, const std::vector<double>& values, double expected)
{
    Swing best;
    double least = std::numeric_limits<double>::infinity();
    for (double f = 0.5 * expected; f < 2.0 * expected; f *= 1.004)
        for (double damping = 0.2 / expected; damping < 40 / expected; damping *= 1.1) {
            const Fit fit = fit_three(times, values, [&](double t) {
                const double e = std::exp(-t / damping);
                return std::array<double, 3>{e * std::cos(2 * pi * f * t), e * std::sin(2 * pi * f * t), 1.0};
            });
            if (fit.rest < least) {
                least = fit.rest;
                best = {f, damping};
            }
        }
    return best;
}

} // namespace hygroloom
