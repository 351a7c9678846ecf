// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One line of a menu.
#pragma once

#include "ui/basics/appearance.h"

#include <QAction>
#include <QMenu>

namespace hygroloom {

/// icon: its name in resources/icons, or empty. tip: a sentence for the status bar.
inline QAction* addCommand(QMenu* menu, const QString& icon, const QString& text, const QKeySequence& shortcut, const QString& tip)
{
    auto* action = icon.isEmpty() ? menu->addAction(text) : menu->addAction(themedIcon(icon), text);
    action->setShortcut(shortcut);
    action->setStatusTip(tip);
    return action;
}

/// Whether a command can be chosen now; why_not: the sentence that says why it cannot, else empty. tip: as of addCommand().
inline void offerCommand(QAction* action, bool can, const QString& tip, const QString& why_not)
{
    const QString why = can ? QString() : why_not;
    action->setEnabled(can);
    action->setStatusTip(why.isEmpty() ? tip : why);
    action->setToolTip(why.isEmpty() ? QString() : "<p>" + why.toHtmlEscaped() + "</p>"); // else its text, and in menus none
}

} // namespace hygroloom
