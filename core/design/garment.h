// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A garment as a project names it: where its pattern comes from, which fabric each panel is cut from, what its seams pass, who wears it.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

namespace hygroloom {

/// The regions of the body of which sweat rates are known, in the order of the table.
const std::vector<std::string>& body_zones();
/// Where air may stand between skin and cloth: the body's zones, and "shoulder", on which cloth rests.
const std::vector<std::string>& gap_zones();
/// The shipped tables of sweat rates.
const std::vector<std::string>& sweat_tables();
/// What this program draws: tee, singlet, leggings.
const std::vector<std::string>& built_in_garments();

/// A garment that the program draws itself.
struct BuiltInGarment {
    std::string kind = "tee"; ///< tee, singlet, leggings
    double chest_mm = 1000;   ///< of the body; of leggings its hip
    double length_mm = 700;   ///< from the shoulder to the hem; of leggings from the waist to the ankle
    double ease_mm = 80;      ///< how much longer the garment's girth is than the body's
    double sleeve_mm = 220;   ///< of a tee, from the shoulder's point to the hem
    bool operator==(const BuiltInGarment&) const = default;
};

/// The usual sizes of a kind; leggings are longer than a tee and fit closer.
BuiltInGarment standard_garment(const std::string& kind);

/// Unit of a mesh's flat coordinates.
enum class UvUnit { from_lengths, millimetre, centimetre, metre };
constexpr int uv_units = 4;
const char* name_of(UvUnit unit);

/// What a panel is cut from, and how.
struct PanelCut {
    std::string fabric;
    double grain_deg = 0;    ///< of the warp, from the pattern's +y, counter-clockwise
    bool top_inside = false; ///< the fabric's top face lies on the skin
    int layers = 1;          ///< of cloth that lie on each other
    std::string lining = {}; ///< fabric of the layers under the first; empty: the same
    bool operator==(const PanelCut&) const = default;
};

constexpr int most_layers = 4;

/// A part of a panel whose skin sweats at a rate of its own, in place of the body's zones there.
struct OwnZone {
    std::string name;
    std::string panel;
    std::vector<std::array<double, 2>> outline_mm; ///< of the flat panel, in its pattern's axes; closed, without repeating the first
    double sweat_g_m2_h = 0;
    bool operator==(const OwnZone&) const = default;
};
constexpr std::size_t most_own_zones = 100, most_outline_places = 1000;

/// The body in the garment.
struct Wearer {
    double skin_temperature_c = 34;
    std::map<std::string, double> gap_mm{{"default", 3.0}}; ///< of air between skin and cloth, per zone; 0: they touch
    std::string zones = "taylor-2013 exercise";             ///< a table of sweat rates: a shipped one, or a CSV beside the project
    std::vector<OwnZone> own_zones;                         ///< where two overlap, the later one holds
    bool operator==(const Wearer&) const = default;
};

struct Garment {
    std::string name;
    std::string source; ///< a pattern or mesh file, relative to the project; empty: built_in
    BuiltInGarment built_in;
    UvUnit uv_unit = UvUnit::from_lengths;
    std::map<std::string, PanelCut> panels; ///< by panel; "*": all that are not named
    std::map<std::string, double> seams;    ///< share of the water that a seam lets through, by "panel|panel"; "default": all others, 1
    Wearer wearer;
    bool operator==(const Garment&) const = default;

    /// nullptr: neither the panel nor "*" is named.
    const PanelCut* cut_of(const std::string& panel) const;
    /// 1 where neither the seam nor "default" is named.
    double seam_between(const std::string& one, const std::string& other) const;
    /// mm; 3 where neither the zone nor "default" is named.
    double gap_of(const std::string& zone) const;
    bool is_built_in() const { return source.empty(); }
    /// A pattern in JSON, whose numbers have a unit of their own.
    bool is_pattern() const;
};

/// That its panels and linings are cut from, each once.
std::vector<std::string> fabrics_of(const Garment& garment);
/// The one fabric that all panels are cut from, whatever their linings; empty: they are cut from several.
std::string one_fabric_of(const Garment& garment);
/// Every panel from one fabric; linings stay.
void cut_all_from(Garment& garment, const std::string& fabric);

} // namespace hygroloom
