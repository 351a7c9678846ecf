// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/room/room_tables.h"

#include "core/physics/between_yarns.h"
#include "core/room/room_flow.h"
#include "core/room/room_menisci.h"
#include "core/room/stokes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hygroloom {
namespace {

constexpr int most_pairs = 16; // of types that are drawn alone; of more, none is

/// The same cloth, so large, from its first end and pick on.
Textile part_of(Textile textile, int ends, int picks)
{
    textile.first_end = textile.first_pick = 0;
    textile.warp.count = ends;
    textile.weft.count = picks;
    return textile;
}

bool is_of_one_type(const YarnSystem& system) { return system.types.size() == 1 || system.order.size() == 1; }
int threads_of_period(int weave, const YarnSystem& system)
{
    return system.types.size() == 1 ? weave : std::lcm(weave, static_cast<int>(system.order.size()));
}

/// Of a weave that is too large, a part of its beginning.
Weave part_of(const Weave& weave)
{
    constexpr int side = 8;
    const int ends = std::min(weave.ends(), std::max(side, most_drawn_crossings / weave.picks())),
              picks = std::min(weave.picks(), most_drawn_crossings / ends);
    std::vector<std::uint8_t> up;
    for (int pick = 0; pick < picks; ++pick)
        for (int end = 0; end < ends; ++end) up.push_back(weave.warp_up(end, pick) ? 1 : 0);
    return {ends, picks, std::move(up)};
}

void of_one_type(YarnSystem& system, std::size_t type) { system.order.assign(1, static_cast<std::uint8_t>(type)); }

/// Of the layer, what the volume of yarns leaves.
double share_of_room(const Textile& cell)
{
    double sum = 0;
    for (int end = 0; end < cell.ends(); ++end)
        for (int pick = 0; pick < cell.picks(); ++pick) {
            const auto a = static_cast<std::size_t>(cell.type_of(YarnKind::warp, end)),
                       b = static_cast<std::size_t>(cell.type_of(YarnKind::weft, pick));
            const YarnType &warp = cell.warp.types[a], &weft = cell.weft.types[b];
            const double yarns =
                warp.area * warp.length_per_pitch[b] / cell.warp.pitch + weft.area * weft.length_per_pitch[a] / cell.weft.pitch;
            sum += std::max(least_share_of_room, 1 - yarns / cell.thickness);
        }
    return sum / cell.crossings();
}

/// Of all places, those of one pair of types.
struct Mean {
    double sum = 0;
    int places = 0;
    void add(double value)
    {
        sum += value;
        ++places;
    }
    double value() const { return places > 0 ? sum / places : 0; }
};

/// Of a full room, Stokes flow over what mobility gives. Where it is not computed: the mean of eleven cloths, 0.71 to 0.94 one by one.
struct Level {
    double warp = 0.81, weft = 0.81;
};
/// On a coarser grid: it depends little on that.
Level level_of_stokes(const Textile& cell, int shift, int voxels)
{
    const DrawnLayer layer = drawn_layer(cell, voxels, shift);
    const double growth = growth_to_share(layer, share_of_room(cell));
    const RoomPermeability full = room_permeability(layer, growth);
    const auto level = [&](bool warp, double mobile) { return mobile > 0 ? stokes_permeability(layer, growth, warp) / mobile : 1.0; };
    return {level(true, full.warp.mean), level(false, full.weft.mean)};
}
void scale(AlongRoom& along, double by)
{
    along.mean *= by;
    along.lower *= by;
    along.upper *= by;
    for (double& place : along.places) place *= by;
}

double falls(double of_half, double of_full, double saturation)
{
    constexpr double least = 1, most = 4;
    if (!(of_half > 0 && of_full > 0 && saturation < 0.95)) return most;
    return std::clamp(std::log(of_half / of_full) / std::log(saturation), least, most);
}

/// Tables by pairs of types and by place, of what is known of each crossing of a cell.
void fill(RoomTables& tables, const Textile& drawn, const WovenCell& cell, const RoomSkin& skin, const RoomPermeability& full,
          const RoomStates& states)
{
    const std::size_t wefts = drawn.weft.types.size(), pairs = drawn.warp.types.size() * wefts;
    const auto types_at = [&](int end, int pick) {
        return static_cast<std::size_t>(drawn.type_of(YarnKind::warp, end)) * wefts +
               static_cast<std::size_t>(drawn.type_of(YarnKind::weft, pick));
    };
    const auto by_types = [&](const std::vector<double>& places) {
        std::vector<Mean> means(pairs);
        for (int end = 0; end < cell.ends; ++end)
            for (int pick = 0; pick < cell.picks; ++pick) means[types_at(end, pick)].add(places[cell.crossing(end, pick)]);
        return means;
    };
    const std::vector<Mean> warp_skin = by_types(skin.warp), weft_skin = by_types(skin.weft), faces = by_types(skin.faces),
                            along_warp = by_types(full.warp.places), along_weft = by_types(full.weft.places);
    tables.types.resize(pairs);
    for (std::size_t k = 0; k < pairs; ++k)
        tables.types[k] = {warp_skin[k].value(),  weft_skin[k].value(),  faces[k].value(),
                           along_warp[k].value(), along_weft[k].value(), states};
    if (pairs == 1) { // then what it comes to is known
        tables.types[0].along_warp = full.warp.mean;
        tables.types[0].along_weft = full.weft.mean;
    }
    tables.ends = cell.ends_of_period();
    tables.picks = cell.picks;
    for (int end = 0; end < tables.ends; ++end)
        for (int pick = 0; pick < tables.picks; ++pick) {
            const std::size_t at = cell.crossing(end, pick);
            const DrawnRoom& mean = tables.types[types_at(end, pick)];
            const auto over = [](double place, double of_types) { return static_cast<float>(of_types > 0 ? place / of_types : 1); };
            tables.warp_places.push_back(over(full.warp.places[at], mean.along_warp));
            tables.weft_places.push_back(over(full.weft.places[at], mean.along_weft));
        }
}

/// To so many digits: what is left of equations that are solved by rounds does not show, and cloth turned over has the same tables.
double to_digits(int digits, double value)
{
    if (!(std::abs(value) > 0) || !std::isfinite(value)) return value;
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - (digits - 1));
    return unit * std::round(value / unit);
}
void round_all(RoomTables& tables)
{
    for (DrawnRoom& room : tables.types) {
        for (double* value : {&room.warp_skin, &room.weft_skin, &room.faces, &room.along_warp, &room.along_weft})
            *value = to_digits(4, *value);
        RoomStates& states = room.states;
        for (RestingState* state : {&states.almost, &states.sunk, &states.knee, &states.low, &states.fills, &states.breaks})
            for (double* value : {&state->curvature, &state->warp, &state->weft}) *value = to_digits(3, *value);
    }
    for (std::vector<float>* places : {&tables.warp_places, &tables.weft_places})
        for (float& place : *places) place = static_cast<float>(to_digits(4, static_cast<double>(place)));
}

