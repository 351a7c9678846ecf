// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A cloth simulated in bundles of neighbouring yarns, and its frames shown yarn by yarn.
#pragma once

#include "core/plan/bundles.h"
#include "core/scene/frame.h"
#include "core/scene/scene.h"

namespace hygroloom {

/// The cloth of which each crossing stands for a block of about this number of ends and of picks. Its faces, pores, fibres and water add up
/// to the same; along and across bundles passes what passes along and across their yarns side by side. A bundle lies on a face with as
/// much of it as its yarns do. An outermost bundle that has other numbers of yarns has the room, the face and the crossings of the others.
/// Precondition: no liquid is free, and the yarns of a bundle are of one type.
Scene coarsened(const Scene& fine, const Bundling& bundling);

/// What a frame of coarsened(fine, …) means for each segment of the fine scene: all of a block are alike. Masses add up to the same; the
/// faces' totals are those of the fine weave.
Frame refined(Frame frame, const Scene& coarse, const Scene& fine, const Bundling& bundling);

/// The same of frames whose scenes are gone, as recordings keep them: of the fields that a frame has; the faces' totals stay.
class YarnsOfBundles {
public:
    YarnsOfBundles(const Textile& textile, const Bundling& bundling);
    /// How many values each field of a frame of bundles has.
    std::size_t segments() const { return bundled_.size(); }
    Frame refined(Frame frame) const;

private:
    Bundles ends_, picks_;
    std::vector<double> lengths_, bundled_; ///< m, of each yarn's segments, and of the bundles'
};

} // namespace hygroloom
