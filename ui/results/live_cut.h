// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What of an experiment is computed within 0.2 s: the first part of its time, on the middle of its sample.
#pragma once

#include "core/design/design.h"

#include <limits>

namespace hygroloom {

struct LiveCut {
    double length = 1;     ///< s, from the first drop on; more than the experiment has: all of it
    int halvings = 0;      ///< of the sample's sides
    int most_halvings = 5; ///< more change nothing, or water has reached the edge

    double too_long = std::numeric_limits<double>::infinity(); ///< s, a length that so much of the sample does not fit
    double wall = 0;                                           ///< s, of the last answer
    double wall_before = 0; ///< s, of the answer before too_long was tried: it is tried again once answers take half as long
};

/// The first answer's: a second, on so many crossings as take about 0.2 s.
LiveCut firstCut(const Fabric& fabric, const Experiment& experiment);

/// The next answer's, by the time (s) that the last took: a smaller sample, then less time (a step of 1, 2, 5, 10, …) where it took too
/// long; more time, then more of the sample, where there is room for it. duration: s, of the whole from the first drop on.
LiveCut nextCut(LiveCut last, double duration, double wall);

/// Where so little of the sample is no experiment, or water has reached its edge. Precondition: it is cut.
LiveCut withMoreOfTheSample(LiveCut last);

/// The design with one fabric and one experiment, cut: errors elsewhere do not matter. Of a strip the lower end is left, of other samples
/// the middle: at least 5 mm, a repeat of the weave, and room for what falls on it.
Design cutDesign(const Design& design, int fabric, int experiment, const LiveCut& cut);

/// When the first drop falls, also of a feed that comes in drops, s; 0 where none does.
double beginOf(const Experiment& experiment);

} // namespace hygroloom
