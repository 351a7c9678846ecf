// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/error.h"
#include "core/base/utf8.h"
#include "core/run/run_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hygroloom {
namespace {

[[noreturn]] void refuse(const std::string& place, const std::string& what) { throw FileError(fmt::format("\"{}\" {}", place, what)); }
[[noreturn]] void refuse_missing(const std::string& place) { refuse(place, "is missing; the recording is damaged or no recording."); }

/// Throws FileError with what is wrong behind its place.
double finite_number(const Statement& row, int column, const std::string& place)
{
    if (row.type(column) != Statement::Type::number && row.type(column) != Statement::Type::whole) refuse(place, "is not a number.");
    if (!std::isfinite(row.number(column))) refuse(place, "is not a finite number.");
    return row.number(column);
}

/// A field of so many numbers of 4 bytes.
std::string_view sized_field(const Statement& row, int column, std::size_t least, std::size_t most, const std::string& place)
{
    constexpr std::size_t size = 4;
    if (row.type(column) != Statement::Type::bytes) refuse(place, "is not a field of numbers.");
    const std::string_view field = row.bytes(column);
    const std::uint64_t bytes = unpacked_bytes(field);
    if (bytes < least * size || bytes > most * size)
        refuse(place, least == most ? fmt::format("has {} values; expected are {}.", bytes / size, least)
                                    : fmt::format("has {} values; a file of this size cannot hold them.", bytes / size));
    return field;
}

template <typename Number> std::vector<Number> numbers_of(std::string_view field, const std::string& place)
{
    try {
        return unpacked<Number>(field);
    } catch (const FileError& error) {
        refuse(place, error.what());
    }
}

std::vector<float> finite_floats(std::string_view field, const std::string& place)
{
    std::vector<float> values = numbers_of<float>(field, place);
    if (!std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); }))
        refuse(place, "holds a number that is not finite.");
    return values;
}

} // namespace

double StoredRow::number(const std::string& name) const
{
    if (!has(name)) refuse_missing(place_of(name));
    return finite_number(*statement_, cells_.at(name), place_of(name));
}

std::string_view StoredRow::field(const std::string& name, std::size_t least, std::size_t most) const
{
    if (!has(name)) refuse_missing(place_of(name));
    return sized_field(*statement_, cells_.at(name), least, most, place_of(name));
}

std::vector<float> StoredRow::floats(const std::string& name, std::size_t expected) const
{
    return finite_floats(field(name, expected, expected), place_of(name));
}

std::vector<float> StoredRow::triples(const std::string& name, std::size_t most) const
{
    std::vector<float> values = finite_floats(field(name, 0, 3 * most), place_of(name));
    if (values.size() % 3 != 0) refuse(place_of(name), fmt::format("has {} values, which are no triples.", values.size()));
    return values;
}

std::vector<std::uint32_t> StoredRow::counts(const std::string& name, std::size_t expected) const
{
    return numbers_of<std::uint32_t>(field(name, expected, expected), place_of(name));
}

RunFileReader::RunFileReader(const std::filesystem::path& path, const char* table) : source_(path), opened_(source_.open())
{
    if (source_.is_being_written()) opened_->run("BEGIN");
    columns_ = columns_of_plain_tables(*opened_, table);
    values_ = rows_of_meta(*opened_);
}

const Database& RunFileReader::database() const
{
    if (!opened_) throw std::logic_error("a recording was let go of before it was read");
    return *opened_;
}

void RunFileReader::release() { opened_.reset(); }

Statement RunFileReader::value(const std::string& name) const
{
    const auto found = values_.find(name);
    if (found == values_.end()) refuse_missing(name);
    Statement value = database().statement("SELECT value FROM meta WHERE rowid=?1");
    if (!value.bind(1, found->second).step()) refuse_missing(name);
    return value;
}

std::string RunFileReader::text(const std::string& name) const
{
    const Statement found = value(name);
    if (found.type(0) != Statement::Type::text) refuse(name, "is not a text.");
    return in_whole_utf8(found.bytes(0));
}

double RunFileReader::number(const std::string& name) const { return finite_number(value(name), 0, name); }

