// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs a study in a folder: project.hygro and study.json say what it is, parts/ keeps each row as soon as it has ended, results.csv and
// study.sqlite are made from the parts. What a row holds depends neither on its order nor on who ran it.
#pragma once

#include "core/queue/run_queue.h"
#include "core/study/study_folder.h"

namespace hygroloom {

struct StudyProgress {
    std::size_t rows = 0;   ///< of the slice
    std::size_t kept = 0;   ///< that were there at the beginning
    std::size_t ended = 0;  ///< with those kept
    std::size_t failed = 0; ///< of those ended
    double share = 0;       ///< of what was to be run, with what is under way
    double wall = 0;        ///< s
};

/// From any thread, but never two at a time.
struct StudyCallbacks {
    std::function<void(const StudyRowResult&)> ended;
    std::function<void(const StudyProgress&)> progress; ///< several times a second
    std::function<void(const std::string&)> note;       ///< a sentence, as of a device that failed
    std::function<void(bool)> paused;                   ///< as of RunBatch
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

/// How many of a study's runs are on at once on a CPU, and the threads of each.
struct StudyShares {
    int jobs = 0; ///< 0: as many as pay on a GPU
    int threads = 1;
};
/// jobs, threads: as asked for; for 0 a run on each core, and the cores shared among them. No more runs than the memory holds.
StudyShares shares_on_cpu(int jobs, int threads, int cores, const StudyNeeds& needs);

/// Runs what the slice lacks in the queue. Throws Error and FileError before the first run: the folder has another study or has rows and
/// resume is not set, somebody else runs the slice. A run that fails is a row that failed.
StudyOutcome run_study(const Design& design, const Study& study, const std::filesystem::path& folder, const StudyOptions& options,
                       RunQueue& queue, const std::shared_ptr<RunPlaces>& places, const std::atomic<bool>& cancel,
                       const StudyCallbacks& callbacks);

} // namespace hygroloom
