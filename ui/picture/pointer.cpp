// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/pointer.h"

#include "ui/basics/preferences.h"

namespace hygroloom {

PointerDrag dragOf(Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers)
{
    const bool left = buttons & Qt::LeftButton, middle = buttons & Qt::MiddleButton, right = buttons & Qt::RightButton;
    const bool shift = modifiers & Qt::ShiftModifier;
    switch (static_cast<Navigation>(preferences().navigation)) {
    case Navigation::blender: return middle ? (shift ? PointerDrag::pan : PointerDrag::orbit) : PointerDrag::none;
    case Navigation::freecad:
        if (middle) { return left ? PointerDrag::orbit : PointerDrag::pan; }
        return right ? (shift                             ? PointerDrag::orbit
                        : modifiers & Qt::ControlModifier ? PointerDrag::pan
                                                          : PointerDrag::none)
                     : PointerDrag::none;
    case Navigation::clo: return middle ? PointerDrag::pan : right ? PointerDrag::orbit : PointerDrag::none;
    case Navigation::hygroloom: break;
    }
    return middle || right || (left && shift) ? PointerDrag::pan : left ? PointerDrag::orbit : PointerDrag::none;
}

QPointF zoomedAt(const QPointF& pointer, const QSizeF& picture)
{
    return preferences().zoom_to_pointer ? pointer : QPointF(0.5 * picture.width(), 0.5 * picture.height());
}

} // namespace hygroloom
