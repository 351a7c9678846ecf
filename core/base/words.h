// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Words that users give: which known one a misspelt one may have meant, and names that are still free.
#pragma once

#include <string>
#include <vector>

namespace hygroloom {

/// The known word with the fewest letters to change, or empty when more than half of the letters, and more than two, would change.
std::string nearest_word(const std::string& word, const std::vector<std::string>& words);

/// The end of a sentence that names an unknown word: "; did you mean "denim"?", or a full stop where no known word is near.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& words);

/// Of named things, in their order.
template <typename Items> std::vector<std::string> names_in(const Items& items)
{
    std::vector<std::string> names;
    for (const auto& item : items) names.push_back(item.name);
    return names;
}

/// "denim, poplin".
std::string listed(const std::vector<std::string>& words);
/// The same with each in quotation marks.
std::string listed_in_quotes(const std::vector<std::string>& words);

/// Of a place counted from 0, as yarns of stripes are named: A to Z, then AA, AB …
inline std::string letters_of(int place)
{
    const std::string last(1, static_cast<char>('A' + place % 26));
    return place < 26 ? last : letters_of(place / 26 - 1) + last;
}

/// The wish itself where it is free, else followed by the first number from 2 on that makes it free. taken(name): whether it is not.
template <typename Taken> std::string free_name(const std::string& wish, const Taken& taken)
{
    std::string name = wish;
    for (int number = 2; taken(name); ++number) name = wish + " " + std::to_string(number);
    return name;
}

} // namespace hygroloom
