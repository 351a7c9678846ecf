// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/laboratory_table.h"

#include "core/analysis/outcomes.h"
#include "core/base/csv_table.h"
#include "core/base/error.h"
#include "core/base/words.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {
namespace {

/// Refuses a word that is not among the known ones.
void require_known(const CsvTable& table, std::size_t row, const char* what, const std::string& word, const std::vector<std::string>& known)
{
    if (std::find(known.begin(), known.end(), word) != known.end()) return;
    const std::string near = nearest_word(word, known);
    throw Error(fmt::format("{}: line {}: There is no {} \"{}\" here{}", table.file, table.lines[row], what, word,
                            near.empty() ? "." : fmt::format("; did you mean \"{}\"?", near)));
}

} // namespace

LaboratoryTable read_laboratory_table(const std::string& text, const std::string& file, const std::vector<std::string>& fabrics,
                                      const std::vector<std::pair<std::string, std::string>>& metrics_and_units)
{
    const CsvTable csv = read_csv(text, file, {"fabric", "metric", "value", "unit"}, {"spread"});
    std::vector<std::string> metrics;
    metrics.reserve(metrics_and_units.size());
    for (const auto& [metric, unit] : metrics_and_units) metrics.push_back(metric);
    LaboratoryTable table;
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
        const std::vector<std::string>& fields = csv.rows[row];
        require_known(csv, row, "fabric", fields[0], fabrics);
        require_known(csv, row, "metric", fields[1], metrics);
        const std::string& unit =
            metrics_and_units[static_cast<std::size_t>(std::find(metrics.begin(), metrics.end(), fields[1]) - metrics.begin())].second;
        if (fields[3] != unit)
            throw Error(
                fmt::format("{}: line {}: The unit of {} is \"{}\"; given is \"{}\".", file, csv.lines[row], fields[1], unit, fields[3]));
        LaboratoryValue value{fields[0], fields[1], number_in(csv, row, 2, "value"), {}};
        if (value.value < 0 && !may_be_negative(value.metric))
            throw Error(fmt::format("{}: line {}: {} must be 0 or more; given is {:g}.", file, csv.lines[row], value.metric, value.value));
        if (!fields[4].empty()) value.spread = number_in(csv, row, 4, "spread");
        if (value.spread && *value.spread < 0)
            throw Error(fmt::format("{}: line {}: spread must be 0 or more; given is {:g}.", file, csv.lines[row], *value.spread));
        for (const LaboratoryValue& other : table)
            if (other.fabric == value.fabric && other.metric == value.metric)
                throw Error(fmt::format("{}: line {}: {} of {} comes twice.", file, csv.lines[row], value.metric, value.fabric));
        table.push_back(std::move(value));
    }
    return table;
}

} // namespace hygroloom
