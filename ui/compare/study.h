// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// All fabrics of a project on an experiment, as samples or as the garment that is worn in it: which runs there are, which are missing, and
// what the numbers so far give.
#pragma once

#include "core/analysis/replicate_file.h"
#include "core/analysis/why.h"
#include "ui/results/run_history.h"

namespace hygroloom {

/// How an experiment is run on the fabrics.
struct StudyChoice {
    std::string experiment;
    Fidelity fidelity = Fidelity::draft;
    int replicates = 1;
};

/// A run that is missing.
struct StudyJob {
    std::string fabric, experiment;
    Fidelity fidelity = Fidelity::draft;
    bool recorded = true; ///< an ordinary run of the project; of the others only the numbers are kept
    int number = 0;       ///< of the replicate
    int of = 1;
    std::string against{}; ///< of a mixture, see why.h: whose parts are in the fabric
    Mixture mixture = 0;   ///< 0: the fabric as it is
    bool operator==(const StudyJob&) const = default;
};

/// A fabric on the experiment.
struct StudyRow {
    std::string fabric;                 ///< of a garment, that all its panels are cut from
    QString path;                       ///< of its run; empty: there is none
    bool reading = false;               ///< its frames are still being read
    double wall = 0;                    ///< s, of its run; 0: there is none
    std::optional<Candidate> candidate; ///< none: no number is known
    int runs = 0;                       ///< of the replicates
    int kept = 0;                       ///< replicates that there are, however many are chosen
    std::vector<StudyJob> missing;
};

/// What a run gave, as the first replicate; none: its frames have not been read.
std::optional<Candidate> candidateOf(const KeptRun& run);

/// One row for each fabric. Of several runs the last counts; those of an older design do not. With one replicate a row has the run of the
/// project; with more it has those that were drawn, see drawn(), the first of which is the run of the project where nothing about the cloth
/// differs. Precondition: the design has the experiment, and validate() found no error.
std::vector<StudyRow> studyRows(const Design& design, const std::vector<KeptRun>& runs, const std::vector<ReplicateSet>& sets,
                                const StudyChoice& choice);

/// Of these numbers of replicates the largest of which no fabric lacks a run; 1 where all lack some. Precondition: as of studyRows().
int keptReplicates(const Design& design, std::vector<KeptRun> runs, const std::vector<ReplicateSet>& sets, StudyChoice choice,
                   const std::vector<int>& counts);

/// What the replicates of a fabric are found by.
ReplicateKey keyOf(const Design& design, const StudyJob& job);

/// The rows' candidates, not yet judged. The baseline is the first where there is none of that name.
Comparison comparisonOf(const std::vector<OutcomeInfo>& criteria, const StudyChoice& choice, const std::vector<StudyRow>& rows,
                        const std::string& baseline);

} // namespace hygroloom
