// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a run asks before it begins and after it was stopped.
#pragma once

#include <QString>

class QWidget;

namespace hygroloom {

/// Whether to run what takes more memory than is free. sentence: how much it takes and how much is free.
bool wantsBeyondMemory(QWidget* parent, const QString& sentence);

/// For the status bar, of a run that takes most of what is free.
QString memoryWarning();

/// Whether to keep what a run recorded that was stopped.
bool wantsStoppedRun(QWidget* parent, const QString& recording);

} // namespace hygroloom
