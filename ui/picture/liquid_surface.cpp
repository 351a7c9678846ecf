// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The field is that of Zhu and Bridson, "Animating sand as a fluid" (2005): the distance to the particles' weighted mean.
// It is turned into triangles by surface nets, Gibson (1998): one vertex in each cell that the surface passes.
#include "ui/picture/liquid_surface.h"

#include "core/base/units.h"
#include "core/scene/liquid_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hygroloom {

namespace {

constexpr double most_nodes = 3e6;

struct Grid {
    QVector3D low;
    float cell = 0;
    int nx = 0, ny = 0, nz = 0;
    std::vector<float> value; ///< negative inside the liquid

    std::size_t at(int x, int y, int z) const
    {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(y)) * static_cast<std::size_t>(nx) +
               static_cast<std::size_t>(x);
    }
};

Grid grid_round(const std::vector<QVector3D>& centres, double spacing)
{
    constexpr float infinity = std::numeric_limits<float>::max();
    QVector3D low(infinity, infinity, infinity), high = -low;
    for (const QVector3D& centre : centres) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], centre[axis]);
            high[axis] = std::max(high[axis], centre[axis]);
        }
    }
    const auto border = static_cast<float>(2.5 * spacing);
    const QVector3D size = high - low + 2 * QVector3D(border, border, border);
    Grid grid;
    grid.low = low - QVector3D(border, border, border);
    grid.cell = static_cast<float>(std::max(0.5 * spacing, std::cbrt(static_cast<double>(size.x()) * size.y() * size.z() / most_nodes)));
    grid.nx = static_cast<int>(size.x() / grid.cell) + 2;
    grid.ny = static_cast<int>(size.y() / grid.cell) + 2;
    grid.nz = static_cast<int>(size.z() / grid.cell) + 2;
    return grid;
}

void fill(Grid& grid, const std::vector<QVector3D>& centres, double spacing)
{
    struct Mean {
        QVector3D sum;
        float weight = 0;
    };
    const std::size_t nodes = static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny) * static_cast<std::size_t>(grid.nz);
    std::vector<Mean> mean(nodes);
    const float reach = std::max(static_cast<float>(2.2 * spacing), 1.8F * grid.cell);
    for (const QVector3D& centre : centres) {
        const QVector3D place = (centre - grid.low) / grid.cell;
        const float span = reach / grid.cell;
        const auto first = [&](float p) { return std::max(0, static_cast<int>(std::ceil(p - span))); };
        const auto last = [&](float p, int n) { return std::min(n - 1, static_cast<int>(p + span)); };
        for (int z = first(place.z()); z <= last(place.z(), grid.nz); ++z) {
            for (int y = first(place.y()); y <= last(place.y(), grid.ny); ++y) {
                for (int x = first(place.x()); x <= last(place.x(), grid.nx); ++x) {
                    const QVector3D node =
                        grid.low + grid.cell * QVector3D(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
                    const float s = 1 - (node - centre).lengthSquared() / (reach * reach);
                    if (s > 0) {
                        Mean& m = mean[grid.at(x, y, z)];
                        m.sum += s * s * s * centre;
                        m.weight += s * s * s;
                    }
                }
            }
        }
    }
    const float radius = std::max(static_cast<float>(0.8 * spacing), 0.7F * grid.cell);
    grid.value.assign(nodes, radius);
    for (int z = 0; z < grid.nz; ++z) {
        for (int y = 0; y < grid.ny; ++y) {
            for (int x = 0; x < grid.nx; ++x) {
                const Mean& m = mean[grid.at(x, y, z)];
                if (m.weight > 1e-6F) {
                    const QVector3D node =
                        grid.low + grid.cell * QVector3D(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
                    grid.value[grid.at(x, y, z)] = (node - m.sum / m.weight).length() - radius;
                }
            }
        }
    }
}

/// One vertex in each cell with corners on both sides, at the mean of the edges' crossings; its number by cell.
std::vector<std::int32_t> place_vertices(const Grid& grid, LiquidSurface& surface)
{
    std::vector<std::int32_t> number(grid.value.size(), -1);
    for (int z = 0; z + 1 < grid.nz; ++z) {
        for (int y = 0; y + 1 < grid.ny; ++y) {
            for (int x = 0; x + 1 < grid.nx; ++x) {
                std::array<float, 8> corner{};
                int inside = 0;
                for (int i = 0; i < 8; ++i) {
                    corner[static_cast<std::size_t>(i)] = grid.value[grid.at(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2))];
                    inside += corner[static_cast<std::size_t>(i)] < 0;
                }
                if (inside == 0 || inside == 8) { continue; }
                QVector3D sum;
                int crossings = 0;
                for (int i = 0; i < 8; ++i) {
                    for (const int axis : {1, 2, 4}) {
                        const float a = corner[static_cast<std::size_t>(i)], b = corner[static_cast<std::size_t>(i | axis)];
                        if (i & axis || (a < 0) == (b < 0)) { continue; }
                        const float t = a / (a - b);
                        sum +=
                            QVector3D(static_cast<float>(i & 1) + (axis == 1 ? t : 0), static_cast<float>(i >> 1 & 1) + (axis == 2 ? t : 0),
                                      static_cast<float>(i >> 2) + (axis == 4 ? t : 0));
                        ++crossings;
                    }
                }
                number[grid.at(x, y, z)] = static_cast<std::int32_t>(surface.vertices.size());
                surface.vertices.push_back(
                    {grid.low + grid.cell * (QVector3D(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)) +
                                             sum / static_cast<float>(crossings)),
                     {}});
            }
        }
    }
    return number;
}

