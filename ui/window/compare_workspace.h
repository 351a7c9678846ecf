// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The workspace in which runs stand side by side.
#pragma once

#include "ui/results/run_history.h"

class QWidget;

namespace hygroloom {

class CompareView;

class CompareWorkspace {
public:
    /// window: parent of its questions.
    explicit CompareWorkspace(QWidget& window);

    RunHistory& runs() { return runs_; }
    CompareView& view() { return *view_; }
    /// Asks before long runs that are not saved are lost with the window.
    bool mayDropRuns() const;

private:
    QWidget& window_;
    RunHistory runs_;
    CompareView* view_;
};

} // namespace hygroloom
