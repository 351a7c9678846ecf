// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/geometry/mesh_stream.h"

#include "core/base/error.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <memory>

namespace hygroloom {
namespace {

constexpr std::size_t piece_vertices = 250000;
constexpr std::size_t most_pieces_at_once = 6;
constexpr double vertex_bytes = 60; // 36 a vertex, 24 for its two triangles
constexpr double wanted_memory = 250e6;

void resize(YarnMesh& mesh, std::size_t vertices, std::size_t triangles)
{
    mesh.positions.resize(3 * vertices);
    mesh.normals.resize(3 * vertices);
    mesh.uvs.resize(2 * vertices);
    mesh.segment_of_vertex.resize(vertices);
    mesh.indices.resize(3 * triangles);
}

/// A yarn, or strands of one.
struct Piece {
    YarnKind kind = YarnKind::warp;
    int yarn = 0;
    std::shared_ptr<const YarnFibres> fibres; ///< empty: the yarn's skin
    int first = 0, last = 0;                  ///< strands
};

/// Cuts a textile into pieces, in order.
class Cutter {
public:
    Cutter(const Textile& textile, const MeshRequest& request) : textile_(textile), request_(request) {}

    bool next(Piece& piece)
    {
        if (!fibres_ || strand_ == fibres_->strands()) {
            if (yarn_ == textile_.system(kind_).count) {
                if (kind_ == YarnKind::weft) return false;
                kind_ = YarnKind::weft;
                yarn_ = 0;
            }
            strand_ = 0;
            fibres_.reset();
            if (request_.detail == MeshDetail::fibre)
                fibres_ = std::make_shared<YarnFibres>(textile_, request_.fibres(), kind_, yarn_, 0, textile_.crossings_along(kind_));
            ++yarn_;
        }
        piece = {kind_, yarn_ - 1, fibres_, strand_, 0};
        if (!fibres_) return true;
        std::size_t vertices = 0;
        while (strand_ < fibres_->strands() && (vertices == 0 || vertices + fibres_->vertices(strand_) <= piece_vertices))
            vertices += fibres_->vertices(strand_++);
        piece.last = strand_;
        return true;
    }

private:
    const Textile& textile_;
    const MeshRequest& request_;
    YarnKind kind_ = YarnKind::warp;
    int yarn_ = 0;
    int strand_ = 0;
    std::shared_ptr<const YarnFibres> fibres_;
};

void fill(const YarnFibres& fibres, int first, int last, YarnMesh& mesh, std::size_t vertex, std::size_t index)
{
    for (int strand = first; strand < last; ++strand) {
        fibres.tube(strand, mesh, vertex, index);
        vertex += fibres.vertices(strand);
        index += 3 * fibres.triangles(strand);
    }
}

void make(const Textile& textile, const MeshRequest& request, const Piece& piece, YarnMesh& mesh)
{
    mesh.groups.clear();
    if (!piece.fibres) {
        mesh.positions.clear();
        mesh.normals.clear();
        mesh.uvs.clear();
        mesh.indices.clear();
        mesh.segment_of_vertex.clear();
        append_yarn(textile, piece.kind, piece.yarn, request.samples_per_crossing, request.sides, mesh, request.capped);
        return;
    }
    std::size_t vertices = 0, triangles = 0;
    for (int strand = piece.first; strand < piece.last; ++strand) {
        vertices += piece.fibres->vertices(strand);
        triangles += piece.fibres->triangles(strand);
    }
    resize(mesh, vertices, triangles);
    fill(*piece.fibres, piece.first, piece.last, mesh, 0, 0);
    mesh.groups.push_back({yarn_name(piece.kind, piece.yarn), piece.kind, piece.yarn, 0, vertices, 0, 3 * triangles});
}

/// Bytes.
double largest_piece(const Textile& textile, const MeshRequest& request)
{
    double vertices = request.detail == MeshDetail::yarn ? 0 : static_cast<double>(piece_vertices);
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        const double rings = static_cast<double>(textile.crossings_along(kind)) * request.samples_per_crossing + 1;
        vertices = std::max(vertices, request.detail == MeshDetail::yarn ? (rings + 2) * (request.sides + 1) : rings * request.sides);
    }
    return vertices * vertex_bytes;
}

/// Fewer where each is large.
std::size_t pieces_at_once(double largest)
{
    return static_cast<std::size_t>(std::clamp(wanted_memory / largest, 1.0, static_cast<double>(most_pieces_at_once)));
}

} // namespace

MeshRequest smooth_request(const Textile& textile, MeshDetail detail)
{
    MeshRequest request;
    const bool fibre = detail == MeshDetail::fibre;
    request.detail = detail;
    request.samples_per_crossing = fibre ? std::min(smooth_samples(textile), most_samples) : 12;
    request.sides = fibre ? 6 : 12;
    return request;
}

