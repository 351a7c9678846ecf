// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The workspace in which runs stand side by side.
#pragma once

#include "ui/compare/study_runs.h"
#include "ui/results/project_runs.h"
#include "ui/results/run_history.h"

class QWidget;

namespace hygroloom {

class CompareView;

class CompareWorkspace {
public:
    CompareWorkspace(Document& document, Recovery& recovery, WindowQueue& queue);

    RunHistory& runs() { return runs_; }
    ProjectRuns& project() { return project_; }
    StudyRuns& study() { return study_; }
    CompareView& view() { return *view_; }
    /// Asks before runs of the table are stopped. True when they may be, or there are none.
    bool agreesToStopRuns(QWidget* window) const;
    /// Stops them. What is done is kept.
    void stopRuns();

private:
    RunHistory runs_;
    ProjectRuns project_;
    StudyRuns study_;
    CompareView* view_;
};

} // namespace hygroloom
