// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A thin layer over SQLite's C library: databases and statements that close themselves, and failures as sentences.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace hygroloom {

/// One statement of SQL. Places of values count from 1, columns from 0. Throws std::bad_alloc, and FileError without the file's name: of
/// readers a sentence, of writers the reason alone.
class Statement {
public:
    Statement& bind(int place, double value);
    Statement& bind(int place, std::int64_t value);
    /// The bytes stay where they are until the statement was run.
    Statement& bind_text(int place, std::string_view text);
    Statement& bind_bytes(int place, std::string_view bytes);
    Statement& bind_copy(int place, std::string_view bytes);
    /// Whether there is another row.
    bool step();
    /// To its end, and back to its beginning without values.
    void run();

    enum class Type { whole, number, text, bytes, none };
    Type type(int column) const;
    double number(int column) const;
    std::int64_t whole(int column) const;
    /// Of a text, or bytes; until the next step.
    std::string_view bytes(int column) const;

private:
    friend class Database;
    struct Close {
        void operator()(sqlite3_stmt* statement) const;
    };
    Statement(sqlite3* database, std::string_view sql);

    sqlite3* database_;
    std::unique_ptr<sqlite3_stmt, Close> statement_;
};

class Database {
public:
    enum class Access {
        create,     ///< an empty file, that nobody reads until it is closed
        write,      ///< what was created, beside readers
        beside_run, ///< read while another writes
        left_over,  ///< read what a killed run left in two files
        finished    ///< read a file that nobody writes
    };
    /// Of strangers' files nothing but tables is read: no extension, view or trigger. Throws FileError without the file's name.
    Database(const std::filesystem::path& path, Access access);

    Statement statement(std::string_view sql) const;
    void run(std::string_view sql) const { statement(sql).run(); }
    /// How many it has, with those beside the file.
    std::uint32_t pages() const;
    /// Brings what was written beside the file into it, as far as readers let it.
    void checkpoint() const;
    /// The file alone has all from here on, unless another program holds it for more than 2 s.
    void become_one_file() const;

private:
    struct Close {
        void operator()(sqlite3* database) const;
    };
    std::unique_ptr<sqlite3, Close> database_;
    std::unique_ptr<std::int64_t> looks_left_; ///< at a reader's statement, until it is stopped
};

/// As a name in SQL.
std::string sql_name(std::string_view name);

} // namespace hygroloom
