// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A button with a picture and no words.
#pragma once

#include "ui/basics/appearance.h"

#include <QToolButton>

namespace hygroloom {

/// name: its tool tip, and what a screen reader says.
inline QToolButton* iconButton(const QString& icon, const QString& name)
{
    auto* button = new QToolButton;
    button->setIcon(themedIcon(icon));
    button->setAutoRaise(true);
    button->setToolTip(name);
    button->setAccessibleName(name);
    return button;
}

} // namespace hygroloom
