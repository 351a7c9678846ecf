// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/fibre_mesh.h"

#include "core/base/units.h"
#include "core/geometry/fibres.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

/// Room for one yarn's fibres in a mesh, and the fibres in it.
YarnMesh tubes_of(const YarnFibres& fibres)
{
    std::size_t vertices = 0, triangles = 0;
    for (int strand = 0; strand < fibres.strands(); ++strand) {
        vertices += fibres.vertices(strand);
        triangles += fibres.triangles(strand);
    }
    YarnMesh mesh;
    mesh.positions.resize(3 * vertices);
    mesh.normals.resize(3 * vertices);
    mesh.uvs.resize(2 * vertices);
    mesh.segment_of_vertex.resize(vertices);
    mesh.indices.resize(3 * triangles);
    std::size_t vertex = 0, index = 0;
    for (int strand = 0; strand < fibres.strands(); ++strand) {
        fibres.tube(strand, mesh, vertex, index);
        vertex += fibres.vertices(strand);
        index += 3 * fibres.triangles(strand);
    }
    return mesh;
}

/// Of the strand at a vertex, with the yarn: its normals round a ring lie square to it.
Vec3d direction_at(const YarnMesh& tubes, std::size_t vertex, int sides, bool is_warp)
{
    const std::size_t ring = vertex - vertex % static_cast<std::size_t>(sides);
    const float* a = &tubes.normals[3 * ring];
    const float* b = a + 3;
    const Vec3d along = cross(Vec3d{a[0], a[1], a[2]}, Vec3d{b[0], b[1], b[2]});
    const double size = std::max(length(along), 1e-12);
    return ((is_warp ? along.y : along.x) < 0 ? -1 / size : 1 / size) * along;
}

/// Hairs narrow at their ends, as cut fibres of staple do.
void sharpen_hairs(const YarnFibres& fibres, int sides, YarnMesh& tubes)
{
    constexpr float tip = 0.2F; // of the radius
    std::size_t vertex = 0;
    for (int strand = 0; strand < fibres.strands(); ++strand) {
        vertex += fibres.vertices(strand);
        if (!fibres.is_hair(strand)) { continue; }
        float* last = &tubes.positions[3 * (vertex - static_cast<std::size_t>(sides))];
        for (int axis = 0; axis < 3; ++axis) {
            float middle = 0;
            for (int k = 0; k < sides; ++k) { middle += last[3 * k + axis] / static_cast<float>(sides); }
            for (int k = 0; k < sides; ++k) { last[3 * k + axis] = middle + tip * (last[3 * k + axis] - middle); }
        }
    }
}

/// Share of light that gets to a skin so deep in a yarn past the fibres over it, which lie at random: Cauchy's mean chord between circles
/// of a radius, pi r (1 - packing) / (2 packing). White fibres pass on what they do not let by: less than a third is lost.
double light_through(const YarnType& type, double depth)
{
    const double chord = 0.5 * pi * drawn_fibre_radius(type) * (1 - type.packing) / type.packing;
    return 0.7 + 0.3 * std::exp(-std::max(depth, 0.0) / std::max(chord, 1e-9));
}

} // namespace

void add_fibres(const PreviewFabric& fabric, const TextileRegion& part, const YarnField& field, CellMesh& mesh)
{
    const Textile& textile = fabric.textile;
    const QVector3D corner = fabric.low(part);
    FibreOptions options;
    options.samples_per_crossing = std::clamp(smooth_samples(textile), 12, 24);
    const auto add = [&](YarnKind kind, int yarn) {
        const bool is_warp = kind == YarnKind::warp;
        const YarnFibres fibres(textile, options, kind, yarn, is_warp ? part.first_pick : part.first_end, is_warp ? part.picks : part.ends);
        YarnMesh skins = tubes_of(fibres);
        sharpen_hairs(fibres, options.sides, skins);
        const YarnType& type = textile.type(kind, yarn);
        const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
        for (std::size_t i = 0; i < skins.segment_of_vertex.size(); ++i) {
            const float* p = &skins.positions[3 * i];
            const float* n = &skins.normals[3 * i];
            const Vec3d at_skin{p[0], p[1], p[2]};
            const double open =
                (0.65 + 0.35 * std::sqrt(field.openness(at_skin, {n[0], n[1], n[2]}))) * light_through(type, -field.distance(at_skin));
            CellVertex vertex{};
            vertex.position[0] = static_cast<float>(mm_from_metre(p[0])) - corner.x();
            vertex.position[1] = static_cast<float>(mm_from_metre(p[1])) - corner.y();
            vertex.position[2] = static_cast<float>(mm_from_metre(p[2]));
            const double shape[] = {n[0], n[1], n[2], open};
            for (int k = 0; k < 4; ++k) {
                vertex.shape[k] = static_cast<std::int16_t>(std::lround(32767 * std::clamp(shape[k], -1.0, 1.0)));
            }
            const Vec3d direction = direction_at(skins, i, options.sides, is_warp);
            vertex.along = static_cast<float>(is_warp ? direction.x : direction.y);
            vertex.around = static_cast<float>(direction.z);
            const int along = skins.segment_of_vertex[i] % (is_warp ? textile.picks() : textile.ends());
            const int at = std::clamp(along - (is_warp ? part.first_pick : part.first_end), 0, (is_warp ? part.picks : part.ends) - 1);
            const int own = yarn - (is_warp ? part.first_end : part.first_pick);
            vertex.crossing[0] = static_cast<std::uint8_t>(is_warp ? own : at);
            vertex.crossing[1] = static_cast<std::uint8_t>(is_warp ? at : own);
            vertex.crossing[2] = is_warp ? 0 : 1;
            vertex.crossing[3] = 1;
            mesh.vertices.push_back(vertex);
        }
        for (const std::uint32_t index : skins.indices) { mesh.indices.push_back(base + index); }
    };
    for (int end = 0; end < part.ends; ++end) { add(YarnKind::warp, part.first_end + end); }
    for (int pick = 0; pick < part.picks; ++pick) { add(YarnKind::weft, part.first_pick + pick); }
}

} // namespace hygroloom
