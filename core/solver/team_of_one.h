// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The team that works on a yarn's line on a CPU: one thread. What teams offer stands here; see team.h.
#pragma once

#include "core/solver/line_equations.h"

#include <type_traits>

namespace hygroloom {

/// Numbers per place that a stage along lines asks for beside what its equations take: Stage::columns.
template <typename Stage>
constexpr int columns_of = [] {
    if constexpr (requires { Stage::columns; }) // void: none
        return Stage::columns;
    else
        return 0;
}();

/// Whether a stage along lines is worth a compilation of its own for processors with wide registers: Stage::wide_along_lines.
template <typename Stage> constexpr bool is_wide_along_lines = requires { Stage::wide_along_lines; };

/// The team of a CPU, with a line to itself.
class Alone {
    static constexpr int of_pairs = LinkColumns<RingLink>::numbers, upper_column = 4;

public:
    /// Numbers per place that a line's room must have: for single equations, or for pairs and the stage's own columns.
    template <typename Stage> static constexpr int per_place = columns_of<Stage> > 0 ? of_pairs + columns_of<Stage> : 2;

    explicit Alone(double* room, int longest) : upper_(room), right_(room + longest), room_(room), longest_(longest) {}

    /// A stage's own columns, a number for each place of a line; the numbers of a place lie side by side.
    struct Columns {
        double* first;
        int count;

        double& operator()(int column, int place) const { return first[place * count + column]; }
    };
    Columns columns(int count, int) const { return {room_ + of_pairs * longest_, count}; }

