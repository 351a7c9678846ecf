// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/database.h"

#include "core/base/error.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <cerrno>
#include <cstring>
#include <new>

namespace hygroloom {
namespace {

constexpr int patience = 2000;               ///< ms, for another program
constexpr int steps_between = 10'000;        ///< of SQLite's machine, between looks at how many there were
constexpr std::int64_t most_looks = 100'000; ///< at which a statement is stopped: some seconds
constexpr int longest_sql = 200'000;         ///< bytes; of a table of a thousand columns
constexpr int most_columns = 1100;

std::string reason_of(int code, int cause, bool reads)
{
    const std::string why = cause == 0 ? "" : std::string(": ") + std::strerror(cause);
    switch (code & 0xFF) {
    case SQLITE_FULL: return "the disk is full";
    case SQLITE_IOERR:
        if (!reads && (cause == EDQUOT || cause == ENOSPC)) return "the disk is full";
        return (reads ? "it cannot be read" : "it cannot be written") + why;
    case SQLITE_CANTOPEN: return "it cannot be opened" + why;
    case SQLITE_BUSY: return "another program holds it";
    case SQLITE_INTERRUPT: return "it takes too long to be read; it is damaged";
    default: return "it is damaged";
    }
}

[[noreturn]] void fail(sqlite3* database, int code)
{
    const int last = errno; // what a commit failed of, SQLite does not keep
    if ((code & 0xFF) == SQLITE_NOMEM || !database) throw std::bad_alloc();
    const int cause = sqlite3_system_errno(database);
    const bool reads = sqlite3_db_readonly(database, "main") == 1;
    throw FileError(reason_of(code, cause != 0 ? cause : last, reads) + (reads ? "." : ""));
}

/// A path with what else SQLite shall know.
std::string uri_of(const std::filesystem::path& path, const char* options)
{
    std::string uri = "file:";
    for (const char letter : std::filesystem::absolute(path).string())
        uri += letter == '%' || letter == '?' || letter == '#' ? fmt::format("%{:02X}", letter) : std::string(1, letter);
    return uri + options;
}

const char* options_of(Database::Access access)
{
    using enum Database::Access;
    switch (access) {
    case create: return "?mode=rwc";
    case write: return "?mode=rw";
    case beside_run: return "?mode=ro";
    case left_over: return "?mode=ro&vfs=unix-none"; // nobody else may look: no lock is asked for, and nothing written beside it
    case finished: break;
    }
    return "?immutable=1";
}

int count_down(void* looks) { return --*static_cast<std::int64_t*>(looks) < 0 ? 1 : 0; }

/// What a reader lets a file of a stranger do.
void trust_nothing(sqlite3* database, std::int64_t* looks)
{
    for (const int off :
         {SQLITE_DBCONFIG_TRUSTED_SCHEMA, SQLITE_DBCONFIG_ENABLE_VIEW, SQLITE_DBCONFIG_ENABLE_TRIGGER, SQLITE_DBCONFIG_DQS_DML,
          SQLITE_DBCONFIG_DQS_DDL, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, SQLITE_DBCONFIG_ENABLE_FKEY})
        sqlite3_db_config(database, off, 0, nullptr);
    for (const int on : {SQLITE_DBCONFIG_DEFENSIVE, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE}) sqlite3_db_config(database, on, 1, nullptr);
    for (const auto& [which, most] : {std::pair{SQLITE_LIMIT_SQL_LENGTH, longest_sql},
                                      {SQLITE_LIMIT_COLUMN, most_columns},
                                      {SQLITE_LIMIT_EXPR_DEPTH, 20},
                                      {SQLITE_LIMIT_COMPOUND_SELECT, 2},
                                      {SQLITE_LIMIT_VDBE_OP, 100'000},
                                      {SQLITE_LIMIT_ATTACHED, 0},
                                      {SQLITE_LIMIT_TRIGGER_DEPTH, 1},
                                      {SQLITE_LIMIT_WORKER_THREADS, 0},
                                      {SQLITE_LIMIT_VARIABLE_NUMBER, 10}})
        sqlite3_limit(database, which, most);
    sqlite3_progress_handler(database, steps_between, count_down, looks);
}

} // namespace

void Statement::Close::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
void Database::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

Statement::Statement(sqlite3* database, std::string_view sql) : database_(database)
{
    sqlite3_stmt* made = nullptr;
    if (const int code = sqlite3_prepare_v2(database, sql.data(), static_cast<int>(sql.size()), &made, nullptr); code != SQLITE_OK)
        fail(database, code);
    statement_.reset(made);
}

Statement& Statement::bind(int place, double value)
{
    if (const int code = sqlite3_bind_double(statement_.get(), place, value); code != SQLITE_OK) fail(database_, code);
    return *this;
}

Statement& Statement::bind(int place, std::int64_t value)
{
    if (const int code = sqlite3_bind_int64(statement_.get(), place, value); code != SQLITE_OK) fail(database_, code);
    return *this;
}

Statement& Statement::bind_text(int place, std::string_view text)
{
    const int code = sqlite3_bind_text64(statement_.get(), place, text.data() ? text.data() : "", text.size(), SQLITE_STATIC, SQLITE_UTF8);
    if (code != SQLITE_OK) fail(database_, code);
    return *this;
}

Statement& Statement::bind_bytes(int place, std::string_view bytes)
{
    const int code = sqlite3_bind_blob64(statement_.get(), place, bytes.data() ? bytes.data() : "", bytes.size(), SQLITE_STATIC);
    if (code != SQLITE_OK) fail(database_, code);
    return *this;
}

Statement& Statement::bind_copy(int place, std::string_view bytes)
{
    const int code = sqlite3_bind_blob64(statement_.get(), place, bytes.data(), bytes.size(), SQLITE_TRANSIENT);
    if (code != SQLITE_OK) fail(database_, code);
    return *this;
}

bool Statement::step()
{
    const int code = sqlite3_step(statement_.get());
    if (code != SQLITE_ROW && code != SQLITE_DONE) fail(database_, code);
    return code == SQLITE_ROW;
}

void Statement::run()
{
    struct Reset {
        sqlite3_stmt* statement;
        ~Reset()
        {
            sqlite3_reset(statement);
            sqlite3_clear_bindings(statement);
        }
    } const reset{statement_.get()};
    while (step()) continue;
}

Statement::Type Statement::type(int column) const
{
    switch (sqlite3_column_type(statement_.get(), column)) {
    case SQLITE_INTEGER: return Type::whole;
    case SQLITE_FLOAT: return Type::number;
    case SQLITE_TEXT: return Type::text;
    case SQLITE_BLOB: return Type::bytes;
    default: return Type::none;
    }
}

double Statement::number(int column) const { return sqlite3_column_double(statement_.get(), column); }
std::int64_t Statement::whole(int column) const { return sqlite3_column_int64(statement_.get(), column); }

std::string_view Statement::bytes(int column) const
{
    const void* const bytes = sqlite3_column_blob(statement_.get(), column);
    if (!bytes && sqlite3_errcode(database_) == SQLITE_NOMEM) throw std::bad_alloc();
    return {static_cast<const char*>(bytes), bytes ? static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column)) : 0};
}

