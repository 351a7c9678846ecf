// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/cell_mesh.h"

#include "core/base/units.h"
#include "core/geometry/mesh.h"
#include "ui/picture/fibre_mesh.h"
#include "ui/picture/yarn_field.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

std::int16_t shortened(double share) { return static_cast<std::int16_t>(std::lround(32767 * std::clamp(share, -1.0, 1.0))); }

/// A neighbour of the same key inside the fabric, so that a shared mesh has neighbours on all sides.
TextileRegion inside(const PreviewFabric& fabric, TextileRegion part)
{
    const int ends = fabric.cell_ends * fabric.period_ends, picks = fabric.cell_picks * fabric.period_picks;
    if (part.first_end == 0 && part.ends == fabric.cell_ends && part.first_end + ends + part.ends < fabric.textile.ends()) {
        part.first_end += ends;
    }
    if (part.first_pick == 0 && part.picks == fabric.cell_picks && part.first_pick + picks + part.picks < fabric.textile.picks()) {
        part.first_pick += picks;
    }
    return part;
}

class CellSweep {
public:
    CellSweep(const PreviewFabric& fabric, const TextileRegion& part, const YarnField& field, const TubeLevel& level, double sunk,
              CellMesh& mesh)
        : textile_(fabric.textile), part_(part), field_(field), sunk_(sunk), level_(level),
          fuller_(std::sqrt(2 * pi / level.sides / std::sin(2 * pi / level.sides))), mesh_(mesh)
    {
        const QVector3D low = fabric.low(part_);
        corner_ = {low.x(), low.y(), 0};
        const auto yarns = static_cast<std::size_t>(part_.ends + part_.picks);
        const auto rings = static_cast<std::size_t>(level.samples * std::max(part_.ends, part_.picks) + 3);
        mesh_.vertices.reserve(yarns * rings * static_cast<std::size_t>(level.sides + 1));
        mesh_.indices.reserve(6 * yarns * rings * static_cast<std::size_t>(level.sides));
    }

    void add(YarnKind kind, int yarn)
    {
        const int crossings = kind == YarnKind::warp ? part_.picks : part_.ends;
        const int rings = crossings * level_.samples + 1;
        const auto per_ring = static_cast<std::uint32_t>(level_.sides + 1);
        for (int ring = 0; ring < rings; ++ring) {
            const auto here = static_cast<std::uint32_t>(mesh_.vertices.size());
            for (int k = 0; k <= level_.sides; ++k) { skin(kind, yarn, ring, crossings, k, 0); }
            for (std::uint32_t k = 0; ring > 0 && k + 1 < per_ring; ++k) {
                const std::uint32_t before = here - per_ring + k, now = here + k;
                mesh_.indices.insert(mesh_.indices.end(), {before, before + 1, now, now, before + 1, now + 1});
            }
        }
        // Closed at both ends: the cut at the fabric's edge, and no crack to a neighbour with other sides.
        for (const int side : {-1, 1}) {
            const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
            for (int k = 0; k < level_.sides; ++k) { skin(kind, yarn, side < 0 ? 0 : rings - 1, crossings, k, side); }
            for (std::uint32_t k = 2; k < static_cast<std::uint32_t>(level_.sides); ++k) {
                if (side > 0) {
                    mesh_.indices.insert(mesh_.indices.end(), {first, first + k - 1, first + k});
                } else {
                    mesh_.indices.insert(mesh_.indices.end(), {first, first + k, first + k - 1});
                }
            }
        }
    }

private:
    void skin(YarnKind kind, int yarn, int ring, int crossings, int k, int cap)
    {
        const bool is_warp = kind == YarnKind::warp;
        const int at = std::min(ring / level_.samples, crossings - 1);
        const double offset = static_cast<double>(ring) / level_.samples - at - 0.5;
        const int first = is_warp ? part_.first_pick : part_.first_end;
        if (k == 0) { point_ = yarn_point(textile_, kind, yarn, first + at, offset); }
        const Vec3d across = is_warp ? Vec3d{1, 0, 0} : Vec3d{0, -1, 0};
        const Vec3d up = cross(across, point_.tangent);
        const double under = sunk_ * point_.half_height;
        const SectionPoint p =
            section_point(point_.half_width - under, point_.half_height - under, 2 * pi * (k % level_.sides) / level_.sides);
        const Vec3d position = point_.centre + fuller_ * (p.across * across + p.up * up);
        Vec3d normal = p.normal_across * across + p.normal_up * up;
        double open = 1;
        if (cap != 0) {
            normal = static_cast<double>(cap) * point_.tangent;
        } else if (k == level_.sides) {
            open = seam_;
        } else {
            open = shade_of(field_.openness(position, normal)) * (sunk_ > 0 ? 0.55 : 1);
            seam_ = k == 0 ? open : seam_;
        }
        CellVertex vertex{};
        vertex.position[0] = static_cast<float>(mm_from_metre(position.x) - corner_.x);
        vertex.position[1] = static_cast<float>(mm_from_metre(position.y) - corner_.y);
        vertex.position[2] = static_cast<float>(mm_from_metre(position.z));
        vertex.shape[0] = shortened(normal.x);
        vertex.shape[1] = shortened(normal.y);
        vertex.shape[2] = shortened(normal.z);
        vertex.shape[3] = shortened(open);
        vertex.along = static_cast<float>(ring) / static_cast<float>(level_.samples);
        vertex.around = static_cast<float>(k) / static_cast<float>(level_.sides);
        const int own = yarn - (is_warp ? part_.first_end : part_.first_pick);
        vertex.crossing[0] = static_cast<std::uint8_t>(is_warp ? own : at);
        vertex.crossing[1] = static_cast<std::uint8_t>(is_warp ? at : own);
        vertex.crossing[2] = is_warp ? 0 : 1;
        vertex.crossing[3] = cap != 0 ? 2 : 0;
        mesh_.vertices.push_back(vertex);
    }

    const Textile& textile_;
    TextileRegion part_;
    const YarnField& field_;
    double sunk_; ///< share of the half height that lies over this body
    const TubeLevel& level_;
    double fuller_; ///< a section of few sides is as large as the round one
    CellMesh& mesh_;
    Vec3d corner_; // mm
    YarnPoint point_{};
    double seam_ = 1;
};

} // namespace

CellMesh mesh_cell(const PreviewFabric& fabric, Cell cell, int level)
{
    CellMesh mesh;
    mesh.key = fabric.key(cell, level);
    const bool fibres = level == fibre_level;
    const TextileRegion part = fibres ? fabric.crossings(cell) : inside(fabric, fabric.crossings(cell));
    const YarnField field(fabric.textile, part);
    CellSweep sweep(fabric, part, field, fibres ? fibre_core : tubes[level - 1], fibres ? fibre_core_share : 0, mesh);
    for (int end = 0; end < part.ends; ++end) { sweep.add(YarnKind::warp, part.first_end + end); }
    for (int pick = 0; pick < part.picks; ++pick) { sweep.add(YarnKind::weft, part.first_pick + pick); }
    if (fibres) { add_fibres(fabric, part, field, mesh); }
    return mesh;
}

} // namespace hygroloom
