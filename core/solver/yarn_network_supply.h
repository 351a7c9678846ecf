// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The part of a yarn network's step in which liquid comes from outside: from pools, drops that stand as caps, and sweat.
#pragma once

#include "core/solver/steps/press_out.h"
#include "core/solver/yarn_network.h"

#include <utility>

namespace hygroloom::inline HL_PRECISION {

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
}

/// Drops fall, land and spread in the last dt, as caps, and give to the air.
template <typename Executor> void YarnNetwork<Executor>::take_drops(double time, double dt)
{
    pools_.pumped.add(caps_.release(time));
    if (scene_->rules.vapour) evaporated_from_caps_.add(caps_.evaporate(climate_, dt));
    cap_landed_ = caps_.spread(time, dt);
    caps_on_face_ = caps_.on_face(time);
    const double cell = std::max(scene_->cloth.warp_pitch, scene_->cloth.weft_pitch);
    constexpr double least = 0.75; // of a cell's side: the least circle that covers one of the places looked at
    for (CapOnFace& cap : caps_on_face_) {
        cap.base = std::max(cap.base, least * cell);
        region_.include_disc(cap.x, cap.y, cap.base + cell);
    }
}

/// To what lies under them, as much of each as it would draw.
template <typename Executor> void YarnNetwork<Executor>::offer_caps(double dt)
{
    cap_views_.upload(caps_on_face_);
    cap_sums_.upload(std::vector<CapSums>(caps_on_face_.size()));
    const Cloth& cloth = scene_->cloth;
    const FindCap find{segments(),
                       cap_views_.data(),
                       static_cast<int>(caps_on_face_.size()),
                       {true, 0, cloth.warp_pitch, cloth.weft_pitch, std::max(2, cloth.threads_per_cell)}};
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

} // namespace hygroloom::inline HL_PRECISION