/// Each grid edge that crosses the surface joins the four cells round it.
void join(const Grid& grid, const std::vector<std::int32_t>& number, LiquidSurface& surface)
{
    for (int z = 1; z + 1 < grid.nz; ++z) {
        for (int y = 1; y + 1 < grid.ny; ++y) {
            for (int x = 1; x + 1 < grid.nx; ++x) {
                const bool here = grid.value[grid.at(x, y, z)] < 0;
                const auto quad = [&](bool there, std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
                    if (here == there) { return; }
                    std::array<std::uint32_t, 4> q{static_cast<std::uint32_t>(number[a]), static_cast<std::uint32_t>(number[b]),
                                                   static_cast<std::uint32_t>(number[c]), static_cast<std::uint32_t>(number[d])};
                    if (!here) { std::swap(q[1], q[3]); }
                    surface.indices.insert(surface.indices.end(), {q[0], q[1], q[2], q[0], q[2], q[3]});
                };
                quad(grid.value[grid.at(x + 1, y, z)] < 0, grid.at(x, y - 1, z - 1), grid.at(x, y, z - 1), grid.at(x, y, z),
                     grid.at(x, y - 1, z));
                quad(grid.value[grid.at(x, y + 1, z)] < 0, grid.at(x - 1, y, z - 1), grid.at(x - 1, y, z), grid.at(x, y, z),
                     grid.at(x, y, z - 1));
                quad(grid.value[grid.at(x, y, z + 1)] < 0, grid.at(x - 1, y - 1, z), grid.at(x, y - 1, z), grid.at(x, y, z),
                     grid.at(x - 1, y, z));
            }
        }
    }
}

void smooth(LiquidSurface& surface)
{
    std::vector<QVector3D> sum(surface.vertices.size());
    std::vector<int> count(surface.vertices.size());
    for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = surface.indices[i + k], to = surface.indices[i + (k + 1) % 3];
            sum[from] += surface.vertices[to].position;
            ++count[from];
        }
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
        if (count[i] > 0) {
            surface.vertices[i].position = 0.4F * surface.vertices[i].position + 0.6F * sum[i] / static_cast<float>(count[i]);
        }
    }
}

void add_normals(LiquidSurface& surface)
{
    for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
        auto& a = surface.vertices[surface.indices[i]];
        auto& b = surface.vertices[surface.indices[i + 1]];
        auto& c = surface.vertices[surface.indices[i + 2]];
        const QVector3D normal = QVector3D::crossProduct(b.position - a.position, c.position - a.position);
        a.normal += normal;
        b.normal += normal;
        c.normal += normal;
    }
    for (auto& vertex : surface.vertices) { vertex.normal.normalize(); }
}