Weave drawn_part(const Weave& weave) { return weave.ends() * weave.picks() <= most_drawn_crossings ? weave : part_of(weave); }

RoomTables found_tables(const Textile& textile, int voxels)
{
    const std::size_t warps = textile.warp.types.size(), wefts = textile.weft.types.size();
    if (const auto cell = drawn_cell(textile)) return tables_of_cell(textile, *cell, voxels);
    RoomTables tables;
    if (warps * wefts > most_pairs) return tables;
    const Weave part = drawn_part(textile.weave);
    for (std::size_t warp = 0; warp < warps; ++warp)
        for (std::size_t weft = 0; weft < wefts; ++weft) {
            Textile alone = textile;
            alone.weave = part;
            of_one_type(alone.warp, warp);
            of_one_type(alone.weft, weft);
            const RoomTables found = tables_of_cell(alone, {part.ends(), part.picks()}, voxels);
            tables.types.push_back(found.types[warp * wefts + weft]);
            tables.growth += found.growth / static_cast<double>(warps * wefts);
            tables.falls_along_warp += found.falls_along_warp / static_cast<double>(warps * wefts);
            tables.falls_along_weft += found.falls_along_weft / static_cast<double>(warps * wefts);
        }
    return tables;
}

} // namespace

std::optional<WovenCell> drawn_cell(const Textile& textile)
{
    constexpr int makes_period = 3; // so many cells or more
    const int ends = threads_of_period(textile.weave.ends(), textile.warp), picks = threads_of_period(textile.weave.picks(), textile.weft);
    const long period = static_cast<long>(ends) * picks, most = std::min<long>(most_drawn_crossings, period / makes_period);
    if (is_of_one_type(textile.warp) && is_of_one_type(textile.weft))
        if (const auto cell = smallest_cell(textile.weave, static_cast<int>(most))) return cell;
    if (period <= most_drawn_crossings) return WovenCell{ends, picks};
    return {};
}

