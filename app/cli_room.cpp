// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/cli_room.h"

#include "app/cli.h"

#include "core/base/units.h"
#include "core/physics/water.h"
#include "core/plan/fidelity.h"
#include "core/room/kept_tables.h"
#include "core/room/room_details.h"
#include "core/scene/suction.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <map>
#include <optional>

namespace hygroloom {
namespace {

/// As a draft has them, and fewer to tell the error by.
const int voxels_per_pitch = static_cast<int>(knobs_of(Fidelity::draft).room_voxels), coarser_voxels = voxels_per_pitch * 2 / 3;

struct Room {
    std::optional<double> seconds; ///< that it took; none: it was found before
    DrawnRoom drawn;
    double open = 0;              ///< share of the layer
    double filling = 0, half = 0; ///< Pa; less than 0: the liquid presses
    double growth = 0;            ///< m, see RoomTables
    std::optional<RoomDetails> details;
    double error = 0; ///< see WithoutLiquid
};

/// What depends on the cloth's drawing alone, so that fabrics that differ in colour or liquid share it.
struct WithoutLiquid {
    std::optional<RoomDetails> details;
    double error = 0; ///< of the permeabilities: the larger change that coarser voxels make, as a share
};

WithoutLiquid without_liquid(const Textile& textile, const RoomTables& tables)
{
    WithoutLiquid found{room_details(textile, tables, voxels_per_pitch), 0};
    const DrawnRoom &drawn = tables.types[0], coarse = room_tables(textile, coarser_voxels)->types[0];
    const auto changes = [](double fine, double other) { return fine > 0 ? std::abs(other / fine - 1) : 0.0; };
    found.error = std::max(changes(drawn.along_warp, coarse.along_warp), changes(drawn.along_weft, coarse.along_weft));
    return found;
}

/// None where the cloth is not drawn: see room_tables().
std::optional<Room> room_of(const Fabric& fabric, const FittedFabric& fitted)
{
    const Textile textile = build_textile(fabric, fitted, {0, 0, 1, 1});
    const double temperature = kelvin_from_celsius(20);
    const LiquidInPores water{water_surface_tension(temperature), water_viscosity(temperature)};
    const bool found_before = room_tables_are_kept(textile, voxels_per_pitch);
    const auto start = std::chrono::steady_clock::now();
    const auto tables = room_tables(textile, voxels_per_pitch);
    if (tables->types.empty()) return {};
    Room room;
    if (!found_before) room.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    room.drawn = tables->types[0];
    room.growth = tables->growth;
    const BetweenParameters between = room_of_crossing(textile, 0, 0, water, *tables);
    room.open = between.volume / (textile.thickness * textile.warp.pitch * textile.weft.pitch);
    room.filling = between.retention[both_wet].front;
    room.half = suction_emptying(between.retention[both_wet], 0.5);
    static std::map<std::shared_ptr<const RoomTables>, WithoutLiquid> found; // cloths drawn alike have the same tables
    const auto known = found.find(tables);
    const WithoutLiquid& same =
        known != found.end() ? known->second : found.emplace(tables, without_liquid(textile, *tables)).first->second;
    room.details = same.details;
    room.error = same.error;
    return room;
}

std::string at_suction(double pascal)
{
    return pascal >= 0 ? fmt::format("at a suction of {:.0f} Pa", pascal) : fmt::format("under a pressure of {:.0f} Pa", -pascal);
}

} // namespace

void add_room_json(nlohmann::ordered_json& json, const Fabric& fabric, const FittedFabric& fitted)
{
    json["room"] = nullptr;
    const auto room = room_of(fabric, fitted);
    if (!room) return;
    json["room"] = {{"voxels_per_pitch", voxels_per_pitch},
                    {"seconds", room->seconds ? Json(*room->seconds) : Json(nullptr)},
                    {"void", room->open},
                    {"permeability_m2", {{"warp", room->drawn.along_warp}, {"weft", room->drawn.along_weft}}},
                    {"filling_suction_pa", room->filling},
                    {"half_suction_pa", room->half},
                    {"yarns_grown_um", um_from_metre(room->growth)},
                    {"error", room->error}};
    if (!room->details) return;
    const auto half = [](const RoomHalf& side) {
        return nlohmann::ordered_json{{"void", side.open}, {"permeability_m2", {{"warp", side.along_warp}, {"weft", side.along_weft}}}};
    };
    json["room"]["permeability_m2"]["through"] = room->details->through;
    json["room"]["threshold"] = {{"warp", room->details->connected_along_warp}, {"weft", room->details->connected_along_weft}};
    json["room"]["faces"] = {half(room->details->upper), half(room->details->lower)}; // the top first
}

void print_room(const Fabric& fabric, const FittedFabric& fitted)
{
    const auto room = room_of(fabric, fitted);
    if (!room) return;
    print_result("  room between yarns         {:.3g} of the layer; permeability {:.2g} m2 along the warp, {:.2g} along the weft\n",
                 room->open, room->drawn.along_warp, room->drawn.along_weft);
    print_result("                             {} voxels from yarn to yarn change these by {:.0f} %\n", coarser_voxels, 100 * room->error);
    if (room->details)
        print_result(
            "                             {:.2g} m2 through the cloth. Liquid runs on until it fills {:.2g} of the room along the warp, "
            "{:.2g} along the weft; more voxels make that up to four times less\n",
            room->details->through, room->details->connected_along_warp, room->details->connected_along_weft);
    print_result("                             dry, it takes water in {}; full, it has emptied to a half {}\n", at_suction(room->filling),
                 at_suction(room->half));
}

} // namespace hygroloom
