// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A strand as a tube of a mesh.
#include "core/geometry/fibres.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

/// Cosine and sine of each side's direction.
void set_around(std::vector<float>& around, std::size_t sides)
{
    if (around.size() == 2 * sides) return;
    around.resize(2 * sides);
    for (std::size_t k = 0; k < sides; ++k) {
        around[2 * k] = static_cast<float>(std::cos(2 * pi * static_cast<double>(k) / static_cast<double>(sides)));
        around[2 * k + 1] = static_cast<float>(std::sin(2 * pi * static_cast<double>(k) / static_cast<double>(sides)));
    }
}

/// Two triangles between each side of each point and the next, and fans over both ends of a capped tube.
void write_triangles(std::uint32_t* index, std::uint32_t first, std::uint32_t points, std::uint32_t sides, bool capped)
{
    const auto triangle = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        *index++ = x;
        *index++ = y;
        *index++ = z;
    };
    for (std::uint32_t i = 1; i < points; ++i) {
        const std::uint32_t here = first + i * sides, before = here - sides;
        for (std::uint32_t k = 0; k < sides; ++k) {
            const std::uint32_t next = k + 1 == sides ? 0 : k + 1;
            triangle(before + k, before + next, here + k);
            triangle(here + k, before + next, here + next);
        }
    }
    if (!capped) return;
    const std::uint32_t last = first + (points - 1) * sides;
    for (std::uint32_t k = 1; k + 1 < sides; ++k) {
        triangle(first, first + k + 1, first + k);
        triangle(last, last + k, last + k + 1);
    }
}

} // namespace

void YarnFibres::middle_line(int strand, std::vector<float>& line) const
{
    const std::size_t count = points(strand);
    line.resize(3 * (count + 2));
    if (!is_hair(strand)) {
        for (std::size_t ring = 0; ring < count + 2; ++ring) place(strand, ring, line.data() + 3 * ring);
        return;
    }
    hair_curve(hair(strand), line.data() + 3);
    for (std::size_t c = 0; c < 3; ++c) { // straight on at both ends
        line[c] = 2 * line[3 + c] - line[6 + c];
        line[3 * (count + 1) + c] = 2 * line[3 * count + c] - line[3 * (count - 1) + c];
    }
}

void YarnFibres::tube(int strand, YarnMesh& mesh, std::size_t first_vertex, std::size_t first_index) const
{
    const std::size_t count = points(strand);
    const auto sides = static_cast<std::size_t>(options_.sides);
    const auto r = static_cast<float>(radius(strand));
    thread_local std::vector<float> line;
    thread_local std::vector<float> around;
    middle_line(strand, line);
    set_around(around, sides);
    const Hair* own = is_hair(strand) ? &hair(strand) : nullptr;
    Vec3T<float> plane;
    if (own) {
        const Vec3d n = cross(own->direction, own->bend);
        plane = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
    }
    float* position = mesh.positions.data() + 3 * first_vertex;
    float* normal = mesh.normals.data() + 3 * first_vertex;
    float* uv = mesh.uvs.data() + 2 * first_vertex;
    int* segment = mesh.segment_of_vertex.data() + first_vertex;
    for (std::size_t i = 0; i < count; ++i) {
        const float* p = line.data() + 3 * (i + 1);
        const Ring& ring = ring_[own ? own->ring : i + 1];
        Vec3T<float> t{p[3] - p[-3], p[4] - p[-2], p[5] - p[-1]};
        t = (1 / std::max(length(t), 1e-20f)) * t;
        Vec3T<float> a = own ? plane : Vec3T<float>{ring.up[0], ring.up[1], ring.up[2]};
        a = a - dot(a, t) * t;
        a = (1 / std::max(length(a), 1e-20f)) * a;
        const Vec3T<float> b = cross(t, a); // right-handed (b, t, a), as the yarn's (across, tangent, up)
        for (std::size_t k = 0; k < sides; ++k) {
            const float c = around[2 * k], s = around[2 * k + 1];
            const Vec3T<float> n{c * a.x + s * b.x, c * a.y + s * b.y, c * a.z + s * b.z};
            normal[0] = n.x;
            normal[1] = n.y;
            normal[2] = n.z;
            position[0] = p[0] + r * n.x;
            position[1] = p[1] + r * n.y;
            position[2] = p[2] + r * n.z;
            uv[0] = ring.u;
            uv[1] = std::abs(1 - 2 * static_cast<float>(k) / static_cast<float>(sides));
            *segment++ = ring.segment;
            normal += 3;
            position += 3;
            uv += 2;
        }
    }
    write_triangles(mesh.indices.data() + first_index, static_cast<std::uint32_t>(first_vertex), static_cast<std::uint32_t>(count),
                    static_cast<std::uint32_t>(sides), options_.capped);
}

} // namespace hygroloom
