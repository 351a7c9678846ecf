// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Texts of functions that belong to no class.
#pragma once

#include <QCoreApplication>
#include <QString>

namespace hygroloom {

/// In the window's language. Classes with texts have a tr of their own.
inline QString tr(const char* text) { return QCoreApplication::translate("hygroloom", text); }

/// With a capital at its start.
inline QString capital(const QString& text) { return text.left(1).toUpper() + text.mid(1); }

} // namespace hygroloom
