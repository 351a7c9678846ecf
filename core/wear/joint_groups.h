// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What joints between crossings have in common, through seams and between layers: conductances, and groups that can act at once.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace hygroloom {

/// Of two conductances.
inline double in_series(double a, double b) { return a > 0 && b > 0 ? a * b / (a + b) : 0.0; }

/// Groups (ClothSeams or ClothLayers) in none of which a crossing comes twice. crossings_of: the two of a joint.
template <typename Groups, typename Joint, typename CrossingsOf>
Groups grouped(int crossings, std::vector<Joint> joints, const CrossingsOf& crossings_of)
{
    Groups groups;
    while (!joints.empty()) {
        std::vector<std::uint8_t> taken(static_cast<std::size_t>(crossings), 0);
        std::vector<Joint> left;
        for (const Joint& joint : joints) {
            const std::array<int, 2> both = crossings_of(joint);
            std::uint8_t &a = taken[static_cast<std::size_t>(both[0])], &b = taken[static_cast<std::size_t>(both[1])];
            if (a || b) {
                left.push_back(joint);
                continue;
            }
            a = b = 1;
            groups.joints.push_back(joint);
        }
        groups.group_ends.push_back(static_cast<int>(groups.joints.size()));
        joints = std::move(left);
    }
    return groups;
}

} // namespace hygroloom