DrawnLayer layer_of_cell(const Textile& textile, const WovenCell& cell, int voxels)
{
    return drawn_layer(part_of(textile, cell.ends, cell.picks), voxels, cell.shift);
}

DrawnRepeat drawn_repeat(const Textile& textile, int voxels, const Widening& wider)
{
    const auto repeat = [&](const Textile& all, const WovenCell& cell) {
        const Textile drawn = part_of(all, cell.ends, cell.picks);
        DrawnLayer layer = drawn_layer(drawn, voxels, cell.shift);
        const double growth = growth_to_share(layer, share_of_room(drawn));
        if (wider.warp != 0 || wider.weft != 0) layer = drawn_layer(drawn, voxels, cell.shift, wider);
        return DrawnRepeat{std::move(layer), growth};
    };
    if (is_of_one_type(textile.warp) && is_of_one_type(textile.weft))
        if (const auto cell = smallest_cell(textile.weave, most_drawn_crossings)) return repeat(textile, *cell);
    if (const auto cell = drawn_cell(textile)) return repeat(textile, *cell);
    Textile alone = textile;
    alone.weave = drawn_part(textile.weave);
    of_one_type(alone.warp, 0);
    of_one_type(alone.weft, 0);
    return repeat(alone, {alone.weave.ends(), alone.weave.picks()});
}

DrawnVolume drawn_volume(const Textile& textile)
{
    const double of_one = cubes_of_crossing(textile), cube = side_of_cube(textile);
    const auto drawn = [&](int ends, int picks, int periods) {
        return DrawnVolume{of_one * ends * picks, periods, std::max(ends * textile.warp.pitch, picks * textile.weft.pitch) / cube};
    };
    if (const auto cell = drawn_cell(textile)) return drawn(cell->ends, cell->picks, 1);
    const auto pairs = static_cast<int>(textile.warp.types.size() * textile.weft.types.size());
    const Weave part = drawn_part(textile.weave);
    return drawn(part.ends(), part.picks(), pairs > most_pairs ? 0 : pairs);
}

RoomTables tables_of_cell(const Textile& textile, const WovenCell& cell, int voxels)
{
    const Textile drawn = part_of(textile, cell.ends, cell.picks);
    const DrawnLayer layer = drawn_layer(drawn, voxels, cell.shift);
    RoomTables tables;
    tables.growth = growth_to_share(layer, share_of_room(drawn));
    const RoomSkin skin = skin_of_room(drawn, tables.growth, cell.shift);
    RoomPermeability full = room_permeability(layer, tables.growth);
    const Level level = voxels >= stokes_voxels ? level_of_stokes(drawn, cell.shift, voxels / 2) : Level{};
    tables.level_along_warp = level.warp;
    tables.level_along_weft = level.weft;
    scale(full.warp, level.warp);
    scale(full.weft, level.weft);
    RestingLiquid liquid(layer, tables.growth, reference_cosine);
    const RoomStates states = states_of_room(liquid);
    const PartlyFull half = half_full(layer, tables.growth);
    const RoomPermeability left = room_permeability(layer, tables.growth, half.air);
    tables.falls_along_warp = falls(left.warp.mean, full.warp.mean, half.saturation);
    tables.falls_along_weft = falls(left.weft.mean, full.weft.mean, half.saturation);
    fill(tables, drawn, cell, skin, full, states);
    return tables;
}

RoomTables find_room_tables(const Textile& textile, int voxels)
{
    RoomTables tables = found_tables(textile, voxels);
    round_all(tables);
    return tables;
}

} // namespace hygroloom
