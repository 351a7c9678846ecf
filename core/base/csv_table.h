// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Tables that other programs wrote as CSV.
#pragma once

#include <string>
#include <vector>

namespace hygroloom {

/// A table with a header. Columns that were not asked for are left out.
struct CsvTable {
    std::string file;
    std::vector<std::vector<std::string>> rows; ///< in the order of the asked columns; an absent optional column is empty everywhere
    std::vector<std::size_t> lines;             ///< of each row, from 1
    bool by_semicolons = false;                 ///< then a comma in a number is its decimal one
};

/// Fields between commas (or, where the header has no comma, semicolons), with quotes or without, as RFC 4180 has them; lines end with LF,
/// CR or both; those that are empty or start with # are skipped, as is a first line such as sep=; that Excel writes. Throws Error naming
/// the file, the line and the fault: a required column is missing, named twice, a row has another number of fields than the header, there
/// are more than 100 000 rows, a field has more than 1000 characters, columns are separated by tabs, the text is not UTF-8.
CsvTable read_csv(const std::string& text, const std::string& file, const std::vector<std::string>& required,
                  const std::vector<std::string>& optional);

/// The columns' names, read as read_csv() does. Throws the same.
std::vector<std::string> csv_header(const std::string& text, const std::string& file);

/// Names of columns for a sentence, the first of them where there are many.
std::string column_list(const std::vector<std::string>& names);

/// The number in a field. Throws Error naming file, line and column.
double number_in(const CsvTable& table, std::size_t row, std::size_t column, const std::string& name);

} // namespace hygroloom
