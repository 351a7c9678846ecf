// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a solver has come to: see StateWriter. It may go on with the same scene, or with parts of the physics switched on in it.
// Included by solver.h.
#pragma once

#include "core/solver/solver.h"

#include <array>

namespace hygroloom::inline HL_PRECISION {

/// Writes or reads all that load() does not find in the scene and that the next step does not find anew.
template <typename Executor> template <typename Archive> void Solver<Executor>::pass_state(Archive& archive)
{
    const auto numbers = [&](auto&... each) { (archive.value(each), ...); };
    const auto buffers = [&](auto&... each) { (archive.buffer(each), ...); };
    numbers(time_, sync_time_, network_time_, exchange_time_, network_dt_, exchange_dt_, next_droplet_, delivered_, initial_,
            initial_energy_, wicking_watch_, exchange_watch_, pumped_, ran_off_, unvisited_, stress_since_);
    archive.values(pool_);
    pass_regain(archive);
    LiquidControl flow = flow_;
    archive.value(flow);
    if constexpr (Archive::reads) flow_ = moved_to(flow, flow_);
    buffers(liquid_, vapour_, warmth_, evaporated_, released_, lost_, before_, pores_, supplied_, uptake_, fibre_water_, liquid_rate_,
            bound_, bound_rate_, heat_, heat_rate_, absorbed_, reach_);
    buffers(position_, velocity_, place_, wall_normal_, wall_distance_, wall_segment_, cloth_from_, content_, alive_, mirrored_, stress_);
    const std::array<bool, 4> own{scene_.wicking, scene_.sorption, scene_.vapour, scene_.heat};
    std::array<bool, 4> parts = own;
    archive.value(parts);
    if (parts == own) return;
    wicking_watch_ = exchange_watch_ = {};
    begin_anew();
}

/// Fibres that took part in nothing have one shell. Where they go on with more, all of a segment's begin with what the one holds.
template <typename Executor> template <typename Archive> void Solver<Executor>::pass_regain(Archive& archive)
{
    auto shells = static_cast<std::size_t>(scene_.fibre_shells);
    archive.value(shells);
    const auto own = static_cast<std::size_t>(scene_.fibre_shells);
    if (shells == own || shells != 1) {
        archive.buffer(regain_);
        return;
    }
    std::vector<double> one(regain_.size() / own), all(regain_.size());
    archive.values(one);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = one[i / own];
    regain_.upload(all);
}

} // namespace hygroloom::inline HL_PRECISION
