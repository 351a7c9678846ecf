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
    StudyRuns runs{document, project, history};
    CompareView view{document, history, runs};
};

/// Of a fabric in the table; -1: it is not in it.
inline int rowOf(CompareView& view, const std::string& name)
{
    const auto& rows = view.table()->grid().rows;
    const auto found = std::find_if(rows.begin(), rows.end(), [&name](const GridRow& row) { return row.name == name; });
    return found == rows.end() ? -1 : static_cast<int>(found - rows.begin());
}

} // namespace hygroloom
