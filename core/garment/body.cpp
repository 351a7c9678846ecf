// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Zones by a place on the built-in body; where nothing says how panels stand, by their names.
#include "core/garment/body.h"

#include "core/base/units.h"
#include "core/garment/outline.h"
#include "core/garment/readers.h"

#include <algorithm>
#include <cctype>

namespace hygroloom {

namespace {

/// In the order of body_zones().
enum Zone { head, chest, abdomen, back, buttocks, upper_arm, forearm, palm, back_of_hand, thigh, shin, sole, top_of_foot };

bool names_one_of(const std::string& name, std::initializer_list<const char*> words)
{
    std::string small = name;
    std::transform(small.begin(), small.end(), small.begin(), [](unsigned char letter) { return std::tolower(letter); });
    return std::any_of(words.begin(), words.end(), [&small](const char* word) { return small.find(word) != std::string::npos; });
}

bool names_an_arm(const std::string& name) { return names_one_of(name, {"sleeve", "arm_", "cuff", "arm panel"}); }

/// Height of the highest place of a panel over the floor, and how far its middle is from the body's, both m.
struct Extent {
    double lowest = 1e300, highest = -1e300, aside = 0;
};

std::vector<Extent> extents_of(const GarmentPattern& pattern)
{
    std::vector<Extent> extents(pattern.panels.size());
    std::vector<double> counts(extents.size());
    const auto add = [&](std::size_t panel, const Vec3d& place) {
        Extent& extent = extents[panel];
        extent.lowest = std::min(extent.lowest, place.y);
        extent.highest = std::max(extent.highest, place.y);
        extent.aside += place.x;
        ++counts[panel];
    };
    for (std::size_t t = 0; t < pattern.shape.triangles.size(); ++t)
        for (const int corner : pattern.shape.triangles[t])
            add(static_cast<std::size_t>(pattern.shape.panel[t]), pattern.shape.places[corner]);
    for (std::size_t p = 0; p < extents.size(); ++p) {
        if (counts[p] == 0)
            for (const FlatPlace& flat : outline_of(pattern.panels[p])) add(p, in_space(pattern.panels[p], flat));
        extents[p].aside = std::abs(extents[p].aside / std::max(counts[p], 1.0));
    }
    return extents;
}

int zone_by_name(const PatternPanel& panel)
{
    if (panel.on_arm) return upper_arm;
    if (names_one_of(panel.name, {"hood", "cap", "head"})) return head;
    if (names_one_of(panel.name, {"sock", "foot"})) return top_of_foot;
    const bool behind = names_one_of(panel.name, {"back", "_b", "rear"});
    if (names_one_of(panel.name, {"leg", "pant", "skirt", "trouser", "short"})) return thigh;
    if (names_one_of(panel.name, {"hip", "waist", "seat"})) return behind ? buttocks : abdomen;
    return behind ? back : chest;
}

int zone_on_arm(const Vec3d& place, double height)
{
    const double x = std::abs(place.x) - body::half_shoulders;
    const double from_shoulder = std::hypot(x, height - body::shoulder);
    if (from_shoulder <= body::upper_arm) return upper_arm;
    if (from_shoulder <= body::upper_arm + body::forearm) return forearm;
    return place.z < 0 ? palm : back_of_hand;
}

/// Whether a place lies inside an outline (mm): a ray from it crosses that an odd number of times.
bool is_inside(const std::vector<std::array<double, 2>>& outline, double x, double y)
{
    bool inside = false;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const auto &a = outline[i], &b = outline[j];
        if ((a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
    }
    return inside;
}

} // namespace

void find_body(GarmentPattern& pattern)
{
    std::vector<Extent> extents = extents_of(pattern);
    double lowest = 0;
    for (const Extent& extent : extents) lowest = std::min(lowest, extent.lowest);
    pattern.floor = lowest < -0.1 ? -body::floor_below_origin : 0;
    for (std::size_t p = 0; p < extents.size(); ++p) {
        const bool reaches_up = extents[p].highest - pattern.floor > 0.92 * body::shoulder;
        const bool hangs_beside = extents[p].lowest - pattern.floor > body::crotch;
        pattern.panels[p].on_arm =
            names_an_arm(pattern.panels[p].name) ||
            ((pattern.is_placed || pattern.is_draped) && extents[p].aside > body::half_shoulders && reaches_up && hangs_beside);
    }
}

int zone_at(const GarmentPattern& pattern, int panel, const Vec3d& place)
{
    const PatternPanel& cloth = pattern.panels[panel];
    if (!pattern.is_placed && !pattern.is_draped) return zone_by_name(cloth);
    const double height = place.y - pattern.floor;
    if (cloth.on_arm) return zone_on_arm(place, height);
    if (height > body::chin) return head;
    const bool behind = place.z < 0;
    if (behind && height > body::waist) return back;
    if (height > body::lower_rib) return chest;
    if (height > body::crotch) return behind ? buttocks : abdomen;
    if (height > body::knee) return thigh;
    if (height > body::ankle) return shin;
    return height > body::sole ? top_of_foot : sole;
}

int zone_at(const Garment& garment, const GarmentPattern& pattern, int panel, const Vec3d& place, const FlatPlace& flat)
{
    const std::string& name = pattern.panels[panel].cut();
    const std::vector<OwnZone>& own = garment.wearer.own_zones;
    for (std::size_t k = own.size(); k-- > 0;)
        if (own[k].panel == name && is_inside(own[k].outline_mm, mm_from_metre(flat[0]), mm_from_metre(flat[1])))
            return static_cast<int>(body_zones().size() + k);
    return zone_at(pattern, panel, place);
}

double gap_at(const Garment& garment, const GarmentPattern& pattern, int panel, const Vec3d& place)
{
    const int zone = zone_at(pattern, panel, place);
    const bool on_top = zone == chest || zone == back || zone == upper_arm;
    const double height = place.y - pattern.floor;
    const bool placed = pattern.is_placed || pattern.is_draped;
    if (on_top && placed && height > body::shoulder - body::shoulder_reach && height < body::chin) {
        const auto shoulder = garment.wearer.gap_mm.find("shoulder");
        if (shoulder != garment.wearer.gap_mm.end()) return shoulder->second;
    }
    return garment.gap_of(body_zones()[zone]);
}

} // namespace hygroloom
