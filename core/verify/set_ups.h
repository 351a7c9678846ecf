// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Small scenes that the cases are made of.
#pragma once

#include "core/sim/backend.h"
#include "core/sim/scene.h"

namespace hygroloom {

/// ends x picks crossings of plain weave, pitch apart; climate of water at a temperature, everything else off.
/// Yarn 0 is the warp's, 1 the weft's.
Scene bare_scene(int ends, int picks, double pitch, double temperature);

/// Loads, advances and returns the frame at each time, in order.
std::vector<Frame> frames_at(Backend& backend, const Scene& scene, const std::vector<double>& times);

} // namespace hygroloom
