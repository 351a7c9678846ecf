// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A plain three-vector for code that also runs on a GPU; host-only code may use Eigen.
#pragma once

#include "core/base/portable.h"

#include <cmath>

namespace hygroloom {

template <typename T> struct Vec3T {
    T x{}, y{}, z{};

    HL_FN Vec3T& operator+=(const Vec3T& o)
    {
        x += o.x;
        y += o.y;
        z += o.z;
        return *this;
    }
    HL_FN Vec3T& operator-=(const Vec3T& o)
    {
        x -= o.x;
        y -= o.y;
        z -= o.z;
        return *this;
    }
};

template <typename T> HL_FN Vec3T<T> operator+(const Vec3T<T>& a, const Vec3T<T>& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
template <typename T> HL_FN Vec3T<T> operator-(const Vec3T<T>& a, const Vec3T<T>& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
template <typename T> HL_FN Vec3T<T> operator-(const Vec3T<T>& a) { return {-a.x, -a.y, -a.z}; }
template <typename T> HL_FN Vec3T<T> operator*(T s, const Vec3T<T>& a) { return {s * a.x, s * a.y, s * a.z}; }
template <typename T> HL_FN T dot(const Vec3T<T>& a, const Vec3T<T>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <typename T> HL_FN Vec3T<T> cross(const Vec3T<T>& a, const Vec3T<T>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <typename T> HL_FN T length(const Vec3T<T>& a) { return std::sqrt(dot(a, a)); }

using Vec3 = Vec3T<Real>;
using Vec3d = Vec3T<double>;

} // namespace hygroloom
