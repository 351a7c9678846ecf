// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Weaves by name. Pick 0 is the first pick, end 0 the leftmost end; a Z line rises to the right.
#include "core/design/weave.h"

#include "core/base/error.h"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <sstream>

namespace hygroloom {

namespace {

[[noreturn]] void refuse(const std::string& pattern, const std::string& why)
{
    throw Error("The weave pattern \"" + pattern + "\" " + why +
                " Forms: \"plain\", \"twill 2/1 Z\" (ups/downs, also \"twill 2/1/1/2 S\"), \"satin 5/2\" (ends/step, warp on top), "
                "\"sateen 5/2\" (weft on top), \"basket 2/2\" (ends/picks), \"rib 2/2 warp\", \"rib 2/2 weft\".");
}

std::vector<int> numbers(const std::string& pattern, const std::string& text)
{
    std::vector<int> values;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        int value = 0;
        const auto [next, failure] = std::from_chars(at, end, value);
        if (failure != std::errc() || value < 1) refuse(pattern, "needs whole numbers of 1 or more, parted by \"/\".");
        values.push_back(value);
        if (value > largest_repeat || values.size() > largest_repeat)
            refuse(pattern, "is larger than " + std::to_string(largest_repeat) + " ends or picks.");
        if (next == end) return values;
        if (*next != '/') refuse(pattern, "needs whole numbers of 1 or more, parted by \"/\".");
        at = next + 1;
    }
}

std::string joined(const std::vector<int>& values)
{
    std::string text;
    for (int value : values) text.append(text.empty() ? "" : "/").append(std::to_string(value));
    return text;
}

template <typename Up> Weave filled(int ends, int picks, const std::string& name, Up warp_up)
{
    std::vector<std::uint8_t> up;
    up.reserve(static_cast<std::size_t>(ends) * static_cast<std::size_t>(picks));
    for (int pick = 0; pick < picks; ++pick)
        for (int end = 0; end < ends; ++end) up.push_back(warp_up(end, pick));
    return {ends, picks, std::move(up), name};
}

/// One repeat of ups and downs along a yarn, 1 = up.
std::vector<std::uint8_t> sequence(const std::vector<int>& runs)
{
    std::vector<std::uint8_t> ups;
    for (std::size_t run = 0; run < runs.size(); ++run) ups.insert(ups.end(), static_cast<std::size_t>(runs[run]), run % 2 == 0);
    return ups;
}

Weave twill(const std::string& pattern, const std::vector<int>& runs, const std::string& direction)
{
    if (runs.size() % 2 != 0) refuse(pattern, "needs as many downs as ups.");
    if (direction != "Z" && direction != "S") refuse(pattern, "runs Z or S.");
    const int size = std::accumulate(runs.begin(), runs.end(), 0);
    if (size > largest_repeat) refuse(pattern, "is larger than " + std::to_string(largest_repeat) + " ends.");
    if (size < 3) refuse(pattern, "has a repeat of fewer than 3; that is plain weave.");
    const auto ups = sequence(runs);
    const int sense = direction == "Z" ? -1 : 1;
    return filled(size, size, "twill " + joined(runs) + " " + direction,
                  [&](int end, int pick) { return ups[static_cast<std::size_t>((pick + sense * end + size) % size)]; });
}

Weave satin(const std::string& pattern, const std::vector<int>& numbers_given, bool warp_on_top)
{
    const int size = numbers_given[0];
    const auto valid = [&](int step) { return step > 1 && step < size - 1 && std::gcd(step, size) == 1; };
    int step = numbers_given.size() == 2 ? numbers_given[1] : 0;
    if (numbers_given.size() > 2 || size < 5) refuse(pattern, "needs 5 ends or more and one step.");
    if (numbers_given.size() == 1)
        for (step = 2; step < size && !valid(step);) ++step;
    if (!valid(step)) {
        std::string steps;
        for (int s = 2; s < size - 1 && steps.size() < 60; ++s)
            if (valid(s)) steps += (steps.empty() ? "" : ", ") + std::to_string(s);
        refuse(pattern, steps.empty() ? "has no valid step: no regular satin has " + std::to_string(size) + " ends."
                                      : "needs a step with no common divisor with " + std::to_string(size) + ", not 1 and not " +
                                            std::to_string(size - 1) + ": " + steps + ".");
    }
    const std::string name = (warp_on_top ? "satin " : "sateen ") + joined({size, step});
    return filled(size, size, name, [&](int end, int pick) {
        const bool binding = pick == static_cast<int>(static_cast<long>(end) * step % size);
        return warp_on_top ? !binding : binding;
    });
}

Weave basket(const std::string& pattern, std::vector<int> blocks)
{
    if (blocks.size() == 1) blocks.push_back(blocks[0]);
    if (blocks.size() != 2 || 2 * std::max(blocks[0], blocks[1]) > largest_repeat) refuse(pattern, "needs ends/picks of one block.");
    return filled(2 * blocks[0], 2 * blocks[1], "basket " + joined(blocks),
                  [&](int end, int pick) { return (end / blocks[0] + pick / blocks[1]) % 2 == 0; });
}

Weave rib(const std::string& pattern, const std::vector<int>& runs, const std::string& system)
{
    if (runs.size() != 2 || runs[0] + runs[1] > largest_repeat) refuse(pattern, "needs two lengths of floats.");
    if (system != "warp" && system != "weft") refuse(pattern, "floats in the warp or in the weft.");
    const int size = runs[0] + runs[1];
    const std::string name = "rib " + joined(runs) + " " + system;
    if (system == "warp") return filled(2, size, name, [&](int end, int pick) { return (pick < runs[0]) == (end % 2 == 0); });
    return filled(size, 2, name, [&](int end, int pick) { return (end < runs[0]) == (pick % 2 == 0); });
}

} // namespace

Weave weave_from_pattern(const std::string& pattern)
{
    std::istringstream words(pattern);
    std::string kind, size, last, more;
    words >> kind >> size >> last >> more;
    if (kind == "plain" && size.empty()) return {};
    if (!more.empty()) refuse(pattern, "has words too many.");
    if (kind == "twill" && !size.empty()) return twill(pattern, numbers(pattern, size), last.empty() ? "Z" : last);
    if (kind == "rib" && !size.empty()) return rib(pattern, numbers(pattern, size), last.empty() ? "warp" : last);
    if (!last.empty()) refuse(pattern, "is not known.");
    if ((kind == "satin" || kind == "sateen") && !size.empty()) return satin(pattern, numbers(pattern, size), kind == "satin");
    if (kind == "basket" && !size.empty()) return basket(pattern, numbers(pattern, size));
    refuse(pattern, "is not known.");
}

const std::vector<std::string>& common_weave_patterns()
{
    static const std::vector<std::string> patterns{
        "plain",       "twill 2/1 Z", "twill 1/2 Z", "twill 2/1 S", "twill 2/2 Z", "twill 2/2 S",  "twill 3/1 Z",  "twill 1/3 Z",
        "twill 3/1 S", "twill 3/3 Z", "twill 4/4 Z", "satin 5/2",   "satin 5/3",   "satin 7/2",    "satin 8/3",    "satin 8/5",
        "sateen 5/2",  "sateen 8/3",  "basket 2/2",  "basket 2/1",  "basket 3/3",  "rib 2/2 warp", "rib 2/2 weft", "rib 3/3 warp"};
    return patterns;
}

} // namespace hygroloom
