// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/run_tables.h"

#include "core/base/error.h"
#include "core/base/utf8.h"
#include "core/run/recording_head.h"

#include <fmt/format.h>

namespace hygroloom {
namespace {

constexpr std::string_view meta_table = "CREATE TABLE meta(name TEXT,value,unit TEXT)";

/// Its sentence must not break the line.
std::string shown(std::string_view text) { return in_one_line(text.substr(0, 60)); }

} // namespace

std::string create_table(std::string_view name, const std::vector<TableColumn>& columns)
{
    std::string sql = fmt::format("CREATE TABLE {}(number INTEGER PRIMARY KEY", name);
    for (const TableColumn& column : columns) sql += "," + sql_name(column.name) + " " + column.type;
    return sql + ")";
}

void mark_as_recording(const Database& database)
{
    database.run(fmt::format("PRAGMA application_id={}", recording_application));
    database.run(fmt::format("PRAGMA user_version={}", recording_version));
}

void create_meta(const Database& database) { database.run(meta_table); }

std::vector<TableColumn> columns_of_plain_tables(const Database& database, std::string_view table)
{
    std::map<std::string, std::string> made; // by name
    Statement schema = database.statement("SELECT name, sql FROM sqlite_schema");
    while (schema.step()) {
        const std::string name(schema.bytes(0));
        if ((name != "meta" && name != table) || made.contains(name))
            throw FileError(fmt::format("it holds \"{}\", which recordings do not; it is damaged or no recording.", shown(name)));
        made[name] = schema.bytes(1);
    }
    std::vector<TableColumn> columns;
    Statement info = database.statement(fmt::format("PRAGMA table_xinfo({})", table));
    while (info.step())
        if (info.bytes(1) != "number") columns.push_back({std::string(info.bytes(1)), std::string(info.bytes(2))});
    const auto require = [&](std::string_view name, const std::string& sql) {
        const auto found = made.find(std::string(name));
        if (found == made.end()) throw FileError(fmt::format("its table \"{}\" is missing; it is damaged or no recording.", name));
        if (found->second != sql) throw FileError(fmt::format("its table \"{}\" has another form than recordings have.", name));
    };
    require("meta", std::string(meta_table));
    require(table, create_table(table, columns));
    return columns;
}

std::map<std::string, std::int64_t> rows_of_meta(const Database& database)
{
    Statement check = database.statement("PRAGMA quick_check(meta)");
    if (!check.step() || check.bytes(0) != "ok") throw FileError("its table \"meta\" is damaged.");
    std::map<std::string, std::int64_t> rows;
    Statement names = database.statement("SELECT name, rowid FROM meta");
    while (names.step()) rows.try_emplace(in_whole_utf8(names.bytes(0)), names.whole(1));
    return rows;
}

} // namespace hygroloom
