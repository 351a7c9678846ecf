// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/drawdown.h"

#include "core/design/numbering.h"

#include <algorithm>
#include <string_view>

namespace hygroloom {

namespace {

/// Which shafts are up at a pick, one byte each.
void raise(const Draft& draft, std::size_t pick, std::vector<std::uint8_t>& raised)
{
    std::fill(raised.begin(), raised.end(), std::uint8_t(!draft.rising_shed));
    const auto name = [&](const std::vector<int>& shafts) {
        for (int shaft : shafts) raised[shaft] = draft.rising_shed;
    };
    if (!draft.liftplan.empty()) {
        name(draft.liftplan[pick]);
    } else {
        for (int treadle : draft.treadling[pick]) name(draft.tie_up[treadle]);
    }
}

} // namespace

Weave drawdown(const Draft& draft)
{
    const std::size_t ends = draft.threading.size(), picks = static_cast<std::size_t>(draft.picks());
    std::vector<std::uint8_t> up(ends * picks);
    std::vector<std::uint8_t> raised(static_cast<std::size_t>(draft.shafts));
    for (std::size_t pick = 0; pick < picks; ++pick) {
        raise(draft, pick, raised);
        std::uint8_t* row = up.data() + pick * ends;
        for (std::size_t end = 0; end < ends; ++end)
            for (int shaft : draft.threading[end]) row[end] |= raised[shaft];
    }
    return {static_cast<int>(ends), static_cast<int>(picks), std::move(up)};
}

Weave weave_from_draft(Draft draft)
{
    Weave weave = drawdown(draft);
    weave.draft_ = std::make_shared<const Draft>(std::move(draft));
    return weave;
}

Draft smallest_draft(const Weave& weave)
{
    const std::size_t ends = static_cast<std::size_t>(weave.ends()), picks = static_cast<std::size_t>(weave.picks());
    const std::vector<std::uint8_t>& up = weave.crossings();
    std::string turned(ends * picks, '\0'); // the ends one after the other
    for (std::size_t pick = 0; pick < picks; ++pick)
        for (std::size_t end = 0; end < ends; ++end) turned[end * picks + pick] = static_cast<char>(up[pick * ends + end]);

    Draft draft;
    Numbering<std::string_view> columns, rows;
    std::vector<std::size_t> first_end; // of each shaft
    for (std::size_t end = 0; end < ends; ++end) {
        const auto [shaft, fresh] = columns.of(std::string_view(turned).substr(end * picks, picks));
        if (fresh) first_end.push_back(end);
        draft.threading.push_back({shaft});
    }
    draft.shafts = columns.size();
    const std::string_view all(reinterpret_cast<const char*>(up.data()), up.size());
    for (std::size_t pick = 0; pick < picks; ++pick) {
        const auto [treadle, fresh] = rows.of(all.substr(pick * ends, ends));
        draft.treadling.push_back({treadle});
        if (!fresh) continue;
        std::vector<int>& tied = draft.tie_up.emplace_back();
        for (int shaft = 0; shaft < draft.shafts; ++shaft)
            if (up[pick * ends + first_end[shaft]]) tied.push_back(shaft);
    }
    draft.treadles = rows.size();
    return draft;
}

} // namespace hygroloom
