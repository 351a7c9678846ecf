// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/wear_layout.h"

#include "core/base/units.h"
#include "core/design/wear.h"
#include "core/garment/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace hygroloom {
namespace {

std::string cells_in_words(const GarmentScene& garment)
{
    std::set<std::string> words;
    for (int fabric : garment.fabric) {
        const FabricCells& cells = garment.fabrics[static_cast<std::size_t>(fabric)];
        const double end_pitch = cells.turned ? cells.pick_pitch : cells.end_pitch,
                     pick_pitch = cells.turned ? cells.end_pitch : cells.pick_pitch;
        words.insert(fmt::format("cells of {:.2g} x {:.2g} mm, {} x {} crossings", 1e3 * end_pitch, 1e3 * pick_pitch,
                                 cells.crossings_per_cell, cells.crossings_per_cell));
    }
    std::string all;
    for (const std::string& each : words) all += (all.empty() ? "" : "; ") + each;
    const std::vector<int>& per_cell = garment.shown.computed_per_cell;
    const auto [least, most] = std::minmax_element(per_cell.begin(), per_cell.end());
    if (*most > 1) all += fmt::format("; shown in sums of {0} x {0} cells{1}", *most, *least < *most ? " at most" : "");
    return all;
}

/// When the garment's skin last sweats less than before; and how warm its zones are over time.
void take_course(const GarmentScene& garment, double duration, WearLayout& layout)
{
    const SkinSupply& skin = garment.scene.supply.skin;
    std::vector<double> area(skin.zones.size(), 0);
    for (const GarmentCell& cell : garment.cells) area[static_cast<std::size_t>(cell.zone)] += cell.area;
    const auto sweat = [&](double time) {
        double sum = 0;
        for (std::size_t zone = 0; zone < area.size(); ++zone) sum += area[zone] * skin.zone_at(zone, time).rate;
        return sum;
    };
    double before = sweat(0);
    layout.stops.reset();
    for (double time = skin.next_change(0); time < duration; time = skin.next_change(time)) {
        const double now = sweat(time), just_before = sweat(std::nextafter(time, 0.0)); // it may jump then
        if (now < (1 - 1e-9) * std::max(before, just_before)) layout.stops = time;
        before = now;
    }
    if (skin.airs.empty()) return;
    for (const std::vector<SkinMoment>& moments : skin.zones) {
        layout.skin_course.emplace_back();
        for (const SkinMoment& moment : moments)
            layout.skin_course.back().push_back({moment.time, garment.scene.climate.temperature + moment.warmth});
    }
}

} // namespace

double WearLayout::skin_temperature_at(int zone, double time) const
{
    if (static_cast<std::size_t>(zone) >= skin_course.size() || skin_course[static_cast<std::size_t>(zone)].empty())
        return skin_temperature;
    const std::vector<SkinTemperature>& course = skin_course[static_cast<std::size_t>(zone)];
    const auto after =
        std::upper_bound(course.begin(), course.end(), time, [](double at, const SkinTemperature& moment) { return at < moment.time; });
    if (after == course.begin()) return course.front().temperature;
    if (after == course.end()) return course.back().temperature;
    const SkinTemperature& before = *(after - 1);
    return before.temperature + (time - before.time) / (after->time - before.time) * (after->temperature - before.temperature);
}

std::vector<std::string> WearLayout::zone_names() const
{
    std::vector<std::string> names = body_zones();
    names.insert(names.end(), own_zones.begin(), own_zones.end());
    return names;
}

FlatBox WearPanel::box() const
{
    FlatBox box;
    for (const FlatPlace& place : outline) {
        box.left = std::min(box.left, place[0]);
        box.right = std::max(box.right, place[0]);
        box.low = std::min(box.low, place[1]);
        box.high = std::max(box.high, place[1]);
    }
    return box;
}

WearLayout wear_layout(const GarmentParts& parts, const GarmentScene& garment)
{
    WearLayout layout;
    layout.garment = parts.garment->name;
    layout.experiment = parts.wear->name;
    layout.cells_in_words = cells_in_words(garment);
    layout.skin_temperature = kelvin_from_celsius(parts.garment->wearer.skin_temperature_c);
    for (const OwnZone& zone : parts.garment->wearer.own_zones) layout.own_zones.push_back(zone.name);
    const std::vector<Activity>& activity = parts.wear->activity;
    for (std::size_t k = 1; k < activity.size(); ++k)
        if (activity[k].factor < activity[k - 1].factor) layout.stops = activity[k].time_s;
    if (garment.scene.supply.skin.has_zones()) take_course(garment, parts.wear->duration_s, layout);
    if (!layout.stops && parts.wear->initial_water_g_m2 > 0) layout.stops = 0;
    for (std::size_t k = 0; k < garment.grids.size(); ++k) {
        const PatternPanel& panel = parts.pattern.panels[k];
        const PanelCut* cut = parts.garment->cut_of(panel.cut());
        const FabricCells& fabric = garment.fabrics[static_cast<std::size_t>(garment.fabric[k])];
        WearPanel made{panel.name,
                       fabric_of(panel, *cut),
                       radian_from_degree(cut->grain_deg),
                       fabric.crossings_per_cell * garment.shown.computed_per_cell[k],
                       outline_of(panel),
                       garment.shown.grids[k]};
        layout.panels.push_back(std::move(made));
    }
    layout.cells = garment.shown.cells;
    layout.shape = parts.pattern.shape;
    return layout;
}

} // namespace hygroloom
