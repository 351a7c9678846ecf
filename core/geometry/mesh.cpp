// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Sweeps each yarn's section along its centreline, ring by ring.
#include "core/geometry/mesh.h"

#include "core/base/error.h"
#include "core/base/units.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace hygroloom {
namespace {

std::size_t rings_of(const Textile& textile, YarnKind kind, int samples)
{
    return static_cast<std::size_t>(textile.crossings_along(kind)) * static_cast<std::size_t>(samples) + 1;
}

/// One station along a yarn: (across, tangent, up) are right-handed.
struct Station {
    YarnPoint point;
    Vec3d across, up;
    int crossing = 0;
    double u = 0; ///< in crossings from the yarn's end
};

Station station(const Textile& textile, YarnKind kind, int yarn, std::size_t ring, int samples)
{
    const int crossings = textile.crossings_along(kind);
    Station s;
    s.crossing = std::min(static_cast<int>(ring / static_cast<std::size_t>(samples)), crossings - 1);
    const double offset = static_cast<double>(ring) / samples - s.crossing - 0.5;
    s.point = yarn_point(textile, kind, yarn, s.crossing, offset);
    const Vec3d& along = s.point.tangent;
    const double flat = 1.0 / std::hypot(along.x, along.y);
    s.across = {along.y * flat, -along.x * flat, 0}; // +x of a straight end, -y of a straight pick
    s.up = cross(s.across, s.point.tangent);
    s.u = static_cast<double>(ring) / samples;
    return s;
}

/// Appends one yarn to the flat arrays.
class Sweep {
public:
    Sweep(const Textile& textile, YarnMesh& mesh, int samples, int sides, bool capped = true)
        : textile_(textile), mesh_(mesh), samples_(samples), sides_(sides), capped_(capped)
    {
    }

    void add(YarnKind kind, int yarn)
    {
        MeshGroup group;
        group.name = yarn_name(kind, yarn);
        group.kind = kind;
        group.yarn = yarn;
        group.first_vertex = mesh_.segment_of_vertex.size();
        group.first_index = mesh_.indices.size();
        const std::size_t rings = rings_of(textile_, kind, samples_);
        const auto first = static_cast<std::uint32_t>(group.first_vertex);
        const auto per_ring = static_cast<std::uint32_t>(sides_ + 1);
        for (std::size_t ring = 0; ring < rings; ++ring) {
            const Station s = station(textile_, kind, yarn, ring, samples_);
            for (int k = 0; k <= sides_; ++k) skin(kind, yarn, s, k);
            if (ring == 0) continue;
            const std::uint32_t here = first + static_cast<std::uint32_t>(ring) * per_ring, before = here - per_ring;
            for (std::uint32_t k = 0; k + 1 < per_ring; ++k) {
                triangle(before + k, before + k + 1, here + k);
                triangle(here + k, before + k + 1, here + k + 1);
            }
        }
        if (capped_) {
            cap(kind, yarn, station(textile_, kind, yarn, 0, samples_), -1);
            cap(kind, yarn, station(textile_, kind, yarn, rings - 1, samples_), 1);
        }
        group.vertices = mesh_.segment_of_vertex.size() - group.first_vertex;
        group.indices = mesh_.indices.size() - group.first_index;
        mesh_.groups.push_back(std::move(group));
    }

private:
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh_.indices.insert(mesh_.indices.end(), {a, b, c}); }

    void vertex(const Vec3d& position, const Vec3d& normal, double u, double v, int segment)
    {
        for (double value : {position.x, position.y, position.z}) mesh_.positions.push_back(static_cast<float>(value));
        for (double value : {normal.x, normal.y, normal.z}) mesh_.normals.push_back(static_cast<float>(value));
        mesh_.uvs.push_back(static_cast<float>(u));
        mesh_.uvs.push_back(static_cast<float>(v));
        mesh_.segment_of_vertex.push_back(segment);
    }

    int segment(YarnKind kind, int yarn, const Station& s) const
    {
        return kind == YarnKind::warp ? textile_.segment(kind, yarn, s.crossing) : textile_.segment(kind, s.crossing, yarn);
    }

    Vec3d skin_position(const Station& s, const SectionPoint& p) const { return s.point.centre + p.across * s.across + p.up * s.up; }

    SectionPoint around(const Station& s, int k) const
    {
        return section_point(s.point.half_width, s.point.half_height, 2 * pi * (k % sides_) / sides_);
    }

