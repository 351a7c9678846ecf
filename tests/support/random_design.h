// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Designs from the corners of what validate() accepts, and a little beyond: about one in five is refused.
#pragma once

#include "core/base/random.h"
#include "core/design/design.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace hygroloom {

constexpr double longest_of_most = 5; ///< s of simulated time; one run in ten goes on to its end

/// Numbers of one design, from its index alone.
class Dice {
public:
    explicit Dice(int design) : design_(static_cast<std::uint64_t>(design)) {}
    double share() { return random_uniform(20261121, design_, count_++); }
    double between(double low, double high) { return low + (high - low) * share(); }
    double by_decades(double low, double high) { return low * std::pow(high / low, share()); }
    bool chance(double probability) { return share() < probability; }
    template <typename T> T one_of(const std::vector<T>& values)
    {
        return values[static_cast<std::size_t>(share() * static_cast<double>(values.size()))];
    }

private:
    std::uint64_t design_, count_ = 0;
};

/// From its index alone. simulated: how long it is worth being run, s.
Design random_design(int index, double& simulated);

} // namespace hygroloom
