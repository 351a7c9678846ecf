// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Free liquid that pictures draw as bodies, because no particles stand for it.
#pragma once

#include "core/scene/frame.h"

#include <vector>

namespace hygroloom {

struct Experiment;

/// The frame's caps; the pool that its ledger knows, as the solver takes it to be shaped; and drops that hang or fall before they are part
/// of the run: at their height and speed when they appear, before that as gravity says. half_thickness: m, of the cloth.
std::vector<FrameCap> liquid_bodies(const Frame& frame, const Experiment& experiment, double half_thickness);

} // namespace hygroloom
