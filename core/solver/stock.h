// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a frame and its ledger are made from: numbers of one time, and the arrays as they were then (see Executor::Snapshot).
#pragma once

#include "core/solver/particles.h"
#include "core/solver/yarn_stock.h"

namespace hygroloom::inline HL_PRECISION {

struct Stock : YarnStock {
    double stressed = 0;             ///< s for which stresses were summed
    ParticleFields<Shown> particles; ///< also those that yarns have absorbed
    std::vector<Real> stress;        ///< of each particle; empty unless the scene asks
};

/// Summed on the host in the order of segments, or of a garment's cells: the same on every machine.
Ledger ledger_of(const Stock& stock, const Scene& scene);
Frame frame_of(const Stock& stock, const Scene& scene);

} // namespace hygroloom::inline HL_PRECISION
