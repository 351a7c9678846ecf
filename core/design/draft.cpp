// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/draft.h"

#include "core/design/numbering.h"

#include <algorithm>

namespace hygroloom {

namespace {

using Lists = std::vector<std::vector<int>>;

std::string fault_in_lists(const Lists& lists, const char* key, const char* what, int count)
{
    for (std::size_t i = 0; i < lists.size(); ++i)
        for (int value : lists[i])
            if (value < 0 || value >= count)
                return std::string(key) + "[" + std::to_string(i) + "]: A " + what + " must be from 1 to " + std::to_string(count) +
                       "; given is " + std::to_string(value + 1LL) + ".";
    return {};
}

std::string out_of_range(const char* key, const char* what, long least, long most, long given)
{
    return std::string(key) + ": The number of " + what + " must be from " + std::to_string(least) + " to " + std::to_string(most) +
           "; given is " + std::to_string(given) + ".";
}

} // namespace

std::string fault_in(const Draft& draft, int most_threads)
{
    if (draft.shafts < 1 || draft.shafts > most_shafts) return out_of_range("shafts", "shafts", 1, most_shafts, draft.shafts);
    if (draft.ends() < 1 || draft.ends() > most_threads) return out_of_range("threading", "ends", 1, most_threads, draft.ends());
    std::string fault = fault_in_lists(draft.threading, "threading", "shaft", draft.shafts);
    if (!fault.empty()) return fault;
    if (!draft.liftplan.empty()) {
        if (!draft.treadling.empty() || !draft.tie_up.empty() || draft.treadles != 0)
            return "liftplan: A draft has either a liftplan, or treadles with a tie-up and a treadling.";
        if (draft.picks() > most_threads) return out_of_range("liftplan", "picks", 1, most_threads, draft.picks());
        return fault_in_lists(draft.liftplan, "liftplan", "shaft", draft.shafts);
    }
    if (draft.treadles < 1 || draft.treadles > most_shafts) return out_of_range("treadles", "treadles", 1, most_shafts, draft.treadles);
    if (draft.tie_up.size() != static_cast<std::size_t>(draft.treadles))
        return "tie_up: Each of the " + std::to_string(draft.treadles) + " treadles needs its list of shafts; given are " +
               std::to_string(draft.tie_up.size()) + ".";
    if (draft.picks() < 1 || draft.picks() > most_threads) return out_of_range("treadling", "picks", 1, most_threads, draft.picks());
    fault = fault_in_lists(draft.tie_up, "tie_up", "shaft", draft.shafts);
    return fault.empty() ? fault_in_lists(draft.treadling, "treadling", "treadle", draft.treadles) : fault;
}

Draft with_liftplan(const Draft& draft)
{
    if (!draft.liftplan.empty()) return draft;
    Draft lifted = draft;
    lifted.treadles = 0;
    lifted.tie_up.clear();
    lifted.treadling.clear();
    for (const std::vector<int>& treadles : draft.treadling) {
        std::vector<int>& shafts = lifted.liftplan.emplace_back();
        for (int treadle : treadles) {
            const std::vector<int>& tied = draft.tie_up[treadle];
            shafts.insert(shafts.end(), tied.begin(), tied.end());
        }
        std::sort(shafts.begin(), shafts.end());
        shafts.erase(std::unique(shafts.begin(), shafts.end()), shafts.end());
    }
    return lifted;
}

Draft with_tie_up(const Draft& draft)
{
    const Draft lifted = with_liftplan(draft);
    Draft tied = lifted;
    tied.liftplan.clear();
    Numbering<std::vector<int>> lifts;
    for (std::vector<int> shafts : lifted.liftplan) {
        std::sort(shafts.begin(), shafts.end());
        shafts.erase(std::unique(shafts.begin(), shafts.end()), shafts.end());
        const auto [treadle, fresh] = lifts.of(shafts);
        if (fresh) tied.tie_up.push_back(shafts);
        tied.treadling.push_back({treadle});
    }
    tied.treadles = lifts.size();
    return tied;
}

} // namespace hygroloom
