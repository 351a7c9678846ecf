// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The table of a study as an SQLite database: "rows" with a column for each of the table's, and "meta" with project, study, and the names
// and roles of the columns.
#include "core/study/results.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "core/project/json_reader.h"
#include "core/run/recording_head.h"
#include "core/run/run_file.h"
#include "core/study/csv_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace hygroloom {
namespace {

using Role = StudyColumnRole;

constexpr const char* study_format = "hygroloom-study-results";
constexpr std::uint64_t least_room = std::uint64_t{1} << 30U; // bytes; besides three times the file's size

/// By the columns' names, of which SQLite tells none from another in other letters.
std::vector<TableColumn> columns_of(const StudyTable& table)
{
    std::vector<TableColumn> columns;
    std::set<std::string> taken{"number"};
    for (const StudyColumn& column : table.columns) {
        const auto small = [](std::string text) {
            std::transform(text.begin(), text.end(), text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
            return text;
        };
        std::string name = column.name;
        while (!taken.insert(small(name)).second) name += "_";
        columns.push_back({name, column.is_number ? "REAL" : "TEXT"});
    }
    return columns;
}

void write_rows(const Database& database, const StudyTable& table)
{
    const std::vector<TableColumn> columns = columns_of(table);
    database.run(create_table("rows", columns));
    std::string places = "?1";
    for (std::size_t k = 0; k < columns.size(); ++k) places += fmt::format(",?{}", k + 2);
    Statement insert = database.statement(fmt::format("INSERT INTO rows VALUES({})", places));
    for (std::size_t row = 0; row < table.rows(); ++row) {
        insert.bind(1, static_cast<std::int64_t>(row));
        for (std::size_t k = 0; k < columns.size(); ++k) {
            const StudyColumn& column = table.columns[k];
            const int place = static_cast<int>(k) + 2;
            if (!column.is_number)
                insert.bind_text(place, column.word(row));
            else if (!std::isnan(column.numbers[row]))
                insert.bind(place, column.numbers[row]);
        }
        insert.run();
    }
}

void write_database(const std::filesystem::path& path, const StudyTable& table, const std::string& project, const std::string& study)
{
    ProjectJson names = ProjectJson::array();
    for (const StudyColumn& column : table.columns) names.push_back({column.name, static_cast<int>(column.role)});
    const Database database(path, Database::Access::create);
    mark_as_recording(database);
    database.run("BEGIN");
    create_meta(database);
    for (const auto& [name, text] :
         {std::pair<const char*, std::string>{"format", study_format}, {"project", project}, {"study", study}, {"columns", names.dump()}})
        database.statement("INSERT INTO meta(name,value) VALUES(?1,?2)").bind_text(1, name).bind_text(2, text).run();
    write_rows(database, table);
    database.run("COMMIT");
}

/// Columns without rows, as the file tells them.
std::vector<StudyColumn> read_columns(const RunFileReader& file, const std::string& name)
{
    const ProjectJson names = parse_json(file.text("columns"), "columns");
    std::vector<StudyColumn> columns;
    for (const ProjectJson& one : array_in(names, name, "columns")) {
        if (columns.size() == most_table_columns || !one.is_array() || one.size() != 2 || !one[0].is_string() ||
            !one[1].is_number_unsigned() || one[1].get<unsigned>() > static_cast<unsigned>(Role::reason))
            throw FileError("columns: This is no table of a study.");
        columns.push_back({one[0].get<std::string>(), static_cast<Role>(one[1].get<int>()), true, {}, {}, {}});
    }
    if (columns.size() != file.columns().size())
        throw FileError(fmt::format("rows: The table has {} columns; {} are named.", file.columns().size(), columns.size()));
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k].is_number = file.columns()[k].type == "REAL";
    return columns;
}

/// Row after row. room: bytes that they may take.
class RowReader {
public:
    RowReader(StudyTable& table, std::uint64_t room) : table_(table), words_(table.columns.size()), room_(room) {}

    void add(const Statement& row)
    {
        if (table_.rows() == most_table_rows) throw FileError(fmt::format("rows: At most {} rows are read.", most_table_rows));
        if (row.whole(0) != next_++) throw FileError("rows: The rows are not counted one by one; the file is damaged.");
        for (std::size_t k = 0; k < table_.columns.size(); ++k) add(table_.columns[k], words_[k], row, static_cast<int>(k) + 1);
    }
    void finish()
    {
        for (std::size_t k = 0; k < table_.columns.size(); ++k) table_.columns[k].words = words_[k].words();
    }

private:
    void add(StudyColumn& column, WordList& words, const Statement& row, int place)
    {
        using enum Statement::Type;
        const Statement::Type type = row.type(place);
        take_room(column, column.is_number ? sizeof(double) : sizeof(column.word_of[0]));
        if (column.is_number ? type != number && type != whole && type != none : type != text)
            throw FileError(fmt::format("rows/{}: This must be {}.", column.name, column.is_number ? "numbers" : "words"));
        if (column.is_number) {
            column.numbers.push_back(type == none ? std::numeric_limits<double>::quiet_NaN() : row.number(place));
            return;
        }
        const std::string_view word = row.bytes(place);
        const std::size_t known = words.words().size();
        column.word_of.push_back(words.place_of(word));
        if (words.words().size() > known) take_room(column, 2 * (sizeof(std::string) + word.size())); // in a list and a map
    }
    void take_room(const StudyColumn& column, std::uint64_t bytes)
    {
        if (bytes > room_)
            throw FileError(
                fmt::format("rows/{}: This and what stands before it take more memory than a file of this size may.", column.name));
        room_ -= bytes;
    }

    StudyTable& table_;
    std::vector<WordList> words_;
    std::uint64_t room_;
    std::int64_t next_ = 0;
};

/// As the table of results.csv has it.
bool has_type_of_role(const StudyColumn& column)
{
    switch (column.role) {
    case Role::point:
    case Role::replicate:
    case Role::metric:
    case Role::wall: return column.is_number;
    case Role::factor: return true;
    default: return !column.is_number;
    }
}

StudyTable read_table(const std::filesystem::path& path)
{
    const RunFileReader file(path, "rows");
    if (file.text("format") != study_format) throw FileError("This is no table of a study.");
    StudyTable table{read_columns(file, "columns")};
    for (const StudyColumn& column : table.columns)
        if (!has_type_of_role(column))
            throw FileError(fmt::format("rows/{}: This has words for numbers, or numbers for words.", column.name));
    for (const Role role : {Role::point, Role::replicate, Role::status})
        if (!table.find(role)) throw FileError("columns: The point, the replicate or the status is missing.");
    RowReader reader(table, least_room + 3 * file.size());
    Statement rows = file.database().statement("SELECT * FROM rows ORDER BY number");
    while (rows.step()) reader.add(rows);
    reader.finish();
    return table;
}

} // namespace

void write_results_database(const StudyTable& table, const std::string& project, const std::string& study,
                            const std::filesystem::path& path)
{
    try {
        write_file_with(path, [&](const std::filesystem::path& temporary) { write_database(temporary, table, project, study); });
    } catch (const FileError& error) {
        throw FileError(path.string() + ": The file cannot be written: " + error.what() + ".");
    }
}

StudyTable read_results_database(const std::filesystem::path& path)
{
    try {
        return read_table(path);
    } catch (const Error& error) {
        throw FileError(path.string() + ": " + error.what());
    } catch (const std::bad_alloc&) {
        throw FileError(path.string() + ": The memory does not suffice to read it.");
    }
}

} // namespace hygroloom
