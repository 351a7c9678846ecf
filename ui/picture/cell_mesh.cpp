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

constexpr int most_texels = 1024; // each way
constexpr int texels_per_crossing = 20;

/// Light that reaches a height of the fabric past its surface; the deeper the less.
double light_at_height(double height, double half_thickness)
{
    const double t = std::clamp((height / half_thickness + 1.0) / 1.75, 0.0, 1.0);
    return 0.70 + 0.30 * t * t * (3 - 2 * t);
}

double contrast(double openness)
{
    return 0.45 + 0.55 * std::sqrt(openness); // light that comes from skin to skin softens the shade
}

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
        : textile_(fabric.textile), part_(part), field_(field), sunk_(sunk), level_(level), mesh_(mesh)
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
        const Vec3d position = point_.centre + p.across * across + p.up * up;
        Vec3d normal = p.normal_across * across + p.normal_up * up;
        double open = 1;
        if (cap != 0) {
            normal = static_cast<double>(cap) * point_.tangent;
        } else if (k == level_.sides) {
            open = seam_;
        } else {
            open = contrast(field_.openness(position, normal)) * (sunk_ > 0 ? 0.55 : 1);
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
        mesh_.vertices.push_back(vertex);
    }

    const Textile& textile_;
    TextileRegion part_;
    const YarnField& field_;
    double sunk_; ///< share of the half height that lies over this body
    const TubeLevel& level_;
    CellMesh& mesh_;
    Vec3d corner_; // mm
    YarnPoint point_{};
    double seam_ = 1;
};

struct Seen {
    YarnKind kind = YarnKind::warp;
    Vec3d point;
    Vec3d normal;
};

/// What is seen of the fabric straight from above (side 1) or below (-1).
std::optional<Seen> seen_at(const YarnField& field, double x, double y, int side)
{
    const Textile& textile = field.textile();
    std::optional<Seen> seen;
    for (const YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        const bool is_warp = kind == YarnKind::warp;
        const double first = is_warp ? textile.x_of_end(0) : textile.y_of_pick(0);
        const double pitch = (is_warp ? textile.x_of_end(1) : textile.y_of_pick(1)) - first;
        const double first_along = is_warp ? textile.y_of_pick(0) : textile.x_of_end(0);
        const double step = (is_warp ? textile.y_of_pick(1) : textile.x_of_end(1)) - first_along;
        const double across = is_warp ? x : y;
        const double along = ((is_warp ? y : x) - first_along) / step;
        const int middle = static_cast<int>(std::lround((across - first) / pitch));
        for (int yarn = std::max(0, middle - 1); yarn <= std::min((is_warp ? textile.ends() : textile.picks()) - 1, middle + 1); ++yarn) {
            const YarnSlice slice = field.slice(kind, yarn, along);
            const double off = across - slice.across;
            const double flat = std::max(0.0F, slice.half_width - slice.half_height);
            const double round = std::max(0.0, std::abs(off) - flat) / slice.half_height;
            if (round >= 1) { continue; }
            const double rise = std::sqrt(1 - round * round);
            const double height = slice.height + side * rise * slice.half_height * std::sqrt(1.0 + slice.slope * slice.slope);
            if (seen && side * height <= side * seen->point.z) { continue; }
            const double norm = 1 / std::sqrt(1.0 + slice.slope * slice.slope);
            const double sideways = off < 0 ? -round : round, along_yarn = -side * rise * slice.slope * norm, up = side * rise * norm;
            seen = Seen{kind, {x, y, height}, is_warp ? Vec3d{sideways, along_yarn, up} : Vec3d{along_yarn, sideways, up}};
        }
    }
    return seen;
}

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

RepeatPicture picture_of_repeat(const PreviewFabric& fabric)
{
    const Textile& textile = fabric.textile;
    RepeatPicture picture;
    picture.ends = std::min(fabric.period_ends, textile.ends());
    picture.picks = std::min(fabric.period_picks, textile.picks());
    picture.width = std::min(most_texels, texels_per_crossing * picture.ends);
    picture.height = std::min(most_texels, texels_per_crossing * picture.picks);
    // Away from the edge where there is room: the picture stands for the middle.
    const TextileRegion part{2 * picture.ends < textile.ends() ? picture.ends : 0, 2 * picture.picks < textile.picks() ? picture.picks : 0,
                             picture.ends, picture.picks};
    const YarnField field(textile, part);
    const double x0 = metre_from_mm(fabric.low(part).x()), y0 = metre_from_mm(fabric.low(part).y());
    const double dx = (textile.x_of_end(1) - textile.x_of_end(0)) * picture.ends / picture.width;
    const double dy = (textile.y_of_pick(1) - textile.y_of_pick(0)) * picture.picks / picture.height;
    const auto texels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    picture.texels.assign(4 * texels * RepeatPicture::layers, 0);
    for (std::size_t i = 0; i < 4 * texels * 4; i += 4) { picture.texels[i] = picture.texels[i + 1] = picture.texels[i + 2] = 128; }
    double level = 0, covered = 0;
    for (int row = 0; row < picture.height; ++row) {
        for (int column = 0; column < picture.width; ++column) {
            const std::size_t texel =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(column);
            for (const int side : {1, -1}) {
                const auto seen = seen_at(field, x0 + (column + 0.5) * dx, y0 + (row + 0.5) * dy, side);
                if (!seen) { continue; }
                const double open =
                    contrast(field.openness(seen->point, seen->normal)) * light_at_height(side * seen->point.z, textile.half_thickness());
                const std::size_t layer = (side > 0 ? 0U : 2U) + (seen->kind == YarnKind::warp ? 0U : 1U);
                std::uint8_t* at = &picture.texels[4 * (layer * texels + texel)];
                const auto byte = [](double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))); };
                at[0] = byte(128 + 127 * open * seen->normal.x);
                at[1] = byte(128 + 127 * open * seen->normal.y);
                at[2] = byte(128 + 127 * open * seen->normal.z);
                at[3] = byte(255 * open);
                level += side * seen->point.z;
                covered += 1;
                picture.texels[4 * (4 * texels + texel)] = 255;
            }
        }
    }
    picture.level = covered > 0 ? static_cast<float>(mm_from_metre(level / covered)) : 0.0F;
    picture.covered = static_cast<float>(0.5 * covered / static_cast<double>(texels)); // counted from both sides
    return picture;
}

} // namespace hygroloom
