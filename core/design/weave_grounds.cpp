// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Twills, satins, baskets and ribs. Pick 0 is the first pick, end 0 the leftmost end; a Z line rises to the right.
#include "core/design/pattern_words.h"

#include <algorithm>
#include <charconv>
#include <numeric>

namespace hygroloom {

namespace {

int wrapped(long index, int size)
{
    const long rest = index % size;
    return static_cast<int>(rest < 0 ? rest + size : rest);
}

/// A whole number of the rest of a pattern.
int number_in(const PatternWords& words, const std::string& text, int least, int most, const std::string& what)
{
    int value = 0;
    const auto [next, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || next != text.data() + text.size() || value < least || value > most)
        refuse_pattern(words, "needs " + what + " from " + std::to_string(least) + " to " + std::to_string(most) + ".");
    return value;
}

/// What all twills share: "2/1 Z".
struct TwillLine {
    std::vector<std::uint8_t> ups; ///< of one repeat
    int size = 0;
    int sense = 1;        ///< +1 rises to the right (Z)
    std::string name;     ///< "2/1 Z"
    std::size_t used = 0; ///< words of the rest

    bool up(long pick, long displacement) const { return ups[static_cast<std::size_t>(wrapped(pick - displacement, size))] != 0; }
};

TwillLine twill_line(const PatternWords& words, bool with_direction = true)
{
    TwillLine line;
    if (words.runs.empty() || words.runs.size() % 2 != 0) refuse_pattern(words, "needs as many downs as ups.");
    line.size = std::accumulate(words.runs.begin(), words.runs.end(), 0);
    if (line.size > largest_repeat) refuse_pattern(words, "is larger than " + std::to_string(largest_repeat) + " ends.");
    if (line.size < 3) refuse_pattern(words, "has a repeat of fewer than 3; that is plain weave.");
    line.ups = ups_and_downs(words.runs);
    line.name = joined(words.runs);
    if (!with_direction) return line;
    std::string direction = "Z";
    if (!words.rest.empty() && (words.rest[0][0] < '0' || words.rest[0][0] > '9')) {
        direction = words.rest[0];
        line.used = 1;
    }
    if (direction != "Z" && direction != "S") refuse_pattern(words, "runs Z or S.");
    line.sense = direction == "Z" ? 1 : -1;
    line.name += " " + direction;
    return line;
}

/// The optional last number.
int count_after(const PatternWords& words, std::size_t used, int otherwise, int least, int most, const std::string& what)
{
    if (words.rest.size() > used + 1) refuse_pattern(words, "has words too many.");
    if (words.rest.size() == used) return std::clamp(otherwise, least, most);
    return number_in(words, words.rest[used], least, most, what);
}

/// Up to a turning point and back, neither point twice: 0 1 2 3 2 1.
int there_and_back(int index, int length) { return index < length ? index : 2 * length - 2 - index; }

} // namespace

Weave twill(const PatternWords& words)
{
    const TwillLine line = twill_line(words);
    if (words.rest.size() == line.used)
        return filled(line.size, line.size, "twill " + line.name, [&](int end, int pick) { return line.up(pick, line.sense * end); });
    if (words.rest.size() != line.used + 2) refuse_pattern(words, "has words too many or too few.");
    const std::string& how = words.rest[line.used];
    if (how != "steep" && how != "reclined") refuse_pattern(words, "is steep or reclined, with a step.");
    const int step = number_in(words, words.rest[line.used + 1], 2, line.size - 1, "a step");
    const int across = line.size / std::gcd(line.size, step);
    const std::string name = "twill " + line.name + " " + how + " " + std::to_string(step);
    if (across < 2) refuse_pattern(words, "repeats on one thread; take another step.");
    if (how == "steep")
        return filled(across, line.size, name,
                      [&](int end, int pick) { return line.up(pick, static_cast<long>(line.sense) * step * end); });
    return filled(line.size, across, name, [&](int end, int pick) { return line.up(static_cast<long>(step) * pick, line.sense * end); });
}

/// The second half of the ends runs back from the other side: 0 1 3 2 on four ends, the crow.
Weave broken_twill(const PatternWords& words)
{
    const TwillLine line = twill_line(words);
    if (words.rest.size() != line.used) refuse_pattern(words, "has words too many.");
    if (line.size < 4) refuse_pattern(words, "needs a repeat of 4 or more.");
    const int half = (line.size + 1) / 2;
    return filled(line.size, line.size, "broken twill " + line.name, [&](int end, int pick) {
        const int displacement = end < half ? end : line.size - 1 - (end - half);
        return line.up(pick, line.sense * displacement);
    });
}

Weave pointed_twill(const PatternWords& words)
{
    const TwillLine line = twill_line(words);
    const int point = count_after(words, line.used, line.size, 3, largest_repeat / 2, "ends to the point");
    return filled(2 * point - 2, line.size, "pointed twill " + line.name + " " + std::to_string(point),
                  [&](int end, int pick) { return line.up(pick, line.sense * there_and_back(end, point)); });
}

/// Stripes of Z and S; from one to the next the line jumps by half a repeat, so that ups meet downs and the stripes part clearly.
Weave herringbone(const PatternWords& words)
{
    const TwillLine line = twill_line(words);
    const int stripe = count_after(words, line.used, 2 * line.size, 2, largest_repeat / 2, "ends to the cut");
    return filled(2 * stripe, line.size, "herringbone " + line.name + " " + std::to_string(stripe), [&](int end, int pick) {
        const int displacement = end < stripe ? end : 2 * stripe - 1 - end + line.size / 2;
        return line.up(pick, line.sense * displacement);
    });
}

/// Pointed in both systems.
Weave diamond(const PatternWords& words)
{
    const TwillLine line = twill_line(words, false);
    const int point = count_after(words, 0, line.size, 3, largest_repeat / 2, "ends to the point");
    return filled(2 * point - 2, 2 * point - 2, "diamond " + line.name + " " + std::to_string(point),
                  [&](int end, int pick) { return line.up(there_and_back(pick, point), there_and_back(end, point)); });
}

Weave satin(const PatternWords& words, bool warp_on_top)
{
    if (words.runs.empty() || words.runs.size() > 2 || !words.rest.empty()) refuse_pattern(words, "needs the number of ends and one step.");
    const int size = words.runs[0];
    const std::string kind = warp_on_top ? "satin " : "sateen ";
    if (words.runs.size() == 1 && (size == 4 || size == 6)) { // no regular one exists; the customary irregular ones
        static constexpr int four[] = {0, 1, 3, 2}, six[] = {0, 2, 4, 1, 5, 3};
        const int* order = size == 4 ? four : six;
        return filled(size, size, kind + std::to_string(size), [&](int end, int pick) { return (pick == order[end]) != warp_on_top; });
    }
    const auto valid = [&](int step) { return step > 1 && step < size - 1 && std::gcd(step, size) == 1; };
    int step = words.runs.size() == 2 ? words.runs[1] : 0;
    if (size < 5) refuse_pattern(words, "needs 5 ends or more and one step.");
    if (words.runs.size() == 1)
        for (step = 2; step < size && !valid(step);) ++step;
    if (!valid(step)) {
        std::string steps;
        for (int s = 2; s < size - 1 && steps.size() < 60; ++s)
            if (valid(s)) steps += (steps.empty() ? "" : ", ") + std::to_string(s);
        refuse_pattern(words, steps.empty() ? "has no valid step: no regular satin has " + std::to_string(size) + " ends."
                                            : "needs a step with no common divisor with " + std::to_string(size) + ", not 1 and not " +
                                                  std::to_string(size - 1) + ": " + steps + ".");
    }
    return filled(size, size, kind + joined({size, step}), [&](int end, int pick) {
        const bool binding = pick == static_cast<int>(static_cast<long>(end) * step % size);
        return binding != warp_on_top;
    });
}

Weave basket(const PatternWords& words)
{
    std::vector<int> blocks = words.runs;
    if (blocks.size() == 1) blocks.push_back(blocks[0]);
    if (blocks.size() != 2 || !words.rest.empty() || 2 * std::max(blocks[0], blocks[1]) > largest_repeat)
        refuse_pattern(words, "needs ends/picks of one block.");
    return filled(2 * blocks[0], 2 * blocks[1], "basket " + joined(blocks),
                  [&](int end, int pick) { return (end / blocks[0] + pick / blocks[1]) % 2 == 0; });
}

Weave rib(const PatternWords& words)
{
    const std::vector<int>& runs = words.runs;
    if (runs.size() != 2 || runs[0] + runs[1] > largest_repeat) refuse_pattern(words, "needs two lengths of floats.");
    if (words.rest.size() > 1) refuse_pattern(words, "has words too many.");
    const std::string system = words.rest.empty() ? "warp" : words.rest[0];
    if (system != "warp" && system != "weft") refuse_pattern(words, "floats in the warp or in the weft.");
    const int size = runs[0] + runs[1];
    const std::string name = "rib " + joined(runs) + " " + system;
    if (system == "warp") return filled(2, size, name, [&](int end, int pick) { return (pick < runs[0]) == (end % 2 == 0); });
    return filled(size, 2, name, [&](int end, int pick) { return (end < runs[0]) == (pick % 2 == 0); });
}

} // namespace hygroloom
