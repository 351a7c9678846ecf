// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/physics/air.h"
#include "core/wear/garment_scene.h"
#include "core/wear/joint_groups.h"

#include <map>

namespace hygroloom {
namespace {

/// How readily a cloth takes or gives liquid where another lies on it, m3/(Pa s) per m2 of cloth.
struct FaceOfCloth {
    double yarns = 0;      ///< from a yarn into the one that it crosses
    double into_yarns = 0; ///< from liquid on the face; half of all segments lie there
    double into_room = 0;  ///< the same into the room between the yarns
};
FaceOfCloth face_of(const GarmentScene& garment, const GarmentCell& cell)
{
    const FabricCells& fabric = garment.fabrics[static_cast<std::size_t>(garment.fabric[static_cast<std::size_t>(cell.panel)])];
    const Cloth& tile = fabric.tile.cloth;
    const std::size_t warp = tile.type[static_cast<std::size_t>(cell.end % fabric.ends)],
                      weft = tile.type[static_cast<std::size_t>(tile.ends + cell.pick % fabric.picks)];
    const std::size_t at = warp * static_cast<std::size_t>(tile.weft_types()) + weft - static_cast<std::size_t>(tile.warp_types);
    const BetweenParameters& between = tile.crossing[at].between;
    const double into_yarns = 0.5 * (tile.yarns[warp].face_conductance + tile.yarns[weft].face_conductance);
    return {between.yarns / cell.area, into_yarns / cell.area, between.face / cell.area};
}

/// Which cells of the inner layer lie under a cell, and on how much of it, m2.
std::map<std::array<int, 2>, double> shared_areas(const GarmentCell& cell, const PanelGrid& outer, const PanelGrid& inner)
{
    constexpr int across = 4; // places along a cell's sides
    std::map<std::array<int, 2>, double> shared;
    for (int i = 0; i < across; ++i)
        for (int j = 0; j < across; ++j) {
            const double e = (i + 0.5) / across - 0.5, p = (j + 0.5) / across - 0.5;
            const std::array<int, 2> under = inner.cell_at(
                {cell.flat[0] + e * outer.across[0] + p * outer.along[0], cell.flat[1] + e * outer.across[1] + p * outer.along[1]});
            if (inner.has(under[0], under[1])) shared[under] += cell.area / (across * across);
        }
    return shared;
}

} // namespace

const std::string& fabric_of(const PatternPanel& panel, const PanelCut& cut)
{
    return panel.layer_of.empty() || cut.lining.empty() ? cut.fabric : cut.lining;
}

void lay_on_each_other(GarmentScene& garment, const GarmentPattern& pattern)
{
    std::map<int, std::size_t> inner_of; // of the panel over it
    for (std::size_t panel = 0; panel < pattern.panels.size(); ++panel)
        if (pattern.panels[panel].over >= 0) inner_of[pattern.panels[panel].over] = panel;
    if (inner_of.empty()) return;
    std::map<int, const GarmentCell*> at_crossing;
    for (const GarmentCell& cell : garment.cells) at_crossing[cell.crossing] = &cell;
    const Cloth& cloth = garment.scene.cloth;
    const double diffusivity = vapour_diffusivity(garment.scene.climate.temperature);
    std::vector<LayerJoint> joints;
    for (const GarmentCell& cell : garment.cells) {
        const auto found = inner_of.find(cell.panel);
        if (found == inner_of.end()) continue;
        const PanelGrid& inner = garment.grids[found->second];
        for (const auto& [under, area] : shared_areas(cell, garment.grids[static_cast<std::size_t>(cell.panel)], inner)) {
            const GarmentCell& other = *at_crossing.at(under[0] * cloth.picks + inner.first_pick + under[1]);
            const FaceOfCloth a = face_of(garment, cell), b = face_of(garment, other);
            const double touching = touching_crowns * area;
            joints.push_back({cell.crossing, other.crossing, touching * 2 * in_series(a.yarns, b.yarns),
                              touching * in_series(a.into_room, b.into_room), touching * in_series(a.into_room, b.into_yarns),
                              touching * in_series(b.into_room, a.into_yarns), area * air_conductivity / contact_gap,
                              area * diffusivity / contact_gap});
        }
    }
    garment.scene.cloth.layers = grouped<ClothLayers>(cloth.crossings(), std::move(joints), [](const LayerJoint& joint) {
        return std::array<int, 2>{joint.a, joint.b};
    });
}

} // namespace hygroloom
