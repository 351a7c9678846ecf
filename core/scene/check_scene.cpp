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

bool is_of(std::size_t size, int count) { return size == static_cast<std::size_t>(count); }

/// Pieces of yarns in chains and rings.
void check_chains(const ClothPanels& p, int segments)
{
    demand(is_of(p.joint_yarns.size(), static_cast<int>(p.order.size())) && is_of(p.joint_rooms.size(), static_cast<int>(p.order.size())) &&
               p.warp_chains >= 0 && p.warp_chains <= static_cast<int>(p.chain_ends.size()) &&
               is_of(p.order.size(), 2 * static_cast<int>(p.crossings.size())),
           "its pieces of yarn are in no chain");
    demand(std::is_sorted(p.chain_ends.begin(), p.chain_ends.end()) &&
               (p.chain_ends.empty() || is_of(p.order.size(), p.chain_ends.back())) &&
               std::all_of(p.order.begin(), p.order.end(), [&](int segment) { return segment >= 0 && segment < segments; }),
           "its chains of yarns are not in order");
    const auto is_joint = [&](std::size_t place) { return p.joint_yarns[place] >= 0; };
    for (std::size_t place = 0; place < p.order.size(); ++place)
        demand(is_joint(place) ? p.joint_rooms[place] >= 0 : p.joint_yarns[place] < 0, "a chain of yarns is sewn by nothing");
    int first = 0;
    for (int end : p.chain_ends) {
        demand(end >= first && (end - first != 1 || !is_joint(static_cast<std::size_t>(first))), "a chain of yarns is sewn to itself");
        first = end;
    }
}

/// Every place that panels name must be there: stages do not ask.
void check_panels(const Cloth& cloth)
{
    const ClothPanels& p = cloth.panels;
    const int segments = cloth.segments(), crossings = cloth.crossings();
    demand(cloth.by_suction, "a garment's liquid must flow by suction");
    demand(p.first.size() == p.last.size() && p.warp_pieces >= 0 && p.warp_pieces <= static_cast<int>(p.first.size()),
           "a piece of a panel's yarn has no end");
    int before = 0;
    for (std::size_t k = 0; k < p.first.size(); ++k) {
        const int from = static_cast<int>(k) < p.warp_pieces ? 0 : crossings, to = from == 0 ? crossings : segments;
        const int along = from == 0 ? cloth.picks : cloth.ends;
        demand(p.first[k] >= std::max(from, before) && p.first[k] < p.last[k] && p.last[k] <= to &&
                   (p.first[k] - from) / along == (p.last[k] - 1 - from) / along,
               "a piece of a panel's yarn lies outside its yarn");
        before = p.last[k];
    }
    const auto is_crossing = [&](int crossing) { return crossing >= 0 && crossing < crossings; };
    demand(std::all_of(p.crossings.begin(), p.crossings.end(), is_crossing) && std::is_sorted(p.crossings.begin(), p.crossings.end()),
           "a panel's crossing does not exist");
    demand(is_of(p.panel.size(), cloth.picks) && is_of(p.cell_area.size(), p.count) && is_of(p.skin_on_top.size(), p.count) &&
               is_of(p.air.size(), crossings) && is_of(p.rise.size(), segments),
           "its panels are not described in full");
    demand(std::all_of(p.panel.begin(), p.panel.end(), [&](std::uint8_t panel) { return panel < p.count; }), "a pick is of no panel");
    demand(std::all_of(p.air.begin(), p.air.end(), [&](std::uint8_t air) { return air < p.airs.size(); }), "a place has no air");
    check_chains(p, segments);
    int group = 0;
    for (int end : cloth.seams.group_ends) {
        demand(end >= group, "its seams are not in order");
        group = end;
    }
    demand(is_of(cloth.seams.joints.size(), group), "a seam is in no group");
    for (const SeamJoint& joint : cloth.seams.joints)
        demand(joint.a >= 0 && joint.b >= 0 && joint.a < segments && joint.b < segments && joint.yarns >= 0 && joint.rooms >= 0,
               "a seam joins what does not exist");
    group = 0;
    for (int end : cloth.layers.group_ends) {
        demand(end >= group, "its layers are not in order");
        group = end;
    }
    demand(is_of(cloth.layers.joints.size(), group), "two places of layers are in no group");
    for (const LayerJoint& joint : cloth.layers.joints)
        demand(joint.a >= 0 && joint.b >= 0 && joint.a < cloth.crossings() && joint.b < cloth.crossings() && joint.a != joint.b &&
                   joint.yarns >= 0 && joint.heat >= 0 && joint.vapour >= 0,
               "two layers touch where there is no cloth");
}

} // namespace

