// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// --fidelity auto: by what error or time is asked for.
#include "core/base/error.h"
#include "core/plan/expectation.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace hygroloom {
namespace {

[[noreturn]] void refuse(const char* option, const char* allowed, const std::string& text)
{
    throw Error(fmt::format("{}: It must be {}; \"{}\" was given.", option, allowed, text));
}

/// A number and the word after it.
std::pair<double, std::string> number_and_unit(const std::string& text)
{
    double value = -1;
    const auto [last, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || !std::isfinite(value)) return {-1, ""};
    return {value, std::string(last, text.data() + text.size())};
}

} // namespace

double parse_error_target(const std::string& text)
{
    const auto [value, unit] = number_and_unit(text);
    const double error = unit == "%" ? value / 100 : value;
    if ((!unit.empty() && unit != "%") || !(error > 0 && error <= 1)) refuse("--error", "a share over 0 and up to 100 %, such as 5%", text);
    return error;
}

double parse_time_target(const std::string& text)
{
    const auto [value, unit] = number_and_unit(text);
    const double factor = unit.empty() || unit == "s" ? 1 : unit == "min" ? 60 : unit == "h" ? 3600 : -1;
    if (!(value * factor > 0)) refuse("--time", "a time over 0 in s, min or h, such as 10s", text);
    return value * factor;
}

FidelityChoice choose_fidelity(const std::vector<ModelPlan>& plans, const FidelityTarget& target)
{
    if (target.error) {
        const auto keeps = [&](const ModelPlan& p) { // the reference's own error is not known
            return p.fidelity != Fidelity::reference && p.expected_error && *p.expected_error <= *target.error;
        };
        const auto found = std::find_if(plans.begin(), plans.end(), keeps);
        if (found != plans.end())
            return {found->fidelity, fmt::format("The cheapest that is expected to keep the numerical error below {:g} %: {}. {}",
                                                 100 * *target.error, error_text(*found), found->expectation_source)};
        return {plans.back().fidelity,
                fmt::format("No fidelity is known from measurements to keep the numerical error below {:g} % in a scene of this "
                            "kind, so the finest is taken.",
                            100 * *target.error)};
    }
    const double most = target.seconds.value_or(0);
    const auto found = std::find_if(plans.rbegin(), plans.rend(), [&](const ModelPlan& p) { return p.expected_seconds <= most; });
    if (found != plans.rend())
        return {found->fidelity, fmt::format("The finest that is expected to take at most {:g} s: {:.2g} s. {}", most,
                                             found->expected_seconds, found->expectation_source)};
    return {plans.front().fidelity,
            fmt::format("No fidelity is expected to take at most {:g} s, so the coarsest is taken; it is expected to "
                        "take {:.2g} s. {}",
                        most, plans.front().expected_seconds, plans.front().expectation_source)};
}

} // namespace hygroloom
