// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Bytes as letters (RFC 4648), for pictures and buffers within texts.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hygroloom {

inline std::string base64_of(std::string_view bytes)
{
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) { return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u; };
        const unsigned three = byte(0) << 16 | byte(1) << 8 | byte(2);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63u];
    }
    return text;
}

/// None where it is no such text.
inline std::optional<std::string> from_base64(std::string_view text)
{
    while (text.ends_with('=')) text.remove_suffix(1);
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    unsigned bits = 0;
    int known = 0;
    for (const char c : text) {
        unsigned six = 64;
        if (c >= 'A' && c <= 'Z') six = static_cast<unsigned>(c - 'A');
        if (c >= 'a' && c <= 'z') six = static_cast<unsigned>(c - 'a') + 26;
        if (c >= '0' && c <= '9') six = static_cast<unsigned>(c - '0') + 52;
        if (c == '+' || c == '-') six = 62;
        if (c == '/' || c == '_') six = 63;
        if (six == 64) return {};
        bits = (bits << 6 | six) & 0xffffff;
        known += 6;
        if (known >= 8) bytes += static_cast<char>(bits >> (known -= 8) & 0xff);
    }
    return bytes;
}

} // namespace hygroloom
