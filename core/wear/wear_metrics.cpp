// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/wear_metrics.h"

#include "core/physics/water.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

void add_cell(WearNow& now, const WearFrame& frame, std::size_t i, const GarmentCell& cell)
{
    const double water = frame.water(i);
    now.water += water;
    now.inside += frame.inside[i];
    if (water > share_of_wet * cell.capacity) now.wet_area += cell.area;
    now.evaporated += frame.evaporated[i];
    now.on_skin += frame.on_skin[i];
    now.temperature += static_cast<double>(frame.temperature[i]) * cell.area;
}

Json numbers_of(const WearPart& part, const std::optional<double>& stops)
{
    const WearNow& end = part.course.back();
    const auto or_null = [](const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); };
    return {{"area_m2", part.area},
            {"capacity_g_m2", 1e3 * part.capacity / part.area},
            {"water_g", 1e3 * end.water},
            {"water_g_m2", 1e3 * end.water / part.area},
            {"most_water_g", 1e3 * part.most_water()},
            {"share_of_capacity", end.water / part.capacity},
            {"share_inside", end.water > 0 ? Json(end.inside / end.water) : Json(nullptr)},
            {"wet_area_m2", end.wet_area},
            {"largest_wet_area_m2", part.largest_wet_area()},
            {"evaporated_g", 1e3 * end.evaporated},
            {"on_skin_g", 1e3 * end.on_skin},
            {"temperature_c", end.temperature - zero_celsius},
            {"time_to_full_s", or_null(part.time_to_full())},
            {"time_to_dry_s", or_null(stops ? part.time_to_dry(*stops) : std::nullopt)}};
}

/// s, at which the water came to so much, between a frame that has passed it and the one before.
double time_of(const std::vector<WearNow>& course, std::vector<WearNow>::const_iterator after, double water)
{
    if (after == course.begin()) return after->time;
    const WearNow& before = *(after - 1);
    const double share = (water - before.water) / (after->water - before.water);
    return before.time + share * (after->time - before.time);
}

Json series_of(const WearPart& part)
{
    Json series;
    for (const WearNow& now : part.course) {
        series["time_s"].push_back(now.time);
        series["water_g"].push_back(1e3 * now.water);
        series["wet_area_m2"].push_back(now.wet_area);
        series["evaporated_g"].push_back(1e3 * now.evaporated);
        series["on_skin_g"].push_back(1e3 * now.on_skin);
        series["temperature_c"].push_back(now.temperature - zero_celsius);
    }
    return series;
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

WearMetrics::WearMetrics(const WearLayout& layout) : layout_(layout)
{
    all_.name = layout.garment;
    for (const WearPanel& panel : layout.panels) panels_.push_back({panel.name, 0, 0, {}});
    const std::vector<std::string> names = layout.zone_names();
    std::map<int, int> known;
    for (const GarmentCell& cell : layout.cells) known.try_emplace(cell.zone, 0);
    for (auto& [zone, place] : known) {
        place = static_cast<int>(zones_.size());
        zones_.push_back({names[static_cast<std::size_t>(zone)], 0, 0, {}});
    }
    for (const GarmentCell& cell : layout.cells) {
        zone_of_.push_back(known[cell.zone]);
        for (WearPart* part : {&all_, &panels_[static_cast<std::size_t>(cell.panel)], &zones_[static_cast<std::size_t>(zone_of_.back())]}) {
            part->area += cell.area;
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
            add_cell(*now, frame, i, cell);
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

std::string WearMetrics::json() const
{
    Json json;
    json["garment"] = all_.name;
    json["time_s"] = all_.course.back().time;
    json["metrics"] = numbers_of(all_, layout_.stops);
    json["metrics"]["sweat_g"] = 1e3 * sweat();
    json["metrics"]["initial_water_g"] = 1e3 * at_start_;
    json["metrics"]["dripped_g"] = 1e3 * ledger_.water_dripped;
    json["metrics"]["heat_from_skin_kj"] = 1e-3 * from_skin_;
    json["metrics"]["heat_of_evaporation_kj"] = 1e-3 * heat_of_evaporation();
    json["water_imbalance"] = imbalance();
    for (const WearPart& panel : panels_) json["panels"][panel.name] = numbers_of(panel, layout_.stops);
    for (const WearPart& zone : zones_) json["zones"][zone.name] = numbers_of(zone, layout_.stops);
    json["series"] = series_of(all_);
    for (const WearPart& panel : panels_) json["series"]["panels"][panel.name] = series_of(panel);
    for (const WearPart& zone : zones_) json["series"]["zones"][zone.name] = series_of(zone);
    return json.dump(2);
}

std::string WearMetrics::text() const
{
    std::string text = fmt::format("{:<16} {:>9} {:>12} {:>12} {:>10} {:>10} {:>12} {:>11}\n", "", "area, m2", "water, g/m2", "of capacity",
                                   "wet, m2", "on skin, g", "evaporated, g", "cloth, C");
    const auto add = [&](const WearPart& part) {
        const WearNow& end = part.course.back();
        text += fmt::format("{:<16} {:>9.3f} {:>12.1f} {:>10.0f} % {:>10.3f} {:>10.2f} {:>12.2f} {:>11.1f}\n", part.name, part.area,
                            1e3 * end.water / part.area, 100 * end.water / part.capacity, end.wet_area, 1e3 * end.on_skin,
                            1e3 * end.evaporated, end.temperature - zero_celsius);
    };
    add(all_);
    for (const WearPart& panel : panels_) add(panel);
    text += "By zone of the body\n";
    for (const WearPart& zone : zones_) add(zone);
    const std::string and_start = at_start_ > 0 ? fmt::format(" and {:.1f} g in the cloth at the start", 1e3 * at_start_) : "";
    text += fmt::format("Sweat {:.1f} g{}: {:.1f} g in the cloth, {:.1f} g evaporated, {:.1f} g on the skin, {:.1f} g dripped.\n",
                        1e3 * sweat(), and_start, 1e3 * all_.course.back().water, 1e3 * ledger_.water_evaporated, 1e3 * ledger_.water_free,
                        1e3 * ledger_.water_dripped);
    text +=
        fmt::format("The skin gave {:.1f} kJ to the cloth; evaporating took {:.1f} kJ.\n", 1e-3 * from_skin_, 1e-3 * heat_of_evaporation());
    return text;
}

} // namespace hygroloom
