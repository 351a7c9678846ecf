// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the folder of a study holds, and the table that is made of its parts.
#include "core/study/study_folder.h"

#include "core/base/error.h"
#include "core/design/validate.h"
#include "core/project/atomic_file.h"
#include "core/project/project_file.h"
#include "core/study/csv_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace hygroloom {
namespace {

using Role = StudyColumnRole;

bool is_there(const std::filesystem::path& file)
{
    std::error_code none;
    return std::filesystem::exists(file, none);
}

/// Whether a table has more than its header.
bool has_rows(const std::filesystem::path& table)
{
    std::ifstream file(table);
    std::string line;
    return std::getline(file, line) && file.peek() != std::ifstream::traits_type::eof();
}

/// A table is made of its parts: without them it would become an empty one.
void require_parts_of(const std::filesystem::path& table)
{
    if (has_rows(table))
        throw Error(table.string() + ": The table has rows whose parts are gone, and would be lost. Move it, or give another folder.");
}

/// A folder that no study has run in may hold files of the user's with the names that a study gives its own.
void require_not_the_users(const StudyFolder& study, const std::filesystem::path& folder)
{
    if (is_there(folder / "parts")) return;
    for (const auto& [name, text] : {std::pair{"project.hygro", &study.project_text}, std::pair{"study.json", &study.study_text}})
        if (is_there(folder / name) && read_file(folder / name, largest_project_bytes) != *text)
            throw Error((folder / name).string() + ": The results would replace this file, which is not theirs. Give another folder.");
}

/// Column after column of the rows that have ended.
class TableMaker {
public:
    TableMaker(const StudyFolder& study, const KeptRows& kept) : study_(study), kept_(kept), frame_(study.study, study.design)
    {
        for (std::size_t row = 0; row < kept.rows(); ++row)
            if (kept.state(row) != KeptRows::State::missing) rows_.push_back(row);
    }

    StudyTable make()
    {
        StudyTable table;
        to_ = &table;
        numbers("point", Role::point, [&](std::size_t row) { return static_cast<double>(frame_.row(row).point); });
        numbers("replicate", Role::replicate, [&](std::size_t row) { return frame_.row(row).replicate; });
        if (frame_.fabrics().size() > 1)
            words("fabric", Role::fabric, [&](std::size_t row) { return frame_.fabrics()[frame_.row(row).fabric]; });
        if (frame_.experiments().size() > 1)
            words("experiment", Role::experiment, [&](std::size_t row) { return frame_.experiments()[frame_.row(row).experiment]; });
        add_factors();
        words("status", Role::status,
              [&](std::size_t row) { return std::string(kept_.state(row) == KeptRows::State::done ? row_done : row_failed); });
        for (std::size_t k = 0; k < frame_.metrics().size(); ++k)
            numbers(frame_.metrics()[k], Role::metric, [&](std::size_t row) { return kept_.metrics(row)[k]; });
        numbers("wall_s", Role::wall, [&](std::size_t row) { return kept_.wall(row); });
        words("device", Role::device, [&](std::size_t row) { return kept_.word(row, 0); });
        words("commit", Role::commit, [&](std::size_t row) { return kept_.word(row, 1); });
        words("reason", Role::reason, [&](std::size_t row) { return kept_.word(row, 2); });
        return table;
    }

private:
    template <typename Value> void numbers(const std::string& name, Role role, const Value& value)
    {
        StudyColumn column{name, role, true, {}, {}, {}};
        for (const std::size_t row : rows_) column.numbers.push_back(value(row));
        to_->columns.push_back(std::move(column));
    }
    template <typename Value> void words(const std::string& name, Role role, const Value& value)
    {
        StudyColumn column{name, role, false, {}, {}, {}};
        WordList list;
        for (const std::size_t row : rows_) column.word_of.push_back(list.place_of(value(row)));
        column.words = list.words();
        to_->columns.push_back(std::move(column));
    }
    void add_factors()
    {
        const StudyPoints points = study_points(study_.study, study_.design);
        for (std::size_t k = 0; k < points.factors().size(); ++k) {
            const Factor& factor = points.factors()[k];
            const bool all_numbers =
                std::all_of(factor.values.begin(), factor.values.end(), [](const FactorValue& v) { return v.is_number; });
            if (all_numbers)
                numbers(factor.path, Role::factor, [&](std::size_t row) { return points.value(frame_.row(row).point, k).number; });
            else
                words(factor.path, Role::factor, [&](std::size_t row) { return points.value(frame_.row(row).point, k).text; });
        }
    }

    const StudyFolder& study_;
    const KeptRows& kept_;
    StudyFrame frame_;
    std::vector<std::size_t> rows_;
    StudyTable* to_ = nullptr;
};

/// The first points of which a row is missing.
std::string missing_points(const StudyFrame& frame, const KeptRows& kept)
{
    constexpr std::size_t most_named = 8;
    std::vector<std::size_t> points;
    for (std::size_t row = 0; row < kept.rows(); ++row) {
        if (kept.state(row) != KeptRows::State::missing) continue;
        const std::size_t point = frame.row(row).point;
        if (points.empty() || points.back() != point) points.push_back(point);
    }
    std::string text;
    for (std::size_t i = 0; i < std::min(points.size(), most_named); ++i) text += fmt::format("{}{}", i > 0 ? ", " : "", points[i]);
    if (points.size() > most_named) text += fmt::format(" and {} more", points.size() - most_named);
    return text;
}

} // namespace

