// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/student.h"

#include "core/base/units.h"

#include <cmath>

namespace hygroloom {

double student_factor(const Level& level, int degrees_of_freedom)
{
    const double v = degrees_of_freedom, z = level.normal, z2 = z * z;
    if (degrees_of_freedom == 1) return std::tan(0.5 * pi * level.held);
    if (degrees_of_freedom == 2) return level.held * std::sqrt(2 / (1 - level.held * level.held));
    const double first = (z2 + 1) / 4, second = ((5 * z2 + 16) * z2 + 3) / 96, third = (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
    const double fourth = ((((79 * z2 + 776) * z2 + 1482) * z2 - 1920) * z2 - 945) / 92160;
    return z * (1 + (first + (second + (third + fourth / v) / v) / v) / v);
}

} // namespace hygroloom
