// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/compare_workspace.h"

#include "ui/results/compare_view.h"

namespace hygroloom {

CompareWorkspace::CompareWorkspace(Document& document, Recovery& recovery)
    : project_(document, recovery, runs_), view_(new CompareView(runs_))
{
    QObject::connect(view_, &CompareView::markRequested, &project_, &ProjectRuns::setMarked);
    QObject::connect(view_, &CompareView::forgetRequested, &project_, &ProjectRuns::forget);
}

} // namespace hygroloom
