// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Numbers things as they first occur.
#pragma once

#include <map>
#include <utility>

namespace hygroloom {

/// Equal things share a number; the first is 0.
template <typename Thing> class Numbering {
public:
    /// The number, and whether it is a new one.
    std::pair<int, bool> of(const Thing& thing)
    {
        const auto [at, fresh] = numbers_.try_emplace(thing, static_cast<int>(numbers_.size()));
        return {at->second, fresh};
    }
    int size() const { return static_cast<int>(numbers_.size()); }

private:
    std::map<Thing, int> numbers_;
};

} // namespace hygroloom
