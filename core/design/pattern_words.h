// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the makers of named weaves share. For weave_patterns.cpp, weave_grounds.cpp and weave_effects.cpp.
#pragma once

#include "core/design/weave.h"

namespace hygroloom {

/// A pattern's text in pieces: "pointed twill 2/2 S 8" has kind "pointed twill", runs {2, 2}, direction S and count 8.
struct PatternWords {
    std::string text; ///< as given, for messages
    std::string kind;
    std::vector<int> runs;         ///< numbers parted by "/"; empty when none
    std::vector<std::string> rest; ///< words after them
};

/// Throws Error: "The weave pattern "..." why Forms: ...".
[[noreturn]] void refuse_pattern(const PatternWords& words, const std::string& why);

/// "2/1/1/2".
std::string joined(const std::vector<int>& values);

/// One repeat of ups and downs along a yarn, 1 = up.
std::vector<std::uint8_t> ups_and_downs(const std::vector<int>& runs);

template <typename Up> Weave filled(int ends, int picks, const std::string& name, Up warp_up)
{
    std::vector<std::uint8_t> up;
    up.reserve(static_cast<std::size_t>(ends) * static_cast<std::size_t>(picks));
    for (int pick = 0; pick < picks; ++pick)
        for (int end = 0; end < ends; ++end) up.push_back(warp_up(end, pick));
    return {ends, picks, std::move(up), name};
}

// Grounds: twills, satins, baskets and ribs.
Weave twill(const PatternWords& words); ///< also steep and reclined
Weave broken_twill(const PatternWords& words);
Weave pointed_twill(const PatternWords& words);
Weave herringbone(const PatternWords& words);
Weave diamond(const PatternWords& words);
Weave satin(const PatternWords& words, bool warp_on_top);
Weave basket(const PatternWords& words);
Weave rib(const PatternWords& words);

// Effects.
Weave waffle(const PatternWords& words);
Weave huckaback(const PatternWords& words);
Weave mock_leno(const PatternWords& words);
Weave crepe(const PatternWords& words);
Weave birdseye(const PatternWords& words);
Weave sharkskin(const PatternWords& words);
Weave ripstop(const PatternWords& words);

constexpr int longest_crepe_float = 3; ///< crossings

} // namespace hygroloom
