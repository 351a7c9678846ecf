// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The workspace in which runs stand side by side.
#pragma once

#include "ui/results/project_runs.h"
#include "ui/results/run_history.h"

namespace hygroloom {

class CompareView;

class CompareWorkspace {
public:
    CompareWorkspace(Document& document, Recovery& recovery);

    RunHistory& runs() { return runs_; }
    ProjectRuns& project() { return project_; }
    CompareView& view() { return *view_; }

private:
    RunHistory runs_;
    ProjectRuns project_;
    CompareView* view_;
};

} // namespace hygroloom
