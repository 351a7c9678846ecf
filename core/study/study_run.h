// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs a study in a folder: project.hygro and study.json say what it is, parts/ keeps each row as soon as it has ended, results.csv and
// study.h5 are made from the parts. What a row holds depends neither on its order nor on who ran it.
#pragma once

#include "core/run/run_options.h"
#include "core/solver/backend.h"
#include "core/study/points.h"
#include "core/study/results.h"

#include <functional>
#include <memory>

namespace hygroloom {

/// One run of a study.
struct StudyRow {
    std::size_t point = 0;
    int replicate = 0;
    std::size_t fabric = 0, experiment = 0; ///< places in fabrics_of() and experiments_of()
};

struct StudyOptions {
    bool resume = false;       ///< goes on in a folder that has rows; without it such a folder is refused
    bool retry_failed = false; ///< with resume: also runs the rows that failed
    int threads = 1;           ///< of each run on a CPU
    int task = 1, tasks = 1;   ///< the slice of the rows: task 1 of 1 has all
};

struct StudyProgress {
    std::size_t rows = 0;   ///< of the slice
    std::size_t kept = 0;   ///< that were there at the beginning
    std::size_t ended = 0;  ///< with those kept
    std::size_t failed = 0; ///< of those ended
    double share = 0;       ///< of what was to be run, with what is under way
    double wall = 0;        ///< s
};

/// A row that has ended.
struct StudyRowResult {
    std::size_t row = 0; ///< its place in the table
    bool failed = false;
    std::string reason;
    std::vector<double> metrics; ///< NaN where there is none
    double wall = 0;             ///< s
    std::string device;
};

/// From any thread, but never two at a time.
struct StudyCallbacks {
    std::function<void(const StudyRowResult&)> ended;
    std::function<void(const StudyProgress&)> progress; ///< several times a second
    std::function<void(const std::string&)> note;       ///< a sentence, as of a device that failed
};

struct StudyOutcome {
    StudyProgress progress;
    bool cancelled = false;
    std::vector<std::pair<std::size_t, std::string>> failures; ///< row and reason, of the slice; the first 1000
};

/// How many runs a slice still has to do in the folder, and the memory (bytes) that each takes; to make backends by. Throws what
/// run_study() throws.
struct StudyNeeds {
    std::size_t rows = 0;
    std::size_t bytes_each = 0;
};
StudyNeeds study_needs(const Design& design, const Study& study, const std::filesystem::path& folder, const StudyOptions& options);

/// Runs what the slice lacks, each run on one of the backends. Throws Error and FileError before the first run: the folder has another
/// study or has rows and resume is not set, somebody else runs the slice. A run that fails is a row that failed.
StudyOutcome run_study(const Design& design, const Study& study, const std::filesystem::path& folder, const StudyOptions& options,
                       const std::vector<std::unique_ptr<Backend>>& backends, RunControl& control, const StudyCallbacks& callbacks);

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
/// Writes results.csv and study.h5 from the parts, atomically. Throws FileError.
MergeResult merge_study(const std::filesystem::path& folder);

} // namespace hygroloom