    void skin(YarnKind kind, int yarn, const Station& s, int k)
    {
        const SectionPoint p = around(s, k);
        vertex(skin_position(s, p), p.normal_across * s.across + p.normal_up * s.up, s.u, static_cast<double>(k) / sides_,
               segment(kind, yarn, s));
    }

    void cap(YarnKind kind, int yarn, const Station& s, int side)
    {
        const auto centre = static_cast<std::uint32_t>(mesh_.segment_of_vertex.size());
        const Vec3d normal = static_cast<double>(side) * s.point.tangent;
        vertex(s.point.centre, normal, s.u, 0.5, segment(kind, yarn, s));
        for (int k = 0; k < sides_; ++k)
            vertex(skin_position(s, around(s, k)), normal, s.u, static_cast<double>(k) / sides_, segment(kind, yarn, s));
        for (int k = 0; k < sides_; ++k) {
            const auto here = centre + 1 + static_cast<std::uint32_t>(k), next = centre + 1 + static_cast<std::uint32_t>((k + 1) % sides_);
            if (side > 0)
                triangle(centre, here, next);
            else
                triangle(centre, next, here);
        }
    }

    const Textile& textile_;
    YarnMesh& mesh_;
    int samples_;
    int sides_;
    bool capped_;
};

} // namespace

SectionPoint section_point(double half_width, double half_height, double angle)
{
    SectionPoint p;
    const double sine = std::sin(angle), cosine = std::cos(angle);
    const double flat = std::max(0.0, half_width - half_height);
    p.across = (half_width - flat) * sine + (sine > 1e-6 ? flat : sine < -1e-6 ? -flat : 0.0);
    p.up = half_height * cosine;
    p.normal_across = sine;
    p.normal_up = cosine;
    return p;
}

MeshSize mesh_size(const Textile& textile, int samples, int sides)
{
    MeshSize size;
    const auto n = static_cast<std::size_t>(sides);
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        const auto yarns = static_cast<std::size_t>(textile.system(kind).count);
        const std::size_t rings = rings_of(textile, kind, samples);
        size.vertices += yarns * (rings + 2) * (n + 1);
        size.triangles += yarns * 2 * n * rings;
    }
    return size;
}

std::string yarn_name(YarnKind kind, int yarn)
{
    char name[32];
    std::snprintf(name, sizeof name, "%s_%03d", kind == YarnKind::warp ? "warp" : "weft", yarn);
    return name;
}

void append_yarn(const Textile& textile, YarnKind kind, int yarn, int samples, int sides, YarnMesh& mesh, bool capped)
{
    Sweep(textile, mesh, samples, sides, capped).add(kind, yarn);
}

YarnMesh mesh_yarns(const Textile& textile, int samples, int sides)
{
    const MeshSize size = mesh_size(textile, samples, sides);
    if (size.vertices > std::numeric_limits<std::uint32_t>::max())
        throw Error("The mesh would have " + std::to_string(size.vertices / 1000000) +
                    " million vertices, more than a mesh can number; take a smaller piece.");
    YarnMesh mesh;
    mesh.positions.reserve(3 * size.vertices);
    mesh.normals.reserve(3 * size.vertices);
    mesh.uvs.reserve(2 * size.vertices);
    mesh.segment_of_vertex.reserve(size.vertices);
    mesh.indices.reserve(3 * size.triangles);
    Sweep sweep(textile, mesh, samples, sides);
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (int yarn = 0; yarn < textile.system(kind).count; ++yarn) sweep.add(kind, yarn);
    return mesh;
}

MiddleLine yarn_line(const Textile& textile, YarnKind kind, int yarn, int samples)
{
    MiddleLine line;
    line.name = yarn_name(kind, yarn);
    const std::size_t rings = rings_of(textile, kind, samples);
    line.positions.reserve(3 * rings);
    for (std::size_t ring = 0; ring < rings; ++ring) {
        const Vec3d centre = station(textile, kind, yarn, ring, samples).point.centre;
        for (double value : {centre.x, centre.y, centre.z}) line.positions.push_back(static_cast<float>(value));
    }
    return line;
}

std::vector<MiddleLine> yarn_lines(const Textile& textile, int samples)
{
    std::vector<MiddleLine> lines;
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (int yarn = 0; yarn < textile.system(kind).count; ++yarn) lines.push_back(yarn_line(textile, kind, yarn, samples));
    return lines;
}

} // namespace hygroloom
