// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How long the yarns' steps are where no drop is about, and so how many there are.
#pragma once

#include "core/base/first_step.h"
#include "core/plan/fidelity.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

constexpr double longest_calm_step = 60; ///< s
constexpr double front_share = 0.2;      ///< of the knob saturation_change: a front moves by half as much of its way

/// The longest step as a share of the time so far.
inline double calm_step_share(const Knobs& knobs) { return front_share * knobs.saturation_change; }

/// Steps from the start to a time (s) of which each is as long as it may be.
inline double calm_steps(const Knobs& knobs, double time)
{
    const double share = calm_step_share(knobs), grow_from = first_step / share, grow_to = longest_calm_step / share;
    const double first = std::min(time, grow_from) / first_step, last = std::max(0.0, time - grow_to) / longest_calm_step;
    const double growing = std::log(std::clamp(time, grow_from, grow_to) / grow_from) / std::log1p(share);
    return first + growing + last;
}

} // namespace hygroloom
