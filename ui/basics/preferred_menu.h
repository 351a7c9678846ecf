// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A menu of choices of which the preferred one is ticked.
#pragma once

#include "ui/basics/preferences.h"

#include <QStringList>

class QMenu;

namespace hygroloom {

/// Choosing one changes the preference; the menu follows it, wherever it is changed.
void addPreferred(QMenu& menu, int Preferences::*choice, const QStringList& names);

/// In the order of their enums.
QStringList navigationNames();
QStringList waterColorNames();

} // namespace hygroloom
