// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Explain: a section through the yarn under the pointer, drawn from its numbers: pores filling, fibres swelling, vapour leaving.
#pragma once

#include "core/lesson/running_cloth.h"

#include <QPointF>
#include <QStringList>

class QPainter;

namespace hygroloom {

/// The upper yarn at a place of a cloth.
struct YarnLook {
    double saturation = 0;  ///< of its pores, 0 .. 1
    double regain = 0;      ///< bound water over dry fibre
    double temperature = 0; ///< C
    double leaving = 0;     ///< g/(m2 h) of vapour to the air; less than 0: it comes
    double packing = 0.5;   ///< share of fibres in the yarn
    double flatness = 1;    ///< width over height
    double growth = 1;      ///< radius of a fibre over that when dry
};

/// x, y: m from the cloth's middle. Precondition: within the cloth.
YarnLook yarnAt(const ClothView& view, double x, double y);

constexpr double magnifier_radius = 116; ///< logical pixels

void drawMagnifier(QPainter& painter, const QPointF& middle, const YarnLook& yarn, const QFont& font);
/// Its numbers, a line each, as they stand beside the picture.
QStringList magnifierLines(const YarnLook& yarn);

} // namespace hygroloom
