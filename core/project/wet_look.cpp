// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/project/wet_look.h"

#include <cmath>

namespace hygroloom {

double diffuse_reflection(double index)
{
    constexpr int steps = 2000; // of the middle rule over the squared sine, in which diffuse light is even
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double sine2 = (i + 0.5) / steps, outside = std::sqrt(1 - sine2), inside = std::sqrt(1 - sine2 / (index * index));
        const double across = (outside - index * inside) / (outside + index * inside),
                     along = (index * outside - inside) / (index * outside + inside);
        sum += 0.5 * (across * across + along * along);
    }
    return sum / steps;
}

double inner_reflection(double index) { return 1 - (1 - diffuse_reflection(index)) / (index * index); }

double wet_reflectance(double dry)
{
    static const double back = inner_reflection(water_index);
    return film_entry * (1 - back) * dry / (1 - back * dry);
}

double roughness_at(double wet_share) { return dry_roughness + wet_share * (wet_roughness - dry_roughness); }
double reflectance_at(double dry, double wet_share) { return dry + wet_share * (wet_reflectance(dry) - dry); }

} // namespace hygroloom
