// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a drag and the wheel do in pictures of cloth and of garments, as the user prefers.
#pragma once

#include <QPointF>
#include <QSizeF>
#include <Qt>

namespace hygroloom {

enum class PointerDrag { none, orbit, pan };
PointerDrag dragOf(Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers);

/// The point that stays where it is while the wheel zooms.
QPointF zoomedAt(const QPointF& pointer, const QSizeF& picture);

} // namespace hygroloom
