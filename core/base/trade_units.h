// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Units that people type behind numbers, and how a number in one becomes one in the unit that the design stores.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace hygroloom {

struct TradeUnit {
    std::vector<std::string_view> spellings; ///< the first is the proper one
    double times = 1, over = 1;              ///< stored = (typed - zero) times / over
    double zero = 0;                         ///< what the stored zero is in this unit
    bool inverse = false;                    ///< stored = times / typed: a yarn count

    double stored(double typed) const { return inverse ? times / typed : (typed - zero) * times / over; }
    double typed(double stored) const { return inverse ? times / stored : stored * over / times + zero; }
};

/// Kinds of numbers, by the unit in which the design stores them.
enum class Stored {
    number,
    fraction,
    share, ///< a fraction that people read in percent
    degree,
    per_cm,
    per_m,
    per_mm,
    mm,
    um,
    tex,
    celsius,
    second,
    metre_per_second,
    microlitre,
    g_per_m2,
    g_per_m2_hour,
    mn_per_m,
    mpa_second,
    kg_per_m3,
    percent,
    watt_per_m_kelvin,
    joule_per_kg_kelvin,
    joule_per_g,
    m2_per_second
};

/// Those that may be typed; the stored one first.
const std::vector<TradeUnit>& trade_units(Stored kind);

/// The kind of a key of the project: "contact_angle_deg" holds degrees. number where the key has no unit.
Stored stored_kind(std::string_view key);

/// As sentences spell it: "turns per metre"; empty where they need none.
std::string_view unit_in_sentences(Stored kind);

/// The stored number of a text such as "60 epi" or "60deg"; nothing where the text is no number with a unit of this kind.
std::optional<double> number_with_unit(std::string_view text, Stored kind);

} // namespace hygroloom
