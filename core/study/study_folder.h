// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The folder of a study: what it is, which rows have ended, and the tables that are made of them.
#pragma once

#include "core/study/journal.h"
#include "core/study/points.h"
#include "core/study/results.h"

namespace hygroloom {

/// What a folder holds.
struct StudyFolder {
    Design design;
    Study study;
    std::string project_text, study_text;
};
/// Throws FileError.
StudyFolder read_study_folder(const std::filesystem::path& folder);

/// The rows that have ended, sorted. Throws FileError.
StudyTable collect_rows(const StudyFolder& study, const std::filesystem::path& folder);

struct MergeResult {
    std::size_t rows = 0;  ///< that there should be
    std::size_t ended = 0; ///< that there are, well or not
    std::size_t failed = 0;
    std::string missing; ///< the first points that lack rows, in words; empty: all are there
};
/// Writes results.csv and study.sqlite from the parts, atomically. Throws FileError.
MergeResult merge_study(const std::filesystem::path& folder);

// For study_run.cpp and slurm.cpp.

/// Which run each row of a study is: replicate by replicate, then experiments, fabrics and points.
class StudyFrame {
public:
    /// Precondition: validate() found no error. Throws Error when there are too many rows.
    StudyFrame(const Study& study, const Design& design);
    std::size_t rows() const { return rows_; }
    StudyRun row(std::size_t number) const;
    const std::vector<std::string>& fabrics() const { return fabrics_; }
    const std::vector<std::string>& experiments() const { return experiments_; }
    const std::vector<std::string>& metrics() const { return metrics_; }

private:
    std::vector<std::string> fabrics_, experiments_, metrics_;
    std::size_t replicates_, rows_;
};

StudyFolder folder_of(const Design& design, const Study& study);
/// Tells the parts of this study and project from those of others.
std::string mark_of(const std::string& project_text, const std::string& study_text);

/// What the folder has of the study. Throws Error where that does not go with the options: see run_study().
KeptRows prepared_rows(const StudyFolder& study, const std::filesystem::path& folder, const StudyOptions& options);
/// Makes the folder, and writes what it does not have yet. Throws FileError.
void write_study_folder(const StudyFolder& study, const std::filesystem::path& folder);

} // namespace hygroloom
