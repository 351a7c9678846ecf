// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/trade_units.h"

#include "core/base/units.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <string>
#include <utility>

namespace hygroloom {

namespace {

const std::map<Stored, std::vector<TradeUnit>>& table()
{
    static const std::map<Stored, std::vector<TradeUnit>> units{
        {Stored::number, {{{""}}}},
        {Stored::fraction, {{{""}}, {{"%"}, 1, 100}}},
        {Stored::share, {{{""}}, {{"%"}, 1, 100}}},
        {Stored::degree, {{{"°", "deg", "degree", "degrees", "Grad"}}, {{"rad"}, 180 / pi}}},
        {Stored::per_cm, {{{"/cm", "per cm", "je cm", "1/cm"}}, {{"/in", "epi", "ppi", "per inch", "per in", "/inch"}, 1, 2.54}}},
        {Stored::per_m, {{{"/m", "tpm", "t/m", "per m", "je m"}}, {{"/cm", "tpc"}, 100}, {{"/in", "tpi", "per inch"}, 1, 0.0254}}},
        {Stored::per_mm, {{{"/mm", "per mm", "je mm"}}, {{"/cm", "per cm", "je cm"}, 1, 10}}},
        {Stored::mm, {{{"mm"}}, {{"µm", "um", "micron"}, 1, 1000}, {{"cm"}, 10}, {{"m"}, 1000}, {{"in", "inch", "\""}, 25.4}}},
        {Stored::um, {{{"µm", "um", "micron"}}, {{"nm"}, 1, 1000}, {{"mm"}, 1000}}},
        {Stored::tex,
         {{{"tex"}},
          {{"Ne", "NeC"}, tex_from_ne(1), 1, 0, true},
          {{"Nm"}, tex_from_nm(1), 1, 0, true},
          {{"den", "denier", "D"}, 1, denier_from_tex(1)},
          {{"dtex"}, 1, 10}}},
        {Stored::celsius, {{{"°C", "C"}}, {{"K"}, 1, 1, zero_celsius}, {{"°F", "F"}, 1, 1.8, 32}}},
        {Stored::second, {{{"s", "sec"}}, {{"ms"}, 1, 1000}, {{"min"}, 60}, {{"h"}, 3600}}},
        {Stored::metre_per_second, {{{"m/s"}}, {{"cm/s"}, 1, 100}, {{"km/h"}, 1, 3.6}}},
        {Stored::microlitre, {{{"µl", "ul", "mm3", "mm³"}}, {{"ml", "cm3"}, 1000}, {{"nl"}, 1, 1000}}},
        {Stored::g_per_m2, {{{"g/m²", "g/m2", "gsm"}}, {{"kg/m²", "kg/m2"}, 1000}, {{"oz/yd²", "oz/yd2", "oz"}, 33.906}}},
        {Stored::g_per_m2_hour, {{{"g/(m² h)", "g/(m2 h)", "g/m2/h"}}}},
        {Stored::mn_per_m, {{{"mN/m", "dyn/cm"}}, {{"N/m"}, 1000}}},
        {Stored::mpa_second, {{{"mPa s", "mPas", "cP"}}, {{"Pa s", "Pas"}, 1000}}},
        {Stored::kg_per_m3, {{{"kg/m³", "kg/m3", "g/l"}}, {{"g/cm³", "g/cm3", "g/ml"}, 1000}}},
        {Stored::percent, {{{"%"}}}},
        {Stored::watt_per_m_kelvin, {{{"W/(m K)", "W/mK"}}}},
        {Stored::joule_per_kg_kelvin, {{{"J/(kg K)", "J/kgK"}}}},
        {Stored::joule_per_g, {{{"J/g"}}}},
        {Stored::m2_per_second, {{{"m²/s", "m2/s"}}}}};
    return units;
}

/// Endings of keys, longer ones before those that they end with; and keys whose name does not say their unit.
constexpr std::pair<std::string_view, Stored> endings[] = {{"_deg", Stored::degree},
                                                           {"_per_cm", Stored::per_cm},
                                                           {"_per_mm", Stored::per_mm},
                                                           {"_per_m", Stored::per_m},
                                                           {"_um", Stored::um},
                                                           {"_mm", Stored::mm},
                                                           {"_tex", Stored::tex},
                                                           {"_ul", Stored::microlitre},
                                                           {"_g_m2_h", Stored::g_per_m2_hour},
                                                           {"_g_m2", Stored::g_per_m2},
                                                           {"_mn_m", Stored::mn_per_m},
                                                           {"_mpa_s", Stored::mpa_second},
                                                           {"_kg_m3", Stored::kg_per_m3},
                                                           {"_m2_s", Stored::m2_per_second},
                                                           {"_m_s", Stored::metre_per_second},
                                                           {"_c", Stored::celsius},
                                                           {"_s", Stored::second},
                                                           {"_percent", Stored::percent},
                                                           {"_w_mk", Stored::watt_per_m_kelvin},
                                                           {"_j_kgk", Stored::joule_per_kg_kelvin},
                                                           {"_j_g", Stored::joule_per_g}};
constexpr std::pair<std::string_view, Stored> keys[] = {
    {"finish_face", Stored::degree},        {"finish_back", Stored::degree},    {"relative_humidity", Stored::share},
    {"packing_factor", Stored::fraction},   {"porosity", Stored::fraction},     {"share", Stored::share},
    {"irregularity_cv", Stored::share},     {"standard_regain", Stored::share}, {"saturation_regain", Stored::share},
    {"monolayer_regain", Stored::fraction}, {"finish_depth", Stored::share},    {"finish_holes", Stored::share}};

/// The micro sign for the Greek letter, which looks the same; small letters where capitals do not count.
std::string folded(std::string_view text, bool fold_case)
{
    std::string result(text);
    constexpr std::string_view mu = "\xce\xbc", micro = "µ";
    if (result.starts_with(mu)) result.replace(0, mu.size(), micro);
    if (fold_case)
        for (char& letter : result) letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    return result;
}

} // namespace

const std::vector<TradeUnit>& trade_units(Stored kind) { return table().at(kind); }

Stored stored_kind(std::string_view key)
{
    for (const auto& [name, kind] : keys)
        if (key == name) return kind;
    for (const auto& [ending, kind] : endings)
        if (key.ends_with(ending)) return kind;
    return Stored::number;
}

std::string_view unit_in_sentences(Stored kind)
{
    switch (kind) {
    case Stored::degree: return "degrees";
    case Stored::per_m: return "turns per metre";
    case Stored::per_cm:
    case Stored::per_mm:
    case Stored::share: return ""; // their names say it; sentences have fractions
    case Stored::celsius: return "C";
    case Stored::microlitre: return "ul";
    case Stored::g_per_m2: return "g/m2";
    case Stored::g_per_m2_hour: return "g/(m2 h)";
    case Stored::kg_per_m3: return "kg/m3";
    case Stored::m2_per_second: return "m2/s";
    default: return trade_units(kind).front().spellings.front();
    }
}

std::optional<double> number_with_unit(std::string_view text, Stored kind)
{
    double number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc()) return std::nullopt;
    std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
    while (unit.starts_with(' ')) unit.remove_prefix(1);
    while (unit.ends_with(' ')) unit.remove_suffix(1);
    for (const bool fold_case : {false, true})
        for (const TradeUnit& known : trade_units(kind))
            for (const std::string_view spelling : known.spellings)
                if (folded(unit, fold_case) == folded(spelling, fold_case)) return known.stored(number);
    return std::nullopt;
}

} // namespace hygroloom
