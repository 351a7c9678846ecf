// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is wrong with a garment as the project names it. Its pattern's file is read elsewhere.
#include "core/design/issue_list.h"

#include <algorithm>

namespace hygroloom {

namespace {

bool is_in(const std::string& word, const std::vector<std::string>& words)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

void validate_built_in(const BuiltInGarment& garment, const Place& where, IssueList& list)
{
    if (!is_in(garment.kind, built_in_garments())) {
        list.error("unknown_garment", where / "built_in",
                   say("There is no built-in garment \"{}\"; there are {}.", garment.kind, listed_in_quotes(built_in_garments())));
        return;
    }
    for (Field<BuiltInGarment> size : fields_of<BuiltInGarment>()) {
        const SizeRange range = size_range(garment.kind, size);
        size.least = range.least;
        size.most = range.most;
        if (!size.is_written || size.is_written(garment)) list.field(where, size, garment);
    }
    if (garment.kind != "tee" && garment.sleeve_mm != standard_garment(garment.kind).sleeve_mm)
        list.error("no_sleeves", where / "sleeve_mm", say("Only a tee has sleeves; leave it out of a {}.", garment.kind));
}

void validate_source(const Garment& garment, const Place& where, IssueList& list)
{
    if (garment.is_built_in()) validate_built_in(garment.built_in, where / "source", list);
    if (garment.uv_unit != UvUnit::from_lengths && (garment.is_built_in() || garment.is_pattern()))
        list.error("idle_uv_unit", where / "uv_unit",
                   say("Only a mesh has flat coordinates without a unit; leave uv_unit out of {}; given is \"{}\".",
                       garment.is_built_in() ? say("a built-in garment") : say("a pattern"), name_of(garment.uv_unit)));
}

void validate_cuts(const Design& design, const Garment& garment, const Place& where, IssueList& list)
{
    if (garment.panels.empty())
        list.error("no_panels", where / "panels",
                   say("A garment needs a fabric for its panels; name panels, or \"*\" for all that are not named."));
    const std::vector<std::string> fabrics = names_in(design.fabrics);
    for (const auto& [panel, cut] : garment.panels) {
        const Place at = where / "panels" / panel;
        if (panel.empty()) list.error("empty_name", where / "panels", say("The name of a panel is empty; give one."));
        list.one_line(where / "panels", panel);
        if (!find_fabric(design, cut.fabric))
            list.error("unknown_fabric", at / "fabric",
                       say("The project has no fabric \"{}\"{}", cut.fabric, or_near(cut.fabric, fabrics)));
        list.fields(at, cut);
        if (cut.lining.empty()) continue;
        if (!find_fabric(design, cut.lining))
            list.error("unknown_fabric", at / "lining",
                       say("The project has no fabric \"{}\"{}", cut.lining, or_near(cut.lining, fabrics)));
        if (cut.layers == 1)
            list.add(Severity::warning, "unused_lining", at / "lining",
                     say("A panel of 1 layer has no lining; give it 2 layers or more, or leave lining out."));
    }
}

constexpr double farthest_mm = 1e5; // as a panel may reach

void validate_own_zone(const OwnZone& zone, const Place& at, IssueList& list)
{
    if (zone.name.empty()) list.error("empty_name", at / "name", say("The name of a zone is empty; give one."));
    list.one_line(at / "name", zone.name);
    if (zone.name == "default" || is_in(zone.name, gap_zones()))
        list.error("duplicate_name", at / "name", say("\"{}\" is a zone of the body; give a zone of your own another name.", zone.name));
    if (zone.panel.empty()) list.error("empty_name", at / "panel", say("The panel of a zone is empty; name one of the garment's."));
    list.fields(at, zone);
    if (zone.outline_mm.size() < 3 || zone.outline_mm.size() > most_outline_places)
        list.error("range", at / "outline_mm",
                   say("The outline of a zone has from 3 to {} places; given are {}.", most_outline_places, zone.outline_mm.size()));
    for (std::size_t i = 0; i < std::min(most_outline_places, zone.outline_mm.size()); ++i)
        for (std::size_t axis = 0; axis < 2; ++axis)
            list.range(at / "outline_mm" / i / axis, axis == 0 ? say("x of a place") : say("y of a place"), zone.outline_mm[i][axis],
                       -farthest_mm, farthest_mm, Stored::mm);
}

void validate_own_zones(const std::vector<OwnZone>& zones, const Place& where, IssueList& list)
{
    if (zones.size() > most_own_zones)
        list.error("range", where, say("A wearer has at most {} own zones; given are {}.", most_own_zones, zones.size()));
    for (std::size_t i = 0; i < std::min(most_own_zones, zones.size()); ++i) {
        const Place at = where / i;
        validate_own_zone(zones[i], at, list);
        const auto before = zones.begin() + static_cast<std::ptrdiff_t>(i);
        if (std::any_of(zones.begin(), before, [&](const OwnZone& other) { return other.name == zones[i].name; }))
            list.error("duplicate_name", at / "name", say("There are two own zones \"{}\"; give one another name.", zones[i].name));
    }
}

void validate_wearer(const Wearer& wearer, const Place& where, IssueList& list)
{
    list.fields(where, wearer);
    for (const auto& [zone, gap] : wearer.gap_mm) {
        const Place at = where / "gap_mm" / zone;
        if (zone != "default" && !is_in(zone, gap_zones()))
            list.error("unknown_zone", at,
                       say("There is no zone \"{}\" of the body{} There are \"default\", {}.", zone, or_near(zone, gap_zones()),
                           listed_in_quotes(gap_zones())));
        list.range(at, say("gap between skin and cloth"), gap, 0, 100, Stored::mm);
    }
    if (!is_in(wearer.zones, sweat_tables()) && !wearer.zones.ends_with(".csv"))
        list.error("unknown_sweat_table", where / "zones",
                   say("There is no table of sweat rates \"{}\"; there are {}, or name a file that ends in .csv.", wearer.zones,
                       listed_in_quotes(sweat_tables())));
    validate_own_zones(wearer.own_zones, where / "own_zones", list);
}

} // namespace

void validate_garment(const Design& design, const Garment& garment, const Place& where, IssueList& list)
{
    validate_source(garment, where, list);
    validate_cuts(design, garment, where, list);
    for (const auto& [seam, share] : garment.seams) {
        const Place at = where / "seams" / seam;
        const std::size_t bar = seam.find('|');
        const bool pair = bar != std::string::npos && bar > 0 && bar + 1 < seam.size();
        if (seam != "default" && !pair)
            list.error("unknown_seam", at, say("A seam is named \"panel|panel\", or \"default\" for all others; given is \"{}\".", seam));
        list.range(at, say("share of the water that a seam lets through"), share, 0, 1);
        if (pair && garment.seams.contains(seam.substr(bar + 1) + "|" + seam.substr(0, bar)) && seam.substr(0, bar) < seam.substr(bar + 1))
            list.error("duplicate_name", at, say("The seam \"{}\" is named twice, once in each order; leave one.", seam));
    }
    validate_wearer(garment.wearer, where / "wearer", list);
}

} // namespace hygroloom
