// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/room/room_details.h"

#include "core/room/liquid_voxels.h"
#include "core/room/room_flow.h"

#include <cmath>
#include <deque>

namespace hygroloom {
namespace {

/// Whether a liquid runs on without end along the ends (y) or the picks (x): whether a way through it leads from a voxel to the same one of
/// another cell.
class RunsOn {
public:
    RunsOn(const DrawnLayer& layer, double growth, const std::vector<std::uint8_t>& air) : liquid_(layer, growth, air)
    {
        reached_.resize(liquid_.places().size());
        for (std::size_t first = 0; first < reached_.size(); ++first)
            if (!reached_[first].yes) follow(static_cast<int>(first));
    }
    bool along_warp = false, along_weft = false;

private:
    using Place = LiquidVoxels::Place;
    struct Reached {
        bool yes = false;
        long x = 0, y = 0; // counted on from cell to cell
    };
    void follow(int first)
    {
        const Place& start = liquid_.places()[static_cast<std::size_t>(first)];
        reached_[static_cast<std::size_t>(first)] = {true, start.x, start.y};
        std::deque<int> open{first};
        while (!open.empty()) {
            const int own = open.front();
            open.pop_front();
            const Reached from = reached_[static_cast<std::size_t>(own)];
            for (int axis = 0; axis < 3; ++axis)
                for (int step : {-1, 1}) {
                    const auto next = liquid_.beside(liquid_.places()[static_cast<std::size_t>(own)], axis, step);
                    const int number = next ? liquid_.number(*next) : -1;
                    if (number < 0) continue;
                    const Reached here{true, from.x + (axis == 0 ? step : 0), from.y + (axis == 1 ? step : 0)};
                    Reached& there = reached_[static_cast<std::size_t>(number)];
                    if (!there.yes) {
                        there = here;
                        open.push_back(number);
                    }
                    along_weft = along_weft || there.x != here.x;
                    along_warp = along_warp || there.y != here.y;
                }
        }
    }

    LiquidVoxels liquid_;
    std::vector<Reached> reached_;
};

/// Air comes in by ever smaller balls until nothing runs on.
double least_connected(const DrawnLayer& layer, double growth, bool RunsOn::*along)
{
    constexpr int rounds = 8;
    double low = layer.side(), high = layer.reach - growth, least = 1;
    for (int round = 0; round < rounds; ++round) {
        const double radius = std::sqrt(low * high);
        const PartlyFull state = emptied_by_balls(layer, growth, radius);
        if (RunsOn(layer, growth, state.air).*along) {
            least = state.saturation;
            high = radius;
        } else {
            low = radius;
        }
    }
    return least;
}

/// Share of the layers of voxels from one on, before another, that lies outside the yarns.
double open_share(const DrawnLayer& layer, double growth, int from, int before)
{
    DrawnLayer part = layer;
    part.margin = 0;
    part.grid.nz = before - from;
    const auto first = layer.outside.begin() + static_cast<std::ptrdiff_t>(layer.grid.at(0, 0, from));
    part.outside.assign(first, first + static_cast<std::ptrdiff_t>(part.grid.size()));
    return share_outside(part, growth);
}

} // namespace

std::optional<RoomDetails> room_details(const Textile& textile, const RoomTables& tables, int voxels)
{
    const auto cell = drawn_cell(textile);
    if (!cell) return {};
    const DrawnLayer layer = layer_of_cell(textile, *cell, voxels);
    const double growth = tables.growth;
    const RoomPermeability full = room_permeability(layer, growth);
    const double by_warp = tables.level_along_warp, by_weft = tables.level_along_weft;
    const int below = (layer.first() + layer.last()) / 2 + 1,
              above = (layer.first() + layer.last() + 1) / 2; // a layer in the middle is of both
    RoomDetails found;
    found.through = std::sqrt(by_warp * by_weft) * permeability_through(layer, growth);
    found.lower = {open_share(layer, growth, layer.first(), below), by_warp * full.warp.lower, by_weft * full.weft.lower};
    found.upper = {open_share(layer, growth, above, layer.last() + 1), by_warp * full.warp.upper, by_weft * full.weft.upper};
    found.connected_along_warp = least_connected(layer, growth, &RunsOn::along_warp);
    found.connected_along_weft = least_connected(layer, growth, &RunsOn::along_weft);
    return found;
}

} // namespace hygroloom
