// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Under the table of candidates: what limits its numbers.
#include "core/design/unknowns.h"
#include "core/plan/fidelity.h"
#include "ui/basics/quantity.h"
#include "ui/compare/compare_bar.h"
#include "ui/compare/compare_view.h"
#include "ui/document/document.h"

#include <QLabel>

#include <algorithm>
#include <set>

namespace hygroloom {

/// Which fabrics have only runs of an older design or program; empty: none.
QString CompareView::outdatedText() const
{
    QStringList fabrics;
    for (const StudyRow& row : rows_) {
        if (entry()->own && row.path.isEmpty() && !row.missing.empty() && outdatedRun(row.fabric, entry()->name)) {
            fabrics << QString::fromStdString(row.fabric);
        }
    }
    return fabrics.isEmpty()
               ? QString()
               : tr("Outdated, as the design or the program has changed since they were run: %1. “Run All Missing” runs them again. The "
                    "older runs stand under All Runs.")
                     .arg(fabrics.join(", "));
}

namespace {

/// How uneven the yarns of a fabric are, warp and weft: "Poplin 14 % as is typical".
QString unevennessOf(const Design& design, const Fabric& fabric)
{
    QStringList all;
    for (const Yarn* yarn : {&fabric.warp, &fabric.weft}) {
        const bool given = yarn->irregularity_cv.has_value();
        const QString share = valueText(100 * (yarn->irregularity_cv.value_or(typical_unevenness(design, *yarn).cv)), "%");
        all << (given ? CompareView::tr("%1 as given").arg(share) : CompareView::tr("%1 as is typical").arg(share));
    }
    all.removeDuplicates();
    return QString::fromStdString(fabric.name) + ' ' + all.join(CompareView::tr(" and "));
}

/// The name of the first replicate's; empty: not known.
std::string fidelityOf(const Candidate& candidate)
{
    if (candidate.run) { return name_of(candidate.run->plan.fidelity); }
    return candidate.worn ? candidate.worn->how.substr(0, candidate.worn->how.find(',')) : std::string(); // the backend follows
}

bool differInFidelity(const std::vector<StudyRow>& rows)
{
    std::set<std::string> fidelities;
    for (const StudyRow& row : rows) {
        if (const std::string own = row.candidate ? fidelityOf(*row.candidate) : std::string(); !own.empty()) { fidelities.insert(own); }
    }
    return fidelities.size() > 1;
}

} // namespace

/// Under the table, what keeps its numbers from being compared.
void CompareView::refreshHint()
{
    QStringList notes;
    const Design& design = *document_.design();
    if (design.fabrics.empty() && rows_.empty()) { notes << tr("This project has no fabric. Add one with Fabric ▸ Add Fabric."); }
    if (design.experiments.empty() && design.wears.empty() && rows_.empty()) {
        notes << tr("This project has no experiment. Add one with Experiment ▸ Add Experiment.");
    }
    if (rows_.size() == 1) {
        notes << tr("A comparison needs a second fabric: add one with Fabric ▸ Add Fabric, or tick an older run under All Runs.");
    }
    int kept = 0;
    QStringList atEdge, uneven;
    for (const StudyRow& row : rows_) {
        kept = std::max(kept, row.kept);
        if (row.candidate && std::any_of(row.candidate->replicates.begin(), row.candidate->replicates.end(),
                                         [](const std::optional<ReplicateRun>& run) { return run && run->edge_time; })) {
            atEdge << QString::fromStdString(row.fabric);
        }
        if (!row.candidate || !row.candidate->run) { continue; }
        const RunRecord& run = *row.candidate->run;
        if (const Fabric* fabric = find_fabric(run.design, run.fabric)) { uneven << unevennessOf(run.design, *fabric); }
    }
    if (entry() && choiceOf(*entry()).replicates > 1) {
        notes << (entry()->worn()
                      ? tr("Maps are of the first replicate; curves are of all of them.")
                      : tr("Maps and 3D are of the first replicate; curves and difference maps are of all of them, whose yarns are uneven: "
                           "%1.")
                            .arg(uneven.join("; ")));
        if (const std::string few = few_replicates_text(choiceOf(*entry()).replicates); !few.empty()) {
            notes.prepend(QString::fromStdString(few));
        }
    }
    if (entry() && entry()->worn() && choiceOf(*entry()).replicates == 1 && kept <= 1 && rows_.size() > 1) {
        notes << tr("One run of each garment shows no scatter, so there is no verdict: choose 4 replicates or more to judge by them.");
    }
    if (entry() && choiceOf(*entry()).replicates == 1 && kept <= 1 && uneven.size() > 1) {
        notes << tr(
            "The verdicts rest on the numerical error of one run of each cloth. Other pieces of the same cloths may come in another "
            "order: choose 8 replicates to judge by them.");
    }
    if (!atEdge.isEmpty()) {
        notes.prepend(tr("Water reached the edge of the sample in: %1. A larger sample changes these numbers.").arg(atEdge.join(", ")));
    }
    if (kept > 1 && entry() && choiceOf(*entry()).replicates == 1) {
        notes << tr("%1 replicates of these runs are kept. Choose more than one under Replicates to judge by them.").arg(kept);
    }
    if (const QString outdated = entry() ? outdatedText() : QString(); !outdated.isEmpty()) { notes.prepend(outdated); }
    if (differInFidelity(rows_)) { notes << tr("These runs have different fidelities, which is part of their difference."); }
    note_->setText(notes.join(' '));
    note_->setVisible(!notes.isEmpty());
}

} // namespace hygroloom