    /// Calls f(i) for first <= i < last, in any order.
    template <typename F> void each(int first, int last, const F& f) const
    {
        for (int i = first; i < last; ++i) f(i);
    }
    /// The same, of all of them; returns whether f(i) was true for any.
    template <typename F> bool each_saying(int first, int last, const F& f) const
    {
        bool any = false;
        for (int i = first; i < last; ++i) any = f(i) || any;
        return any;
    }
    /// Whether f(i) is true for any first <= i < last.
    template <typename F> bool any_of(int first, int last, const F& f) const
    {
        for (int i = first; i < last; ++i)
            if (f(i)) return true;
        return false;
    }
    /// The sum of f(i), and the most, at least 0.
    template <typename F> double sum(int first, int last, const F& f) const
    {
        double all = 0;
        for (int i = first; i < last; ++i) all += f(i);
        return all;
    }
    template <typename F> double most(int first, int last, const F& f) const
    {
        double most = 0;
        for (int i = first; i < last; ++i) most = std::fmax(most, f(i));
        return most;
    }
    /// Adds what every thread has to a total.
    void add(std::int64_t* total, std::int64_t own) const
    {
        if (own != 0) atomic_add(total, own);
    }
    /// Solves the rows row(i), first <= i < last, by elimination. For diagonally dominant M-matrices, by rows or by columns. Until the
    /// next solution found(first, i) is x[i].
    template <typename Rows> void solve(int first, int last, const Rows& row) const
    {
        double upper = 0, right = 0;
        for (int i = first; i < last; ++i) {
            const Equation own = row(i);
            const double per_pivot = 1.0 / (own.pivot - own.lower * upper);
            upper_[i - first] = upper = own.upper * per_pivot;
            right_[i - first] = right = (own.right - own.lower * right) * per_pivot;
        }
        double x = 0;
        for (int i = last - 1; i >= first; --i) right_[i - first] = x = right_[i - first] - upper_[i - first] * x;
    }
    double found(int first, int i) const { return right_[i - first]; }
    /// The same of pairs, whose rows are diagonally dominant M-matrices, too. row(i, open) also says so where something is left open; if
    /// none does, nothing is solved, otherwise use(i, x[i]) is called for each place. Returns whether any does.
    template <typename Rows, typename Use> bool solve_pairs(int first, int last, const Rows& row, const Use& use) const
    {
        return solve_open<Pair>(first, last, row, use);
    }
    /// The same of rows whose last place joins the first. A row's right has its own number and, for the answer, one at the first place and
    /// less than that at the last; the joint, which the rows do without, passes this much of each number for a difference of one.
    template <typename Rows, typename Use> bool solve_ring(int first, int last, const Rows& row, const Pair& joint, const Use& use) const
    {
        const auto places = columns_of_pairs<RingPair>();
        if (!solve_open<RingPair>(first, last, row, [&](int i, const RingPair& x) { places.set_right(i - first, x); })) return false;
        const int count = last - first;
        const Pair passes = through_joint(places.right(0), places.right(count - 1), joint);
        for (int k = 0; k < count; ++k) use(first + k, places.right(k).with(passes));
        return true;
    }
    /// Notes in place_of(i) what solve_factored() needs of equations with many rights: of their pivots, and of joints that a place's
    /// numbers have with the next place's like (the last of a line has none); both at least 0, the matrix positive definite.
    template <typename Pivot, typename Joint, typename PlaceOf>
    void factor_pairs(int first, int last, const Pivot& pivot, const Joint& joint, const PlaceOf& place_of) const
    {
        SymmetricMatrix before{0, 0, 0};
        for (int i = first; i < last; ++i) {
            SymmetricMatrix own = pivot(i);
            if (i > first) {
                const Pair g = joint(i - 1);
                own = {own.a - g.first * g.first * before.a, own.b - g.first * g.second * before.b, own.d - g.second * g.second * before.d};
            }
            before = own.inverse();
            place_of(i).write(before);
        }
    }
    /// Calls use(i, x[i]) for each place, from the last to the first; factor(i) is what factor_pairs() noted.
    template <typename Factor, typename Joint, typename Right, typename Use>
    void solve_factored(int first, int last, const Factor& factor, const Joint& joint, const Right& right, const Use& use) const
    {
        // What a neighbour brings is one product away from it, so that places wait little for each other.
        const auto brings = [](const SymmetricMatrix& m, const Pair& g, const Pair& neighbour, const Pair& own) {
            const double a = m.a * g.first, b = m.b * g.second, c = m.b * g.first, d = m.d * g.second;
            return Pair{a * neighbour.first + (b * neighbour.second + own.first),
                        c * neighbour.first + (d * neighbour.second + own.second)};
        };
        Pair found;
        for (int i = first; i < last; ++i) {
            const SymmetricMatrix m = factor(i);
            const Pair own = m * right(i);
            found = i > first ? brings(m, joint(i - 1), found, own) : own;
            upper_[i - first] = found.first;
            right_[i - first] = found.second;
        }
        Pair x;
        for (int i = last - 1; i >= first; --i) {
            const Pair own{upper_[i - first], right_[i - first]};
            x = i + 1 < last ? brings(factor(i), joint(i), x, own) : own;
            use(i, x);
        }
    }
    /// Passes on what places cannot keep: from the first to the last, then back to the first, which keeps whatever comes. keep(i) bounds a
    /// place and returns what it had too much (or, less than nothing, too little); pass(from, to, amount) notes that it goes over to a
    /// neighbour, and give(i, amount) adds it there.
    template <typename Keep, typename Pass, typename Give>
    void carry(int first, int last, const Keep& keep, const Pass& pass, const Give& give) const
    {
        for (int step : {1, -1})
            for (int k = 0, i = step > 0 ? first : last - 1; k < last - first - 1; ++k, i += step)
                if (const double over = keep(i); over != 0) {
                    pass(i, i + step, over);
                    give(i + step, over);
                }
    }

private:
    template <typename Right> LinkColumns<Link<PairMatrix, Right>> columns_of_pairs() const { return {room_, longest_, longest_}; }
    template <typename Right, typename Rows, typename Use> bool solve_open(int first, int last, const Rows& row, const Use& use) const
    {
        const auto places = columns_of_pairs<Right>();
        PairMatrix upper{0, 0, 0, 0};
        Right found{};
        bool open = false;
        for (int i = first; i < last; ++i) {
            const PairRow<Right> own = row(i, open);
            const Pair& l = own.lower;
            const PairMatrix per_pivot = PairMatrix{own.pivot.a - l.first * upper.a, own.pivot.b - l.first * upper.b,
                                                    own.pivot.c - l.second * upper.c, own.pivot.d - l.second * upper.d}
                                             .inverse();
            found = per_pivot * (own.right - diagonal(l) * found);
            upper = {per_pivot.a * own.upper.first, per_pivot.b * own.upper.second, per_pivot.c * own.upper.first,
                     per_pivot.d * own.upper.second};
            const int k = i - first;
            places.set(upper_column, k, upper);
            places.set_right(k, found);
        }
        if (!open) return false;
        Right x{};
        for (int k = last - first - 1; k >= 0; --k) {
            x = places.right(k) - places.matrix(upper_column, k) * x;
            use(first + k, x);
        }
        return true;
    }
    double* upper_;
    double* right_;
    double* room_;
    int longest_;
};

} // namespace hygroloom
