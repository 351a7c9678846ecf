// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/garment.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace hygroloom {

namespace {

/// The value of a name, else that of another name, else nullptr.
template <typename Value>
const Value* named(const std::map<std::string, Value>& values, const std::string& name, const std::string& otherwise)
{
    auto at = values.find(name);
    if (at == values.end()) at = values.find(otherwise);
    return at == values.end() ? nullptr : &at->second;
}

} // namespace

const std::vector<std::string>& body_zones()
{
    static const std::vector<std::string> zones{"head", "chest",        "abdomen", "back", "buttocks", "upper arm",  "forearm",
                                                "palm", "back of hand", "thigh",   "shin", "sole",     "top of foot"};
    return zones;
}

const std::vector<std::string>& gap_zones()
{
    static const std::vector<std::string> zones = [] {
        std::vector<std::string> all = body_zones();
        all.emplace_back("shoulder");
        return all;
    }();
    return zones;
}

const std::vector<std::string>& sweat_tables()
{
    static const std::vector<std::string> tables{"taylor-2013 rest", "taylor-2013 exercise"};
    return tables;
}

const std::vector<std::string>& built_in_garments()
{
    static const std::vector<std::string> kinds{"tee", "singlet", "leggings"};
    return kinds;
}

BuiltInGarment standard_garment(const std::string& kind)
{
    // Usual sizes of a chest and a hip of 1 m; assumptions.
    if (kind == "singlet") return {kind, 1000, 680, 60, 220};
    if (kind == "leggings") return {kind, 1000, 1000, 20, 220};
    return {kind, 1000, 700, 80, 220};
}

const char* name_of(UvUnit unit)
{
    constexpr const char* names[uv_units] = {"from_lengths", "mm", "cm", "m"};
    return names[static_cast<int>(unit)];
}

const PanelCut* Garment::cut_of(const std::string& panel) const { return named(panels, panel, "*"); }

double Garment::seam_between(const std::string& one, const std::string& other) const
{
    const auto at = seams.find(one + "|" + other);
    if (at != seams.end()) return at->second;
    const double* share = named(seams, other + "|" + one, "default");
    return share ? *share : 1;
}

double Garment::gap_of(const std::string& zone) const
{
    const double* gap = named(wearer.gap_mm, zone, "default");
    return gap ? *gap : 3;
}

bool Garment::is_pattern() const
{
    const std::size_t dot = source.rfind('.');
    std::string ending = dot == std::string::npos ? std::string() : source.substr(dot);
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char letter) { return std::tolower(letter); });
    return ending == ".json";
}

std::vector<std::string> fabrics_of(const Garment& garment)
{
    std::set<std::string> names;
    for (const auto& [panel, cut] : garment.panels)
        for (const std::string& name : {cut.fabric, cut.lining})
            if (!name.empty()) names.insert(name);
    return {names.begin(), names.end()};
}

std::string one_fabric_of(const Garment& garment)
{
    std::set<std::string> names;
    for (const auto& [panel, cut] : garment.panels) names.insert(cut.fabric);
    return names.size() == 1 ? *names.begin() : std::string();
}

void cut_all_from(Garment& garment, const std::string& fabric)
{
    garment.panels["*"].fabric = fabric;
    for (auto& [panel, cut] : garment.panels) cut.fabric = fabric;
}

} // namespace hygroloom
