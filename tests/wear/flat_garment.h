// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Garments of rectangles that lie flat, for tests.
#pragma once

#include "core/design/wear.h"
#include "core/project/library.h"
#include "core/solver/backend.h"
#include "core/wear/garment_scene.h"

namespace hygroloom {

/// A rectangle from a corner (m), its four edges from the lower one on.
inline void add_rectangle(GarmentPattern& pattern, const std::string& name, const FlatPlace& corner, double width, double height)
{
    const double left = corner[0], low = corner[1], right = left + width, high = low + height;
    const std::array<FlatPlace, 4> at{{{left, low}, {right, low}, {right, high}, {left, high}}};
    PatternPanel panel{name, {}, {Vec3d{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    for (std::size_t k = 0; k < 4; ++k) panel.edges.push_back({{at[k], at[(k + 1) % 4]}});
    GarmentShape& shape = pattern.shape;
    const int first = static_cast<int>(shape.flat.size()), number = static_cast<int>(pattern.panels.size());
    for (const FlatPlace& place : at) {
        shape.flat.push_back(place);
        shape.places.push_back({place[0], place[1], 0});
    }
    for (const std::array<int, 3>& corners : {std::array{0, 1, 2}, {0, 2, 3}}) {
        shape.triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
        shape.panel.push_back(number);
    }
    pattern.panels.push_back(std::move(panel));
}

inline Design library_design(const std::string& fabric)
{
    Design design;
    for (const Preset& preset : shipped_presets())
        if (preset.fabric().name == fabric) add_preset(design, preset);
    return design;
}

/// One garment of one fabric, worn.
struct Worn {
    Design design;
    Garment garment;
    WearExperiment wear;
    GarmentParts parts;
    Fidelity fidelity = Fidelity::standard;
    std::optional<double> room_voxels; ///< in place of the fidelity's

    explicit Worn(const std::string& fabric = "Textile F") : design(library_design(fabric))
    {
        garment.name = "piece";
        garment.panels["*"] = {fabric};
        wear.name = "wear";
        wear.garment = garment.name;
        wear.climate = Climate{};
        wear.duration_s = 10;
        parts.sweat.g_m2_h.assign(body_zones().size(), 0);
    }
    Worn(const Worn&) = delete;
    GarmentScene scene(double side, bool hangs = false, bool has_skin = false, const ShownSize& shown = {})
    {
        parts.design = &design;
        parts.garment = &garment;
        parts.wear = &wear;
        Knobs knobs = knobs_of(fidelity);
        if (room_voxels) knobs.room_voxels = *room_voxels;
        return garment_scene(parts, {knobs, side, hangs, has_skin, shown});
    }
};

/// The built-in tee of a textile, exercised in.
struct Tee : Worn {
    explicit Tee(double duration) : Worn("Textile F")
    {
        garment.name = "tee";
        wear.garment = "tee";
        wear.duration_s = duration;
        wear.climate = {25, 0.5, 1};
        parts.pattern = read_pattern(garment, {});
        parts.sweat = sweat_table("taylor-2013 exercise", {});
    }
};

/// Sweat (g/m2 h) under the cells that are within a radius (m) of a flat place, none elsewhere.
inline void sweat_in_circle(GarmentScene& garment, const FlatPlace& middle, double radius, double g_m2_h)
{
    for (const GarmentCell& cell : garment.cells) {
        const double x = cell.flat[0] - middle[0], y = cell.flat[1] - middle[1];
        garment.scene.supply.skin.rate[static_cast<std::size_t>(cell.crossing)] =
            x * x + y * y <= radius * radius ? 1e-3 * g_m2_h / 3600 / garment.scene.climate.density : 0.0;
    }
}

inline Frame frame_at(const Scene& scene, double time)
{
    const std::unique_ptr<Backend> cpu = make_cpu_backend();
    cpu->load(scene);
    while (cpu->advance(time) < time) {}
    return cpu->frame();
}

/// kg of liquid and bound water in each shown cell over the start.
inline std::vector<double> water_in_cells(const Frame& frame)
{
    std::vector<double> water;
    for (const CellSums& cell : frame.cells) water.push_back(cell.top + cell.bottom);
    return water;
}

} // namespace hygroloom
