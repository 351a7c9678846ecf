// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Studies of many points for Python: run in a folder, and their table as columns.
#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/machine.h"

#include "core/study/study_run.h"
#include "core/wear/worn_candidate.h"
#include "gpu/backends.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>

namespace hygroloom::python {
namespace {

struct SweepArguments {
    std::string study, study_name, folder;
    std::string base; ///< folder of the project
    bool resume = false, retry_failed = false;
};

struct Swept {
    StudyTable table;
    std::vector<std::pair<std::size_t, std::string>> failures;
    std::vector<std::string> notes;
};

/// On a GPU as many as pay (0).
StudyShares shares_of(const RunArguments& arguments, const StudyNeeds& needs)
{
    return expected_backend(backend_for(arguments.backend, {})) == "cpu"
               ? shares_on_cpu(arguments.at_once, arguments.threads, usable_threads(), needs)
               : StudyShares{arguments.at_once, std::max(1, arguments.threads)};
}

Swept swept(Design design, const SweepArguments& asked, const RunArguments& arguments, Watch& watch)
{
    const Study study = parse_study(asked.study, asked.study_name);
    require_valid(design);
    std::vector<Issue> issues = validate(study, design);
    if (has_error(issues)) throw InvalidProject("study", std::move(issues));
    if (is_of_garments(study, design)) design = with_absolute_files(design, asked.base);
    StudyOptions options;
    options.resume = asked.resume;
    options.retry_failed = asked.retry_failed;
    options.memory = memory_rule(arguments);
    const StudyNeeds needs = study_needs(design, study, asked.folder, options);
    std::string shortage = ask_for_memory("One run of this study", static_cast<double>(needs.bytes_each), options.memory);
    const StudyShares shares = shares_of(arguments, needs);
    options.threads = shares.threads;
    const int runs = static_cast<int>(std::max<std::size_t>(1, needs.rows));
    const auto places = open_places(arguments, shares.jobs, runs, needs.bytes_each);
    RunQueue queue;
    Swept result;
    if (!shortage.empty()) result.notes.push_back(std::move(shortage));
    StudyCallbacks callbacks;
    callbacks.progress = [&](const StudyProgress& p) {
        watch.tell(p.share, fmt::format("{} of {} runs, {} failed", p.ended, p.rows, p.failed));
    };
    callbacks.note = [&](const std::string& note) { result.notes.push_back(note); };
    StudyOutcome outcome = run_study(design, study, asked.folder, options, queue, places, watch.control.cancel, callbacks);
    if (outcome.cancelled) throw Cancelled();
    merge_study(asked.folder);
    result.table = collect_rows(read_study_folder(asked.folder), asked.folder);
    result.failures = std::move(outcome.failures);
    return result;
}

py::list words_of(const std::vector<std::string>& words)
{
    py::list list;
    for (const std::string& word : words) list.append(text(word));
    return list;
}

/// Each column: name, its numbers or places, and the words that those are of; None for numbers.
py::list columns_of(StudyTable table)
{
    py::list columns;
    for (StudyColumn& column : table.columns) {
        if (column.is_number)
            columns.append(py::make_tuple(text(column.name), array_of(std::move(column.numbers)), py::none()));
        else
            columns.append(py::make_tuple(text(column.name), array_of(std::move(column.word_of)), words_of(column.words)));
    }
    return columns;
}

py::tuple sweep(const Design& design, const std::string& study, const std::string& study_name, const std::string& folder,
                const std::string& base, bool resume, bool retry_failed, const py::dict& how, const py::object& progress)
{
    const RunArguments arguments = run_arguments(how);
    const SweepArguments asked{study, study_name, folder, base, resume, retry_failed};
    Swept result = watched(progress, [=](Watch& watch) { return swept(design, asked, arguments, watch); });
    py::list failures;
    for (const auto& [row, reason] : result.failures) failures.append(py::make_tuple(row, text(reason)));
    return py::make_tuple(columns_of(std::move(result.table)), failures, words_of(result.notes));
}

} // namespace

void add_sweeps(py::module_& module) { module.def("sweep", &sweep); }

} // namespace hygroloom::python
