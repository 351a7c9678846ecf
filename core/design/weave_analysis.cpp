// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/weave_analysis.h"

#include "core/design/drawdown.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <numeric>

namespace hygroloom {

namespace {

/// The threads of one system one after the other, each a row of its crossings.
struct Threads {
    std::size_t count = 0;
    std::size_t length = 0;
    const std::uint8_t* up = nullptr;

    const std::uint8_t* of(std::size_t thread) const { return up + thread * length; }
    bool alike(int a, int b) const { return std::memcmp(of(static_cast<std::size_t>(a)), of(static_cast<std::size_t>(b)), length) == 0; }
};

std::vector<std::uint8_t> turned(const Weave& weave)
{
    constexpr std::size_t block = 32; // cells at a time, so that both sides stay in the cache
    const std::size_t ends = static_cast<std::size_t>(weave.ends()), picks = static_cast<std::size_t>(weave.picks());
    const std::vector<std::uint8_t>& up = weave.crossings();
    std::vector<std::uint8_t> result(up.size());
    for (std::size_t first = 0; first < ends; first += block)
        for (std::size_t pick = 0; pick < picks; ++pick)
            for (std::size_t end = first; end < std::min(ends, first + block); ++end) result[end * picks + pick] = up[pick * ends + end];
    return result;
}

/// Floats of all threads: those of ones and those of zeros. Returns the changes of side.
long count_floats(const Threads& threads, Floats& ones, Floats& zeros, std::vector<int>& unbound)
{
    ones.count.assign(threads.length + 1, 0);
    zeros.count.assign(threads.length + 1, 0);
    long changes = 0;
    for (std::size_t thread = 0; thread < threads.count; ++thread) {
        const std::uint8_t* up = threads.of(thread);
        std::size_t first = 0; // of a float
        while (first < threads.length && up[first] == up[threads.length - 1]) ++first;
        if (first == threads.length) {
            unbound.push_back(static_cast<int>(thread));
            continue;
        }
        std::size_t run = 0;
        for (std::size_t step = 0; step < threads.length; ++step) {
            std::size_t at = first + step, next = at + 1;
            if (at >= threads.length) at -= threads.length;
            if (next >= threads.length) next -= threads.length;
            ++run;
            if (up[at] == up[next]) continue;
            ++changes;
            ++(up[at] ? ones : zeros).count[run];
            run = 0;
        }
    }
    for (Floats* floats : {&ones, &zeros}) {
        while (floats->count.size() > 1 && floats->count.back() == 0) floats->count.pop_back();
        floats->longest = static_cast<int>(floats->count.size()) - 1;
    }
    return changes;
}

std::vector<long> sorted_sums(const Threads& threads, bool of_ones)
{
    std::vector<long> sums(threads.count);
    for (std::size_t thread = 0; thread < threads.count; ++thread) {
        const long ones = std::accumulate(threads.of(thread), threads.of(thread) + threads.length, 0L);
        sums[thread] = of_ones ? ones : static_cast<long>(threads.length) - ones;
    }
    std::sort(sums.begin(), sums.end(), std::greater<>());
    return sums;
}

/// Clapham (1980): r ends and s picks lie over all the others just when the r ends and s picks that are most often on top are on top
/// r picks + s ends - r s times, the most that is possible. Between two such cuts lies a cloth, or loose threads of one system.
void count_cloths(const Threads& ends, const Threads& picks, WeaveAnalysis& analysis)
{
    const std::vector<long> end_ups = sorted_sums(ends, true), pick_ups = sorted_sums(picks, false);
    const long m = static_cast<long>(picks.count), n = static_cast<long>(ends.count);
    analysis.cloths = 0;
    long from_r = 0, from_s = 0, ups_r = 0;
    for (long r = 0; r <= n; ++r) {
        if (r > 0) ups_r += end_ups[r - 1];
        long ups = ups_r;
        for (long s = 0; s <= m; ++s) {
            if (s > 0) ups += pick_ups[s - 1];
            if (ups != r * m + s * n - r * s) continue;
            if (r > from_r && s > from_s && ++analysis.cloths == 1) {
                analysis.top_ends = static_cast<int>(r - from_r);
                analysis.top_picks = static_cast<int>(s - from_s);
            }
            from_r = r;
            from_s = s;
        }
    }
}

} // namespace

WeaveAnalysis analyse(const Weave& weave)
{
    const std::vector<std::uint8_t> columns = turned(weave);
    const Threads picks{static_cast<std::size_t>(weave.picks()), static_cast<std::size_t>(weave.ends()), weave.crossings().data()};
    const Threads ends{picks.length, picks.count, columns.data()};
    WeaveAnalysis analysis;
    analysis.warp_interlacings = count_floats(ends, analysis.warp_face, analysis.warp_back, analysis.unbound_ends);
    analysis.weft_interlacings = count_floats(picks, analysis.weft_back, analysis.weft_face, analysis.unbound_picks);
    analysis.warp_up_share = static_cast<double>(std::accumulate(columns.begin(), columns.end(), 0L)) / static_cast<double>(columns.size());
    analysis.repeat_ends = dividing_period(weave.ends(), [&](int a, int b) { return ends.alike(a, b); });
    analysis.repeat_picks = dividing_period(weave.picks(), [&](int a, int b) { return picks.alike(a, b); });
    count_cloths(ends, picks, analysis);
    return analysis;
}

Weave reduced(const Weave& weave)
{
    const std::vector<std::uint8_t> columns = turned(weave);
    const Threads all_picks{static_cast<std::size_t>(weave.picks()), static_cast<std::size_t>(weave.ends()), weave.crossings().data()};
    const Threads all_ends{all_picks.length, all_picks.count, columns.data()};
    const int ends = dividing_period(weave.ends(), [&](int a, int b) { return all_ends.alike(a, b); });
    const int picks = dividing_period(weave.picks(), [&](int a, int b) { return all_picks.alike(a, b); });
    if (ends == weave.ends() && picks == weave.picks()) return weave;
    if (weave.draft()) {
        Draft draft = *weave.draft();
        draft.threading.resize(static_cast<std::size_t>(ends));
        (draft.liftplan.empty() ? draft.treadling : draft.liftplan).resize(static_cast<std::size_t>(picks));
        return weave_from_draft(std::move(draft));
    }
    std::vector<std::uint8_t> up;
    for (int pick = 0; pick < picks; ++pick) {
        const std::uint8_t* row = all_picks.of(static_cast<std::size_t>(pick));
        up.insert(up.end(), row, row + ends);
    }
    return {ends, picks, std::move(up)};
}

} // namespace hygroloom
