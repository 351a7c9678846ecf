// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A cloth without what only tells how it looks, so that two may be compared as a run sees them.
#pragma once

#include "core/design/fields.h"

namespace hygroloom {

/// Whether a number says only how a yarn looks, or what it costs: no run depends on it.
bool is_look(const Field<Yarn>& row);
/// Without labels, see labels.h; what only tells how it looks is as usual. Two that are alike then are the same yarn to every run.
Yarn without_look(Yarn yarn);
/// All of its yarns.
Fabric without_look(Fabric fabric);
/// All of its fabrics.
Design without_look(Design design);

} // namespace hygroloom
