// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Cloth so open that a drop falls through it.
#pragma once

#include "core/base/message.h"
#include "core/design/experiment.h"
#include "core/design/fitted_fabric.h"

#include <optional>

namespace hygroloom {

/// mm, the narrower side of the holes between the yarns as they lie in the fabric; 0 where they touch.
double hole_width_mm(const Fabric& fabric, const FittedFabric& fitted);

/// Says that a drop of the experiment, or one that hangs from its feed, is narrower than the holes; nothing where all are wider, or where
/// no drop falls.
std::optional<Message> falls_through(const Fabric& fabric, const FittedFabric& fitted, const Experiment& experiment);

} // namespace hygroloom
