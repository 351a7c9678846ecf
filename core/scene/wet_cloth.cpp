// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/scene/wet_cloth.h"

#include "core/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace hygroloom {
namespace {

/// A cloth's segments and rooms as they are with a regain.
class Pores {
public:
    explicit Pores(const Scene& scene) : scene_(scene) {}

    std::size_t segments() const { return static_cast<std::size_t>(scene_.cloth.segments()); }
    std::size_t rooms() const { return scene_.cloth.by_suction ? segments() / 2 : 0; }
    std::size_t type_of(std::size_t i) const
    {
        const auto crossings = segments() / 2, picks = static_cast<std::size_t>(scene_.cloth.picks),
                   ends = static_cast<std::size_t>(scene_.cloth.ends);
        return scene_.cloth.type[i < crossings ? i / picks : ends + (i - crossings) / ends];
    }
    const YarnParameters& yarn_of(std::size_t i) const { return scene_.cloth.yarns[type_of(i)]; }
    double fibres(std::size_t i) const // kg
    {
        return yarn_of(i).fibre_area * yarn_of(i).fibre_density * scene_.cloth.fibre_length(i, yarn_of(i));
    }
    Swollen swollen(std::size_t i) const
    {
        const YarnParameters& yarn = yarn_of(i);
        const double length = scene_.cloth.fibre_length(i, yarn), dry = yarn.pore_area * length, fibres_m3 = yarn.fibre_area * length;
        const double room = rooms() > 0 ? between(crossing_of(i)).volume : 0.0;
        Swollen found = swollen_yarn(dry, fibres_m3, scene_.cloth.swelling * yarn.initial_regain * fibres(i), each_takes_of_room * room);
        const bool on_top = (scene_.cloth.warp_up[crossing_of(i)] != 0) == (i < segments() / 2);
        found.pores *= yarn.on_face[on_top ? 1 : 0].finish.holds;
        return found;
    }
    const BetweenParameters& between(std::size_t crossing) const
    {
        const auto picks = static_cast<std::size_t>(scene_.cloth.picks), wefts = static_cast<std::size_t>(scene_.cloth.weft_types());
        const std::size_t warp = scene_.cloth.type[crossing / picks],
                          weft = scene_.cloth.type[static_cast<std::size_t>(scene_.cloth.ends) + crossing % picks];
        return scene_.cloth.crossing[warp * wefts + weft - static_cast<std::size_t>(scene_.cloth.warp_types)].between;
    }
    double room(std::size_t crossing) const // m3
    {
        const auto picks = static_cast<std::size_t>(scene_.cloth.picks), ends = static_cast<std::size_t>(scene_.cloth.ends);
        const std::size_t weft = segments() / 2 + crossing % picks * ends + crossing / picks;
        return std::max(0.0, between(crossing).volume - swollen(crossing).grown - swollen(weft).grown);
    }

private:
    std::size_t crossing_of(std::size_t i) const
    {
        const std::size_t crossings = segments() / 2, ends = static_cast<std::size_t>(scene_.cloth.ends);
        return i < crossings ? i : (i - crossings) % ends * static_cast<std::size_t>(scene_.cloth.picks) + (i - crossings) / ends;
    }

