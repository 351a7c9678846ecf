// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Equations along a yarn's line, each of a place and its neighbours, for one number at each place or for two.
#pragma once

#include "core/base/portable.h"

#include <cmath>
#include <cstdint>

namespace hygroloom {

/// lower x[i - 1] + pivot x[i] + upper x[i + 1] = right. The first row of a line has no lower, the last no upper.
struct Equation {
    double lower, pivot, upper, right;
};

/// Two numbers of a place, and the matrix between them.
struct Pair {
    double first = 0, second = 0;
};
struct PairMatrix {
    double a = 0, b = 0, c = 0, d = 0; ///< rows (a b), (c d)

    HL_FN PairMatrix inverse() const
    {
        const double scale = plain_inverse(a * d - b * c);
        return {d * scale, -b * scale, -c * scale, a * scale};
    }
};
HL_FN PairMatrix operator*(const PairMatrix& m, const PairMatrix& n)
{
    return {m.a * n.a + m.b * n.c, m.a * n.b + m.b * n.d, m.c * n.a + m.d * n.c, m.c * n.b + m.d * n.d};
}
HL_FN PairMatrix operator-(const PairMatrix& m, const PairMatrix& n) { return {m.a - n.a, m.b - n.b, m.c - n.c, m.d - n.d}; }
HL_FN PairMatrix operator-(const PairMatrix& m) { return {-m.a, -m.b, -m.c, -m.d}; }
HL_FN Pair operator-(const Pair& v, const Pair& w) { return {v.first - w.first, v.second - w.second}; }
HL_FN Pair operator*(const PairMatrix& m, const Pair& v) { return {m.a * v.first + m.b * v.second, m.c * v.first + m.d * v.second}; }

/// The same of two numbers at each place; those of neighbours meet their like only: lower and upper are diagonals.
struct PairEquation {
    Pair lower;
    PairMatrix pivot;
    Pair upper, right;
};

// What elimination does with the numbers of one place alike, whether it has one or two.
HL_FN double one_of(double) { return 1.0; }
HL_FN PairMatrix one_of(const PairMatrix&) { return {1, 0, 0, 1}; }
HL_FN double inverse_of(double value) { return plain_inverse(value); }
HL_FN PairMatrix inverse_of(const PairMatrix& m) { return m.inverse(); }
HL_FN double scaled(double value, double scale) { return value * scale; }
template <typename Value> HL_FN Value scaled(const Value& value, const PairMatrix& scale) { return scale * value; }
HL_FN double largest_of(double value) { return value < 0 ? -value : value; }
HL_FN double largest_of(const PairMatrix& m)
{
    const double ab = std::fmax(std::fabs(m.a), std::fabs(m.b)), cd = std::fmax(std::fabs(m.c), std::fabs(m.d));
    return ab > cd ? ab : cd;
}
HL_FN PairMatrix diagonal(const Pair& v) { return {v.first, 0, 0, v.second}; }

/// x = right - lower x[before] - upper x[after].
template <typename Matrix, typename Vector> struct Link {
    Matrix lower{}, upper{};
    Vector right{};

    /// Whether the others matter: what is less is lost in rounding.
    HL_FN bool is_coupled() const
    {
        constexpr double least = 0x1.0p-64;
        return largest_of(lower) > least || largest_of(upper) > least;
    }
};
using SingleLink = Link<double, double>;
using PairLink = Link<PairMatrix, Pair>;

HL_FN SingleLink link_of(const Equation& own)
{
    const double scale = plain_inverse(own.pivot);
    return {own.lower * scale, own.upper * scale, own.right * scale};
}
HL_FN PairLink link_of(const PairEquation& own)
{
    const PairMatrix scale = own.pivot.inverse();
    return {scale * diagonal(own.lower), scale * diagonal(own.upper), scale * own.right};
}

/// Links in columns of numbers; none before the first and after the last.
template <typename Kind> struct LinkColumns;
template <> struct LinkColumns<SingleLink> {
    static constexpr int numbers = 3, found = 2; ///< of a link; the column of the first of right
    double* first;
    int stride, count;

    HL_FN SingleLink at(int k) const
    {
        return k < 0 || k >= count ? SingleLink{} : SingleLink{first[k], first[stride + k], first[2 * stride + k]};
    }
    HL_FN void set(int k, const SingleLink& link) const
    {
        first[k] = link.lower;
        first[stride + k] = link.upper;
        set_right(k, link.right);
    }
    HL_FN void set_right(int k, double right) const { first[found * stride + k] = right; }
};
template <> struct LinkColumns<PairLink> {
    static constexpr int numbers = 10, found = 8;
    double* first;
    int stride, count;

    HL_FN PairMatrix matrix(int column, int k) const
    {
        const double* const at = first + column * stride + k;
        return {at[0], at[stride], at[2 * stride], at[3 * stride]};
    }
    HL_FN void set(int column, int k, const PairMatrix& m) const
    {
        double* const at = first + column * stride + k;
        at[0] = m.a;
        at[stride] = m.b;
        at[2 * stride] = m.c;
        at[3 * stride] = m.d;
    }
    HL_FN PairLink at(int k) const
    {
        if (k < 0 || k >= count) return {};
        return {matrix(0, k), matrix(4, k), {first[8 * stride + k], first[9 * stride + k]}};
    }
    HL_FN void set(int k, const PairLink& link) const
    {
        set(0, k, link.lower);
        set(4, k, link.upper);
        set_right(k, link.right);
    }
    HL_FN void set_right(int k, const Pair& right) const
    {
        first[found * stride + k] = right.first;
        first[(found + 1) * stride + k] = right.second;
    }
};

} // namespace hygroloom
