// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Weaves with relief, holes or grain. Pick 0 is the first pick, end 0 the leftmost end.
#include "core/design/pattern_words.h"

#include "core/base/random.h"

#include <charconv>

namespace hygroloom {

namespace {

/// The one number of a pattern; more than one, or words after it, are refused.
int size_of(const PatternWords& words, int otherwise, int least, int most, int remainder_of_two, const std::string& what)
{
    if (words.runs.size() > 1) refuse_pattern(words, "needs one number.");
    const int size = words.runs.empty() ? otherwise : words.runs[0];
    if (size < least || size > most || (remainder_of_two >= 0 && size % 2 != remainder_of_two))
        refuse_pattern(words, "needs " + what + " from " + std::to_string(least) + " to " + std::to_string(most) + ".");
    return size;
}

void no_more_words(const PatternWords& words)
{
    if (!words.rest.empty()) refuse_pattern(words, "has words too many.");
}

/// The longest run of equal values through one place of a ring, counted no further than most + 1.
template <typename Value> int run_through(int at, int size, int most, Value value)
{
    const bool own = value(at);
    int run = 1;
    for (int i = 1; i < size && run <= most && value((at + i) % size) == own; ++i) ++run;
    for (int i = 1; i < size && run <= most && value((at + size - i) % size) == own; ++i) ++run;
    return run;
}

} // namespace

/// Ordinary honeycomb: two crossing lines of single marks; warp floats fill one set of the diamonds between them, weft floats the other.
Weave waffle(const PatternWords& words)
{
    const int size = size_of(words, 8, 6, largest_repeat, 0, "an even number of ends");
    no_more_words(words);
    const auto from_line = [size](int index) { return index <= size / 2 ? index : size - index; };
    return filled(size, size, "waffle " + std::to_string(size), [&](int end, int pick) {
        const int x = from_line(end), y = from_line(pick);
        return x == y || y >= x + 2;
    });
}

/// Four quarters: plain weave throughout; in two opposite quarters every second end floats over the quarter's picks.
Weave huckaback(const PatternWords& words)
{
    const int quarter = size_of(words, 5, 3, largest_repeat / 2, 1, "an odd number of ends to a quarter");
    no_more_words(words);
    return filled(2 * quarter, 2 * quarter, "huckaback " + std::to_string(quarter), [&](int end, int pick) {
        const bool figured = (end < quarter) == (pick < quarter);
        return (end + pick) % 2 == 1 || (figured && end % quarter % 2 == 1);
    });
}

/// Four quarters, each the reverse of its neighbours; in a quarter threads float side by side and draw together, which leaves holes.
Weave mock_leno(const PatternWords& words)
{
    const int quarter = size_of(words, 3, 3, largest_repeat / 2, 1, "an odd number of ends to a quarter");
    no_more_words(words);
    return filled(2 * quarter, 2 * quarter, "mock leno " + std::to_string(quarter), [&](int end, int pick) {
        const bool up = end % quarter % 2 == 0 || pick % quarter % 2 == 1;
        return up == ((end < quarter) == (pick < quarter));
    });
}

/// Plain weave with crossings turned over at random, wherever that leaves no float longer than longest_crepe_float.
/// So every thread stays bound, and the same seed gives the same cloth on every machine.
Weave crepe(const PatternWords& words)
{
    const int size = size_of(words, 16, 8, largest_repeat, 0, "an even number of ends");
    int seed = 1;
    if (!words.rest.empty()) {
        const std::string& text = words.rest.back();
        const auto [next, failure] = std::from_chars(text.data(), text.data() + text.size(), seed);
        if (words.rest.size() != 2 || words.rest[0] != "seed" || failure != std::errc() || next != text.data() + text.size() || seed < 0)
            refuse_pattern(words, "takes \"seed\" and a whole number of 0 or more after its size.");
    }
    const std::size_t row = static_cast<std::size_t>(size);
    std::vector<std::uint8_t> up(row * row);
    for (std::size_t at = 0; at < up.size(); ++at) up[at] = (at / row + at % row) % 2 == 0;
    for (std::uint64_t trial = 0; trial < 3 * up.size(); ++trial) {
        const std::size_t at = random_bits(static_cast<std::uint64_t>(seed), 0, trial) % up.size();
        const std::size_t end = at % row, pick = at / row;
        up[at] ^= 1;
        const auto along_pick = [&](int e) { return up[pick * row + static_cast<std::size_t>(e)] != 0; };
        const auto along_end = [&](int p) { return up[static_cast<std::size_t>(p) * row + end] != 0; };
        if (run_through(static_cast<int>(end), size, longest_crepe_float, along_pick) > longest_crepe_float ||
            run_through(static_cast<int>(pick), size, longest_crepe_float, along_end) > longest_crepe_float)
            up[at] ^= 1;
    }
    return {size, size, std::move(up), "crepe " + std::to_string(size) + " seed " + std::to_string(seed)};
}

/// Diamonds of single marks, each with a mark in its middle.
Weave birdseye(const PatternWords& words)
{
    if (!words.runs.empty()) refuse_pattern(words, "takes no number.");
    no_more_words(words);
    return filled(6, 6, "birdseye", [](int end, int pick) {
        const int x = end <= 3 ? end : 6 - end, y = pick <= 3 ? pick : 6 - pick;
        return x == y || x + 3 == y || y + 3 == x;
    });
}

/// The 2/2 twill; what makes it sharkskin is its colours, one dark and one light thread in turn in both systems.
Weave sharkskin(const PatternWords& words)
{
    if (!words.runs.empty()) refuse_pattern(words, "takes no number.");
    no_more_words(words);
    return filled(4, 4, "sharkskin", [](int end, int pick) { return (pick - end + 4) % 4 < 2; });
}

/// Plain weave in which the last two of every N threads lie side by side as one.
Weave ripstop(const PatternWords& words)
{
    const int grid = size_of(words, 12, 3, largest_repeat / 2, -1, "a number of ends");
    no_more_words(words);
    const int size = grid % 2 == 1 ? grid : 2 * grid; // with an odd number of threads to the grid less one, plain weave fits after two
    const auto phase = [grid](int index) { return index / grid * (grid - 1) + std::min(index % grid, grid - 2); };
    return filled(size, size, "ripstop " + std::to_string(grid), [&](int end, int pick) { return (phase(end) + phase(pick)) % 2 == 0; });
}

} // namespace hygroloom
