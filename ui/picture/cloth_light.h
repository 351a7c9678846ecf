// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How yarn reflects light, for C++: the shaders' own text, compiled with numbers and vectors that have the shaders' names.
#pragma once

#include "core/base/vec3.h"

#include <algorithm>
#include <cmath>

namespace hygroloom::cloth_light {

using real = double;
using vec3 = Vec3d;
using std::exp;
using std::max;
using std::pow;
using std::sqrt;

inline real clamp(real value, real low, real high) { return std::clamp(value, low, high); }
inline real mix(real a, real b, real share) { return a + (b - a) * share; }
inline vec3 normalize(const vec3& v) { return (1 / length(v)) * v; }
inline real smoothstep(real low, real high, real value)
{
    const real t = clamp((value - low) / (high - low), 0, 1);
    return t * t * (3 - 2 * t);
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
namespace {
#include "resources/shaders/cloth_light.glsl"
}
#pragma GCC diagnostic pop

} // namespace hygroloom::cloth_light
