// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The file of a run, of a sample or a garment: an SQLite database with a table "meta" of named values (texts, numbers, fields of numbers
// with their unit) and a table "frames", a row a frame: its number and time, the columns of the ledger, numbers and fields of numbers by
// name. See packed_numbers.h for fields.
#pragma once

#include "core/run/packed_numbers.h"
#include "core/run/recording_source.h"
#include "core/run/recording_target.h"
#include "core/run/run_tables.h"
#include "core/scene/frame.h"

#include <functional>
#include <map>
#include <mutex>
#include <optional>

namespace hygroloom {

/// A column of frames beside number and ledger. unit: none of a number.
struct RunColumn {
    std::string name;
    const char* unit = nullptr;
};

/// The column of a number of the ledger, which tells the time of its sums by itself.
inline std::string column_of(const LedgerColumn& column) { return column.value == &Ledger::time ? "ledger_time_s" : column.name; }
constexpr const char* time_column = "time_s";

/// What stands in one row of frames, while it is written.
class RunRow {
public:
    void number(const std::string& name, double value);
    template <typename Number> void field(const std::string& name, std::span<const Number> numbers, int level = NumberPacker::usual_level)
    {
        bytes(name, packer_.packed(numbers, level));
    }

private:
    friend class RunFileWriter;
    RunRow(Statement& statement, const std::map<std::string, int>& places, NumberPacker& packer)
        : statement_(statement), places_(places), packer_(packer)
    {
    }
    void bytes(const std::string& name, std::string_view field);

    Statement& statement_;
    const std::map<std::string, int>& places_;
    NumberPacker& packer_;
};

/// Any thread may call. What fails leaves the recording as the last commit made it, and nothing is added to it any more: FileError, which
/// says so.
class RunFileWriter {
public:
    RunFileWriter(const std::filesystem::path& path, const char* format, const std::vector<RunColumn>& columns);
    ~RunFileWriter();

    void text(const std::string& name, std::string_view value);
    void number(const std::string& name, double value);
    template <typename Number> void field(const std::string& name, std::span<const Number> numbers, const char* unit)
    {
        put_field(
            name, [&] { return packer_.packed(numbers); }, unit);
    }
    void append(double time, const Ledger& ledger, const std::function<void(RunRow&)>& fill);
    /// Lets what was added take effect, where that has waited long enough: while nothing is added. Does nothing while another thread adds.
    void commit_when_due();
    /// Notes the wall time, s, and closes.
    void finish(double wall);

private:
    template <typename Write> void attempt(Write write);
    template <typename Bind> void put(const std::string& name, Bind bind);
    void put_field(const std::string& name, const std::function<std::string_view()>& pack, const char* unit);
    void commit_if_due();
    /// The state that a run begins with is no reason to lose an older recording.
    bool may_replace() const { return frames_ > 1; }

    std::string name_;
    RecordingTarget target_;
    std::mutex adding_;
    NumberPacker packer_;
    std::string insert_sql_;
    std::optional<Statement> insert_;
    std::map<std::string, int> places_; ///< of columns, among the values of an insert
    std::string failure_;
    std::int64_t frames_ = 0;
    double end_ = 0;      ///< s, of the last frame
    double kept_end_ = 0; ///< s, of the last frame that took effect
    bool waits_ = false;  ///< something was added since the last commit
    bool closed_ = false;
};

/// Some columns of a row of frames, by their names.
class StoredRow {
public:
    bool has(const std::string& name) const { return cells_.contains(name); }
    double number(const std::string& name) const;
    /// As many as expected, finite.
    std::vector<float> floats(const std::string& name, std::size_t expected) const;
    /// Any number of x, y and z, up to a limit.
    std::vector<float> triples(const std::string& name, std::size_t most) const;
    /// Whole numbers, as many as expected.
    std::vector<std::uint32_t> counts(const std::string& name, std::size_t expected) const;

private:
    friend class RunFileReader;
    std::string place_of(const std::string& name) const { return place_ + "/" + name; }
    std::string_view field(const std::string& name, std::size_t least, std::size_t most) const;

    std::string place_;
    std::shared_ptr<const Database> database_;
    std::optional<Statement> statement_;
    std::map<std::string, int> cells_; ///< columns that are there
};

/// What the file says of a frame without its fields.
struct StoredFrame {
    std::int64_t number = 0; ///< in the file
    double time = 0;         ///< s
    Ledger ledger;
};

/// Reads one; nothing in it is trusted. All throw FileError, without the file's name.
class RunFileReader {
public:
    /// Throws where it is no database of this program, or holds more than plain tables.
    explicit RunFileReader(const std::filesystem::path& path, const char* table = "frames");

    bool is_being_written() const { return source_.is_being_written(); }
    std::uint64_t size() const { return source_.size(); } ///< bytes

    bool has(const std::string& name) const { return values_.contains(name); }
    bool has_column(const std::string& name) const;
    /// What is no UTF-8 becomes the replacement character.
    std::string text(const std::string& name) const;
    /// Finite.
    double number(const std::string& name) const;
    /// A whole number within bounds.
    long count(const std::string& name, long least, long most) const;
    /// As many as expected, finite.
    std::vector<float> floats(const std::string& name, std::size_t expected) const;

    const std::vector<TableColumn>& columns() const { return columns_; } ///< of the table
    /// In order of time. leave_out gets what is wrong with the others.
    std::vector<StoredFrame> frames(const std::function<void(std::int64_t, const std::string&)>& leave_out) const;
    /// With these columns. Throws where there is no such row.
    StoredRow row(std::int64_t number, const std::vector<std::string>& names) const;
    /// The database as it was when it was opened, until release().
    const Database& database() const;
    /// A run that writes the file need not wait for what is kept of it.
    void release();

private:
    Statement value(const std::string& name) const;

    RecordingSource source_;
    std::shared_ptr<const Database> opened_;
    std::map<std::string, std::int64_t> values_; ///< rows of meta by their names
    std::vector<TableColumn> columns_;
};

} // namespace hygroloom