    const Scene& scene_;
};

/// kg/kg that each type can still bind.
std::vector<double> bindable(const Scene& scene)
{
    std::vector<double> regains;
    for (const YarnParameters& yarn : scene.cloth.yarns)
        regains.push_back(scene.rules.sorption ? equilibrium_regain(yarn.isotherm, 1.0, scene.climate.temperature) - yarn.initial_regain
                                               : 0.0);
    return regains;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// One room, and what it holds at a suction.
struct Room {
    Retention retention;
    double volume; // m3

    double held_at(double suction) const { return volume * held_filling(retention, suction).saturation; }
};

/// kg in each room, all at the suction at which they hold so much together.
std::vector<double> fill_rooms(const std::vector<Room>& rooms, double density, double water)
{
    double low = 0, high = 0; // Pa
    for (const Room& room : rooms) {
        low = std::min(low, room.retention.full_at());
        high = std::max(high, room.retention.dry);
    }
    const auto all_at = [&](double suction) {
        double all = 0;
        for (const Room& room : rooms) all += density * room.held_at(suction);
        return all;
    };
    for (int round = 0; round < 60; ++round) {
        const double middle = 0.5 * (low + high);
        (all_at(middle) > water ? low : high) = middle;
    }
    const double all = all_at(high), rest = all > 0 ? water / all : 0.0; // what the rounds have left open
    std::vector<double> held;
    for (const Room& room : rooms) held.push_back(std::min(density * room.volume, rest * density * room.held_at(high)));
    return held;
}

/// What fibres bind, kg; with the regain that leaves them.
double bind(Scene& scene, double water)
{
    const std::vector<double> regains = bindable(scene);
    const Pores pores(scene);
    double most = 0;
    for (std::size_t i = 0; i < pores.segments(); ++i) most += regains[pores.type_of(i)] * pores.fibres(i);
    const double share = most > 0 ? std::min(1.0, water / most) : 0.0;
    for (std::size_t type = 0; type < regains.size(); ++type) scene.cloth.yarns[type].initial_regain += share * regains[type];
    return share * most;
}

std::vector<double> yarns_hold(const Scene& scene)
{
    const Pores pores(scene);
    std::vector<double> held(pores.segments());
    for (std::size_t i = 0; i < held.size(); ++i) held[i] = scene.climate.density * pores.swollen(i).pores;
    return held;
}

std::vector<Room> rooms_of(const Scene& scene)
{
    const Pores pores(scene);
    std::vector<Room> rooms;
    for (std::size_t crossing = 0; crossing < pores.rooms(); ++crossing) {
        const BetweenParameters& between = pores.between(crossing);
        const double volume = pores.room(crossing);
        const double finer = scene.cloth.swelling > 0 && volume > 0 ? between.volume / volume : 1.0;
        rooms.push_back({narrowed(between.retention[both_wet + covered], finer), volume});
    }
    return rooms;
}

} // namespace

void wet_evenly(Scene& scene, double water_per_area)
{
    const double area = scene.cloth.cell_area * scene.cloth.crossings(), water = water_per_area * area, density = scene.climate.density;
    ClothStart& start = scene.cloth.start;
    start.bound = bind(scene, water);
    double rest = water - start.bound;

    start.liquid = yarns_hold(scene);
    const double in_yarns = sum(start.liquid), share = in_yarns > 0 ? std::min(1.0, rest / in_yarns) : 0.0;
    for (double& liquid : start.liquid) liquid *= share;
    rest -= share * in_yarns;

    const double rounding = 1e-12 * water;
    if (rest > rounding && scene.cloth.by_suction) {
        const std::vector<Room> rooms = rooms_of(scene);
        double most = 0;
        for (const Room& room : rooms) most += density * room.volume;
        start.between = fill_rooms(rooms, density, std::min(rest, most));
        rest -= sum(start.between);
    }
    if (rest > rounding) start.film = rest;
    start.humidity = water > 0 ? 1.0 : -1.0;
    if (start.film <= density * 2.0 * most_film * area) return;
    const double most = water - start.film + density * 2.0 * most_film * area, per_area = 1e3 / area; // g/m2
    throw Error(
        fmt::format("This cloth holds {:.4g} g/m2 of water at most: {:.3g} in its fibres, {:.3g} in its yarns, {:.3g} between them and "
                    "{:.3g} as a film of {:g} mm on each face. The experiment's initial_water_g_m2 is {:g}.",
                    most * per_area, start.bound * per_area, in_yarns * per_area, sum(start.between) * per_area,
                    density * 2.0 * most_film * 1e3, most_film * 1e3, 1e3 * water_per_area));
}

} // namespace hygroloom
