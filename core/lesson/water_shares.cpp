// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/lesson/water_shares.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hygroloom {

WaterShares water_shares(const Ledger& ledger, double bound_at_start, int drops)
{
    WaterShares shares;
    shares.drops = drops;
    if (drops <= 0 || !(ledger.water_delivered > 0)) return shares;
    const double vapour_at_start = ledger.water_initial - bound_at_start;
    const std::array<double, 5> kg{ledger.water_liquid + ledger.water_vapour - vapour_at_start, ledger.water_bound - bound_at_start,
                                   ledger.water_evaporated, ledger.water_free, ledger.water_dripped};
    const std::array<int*, 5> into{&shares.in_yarns, &shares.in_fibres, &shares.in_air, &shares.standing, &shares.run_off};
    std::array<double, 5> tenths{};
    int sum = 0;
    for (std::size_t k = 0; k < kg.size(); ++k) {
        tenths[k] = 10.0 * drops * kg[k] / ledger.water_delivered;
        *into[k] = static_cast<int>(std::floor(tenths[k]));
        sum += *into[k];
    }
    std::array<std::size_t, 5> order{0, 1, 2, 3, 4};
    const auto rest = [&](std::size_t k) { return tenths[k] - std::floor(tenths[k]); };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rest(a) > rest(b); });
    const int left = std::clamp(10 * drops - sum, 0, static_cast<int>(order.size()));
    for (int k = 0; k < left; ++k) ++*into[order[static_cast<std::size_t>(k)]];
    return shares;
}

} // namespace hygroloom
