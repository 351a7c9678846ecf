// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The piece of a textile that is drawn, as a graphics card takes it.
#pragma once

#include "core/geometry/textile.h"

#include <QVector3D>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace hygroloom {

/// Which crossings to draw. whole is what frames are numbered by; the patch lies in it.
struct PreviewRequest {
    std::shared_ptr<const Design> design;
    int fabric = 0;
    TextileRegion whole;
    TextileRegion patch;
    std::size_t triangle_budget = 300000;
};

struct PreviewVertex {
    float position[3]; ///< mm, in the axes of the whole
    float normal[3];
    float along;       ///< in crossings
    float around;      ///< once round is 1
    std::uint32_t segment; ///< of the patch
};

struct PreviewMesh {
    PreviewRequest request;
    Textile textile; ///< of the patch
    QVector3D offset; ///< mm, of the patch's middle in the whole's axes
    std::vector<PreviewVertex> vertices;
    std::vector<std::uint32_t> indices;
    bool fine = false;

    QVector3D low() const;
    QVector3D high() const;
    /// The whole's segment values picked for the patch; values may be empty.
    std::vector<float> patchValues(const std::vector<float>& values) const;
};

/// A patch of at most so many crossings each way, a whole number of repeats where that is possible.
TextileRegion patch_of_repeats(const Weave& weave, int crossings);
/// A part of whole that keeps within the budget at the coarsest level, centred on a crossing of it.
TextileRegion patch_within(const TextileRegion& whole, std::size_t triangle_budget, int centre_end, int centre_pick);

/// A coarse mesh first when the fine one is much larger. Stops early when outdated() says so.
void build_preview(const PreviewRequest& request, const std::function<bool()>& outdated,
                   const std::function<void(std::shared_ptr<const PreviewMesh>)>& deliver);

} // namespace hygroloom
