// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "tests/support/crafted_recording.h"

#include "tests/support/drop_design.h"

#include <fmt/format.h>
#include <sqlite3.h>

namespace hygroloom {
namespace {

/// As SQL: numbers, texts and bytes that no recording has there. A field says how many bytes its numbers are, in 8 bytes.
constexpr const char* values[] = {"0",
                                  "1",
                                  "-1",
                                  "2",
                                  "0.5",
                                  "1e300",
                                  "-1e300",
                                  "1e-310",
                                  "9e999",
                                  "3e9",
                                  "4000",
                                  "-0.0",
                                  "9223372036854775807",
                                  "NULL",
                                  "''",
                                  "'text'",
                                  "x''",
                                  "x'00'",
                                  "x'0000000000000000'",
                                  "x'0400000000000000'",
                                  "x'FFFFFFFFFFFFFFFF'",
                                  "x'0000000000000080'",
                                  "x'801800000000000000'",
                                  "x'8018000000000000789C030000000001'",
                                  "zeroblob(8)",
                                  "zeroblob(6280)",
                                  "zeroblob(1000000)",
                                  "randomblob(6280)",
                                  "replace(hex(zeroblob(100000)),'0','a')"};

constexpr const char* words[] = {"",
                                 "hygroloom-recording",
                                 "\xFF\xFE\x80",
                                 "\x1b]0;x\x07\x1b[31m",
                                 "{}",
                                 "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[",
                                 "{\"region\":{\"first_end\":-1,\"first_pick\":-2147483648,\"ends\":2147483647,\"picks\":1}}",
                                 "18446744073709551616",
                                 "-1",
                                 "1e9",
                                 "cloth",
                                 "drop",
                                 "2026-11-22T18:40:12Z",
                                 "null"};

/// An open file; SQL that fails is left undone.
class Opened {
public:
    explicit Opened(const std::string& path)
    {
        sqlite3_open(path.c_str(), &file_);
        sqlite3_db_config(file_, SQLITE_DBCONFIG_DEFENSIVE, 0, nullptr);
        run("PRAGMA synchronous=OFF");
        sqlite3_progress_handler( // a view without end is read no further
            file_, 10'000'000, [](void*) { return 1; }, nullptr);
    }
    ~Opened() { sqlite3_close(file_); }
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;

