// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// From a draft to its weave and back.
#pragma once

#include "core/design/draft.h"
#include "core/design/weave.h"

namespace hygroloom {

/// The matrix: an end is up when one of its shafts is. The weave carries no draft.
/// Precondition of this and of weave_from_draft(): fault_in() finds nothing.
Weave drawdown(const Draft& draft);

/// The same, and the weave carries the draft.
Weave weave_from_draft(Draft draft);

/// Fewest shafts (as many as there are different ends) and fewest treadles (different picks), numbered as they first occur, so that a
/// twill has a straight draw.
Draft smallest_draft(const Weave& weave);

} // namespace hygroloom
