// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/run_file.h"

#include "core/base/error.h"

#include <fmt/format.h>

namespace hygroloom {

void RunRow::number(const std::string& name, double value) { statement_.bind(places_.at(name), value); }
void RunRow::bytes(const std::string& name, std::string_view field) { statement_.bind_copy(places_.at(name), field); }

RunFileWriter::RunFileWriter(const std::filesystem::path& path, const char* format, const std::vector<RunColumn>& columns)
    : name_(path.string()), target_(path)
{
    std::vector<TableColumn> all{{time_column, "REAL"}};
    for (const LedgerColumn& column : ledger_columns) all.push_back({column_of(column), "REAL"});
    for (const RunColumn& column : columns) all.push_back({column.name, column.unit ? "BLOB" : "REAL"});
    std::string names = "number", places = "?1";
    for (const TableColumn& column : all) {
        places_[column.name] = static_cast<int>(places_.size()) + 2;
        names += "," + sql_name(column.name);
        places += fmt::format(",?{}", places_[column.name]);
    }
    insert_sql_ = fmt::format("INSERT INTO frames({}) VALUES({})", names, places);
    attempt([&] {
        create_meta(target_.open());
        target_.open().run(create_table("frames", all));
    });
    text("format", format);
    for (const RunColumn& column : columns)
        if (column.unit) text("unit/" + column.name, column.unit);
}

/// Frames that wait are not lost.
RunFileWriter::~RunFileWriter()
{
    insert_.reset();
    if (closed_ || frames_ == 0 || !failure_.empty()) return;
    try {
        target_.commit(may_replace());
        target_.close(false);
    } catch (const FileError&) {
        // the frames before can be read
    }
}

template <typename Write> void RunFileWriter::attempt(Write write)
{
    try {
        if (!failure_.empty()) throw FileError(failure_);
        write();
    } catch (const FileError& error) {
        failure_ = error.what();
        insert_.reset();
        target_.give_up();
        throw FileError(fmt::format("{}: {}; {}", name_, failure_,
                                    target_.in_place()
                                        ? fmt::format("the recording ends at {:.4g} s and can be read up to there.", kept_end_)
                                        : "nothing was recorded, and what had this name before stays."));
    }
}

void RunFileWriter::commit_if_due()
{
    if (!waits_ || !target_.is_due()) return;
    if (!target_.in_place()) insert_.reset();
    target_.commit(may_replace());
    kept_end_ = end_;
    waits_ = false;
}

template <typename Bind> void RunFileWriter::put(const std::string& name, Bind bind)
{
    const std::lock_guard alone(adding_);
    attempt([&] {
        const Database& database = target_.open();
        database.statement("DELETE FROM meta WHERE name=?1").bind_text(1, name).run();
        Statement insert = database.statement("INSERT INTO meta VALUES(?1,?2,?3)");
        bind(insert.bind_text(1, name)).run();
        waits_ = frames_ > 0;
        commit_if_due();
    });
}

void RunFileWriter::text(const std::string& name, std::string_view value)
{
    put(name, [&](Statement& insert) -> Statement& { return insert.bind_text(2, value); });
}

void RunFileWriter::number(const std::string& name, double value)
{
    put(name, [&](Statement& insert) -> Statement& { return insert.bind(2, value); });
}

void RunFileWriter::put_field(const std::string& name, const std::function<std::string_view()>& pack, const char* unit)
{
    put(name, [&](Statement& insert) -> Statement& { return insert.bind_bytes(2, pack()).bind_text(3, unit); });
}

void RunFileWriter::append(double time, const Ledger& ledger, const std::function<void(RunRow&)>& fill)
{
    const std::lock_guard alone(adding_);
    attempt([&] {
        const Database& database = target_.open();
        if (!insert_) insert_.emplace(database.statement(insert_sql_));
        RunRow row(*insert_, places_, packer_);
        row.number(time_column, time);
        for (const LedgerColumn& column : ledger_columns) row.number(column_of(column), ledger.*column.value);
        fill(row);
        insert_->bind(1, frames_).run();
        ++frames_;
        end_ = time;
        waits_ = true;
        commit_if_due();
    });
}

void RunFileWriter::commit_when_due()
{
    const std::unique_lock alone(adding_, std::try_to_lock);
    if (alone) attempt([&] { commit_if_due(); });
}

void RunFileWriter::finish(double wall)
{
    number("wall_s", wall);
    attempt([&] {
        insert_.reset();
        target_.commit(true);
        target_.close(true);
        closed_ = true;
    });
}

} // namespace hygroloom
