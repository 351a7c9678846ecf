// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The value that is being typed into a field.
#pragma once

class QWidget;

namespace hygroloom {

/// Commits the value that is being edited in a window, or in a floating panel of it, as leaving the field would. Shortcuts and tool
/// buttons leave the focus where it is; what they do must use the value that is on screen.
void commitTypedValue(QWidget& window);

} // namespace hygroloom
