// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The two tables of a recording, or of a study's results, as this program makes them. In a stranger's file nothing else may stand.
#pragma once

#include "core/run/database.h"

#include <map>
#include <vector>

namespace hygroloom {

struct TableColumn {
    std::string name;
    std::string type; ///< "REAL", "TEXT", "BLOB"
};
/// The statement that makes a table whose rows have a number of their own, and these columns.
std::string create_table(std::string_view name, const std::vector<TableColumn>& columns);
/// As application and version.
void mark_as_recording(const Database& database);
/// A table of values by name, of any type; a field of numbers has a unit.
void create_meta(const Database& database);

/// Of the other table, without the number. Throws FileError where the file holds anything but both tables, or those are of another form.
std::vector<TableColumn> columns_of_plain_tables(const Database& database, std::string_view table);
/// The values' rows by their names. Throws FileError where the table is damaged.
std::map<std::string, std::int64_t> rows_of_meta(const Database& database);

} // namespace hygroloom