MeshSize stream_size(const Textile& textile, const MeshRequest& request, YarnKind kind, int yarn)
{
    const auto rings = static_cast<std::size_t>(textile.crossings_along(kind)) * static_cast<std::size_t>(request.samples_per_crossing) + 1;
    const auto sides = static_cast<std::size_t>(request.sides);
    if (request.detail == MeshDetail::centreline) return {rings, 0};
    if (request.detail == MeshDetail::yarn) {
        const std::size_t caps = request.capped ? 2 : 0;
        return {(rings + caps) * (sides + 1), 2 * sides * (rings - 1) + caps * sides};
    }
    const auto fibres = static_cast<std::size_t>(running_strands(textile.type(kind, yarn)));
    const std::size_t hairs = YarnFibres::count_hairs(textile, request.fibres(), kind, yarn, 0, textile.crossings_along(kind));
    const std::size_t caps = request.capped ? 2 * (sides - 2) : 0;
    return {sides * (fibres * rings + hairs * YarnFibres::hair_points),
            fibres * (2 * (rings - 1) * sides + caps) + hairs * (2 * (YarnFibres::hair_points - 1) * sides + caps)};
}

MeshSize stream_size(const Textile& textile, const MeshRequest& request)
{
    MeshSize all;
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (int yarn = 0; yarn < textile.system(kind).count; ++yarn) {
            const MeshSize one = stream_size(textile, request, kind, yarn);
            all.vertices += one.vertices;
            all.triangles += one.triangles;
        }
    return all;
}

double stream_memory(const Textile& textile, const MeshRequest& request)
{
    const double piece = largest_piece(textile, request);
    return static_cast<double>(pieces_at_once(piece)) * piece;
}

bool stream_mesh(const Textile& textile, const MeshRequest& request, const std::function<bool(const YarnMesh&)>& take)
{
    Cutter cutter(textile, request);
    // A ring of buffers: a piece's buffer is free again once the piece has been taken, before as many others have begun.
    const std::size_t at_once = pieces_at_once(largest_piece(textile, request));
    std::vector<YarnMesh> buffers(at_once);
    std::size_t next_buffer = 0;
    std::atomic<bool> stopped{false};
    std::exception_ptr failure;
    // Nothing may be thrown through the pipeline, which would leak what is under way in it. The first failure ends it.
    const auto attempt = [&](const auto& act) {
        try {
            if (!stopped) act();
        } catch (...) {
            if (!stopped.exchange(true)) failure = std::current_exception();
        }
    };
    struct Work {
        Piece piece;
        YarnMesh* mesh = nullptr;
    };
    tbb::parallel_pipeline(at_once, tbb::make_filter<void, Work>(tbb::filter_mode::serial_in_order, [&](tbb::flow_control& flow) {
                                        Work work;
                                        bool more = false;
                                        attempt([&] { more = cutter.next(work.piece); });
                                        if (!more) flow.stop();
                                        work.mesh = &buffers[next_buffer++ % at_once];
                                        return work;
                                    }) & tbb::make_filter<Work, Work>(tbb::filter_mode::parallel, [&](Work work) {
                                        attempt([&] { make(textile, request, work.piece, *work.mesh); });
                                        return work;
                                    }) & tbb::make_filter<Work, void>(tbb::filter_mode::serial_in_order, [&](const Work& work) {
                                        attempt([&] {
                                            if (!take(*work.mesh)) stopped = true;
                                        });
                                    }));
    if (failure) std::rethrow_exception(failure);
    return !stopped;
}

YarnMesh mesh_fibres(const Textile& textile, const TextileRegion& window, const FibreOptions& options)
{
    struct Stretch {
        YarnKind kind;
        int yarn;
        std::unique_ptr<YarnFibres> fibres;
        std::size_t vertices = 0, triangles = 0;
    };
    std::vector<Stretch> stretches;
    stretches.reserve(static_cast<std::size_t>(window.ends) + static_cast<std::size_t>(window.picks));
    for (int end = 0; end < window.ends; ++end) stretches.push_back({YarnKind::warp, window.first_end + end, nullptr});
    for (int pick = 0; pick < window.picks; ++pick) stretches.push_back({YarnKind::weft, window.first_pick + pick, nullptr});
    tbb::parallel_for(std::size_t(0), stretches.size(), [&](std::size_t i) {
        Stretch& s = stretches[i];
        const bool is_warp = s.kind == YarnKind::warp;
        s.fibres = std::make_unique<YarnFibres>(textile, options, s.kind, s.yarn, is_warp ? window.first_pick : window.first_end,
                                                is_warp ? window.picks : window.ends);
        for (int strand = 0; strand < s.fibres->strands(); ++strand) {
            s.vertices += s.fibres->vertices(strand);
            s.triangles += s.fibres->triangles(strand);
        }
    });
    YarnMesh mesh;
    std::size_t vertices = 0, triangles = 0;
    for (const Stretch& s : stretches) {
        mesh.groups.push_back({yarn_name(s.kind, s.yarn), s.kind, s.yarn, vertices, s.vertices, 3 * triangles, 3 * s.triangles});
        vertices += s.vertices;
        triangles += s.triangles;
    }
    if (vertices > std::numeric_limits<std::uint32_t>::max())
        throw Error("The fibres would have " + std::to_string(vertices / 1000000) +
                    " million vertices, more than a mesh can number; take a smaller piece.");
    resize(mesh, vertices, triangles);
    tbb::parallel_for(std::size_t(0), stretches.size(), [&](std::size_t i) {
        const YarnFibres& fibres = *stretches[i].fibres;
        fill(fibres, 0, fibres.strands(), mesh, mesh.groups[i].first_vertex, mesh.groups[i].first_index);
    });
    return mesh;
}

} // namespace hygroloom
