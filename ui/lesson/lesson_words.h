// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a class reads of a cloth, in words.
#pragma once

#include "core/lesson/running_cloth.h"
#include "core/lesson/water_shares.h"

#include <QStringList>

namespace hygroloom {

/// "Of 3 drops: 1.9 in the yarns, 0.6 in the fibres, 0.4 in the air, 0.1 still standing."
QString waterInWords(const WaterShares& shares);
/// Wet area, radius and time to absorb, a line each.
QStringList scoreLines(const ClothScore& score);
/// What else is to say of a cloth: why a drop was refused, drops that would slide; empty: nothing.
QString noticeOf(const ClothView& view);

} // namespace hygroloom
