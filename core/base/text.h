// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// UTF-8 texts, and counts of bytes and times as text.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hygroloom {

/// The beginning of a text, at most that many bytes and whole characters only.
inline std::string cut_text(std::string_view text, std::size_t most)
{
    if (text.size() <= most) return std::string(text);
    while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
    return std::string(text.substr(0, most));
}

/// A field of a CSV, in quotes, on one line.
inline std::string quoted_csv_field(const std::string& text)
{
    std::string inside;
    for (const char c : text) inside += c == '"' ? "\"\"" : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
    return '"' + inside + '"';
}
/// The same, in quotes only where it needs them.
inline std::string csv_field(const std::string& text)
{
    const bool is_comment = text.starts_with('#');
    return !is_comment && text.find_first_of(",;\"\n\r") == std::string::npos ? text : quoted_csv_field(text);
}

/// Characters of UTF-8: one of several bytes counts once.
inline std::size_t width_as_seen(const std::string& text)
{
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

/// Columns as wide as their widest cell; the first is aligned left, the others right. A row of two is a name and a sentence.
inline std::string aligned_columns(const std::vector<std::vector<std::string>>& rows)
{
    std::vector<std::size_t> widths;
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i == widths.size()) widths.push_back(0);
            if (row.size() > 2 || i != 1) widths[i] = std::max(widths[i], width_as_seen(row[i]));
        }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string blanks(widths[i] - std::min(widths[i], width_as_seen(row[i])), ' ');
            line += (i == 0 ? "" : "  ") + (i == 0 || row.size() == 2 ? row[i] + blanks : blanks + row[i]);
        }
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
}

/// The decimals with which a number shows as many digits as count, none of a large one: of 2 digits 4.8, 0.55, 17, 310.
inline int decimals_for(double number, int digits)
{
    return number == 0 ? 0 : std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(number)))), 0, 9);
}

/// A number with as many digits as count: with 2 "4.8", "0.55", "17", "310".
inline std::string rounded_text(double number, int digits)
{
    char text[400]; // of any double
    std::snprintf(text, sizeof text, "%.*f", decimals_for(number, digits), number);
    return text;
}

/// The same without zeros that say nothing; the very large and the very small with a power of ten: "3.15", "30", "12350", "1e-13".
inline std::string brief_text(double number, int digits)
{
    char small[40];
    std::snprintf(small, sizeof small, "%.*g", digits, number);
    if (!(std::abs(number) >= 1e-4 && std::abs(number) < 1e7)) return small;
    std::string text = rounded_text(number, digits);
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

/// A count of bytes in the unit in which people read it.
struct ByteCount {
    double number;
    int decimals;
    const char* unit;
};

inline ByteCount byte_count(double bytes)
{
    constexpr double least = 0.9995; // 999.6 kB are 1.0 MB
    const double size = bytes >= least * 1e9 ? 1e9 : bytes >= least * 1e6 ? 1e6 : 1e3;
    const double number = bytes / size;
    return {number, number < 9.95 ? 1 : 0, size == 1e9 ? "GB" : size == 1e6 ? "MB" : "kB"};
}

/// "0.8 kB", "820 kB", "3.4 MB", "34 MB", "1.2 GB".
inline std::string bytes_text(double bytes)
{
    const ByteCount count = byte_count(bytes);
    char text[400]; // of any double
    std::snprintf(text, sizeof text, "%.*f %s", count.decimals, count.number, count.unit);
    return text;
}

/// Decimals of all times of a run of this duration (s): 3.20 of 10, 3600 of 3600.
inline int decimals_of_moments(double duration) { return duration >= 1000 ? 0 : duration >= 100 ? 1 : duration >= 1 ? 2 : 3; }

/// Seconds that work will still take when a share of it took these seconds; none below a share of 2 % or a time of 2 s.
inline std::optional<double> time_left(double share, double seconds)
{
    constexpr double least_share = 0.02, least_seconds = 2;
    if (!(share >= least_share && seconds >= least_seconds)) return std::nullopt;
    return seconds * (1 - share) / share;
}

} // namespace hygroloom
