// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// From which number a WIF file counts each of its quantities. The format counts from 1; programs count some of them, or all, from 0.
#pragma once

#include "core/project/wif_file.h"

#include <algorithm>

namespace hygroloom {

/// Numbers of the first end, pick, shaft and treadle.
struct WifCounting {
    int ends = 1, picks = 1, shafts = 1, treadles = 1;

    /// "ends, picks and treadles": what is counted from 0; empty: nothing.
    std::string from_zero() const
    {
        std::vector<std::string> names;
        for (const auto& [first, name] : {std::pair(ends, "ends"), {picks, "picks"}, {shafts, "shafts"}, {treadles, "treadles"}})
            if (first == 0) names.emplace_back(name);
        std::string text;
        for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
        return text;
    }
};

/// Whether a section has an entry of that number.
inline bool has_key(const WifFile& file, std::string_view section, int number)
{
    const WifSection* const found = file.find(section);
    return found && std::any_of(found->entries.begin(), found->entries.end(),
                                [number](const WifEntry& entry) { return whole_number(entry.key) == number; });
}

/// Whether a section numbers threads from 0: it has a number 0, and none as high as there are threads.
inline bool threads_from_zero(const WifFile& file, std::string_view section, std::string_view system)
{
    const auto threads = leading_whole(file.value(system, "Threads").value_or(""));
    return has_key(file, section, 0) && !(threads && has_key(file, section, *threads));
}

/// The values of a section.
struct WifValues {
    bool has_zero = false;
    bool has_zero_beside_others = false; ///< in one list: there it does not stand for none
    int greatest = 0;
};

inline WifValues values_of(const WifFile& file, std::string_view section)
{
    WifValues values;
    const WifSection* const found = file.find(section);
    if (!found) return values;
    for (const WifEntry& entry : found->entries) {
        bool zero = false, others = false;
        for (const std::string_view part : parted(entry.value, ',')) {
            const auto number = leading_whole(part);
            zero = zero || number == 0;
            others = others || number.value_or(0) > 0;
            values.greatest = std::max(values.greatest, number.value_or(0));
        }
        values.has_zero = values.has_zero || zero;
        values.has_zero_beside_others = values.has_zero_beside_others || (zero && others);
    }
    return values;
}

/// Each quantity apart.
inline WifCounting counting_of(const WifFile& file)
{
    const auto program = file.value("WIF", "Source Program");
    if (program && capitals(*program).find("GLASSNER") != std::string::npos) return {0, 0, 0, 0};
    WifCounting first;
    if (threads_from_zero(file, "THREADING", "WARP")) first.ends = 0;
    if (threads_from_zero(file, "TREADLING", "WEFT") || threads_from_zero(file, "LIFTPLAN", "WEFT")) first.picks = 0;
    if (has_key(file, "TIEUP", 0) && values_of(file, "TREADLING").has_zero) first.treadles = 0;
    const WifValues threading = values_of(file, "THREADING"), ties = values_of(file, "TIEUP"), lifts = values_of(file, "LIFTPLAN");
    const auto shafts = leading_whole(file.value("WEAVING", "Shafts").value_or(""));
    const bool fits = !shafts || std::max({threading.greatest, ties.greatest, lifts.greatest}) < *shafts;
    const bool is_shaft =
        ties.has_zero_beside_others || lifts.has_zero_beside_others || (first.ends == 0 && (ties.has_zero || lifts.has_zero));
    if (threading.has_zero && is_shaft && fits) first.shafts = 0;
    return first;
}

} // namespace hygroloom
