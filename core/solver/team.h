// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Threads that work on a yarn's line together: one on a CPU, a block of them on a GPU. A stage that goes along lines is called with its
// team, by all of its threads at once. What threads exchange goes through places of the line and the team's own room; each call
// of the team ends when all of its threads are done with it.
#pragma once

#include "core/solver/team_of_one.h"

namespace hygroloom {

/// A line's places in chunks of neighbours, one for each thread, as even as they come.
struct Chunks {
    int places, each;

    HL_FN int begin(int t) const { return t * each < places ? t * each : places; }
    HL_FN int end(int t) const { return begin(t + 1); }
    HL_FN int count() const { return (places + each - 1) / each; }
};

/// Where numbers of places lie so that threads that go through their chunks side by side find them side by side: the first of each chunk,
/// then the second, and so on.
class ChunkSlots {
public:
    HL_FN explicit ChunkSlots(const Chunks& chunks)
        : each_(chunks.each), count_(chunks.count()), per_each_((std::uint64_t(1) << 32) / static_cast<unsigned>(chunks.each) + 1)
    {
    }
    HL_FN int operator()(int place) const // a line of fewer places than 2^32 over those of a chunk
    {
        const auto chunk = static_cast<int>(static_cast<std::uint64_t>(place) * per_each_ >> 32);
        return (place - chunk * each_) * count_ + chunk;
    }

private:
    int each_, count_;
    std::uint64_t per_each_; ///< of 2^32
};

/// Numbers of each place that a stage along lines asks for.
struct LineNumbers {
    int of_link; ///< see LinkColumns
    int columns; ///< the stage's own
};
template <typename Stage> HL_FN LineNumbers line_numbers_of(const Stage& stage)
{
    if constexpr (columns_of<Stage> != 0)
        return {stage.has_rings() ? LinkColumns<RingLink>::numbers : LinkColumns<PairLink>::numbers, columns_of<Stage>};
    else
        return {LinkColumns<SingleLink>::numbers, 0};
}

/// A team of several threads, each with a chunk of neighbouring places wherever what happens at one depends on the one before. Threads
/// offers size(), all(f), which has every thread call f(its number) and wait for the others, any(f), which does the same and returns
/// whether any f did, and add(total, own).
template <typename Threads> class Team {
    HL_FN static constexpr int slots(int longest, int threads) { return longest + longest / threads + 1; }

public:
    /// Numbers that the room of the longest line must have, and that the links' room must have.
    HL_FN static constexpr std::size_t room(const LineNumbers& numbers, int longest, int threads)
    {
        return static_cast<std::size_t>(numbers.of_link + numbers.columns) * static_cast<std::size_t>(slots(longest, threads));
    }
    HL_FN static constexpr int links_room(const LineNumbers& numbers, int threads) { return 2 * numbers.of_link * threads; }

    HL_FN Team(const Threads& threads, const LineNumbers& numbers, double* room, int longest, double* links_room)
        : threads_(threads), of_link_(numbers.of_link), room_(room), stride_(slots(longest, threads.size())), links_(links_room)
    {
    }

    /// A stage's own columns, a number for each place of a line.
    struct Columns {
        double* first;
        int stride;
        ChunkSlots slot;

        HL_FN double& operator()(int column, int place) const { return first[column * stride + slot(place)]; }
    };
    HL_FN Columns columns(int, int places) const { return {room_ + of_link_ * stride_, stride_, ChunkSlots(even_chunks(places))}; }

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
    template <typename F> HL_FN double sum(int first, int last, const F& f) const
    {
        return fold(first, last, f, [](double a, double b) { return a + b; });
    }
    template <typename F> HL_FN double most(int first, int last, const F& f) const
    {
        return fold(first, last, f, [](double a, double b) { return std::fmax(a, b); });
    }

    /// Each thread eliminates the places within its chunk, which leaves a row per chunk (Wang 1981: a parallel method for tridiagonal
    /// equations); those are solved by parallel cyclic reduction (Hockney and Jesshope 1981).
    template <typename Rows> HL_FN void solve(int first, int last, const Rows& row) const
    {
        const LinkColumns<SingleLink> places{room_, stride_, last - first};
        each(first, last, [&](int i) { places.set(i - first, link_of(row(i))); });
        const Chunks chunks = odd_chunks(last - first);
        const auto slot = [](int place) { return place; };
        threads_.all([&](int t) {
            links<SingleLink>(1).set(t, eliminate(places, slot, chunks.begin(t), chunks.end(t), [&](int k) { return places.at(k); }));
        });
        const LinkColumns<SingleLink> solved = solve_chunks(places, slot, chunks);
        threads_.all([&](int t) {
            substitute(places, slot, chunks.begin(t), chunks.end(t), solved.at(t - 1).right, solved.at(t).right,
                       [&](int k, double x) { places.set_right(k, x); });
        });
    }
    HL_FN double found(int first, int i) const { return room_[LinkColumns<SingleLink>::found * stride_ + i - first]; }
    template <typename Rows, typename Use> HL_FN bool solve_pairs(int first, int last, const Rows& row, const Use& use) const
    {
        return solve_open<PairLink>(
            last - first, [&](int k, bool& open) { return row(first + k, open); }, [&](int k, const Pair& x) { use(first + k, x); });
    }
    template <typename Rows, typename Use>
    HL_FN bool solve_ring(int first, int last, const Rows& row, const Pair& joint, const Use& use) const
    {
        const Chunks chunks = even_chunks(last - first);
        const ChunkSlots slot(chunks);
        const LinkColumns<RingLink> places{room_, stride_, stride_};
        if (!solve_open<RingLink>(
                last - first, [&](int k, bool& open) { return row(first + k, open); },
                [&](int k, const RingPair& x) { places.set_right(slot(k), x); }))
            return false;
        const Pair passes = through_joint(places.right(slot(0)), places.right(slot(last - first - 1)), joint);
        threads_.all([&](int t) {
            for (int k = chunks.begin(t); k < chunks.end(t); ++k) use(first + k, places.right(slot(k)).with(passes));
        });
        return true;
    }

    template <typename Pivot, typename Joint, typename PlaceOf>
    HL_FN void factor_pairs(int first, int last, const Pivot& pivot, const Joint&, const PlaceOf& place_of) const
    {
        each(first, last, [&](int i) { place_of(i).write(pivot(i)); }); // threads side by side eliminate anew each time
    }
    template <typename Factor, typename Joint, typename Right, typename Use>
    HL_FN void solve_factored(int first, int last, const Factor& factor, const Joint& joint, const Right& right, const Use& use) const
    {
        solve_pairs(
            first, last,
            [&](int i, bool& open) -> PairEquation {
                open = true;
                const Pair before = i > first ? joint(i - 1) : Pair{}, next = i + 1 < last ? joint(i) : Pair{};
                const SymmetricMatrix m = factor(i);
                return {{-before.first, -before.second}, {m.a, m.b, m.b, m.d}, {-next.first, -next.second}, right(i)};
            },
            use);
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
    /// In an order that the number of threads decides.
    template <typename F, typename Join> HL_FN double fold(int first, int last, const F& f, const Join& join) const
    {
        threads_.all([&](int t) {
            double own = 0;
            for (int i = first + t; i < last; i += threads_.size()) own = join(own, f(i));
            links_[t] = own;
        });
        for (int apart = 1; apart < threads_.size(); apart *= 2)
            threads_.all([&](int t) {
                if (t % (2 * apart) == 0 && t + apart < threads_.size()) links_[t] = join(links_[t], links_[t + apart]);
            });
        const double all = links_[0];
        threads_.all([](int) {}); // before the next call writes there
        return all;
    }
    template <typename Own, typename Rows, typename Use> HL_FN bool solve_open(int count, const Rows& row, const Use& use) const
    {
        const Chunks chunks = even_chunks(count);
        const ChunkSlots slot(chunks);
        const LinkColumns<Own> places{room_, stride_, stride_};
        const bool any_open = threads_.any([&](int t) {
            bool open = false;
            links<Own>(1).set(t, eliminate(places, slot, chunks.begin(t), chunks.end(t), [&](int k) { return link_of(row(k, open)); }));
            return open;
        });
        if (!any_open) return false;
        const LinkColumns<Own> solved = solve_chunks(places, slot, chunks);
        threads_.all(
            [&](int t) { substitute(places, slot, chunks.begin(t), chunks.end(t), solved.at(t - 1).right, solved.at(t).right, use); });
        return true;
    }
    HL_FN Chunks even_chunks(int places) const { return {places, places > 0 ? (places + threads_.size() - 1) / threads_.size() : 1}; }
    /// So that the threads of a warp find their places in different banks of shared memory.
    HL_FN Chunks odd_chunks(int places) const { return {places, even_chunks(places).each | 1}; }
    template <typename Own> HL_FN LinkColumns<Own> links(int which) const
    {
        return {links_ + LinkColumns<Own>::numbers * which * threads_.size(), threads_.size(), threads_.size()};
    }

    /// The last of each chunk, as the right of links.
    template <typename Own, typename Slot>
    HL_FN LinkColumns<Own> solve_chunks(const LinkColumns<Own>& places, const Slot& slot, const Chunks& chunks) const
    {
        const bool coupled = threads_.any([&](int t) {
            const Own own = join(places, slot, chunks.begin(t), chunks.end(t), links<Own>(1).at(t + 1));
            links<Own>(0).set(t, own);
            return own.is_coupled();
        });
        return links<Own>(reduce<Own>(chunks.count(), coupled));
    }
    /// Leaves each place by the last of the chunk before and by the next place; returns the chunk's first by the last of the chunk before
    /// and its own last.
    template <typename M, typename V, typename Slot, typename LinkOf>
    HL_FN static Link<M, V> eliminate(const LinkColumns<Link<M, V>>& places, const Slot& slot, int begin, int end, const LinkOf& link)
    {
        if (begin >= end) return {};
        Link<M, V> before = link(begin);
        places.set(slot(begin), before);
        Link<M, V> first{{}, -one_of(M{}), {}}; // so far by the place itself
        for (int i = begin + 1; i < end; ++i) {
            first = {first.lower - first.upper * before.lower, -first.upper * before.upper, first.right - first.upper * before.right};
            const Link<M, V> own = link(i);
            const M scale = inverse_of(one_of(M{}) - own.lower * before.upper);
            before = {scaled(-own.lower * before.lower, scale), scaled(own.upper, scale),
                      scaled(own.right - own.lower * before.right, scale)};
            places.set(slot(i), before);
        }
        return first;
    }
    /// The chunk's last by those of the chunks before and after.
    template <typename M, typename V, typename Slot>
    HL_FN static Link<M, V> join(const LinkColumns<Link<M, V>>& places, const Slot& slot, int begin, int end,
                                 const Link<M, V>& first_of_next)
    {
        if (begin >= end) return {};
        const Link<M, V> own = places.at(slot(end - 1));
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
    /// Calls use(place, x) from the chunk's last place, whose x is known, to its first.
    template <typename M, typename V, typename Slot, typename Use>
    HL_FN static void substitute(const LinkColumns<Link<M, V>>& places, const Slot& slot, int begin, int end, const V& before, V last,
                                 const Use& use)
    {
        for (int i = end - 1; i >= begin; --i) {
            if (i < end - 1) {
                const Link<M, V> own = places.at(slot(i));
                last = own.right - own.lower * before - own.upper * last;
            }
            use(i, last);
        }
    }

    /// From a place on, along the line or back.
    template <typename Keep, typename Pass, typename Give>
    HL_FN void carry_one_way(int places, int from, int step, const Keep& keep, const Pass& pass, const Give& give) const
    {
        const Chunks chunks = odd_chunks(places);
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
    int of_link_;
    double* room_;
    int stride_;
    double* links_;
};

} // namespace hygroloom
