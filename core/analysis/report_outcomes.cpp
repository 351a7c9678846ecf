// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/report_outcomes.h"

#include "core/analysis/comparison.h"

#include <fmt/format.h>

namespace hygroloom {

OutcomeRows outcome_rows(const std::vector<Outcome>& outcomes, const std::map<std::string, Interval>& intervals, const ReaderUnits& units)
{
    OutcomeRows made;
    for (const Outcome& outcome : outcomes) {
        if (!is_shown(outcome)) continue;
        const ShownValue value = shown(outcome, outcome.value.value_or(0));
        const auto found = intervals.find(outcome.key);
        const ReaderUnit own = reader_unit(units, value.unit);
        const std::string number =
            found == intervals.end() ? fmt::format("{:.4g}", own.of(value.value)) : with_interval(outcome, found->second, units);
        const std::string text = !outcome.text.empty() ? outcome.text : outcome.value ? number : "–";
        const std::string grade = outcome.grade ? fmt::format("grade {} of 5", *outcome.grade) : "";
        made.rows.push_back(row(full_title(outcome), text, outcome.value ? own.unit : "", grade));
        for (const std::string& note : {outcome.missing, outcome.remark})
            if (!note.empty()) made.notes.push_back(full_title(outcome) + ": " + note + ".");
    }
    return made;
}

} // namespace hygroloom
