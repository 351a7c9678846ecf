// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace hygroloom {
namespace {

/// Levenshtein's distance, one row at a time.
std::size_t distance(const std::string& a, const std::string& b)
{
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row.back();
}

} // namespace

std::string nearest_word(const std::string& word, const std::vector<std::string>& words)
{
    std::string nearest;
    if (word.size() > 100) return nearest;
    std::size_t least = std::max<std::size_t>(2, word.size() / 2) + 1;
    for (const std::string& candidate : words)
        if (const std::size_t far = distance(word, candidate); far < least) {
            least = far;
            nearest = candidate;
        }
    return nearest;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& words)
{
    const std::string near = nearest_word(word, words);
    return near.empty() ? "." : "; did you mean \"" + near + "\"?";
}

std::string listed(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

std::string listed_in_quotes(const std::vector<std::string>& words)
{
    return words.empty() ? std::string() : fmt::format("\"{}\"", fmt::join(words, "\", \""));
}

} // namespace hygroloom
