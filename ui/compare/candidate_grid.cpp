// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/candidate_grid.h"

#include "core/analysis/card.h"
#include "core/analysis/comparative.h"
#include "core/base/text.h"
#include "ui/basics/core_words.h"
#include "ui/basics/quantity.h"
#include "ui/basics/words.h"
#include "ui/results/report_file.h"
#include "ui/results/results_panel.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {

namespace {

ShownValue inUserUnit(const ShownValue& value)
{
    const ReaderUnit user = unitsOfReader()(value.unit);
    return {user.of(value.value), user.unit};
}

/// Of a difference of two values.
ShownValue differenceInUserUnit(const ShownValue& value)
{
    const ReaderUnit user = unitsOfReader()(value.unit);
    return {user.per_one * value.value, user.unit};
}

QString betterText(const OutcomeInfo& info)
{
    if (info.better == Better::neither) { return {}; }
    const std::string_view word = comparative(info, info.better == Better::more);
    if (word == "shorter") { return tr("Shorter is better."); }
    if (word == "longer") { return tr("Longer is better."); }
    if (word == "smaller") { return tr("Smaller is better."); }
    if (word == "larger") { return tr("Larger is better."); }
    return word == "lower" ? tr("Lower is better.") : tr("Higher is better.");
}

GridColumn columnOf(const OutcomeInfo& info)
{
    GridColumn column;
    column.info = info;
    const QString unit = userUnit(QString::fromStdString(shown(info, 0.0).unit)).unit;
    column.head = capital(info.part.empty() ? outcomeTitle(info) : outcomeTitle(info) + ", " + coreWord(info.part));
    if (!unit.isEmpty()) { column.head += " (" + unit + ")"; }
    column.tip = betterText(info);
    return column;
}

const Candidate* candidateNamed(const Comparison& comparison, const std::string& name)
{
    const auto& all = comparison.candidates;
    const auto found = std::find_if(all.begin(), all.end(), [&name](const Candidate& each) { return each.fabric == name; });
    return found == all.end() ? nullptr : &*found;
}

/// What there is to say under a number, and why.
void addVerdict(GridCell& cell, const Comparison& comparison, const Candidate& candidate, const GridEntry& entry, const OutcomeInfo& info)
{
    if (entry.runs < comparison.replicates) {
        cell.verdict = tr("%1 of %2 runs").arg(entry.runs).arg(comparison.replicates);
    } else if (candidate.fabric == comparison.baseline) {
        cell.verdict = comparison.candidates.size() > 1 ? tr("baseline") : QString();
    }
    if (const LoneNumber* lone = lone_number_of(comparison, candidate.fabric, info.key)) {
        cell.verdict = coreWord(lone->words);
        cell.tip += "\n" + QString::fromStdString(lone->sentence);
    }
    const Compared* found = verdict_of(comparison, candidate.fabric, info.key);
    if (!found) { return; }
    cell.verdict = verdictText(found->verdict);
    const QString base = QString::fromStdString(comparison.baseline);
    const ShownValue low = differenceInUserUnit(shown(info, found->low)), high = differenceInUserUnit(shown(info, found->high));
    const int decimals = decimals_for(std::max(std::abs(low.value), std::abs(high.value)), 2);
    cell.tip += "\n" + tr("Difference to %1: %2 to %3 %4, from %5.")
                           .arg(base, shownNumber(low.value, decimals), shownNumber(high.value, decimals), QString::fromStdString(low.unit),
                                found->pairs == 1 ? tr("one run of each") : tr("%1 pairs of runs").arg(found->pairs));
}

/// " · measured 7.2 ± 0.1 mm"; empty: it was not.
QString measuredText(const Comparison& comparison, const std::string& fabric, const OutcomeInfo& info)
{
    const LaboratoryValue* found = measured_of(comparison, fabric, info.key);
    if (!found) { return {}; }
    const ShownValue value = inUserUnit(shown(info, found->value));
    QString text = tr("measured %1").arg(shownNumber(value.value, decimals_for(std::abs(value.value), 3)));
    if (found->spread) {
        const double spread = std::abs(inUserUnit(shown(info, found->value + *found->spread)).value - value.value);
        text += QStringLiteral(" ± ") + shownNumber(spread, decimals_for(std::abs(value.value), 3));
    }
    return value.unit.empty() ? text : text + QChar(0x00a0) + QString::fromStdString(value.unit);
}

/// A number of the technical card, which needs no run.
GridCell cardCell(const LaboratoryNumber& number)
{
    const LaboratoryNumber seen = in_units(number, unitsOfReader());
    GridCell cell;
    cell.state = GridCell::State::number;
    cell.value = seen.estimate.value;
    cell.low = seen.estimate.low;
    cell.high = seen.estimate.high;
    cell.number = significant(cell.value);
    if (cell.low < cell.high) { cell.number = tr("%1 (%2 to %3)").arg(cell.number, significant(cell.low), significant(cell.high)); }
    if (!seen.unit.empty()) { cell.number += QChar(0x00a0) + QString::fromStdString(seen.unit); }
    for (const std::string& text : {seen.standard, seen.conditions}) {
        if (!text.empty()) { cell.tip += (cell.tip.isEmpty() ? QString() : QStringLiteral("; ")) + QString::fromStdString(text); }
    }
    return cell;
}

GridCell cellOf(const Comparison& comparison, const GridEntry& entry, const OutcomeInfo& info)
{
    if (const LaboratoryNumber* own = card_number_of(comparison, entry.name, info.key)) { return cardCell(*own); }
    GridCell cell;
    cell.measured = measuredText(comparison, entry.name, info);
    cell.path = entry.path;
    cell.missing = entry.missing;
    const Candidate* candidate = candidateNamed(comparison, entry.name);
    const auto found = candidate ? candidate->intervals.find(info.key) : std::map<std::string, Interval>::const_iterator{};
    if (!candidate || found == candidate->intervals.end()) {
        const bool none = !candidate || entry.runs == 0;
        cell.state = entry.reading                    ? GridCell::State::reading
                     : none && !entry.missing.empty() ? GridCell::State::missing
                                                      : GridCell::State::no_number;
        cell.tip = tr("This run does not give this number.");
        if (const LoneNumber* lone = candidate ? lone_number_of(comparison, entry.name, info.key) : nullptr) {
            cell.verdict = coreWord(lone->words);
            cell.tip = QString::fromStdString(lone->sentence);
        }
        return cell;
    }
    const Interval& interval = found->second;
    const ShownInterval seen = in_unit(shown(info, interval), unitsOfReader()(shown(info, 0.0).unit));
    cell.state = GridCell::State::number;
    cell.value = seen.value;
    cell.low = seen.low;
    cell.high = seen.high;
    if (cell.low > cell.high) { std::swap(cell.low, cell.high); }
    const auto text = [&seen](double number) { // both with equal decimals; never "-0.00"
        return QLocale().toString(std::abs(number) < 0.5 * std::pow(10.0, -seen.decimals) ? 0.0 : number, 'f', seen.decimals);
    };
    cell.number = seen.cut        ? tr("%1 (%2 to %3)").arg(text(seen.value), text(seen.low), text(seen.high))
                  : seen.half > 0 ? text(seen.value) + QStringLiteral(" ± ") + text(seen.half)
                                  : shownNumber(seen.value, seen.decimals);
    if (!seen.unit.empty()) { cell.number += QChar(0x00a0) + QString::fromStdString(seen.unit); }
    const bool several = interval.runs > 1;
    cell.tip = several
                   ? tr("After ±: where one more such cloth is expected, from %1 runs with numerical error, scatter and what is not known "
                        "of the cloth.")
                         .arg(interval.runs)
                   : tr("After ±: the numerical error, as measured on runs of this kind.");
    if (!interval.numerical_known) { cell.tip = tr("The numerical error of this number is not known."); }
    cell.tip.prepend(
        tr("%1 in full.").arg(valueText(shown(info, interval.centre).value, QString::fromStdString(shown(info, 0.0).unit), true)) + "\n");
    addVerdict(cell, comparison, *candidate, entry, info);
    return cell;
}

void findRanges(Grid& grid)
{
    for (std::size_t i = 0; i < grid.columns.size(); ++i) {
        GridColumn& column = grid.columns[i];
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const GridRow& row : grid.rows) {
            if (row.cells[i].state != GridCell::State::number) { continue; }
            low = std::min(low, row.cells[i].low);
            high = std::max(high, row.cells[i].high);
        }
        if (low < high) {
            column.low = low;
            column.high = high;
        }
    }
}

