// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Colours in files: "#rrggbb".
#pragma once

#include "core/design/yarn.h"

#include <fmt/format.h>

#include <string>

namespace hygroloom {

inline std::string text_of(const Color& color) { return fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue); }

/// none: the text is no colour.
inline std::optional<Color> color_of(const std::string& text)
{
    if (text.size() != 7 || text[0] != '#' || text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos) return {};
    const auto part = [&](std::size_t at) { return static_cast<std::uint8_t>(std::stoi(text.substr(at, 2), nullptr, 16)); };
    return Color{part(1), part(3), part(5)};
}

} // namespace hygroloom
