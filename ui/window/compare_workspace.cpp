// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/compare_workspace.h"

#include "ui/basics/ask.h"
#include "ui/compare/compare_view.h"

#include <QEventLoop>

namespace hygroloom {

CompareWorkspace::CompareWorkspace(Document& document, Recovery& recovery, WindowQueue& queue)
    : project_(document, recovery, runs_), study_(document, project_, runs_, queue), view_(new CompareView(document, runs_, study_))
{
    QObject::connect(view_, &CompareView::markRequested, &project_, &ProjectRuns::setMarked);
    QObject::connect(view_, &CompareView::forgetRequested, &project_, &ProjectRuns::forget);
}

bool CompareWorkspace::agreesToStopRuns(QWidget* window) const
{
    return !study_.running() ||
           confirm(window, CompareView::tr("Runs are in progress"), CompareView::tr("Stop the runs of Compare?"),
                   CompareView::tr("%1. Those are kept with the project.").arg(study_.progressText()), CompareView::tr("Stop the Runs"));
}

/// Until they have ended, 0.2 s or so, the window is drawn, but takes no input.
void CompareWorkspace::stopRuns()
{
    if (!study_.running()) { return; } // they may have ended while questions were open
    QEventLoop end;
    QObject::connect(&study_, &StudyRuns::ended, &end, &QEventLoop::quit);
    study_.cancel();
    if (study_.running()) { end.exec(QEventLoop::ExcludeUserInputEvents); }
}

} // namespace hygroloom
