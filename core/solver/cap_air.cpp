// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/solver/cap_air.h"

#include "core/physics/caps.h"

#include <boost/math/quadrature/exp_sinh.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hygroloom {
namespace {

constexpr int places = 358; // half degrees from 0 to 179

double factor_by_integral(double angle)
{
    boost::math::quadrature::exp_sinh<double> quadrature;
    const auto integrand = [angle](double place) { return evaporation_integrand(angle, place); };
    return cap_steepness(angle) + 4.0 * quadrature.integrate(integrand, 1e-10);
}

/// The factor grows without end towards 180 degrees; with the cosine of half the angle it does not.
std::array<double, places + 1> tamed_factors()
{
    std::array<double, places + 1> table{};
    for (int k = 0; k <= places; ++k) {
        const double angle = radian_from_degree(0.5 * k);
        table[static_cast<std::size_t>(k)] = factor_by_integral(angle) * std::cos(0.5 * angle);
    }
    return table;
}

} // namespace

double evaporation_factor(double contact_angle)
{
    static const std::array<double, places + 1> table = tamed_factors();
    const double place = std::clamp(contact_angle * 360.0 / pi, 0.0, static_cast<double>(places));
    const auto below = static_cast<std::size_t>(std::min(place, places - 1.0));
    const double part = place - static_cast<double>(below), angle = radian_from_degree(0.5 * place);
    return ((1.0 - part) * table[below] + part * table[below + 1]) / std::cos(0.5 * angle);
}

} // namespace hygroloom
