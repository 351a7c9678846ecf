// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/cli_room.h"

#include "app/cli.h"

#include "core/base/units.h"
#include "core/physics/water.h"
#include "core/scene/suction.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>

namespace hygroloom {
namespace {

struct Room {
    int voxels = 0;
    double seconds = 0;           ///< that it took
    double open = 0;              ///< share of the layer
    double warp = 0, weft = 0;    ///< m2
    double filling = 0, half = 0; ///< Pa
    double error = 0;             ///< of the permeabilities, the larger change from voxels 1.4 times as large
};

Room room_of(const Fabric& fabric, const FittedFabric& fitted)
{
    const Textile textile = build_textile(fabric, fitted, {0, 0, 1, 1});
    const double temperature = kelvin_from_celsius(20);
    const LiquidInPores water{water_surface_tension(temperature), water_viscosity(temperature)};
    Room room;
    room.voxels = 16;
    const auto start = std::chrono::steady_clock::now();
    const auto tables = room_tables(textile, room.voxels);
    room.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const auto coarser = room_tables(textile, static_cast<int>(std::lround(room.voxels / std::sqrt(2.0))));
    const BetweenParameters between = room_of_crossing(textile, 0, 0, water, *tables);
    room.open = between.volume / (textile.thickness * textile.warp.pitch * textile.weft.pitch);
    const double across = textile.thickness * textile.warp.pitch / (textile.weft.pitch * water.viscosity),
                 along = textile.thickness * textile.weft.pitch / (textile.warp.pitch * water.viscosity);
    room.warp = between.along_warp / across;
    room.weft = between.along_weft / along;
    room.filling = suction_filling(between.retention[both_wet], 0.5);
    room.half = suction_emptying(between.retention[both_wet], 0.5);
    if (!tables->types.empty()) {
        const auto changes = [](double fine, double coarse) { return fine > 0 ? std::abs(coarse / fine - 1) : 0.0; };
        room.error = std::max(changes(tables->types[0].along_warp, coarser->types[0].along_warp),
                              changes(tables->types[0].along_weft, coarser->types[0].along_weft));
    }
    return room;
}

} // namespace

void add_room_json(nlohmann::ordered_json& json, const Fabric& fabric, const FittedFabric& fitted)
{
    const Room room = room_of(fabric, fitted);
    json["room"] = {{"voxels_per_pitch", room.voxels},
                    {"seconds", room.seconds},
                    {"void", room.open},
                    {"permeability_m2", {{"warp", room.warp}, {"weft", room.weft}}},
                    {"filling_suction_pa", room.filling},
                    {"half_suction_pa", room.half},
                    {"error", room.error}};
}

void print_room(const Fabric& fabric, const FittedFabric& fitted)
{
    const Room room = room_of(fabric, fitted);
    print_result(
        "  room between yarns         {:.3g} of the layer; permeability {:.2g} m2 along the warp, {:.2g} along the weft, within {:.0f} %\n",
        room.open, room.warp, room.weft, 100 * room.error);
    print_result("                             water fills it at a suction of {:.0f} Pa; at {:.0f} Pa it has emptied to a half\n",
                 room.filling, room.half);
}

} // namespace hygroloom
