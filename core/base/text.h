// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// UTF-8 texts.
#pragma once

#include <string>
#include <string_view>

namespace hygroloom {

/// The beginning of a text, at most so many bytes and no half of a character.
inline std::string cut_text(std::string_view text, std::size_t most)
{
    if (text.size() <= most) return std::string(text);
    while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
    return std::string(text.substr(0, most));
}

} // namespace hygroloom
