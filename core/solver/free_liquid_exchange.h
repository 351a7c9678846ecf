// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What drops of particles give to the yarns and to the air, and what they get back from swollen yarns.
#pragma once

#include "core/physics/caps.h"
#include "core/solver/free_liquid.h"

namespace hygroloom::inline HL_PRECISION {

template <typename Executor> bool FreeLiquid<Executor>::offer(double time, const WaterAbsorbed& absorbed)
{
    const Segments& takers = absorbed.segments;
    offered_ = offers_ && flow_.count > 0 && time >= flow_.flight_end;
    if (offered_) exec_.for_each("offer", flow_.count, OfferFromDrops{particle_views(), shape(takers), takers, {absorbed.reach}});
    return offered_;
}

template <typename Executor> void FreeLiquid<Executor>::take_payment(const Segments& segments)
{
    if (!offered_) return;
    flow_.left = flow_.above = 0;
    control_.write(0, flow_);
    LiquidControl* control = control_.data();
    const OfferFromDrops offered{particle_views(), shape(segments), segments, {}};
    exec_.for_each("pay", flow_.count, PayForDrawn{offered, &control->absorbed});
    exec_.for_each("close", flow_.count, CloseAccounts{offered, &control->absorbed, &control->left, &control->above});
    flow_ = control_.read(0);
    if (flow_.left == 0) flow_.count = 0;
}

template <typename Executor> std::size_t FreeLiquid<Executor>::room_for_given_back() const
{
    std::size_t kept = 0; // for drops to come
    for (std::size_t k = next_droplet_; k < scene_->supply.droplets.size(); ++k)
        kept += start_.particles_of(scene_->supply.droplets[k].volume);
    return start_.room == 0 ? 0 : static_cast<std::size_t>(start_.room - flow_.count) - kept;
}

template <typename Executor> bool FreeLiquid<Executor>::take_back(const WaterGivenBack& given, const Segments& segments, double time)
{
    const auto count = static_cast<int>(given.segments.size());
    if (count == 0) return false;
    from_.upload(given.segments);
    exec_.for_each("give back", count,
                   GiveBack{particle_views(), shape(segments), segments, scene_->climate.density, from_.data(), flow_.count,
                            Real(1.1) * touching_in_spacings * start_.spacing});
    const bool wakes = rests();
    flow_.count += count;
    flow_.listed_for = flow_.asleep = 0;
    flow_.flight_end = 0;
    flow_.roused = time;
    const double settling = rules_.capillary_time(static_cast<double>(count) * std::pow(static_cast<double>(start_.spacing), 3));
    flow_.settling = wakes ? settling : std::max(flow_.settling, settling);
    flow_.longest_dt = std::min(flow_.longest_dt, rules_.longest_step());
    return wakes;
}

template <typename Executor> std::vector<CapOnFace> FreeLiquid<Executor>::standing(double time)
{
    std::vector<CapOnFace> drops;
    if (!scene_->rules.vapour || flow_.count == 0 || time < flow_.flight_end) return drops;
    double released = 0; // m3
    std::vector<const SceneDroplet*> landed;
    for (std::size_t k = 0; k < next_droplet_; ++k) {
        const SceneDroplet& drop = scene_->supply.droplets[k];
        released += drop.volume;
        if (drop.time + falls_for(drop) < time) landed.push_back(&drop);
    }
    if (landed.empty()) return drops;
    touched_.fill(0);
    exec_.for_each("touching", flow_.count, SumTouching{particle_views(), touched_.data(), touched_.data() + 1});
    in_particles_ = touched_.read(0);
    if (in_particles_ == 0) { // all has dried
        flow_.count = 0;
        flow_.left = flow_.above = 0;
        return drops;
    }
    const double spacing = static_cast<double>(start_.spacing), area = 1e-6 * static_cast<double>(touched_.read(1)) * spacing * spacing;
    double faces = 0; // of like drops, as the square of their width
    for (const SceneDroplet* drop : landed) faces += std::pow(drop->volume, 2.0 / 3.0);
    for (const SceneDroplet* drop : landed) {
        const double part = std::pow(drop->volume, 2.0 / 3.0) / faces, base = std::sqrt(area * part / pi);
        const auto water = static_cast<std::int64_t>(static_cast<double>(in_particles_) * (drop->volume / released));
        if (!(base > 0) || water <= 0) continue; // nothing touches the cloth just now
        const double volume = static_cast<double>(water) * water_quantum / scene_->climate.density;
        drops.push_back({drop->centre.x, drop->centre.y, base, 0, water, cap_angle(volume, base)});
    }
    return drops;
}

template <typename Executor> void FreeLiquid<Executor>::evaporate(std::int64_t quanta)
{
    if (quanta == 0 || in_particles_ <= 0) return; // less than nothing condenses
    touched_.fill(0);
    const double share = static_cast<double>(quanta) / static_cast<double>(in_particles_);
    exec_.for_each("shrink", flow_.count, ShrinkInAir{particle_views(), share, touched_.data()});
    const std::int64_t lost = touched_.read(0);
    evaporated_.add(lost);
    flow_.above -= static_cast<std::int64_t>(share * static_cast<double>(flow_.above));
    flow_.absorbed += lost; // it changes the shape of what sleeps
    in_particles_ -= lost;
}

} // namespace hygroloom::inline HL_PRECISION