StudyFrame::StudyFrame(const Study& study, const Design& design)
    : fabrics_(fabrics_of(study, design)), experiments_(experiments_of(study, design)), metrics_(metrics_of(study, design)),
      replicates_(static_cast<std::size_t>(study.replicates)),
      rows_(study_points(study, design).size() * fabrics_.size() * experiments_.size() * replicates_)
{
}

StudyRun StudyFrame::row(std::size_t number) const
{
    StudyRun row;
    row.replicate = static_cast<int>(number % replicates_);
    number /= replicates_;
    row.experiment = number % experiments_.size();
    number /= experiments_.size();
    row.fabric = number % fabrics_.size();
    row.point = number / fabrics_.size();
    return row;
}

std::string mark_of(const std::string& project_text, const std::string& study_text)
{
    std::uint64_t hash = 0xcbf29ce484222325ULL; // Fowler, Noll and Vo's, 1a, 64 bits
    for (const std::string* text : {&project_text, &study_text})
        for (const unsigned char letter : *text) hash = (hash ^ letter) * 0x100000001b3ULL;
    return fmt::format("{:016x}", hash);
}

StudyFolder folder_of(const Design& design, const Study& study) { return {design, study, format_project(design), format_study(study)}; }

StudyFolder read_study_folder(const std::filesystem::path& folder)
{
    if (!is_there(folder / "study.json") || !is_there(folder / "project.hygro"))
        throw FileError(folder.string() + ": This folder holds no study: study.json and project.hygro are missing.");
    StudyFolder read;
    read.project_text = read_file(folder / "project.hygro", largest_project_bytes);
    read.study_text = read_file(folder / "study.json", largest_project_bytes);
    read.design = parse_project(read.project_text, (folder / "project.hygro").string());
    read.study = parse_study(read.study_text, (folder / "study.json").string());
    for (const std::vector<Issue>& issues : {validate(read.design), validate(read.study, read.design)})
        if (const Issue* error = first_error(issues))
            throw FileError(fmt::format("{}: {}: {}", folder.string(), error->where.text(), error->text()));
    return read;
}

KeptRows prepared_rows(const StudyFolder& study, const std::filesystem::path& folder, const StudyOptions& options)
{
    const StudyFrame frame(study.study, study.design);
    const bool has_study = is_there(folder / "study.json");
    const bool same = has_study && is_there(folder / "project.hygro") &&
                      read_file(folder / "study.json", largest_project_bytes) == study.study_text &&
                      read_file(folder / "project.hygro", largest_project_bytes) == study.project_text;
    std::error_code none;
    const bool has_parts = !std::filesystem::is_empty(folder / "parts", none) && !none;
    if (!has_study && (is_there(folder / "results.csv") || is_there(folder / "study.sqlite")))
        throw Error(folder.string() + ": The folder has results of something else; give another folder.");
    if (has_parts && !same)
        throw Error(folder.string() + ": The folder has the rows of another study or project (see study.json and project.hygro there). "
                                      "Give another folder.");
    require_not_the_users(study, folder);
    if (!has_parts) require_parts_of(folder / "results.csv");
    KeptRows kept(frame.rows(), frame.metrics().size());
    if (!same) return kept;
    kept.read_parts(folder, mark_of(study.project_text, study.study_text));
    const std::size_t ended = frame.rows() - kept.count(KeptRows::State::missing);
    if (ended > 0 && !options.resume)
        throw Error(fmt::format("{}: The folder has {} of the study's {} rows. Go on with --resume, or give another folder.",
                                folder.string(), ended, frame.rows()));
    return kept;
}

void write_study_folder(const StudyFolder& study, const std::filesystem::path& folder)
{
    std::error_code failure;
    std::filesystem::create_directories(folder / "parts", failure);
    if (failure) throw FileError(fmt::format("{}: The folder cannot be created: {}.", folder.string(), failure.message()));
    for (const auto& [name, text] : {std::pair{"project.hygro", &study.project_text}, std::pair{"study.json", &study.study_text}})
        if (!is_there(folder / name) || read_file(folder / name, largest_project_bytes) != *text) write_file(folder / name, *text);
}

StudyTable collect_rows(const StudyFolder& study, const std::filesystem::path& folder)
{
    const StudyFrame frame(study.study, study.design);
    KeptRows kept(frame.rows(), frame.metrics().size());
    kept.read_parts(folder, mark_of(study.project_text, study.study_text));
    return TableMaker(study, kept).make();
}

MergeResult merge_study(const std::filesystem::path& folder)
{
    const StudyFolder study = read_study_folder(folder);
    const StudyFrame frame(study.study, study.design);
    KeptRows kept(frame.rows(), frame.metrics().size());
    kept.read_parts(folder, mark_of(study.project_text, study.study_text));
    const StudyTable table = TableMaker(study, kept).make();
    if (table.rows() == 0) require_parts_of(folder / "results.csv");
    write_file(folder / "results.csv", format_results(table));
    write_results_database(table, study.project_text, study.study_text, folder / "study.sqlite");
    return {frame.rows(), table.rows(), kept.count(KeptRows::State::failed), missing_points(frame, kept)};
}

} // namespace hygroloom
