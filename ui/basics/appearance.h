// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How the program looks: light and dark palettes, icons that take the palette's colour, colours with a meaning.
#pragma once

#include "core/design/validate.h"

#include <QIcon>
#include <QPalette>

namespace hygroloom {

enum class Appearance { desktop, light, dark, contrast };

/// Makes icons, shaders and the built-in example available; a static library does not do so by itself.
void useResources();

/// Sets the application's style and palette. desktop reads the desktop portal, and is light where there is none.
void applyAppearance(Appearance appearance);
Appearance savedAppearance();
void saveAppearance(Appearance appearance);

bool isDark(const QPalette& palette);

/// An icon of resources/icons, drawn in the palette's text colour at the time of painting.
QIcon themedIcon(const QString& name);

QColor severityColor(Severity severity, const QPalette& palette);
QIcon severityIcon(Severity severity);
/// "Error", "Warning", "Note".
QString severityName(Severity severity);

/// What weaves are drawn with. Paper is pale and ink is dark in every look, as weavers read them: a dark square is a warp end that lies up.
struct PaperColors {
    QColor paper, ink, accent;
};
PaperColors paperColors(const QPalette& palette);

/// Text that is less important than the rest, readable on window and base.
QColor quietText(const QPalette& palette);

} // namespace hygroloom
