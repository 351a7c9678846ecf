// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/study/quantiles.h"

#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace hygroloom {
namespace {

/// Doubles all through, whatever a machine's long doubles are; what is no distribution any more, for its numbers are too large, gives
/// infinities or none, which no project takes.
namespace policies = boost::math::policies;
using Policy = policies::policy<policies::promote_double<false>, policies::domain_error<policies::ignore_error>,
                                policies::pole_error<policies::ignore_error>, policies::overflow_error<policies::ignore_error>,
                                policies::evaluation_error<policies::ignore_error>>;

/// Of what lies between the bounds, which is not without probability for doubles.
template <typename Of> double within(const Of& of, const FactorDistribution& distribution, double probability)
{
    const double lowest = distribution.low ? cdf(of, *distribution.low) : 0.0;
    const double highest = distribution.high ? cdf(of, *distribution.high) : 1.0;
    const double low = distribution.low.value_or(-INFINITY), high = distribution.high.value_or(INFINITY);
    const double share = lowest + (highest - lowest) * probability;
    constexpr double least = 1e-15;
    return std::clamp(quantile(of, std::clamp(share, least, 1 - least)), low, high);
}

} // namespace

double quantile(const FactorDistribution& d, double probability)
{
    using Type = FactorDistribution::Type;
    switch (d.type) {
    case Type::uniform: return *d.low + (*d.high - *d.low) * probability;
    case Type::log_uniform: return *d.low * std::pow(*d.high / *d.low, probability);
    case Type::normal: return within(boost::math::normal_distribution<double, Policy>(d.mean, d.sd), d, probability);
    case Type::lognormal: {
        const double variance = std::log1p(d.sd * d.sd / (d.mean * d.mean)); // of the logarithm
        const double location = std::log(d.mean) - variance / 2;
        FactorDistribution positive = d;
        if (d.low) positive.low = std::max(*d.low, 0.0);
        return within(boost::math::lognormal_distribution<double, Policy>(location, std::sqrt(variance)), positive, probability);
    }
    case Type::triangular: return quantile(boost::math::triangular_distribution<double, Policy>(*d.low, d.mode, *d.high), probability);
    }
    return 0;
}

double rounded_for_all(double number)
{
    const std::string text = fmt::format("{:.10g}", number);
    double rounded = number;
    std::from_chars(text.data(), text.data() + text.size(), rounded);
    return rounded + 0.0; // no negative zero
}

} // namespace hygroloom
