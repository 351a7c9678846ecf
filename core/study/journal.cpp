// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/study/journal.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/project/atomic_file.h"
#include "core/run/writer_lock.h"
#include "core/study/csv_rows.h"
#include "core/study/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace hygroloom {
namespace {

constexpr std::size_t largest_part_bytes = std::size_t{4} << 30U, most_distinct_words = 2'000'000;
constexpr std::string_view first_word = "hygroloom-study-part 2 "; // a program that places points differently has another number

[[noreturn]] void fail(const std::filesystem::path& path, int code)
{
    throw FileError(fmt::format("{}: The file cannot be written: {}.", path.string(), std::strerror(code)));
}

[[noreturn]] void refuse_mark(const std::filesystem::path& file)
{
    throw FileError(file.string() +
                    ": These rows are of another study or project, or of a version of the program that has other points. Give "
                    "another folder, or remove this file.");
}

/// Whole lines of a part, without its torn end.
std::string whole_lines(const std::filesystem::path& file)
{
    std::error_code failure;
    const std::uintmax_t bytes = std::filesystem::file_size(file, failure);
    if (failure) throw FileError(fmt::format("{}: The file cannot be read: {}.", file.string(), failure.message()));
    if (bytes == 0) return {};
    std::string text = read_file(file, largest_part_bytes);
    text.resize(text.rfind('\n') + 1); // npos + 1 is 0
    return text;
}

} // namespace

KeptRows::KeptRows(std::size_t rows, std::size_t metrics)
    : metric_count_(metrics), states_(rows, State::missing), metrics_(rows * metrics, std::numeric_limits<double>::quiet_NaN()),
      walls_(rows), words_of_(3 * rows)
{
    place_of("");
}

std::uint32_t KeptRows::place_of(std::string_view word)
{
    if (const auto found = places_.find(word); found != places_.end()) return found->second;
    if (words_.size() == most_distinct_words) throw Error("The parts of the study have too many different words.");
    const auto place = static_cast<std::uint32_t>(words_.size());
    words_.emplace_back(word);
    places_.emplace(word, place);
    return place;
}

std::size_t KeptRows::count(State state) const { return static_cast<std::size_t>(std::count(states_.begin(), states_.end(), state)); }

void KeptRows::keep(std::size_t row, const StudyRowResult& result, std::string_view commit)
{
    if (result.failed && states_[row] == State::done) return;
    states_[row] = result.failed ? State::failed : State::done;
    std::copy(result.metrics.begin(), result.metrics.end(), metrics_.begin() + static_cast<std::ptrdiff_t>(row * metric_count_));
    walls_[row] = result.wall;
    words_of_[3 * row] = place_of(result.device);
    words_of_[3 * row + 1] = place_of(commit);
    words_of_[3 * row + 2] = place_of(result.reason);
}

void KeptRows::read_part(const std::filesystem::path& file, const std::string& mark)
{
    const std::string text = whole_lines(file);
    CsvRows lines(text);
    if (!lines.next_line()) return; // it was killed before its first line
    if (lines.line() != std::string(first_word) + mark) refuse_mark(file);
    StudyRowResult result;
    result.metrics.resize(metric_count_);
    while (lines.next_line()) {
        const auto refuse = [&] {
            throw FileError(fmt::format("{}: line {}: This is no row of the study; remove the line.", file.string(), lines.line_number()));
        };
        const auto field = [&]() -> std::string_view {
            const auto next = lines.next_field();
            if (!next) refuse();
            return *next;
        };
        const auto row = number_of<std::size_t>(field());
        if (!row || *row >= rows()) refuse();
        const std::string_view status = field();
        if (status != row_done && status != row_failed) refuse();
        result.failed = status == row_failed;
        for (double& metric : result.metrics) {
            const std::string_view written = field();
            const std::optional<double> number = written.empty() ? std::numeric_limits<double>::quiet_NaN() : number_of(written);
            if (!number) refuse();
            metric = *number;
        }
        const std::optional<double> wall = number_of(field());
        if (!wall) refuse();
        result.wall = *wall;
        result.device = field();
        const std::string commit(field());
        result.reason = field();
        if (lines.next_field()) refuse();
        keep(*row, result, commit);
    }
}

void KeptRows::read_parts(const std::filesystem::path& folder, const std::string& mark)
{
    std::vector<std::filesystem::path> files;
    std::error_code failure;
    if (std::filesystem::directory_iterator at(folder / "parts", failure); !failure) {
        for (; !failure && at != std::filesystem::directory_iterator(); at.increment(failure))
            if (at->path().extension() == ".csv") files.push_back(at->path());
    } else if (failure == std::errc::no_such_file_or_directory) {
        failure.clear();
    }
    if (failure) throw FileError(fmt::format("{}: The folder cannot be read: {}.", (folder / "parts").string(), failure.message()));
    std::sort(files.begin(), files.end());
    for (const auto& file : files) read_part(file, mark);
}

Journal::Journal(const std::filesystem::path& file, const std::string& mark) : path_(file)
{
    file_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file_ < 0) fail(file, errno);
    try {
        if (!lock_as_writer(file_))
            throw FileError(file.string() + ": Another program runs this part of the study now. Wait for it, or end it.");
        const std::string text = whole_lines(file);
        if (::ftruncate(file_, static_cast<off_t>(text.size())) != 0) fail(file, errno);
        const std::string head = std::string(first_word) + mark + "\n";
        if (text.empty())
            write_line(head);
        else if (!text.starts_with(head))
            refuse_mark(file);
    } catch (...) {
        ::close(file_);
        throw;
    }
}

Journal::~Journal()
{
    ::fdatasync(file_);
    ::close(file_);
}

/// What is written of a line that does not fit is taken off again, so that the next one does not run into it.
void Journal::write_line(const std::string& line)
{
    const off_t before = torn_ ? -1 : ::lseek(file_, 0, SEEK_END);
    if (before < 0) fail(path_, torn_ ? EIO : errno);
    std::size_t done = 0;
    while (done < line.size()) {
        const ssize_t written = ::write(file_, line.data() + done, line.size() - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) {
            const int code = written < 0 ? errno : ENOSPC;
            torn_ = done > 0 && ::ftruncate(file_, before) != 0;
            fail(path_, code);
        }
        done += static_cast<std::size_t>(written);
    }
}

void Journal::add(const StudyRowResult& result)
{
    std::string line = fmt::format("{},{}", result.row, result.failed ? row_failed : row_done);
    for (const double metric : result.metrics) line += std::isnan(metric) ? "," : fmt::format(",{}", metric);
    line += fmt::format(",{:.3f},{},{},{}\n", result.wall, csv_field(result.device), csv_field(program_commit()), csv_field(result.reason));
    {
        constexpr auto often = std::chrono::milliseconds(500); // each time takes some milliseconds
        const std::lock_guard lock(mutex_);
        write_line(line);
        const auto now = std::chrono::steady_clock::now();
        if (now - synced_ < often) return;
        synced_ = now;
    }
    if (::fdatasync(file_) != 0 && errno != EINVAL && errno != ENOSYS) fail(path_, errno); // some file systems cannot
}

} // namespace hygroloom
