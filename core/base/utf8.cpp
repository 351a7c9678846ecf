// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/utf8.h"

namespace hygroloom {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

/// Bytes of the character that begins there; 0: none does.
std::size_t length_at(std::string_view text, std::size_t at)
{
    const auto lead = static_cast<unsigned char>(text[at]);
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xC2 && lead < 0xE0 ? 2
                               : lead >= 0xE0 && lead < 0xF0 ? 3
                               : lead >= 0xF0 && lead < 0xF5 ? 4
                                                             : 0;
    if (length == 0 || at + length > text.size()) return 0;
    for (std::size_t k = 1; k < length; ++k)
        if ((static_cast<unsigned char>(text[at + k]) & 0xC0) != 0x80) return 0;
    const auto second = length > 1 ? static_cast<unsigned char>(text[at + 1]) : 0x80;
    const bool no_character = (lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) || (lead == 0xF0 && second < 0x90) ||
                              (lead == 0xF4 && second > 0x8F); // overlong, surrogate or beyond Unicode
    return no_character ? 0 : length;
}

/// C0 but for tab and line feed, DEL, and C1, which some terminals obey; Unicode's line breaks, and what turns the direction of a text.
bool is_control(std::string_view character)
{
    const auto lead = static_cast<unsigned char>(character[0]);
    if (character.size() == 3) return (character >= "\u2028" && character <= "\u202E") || (character >= "\u2066" && character <= "\u2069");
    if (character.size() == 2) return lead == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0;
    return character.size() == 1 && (lead == 0x7F || (lead < 0x20 && lead != '\t' && lead != '\n'));
}

template <typename Refuse> std::string repaired(std::string_view bytes, Refuse refuse)
{
    std::string text;
    text.reserve(bytes.size());
    for (std::size_t i = 0; i < bytes.size();) {
        const std::size_t length = length_at(bytes, i);
        const std::string_view character = bytes.substr(i, length);
        text += length == 0 || refuse(character) ? replacement : character;
        i += length == 0 ? 1 : length;
    }
    return text;
}

} // namespace

bool is_utf8(std::string_view text)
{
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = length_at(text, i);
        if (length == 0) return false;
        i += length;
    }
    return true;
}

std::string in_whole_utf8(std::string_view bytes)
{
    return is_utf8(bytes) ? std::string(bytes) : repaired(bytes, [](std::string_view) { return false; });
}

std::string printable(std::string_view bytes) { return repaired(bytes, is_control); }

std::string in_one_line(std::string_view bytes)
{
    return repaired(bytes, [](std::string_view character) { return is_control(character) || character == "\n"; });
}

} // namespace hygroloom
