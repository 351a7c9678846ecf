// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/garment/outline.h"
#include "core/wear/garment_scene.h"
#include "core/wear/joint_groups.h"
#include "core/wear/on_edge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace hygroloom {

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

namespace {

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

/// Cosine between the way out and a step along the yarns of one system; none where these run along the seam but for rounding.
double cosine_to(const FlatPlace& out, const FlatPlace& step, double pitch)
{
    constexpr double rounding = 1e-9;
    const double cosine = (out[0] * step[0] + out[1] * step[1]) / pitch;
    return std::abs(cosine) > rounding ? cosine : 0.0;
}

/// One of a cell's two segments up to a seam: what its yarns, and the room beside them, conduct over a metre of seam, m3/(Pa s) per m.
struct HalfWay {
    int segment = 0;
    bool is_cut = false; ///< by the seam: the next cell towards it is not there
    double yarns = 0, rooms = 0;
};
/// A cell at a seam. Where the seam runs along the yarns of one system, it cuts those of the other alone.
struct CellAtSeam {
    int crossing = 0;
    std::array<HalfWay, 2> ways; ///< of the warp, of the weft

    double yarns() const { return ways[0].yarns + ways[1].yarns; }
    double rooms() const { return ways[0].rooms + ways[1].rooms; }
    /// Of what its yarns conduct. All of it is for those that the seam cuts, if any.
    std::array<double, 2> shares() const
    {
        const bool any = ways[0].is_cut || ways[1].is_cut;
        std::array<double, 2> parts{};
        for (std::size_t k = 0; k < 2; ++k) parts[k] = any && !ways[k].is_cut ? 0.0 : ways[k].yarns;
        const double all = parts[0] + parts[1];
        if (all > 0)
            for (double& part : parts) part /= all;
        return parts;
    }
};

CellAtSeam cell_at_seam(const GarmentScene& garment, std::size_t panel, const std::array<int, 2>& cell, const FlatPlace& out)
{
    const PanelGrid& grid = garment.grids[panel];
    const FabricCells& fabric = garment.fabrics[static_cast<std::size_t>(garment.fabric[panel])];
    const Cloth &cloth = garment.scene.cloth, &tile = fabric.tile.cloth;
    const int end = cell[0], pick = cell[1], row = grid.first_pick + pick;
    const int warp = end % fabric.ends, weft = tile.ends + pick % fabric.picks;
    const std::size_t warp_type = tile.type[static_cast<std::size_t>(warp)], weft_type = tile.type[static_cast<std::size_t>(weft)];
    const BetweenParameters& room =
        tile.crossing[warp_type * static_cast<std::size_t>(tile.weft_types()) + weft_type - static_cast<std::size_t>(tile.warp_types)]
            .between;
    const double along = cosine_to(out, grid.along, fabric.pick_pitch), across = cosine_to(out, grid.across, fabric.end_pitch);
    CellAtSeam found;
    found.crossing = end * cloth.picks + row;
    const auto add = [&](std::size_t way, int segment, const YarnParameters& yarn, double length, double room_along, double bundles,
                         bool is_cut) {
        found.ways[way] = {segment, is_cut && bundles != 0, 2 * yarn.flow_along / length * std::abs(bundles),
                           2 * room_along * std::abs(bundles)};
    };
    add(0, found.crossing, tile.yarns[warp_type], tile.length[fabric.warp(end, pick)], room.along_warp, along / fabric.end_pitch,
        !grid.has(end, pick + (along > 0 ? 1 : -1)));
    add(1, cloth.crossings() + row * cloth.ends + end, tile.yarns[weft_type], tile.length[fabric.weft(end, pick)], room.along_weft,
        across / fabric.pick_pitch, !grid.has(end + (across > 0 ? 1 : -1), pick));
    return found;
}

using Joints = std::map<std::pair<int, int>, SeamJoint>;

/// Of a piece of seam, m. Warp is joined with warp and weft with weft, since those can be solved together as chains; a system with the
/// other only where nothing else meets. Within a cell both exchange at its crossings.
void add_joints(Joints& joints, const CellAtSeam& one, const CellAtSeam& other, double length)
{
    const std::array<double, 2> from = one.shares(), to = other.shares();
    std::array<std::array<double, 2>, 2> shares{};
    const double alike = std::min(from[0], to[0]) + std::min(from[1], to[1]);
    for (std::size_t a = 0; a < 2; ++a)
        for (std::size_t b = 0; b < 2; ++b) shares[a][b] = alike <= 0 ? from[a] * to[b] : a == b ? std::min(from[a], to[a]) / alike : 0.0;
    const double yarns = length * in_series(one.yarns(), other.yarns()), rooms = length * in_series(one.rooms(), other.rooms());
    for (std::size_t a = 0; a < 2; ++a)
        for (std::size_t b = 0; b < 2; ++b) {
            if (shares[a][b] <= 0) continue;
            const int first = one.ways[a].segment, second = other.ways[b].segment;
            SeamJoint& joint = joints.try_emplace({first, second}, SeamJoint{first, second}).first->second;
            joint.yarns += shares[a][b] * yarns;
            joint.rooms += shares[a][b] * rooms;
        }
}

} // namespace

std::vector<SeamJoint> seam_joints(const GarmentPattern& pattern, const GarmentScene& garment, const std::vector<double>& pass)
{
    Joints joints;
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
            const CellAtSeam from = cell_at_seam(garment, a, *cell_a, at_a.out), to = cell_at_seam(garment, b, *cell_b, at_b.out);
            if (from.crossing != to.crossing) add_joints(joints, from, to, pass[s] * length / steps);
        }
    }
    std::vector<SeamJoint> all;
    for (const auto& [ends, joint] : joints) all.push_back(joint);
    return all;
}

} // namespace hygroloom
