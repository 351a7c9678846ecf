// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The results of a study as a table of columns, a row for each point, fabric, experiment and replicate.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hygroloom {

/// point, replicate, fabric and experiment (each of the last two only where there are several), factors, status, metrics, wall_s, device,
/// commit, reason; in this order.
enum class StudyColumnRole { point, replicate, fabric, experiment, factor, status, metric, wall, device, commit, reason };

/// Numbers, or words by their place in a list of those that occur. An empty cell is NaN, or the empty word.
struct StudyColumn {
    std::string name; ///< of a factor its path, of a metric its key
    StudyColumnRole role = StudyColumnRole::metric;
    bool is_number = true;
    std::vector<double> numbers;
    std::vector<std::string> words;     ///< that occur
    std::vector<std::uint32_t> word_of; ///< of each row
    std::size_t size() const { return is_number ? numbers.size() : word_of.size(); }
    const std::string& word(std::size_t row) const { return words[word_of[row]]; }
    /// As the CSV has it.
    std::string text(std::size_t row) const;
};

/// That are read.
constexpr std::size_t most_table_columns = 1000, most_table_rows = 2'000'000;

struct StudyTable {
    std::vector<StudyColumn> columns;
    std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
    /// nullptr: there is none.
    const StudyColumn* find(std::string_view name) const;
    /// The first of that role; nullptr: there is none.
    const StudyColumn* find(StudyColumnRole role) const;
    std::vector<const StudyColumn*> all(StudyColumnRole role) const;
};

/// Status of a row.
constexpr const char *row_done = "done", *row_failed = "failed";

/// From DIR/results.csv. 100 000 rows take a tenth of a second. Throws FileError.
StudyTable read_results(const std::filesystem::path& file);
StudyTable parse_results(std::string_view text, const std::string& name);
std::string format_results(const StudyTable& table);

/// From DIR/study.sqlite, which has the same columns. Throws FileError.
StudyTable read_results_database(const std::filesystem::path& file);
/// project and study: their texts, which stand beside the columns. Throws FileError.
void write_results_database(const StudyTable& table, const std::string& project, const std::string& study,
                            const std::filesystem::path& file);

} // namespace hygroloom