Database::Database(const std::filesystem::path& path, Access access)
{
    const bool writes = access == Access::create || access == Access::write;
    sqlite3* opened = nullptr;
    const int code = sqlite3_open_v2(
        uri_of(path, options_of(access)).c_str(), &opened,
        SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX | (writes ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READONLY), nullptr);
    database_.reset(opened);
    if (code != SQLITE_OK && !writes) throw FileError(reason_of(code, sqlite3_system_errno(opened), true) + ".");
    if (code != SQLITE_OK) fail(opened, code);
    sqlite3_extended_result_codes(opened, 1);
    sqlite3_busy_timeout(opened, patience);
    if (access == Access::create) {
        run("PRAGMA locking_mode=EXCLUSIVE");
        run("PRAGMA journal_mode=OFF");
        run("PRAGMA synchronous=OFF");
    } else if (access == Access::write) {
        run("PRAGMA journal_mode=WAL"); // where the file system cannot share memory, the journal stays another one
        run("PRAGMA synchronous=OFF");  // who writes syncs where it matters
        run("PRAGMA wal_autocheckpoint=0");
    } else {
        looks_left_ = std::make_unique<std::int64_t>(most_looks);
        trust_nothing(opened, looks_left_.get());
        run("PRAGMA cell_size_check=ON");
        if (access == Access::left_over) run("PRAGMA locking_mode=EXCLUSIVE");
    }
}

Statement Database::statement(std::string_view sql) const
{
    if (looks_left_) *looks_left_ = most_looks;
    return {database_.get(), sql};
}

std::uint32_t Database::pages() const
{
    Statement count = statement("PRAGMA page_count");
    return count.step() ? static_cast<std::uint32_t>(count.whole(0)) : 0;
}

void Database::checkpoint() const
{
    const int code = sqlite3_wal_checkpoint_v2(database_.get(), nullptr, SQLITE_CHECKPOINT_PASSIVE, nullptr, nullptr);
    if (code != SQLITE_OK && code != SQLITE_BUSY) fail(database_.get(), code);
}

void Database::become_one_file() const
{
    const int code = sqlite3_exec(database_.get(), "PRAGMA journal_mode=DELETE", nullptr, nullptr, nullptr);
    if (code != SQLITE_OK && (code & 0xFF) != SQLITE_BUSY) fail(database_.get(), code);
}

std::string sql_name(std::string_view name)
{
    std::string quoted = "\"";
    for (const char letter : name) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
    return quoted + '"';
}

} // namespace hygroloom
