// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The part of a yarn network's step in which liquid comes from outside: from pools, drops that stand as caps, and sweat.
#pragma once

#include "core/solver/steps/press_out.h"
#include "core/solver/yarn_network.h"

#include <utility>

namespace hygroloom {

template <typename Executor> double YarnNetwork<Executor>::next_event(double time) const
{
    double next = std::numeric_limits<double>::infinity();
    const auto consider = [&](double event) {
        if (event > time) next = std::min(next, event);
    };
    for (const ScenePool& pool : scene_->supply.pools) consider(pool.next_change(time));
    for (const AirMoment& moment : scene_->climate.course) consider(moment.time);
    consider(scene_->supply.skin.next_change(time));
    consider(caps_.next_event(time));
    return next;
}

template <typename Executor> bool YarnNetwork<Executor>::jumps_at(double time) const
{
    const std::vector<AirMoment>& course = scene_->climate.course;
    const std::vector<SceneDroplet>& drops = scene_->supply.droplets;
    if (scene_->caps.on && std::any_of(drops.begin(), drops.end(), [time](const SceneDroplet& drop) { return drop.time == time; }))
        return true;
    return std::count_if(course.begin(), course.end(), [time](const AirMoment& moment) { return moment.time == time; }) > 1;
}

/// Liquid that came without drops in the last dt.
template <typename Executor> void YarnNetwork<Executor>::supply(double time, double dt)
{
    if (!scene_->supply.fed.empty()) each_segment("keep fed", KeepFed{segments(), climate_.density});
    feed_from_pools(time, dt);
    if (scene_->caps.on) take_drops(time, dt);
    if (scene_->supply.sweat > 0) sweat(dt);
    if (!scene_->supply.skin.rate.empty()) sweat_from_skin(time, dt);
    may_have_absorbed_ = may_have_absorbed_ || !pools_.standing.empty() || scene_->supply.sweat > 0 || !scene_->supply.skin.rate.empty();
}

/// Pools fill, and the yarns under them absorb.
template <typename Executor> void YarnNetwork<Executor>::feed_from_pools(double time, double dt)
{
    pools_.fill(*scene_, time, dt, climate_.density);
    if (by_suction() && scene_->rules.wicking) { // yarns draw while liquid moves
        if (pools_.feeds()) face_under(0);       // visited before any stage of this step
        return;
    }
    for (std::size_t k = 0; k < pools_.standing.size(); ++k) {
        if (pools_.standing[k] <= 0) continue;
        const FedFace face = face_under(k);
        totals_.write(0, {});
        const AskPool ask{segments(), face, climate_.density, dt, -1.0, &totals_.data()->asked};
        each_segment("ask pool", ask);
        each_segment("take from pool", TakeFromPool{ask, pools_.standing[k], &totals_.data()->given});
        pools_.standing[k] -= totals_.read(0).given;
    }
}

/// Each segment of the face gets its share; what finds no room runs off.
template <typename Executor> void YarnNetwork<Executor>::sweat(double dt)
{
    const double each = scene_->supply.sweat * scene_->cloth.cell_area * climate_.density * dt;
    const std::int64_t offered = static_cast<std::int64_t>(each / water_quantum) * scene_->cloth.crossings();
    totals_.write(0, {});
    const AskPool ask{segments(), {scene_->supply.sweat_on_top, -1.0, 0, 0}, climate_.density, dt, each, &totals_.data()->asked};
    each_segment("sweat", TakeFromPool{ask, offered, &totals_.data()->given});
    pools_.pumped.add(offered);
    pools_.ran_off.add(offered - totals_.read(0).given);
}

/// Each crossing's skin gives what the cloth over it takes.
template <typename Executor> void YarnNetwork<Executor>::sweat_from_skin(double time, double dt)
{
    const SkinSupply& skin = scene_->supply.skin;
    totals_.write(0, {});
    const double begins = 0.5 * (time + time - dt); // the factor changes at steps' ends only, and zones change evenly between them
    if (skin.has_zones()) fields_.sweat.upload(skin.rates_at(begins));
    if (!skin.airs.empty()) panels_.airs.upload(skin.airs_at(scene_->cloth.panels.airs, begins));
    each_crossing("sweat", SweatFromSkin{segments(), climate_.density, skin.factor_at(begins) * dt, dt, skin.holds, &totals_.data()->asked,
                                         &totals_.data()->shed});
    const YarnTotals found = totals_.read(0);
    pools_.pumped.add(found.asked);
    pools_.ran_off.add(found.shed);
}

template <typename Executor> void YarnNetwork<Executor>::squeeze(double share)
{
    totals_.write(0, {});
    each_segment("squeeze", PressOut{segments(), climate_.density, share, &totals_.data()->pressed_out});
    pools_.ran_off.add(totals_.read(0).pressed_out);
    pools_.ran_off.add(caps_.wipe_off());
    for (std::int64_t& standing : pools_.standing) pools_.ran_off.add(std::exchange(standing, 0));
    pools_.ran_off.add(std::exchange(film_, 0));
}

/// Drops fall, land and spread in the last dt, as caps.
template <typename Executor> void YarnNetwork<Executor>::take_drops(double time, double dt)
{
    pools_.pumped.add(caps_.release(time));
    cap_landed_ = caps_.spread(time, dt);
    caps_on_face_ = caps_.on_face(time);
    cover_a_cell(caps_on_face_);
}

/// Each covers one of the places looked at, at least.
template <typename Executor> void YarnNetwork<Executor>::cover_a_cell(std::vector<CapOnFace>& caps) const
{
    constexpr double least = 0.75; // of a cell's side
    for (CapOnFace& cap : caps) cap.base = std::max(cap.base, least * widest_cell());
}

template <typename Executor> FindCap YarnNetwork<Executor>::find_cap(int count)
{
    const Cloth& cloth = scene_->cloth;
    constexpr int places = 8; // along a side: a cap's edge goes through few cells, and jumps of what is under it would be seen
    return {segments(), cap_views_.data(), count, {true, 0, cloth.warp_pitch, cloth.weft_pitch, places}};
}

/// Before any stage of a step.
template <typename Executor> void YarnNetwork<Executor>::visit_standing()
{
    for (const std::vector<CapOnFace>* caps : {&caps_on_face_, &drops_on_face_})
        for (const CapOnFace& cap : *caps) region_.include_disc(cap.x, cap.y, std::max(cap.base, widest_cell()) + widest_cell());
    for (std::size_t k = 0; k < pools_.standing.size() && scene_->rules.vapour; ++k)
        if (pools_.standing[k] > 0) face_under(k);
}

/// All that stands on the cloth, with what it exchanges with the air.
template <typename Executor> StandingOnFace YarnNetwork<Executor>::standing(double time)
{
    StandingOnFace found;
    const auto add = [&](const CapOnFace& cap, std::int64_t* water) {
        found.caps.push_back(cap);
        found.water.push_back(water);
    };
    const auto add_face = [&](std::int64_t& water, double radius, double area) {
        if (water > 0) add({0, 0, radius, 0, water, 0, area * climate_.mass_transfer, area * climate_.heat_transfer}, &water);
    };
    add_face(film_, -1.0, scene_->cloth.cell_area * scene_->cloth.segments()); // the first: see StandingLiquid
    for (std::size_t k = 0; k < pools_.standing.size(); ++k) {
        if (pools_.standing[k] <= 0) continue;
        const double radius = face_under(k).radius;
        add_face(pools_.standing[k], radius, pi * radius * radius);
    }
    const std::vector<CapOnFace> drops = scene_->caps.on ? caps_.on_face(time) : drops_on_face_;
    for (std::size_t k = 0; k < drops.size(); ++k) {
        CapOnFace drop = drops[k];
        expose(drop, climate_);
        add(drop, scene_->caps.on ? &caps_.water_of(k) : nullptr);
    }
    cover_a_cell(found.caps);
    return found;
}

template <typename Executor> StandingLiquid YarnNetwork<Executor>::find_standing(const StandingOnFace& standing)
{
    if (standing.caps.empty()) return {};
    cap_views_.upload(standing.caps);
    cap_sums_.upload(std::vector<CapSums>(standing.caps.size()));
    if (film_ > 0) return {cap_views_.data(), cap_sums_.data(), {}, scene_->cloth.segments()}; // it covers what else there is
    const FindCap find = find_cap(static_cast<int>(standing.caps.size()));
    each_crossing("find standing", find);
    each_crossing("count covered", CountCovered{find, cap_sums_.data()});
    return {cap_views_.data(), cap_sums_.data(), find.face};
}

template <typename Executor> void YarnNetwork<Executor>::take_evaporated(const StandingOnFace& standing)
{
    if (standing.caps.empty()) return;
    const std::vector<CapSums> sums = cap_sums_.download();
    for (std::size_t k = 0; k < sums.size(); ++k) {
        if (standing.water[k] == nullptr) {
            evaporated_from_drops_ += sums[k].evaporated;
            continue;
        }
        std::int64_t& water = *standing.water[k];
        const bool scraps = water - sums[k].evaporated < scene_->cloth.segments(); // quanta that cannot be shared out any more
        const std::int64_t gone = scraps ? std::exchange(water, 0) : sums[k].evaporated;
        if (!scraps) water -= gone;
        evaporated_from_standing_.add(gone);
    }
}

/// kg that come to stand on the cloth in all.
inline double brought_to_stand(const Scene& scene)
{
    double volume = 0; // m3
    for (const SceneDroplet& drop : scene.supply.droplets) volume += drop.volume;
    for (const ScenePool& pool : scene.supply.pools) volume += pool.rate * (pool.end - pool.start);
    return scene.climate.density * volume + scene.cloth.start.film;
}

/// s, in which none of what stands shrinks by more than a fiftieth, or a film, which stays as wide as it is, by half; of little that is
/// left, by a little of all that came. The air takes it as if it were as warm as the air.
template <typename Executor> double YarnNetwork<Executor>::standing_lasts(double time)
{
    constexpr double shrinks = 0.02, film_shrinks = 0.5, little = 2e-4;
    double longest = std::numeric_limits<double>::infinity();
    const double dryness = saturation_concentration(climate_.temperature + climate_.air_warmth) - climate_.vapour; // kg/m3
    if (!scene_->rules.vapour || !(dryness > 0)) return longest;
    const double least = little * brought_to_stand(*scene_);
    for (const CapOnFace& cap : standing(time).caps) {
        const double water = static_cast<double>(cap.water) * water_quantum;
        longest = std::min(longest, std::max((cap.base < 0 ? film_shrinks : shrinks) * water, least) / (cap.vapour * dryness));
    }
    return longest;
}

/// To what lies under them, as much of each as it would draw.
template <typename Executor> void YarnNetwork<Executor>::offer_caps(double dt)
{
    cap_views_.upload(caps_on_face_);
    cap_sums_.upload(std::vector<CapSums>(caps_on_face_.size()));
    const FindCap find = find_cap(static_cast<int>(caps_on_face_.size()));
    const WeighCaps weigh{find, climate_.density, dt, cap_sums_.data()};
    each_crossing("find cap", find);
    each_segment("weigh cap", weigh);
    each_segment("offer cap", OfferCaps{weigh});
}

/// What stands on a face in this step, as flow sees it.
template <typename Executor> StandingPool YarnNetwork<Executor>::standing_pool()
{
    if (particles_offer_) return {.stands = true, .drops = true};
    if (caps_on_face_.empty()) return pools_.standing_pool(*scene_, climate_);
    return {true, 0, cap_views_.data(), cap_sums_.data(), true};
}

} // namespace hygroloom
