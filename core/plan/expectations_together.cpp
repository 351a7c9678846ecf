// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is expected of one run in words, and of several together.
#include "core/base/text.h"
#include "core/plan/expectation.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {

std::string error_text(const ModelPlan& plan)
{
    if (!plan.expected_error) return "numerical error not measured";
    if (plan.fidelity == Fidelity::reference) return "numerical error not known (this is the reference)";
    return fmt::format("numerical error {} %", rounded_text(100 * *plan.expected_error, 2));
}

ModelPlan expected_of_all(const std::vector<ModelPlan>& plans)
{
    ModelPlan all = plans.front();
    if (plans.size() == 1) return all;
    for (std::size_t i = 1; i < plans.size(); ++i) {
        all.expected_seconds += plans[i].expected_seconds;
        all.expected_bytes = std::max(all.expected_bytes, plans[i].expected_bytes);
        if (!plans[i].expected_error || !all.expected_error)
            all.expected_error.reset();
        else
            all.expected_error = std::max(*all.expected_error, *plans[i].expected_error);
    }
    all.expectation_source =
        fmt::format("That is the largest numerical error of {} runs, and the time of all, one after the other.", plans.size());
    return all;
}

} // namespace hygroloom
