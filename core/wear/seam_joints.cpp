// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/garment/outline.h"
#include "core/wear/garment_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace hygroloom {
namespace {

/// A place on an edge, and the direction out of the panel there.
struct OnEdge {
    FlatPlace place;
    FlatPlace out;
};

/// At a share of its length. Panels go counter-clockwise, so that out is to the right.
OnEdge at_share(const PanelEdge& edge, double share)
{
    double left = share * length_of(edge);
    for (std::size_t i = 0; i + 1 < edge.places.size(); ++i) {
        const FlatPlace &a = edge.places[i], &b = edge.places[i + 1];
        const double x = b[0] - a[0], y = b[1] - a[1], length = std::hypot(x, y);
        if (length > 0 && (left <= length || i + 2 == edge.places.size()))
            return {{a[0] + left / length * x, a[1] + left / length * y}, {y / length, -x / length}};
        left -= length;
    }
    return {edge.places.back(), {0, 0}};
}

/// The cell of a panel that lies at its edge there.
std::optional<std::array<int, 2>> cell_inside(const PanelGrid& grid, const OnEdge& at)
{
    const double size = std::min(std::hypot(grid.across[0], grid.across[1]), std::hypot(grid.along[0], grid.along[1]));
    for (double deep : {0.25, 0.5, 0.75, 1.0, 1.5}) {
        const std::array<int, 2> cell = grid.cell_at({at.place[0] - deep * size * at.out[0], at.place[1] - deep * size * at.out[1]});
        if (grid.has(cell[0], cell[1])) return cell;
    }
    return std::nullopt;
}

/// Of a cell, up to a seam: the segment that runs into it more steeply, and what it and the room beside it conduct over a metre of seam,
/// m3/(Pa s) per m.
struct HalfWay {
    int segment = 0, crossing = 0;
    double yarns = 0, rooms = 0;
};
HalfWay half_way(const GarmentScene& garment, std::size_t panel, const std::array<int, 2>& cell, const FlatPlace& out)
{
    const PanelGrid& grid = garment.grids[panel];
    const FabricCells& fabric = garment.fabrics[static_cast<std::size_t>(garment.fabric[panel])];
    const Cloth &cloth = garment.scene.cloth, &tile = fabric.tile.cloth;
    const double along = std::abs(out[0] * grid.along[0] + out[1] * grid.along[1]) / fabric.pick_pitch,
                 across = std::abs(out[0] * grid.across[0] + out[1] * grid.across[1]) / fabric.end_pitch;
    const bool by_warp = along >= across;
    const int end = cell[0], pick = cell[1], row = grid.first_pick + pick;
    const std::size_t warp_type = tile.type[static_cast<std::size_t>(end % fabric.ends)],
                      weft_type = tile.type[static_cast<std::size_t>(tile.ends + pick % fabric.picks)];
    const YarnParameters& yarn = tile.yarns[by_warp ? warp_type : weft_type];
    const BetweenParameters& room =
        tile.crossing[warp_type * static_cast<std::size_t>(tile.weft_types()) + weft_type - static_cast<std::size_t>(tile.warp_types)]
            .between;
    const double length = tile.length[by_warp ? fabric.warp(end, pick) : fabric.weft(end, pick)];
    const double yarns_per_metre = by_warp ? along / fabric.end_pitch : across / fabric.pick_pitch; // bundles that the seam cuts
    HalfWay half;
    half.crossing = end * cloth.picks + row;
    half.segment = by_warp ? half.crossing : cloth.crossings() + row * cloth.ends + end;
    half.yarns = 2 * yarn.flow_along / length * yarns_per_metre;
    half.rooms = 2 * (by_warp ? room.along_warp : room.along_weft) * yarns_per_metre;
    return half;
}

double in_series(double a, double b) { return a > 0 && b > 0 ? a * b / (a + b) : 0.0; }

} // namespace

std::vector<SeamJoint> seam_joints(const GarmentPattern& pattern, const GarmentScene& garment, const std::vector<double>& pass)
{
    std::map<std::pair<int, int>, SeamJoint> joints;
    for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
        const PatternSeam& seam = pattern.seams[s];
        if (pass[s] <= 0) continue;
        const auto a = static_cast<std::size_t>(seam.panel_a), b = static_cast<std::size_t>(seam.panel_b);
        const PanelEdge &edge_a = pattern.panels[a].edges[static_cast<std::size_t>(seam.edge_a)],
                        &edge_b = pattern.panels[b].edges[static_cast<std::size_t>(seam.edge_b)];
        const double length = 0.5 * (length_of(edge_a) + length_of(edge_b));
        double least = 1e300;
        for (std::size_t panel : {a, b}) {
            const FabricCells& fabric = garment.fabrics[static_cast<std::size_t>(garment.fabric[panel])];
            least = std::min({least, fabric.end_pitch, fabric.pick_pitch});
        }
        const int steps = std::max(1, static_cast<int>(std::ceil(8 * length / least)));
        for (int step = 0; step < steps; ++step) {
            const double share = (step + 0.5) / steps;
            const OnEdge at_a = at_share(edge_a, share), at_b = at_share(edge_b, seam.reversed ? 1 - share : share);
            const auto cell_a = cell_inside(garment.grids[a], at_a), cell_b = cell_inside(garment.grids[b], at_b);
            if (!cell_a || !cell_b) continue;
            const HalfWay from = half_way(garment, a, *cell_a, at_a.out), to = half_way(garment, b, *cell_b, at_b.out);
            if (from.crossing == to.crossing) continue;
            SeamJoint& joint = joints.try_emplace({from.segment, to.segment}, SeamJoint{from.segment, to.segment}).first->second;
            joint.yarns += pass[s] * length / steps * in_series(from.yarns, to.yarns);
            joint.rooms += pass[s] * length / steps * in_series(from.rooms, to.rooms);
        }
    }
    std::vector<SeamJoint> all;
    for (const auto& [ends, joint] : joints) all.push_back(joint);
    return all;
}

} // namespace hygroloom
