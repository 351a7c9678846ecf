// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Threads that work on a yarn's line together: one on a CPU, a block of them on a GPU. A stage that goes along lines is called with its
// team, by all of its threads at once. What threads exchange goes through places of the line and the team's own room; each call
// of the team ends when all of its threads are done with it.
#pragma once

#include "core/base/portable.h"

#include <cmath>

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

/// Numbers per place that a stage along lines asks for beside what its equations take: Stage::columns.
template <typename Stage>
constexpr int columns_of = [] {
    if constexpr (requires { Stage::columns; }) // void: none
        return Stage::columns;
    else
        return 0;
}();

/// The team of a CPU, with a line to itself.
class Alone {
public:
    /// Numbers per place that a line's room must have: for single equations, or for pairs and the stage's own columns.
    template <typename Stage> static constexpr int per_place = columns_of<Stage> > 0 ? 6 + columns_of<Stage> : 2;

    explicit Alone(double* room, int longest) : upper_(room), right_(room + longest), room_(room), longest_(longest) {}

    /// One of the stage's own columns, a number for each place of the line.
    double* column(int k) const { return room_ + (6 + k) * longest_; }

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
    /// The same of pairs, whose rows are diagonally dominant M-matrices, too.
    template <typename Rows> void solve_pairs(int first, int last, const Rows& row) const
    {
        double* const columns[] = {room_, room_ + longest_, room_ + 2 * longest_, room_ + 3 * longest_};
        double* const found[] = {room_ + 4 * longest_, room_ + 5 * longest_};
        PairMatrix upper{0, 0, 0, 0};
        Pair right{0, 0};
        for (int i = first; i < last; ++i) {
            const PairEquation own = row(i);
            const Pair& l = own.lower;
            const PairMatrix per_pivot = PairMatrix{own.pivot.a - l.first * upper.a, own.pivot.b - l.first * upper.b,
                                                    own.pivot.c - l.second * upper.c, own.pivot.d - l.second * upper.d}
                                             .inverse();
            right = per_pivot * Pair{own.right.first - l.first * right.first, own.right.second - l.second * right.second};
            upper = {per_pivot.a * own.upper.first, per_pivot.b * own.upper.second, per_pivot.c * own.upper.first,
                     per_pivot.d * own.upper.second};
            const int k = i - first;
            columns[0][k] = upper.a;
            columns[1][k] = upper.b;
            columns[2][k] = upper.c;
            columns[3][k] = upper.d;
            found[0][k] = right.first;
            found[1][k] = right.second;
        }
        Pair x{0, 0};
        for (int k = last - first - 1; k >= 0; --k) {
            x = {found[0][k] - columns[0][k] * x.first - columns[1][k] * x.second,
                 found[1][k] - columns[2][k] * x.first - columns[3][k] * x.second};
            found[0][k] = x.first;
            found[1][k] = x.second;
        }
    }
    Pair found_pair(int first, int i) const { return {room_[4 * longest_ + i - first], room_[5 * longest_ + i - first]}; }
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
    double* upper_;
    double* right_;
    double* room_;
    int longest_;
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

/// A team of several threads, each with a chunk of neighbouring places wherever what happens at one depends on the one before. Threads
/// offers size(), all(f), which has every thread call f(its number) and wait for the others, any(f), which does the same and returns
/// whether any f did, and add(total, own).
template <typename Threads> class Team {
    template <typename Stage> static constexpr bool of_pairs = columns_of<Stage> > 0;

public:
    /// Numbers per place that a line's room must have, and per thread that the links' room must have.
    template <typename Stage>
    static constexpr int per_place =
        of_pairs<Stage> ? LinkColumns<PairLink>::numbers + columns_of<Stage> : LinkColumns<SingleLink>::numbers;
    template <typename Stage>
    static constexpr int per_thread = 2 * (of_pairs<Stage> ? LinkColumns<PairLink>::numbers : LinkColumns<SingleLink>::numbers);

    HL_FN Team(const Threads& threads, double* room, int longest, double* links_room)
        : threads_(threads), room_(room), longest_(longest), links_(links_room)
    {
    }

    /// One of the stage's own columns, a number for each place of the line.
    HL_FN double* column(int k) const { return room_ + (LinkColumns<PairLink>::numbers + k) * longest_; }

    // As with Alone.
    template <typename F> HL_FN void each(int first, int last, const F& f) const
    {
        threads_.all([&](int t) {
            for (int i = first + t; i < last; i += threads_.size()) f(i);
        });
    }
    template <typename F> HL_FN bool each_saying(int first, int last, const F& f) const
    {
        return threads_.any([&](int t) {
            bool any = false;
            for (int i = first + t; i < last; i += threads_.size()) any = f(i) || any;
            return any;
        });
    }
    template <typename F> HL_FN bool any_of(int first, int last, const F& f) const
    {
        return threads_.any([&](int t) {
            bool found = false;
            for (int i = first + t; i < last && !found; i += threads_.size()) found = f(i);
            return found;
        });
    }
    HL_FN void add(std::int64_t* total, std::int64_t own) const { threads_.add(total, own); }

    template <typename Rows> HL_FN void solve(int first, int last, const Rows& row) const { solve_links<SingleLink>(first, last, row); }
    HL_FN double found(int first, int i) const { return room_[LinkColumns<SingleLink>::found * longest_ + i - first]; }
    template <typename Rows> HL_FN void solve_pairs(int first, int last, const Rows& row) const { solve_links<PairLink>(first, last, row); }
    HL_FN Pair found_pair(int first, int i) const
    {
        const double* const at = room_ + LinkColumns<PairLink>::found * longest_ + i - first;
        return {at[0], at[longest_]};
    }

    /// In each round every thread goes through its chunk; what the chunk's last place cannot keep comes to the next chunk in the next
    /// round.
    template <typename Keep, typename Pass, typename Give>
    HL_FN void carry(int first, int last, const Keep& keep, const Pass& pass, const Give& give) const
    {
        carry_one_way(last - first, first, 1, keep, pass, give);
        carry_one_way(last - first, last - 1, -1, keep, pass, give);
    }

private:
    /// As even as they come, and odd, so that the threads of a warp find their places in different banks of shared memory.
    struct Chunks {
        int places, each;

        HL_FN Chunks(int all_places, int threads) : places(all_places), each(((all_places + threads - 1) / threads) | 1) {}
        HL_FN int begin(int t) const { return t * each < places ? t * each : places; }
        HL_FN int end(int t) const { return begin(t + 1); }
        HL_FN int count() const { return (places + each - 1) / each; }
    };
    template <typename Own> HL_FN LinkColumns<Own> links(int which) const
    {
        return {links_ + LinkColumns<Own>::numbers * which * threads_.size(), threads_.size(), threads_.size()};
    }

    /// Each thread eliminates the places within its chunk, which leaves a row per chunk (Wang 1981: a parallel method for tridiagonal
    /// equations); those are solved by parallel cyclic reduction (Hockney and Jesshope 1981).
    template <typename Own, typename Rows> HL_FN void solve_links(int first, int last, const Rows& row) const
    {
        const LinkColumns<Own> places{room_, longest_, last - first};
        each(first, last, [&](int i) { places.set(i - first, link_of(row(i))); });
        const Chunks chunks(last - first, threads_.size());
        threads_.all([&](int t) { links<Own>(1).set(t, eliminate(places, chunks.begin(t), chunks.end(t))); });
        const bool coupled = threads_.any([&](int t) {
            const Own own = join(places, chunks.begin(t), chunks.end(t), links<Own>(1).at(t + 1));
            links<Own>(0).set(t, own);
            return own.is_coupled();
        });
        const LinkColumns<Own> solved = links<Own>(reduce<Own>(chunks.count(), coupled));
        threads_.all([&](int t) { substitute(places, chunks.begin(t), chunks.end(t), solved.at(t - 1).right, solved.at(t).right); });
    }
    /// Leaves each place by the last of the chunk before and by the next place; returns the chunk's first by the last of the chunk before
    /// and its own last.
    template <typename M, typename V> HL_FN static Link<M, V> eliminate(const LinkColumns<Link<M, V>>& places, int begin, int end)
    {
        if (begin >= end) return {};
        Link<M, V> before = places.at(begin);
        Link<M, V> first{{}, -one_of(M{}), {}}; // so far by the place itself
        for (int i = begin + 1; i < end; ++i) {
            first = {first.lower - first.upper * before.lower, -first.upper * before.upper, first.right - first.upper * before.right};
            const Link<M, V> own = places.at(i);
            const M scale = inverse_of(one_of(M{}) - own.lower * before.upper);
            before = {scaled(-own.lower * before.lower, scale), scaled(own.upper, scale),
                      scaled(own.right - own.lower * before.right, scale)};
            places.set(i, before);
        }
        return first;
    }
    /// The chunk's last by those of the chunks before and after.
    template <typename M, typename V>
    HL_FN static Link<M, V> join(const LinkColumns<Link<M, V>>& places, int begin, int end, const Link<M, V>& first_of_next)
    {
        if (begin >= end) return {};
        const Link<M, V> own = places.at(end - 1);
        const M scale = inverse_of(one_of(M{}) - own.upper * first_of_next.lower);
        return {scaled(own.lower, scale), scaled(-own.upper * first_of_next.upper, scale),
                scaled(own.right - own.upper * first_of_next.right, scale)};
    }
    /// Solves for the last of each chunk; returns which of the links then has it as right. Each round couples chunks twice as far apart,
    /// by far less where places hold to themselves: most lines are done after a few.
    template <typename Own> HL_FN int reduce(int count, bool coupled) const
    {
        int now = 0;
        for (int apart = 1; apart < count && coupled; apart *= 2, now = 1 - now)
            coupled = threads_.any([&](int t) {
                const Own own = links<Own>(now).at(t), before = links<Own>(now).at(t - apart), after = links<Own>(now).at(t + apart);
                const auto scale = inverse_of(one_of(own.lower) - own.lower * before.upper - own.upper * after.lower);
                const Own next{scaled(-own.lower * before.lower, scale), scaled(-own.upper * after.upper, scale),
                               scaled(own.right - own.lower * before.right - own.upper * after.right, scale)};
                links<Own>(1 - now).set(t, next);
                return next.is_coupled();
            });
        return now;
    }
    template <typename M, typename V>
    HL_FN static void substitute(const LinkColumns<Link<M, V>>& places, int begin, int end, const V& before, V last)
    {
        if (begin >= end) return;
        places.set_right(end - 1, last);
        for (int i = end - 2; i >= begin; --i) {
            const Link<M, V> own = places.at(i);
            last = own.right - own.lower * before - own.upper * last;
            places.set_right(i, last);
        }
    }

    /// From a place on, along the line or back.
    template <typename Keep, typename Pass, typename Give>
    HL_FN void carry_one_way(int places, int from, int step, const Keep& keep, const Pass& pass, const Give& give) const
    {
        const Chunks chunks(places, threads_.size());
        // Returns what the chunk's last place could not keep. Where only one place has changed, what follows the first that keeps all does.
        const auto sweep = [&](int begin, int end, bool all) {
            double over = 0;
            for (int k = begin; k < end && k < places - 1; ++k) {
                const int i = from + step * k;
                over = keep(i);
                if (over != 0) {
                    pass(i, i + step, over);
                    if (k + 1 < end) give(i + step, over);
                } else if (!all)
                    break;
            }
            return end < places ? over : 0.0;
        };
        bool goes_on = true;
        for (int round = 0; goes_on; ++round) {
            double* leaves = links_ + threads_.size() * (round % 2);
            const double* came = links_ + threads_.size() * (1 - round % 2);
            goes_on = threads_.any([&](int t) {
                const int begin = chunks.begin(t), end = chunks.end(t);
                const double comes = round > 0 && t > 0 && begin < end ? came[t - 1] : 0.0;
                if (comes != 0) give(from + step * begin, comes);
                leaves[t] = round == 0 || comes != 0 ? sweep(begin, end, round == 0) : 0.0;
                return leaves[t] != 0;
            });
        }
    }

    Threads threads_;
    double* room_;
    int longest_;
    double* links_;
};

} // namespace hygroloom
