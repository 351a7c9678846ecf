// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/garment/check_garment.h"

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/design/issue_list.h"
#include "core/design/wear.h"
#include "core/garment/outline.h"
#include "core/garment/sweat_table.h"

#include <algorithm>

namespace hygroloom {
namespace {

std::vector<std::string> names_of(const GarmentPattern& pattern)
{
    std::vector<std::string> names;
    for (const PatternPanel& panel : pattern.panels) names.push_back(panel.name);
    return names;
}

bool is_in(const std::string& name, const std::vector<std::string>& names)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

Message no_panel(const std::string& name, const std::vector<std::string>& names)
{
    constexpr std::size_t most_listed = 20;
    std::string listed;
    for (std::size_t k = 0; k < std::min(most_listed, names.size()); ++k) listed += (k > 0 ? ", \"" : "\"") + names[k] + "\"";
    const Argument more = names.size() > most_listed ? Argument(say(" and more")) : Argument("");
    return say("The pattern has no panel \"{}\"{} It has {}{}.", name, or_near(name, names), listed, more);
}

bool are_sewn(const GarmentPattern& pattern, const std::string& one, const std::string& other)
{
    return std::any_of(pattern.seams.begin(), pattern.seams.end(), [&](const PatternSeam& seam) {
        const std::string &a = pattern.panels[seam.panel_a].name, &b = pattern.panels[seam.panel_b].name;
        return (a == one && b == other) || (a == other && b == one);
    });
}

/// A zone's outline that crosses itself, or lies beside its panel.
void check_outline(const OwnZone& zone, const PatternPanel& panel, const Place& at, std::vector<Issue>& issues)
{
    std::vector<FlatPlace> outline;
    for (const auto& place : zone.outline_mm) outline.push_back({metre_from_mm(place[0]), metre_from_mm(place[1])});
    std::size_t done = 0;
    if (crosses_itself(outline, done)) {
        issues.push_back({Severity::warning, "zone_outline", at,
                          say("The outline of the zone \"{}\" crosses itself; what it goes round twice is left out.", zone.name)});
        return;
    }
    const auto box_of = [](const std::vector<FlatPlace>& places) {
        std::array<double, 4> box{1e300, 1e300, -1e300, -1e300};
        for (const FlatPlace& place : places)
            for (std::size_t axis = 0; axis < 2; ++axis) {
                box[axis] = std::min(box[axis], place[axis]);
                box[axis + 2] = std::max(box[axis + 2], place[axis]);
            }
        return box;
    };
    const std::array<double, 4> of_zone = box_of(outline), of_panel = box_of(outline_of(panel));
    if (of_zone[0] >= of_panel[2] || of_zone[2] <= of_panel[0] || of_zone[1] >= of_panel[3] || of_zone[3] <= of_panel[1])
        issues.push_back(
            {Severity::warning, "zone_outline", at,
             say("The zone \"{}\" lies beside the panel \"{}\", which reaches from x {:.0f}, y {:.0f} to x {:.0f}, y "
                 "{:.0f}.",
                 zone.name, zone.panel, Bare{mm_from_metre(of_panel[0]), Stored::mm}, Bare{mm_from_metre(of_panel[1]), Stored::mm},
                 Bare{mm_from_metre(of_panel[2]), Stored::mm}, Amount{mm_from_metre(of_panel[3]), Stored::mm})});
}

/// Whether an error concerns a place of the project or what is in it.
bool is_wrong(const std::vector<Issue>& known, const Place& where)
{
    return std::any_of(known.begin(), known.end(),
                       [&](const Issue& issue) { return issue.severity == Severity::error && issue.where.is_in(where); });
}

} // namespace

std::vector<Issue> misnamed_in(const Garment& garment, const GarmentPattern& pattern, const Place& where)
{
    const std::vector<std::string> names = names_of(pattern);
    std::vector<Issue> issues;
    for (const auto& [panel, cut] : garment.panels)
        if (panel != "*" && !is_in(panel, names))
            issues.push_back({Severity::warning, "unknown_panel", where / "panels" / panel, no_panel(panel, names)});
    for (const auto& [seam, share] : garment.seams) {
        const std::size_t bar = seam.find('|');
        if (bar == std::string::npos) continue; // "default"
        const Place at = where / "seams" / seam;
        const std::string one = seam.substr(0, bar), other = seam.substr(bar + 1);
        const std::size_t before = issues.size();
        for (const std::string& panel : {one, other})
            if (!is_in(panel, names)) issues.push_back({Severity::warning, "unknown_panel", at, no_panel(panel, names)});
        if (issues.size() == before && !are_sewn(pattern, one, other))
            issues.push_back({Severity::warning, "unknown_seam", at, say("\"{}\" and \"{}\" are not sewn together.", one, other)});
    }
    for (std::size_t i = 0; i < garment.wearer.own_zones.size(); ++i) {
        const OwnZone& zone = garment.wearer.own_zones[i];
        const Place at = where / "wearer" / "own_zones" / i;
        const auto panel = std::find(names.begin(), names.end(), zone.panel);
        if (panel == names.end()) {
            issues.push_back({Severity::warning, "unknown_panel", at / "panel", no_panel(zone.panel, names)});
            continue;
        }
        check_outline(zone, pattern.panels[static_cast<std::size_t>(panel - names.begin())], at / "outline_mm", issues);
    }
    return issues;
}

GarmentCheck check_garments(const Design& design, const std::filesystem::path& base, const std::vector<Issue>& known)
{
    GarmentCheck found;
    const auto read = [&](const char* code, const Place& where, const auto& act) {
        try {
            act();
        } catch (const FileError& error) {
            found.issues.push_back({Severity::error, code, where, quote(error.what())});
        }
    };
    for (std::size_t i = 0; i < design.garments.size(); ++i) {
        const Garment& garment = design.garments[i];
        const Place where = Place("garments") / i;
        std::optional<GarmentPattern>& pattern = found.patterns.emplace_back();
        if (is_wrong(known, where)) continue;
        read("garment_source", where / "source", [&] { pattern = read_pattern(garment, base); });
        read("sweat_table", where / "wearer" / "zones", [&] { sweat_table(garment.wearer.zones, base); });
        if (!pattern) continue;
        for (const std::string& doubt : pattern->doubts)
            found.issues.push_back({Severity::warning, "garment_shape", where / "source", quote(garment.source + ": " + doubt)});
        for (Issue& issue : misnamed_in(garment, *pattern, where)) found.issues.push_back(std::move(issue));
    }
    for (std::size_t i = 0; i < design.wears.size(); ++i) { // they stand behind the others
        const WearExperiment& wear = design.wears[i];
        const Place where = Place("experiments") / (design.experiments.size() + i);
        if (!wear.activity_file.empty() && !is_wrong(known, where))
            read("activity", where / "activity", [&] {
                const Garment* garment = find_garment(design, wear.garment);
                sweat_course(wear.activity_file, base, garment ? garment->wearer.own_zones : std::vector<OwnZone>{});
            });
    }
    return found;
}

} // namespace hygroloom
