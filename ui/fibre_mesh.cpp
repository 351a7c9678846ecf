// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/fibre_mesh.h"

#include "core/base/units.h"
#include "core/geometry/mesh.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr int fibres = 44;  // seen round a yarn: of 15 um in one of 0.2 mm
constexpr int samples = 10; // per crossing
constexpr int sides = 4;
constexpr double share_of_gap = 1.15; // fibres lie a little over each other

/// 0..1, always the same for the same numbers.
double chance(int kind, int yarn, int fibre, int which)
{
    auto hash = static_cast<std::uint32_t>(yarn * 7919 + fibre * 104729 + which * 1299709 + kind * 15485863);
    hash ^= hash >> 16;
    hash *= 0x7feb352dU;
    hash ^= hash >> 15;
    hash *= 0x846ca68bU;
    hash ^= hash >> 16;
    return hash / 4294967296.0;
}

double radius_of(double half_width, double half_height)
{
    const double round = 2 * pi * half_height + 4 * std::max(0.0, half_width - half_height);
    return share_of_gap * round / (2 * fibres);
}

struct Place {
    Vec3d centre; // m
    Vec3d outwards;
    double radius;
};

/// A fibre at a distance along its yarn, in crossings from the textile's edge.
Place fibre_at(const Textile& textile, YarnKind kind, int yarn, int fibre, double turns, double along)
{
    const bool is_warp = kind == YarnKind::warp;
    const int crossings = is_warp ? textile.picks() : textile.ends();
    const int at = std::clamp(static_cast<int>(std::floor(along)), 0, crossings - 1);
    const YarnPoint point = yarn_point(textile, kind, yarn, at, std::clamp(along - at - 0.5, -0.5, 0.5));
    const auto lot = [&](int which) { return chance(is_warp ? 0 : 1, yarn, fibre, which); };
    const double wander = 0.35 * std::sin(2 * pi * (lot(0) + along * (0.25 + 0.35 * lot(1)))) + 0.2 * std::sin(2 * pi * (lot(2) + along * (0.7 + lot(3))));
    const double angle = 2 * pi * ((fibre + 0.8 * lot(4) + wander) / fibres + turns * along);
    const double radius = radius_of(point.half_width, point.half_height) * (0.85 + 0.3 * lot(5));
    const double sunk = radius * (1 + 0.8 * (0.5 + 0.5 * std::sin(2 * pi * (lot(6) + along * (0.2 + 0.4 * lot(7))))));
    const SectionPoint p = section_point(point.half_width - sunk, point.half_height - sunk, angle);
    const Vec3d across = is_warp ? Vec3d{1, 0, 0} : Vec3d{0, -1, 0};
    const Vec3d up = cross(across, point.tangent);
    return {point.centre + p.across * across + p.up * up, p.normal_across * across + p.normal_up * up, radius};
}

Vec3d unit(const Vec3d& v)
{
    return 1 / std::max(1e-30, length(v)) * v;
}

} // namespace

double fibre_depth(const PreviewFabric& fabric)
{
    const YarnPoint end = yarn_point(fabric.textile, YarnKind::warp, 0, 0, 0);
    return 2.4 * radius_of(end.half_width, end.half_height);
}

std::size_t fibre_triangles(int crossings)
{
    return static_cast<std::size_t>(2 * crossings) * fibres * samples * sides * 2;
}

void add_fibres(const PreviewFabric& fabric, const TextileRegion& part, const YarnField& field, CellMesh& mesh)
{
    const QVector3D corner = fabric.low(part);
    const auto add = [&](YarnKind kind, int yarn, int fibre) {
        const bool is_warp = kind == YarnKind::warp;
        const Yarn& designed = *(is_warp ? fabric.end_yarns : fabric.pick_yarns)[static_cast<std::size_t>(yarn)];
        const double step = is_warp ? fabric.pitch().y() : fabric.pitch().x();
        const double turns = designed.twist_per_m * metre_from_mm(step) * (designed.twist_direction == TwistDirection::z ? 1 : -1);
        const int first = is_warp ? part.first_pick : part.first_end;
        const int crossings = is_warp ? part.picks : part.ends;
        const int rings = crossings * samples + 1;
        for (int ring = 0; ring < rings; ++ring) {
            const double along = first + static_cast<double>(ring) / samples;
            constexpr double little = 0.02;
            const Place here = fibre_at(fabric.textile, kind, yarn, fibre, turns, along);
            const Vec3d tangent = unit(fibre_at(fabric.textile, kind, yarn, fibre, turns, along + little).centre
                                       - fibre_at(fabric.textile, kind, yarn, fibre, turns, along - little).centre);
            const Vec3d aside = unit(cross(tangent, here.outwards));
            const Vec3d out = cross(aside, tangent);
            const Vec3d skin = here.centre + here.radius * out;
            const double open = 0.6 + 0.4 * std::sqrt(field.openness(skin, here.outwards));
            const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
            for (int k = 0; k < sides; ++k) {
                const double angle = 2 * pi * k / sides;
                const Vec3d normal = std::cos(angle) * out + std::sin(angle) * aside;
                const Vec3d position = here.centre + here.radius * normal;
                const double buried = 0.86 + 0.14 * std::cos(angle); // its flanks lie between its neighbours
                CellVertex vertex{};
                vertex.position[0] = static_cast<float>(mm_from_metre(position.x)) - corner.x();
                vertex.position[1] = static_cast<float>(mm_from_metre(position.y)) - corner.y();
                vertex.position[2] = static_cast<float>(mm_from_metre(position.z));
                const double shape[] = {normal.x, normal.y, normal.z, open * buried};
                for (int i = 0; i < 4; ++i) {
                    vertex.shape[i] = static_cast<std::int16_t>(std::lround(32767 * std::clamp(shape[i], -1.0, 1.0)));
                }
                vertex.along = static_cast<float>(ring) / samples;
                const int at = std::min(ring / samples, crossings - 1), own = yarn - (is_warp ? part.first_end : part.first_pick);
                vertex.crossing[0] = static_cast<std::uint8_t>(is_warp ? own : at);
                vertex.crossing[1] = static_cast<std::uint8_t>(is_warp ? at : own);
                vertex.crossing[2] = is_warp ? 0 : 1;
                vertex.crossing[3] = 1;
                mesh.vertices.push_back(vertex);
                if (ring > 0) {
                    const std::uint32_t a = base + static_cast<std::uint32_t>(k), b = base + static_cast<std::uint32_t>((k + 1) % sides);
                    mesh.indices.insert(mesh.indices.end(), {a - sides, b - sides, a, a, b - sides, b});
                }
            }
        }
    };
    mesh.vertices.reserve(mesh.vertices.size() + fibre_triangles(part.ends * part.picks));
    mesh.indices.reserve(mesh.indices.size() + 3 * fibre_triangles(part.ends * part.picks));
    for (int fibre = 0; fibre < fibres; ++fibre) {
        for (int end = 0; end < part.ends; ++end) {
            add(YarnKind::warp, part.first_end + end, fibre);
        }
        for (int pick = 0; pick < part.picks; ++pick) {
            add(YarnKind::weft, part.first_pick + pick, fibre);
        }
    }
}

} // namespace hygroloom
