// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whether falling drops may stand as caps: whether they splash or pass through holes, how far they can spread in a run, and whether
// the sample has room for that.
#pragma once

#include "core/plan/bounds.h"

#include <string>

namespace hygroloom {

/// Radius of the base, m, that a drop of a volume (m3) cannot exceed within a time (s) after it landed softly, even if nothing of it were
/// absorbed: at most that at rest. Until then its contact line goes no faster than its angle drives it; see speed_of_contact_line().
double largest_cap_base(double volume, double advancing, const LiquidAt& liquid, double duration);

/// Why drops cannot stand as caps, in a sentence; empty: they can, and none leaves the sample in the run.
std::string why_no_cap(const Experiment& experiment, const Bounds& bounds);

} // namespace hygroloom
