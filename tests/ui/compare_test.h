// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The Compare workspace without its window, for the tests of it.
#pragma once

#include "ui/compare/candidate_table.h"
#include "ui/compare/compare_bar.h"
#include "ui/compare/compare_view.h"
#include "ui/document/document.h"
#include "ui/document/recovery.h"
#include "ui/results/project_runs.h"

#include <algorithm>

namespace hygroloom {

/// With an empty project, until another is opened.
struct Workplace {
    Document document;
    Recovery recovery{document};
    RunHistory history;
    ProjectRuns project{document, recovery, history};
    WindowQueue queue;
    StudyRuns runs{document, project, history, queue};
    CompareView view{document, history, runs};
};

inline constexpr const char* radius_key = "equal_area_radius_mm";

/// As if it had been run, with this wetted radius in mm.
inline KeptRun runOf(const Design& design, std::size_t fabric, Fidelity fidelity, double radius_mm)
{
    auto run = std::make_shared<RunRecord>();
    run->design = design;
    run->fabric = design.fabrics[fabric].name;
    run->experiment = design.experiments[0].name;
    run->plan.fidelity = fidelity;
    run->plan.expected_errors[radius_key] = 0.02;
    run->wall = 1;
    auto metrics = std::make_shared<Metrics>();
    metrics->equal_area_radius_top = 1e-3 * radius_mm;
    return {QString("%1 %2").arg(fabric).arg(radius_mm), run, metrics};
}

inline ReplicateSet setOf(const Design& design, int of)
{
    const StudyJob job{design.fabrics[0].name, design.experiments[0].name, Fidelity::draft, false, 0, of};
    ReplicateSet set{keyOf(design, job), {"contact angle on cotton"}, {}};
    for (int number = 0; number < of; ++number) { set.runs[number] = {{{radius_key, 3.0 + number}}, {number == 0 ? 0.5 : 0.25}, {}}; }
    set.runs[1].edge_time = 0.75;
    return set;
}

/// Of a fabric in the table; -1: it is not in it.
inline int rowOf(CompareView& view, const std::string& name)
{
    const auto& rows = view.table()->grid().rows;
    const auto found = std::find_if(rows.begin(), rows.end(), [&name](const GridRow& row) { return row.name == name; });
    return found == rows.end() ? -1 : static_cast<int>(found - rows.begin());
}

} // namespace hygroloom