    bool run(const std::string& sql) const { return sqlite3_exec(file_, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK; }
    std::string bytes(const std::string& sql) const
    {
        std::string found;
        sqlite3_stmt* row = nullptr;
        sqlite3_prepare_v2(file_, sql.c_str(), -1, &row, nullptr);
        if (sqlite3_step(row) == SQLITE_ROW && sqlite3_column_bytes(row, 0) > 0)
            found.assign(static_cast<const char*>(sqlite3_column_blob(row, 0)), static_cast<std::size_t>(sqlite3_column_bytes(row, 0)));
        sqlite3_finalize(row);
        return found;
    }

private:
    sqlite3* file_ = nullptr;
};

std::string in_hex(const std::string& bytes)
{
    std::string text = "x'";
    for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
    return text + "'";
}

template <typename Names> const char* one_of(const Names& names, Choices& choices) { return names[choices.of(std::size(names))]; }

/// A place of a value, as in UPDATE TABLE SET COLUMN=... WHERE ...
struct Spot {
    std::string table, column, where;
    std::string set(const std::string& to) const { return fmt::format("UPDATE {} SET \"{}\"={} WHERE {}", table, column, to, where); }
    std::string get() const { return fmt::format("SELECT \"{}\" FROM {} WHERE {}", column, table, where); }
};

Spot in_meta(const char* name) { return {"meta", "value", fmt::format("name='{}'", name)}; }
Spot in_frames(const CraftTargets& targets, Choices& choices)
{
    return {"frames", one_of(targets.columns, choices), fmt::format("number={}", choices.of(3))};
}

Spot any_value(const CraftTargets& targets, Choices& choices)
{
    switch (choices.of(5)) {
    case 0: return in_meta(one_of(targets.numbers, choices));
    case 1: return in_meta(one_of(targets.texts, choices));
    case 2: return targets.fields.empty() ? in_frames(targets, choices) : in_meta(one_of(targets.fields, choices));
    default: return in_frames(targets, choices);
    }
}

std::string change_value(const Opened& file, const CraftTargets& targets, Choices& choices)
{
    const std::string sql = any_value(targets, choices).set(one_of(values, choices));
    file.run(sql);
    return sql;
}

std::string change_text(const Opened& file, const CraftTargets& targets, Choices& choices)
{
    const std::string sql = in_meta(one_of(targets.texts, choices)).set(fmt::format("CAST({} AS TEXT)", in_hex(one_of(words, choices))));
    file.run(sql);
    return sql;
}

std::string remove_row(const Opened& file, const CraftTargets& targets, Choices& choices)
{
    const std::string sql = choices.of(3) == 0 ? fmt::format("DELETE FROM frames WHERE number={}", choices.of(3))
                                               : fmt::format("DELETE FROM meta WHERE name='{}'",
                                                             one_of(choices.of(2) == 0 ? targets.texts : targets.numbers, choices));
    file.run(sql);
    return sql;
}

/// In place, as a flipped bit would; or cut.
std::string change_bytes(const Opened& file, const CraftTargets& targets, Choices& choices)
{
    const Spot place = any_value(targets, choices);
    std::string bytes = file.bytes(place.get());
    if (bytes.empty()) return "nothing";
    const std::size_t at = (choices.of(256) * 256 + choices.of(256)) % bytes.size();
    if (choices.of(4) == 0)
        bytes.resize(at);
    else
        bytes[choices.of(2) == 0 ? at % 12 % bytes.size() : at] = static_cast<char>(choices.of(256));
    const bool is_text = place.table == "meta" && file.bytes(fmt::format("SELECT typeof(value) FROM meta WHERE {}", place.where)) == "text";
    file.run(place.set(is_text ? fmt::format("CAST({} AS TEXT)", in_hex(bytes)) : in_hex(bytes)));
    return fmt::format("byte {} of {} of {}", at, place.column, place.where);
}

/// Tables that are none, or others.
std::string change_tables(const Opened& file, const CraftTargets&, Choices& choices)
{
    constexpr const char* changes[] = {
        "DROP TABLE meta",
        "DROP TABLE frames",
        "ALTER TABLE frames RENAME TO f; CREATE VIEW frames AS SELECT * FROM f",
        "ALTER TABLE meta RENAME TO m; CREATE VIEW meta AS SELECT * FROM m",
        "ALTER TABLE frames RENAME TO f; CREATE VIEW frames AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i+1 FROM n) SELECT i AS "
        "number FROM n",
        "CREATE TRIGGER t AFTER INSERT ON meta BEGIN DELETE FROM frames; END",
        "CREATE INDEX i ON meta(name)",
        "CREATE TABLE other(x)",
        "ALTER TABLE frames ADD COLUMN more REAL DEFAULT 1",
        "ALTER TABLE frames ADD COLUMN more AS (zeroblob(100000000))",
        "ALTER TABLE frames DROP COLUMN liquid",
        "ALTER TABLE frames RENAME COLUMN time_s TO time",
        "CREATE VIRTUAL TABLE v USING fts5(x)",
        "INSERT INTO meta SELECT * FROM meta",
        "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i+1 FROM n LIMIT 3000) INSERT INTO meta SELECT 'name'||i, i, '' FROM n",
        "WITH RECURSIVE n(i) AS (SELECT 10 UNION ALL SELECT i+1 FROM n LIMIT 3000) INSERT INTO frames(number,time_s,ledger_time_s) SELECT "
        "i, i, i FROM n",
        "UPDATE frames SET number=number-5",
        "UPDATE frames SET number=9223372036854775000+number",
        "UPDATE frames SET number=number*1000",
        "PRAGMA writable_schema=ON; UPDATE sqlite_schema SET rootpage=5-rootpage",
        "PRAGMA writable_schema=ON; UPDATE sqlite_schema SET rootpage=1",
        "PRAGMA writable_schema=ON; UPDATE sqlite_schema SET rootpage=4000000000",
        "PRAGMA writable_schema=ON; UPDATE sqlite_schema SET type='view' WHERE name='meta'",
        "PRAGMA writable_schema=ON; UPDATE sqlite_schema SET sql='CREATE TABLE frames(number INTEGER PRIMARY KEY)' WHERE name='frames'",
        "PRAGMA writable_schema=ON; UPDATE sqlite_schema SET sql=replace(sql,'REAL','INTEGER')",
        "PRAGMA user_version=0",
        "PRAGMA user_version=77",
        "PRAGMA application_id=1",
        "PRAGMA encoding='UTF-16'; VACUUM",
        "PRAGMA page_size=512; VACUUM",
        "PRAGMA auto_vacuum=FULL; VACUUM",
        "PRAGMA journal_mode=WAL"};
    const char* const sql = one_of(changes, choices);
    file.run(sql);
    return sql;
}

/// A number in a text of JSON.
std::string change_json(const Opened& file, const CraftTargets& targets, Choices& choices)
{
    const char* name = one_of(targets.jsons, choices);
    std::string text = file.bytes(in_meta(name).get());
    if (text.empty()) return "nothing";
    const std::size_t from = (choices.of(256) * 256 + choices.of(256)) % text.size();
    const std::size_t digit = text.find_first_of("0123456789", from);
    if (digit == std::string::npos) return "nothing";
    const std::size_t end = text.find_first_not_of("0123456789.eE+-", digit);
    constexpr const char* strange[] = {"-1",     "0",    "1e308", "2147483647", "-2147483648",         "4294967296",
                                       "1e-300", "null", "\"\"",  "[]",         "99999999999999999999"};
    const std::string value = one_of(strange, choices);
    text.replace(digit, (end == std::string::npos ? text.size() : end) - digit, value);
    file.run(in_meta(name).set(fmt::format("CAST({} AS TEXT)", in_hex(text))));
    return fmt::format("number at {} of {} is {}", digit, name, value);
}

} // namespace

bool craft_by_sql(const std::string& path, const std::string& sql) { return Opened(path).run(sql); }

RunRecord small_run()
{
    RunRecord run;
    run.design = drop_design();
    run.fabric = run.design.fabrics[0].name;
    run.experiment = run.design.experiments[0].name;
    const std::array<double, 2> sample = run.design.experiments[0].sample_mm;
    run.plan.region = region_of_sample(run.design.fabrics[0], sample[0], sample[1]);
    run.textile = build_textile(run.design, run.design.fabrics[0], run.plan.region);
    run.backend = "cpu";
    run.device = "a device";
    run.date = "2026-11-22T18:40:12Z";
    return run;
}

Frame small_frame(const RunRecord& run, int number)
{
    Frame frame;
    const auto n = static_cast<std::size_t>(run.textile.segments());
    frame.time = frame.ledger.time = 0.1 * number;
    frame.resize_fields(n);
    for (std::size_t i = 0; i < n; ++i) frame.saturation[i] = static_cast<float>(i % 7) / 7;
    frame.temperature.assign(n, 293.15F);
    frame.positions.assign(static_cast<std::size_t>(number), {0.001F, 0, 0.002F});
    frame.velocities.assign(static_cast<std::size_t>(number), {0, 0, -1});
    return frame;
}

void write_small_recording(const std::string& path)
{
    const RunRecord run = small_run();
    RecordingWriter writer(path, run);
    for (int k = 0; k < 3; ++k) writer.append(small_frame(run, k));
    writer.note_device("a device; from 0.1 s on another");
    writer.note_switched_on({.name = "heat", .time = 0.1, .share = 0.1, .limit = 0.01, .estimate = 0.2, .kept_off = "the run was over"});
    writer.finish(1);
}

const CraftTargets& targets_of_a_sample()
{
    static const CraftTargets targets{{"wall_s", "in_bundles", "provenance/threads", "provenance/switched_on/heat/time_s",
                                       "provenance/switched_on/heat/share", "provenance/switched_on/heat/estimate"},
                                      {"format", "design", "provenance/fabric", "provenance/experiment", "provenance/backend",
                                       "provenance/device", "provenance/all_devices", "provenance/plan", "provenance/date",
                                       "provenance/seed", "provenance/switched_on/heat/kept_off"},
                                      {"textile/length"},
                                      {"time_s", "ledger_time_s", "water_delivered_kg", "free_until_s", "water_top_kg", "water_bottom_kg",
                                       "follows", "saturation", "liquid", "bound_water", "vapour_concentration", "temperature",
                                       "liquid_between", "particle_position", "particle_velocity", "cap_place", "cap_size", "wet"},
                                      {"provenance/plan", "design"}};
    return targets;
}

std::string craft(const std::string& path, Choices choices, const CraftTargets& targets)
{
    const Opened file(path);
    using Change = std::string (*)(const Opened&, const CraftTargets&, Choices&);
    constexpr Change changes[] = {change_value, change_value, change_text,   remove_row,
                                  change_bytes, change_bytes, change_tables, change_json};
    std::string did;
    do did += (did.empty() ? "" : "; ") + changes[choices.of(std::size(changes))](file, targets, choices);
    while (choices.any_left());
    return did;
}

} // namespace hygroloom
