// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The cloth of a scene on the host: its shape as stages see it, and the beads by which it acts on the free liquid.
#pragma once

#include "core/solver/steps/cloth_field.h"

namespace hygroloom::inline HL_PRECISION {

/// The scene's cloth as stages see it, in arrays that a stage's machine may have a copy of.
struct ClothShape {
    explicit ClothShape(const Scene& scene);

    TextileShape numbers; ///< pointers not set
    std::vector<YarnShape> shapes;
    std::vector<Quad> profiles;
    std::vector<Quad> paths;
    std::vector<float> shift; ///< of each segment
};

/// The same on the host, which stages can use; the scene must outlive it.
class HostCloth {
public:
    explicit HostCloth(const Scene& scene);
    HostCloth(const HostCloth&) = delete;
    HostCloth& operator=(const HostCloth&) = delete;
    const TextileShape& shape() const { return shape_; }

private:
    ClothShape cloth_;
    TextileShape shape_;
};

struct HostBeads {
    std::vector<Quad> beads;     ///< of the tiles in memory; a pack more than there are
    std::vector<int> first;      ///< of each tile
    std::vector<BeadType> types; ///< as the scene's yarns
    Beads view;                  ///< pointers not set
};

/// Cuts the yarns into beads about as large as the liquid's particles, or as the height of a thinner yarn, whatever the cloth's size.
/// Supports of the liquid's two kernels, m.
HostBeads make_beads(const Scene& scene, const ClothShape& shape, double spacing, double support, double reach);

} // namespace hygroloom::inline HL_PRECISION