/// Round the frame's particles.
void wrap(const Frame& frame, LiquidSurface& surface)
{
    if (frame.positions.empty() || !(frame.ledger.water_free > 0)) { return; }
    std::vector<QVector3D> centres;
    centres.reserve(frame.positions.size());
    for (const auto& position : frame.positions) { centres.emplace_back(1000 * position[0], 1000 * position[1], 1000 * position[2]); }
    // Spacing of particles that lie as dense as in water at rest; its density is near enough for a picture.
    const double spacing = mm_from_metre(std::cbrt(frame.ledger.water_free / 1000 / static_cast<double>(centres.size())));
    Grid grid = grid_round(centres, spacing);
    fill(grid, centres, spacing);
    const std::vector<std::int32_t> number = place_vertices(grid, surface);
    join(grid, number, surface);
    smooth(surface);
    smooth(surface);
    add_normals(surface);
    surface.particle_radius = static_cast<float>(std::cbrt(3 / (4 * pi)) * spacing);
    surface.centres = std::move(centres);
}

/// A ball, or what of it stands over a face, with that face below.
void add_body(const FrameCap& body, LiquidSurface& surface)
{
    constexpr int rings = 28, sides = 72;
    const bool falls = body.base <= 0;
    const double ball = falls ? std::cbrt(3 * body.volume / (4 * pi)) : 0.5 * (body.base * body.base / body.height + body.height);
    const double last = falls ? pi : std::acos(std::clamp(1 - body.height / ball, -1.0, 1.0));
    const double middle = body.face + body.height - ball; // m, its height
    const auto add = [&](double out, double height, const QVector3D& normal, double angle) {
        const QVector3D at(static_cast<float>(mm_from_metre(body.x + out * std::cos(angle))),
                           static_cast<float>(mm_from_metre(body.y + out * std::sin(angle))), static_cast<float>(mm_from_metre(height)));
        surface.vertices.push_back({at, normal});
    };
    const auto first = static_cast<std::uint32_t>(surface.vertices.size());
    for (int ring = 0; ring <= rings; ++ring) {
        const double down = last * ring / rings;
        for (int side = 0; side <= sides; ++side) {
            const double angle = 2 * pi * (side % sides) / sides;
            add(ball * std::sin(down), middle + ball * std::cos(down),
                {static_cast<float>(std::sin(down) * std::cos(angle)), static_cast<float>(std::sin(down) * std::sin(angle)),
                 static_cast<float>(std::cos(down))},
                angle);
        }
    }
    for (std::uint32_t ring = 0; ring < rings; ++ring) {
        for (std::uint32_t side = 0; side < sides; ++side) {
            const std::uint32_t here = first + ring * (sides + 1) + side, below = here + sides + 1;
            surface.indices.insert(surface.indices.end(), {here, below, below + 1, here, below + 1, here + 1});
        }
    }
    if (falls) { return; }
    const auto face = static_cast<std::uint32_t>(surface.vertices.size());
    for (int side = 0; side < sides; ++side) { add(body.base, body.face, {0, 0, -1}, 2 * pi * side / sides); }
    for (std::uint32_t side = 1; side + 1 < sides; ++side) {
        surface.indices.insert(surface.indices.end(), {face, face + side + 1, face + side});
    }
}

} // namespace

LiquidSurface liquid_surface(const Frame& frame, const std::vector<FrameCap>& bodies)
{
    LiquidSurface surface;
    wrap(frame, surface);
    Frame in_bodies;
    for (const FrameCap& body : bodies) {
        if (body.height > 0 && body.volume > 0) { in_bodies.caps.push_back(body); }
    }
    for (const FrameCap& body : in_bodies.caps) { add_body(body, surface); }
    if (surface.centres.empty() && !in_bodies.caps.empty()) { // to be shown as particles all the same
        double volume = 0;
        for (const auto& point : liquid_points(in_bodies)) {
            surface.centres.emplace_back(1000 * point[0], 1000 * point[1], 1000 * point[2]);
        }
        for (const FrameCap& body : in_bodies.caps) { volume += body.volume; }
        surface.particle_radius = static_cast<float>(
            mm_from_metre(std::cbrt(3 * volume / (4 * pi * std::max<double>(1, static_cast<double>(surface.centres.size()))))));
    }
    return surface;
}

} // namespace hygroloom
