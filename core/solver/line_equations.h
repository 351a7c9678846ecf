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
HL_FN PairMatrix diagonal(const Pair& v) { return {v.first, 0, 0, v.second}; }

/// A pair's matrix (a b), (b d), in columns of numbers.
struct SymmetricMatrix {
    double a, b, d;

    HL_FN Pair operator*(const Pair& v) const { return {a * v.first + b * v.second, b * v.first + d * v.second}; }
    HL_FN SymmetricMatrix inverse() const
    {
        const double scale = plain_inverse(a * d - b * b);
        return {d * scale, -b * scale, a * scale};
    }
};
struct SymmetricColumns {
    double *a, *b, *d;

    HL_FN SymmetricMatrix read() const { return {*a, *b, *d}; }
    HL_FN void write(const SymmetricMatrix& m) const
    {
        *a = m.a;
        *b = m.b;
        *d = m.d;
    }
};

/// Of a line whose last place joins its first: what is found as if it were open, and how that answers to a unit that leaves by the joint
/// from the first place and comes in at the last, of each number (Woodbury 1950).
struct RingPair {
    Pair open;
    PairMatrix answer;

    /// With so much of each number that passes the joint.
    HL_FN Pair with(const Pair& passes) const { return open - answer * passes; }
};
HL_FN RingPair operator-(const RingPair& v, const RingPair& w) { return {v.open - w.open, v.answer - w.answer}; }
HL_FN RingPair operator*(const PairMatrix& m, const RingPair& v) { return {m * v.open, m * v.answer}; }

/// What passes a joint that passes this much for a difference of one, from the first place to the last.
HL_FN Pair through_joint(const RingPair& first, const RingPair& last, const Pair& joint)
{
    const RingPair apart = first - last;
    const PairMatrix held_back = diagonal(joint) * apart.answer;
    return PairMatrix{1 + held_back.a, held_back.b, held_back.c, 1 + held_back.d}.inverse() * (diagonal(joint) * apart.open);
}

/// The same as Equation of two numbers at each place; those of neighbours meet their like only: lower and upper are diagonals.
template <typename Right> struct PairRow {
    Pair lower;
    PairMatrix pivot;
    Pair upper;
    Right right;
};
using PairEquation = PairRow<Pair>;
using RingEquation = PairRow<RingPair>;

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
using RingLink = Link<PairMatrix, RingPair>;

HL_FN SingleLink link_of(const Equation& own)
{
    const double scale = plain_inverse(own.pivot);
    return {own.lower * scale, own.upper * scale, own.right * scale};
}
template <typename Right> HL_FN Link<PairMatrix, Right> link_of(const PairRow<Right>& own)
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
template <typename Right> struct LinkColumns<Link<PairMatrix, Right>> {
    static constexpr int found = 8, numbers = found + static_cast<int>(sizeof(Right) / sizeof(double));
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
    HL_FN Link<PairMatrix, Right> at(int k) const
    {
        if (k < 0 || k >= count) return {};
        return {matrix(0, k), matrix(4, k), right(k)};
    }
    HL_FN void set(int k, const Link<PairMatrix, Right>& link) const
    {
        set(0, k, link.lower);
        set(4, k, link.upper);
        set_right(k, link.right);
    }
    HL_FN Right right(int k) const
    {
        const Pair pair{first[found * stride + k], first[(found + 1) * stride + k]};
        if constexpr (numbers > found + 2)
            return {pair, matrix(found + 2, k)};
        else
            return pair;
    }
    HL_FN void set_right(int k, const Pair& right) const
    {
        first[found * stride + k] = right.first;
        first[(found + 1) * stride + k] = right.second;
    }
    HL_FN void set_right(int k, const RingPair& right) const
    {
        set_right(k, right.open);
        set(found + 2, k, right.answer);
    }
};

} // namespace hygroloom