void addRank(GridRow& row, const Comparison& comparison)
{
    const Candidate* candidate = candidateNamed(comparison, row.name);
    if (!candidate || candidate->rank == 0 || comparison.candidates.size() < 2) { return; }
    row.place = candidate->rank;
    row.rank = QString::fromStdString(rank_text(*candidate));
}

} // namespace

QString verdictText(Verdict verdict)
{
    switch (verdict) {
    case Verdict::better: return tr("better");
    case Verdict::probably_better: return tr("probably better");
    case Verdict::no_difference: return tr("no difference shown");
    case Verdict::probably_worse: return tr("probably worse");
    case Verdict::worse: return tr("worse");
    }
    return {};
}

Grid gridOf(const Comparison& comparison, const std::vector<GridEntry>& entries)
{
    Grid grid;
    for (const OutcomeInfo& info : comparison.criteria) { grid.columns.push_back(columnOf(info)); }
    for (const GridEntry& entry : entries) {
        GridRow row;
        row.name = entry.name;
        row.path = entry.path;
        row.baseline = entry.name == comparison.baseline;
        for (const OutcomeInfo& info : comparison.criteria) { row.cells.push_back(cellOf(comparison, entry, info)); }
        addRank(row, comparison);
        grid.rows.push_back(std::move(row));
    }
    findRanges(grid);
    return grid;
}

