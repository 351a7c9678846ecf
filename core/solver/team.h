// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Threads that work on a yarn's line together: one on a CPU, a block of them on a GPU. A stage that goes along lines is called with its
// team, by all of its threads at once. What threads exchange goes through places of the line and the team's own room; each call
// of the team ends when all of its threads are done with it.
#pragma once

#include "core/base/portable.h"

namespace hygroloom {

/// lower x[i - 1] + pivot x[i] + upper x[i + 1] = right. The first row of a line has no lower, the last no upper.
struct Equation {
    double lower, pivot, upper, right;
};

/// The team of a CPU, with a line to itself.
class Alone {
public:
    static constexpr int per_place = 2; ///< numbers per place that a line's room must have

    explicit Alone(double* room, int longest) : upper_(room), right_(room + longest) {}

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
};

/// A team of several threads, each with a chunk of neighbouring places wherever what happens at one depends on the one before. Threads
/// offers size(), all(f), which has every thread call f(its number) and wait for the others, any(f), which does the same and returns
/// whether any f did, and add(total, own).
template <typename Threads> class Team {
public:
    static constexpr int per_place = 3;  ///< numbers per place that a line's room must have
    static constexpr int per_thread = 6; ///< numbers per thread that the links' room must have

    HL_FN Team(const Threads& threads, double* room, int longest, double* links_room)
        : threads_(threads), lower_(room), upper_(room + longest), right_(room + 2 * longest), links_(links_room)
    {
    }

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

    /// Each thread eliminates the places within its chunk, which leaves a row per chunk (Wang 1981: a parallel method for tridiagonal
    /// equations); those are solved by parallel cyclic reduction (Hockney and Jesshope 1981).
    template <typename Rows> HL_FN void solve(int first, int last, const Rows& row) const
    {
        each(first, last, [&](int i) {
            const Equation own = row(i);
            const double scale = plain_inverse(own.pivot);
            lower_[i - first] = own.lower * scale;
            upper_[i - first] = own.upper * scale;
            right_[i - first] = own.right * scale;
        });
        const Chunks chunks(last - first, threads_.size());
        threads_.all([&](int t) { links(1).set(t, eliminate(chunks.begin(t), chunks.end(t))); });
        const bool coupled = threads_.any([&](int t) {
            const Link own = join(chunks.begin(t), chunks.end(t), links(1).at(t + 1));
            links(0).set(t, own);
            return own.is_coupled();
        });
        const Links solved = links(reduce(chunks.count(), coupled));
        threads_.all([&](int t) { substitute(chunks.begin(t), chunks.end(t), solved.at(t - 1).right, solved.at(t).right); });
    }
    HL_FN double found(int first, int i) const { return right_[i - first]; }

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
    /// x = right - lower x[before] - upper x[after], for an x of a chunk.
    struct Link {
        double lower = 0, upper = 0, right = 0;

        /// Whether the other chunks matter: what is less is lost in rounding.
        HL_FN bool is_coupled() const
        {
            constexpr double least = 0x1.0p-64;
            return lower > least || lower < -least || upper > least || upper < -least;
        }
    };
    /// One per chunk; nothing before the first and after the last.
    struct Links {
        double* at_;
        int count;

        HL_FN Link at(int t) const { return t < 0 || t >= count ? Link{} : Link{at_[t], at_[count + t], at_[2 * count + t]}; }
        HL_FN void set(int t, const Link& link) const
        {
            at_[t] = link.lower;
            at_[count + t] = link.upper;
            at_[2 * count + t] = link.right;
        }
    };

    HL_FN Links links(int which) const { return {links_ + 3 * which * threads_.size(), threads_.size()}; }

    /// Leaves x[i] = right - lower x[last of the chunk before] - upper x[i + 1]; returns the chunk's first x by the last of the chunk
    /// before and its own last.
    HL_FN Link eliminate(int begin, int end) const
    {
        if (begin >= end) return {};
        Link before{lower_[begin], upper_[begin], right_[begin]};
        Link first{0, -1, 0}; // so far by the place itself
        for (int i = begin + 1; i < end; ++i) {
            first = {first.lower - first.upper * before.lower, -first.upper * before.upper, first.right - first.upper * before.right};
            const double lower = lower_[i], scale = plain_inverse(1.0 - lower * before.upper);
            before = {-lower * before.lower * scale, upper_[i] * scale, (right_[i] - lower * before.right) * scale};
            lower_[i] = before.lower;
            upper_[i] = before.upper;
            right_[i] = before.right;
        }
        return first;
    }
    /// The chunk's last x by those of the chunks before and after.
    HL_FN Link join(int begin, int end, const Link& first_of_next) const
    {
        if (begin >= end) return {};
        const double upper = upper_[end - 1], scale = plain_inverse(1.0 - upper * first_of_next.lower);
        return {lower_[end - 1] * scale, -upper * first_of_next.upper * scale, (right_[end - 1] - upper * first_of_next.right) * scale};
    }
    /// Solves for the last x of each chunk; returns which of the links then has it as right. Each round couples chunks twice as far apart,
    /// by far less where places hold to themselves: most lines are done after a few.
    HL_FN int reduce(int count, bool coupled) const
    {
        int now = 0;
        for (int apart = 1; apart < count && coupled; apart *= 2, now = 1 - now)
            coupled = threads_.any([&](int t) {
                const Link own = links(now).at(t), before = links(now).at(t - apart), after = links(now).at(t + apart);
                const double scale = plain_inverse(1.0 - own.lower * before.upper - own.upper * after.lower);
                const Link next{-own.lower * before.lower * scale, -own.upper * after.upper * scale,
                                (own.right - own.lower * before.right - own.upper * after.right) * scale};
                links(1 - now).set(t, next);
                return next.is_coupled();
            });
        return now;
    }
    HL_FN void substitute(int begin, int end, double before, double last) const
    {
        if (begin >= end) return;
        right_[end - 1] = last;
        for (int i = end - 2; i >= begin; --i) right_[i] = last = right_[i] - lower_[i] * before - upper_[i] * last;
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
    double* lower_;
    double* upper_;
    double* right_;
    double* links_;
};

} // namespace hygroloom
