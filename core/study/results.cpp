// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/study/results.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/project/atomic_file.h"
#include "core/study/csv_rows.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {
namespace {

using Role = StudyColumnRole;

constexpr std::size_t largest_table_bytes = std::size_t{4} << 30U;

struct FixedColumn {
    const char* name;
    Role role;
    bool is_number;
};
constexpr FixedColumn before[] = {{"point", Role::point, true},
                                  {"replicate", Role::replicate, true},
                                  {"fabric", Role::fabric, false},
                                  {"experiment", Role::experiment, false}};
constexpr FixedColumn after[] = {
    {"wall_s", Role::wall, true}, {"device", Role::device, false}, {"commit", Role::commit, false}, {"reason", Role::reason, false}};

[[noreturn]] void refuse(const std::string& file, std::size_t line, const std::string& sentence)
{
    throw FileError(fmt::format("{}: line {}: {}", file, line, sentence));
}

/// Columns without rows, from their names.
std::vector<StudyColumn> columns_of(const std::vector<std::string>& names, const std::string& file)
{
    std::vector<StudyColumn> columns;
    std::size_t at = 0;
    const auto take = [&](const FixedColumn& fixed) {
        if (at == names.size() || names[at] != fixed.name) return false;
        columns.push_back({names[at++], fixed.role, fixed.is_number, {}, {}, {}});
        return true;
    };
    const auto take_all_until = [&](const char* end, Role role) {
        for (; at < names.size() && names[at] != end; ++at) columns.push_back({names[at], role, true, {}, {}, {}});
    };
    if (!take(before[0]) || !take(before[1]))
        refuse(file, 1, "This is no table of a study: its first columns must be point and replicate.");
    take(before[2]);
    take(before[3]);
    take_all_until("status", Role::factor);
    if (!take({"status", Role::status, false})) refuse(file, 1, "The column status is missing.");
    take_all_until(after[0].name, Role::metric);
    for (const FixedColumn& fixed : after)
        if (!take(fixed)) refuse(file, 1, fmt::format("The column {} is missing.", fixed.name));
    if (at < names.size()) refuse(file, 1, fmt::format("The column {} is not known at this place.", names[at]));
    return columns;
}

/// A column whose numbers turn out to be words.
void become_words(StudyColumn& column, WordList& words)
{
    for (const double number : column.numbers)
        column.word_of.push_back(words.place_of(std::isnan(number) ? "" : fmt::format("{}", number)));
    column.numbers.clear();
    column.is_number = false;
}

void add_field(StudyColumn& column, WordList& words, std::string_view field, const std::string& file, std::size_t line)
{
    if (column.is_number) {
        if (field.empty()) {
            column.numbers.push_back(std::numeric_limits<double>::quiet_NaN());
            return;
        }
        if (const std::optional<double> number = number_of(field)) {
            column.numbers.push_back(*number);
            return;
        }
        if (column.role != Role::factor)
            refuse(file, line, fmt::format("{} must be a number; given is \"{}\".", column.name, cut_text(field, 60)));
        become_words(column, words);
    }
    column.word_of.push_back(words.place_of(field));
}

} // namespace

std::string StudyColumn::text(std::size_t row) const
{
    if (!is_number) return word(row);
    return std::isnan(numbers[row]) ? std::string() : fmt::format("{}", numbers[row]);
}

const StudyColumn* StudyTable::find(std::string_view name) const
{
    const auto found = std::find_if(columns.begin(), columns.end(), [&](const StudyColumn& column) { return column.name == name; });
    return found == columns.end() ? nullptr : &*found;
}

const StudyColumn* StudyTable::find(StudyColumnRole role) const
{
    const auto found = std::find_if(columns.begin(), columns.end(), [&](const StudyColumn& column) { return column.role == role; });
    return found == columns.end() ? nullptr : &*found;
}

std::vector<const StudyColumn*> StudyTable::all(StudyColumnRole role) const
{
    std::vector<const StudyColumn*> found;
    for (const StudyColumn& column : columns)
        if (column.role == role) found.push_back(&column);
    return found;
}

StudyTable parse_results(std::string_view text, const std::string& name)
{
    CsvRows rows(text);
    if (!rows.next_line()) refuse(name, 1, "The header is missing.");
    std::vector<std::string> names;
    while (const auto field = rows.next_field()) names.emplace_back(*field);
    if (names.size() > most_table_columns)
        refuse(name, 1, fmt::format("There are {} columns; at most {} are read.", names.size(), most_table_columns));
    StudyTable table{columns_of(names, name)};
    std::vector<WordList> words(table.columns.size());
    while (rows.next_line()) {
        if (table.rows() == most_table_rows) refuse(name, rows.line_number(), fmt::format("At most {} rows are read.", most_table_rows));
        for (std::size_t k = 0; k < table.columns.size(); ++k) {
            const auto field = rows.next_field();
            if (!field) refuse(name, rows.line_number(), fmt::format("There are {} fields; the header has {}.", k, names.size()));
            add_field(table.columns[k], words[k], *field, name, rows.line_number());
        }
        if (rows.next_field())
            refuse(name, rows.line_number(), fmt::format("There are more fields than the {} of the header.", names.size()));
    }
    if (!rows.ends_whole()) refuse(name, rows.line_number() + 1, "The last line is torn; write the table anew with --merge.");
    for (std::size_t k = 0; k < table.columns.size(); ++k) table.columns[k].words = words[k].words();
    return table;
}

StudyTable read_results(const std::filesystem::path& file) { return parse_results(read_file(file, largest_table_bytes), file.string()); }

std::string format_results(const StudyTable& table)
{
    std::string text;
    for (const StudyColumn& column : table.columns) text += (text.empty() ? "" : ",") + csv_field(column.name);
    text += '\n';
    std::vector<std::vector<std::string>> fields; // of words, quoted where they need it
    for (const StudyColumn& column : table.columns) {
        fields.emplace_back();
        for (const std::string& word : column.words) fields.back().push_back(csv_field(word));
    }
    for (std::size_t row = 0; row < table.rows(); ++row) {
        for (std::size_t k = 0; k < table.columns.size(); ++k) {
            const StudyColumn& column = table.columns[k];
            if (k > 0) text += ',';
            if (!column.is_number)
                text += fields[k][column.word_of[row]];
            else if (!std::isnan(column.numbers[row]))
                fmt::format_to(std::back_inserter(text), "{}", column.numbers[row]);
        }
        text += '\n';
    }
    return text;
}

} // namespace hygroloom
