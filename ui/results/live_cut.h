// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What of an experiment is computed at once after an edit: the first part of its time, on the middle of its sample. The cloth and the
// test alone say how much, never the clock: the same cloth has the same answer on any machine, however busy.
#pragma once

#include "core/design/design.h"

namespace hygroloom {

struct LiveCut {
    double length = 1; ///< s, from the first drop on; more than the experiment has: all of it
    int halvings = 0;  ///< of the sample's sides
};

/// A time that each type of experiment has of its own, on so many crossings as take about 0.2 s at live on one core.
LiveCut cutOf(const Fabric& fabric, const Experiment& experiment);

/// The design with one fabric and one experiment, cut: errors elsewhere do not matter. Of a strip the lower end is left, of other samples
/// the middle: at least 5 mm, a repeat of the weave, and room for what falls on it.
Design cutDesign(const Design& design, int fabric, int experiment, const LiveCut& cut);

/// When the first drop falls, also of a feed that comes in drops, s; 0 where none does.
double beginOf(const Experiment& experiment);

} // namespace hygroloom
