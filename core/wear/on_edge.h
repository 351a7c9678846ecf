// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Places along the edges of panels.
#pragma once

#include "core/garment/pattern.h"

namespace hygroloom {

/// A place on an edge, and the direction out of the panel there.
struct OnEdge {
    FlatPlace place;
    FlatPlace out;
};

/// At a share of its length. Panels go counter-clockwise, so that out is to the right.
OnEdge at_share(const PanelEdge& edge, double share);

} // namespace hygroloom
