// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/verify/drawn_pores.h"

#include "core/base/units.h"
#include "core/geometry/fibres.h"
#include "core/room/yarn_stations.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

constexpr double margin_of_section = 4; // fibre radii of air about a section
constexpr double margin_of_room = 2;    // of the layer's thickness, above and below

/// Distance of a place from a racetrack's skin, more than 0 outside; of the round one of its height along its flat.
double outside_racetrack(double x, double y, double half_width, double half_height)
{
    return std::hypot(std::max(0.0, std::abs(x) - (half_width - half_height)), y) - half_height;
}

FibreCut cut_of(const std::vector<float>& line, std::size_t ring, const YarnPoint& at, double radius)
{
    const auto point = [&](std::size_t i) {
        return Vec3d{static_cast<double>(line[3 * i]), static_cast<double>(line[3 * i + 1]), static_cast<double>(line[3 * i + 2])};
    };
    const double flat = 1.0 / std::hypot(at.tangent.x, at.tangent.y);
    const Vec3d across{at.tangent.y * flat, -at.tangent.x * flat, 0}, up = cross(across, at.tangent);
    const Vec3d from_middle = point(ring) - at.centre, along = point(ring + 1) - point(ring - 1);
    const double obliqueness = length(along) / std::abs(dot(along, at.tangent));
    return {dot(from_middle, across), dot(from_middle, up), radius * std::sqrt(obliqueness)};
}

} // namespace

std::vector<DrawnSection> drawn_sections(Textile textile, YarnKind kind, int yarn, int sections)
{
    YarnSystem& system = kind == YarnKind::warp ? textile.warp : textile.weft;
    YarnType& type = system.types[static_cast<std::size_t>(textile.type_of(kind, yarn))];
    for (int round = 0; round < 3; ++round) // thinner fibres reach further out and are longer
        type.fibres = std::max(1, static_cast<int>(std::lround(
                                      type.fibres * std::pow(drawn_fibre_radius(type) / metre_from_um(type.fibre.fibre_radius_um), 2))));
    FibreOptions options;
    options.samples_per_crossing = 16;
    options.flyaways = false;
    const YarnFibres fibres(textile, options, kind, yarn, 0, sections);
    std::vector<DrawnSection> drawn(static_cast<std::size_t>(sections));
    std::vector<YarnPoint> at;
    for (int k = 0; k < sections; ++k) {
        at.push_back(yarn_point(textile, kind, yarn, k, 0));
        drawn[k].half_width = at.back().half_width;
        drawn[k].half_height = at.back().half_height;
    }
    std::vector<float> line;
    for (int strand = 0; strand < fibres.regular(); ++strand) {
        line.resize(3 * fibres.points(strand));
        fibres.curve(strand, line.data());
        for (std::size_t k = 0; k < drawn.size(); ++k)
            drawn[k].fibres.push_back(
                cut_of(line, k * static_cast<std::size_t>(options.samples_per_crossing) + 8, at[k], fibres.radius(strand)));
    }
    return drawn;
}

VoxelGrid grid_of_sections(const std::vector<DrawnSection>& sections, double voxel)
{
    double half_width = 0, half_height = 0;
    for (const DrawnSection& s : sections) {
        half_width = std::max(half_width, s.half_width);
        half_height = std::max(half_height, s.half_height);
    }
    const double margin = margin_of_section * sections[0].fibres[0].radius;
    VoxelGrid g;
    g.nx = static_cast<int>(std::ceil(2 * (half_width + margin) / voxel));
    g.ny = static_cast<int>(std::ceil(2 * (half_height + margin) / voxel));
    g.nz = static_cast<int>(sections.size());
    g.sections = true;
    return g;
}

