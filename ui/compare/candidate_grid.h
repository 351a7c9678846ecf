// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the table of candidates says: numbers with intervals, verdicts in words, ranks with ties, and what was not run.
#pragma once

#include "ui/compare/study.h"

#include <QStringList>

namespace hygroloom {

/// A candidate on one experiment, and what of it is missing.
struct GridEntry {
    std::string name; ///< as in the comparison
    QString path;     ///< of its run; empty: there is none
    bool reading = false;
    int runs = 0;
    std::vector<StudyJob> missing = {};
};

struct GridColumn {
    OutcomeInfo info;
    QString head; ///< "Wetted radius, top (mm)"
    QString tip;
    double low = 0, high = 0; ///< of all intervals in it, in the shown unit; equal: there is nothing to draw
};

struct GridCell {
    enum class State { number, no_number, reading, missing };
    State state = State::no_number;
    QString number;   ///< "23.1 ± 0.4 mm"
    QString measured; ///< "measured 7.2 ± 0.1 mm"; empty: it was not
    QString verdict;  ///< "better", "baseline", "1 of 8 runs", of what is missing "running", "waiting"; empty: there is nothing to say
    QString tip;
    double low = 0, value = 0, high = 0; ///< in the shown unit
    QString path;                        ///< of the run behind it
    std::vector<StudyJob> missing;
    bool failed = false;   ///< the last run of what is missing; the tip says why
    bool outdated = false; ///< what is missing was run, on an older design
};

struct GridRow {
    std::string name;
    QString rank; ///< "1", "2="; empty: none
    int place = 0;
    bool baseline = false;
    bool candidate = true; ///< a fabric of the project
    QString note{};        ///< of another run, how it differs
    QString path;          ///< of its run, where the rows are of one experiment
    std::vector<GridCell> cells;
};

struct Grid {
    std::vector<GridColumn> columns;
    std::vector<GridRow> rows;
};

QString verdictText(Verdict verdict);

/// One experiment: a column for each of its numbers. The comparison is judged.
Grid gridOf(const Comparison& comparison, const std::vector<GridEntry>& entries);

struct ExperimentPart {
    Comparison comparison; ///< judged
    std::vector<GridEntry> entries;
};
/// All experiments, of each the number that ranks. Each has the same entries, by name.
Grid overviewOf(const std::vector<ExperimentPart>& parts);

/// Orders the rows by a column; -1: by rank. Rows without a number stand last either way.
void sortRows(Grid& grid, int column, bool ascending);
/// Leaves the rows whose name has the text, whatever its case.
void filterRows(Grid& grid, const QString& text);

} // namespace hygroloom
