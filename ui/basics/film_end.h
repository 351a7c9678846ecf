// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The end of a film before what shows it goes: the user sees that it is being written, and may leave without it.
#pragma once

class QWidget;

namespace hygroloom {

class Film;

/// Ends the film and returns once it is written, or once the user left without it. Nothing is shown where nothing is waited for.
void endInDialog(Film& film, QWidget* parent);

} // namespace hygroloom