PoreImage image_of_sections(const std::vector<DrawnSection>& sections, double voxel, double skin)
{
    PoreImage image{grid_of_sections(sections, voxel), {}};
    const VoxelGrid& g = image.grid;
    image.voxels.assign(g.size(), Voxel::outside);
    const auto place = [&](int i, int n) { return (i + 0.5 - 0.5 * n) * voxel; };
    const auto first = [&](double p, int n) { return std::clamp(static_cast<int>(std::floor(p / voxel + 0.5 * n)), 0, n - 1); };
    for (int z = 0; z < g.nz; ++z) {
        const DrawnSection& s = sections[z];
        for (int y = 0; y < g.ny; ++y)
            for (int x = 0; x < g.nx; ++x)
                if (outside_racetrack(place(x, g.nx), place(y, g.ny), s.half_width, s.half_height) < -skin)
                    image.voxels[g.at(x, y, z)] = Voxel::pore;
        for (const FibreCut& f : s.fibres)
            for (int y = first(f.y - f.radius, g.ny); y <= first(f.y + f.radius, g.ny); ++y)
                for (int x = first(f.x - f.radius, g.nx); x <= first(f.x + f.radius, g.nx); ++x)
                    if (std::hypot(place(x, g.nx) - f.x, place(y, g.ny) - f.y) < f.radius) image.voxels[g.at(x, y, z)] = Voxel::solid;
    }
    return image;
}

namespace {

/// Fills one yarn; what leaves the repeat comes in on the other side.
void fill_yarn(const Textile& textile, YarnKind kind, int yarn, PoreImage& image, const Vec3d& voxel)
{
    const VoxelGrid& g = image.grid;
    const bool is_warp = kind == YarnKind::warp;
    const double along_voxel = is_warp ? voxel.y : voxel.x, across_voxel = is_warp ? voxel.x : voxel.y;
    const int n_along = is_warp ? g.ny : g.nx, n_across = is_warp ? g.nx : g.ny;
    const YarnStations stations(textile, kind, yarn, 0.5 * along_voxel, 2);
    const double reach = 0.5 * textile.type(kind, yarn).section.height + along_voxel;
    for (int a = 0; a < n_along; ++a)
        for (int z = 0; z < g.nz; ++z) {
            const auto [station, off] = stations.nearest((a + 0.5 - 0.5 * n_along) * along_voxel, (z + 0.5 - 0.5 * g.nz) * voxel.z, reach);
            if (!station || off >= station->half_height) continue;
            const double half = station->flat + std::sqrt(station->half_height * station->half_height - off * off);
            const double middle = station->across / across_voxel + 0.5 * n_across - 0.5, wide = half / across_voxel;
            for (int c = static_cast<int>(std::ceil(middle - wide)); c <= static_cast<int>(std::floor(middle + wide)); ++c) {
                const int inside = ((c % n_across) + n_across) % n_across;
                image.voxels[is_warp ? g.at(inside, a, z) : g.at(a, inside, z)] = Voxel::solid;
            }
        }
}

} // namespace

VoxelGrid grid_of_room(const Textile& textile, double voxel)
{
    const auto whole = [&](double length) { return std::max(1, static_cast<int>(std::lround(length / voxel))); };
    VoxelGrid g;
    g.nx = whole(textile.ends() * textile.warp.pitch);
    g.ny = whole(textile.picks() * textile.weft.pitch);
    g.nz = static_cast<int>(std::ceil((1 + 2 * margin_of_room) * textile.thickness / voxel));
    g.repeats = true;
    return g;
}

PoreImage image_of_room(const Textile& textile, double voxel)
{
    PoreImage image{grid_of_room(textile, voxel), {}};
    const VoxelGrid& g = image.grid;
    image.voxels.assign(g.size(), Voxel::outside);
    for (int z = 0; z < g.nz; ++z)
        if (std::abs((z + 0.5 - 0.5 * g.nz) * voxel) < 0.5 * textile.thickness)
            std::fill_n(image.voxels.begin() + static_cast<std::ptrdiff_t>(g.at(0, 0, z)), g.nx * g.ny, Voxel::pore);
    const Vec3d fitted{textile.ends() * textile.warp.pitch / g.nx, textile.picks() * textile.weft.pitch / g.ny, voxel}; // a whole repeat
    for (int end = 0; end < textile.ends(); ++end) fill_yarn(textile, YarnKind::warp, end, image, fitted);
    for (int pick = 0; pick < textile.picks(); ++pick) fill_yarn(textile, YarnKind::weft, pick, image, fitted);
    return image;
}

} // namespace hygroloom
