// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/compare_workspace.h"

#include "ui/results/compare_view.h"
#include "ui/results/plan_dialog.h"
#include "ui/window/confirm.h"

#include <algorithm>

namespace hygroloom {

CompareWorkspace::CompareWorkspace(QWidget& window) : window_(window), view_(new CompareView(runs_)) {}

bool CompareWorkspace::mayDropRuns() const
{
    constexpr double long_run = 30; // s
    double longest = 0;
    for (const KeptRun& run : runs_.unsaved()) { longest = std::max({longest, run.elapsed, run.run->wall}); }
    return longest < long_run ||
           confirm(&window_, CompareView::tr("Runs are not saved"), CompareView::tr("Close without saving the recordings?"),
                   CompareView::tr("The longest unsaved run took %1. File ▸ Save Recording As saves the run that is shown; Compare lists "
                                   "all runs.")
                       .arg(roughDuration(longest)),
                   CompareView::tr("Close Without Saving"));
}

} // namespace hygroloom
