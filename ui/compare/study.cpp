// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/study.h"

#include "core/design/unknowns.h"
#include "core/wear/worn_candidate.h"

#include <algorithm>
#include <utility>

namespace hygroloom {

namespace {

/// The last that is complete and of the design as it is.
const KeptRun* runOf(const Design& design, const std::vector<KeptRun>& runs, const std::string& fabric, const StudyChoice& choice)
{
    const auto counts = [&](const KeptRun& run) {
        return run.problem.isEmpty() && run.complete() && run.cloth() == fabric && run.run->experiment == choice.experiment &&
               run.run->plan.fidelity == choice.fidelity && holdsFor(*run.run, design);
    };
    const auto found = std::find_if(runs.rbegin(), runs.rend(), counts);
    return found == runs.rend() ? nullptr : &*found;
}

/// The replicates that there are take the place of the candidate's run.
void takeReplicates(StudyRow& row, const Design& design, const std::vector<ReplicateSet>& sets, const StudyJob& job)
{
    const ReplicateSet* set = find_set(sets, keyOf(design, job));
    std::vector<std::optional<ReplicateRun>> replicates(static_cast<std::size_t>(job.of));
    for (int number = 0; number < job.of; ++number) {
        auto& replicate = replicates[static_cast<std::size_t>(number)];
        if (number == 0) { // the cloth as given
            if (row.candidate) { replicate = row.candidate->replicates.front(); }
            continue; // where it is missing, so is the run of the project
        }
        if (const auto found = set ? set->runs.find(number) : std::map<int, ReplicateRun>::const_iterator{};
            set && found != set->runs.end()) {
            replicate = found->second;
            continue;
        }
        row.missing.push_back(job);
        row.missing.back().recorded = false;
        row.missing.back().number = number;
    }
    row.runs = static_cast<int>(std::count_if(replicates.begin(), replicates.end(), [](const auto& run) { return run.has_value(); }));
    if (!row.candidate) { return; }
    if (row.candidate->worn) { add_error_of_cells(*row.candidate); }
    if (set) { row.candidate->unknowns = set->unknowns; }
    if (replicates.front()) { replicates.front()->places.assign(row.candidate->unknowns.size(), 0.5); }
    row.candidate->replicates = std::move(replicates);
}

} // namespace

ReplicateKey keyOf(const Design& design, const StudyJob& job)
{
    Design part = find_wear(design, job.experiment) ? anywhere(part_of_run(cut_from(design, job.experiment, job.fabric), job.experiment))
                                                    : part_of_run(design, job.fabric, job.experiment);
    return {std::move(part), job.fabric, job.experiment, job.fidelity, 1, job.of};
}

std::optional<Candidate> candidateOf(const KeptRun& run)
{
    if (run.worn) { return run.numbers ? std::optional(*run.numbers) : std::nullopt; }
    return run.metrics ? std::optional(candidate_of(run.run, run.metrics)) : std::nullopt;
}

std::vector<StudyRow> studyRows(const Design& design, const std::vector<KeptRun>& runs, const std::vector<ReplicateSet>& sets,
                                const StudyChoice& choice)
{
    std::vector<StudyRow> rows;
    for (const Fabric& fabric : design.fabrics) {
        StudyRow row;
        row.fabric = fabric.name;
        const StudyJob job{fabric.name, choice.experiment, choice.fidelity, true, 0, 1};
        if (const KeptRun* run = runOf(design, runs, fabric.name, choice)) {
            row.path = run->path;
            row.reading = !run->measured();
            row.wall = run->run->wall;
            row.runs = 1;
            row.candidate = candidateOf(*run);
        } else {
            row.missing.push_back(job);
        }
        if (const ReplicateSet* set = sets.empty() ? nullptr : find_set(sets, keyOf(design, job))) {
            row.kept = static_cast<int>(set->runs.size()) + (set->runs.contains(0) ? 0 : 1); // number 0 may be the row's own run
        }
        if (choice.replicates > 1) {
            StudyJob several = job;
            several.of = choice.replicates;
            takeReplicates(row, design, sets, several);
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

int keptReplicates(const Design& design, std::vector<KeptRun> runs, const std::vector<ReplicateSet>& sets, StudyChoice choice,
                   const std::vector<int>& counts)
{
    int most = 1;
    if (sets.empty() || design.fabrics.empty()) { return most; }
    for (KeptRun& run : runs) { run.metrics = nullptr, run.numbers = nullptr; } // nothing is to be computed from them
    for (const int count : counts) {
        choice.replicates = count;
        const std::vector<StudyRow> rows = count > most ? studyRows(design, runs, sets, choice) : std::vector<StudyRow>();
        const bool whole = std::all_of(rows.begin(), rows.end(), [](const StudyRow& row) { return row.missing.empty(); });
        if (!rows.empty() && whole) { most = count; }
    }
    return most;
}

Comparison comparisonOf(const std::vector<OutcomeInfo>& criteria, const StudyChoice& choice, const std::vector<StudyRow>& rows,
                        const std::string& baseline)
{
    Comparison made;
    made.experiment = choice.experiment;
    made.replicates = choice.replicates;
    made.criteria = criteria;
    if (made.criteria.empty()) { return made; }
    made.ranked_by = made.criteria.front();
    made.complete = true;
    for (const StudyRow& row : rows) {
        made.complete = made.complete && row.candidate && row.missing.empty();
        if (!row.candidate) { continue; }
        made.of_garments = row.candidate->worn != nullptr;
        made.candidates.push_back(*row.candidate);
        made.candidates.back().fabric = row.fabric;
        if (made.baseline.empty() || row.fabric == baseline) { made.baseline = row.fabric; }
    }
    return made;
}

} // namespace hygroloom
