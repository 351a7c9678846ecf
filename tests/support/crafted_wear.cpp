// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "tests/support/crafted_wear.h"

#include "core/project/library.h"
#include "core/wear/wear_map.h"
#include "core/wear/wear_outcomes.h"

namespace hygroloom {
namespace {

constexpr double side = 8e-3; ///< m, of cells

/// A rectangle of cells whose lower left corner lies at a flat place, and in space as far from the body.
void add_panel(WearLayout& layout, const std::string& name, const FlatPlace& corner, int ends, int picks)
{
    WearPanel panel{name, shipped_presets().front().fabric().name, 0, 2, {}, {}};
    panel.grid.ends = ends;
    panel.grid.picks = picks;
    panel.grid.origin = {corner[0] + 0.5 * side, corner[1] + 0.5 * side};
    panel.grid.across = {side, 0};
    panel.grid.along = {0, side};
    const int number = static_cast<int>(layout.panels.size()), first = static_cast<int>(layout.shape.flat.size());
    for (const auto& [x, y] : {std::array{0, 0}, {ends, 0}, {ends, picks}, {0, picks}}) {
        const FlatPlace place{corner[0] + x * side, corner[1] + y * side};
        panel.outline.push_back(place);
        layout.shape.flat.push_back(place);
        layout.shape.places.push_back({place[0], 1 + place[1], 0.1 + 0.5 * place[0]});
    }
    for (const std::array<int, 3>& corners : {std::array{0, 1, 2}, {0, 2, 3}}) {
        layout.shape.triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
        layout.shape.panel.push_back(number);
    }
    for (int end = 0; end < ends; ++end)
        for (int pick = 0; pick < picks; ++pick) {
            GarmentCell cell{number, end, pick};
            cell.zone = end % 3;
            cell.flat = panel.grid.middle(end, pick);
            cell.place = {cell.flat[0], 1 + cell.flat[1], 0.1 + 0.5 * cell.flat[0]};
            cell.area = side * side;
            cell.capacity = 0.2 * cell.area;
            cell.skin_contact = 8;
            layout.cells.push_back(cell);
        }
    layout.panels.push_back(std::move(panel));
}

} // namespace

WearRecord small_wear()
{
    WearRecord record;
    add_preset(record.design, shipped_presets().front());
    record.fidelity = "draft";
    record.backend = "cpu";
    record.device = "a device";
    record.date = "2026-11-22T18:40:12Z";
    WearLayout& layout = record.layout;
    layout.garment = "tee";
    layout.experiment = "run";
    layout.cells_in_words = "cells of 8 x 8 mm, 2 x 2 crossings";
    layout.skin_temperature = 307.15;
    layout.stops = 1;
    add_panel(layout, "front", {0, 0}, 4, 3);
    add_panel(layout, "sleeve", {0.1, 0}, 2, 3);
    return record;
}

WearFrame small_wear_frame(const WearLayout& layout, int number)
{
    WearFrame frame;
    frame.time = frame.ledger.time = number;
    for (std::size_t i = 0; i < layout.cells.size(); ++i) {
        const double water = 1e-7 * number * static_cast<double>(i % 5);
        frame.inside.push_back(water);
        frame.outside.push_back(0.5 * water);
        frame.evaporated.push_back(0.1 * water);
        frame.temperature.push_back(303.15F);
        frame.on_skin.push_back(0.2 * water);
        frame.ledger.water_delivered += 1.8 * water;
    }
    return frame;
}

void write_small_wear_recording(const std::string& path)
{
    const WearRecord record = small_wear();
    WearWriter writer(path, record);
    for (int k = 0; k < 3; ++k) writer.append(small_wear_frame(record.layout, k));
    writer.finish(1);
}

const CraftTargets& targets_of_a_garment()
{
    static const CraftTargets targets{
        {"wall_s", "cells/count", "shape/vertices", "shape/triangles"},
        {"format", "design", "layout", "provenance/fidelity", "provenance/backend", "provenance/device", "provenance/date"},
        {"cells/panel", "cells/end", "cells/pick", "cells/zone", "cells/x", "cells/y", "cells/area", "cells/capacity", "cells/skin_contact",
         "shape/places", "shape/flat", "shape/corners"},
        {"time_s", "ledger_time_s", "water_delivered_kg", "inside", "outside", "temperature", "evaporated", "on_skin"},
        {"layout", "layout", "layout", "design"}};
    return targets;
}

void use_wear_recording(const std::string& path, const std::string& folder)
{
    const WearRecording recording(path);
    const WearLayout& layout = recording.record().layout;
    WearMetrics metrics(layout);
    WearFrame frame;
    for (int k = 0; k < recording.frames(); ++k) {
        frame = recording.frame(k);
        metrics.add(frame);
    }
    wear_json(metrics);
    table_of_parts(metrics);
    for (const WearScale scale : {WearScale::capacity, WearScale::same}) {
        WearMapOptions how;
        how.scale = scale;
        const WearMap map = wear_map(layout, frame, how);
        if (scale == WearScale::same && !folder.empty()) write_wear_map(layout, frame, map, folder);
    }
    wear_csv(layout, frame);
}

} // namespace hygroloom
