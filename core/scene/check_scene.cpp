// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What every scene must fulfil, whoever makes it.
#include "core/base/error.h"
#include "core/scene/scene.h"

#include <algorithm>

namespace hygroloom {
namespace {

void demand(bool fulfilled, const char* fault)
{
    if (!fulfilled) throw Error(std::string("The scene cannot be run: ") + fault + ".");
}

bool empty_or(std::size_t size, int count) { return size == 0 || size == static_cast<std::size_t>(count); }

} // namespace

void check(const Cloth& cloth)
{
    demand(cloth.ends > 0 && cloth.picks > 0, "its cloth has no crossing");
    demand(cloth.length.size() == static_cast<std::size_t>(cloth.segments()), "its cloth does not have a length for each segment");
    demand(std::all_of(cloth.length.begin(), cloth.length.end(), [](double length) { return length > 0; }), "a segment has no length");
    demand(empty_or(cloth.pores.size(), cloth.segments()), "its cloth does not have pores for each segment");
    demand(empty_or(cloth.shift.size(), cloth.segments()), "its cloth does not have a shift for each segment");
    demand(empty_or(cloth.touching.size(), cloth.segments()), "its cloth does not say of each segment how it touches the next");
    demand(empty_or(cloth.start.liquid.size(), cloth.segments()), "its cloth does not begin with liquid for each segment");
    demand(cloth.warp_up.size() == static_cast<std::size_t>(cloth.crossings()), "its cloth does not say at each crossing which yarn is up");
    demand(empty_or(cloth.warp_up_share.size(), cloth.crossings()), "its cloth does not have a share for each crossing");
    demand(cloth.warp_types > 0 && cloth.weft_types() > 0, "its cloth has no type of warp or of weft");
    demand(cloth.crossing.size() == static_cast<std::size_t>(cloth.warp_types * cloth.weft_types()),
           "its cloth does not say how each type of warp crosses each type of weft");
    demand(cloth.type.size() == static_cast<std::size_t>(cloth.ends + cloth.picks), "its cloth does not have a type for each end and pick");
    demand(std::all_of(cloth.type.begin(), cloth.type.end(), [&](std::uint8_t type) { return type < cloth.yarns.size(); }),
           "an end or a pick is of a type that does not exist");
    demand(cloth.cell_area >= 0 && cloth.warp_pitch > 0 && cloth.weft_pitch > 0, "its cloth has no area");
}

void check(const SceneClimate& climate)
{
    demand(climate.temperature > 0 && climate.density > 0, "its climate has no temperature or no density of the liquid");
    demand(climate.course.empty() || climate.course.front().time == 0, "its climate does not begin at 0 s");
    const auto goes_back = [](const AirMoment& a, const AirMoment& b) { return b.time < a.time; };
    demand(std::adjacent_find(climate.course.begin(), climate.course.end(), goes_back) == climate.course.end(),
           "its climate is not in order of time");
}

void check(const Supply& supply)
{
    for (const SceneDroplet& drop : supply.droplets) demand(drop.volume > 0, "a drop has no volume");
    const auto by_time = [](const SceneDroplet& a, const SceneDroplet& b) { return a.time < b.time; };
    demand(std::is_sorted(supply.droplets.begin(), supply.droplets.end(), by_time), "its drops are not in order of time");
    for (const ScenePool& pool : supply.pools) demand(pool.end >= pool.start && pool.rate >= 0, "a pool ends before it begins");
    for (const ScenePool& pool : supply.pools)
        demand(pool.drop >= 0 && (pool.drop == 0 || pool.rate > 0), "drops join a pool that nothing feeds");
    demand(supply.sweat >= 0, "it takes sweat away");
}

void check(const FreeLiquidStart& liquid)
{
    demand(liquid.velocities.size() == liquid.places.size(), "its free liquid does not have a velocity for each place");
    demand(liquid.places.empty() || liquid.particle_volume > 0, "its free liquid has no volume");
}

void check(const StepRules& rules)
{
    demand(rules.network_step > 0, "its yarns have no step");
    demand(rules.fibre_shells >= 1 && rules.fibre_shells <= largest_shell_count, "its fibres have too many shells or none");
}

void check(const Scene& scene)
{
    check(scene.cloth);
    check(scene.climate);
    check(scene.supply);
    check(scene.liquid);
    check(scene.rules);
    const bool drops = !scene.supply.droplets.empty(), has_free_liquid = drops || !scene.liquid.places.empty();
    demand(!has_free_liquid || scene.rules.liquid_step_factor > 0, "its free liquid has no step");
    demand(!scene.cloth.by_suction || scene.supply.pools.size() <= 1, "several pools stand on cloth in which liquid flows by suction");
    demand(scene.rules.suction_rounds >= 1, "suctions are found in no rounds");
    demand(!drops || !scene.liquid.places.empty() || scene.rules.particles_per_droplet > 0, "its drops have no particles");
    demand(empty_or(scene.supply.fed.size(), scene.cloth.segments()), "it does not say of each segment whether it hangs in liquid");
    demand(scene.cloth.shapes.size() == scene.cloth.yarns.size() || !has_free_liquid, "its yarns have no shape that liquid could meet");
}

} // namespace hygroloom
