// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a solver has come to: see StateWriter. Included by solver.h.
#pragma once

#include "core/sim/solver.h"

namespace hygroloom {

/// Writes or reads all that load() does not find in the scene and that the next step does not find anew.
template <typename Executor> template <typename Archive> void Solver<Executor>::pass_state(Archive& archive)
{
    const auto numbers = [&](auto&... each) { (archive.value(each), ...); };
    const auto buffers = [&](auto&... each) { (archive.buffer(each), ...); };
    numbers(time_, sync_time_, network_time_, exchange_time_, network_dt_, exchange_dt_, next_droplet_, delivered_, initial_,
            initial_energy_, wicking_watch_, exchange_watch_, heat_scale_, water_scale_, pumped_, ran_off_, unvisited_, stress_since_);
    archive.values(pool_);
    LiquidControl flow = flow_;
    archive.value(flow);
    if constexpr (Archive::reads) flow_ = moved_to(flow, flow_);
    buffers(liquid_, vapour_, warmth_, regain_, evaporated_, released_, lost_, before_, pores_, supplied_, uptake_, liquid_rate_, bound_,
            bound_rate_, heat_, heat_rate_, absorbed_, reach_);
    buffers(position_, velocity_, place_, wall_normal_, wall_distance_, wall_segment_, cloth_from_, content_, alive_, stress_);
}

} // namespace hygroloom