void check(const Cloth& cloth)
{
    demand(cloth.ends > 0 && cloth.picks > 0, "its cloth has no crossing");
    demand(cloth.length.size() == static_cast<std::size_t>(cloth.segments()), "its cloth does not have a length for each segment");
    demand(std::all_of(cloth.length.begin(), cloth.length.end(), [](double length) { return length > 0; }), "a segment has no length");
    demand(empty_or(cloth.pores.size(), cloth.segments()), "its cloth does not have pores for each segment");
    demand(empty_or(cloth.shift.size(), cloth.segments()), "its cloth does not have a shift for each segment");
    demand(empty_or(cloth.touching.size(), cloth.segments()), "its cloth does not say of each segment how it touches the next");
    demand(empty_or(cloth.room_along.size(), cloth.segments()), "its cloth does not say of each segment how its room conducts");
    demand(empty_or(cloth.start.liquid.size(), cloth.segments()), "its cloth does not begin with liquid for each segment");
    demand(cloth.warp_up.size() == static_cast<std::size_t>(cloth.crossings()), "its cloth does not say at each crossing which yarn is up");
    demand(empty_or(cloth.warp_up_share.size(), cloth.crossings()), "its cloth does not have a share for each crossing");
    demand(cloth.warp_types > 0 && cloth.weft_types() > 0, "its cloth has no type of warp or of weft");
    demand(cloth.crossing.size() == static_cast<std::size_t>(cloth.warp_types * cloth.weft_types()),
           "its cloth does not say how each type of warp crosses each type of weft");
    demand(cloth.type.size() == static_cast<std::size_t>(std::max(1, cloth.panels.count) * cloth.ends + cloth.picks),
           "its cloth does not have a type for each end and pick");
    demand(std::all_of(cloth.type.begin(), cloth.type.end(), [&](std::uint8_t type) { return type < cloth.yarns.size(); }),
           "an end or a pick is of a type that does not exist");
    if (cloth.panels.count > 0) check_panels(cloth);
    demand(cloth.shown_ends >= 0 && cloth.shown_ends <= cloth.ends && cloth.shown_picks >= 0 && cloth.shown_picks <= cloth.picks &&
               (cloth.shown_ends > 0) == (cloth.shown_picks > 0) && (cloth.shown_ends == 0 || cloth.panels.count == 0),
           "it is shown in cells that it does not have");
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
    demand(supply.skin.holds >= 0 && std::all_of(supply.skin.rate.begin(), supply.skin.rate.end(), [](double rate) { return rate >= 0; }),
           "its skin takes sweat away");
    demand(std::all_of(supply.skin.course.begin(), supply.skin.course.end(), [](const SweatMoment& moment) { return moment.factor >= 0; }),
           "its skin takes sweat away");
    for (const std::vector<SkinMoment>& moments : supply.skin.zones) {
        demand(!moments.empty(), "a zone of its skin has no moment");
        demand(std::all_of(moments.begin(), moments.end(), [](const SkinMoment& moment) { return moment.rate >= 0; }),
               "its skin takes sweat away");
        demand(std::is_sorted(moments.begin(), moments.end(), [](const SkinMoment& a, const SkinMoment& b) { return a.time < b.time; }),
               "a zone of its skin is not in order of time");
    }
    for (const SkinAir& air : supply.skin.airs)
        demand(air.zone < supply.skin.zones.size() && air.outer + air.to_skin > 0, "an air lies over no zone of its skin");
}

void check(const FreeLiquidStart& liquid)
{
    demand(liquid.velocities.size() == liquid.places.size(), "its free liquid does not have a velocity for each place");
    demand(liquid.places.empty() || liquid.particle_volume > 0, "its free liquid has no volume");
}

void check(const StepRules& rules)
{
    demand(rules.network_step > 0, "its yarns have no step");
    demand(rules.step_share >= 0 && rules.step_share < 1, "its steps have no share of the time");
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
    demand(!scene.caps.on || (scene.cloth.by_suction && scene.supply.pools.empty() && scene.liquid.places.empty()),
           "caps stand beside a pool or particles, or on cloth in which liquid does not flow by suction");
    demand(!scene.caps.on || (scene.caps.advancing > 0 && scene.caps.receding >= 0 && scene.caps.receding <= scene.caps.advancing),
           "its caps have no angles");
    demand(scene.rules.suction_rounds >= 1, "suctions are found in no rounds");
    demand(!drops || scene.caps.on || !scene.liquid.places.empty() || scene.rules.particles_per_droplet > 0, "its drops have no particles");
    demand(scene.supply.skin.rate.empty() ||
               (scene.cloth.panels.count > 0 && empty_or(scene.supply.skin.rate.size(), scene.cloth.crossings())),
           "its skin is not that of a garment");
    demand(scene.cloth.panels.count == 0 || (!has_free_liquid && scene.supply.pools.empty() && scene.supply.fed.empty()),
           "liquid comes to a garment otherwise than from the skin");
    demand(empty_or(scene.supply.fed.size(), scene.cloth.segments()), "it does not say of each segment whether it hangs in liquid");
    demand(scene.cloth.shapes.size() == scene.cloth.yarns.size() || !has_free_liquid, "its yarns have no shape that liquid could meet");
}

} // namespace hygroloom
