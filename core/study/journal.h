// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The rows of a study as they end: each is one whole line of its writer's own file, so that a killed writer loses only what was under way,
// and any number of writers work side by side.
#pragma once

#include "core/study/study_rows.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>

namespace hygroloom {

/// What the lines of a folder's parts say of each row.
class KeptRows {
public:
    enum class State : std::uint8_t { missing, failed, done };

    KeptRows(std::size_t rows, std::size_t metrics);
    /// All parts of a folder; none where there is no such folder. A torn last line does not count. Throws FileError: a part is not of the
    /// study with that mark, or cannot be read.
    void read_parts(const std::filesystem::path& folder, const std::string& mark);
    /// A row that failed does not replace one that is done.
    void keep(std::size_t row, const StudyRowResult& result, std::string_view commit);

    std::size_t rows() const { return states_.size(); }
    std::size_t count(State state) const;
    State state(std::size_t row) const { return states_[row]; }
    const double* metrics(std::size_t row) const { return &metrics_[row * metric_count_]; }
    double wall(std::size_t row) const { return walls_[row]; }
    /// Device, commit, reason.
    const std::string& word(std::size_t row, int which) const { return words_[words_of_[3 * row + static_cast<std::size_t>(which)]]; }

private:
    void read_part(const std::filesystem::path& file, const std::string& mark);
    std::uint32_t place_of(std::string_view word);

    std::size_t metric_count_;
    std::vector<State> states_;
    std::vector<double> metrics_, walls_;
    std::vector<std::uint32_t> words_of_;
    std::vector<std::string> words_;
    std::map<std::string, std::uint32_t, std::less<>> places_;
};

/// A writer's own file. Any thread may add.
class Journal {
public:
    /// Goes on at the end of the file's last whole line, or begins it. Throws FileError: it cannot be written, another program writes it,
    /// it is of another study.
    Journal(const std::filesystem::path& file, const std::string& mark);
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    /// It is on the disk within half a second, or once the next row is. Throws FileError; the file then ends as before.
    void add(const StudyRowResult& result);

private:
    void write_line(const std::string& line);

    std::mutex mutex_;
    std::filesystem::path path_;
    int file_ = -1;
    std::chrono::steady_clock::time_point synced_{}; ///< the last time
    bool torn_ = false;                              ///< its last line is not whole, and cannot be taken off
};

} // namespace hygroloom
