// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Panels of the window that can be moved, hidden and shown.
#pragma once

#include "ui/window/scrolled.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QStackedWidget>

namespace hygroloom {

/// name: under which the window saves its place. Precondition: unique in the window.
inline QDockWidget* makeDock(QMainWindow& window, const char* name, const QString& title, QWidget* content)
{
    auto* dock = new QDockWidget(title, &window);
    dock->setObjectName(name);
    dock->setAccessibleName(title);
    dock->setWidget(new Scrolled(content));
    return dock;
}

/// The other pages ask for no room: one that is not seen would push the panels together.
inline void showPage(QStackedWidget& pages, int shown)
{
    for (int page = 0; page < pages.count(); ++page) {
        const QSizePolicy::Policy policy = page == shown ? QSizePolicy::Preferred : QSizePolicy::Ignored;
        pages.widget(page)->setSizePolicy(policy, policy);
    }
    pages.setCurrentIndex(shown);
}

/// Shows it in front of those that share its place.
inline void reveal(QDockWidget* dock)
{
    dock->setVisible(true);
    dock->raise();
}

} // namespace hygroloom