Grid overviewOf(const std::vector<ExperimentPart>& parts)
{
    Grid grid;
    for (const ExperimentPart& part : parts) {
        const Comparison& comparison = part.comparison;
        GridColumn column = columnOf(comparison.ranked_by);
        column.head = QString::fromStdString(comparison.experiment) + "\n" + column.head;
        grid.columns.push_back(std::move(column));
        if (grid.rows.empty()) {
            for (const GridEntry& entry : part.entries) {
                GridRow row;
                row.name = entry.name;
                row.baseline = entry.name == comparison.baseline;
                grid.rows.push_back(std::move(row));
            }
        }
        for (std::size_t i = 0; i < grid.rows.size(); ++i) {
            grid.rows[i].cells.push_back(cellOf(comparison, part.entries[i], comparison.ranked_by));
        }
    }
    findRanges(grid);
    return grid;
}

void sortRows(Grid& grid, int column, bool ascending)
{
    const auto key = [&](const GridRow& row) -> std::optional<double> {
        if (column < 0) { return row.place > 0 ? std::optional<double>(row.place) : std::nullopt; }
        const GridCell& cell = row.cells[static_cast<std::size_t>(column)];
        return cell.state == GridCell::State::number ? std::optional(cell.value) : std::nullopt;
    };
    std::stable_sort(grid.rows.begin(), grid.rows.end(), [&](const GridRow& a, const GridRow& b) {
        const auto one = key(a), other = key(b);
        if (!one || !other) { return one.has_value() && !other; }
        return ascending ? *one < *other : *other < *one;
    });
}

void filterRows(Grid& grid, const QString& text)
{
    std::erase_if(grid.rows, [&text](const GridRow& row) { return !QString::fromStdString(row.name).contains(text, Qt::CaseInsensitive); });
}

} // namespace hygroloom
