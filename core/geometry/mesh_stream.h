// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A mesh of any size piece by piece, so that memory does not grow with it: made on all cores, handed over in order.
#pragma once

#include "core/geometry/fibres.h"

#include <functional>

namespace hygroloom {

enum class MeshDetail { centreline, yarn, fibre };

struct MeshRequest {
    MeshDetail detail = MeshDetail::yarn;
    int samples_per_crossing = 8; ///< rings
    int sides = 12;               ///< of a yarn, or of a fibre
    bool flyaways = true;
    bool capped = true; ///< ends of the tubes, of yarns or fibres
    std::uint64_t seed = 1;

    FibreOptions fibres() const { return {samples_per_crossing, sides, flyaways, capped, seed}; }
};

constexpr int most_samples = 100; ///< per crossing
constexpr int most_sides = 200;

/// Samples and sides that draw a textile smoothly: of yarns 12 and 12, of fibres 6 sides and as many samples as the twist needs.
MeshRequest smooth_request(const Textile& textile, MeshDetail detail);

/// What stream_mesh() hands over in all. A centreline has no triangles.
MeshSize stream_size(const Textile& textile, const MeshRequest& request);
/// The same of one yarn.
MeshSize stream_size(const Textile& textile, const MeshRequest& request, YarnKind kind, int yarn);

/// Bytes that the pieces alive at the same time take at most: little, unless one yarn or one fibre alone has millions of vertices.
double stream_memory(const Textile& textile, const MeshRequest& request);

/// Hands over all ends, then all picks, in pieces of one yarn or of a part of its fibres: at most about a quarter of a million vertices
/// unless one yarn or fibre alone has more. Each piece has one group, whose indices begin at 0. take returns false to stop; it is
/// called from one thread at a time. What it throws ends the stream and is thrown on. Returns whether it ran to the end. Precondition:
/// detail is not centreline.
bool stream_mesh(const Textile& textile, const MeshRequest& request, const std::function<bool(const YarnMesh&)>& take);

/// All fibres of a window of the textile (its crossings counted from the textile's first) in one mesh with a group per yarn; positions
/// are the textile's. Throws Error when the vertices are too many for 32-bit indices.
YarnMesh mesh_fibres(const Textile& textile, const TextileRegion& window, const FibreOptions& options);

} // namespace hygroloom
