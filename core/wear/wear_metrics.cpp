// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/wear_metrics.h"

#include "core/garment/outline.h"
#include "core/physics/water.h"

#include <algorithm>
#include <map>

namespace hygroloom {
namespace {

/// Of each cell, m2, so that those of a panel make up its pattern piece: cells at the outline are whole, and stick out or are missing.
std::vector<double> areas_in(const WearLayout& layout)
{
    const auto panel_of = [](const GarmentCell& cell) { return static_cast<std::size_t>(cell.panel); };
    std::vector<double> in_cells(layout.panels.size(), 0.0), factors, areas;
    for (const GarmentCell& cell : layout.cells) in_cells[panel_of(cell)] += cell.area;
    for (std::size_t panel = 0; panel < in_cells.size(); ++panel) {
        const double drawn = std::abs(signed_area(layout.panels[panel].outline));
        factors.push_back(drawn > 0 ? drawn / in_cells[panel] : 1.0); // a damaged file may have none
    }
    for (const GarmentCell& cell : layout.cells) areas.push_back(factors[panel_of(cell)] * cell.area);
    return areas;
}

void add_cell(WearNow& now, const WearFrame& frame, std::size_t i, const GarmentCell& cell, double area)
{
    const double water = frame.water(i);
    now.water += water;
    now.inside += frame.inside[i];
    if (water > share_of_wet * cell.capacity) now.wet_area += area;
    now.evaporated += frame.evaporated[i];
    now.on_skin += frame.on_skin[i];
    now.temperature += static_cast<double>(frame.temperature[i]) * area;
}

/// s, at which the water came to so much, between a frame that has passed it and the one before.
double time_of(const std::vector<WearNow>& course, std::vector<WearNow>::const_iterator after, double water)
{
    if (after == course.begin()) return after->time;
    const WearNow& before = *(after - 1);
    const double share = (water - before.water) / (after->water - before.water);
    return before.time + share * (after->time - before.time);
}

} // namespace

double WearPart::largest_wet_area() const
{
    double largest = 0;
    for (const WearNow& now : course) largest = std::max(largest, now.wet_area);
    return largest;
}

double WearPart::most_water() const
{
    double most = 0;
    for (const WearNow& now : course) most = std::max(most, now.water);
    return most;
}

std::optional<double> WearPart::time_to_full() const
{
    const double much = share_of_full * capacity;
    const auto full = std::find_if(course.begin(), course.end(), [&](const WearNow& now) { return now.water >= much; });
    return full == course.end() ? std::nullopt : std::optional(time_of(course, full, much));
}

std::optional<double> WearPart::time_to_dry(double from) const
{
    const double little = share_of_dry * most_water();
    if (little <= 0) return std::nullopt;
    const auto wet = std::find_if(course.rbegin(), course.rend(), [&](const WearNow& now) { return now.water >= little; });
    if (wet == course.rbegin()) return std::nullopt; // at the end, still or again
    return std::max(from, time_of(course, wet.base(), little)) - from;
}

WearMetrics::WearMetrics(const WearLayout& layout) : layout_(layout), areas_(areas_in(layout))
{
    all_.name = layout.garment;
    for (const WearPanel& panel : layout.panels) panels_.push_back({panel.name, 0, 0, 0, {}});
    const std::vector<std::string> names = layout.zone_names();
    std::map<int, int> known;
    for (const GarmentCell& cell : layout.cells) known.try_emplace(cell.zone, 0);
    for (auto& [zone, place] : known) {
        place = static_cast<int>(zones_.size());
        zones_.push_back({names[static_cast<std::size_t>(zone)], 0, 0, 0, {}});
    }
    for (std::size_t i = 0; i < layout.cells.size(); ++i) {
        const GarmentCell& cell = layout.cells[i];
        zone_of_.push_back(known[cell.zone]);
        for (WearPart* part : {&all_, &panels_[static_cast<std::size_t>(cell.panel)], &zones_[static_cast<std::size_t>(zone_of_.back())]}) {
            part->area += areas_[i];
            part->in_cells += cell.area;
            part->capacity += cell.capacity;
        }
    }
}

void WearMetrics::add(const WearFrame& frame)
{
    WearNow all{frame.time};
    std::vector<WearNow> panels(panels_.size(), all), zones(zones_.size(), all);
    double flow = 0;
    for (std::size_t i = 0; i < layout_.cells.size(); ++i) {
        const GarmentCell& cell = layout_.cells[i];
        for (WearNow* now : {&all, &panels[static_cast<std::size_t>(cell.panel)], &zones[static_cast<std::size_t>(zone_of_[i])]})
            add_cell(*now, frame, i, cell, areas_[i]);
        const double skin = layout_.skin_temperature_at(cell.zone, frame.time);
        flow += cell.skin_contact * cell.area * (skin - static_cast<double>(frame.temperature[i]));
    }
    if (!all_.course.empty()) from_skin_ += 0.5 * (flow + flow_before_) * (frame.time - all_.course.back().time);
    flow_before_ = flow;
    const auto keep = [](WearPart& part, WearNow now) {
        now.temperature /= part.area;
        part.course.push_back(now);
    };
    keep(all_, all);
    for (std::size_t k = 0; k < panels.size(); ++k) keep(panels_[k], panels[k]);
    for (std::size_t k = 0; k < zones.size(); ++k) keep(zones_[k], zones[k]);
    if (all_.course.size() == 1) at_start_ = frame.ledger.water_delivered;
    ledger_ = frame.ledger;
}

double WearMetrics::imbalance() const
{
    return ledger_.water_imbalance() / std::max(1e-30, ledger_.water_delivered + ledger_.water_initial);
}

double WearMetrics::heat_of_evaporation() const
{
    return hygroloom::heat_of_evaporation(layout_.skin_temperature) * ledger_.water_evaporated;
}

} // namespace hygroloom