long RunFileReader::count(const std::string& name, long least, long most) const
{
    const double value = number(name);
    if (!(value >= static_cast<double>(least) && value <= static_cast<double>(most)) || value != std::floor(value))
        refuse(name, fmt::format("is {:g}; expected is a whole number from {} to {}.", value, least, most));
    return static_cast<long>(value);
}

std::vector<float> RunFileReader::floats(const std::string& name, std::size_t expected) const
{
    const Statement found = value(name);
    return finite_floats(sized_field(found, 0, expected, expected, name), name);
}

bool RunFileReader::has_column(const std::string& name) const
{
    return std::any_of(columns_.begin(), columns_.end(), [&](const TableColumn& column) { return column.name == name; });
}

namespace {

void require_after(const StoredFrame& frame, double last)
{
    const double time = frame.time, of_ledger = frame.ledger.time;
    if (time < 0 || std::abs(time - of_ledger) > 1e-6 * (1 + time))
        throw FileError(fmt::format("its time is {:.4g} s, and {:.4g} s in the ledger.", time, of_ledger));
    if (time <= last) throw FileError(fmt::format("its time, {:.4g} s, does not come after {:.4g} s.", time, last));
}

} // namespace

std::vector<StoredFrame> RunFileReader::frames(const std::function<void(std::int64_t, const std::string&)>& leave_out) const
{
    constexpr int most_problems = 1000;
    constexpr std::int64_t most_frames = 1'000'000'000;
    std::vector<const LedgerColumn*> of_ledger;
    std::string names = std::string("number,") + time_column;
    for (const LedgerColumn& column : ledger_columns) {
        if (!has_column(column_of(column))) continue; // recordings of older versions lack some
        of_ledger.push_back(&column);
        names += "," + column_of(column);
    }
    if (!has_column(time_column)) throw FileError("its table \"frames\" has no times; it is damaged or no recording.");
    std::vector<StoredFrame> frames;
    std::int64_t next = 0;
    Statement rows = database().statement(fmt::format("SELECT {} FROM frames ORDER BY number", names));
    for (int problems = 0; problems < most_problems;) {
        StoredFrame frame;
        try {
            if (!rows.step()) break;
            frame.number = rows.whole(0);
            if (frame.number < next || frame.number >= most_frames)
                throw FileError(fmt::format("behind it stands number {}.", frame.number));
        } catch (const FileError& error) {
            leave_out(next, fmt::format("{} None after it is read.", error.what()));
            break;
        }
        if (frame.number > next) leave_out(next, "it is missing.");
        next = frame.number + 1;
        try {
            const auto number = [&](int column, const std::string& name) {
                return finite_number(rows, column, fmt::format("frames/{:06d}/{}", frame.number, name));
            };
            frame.time = number(1, time_column);
            for (std::size_t k = 0; k < of_ledger.size(); ++k)
                frame.ledger.*of_ledger[k]->value = number(static_cast<int>(k) + 2, column_of(*of_ledger[k]));
            require_after(frame, frames.empty() ? -1 : frames.back().time);
            frames.push_back(frame);
        } catch (const FileError& error) {
            leave_out(frame.number, error.what());
            ++problems;
        }
    }
    return frames;
}

StoredRow RunFileReader::row(std::int64_t number, const std::vector<std::string>& names) const
{
    StoredRow row;
    row.place_ = fmt::format("frames/{:06d}", number);
    std::string wanted = "number";
    for (const std::string& name : names)
        if (has_column(name) && !row.has(name)) {
            row.cells_[name] = static_cast<int>(row.cells_.size()) + 1;
            wanted += "," + sql_name(name);
        }
    row.database_ = opened_ ? opened_ : source_.open();
    row.statement_.emplace(row.database_->statement(fmt::format("SELECT {} FROM frames WHERE number=?1", wanted)));
    if (!row.statement_->bind(1, number).step()) refuse_missing(row.place_);
    std::erase_if(row.cells_, [&](const auto& cell) { return row.statement_->type(cell.second) == Statement::Type::none; });
    return row;
}

} // namespace hygroloom
