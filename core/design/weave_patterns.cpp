// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Weaves by name: reads the name and lists the catalogue. The weaves are made in weave_grounds.cpp and weave_effects.cpp.
#include "core/design/pattern_words.h"

#include "core/base/error.h"

#include <charconv>
#include <functional>
#include <sstream>

namespace hygroloom {

namespace {

std::vector<int> numbers(const PatternWords& words, const std::string& text)
{
    std::vector<int> values;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        int value = 0;
        const auto [next, failure] = std::from_chars(at, end, value);
        if (failure != std::errc() || value < 1) refuse_pattern(words, "needs whole numbers of 1 or more, parted by \"/\".");
        values.push_back(value);
        if (value > largest_repeat || values.size() > largest_repeat)
            refuse_pattern(words, "is larger than " + std::to_string(largest_repeat) + " ends or picks.");
        if (next == end) return values;
        if (*next != '/') refuse_pattern(words, "needs whole numbers of 1 or more, parted by \"/\".");
        at = next + 1;
    }
}

bool begins_with_digit(const std::string& word) { return !word.empty() && word[0] >= '0' && word[0] <= '9'; }

PatternWords words_of(const std::string& pattern)
{
    PatternWords words{pattern, {}, {}, {}};
    std::istringstream stream(pattern);
    std::string word;
    stream >> words.kind;
    if (words.kind == "broken" || words.kind == "pointed" || words.kind == "mock") {
        if (stream >> word) words.kind += " " + word;
    }
    if (!(stream >> word)) return words;
    if (begins_with_digit(word))
        words.runs = numbers(words, word);
    else
        words.rest.push_back(word);
    while (stream >> word) words.rest.push_back(word);
    return words;
}

Weave plain(const PatternWords& words)
{
    if (!words.runs.empty() || !words.rest.empty()) refuse_pattern(words, "has words too many.");
    return {};
}

} // namespace

void refuse_pattern(const PatternWords& words, const std::string& why)
{
    throw Error("The weave pattern \"" + words.text + "\" " + why +
                " Forms: \"plain\", \"twill 2/1 Z\" (ups/downs, also \"twill 2/1/1/2 S\"), \"twill 3/2 Z steep 2\" (picks per end), "
                "\"twill 3/2 Z reclined 2\" (ends per pick), \"broken twill 3/1 Z\", \"pointed twill 2/2 Z 4\" (ends to the point), "
                "\"herringbone 2/2 Z 8\" (ends to the cut), \"diamond 2/2 4\", \"satin 5/2\" (ends/step, warp on top), "
                "\"sateen 5/2\" (weft on top), \"satin 4\" and \"satin 6\" (irregular), \"basket 2/2\" (ends/picks), \"rib 2/2 warp\", "
                "\"rib 2/2 weft\", \"waffle 8\" (ends, even), \"huckaback 5\" and \"mock leno 3\" (ends of a quarter, odd), "
                "\"crepe 16 seed 1\" (ends, even), \"birdseye\", \"sharkskin\", \"ripstop 12\" (ends from one double thread to the next).");
}

std::string joined(const std::vector<int>& values)
{
    std::string text;
    for (int value : values) text.append(text.empty() ? "" : "/").append(std::to_string(value));
    return text;
}

std::vector<std::uint8_t> ups_and_downs(const std::vector<int>& runs)
{
    std::vector<std::uint8_t> ups;
    for (std::size_t run = 0; run < runs.size(); ++run) ups.insert(ups.end(), static_cast<std::size_t>(runs[run]), run % 2 == 0);
    return ups;
}

Weave weave_from_pattern(const std::string& pattern)
{
    const PatternWords words = words_of(pattern);
    using Maker = std::function<Weave(const PatternWords&)>;
    static const std::vector<std::pair<std::string, Maker>> makers{
        {"plain", plain},
        {"twill", twill},
        {"broken twill", broken_twill},
        {"pointed twill", pointed_twill},
        {"herringbone", herringbone},
        {"diamond", diamond},
        {"satin", [](const PatternWords& w) { return satin(w, true); }},
        {"sateen", [](const PatternWords& w) { return satin(w, false); }},
        {"basket", basket},
        {"rib", rib},
        {"waffle", waffle},
        {"huckaback", huckaback},
        {"mock leno", mock_leno},
        {"crepe", crepe},
        {"birdseye", birdseye},
        {"sharkskin", sharkskin},
        {"ripstop", ripstop},
    };
    for (const auto& [kind, make] : makers)
        if (kind == words.kind) return make(words);
    refuse_pattern(words, "is not known.");
}

const std::vector<WeaveGroup>& weave_catalogue()
{
    static const std::vector<WeaveGroup> groups{
        {"Plain, baskets and ribs",
         {"plain", "basket 2/2", "basket 2/1", "basket 3/3", "rib 2/2 warp", "rib 3/3 warp", "rib 2/2 weft", "rib 3/3 weft"}},
        {"Twills",
         {"twill 2/1 Z", "twill 1/2 Z", "twill 2/1 S", "twill 2/2 Z", "twill 2/2 S", "twill 3/1 Z", "twill 1/3 Z", "twill 3/1 S",
          "twill 3/3 Z", "twill 4/4 Z", "twill 3/2 Z steep 2", "twill 3/2 Z reclined 2"}},
        {"Broken and pointed twills",
         {"broken twill 3/1 Z", "broken twill 2/2 Z", "pointed twill 2/2 Z 4", "pointed twill 3/1 Z 8", "herringbone 2/2 Z 8",
          "herringbone 2/1 Z 6", "diamond 2/2 4", "diamond 3/3 6"}},
        {"Satins", {"satin 4", "satin 5/2", "satin 5/3", "satin 6", "satin 7/2", "satin 8/3", "satin 8/5"}},
        {"Sateens", {"sateen 4", "sateen 5/2", "sateen 6", "sateen 7/2", "sateen 8/3"}},
        {"Effects",
         {"waffle 6", "waffle 8", "huckaback 5", "mock leno 3", "mock leno 5", "crepe 16 seed 1", "birdseye", "sharkskin", "ripstop 12"}}};
    return groups;
}

const std::vector<std::string>& common_weave_patterns()
{
    static const std::vector<std::string> patterns = [] {
        std::vector<std::string> all;
        for (const WeaveGroup& group : weave_catalogue()) all.insert(all.end(), group.patterns.begin(), group.patterns.end());
        return all;
    }();
    return patterns;
}

} // namespace hygroloom
