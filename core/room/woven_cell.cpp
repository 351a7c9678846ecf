// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/room/woven_cell.h"

namespace hygroloom {
namespace {

/// Whether so many ends on each of the first picks is the same so many picks higher.
bool repeats(const Weave& weave, int ends, int picks, int of_picks)
{
    for (int end = 0; end < weave.ends(); ++end)
        for (int pick = 0; pick < of_picks; ++pick)
            if (weave.warp_up(end + ends, pick + picks) != weave.warp_up(end, pick)) return false;
    return true;
}

} // namespace

std::optional<WovenCell> smallest_cell(const Weave& weave, int most)
{
    int picks = 1;
    while (picks <= most && !(weave.picks() % picks == 0 && repeats(weave, 0, picks, weave.picks()))) ++picks;
    for (int ends = 1; ends * picks <= most; ++ends)
        for (int shift = 0; shift < picks && weave.ends() % ends == 0; ++shift)
            if (repeats(weave, ends, shift, picks)) return WovenCell{ends, picks, shift};
    return {};
}

} // namespace hygroloom
