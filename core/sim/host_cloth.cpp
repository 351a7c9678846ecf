// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/sim/host_cloth.h"

#include <algorithm>
#include <cmath>

namespace hygroloom::inline HL_PRECISION {
namespace {

/// A yarn's section, cut into rows and columns of beads.
struct CutSection {
    double half_height, half_width;
    int rows, columns;

    double flat() const { return std::max(0.0, half_width - half_height); }
    double area() const { return pi * half_height * half_height + 4.0 * flat() * half_height; } // of a stadium
    double outline() const { return 2.0 * pi * half_height + 4.0 * flat(); }
    double up(int row) const { return half_height * (2.0 * row + 1.0 - rows) / rows; }
    double side(int column) const { return half_width * (2.0 * column + 1.0 - columns) / columns; }
    /// Of a bead's places about its middle, the mean along both directions; of an ellipse.
    double variance() const { return 0.125 * (half_height * half_height / (rows * rows) + half_width * half_width / (columns * columns)); }
};

int bounded(double wanted, int most) { return std::clamp(static_cast<int>(std::ceil(wanted)), 1, most); }

/// The share of the space round its skin that a straight yarn takes of a kernel, over and under it.
double share_of_own_yarn(const CutSection& section, double bead_length, Real support)
{
    double share = 0;
    const double volume = section.area() * bead_length / (section.rows * section.columns);
    const int far = static_cast<int>(static_cast<double>(support) / bead_length) + 1;
    for (int row = 0; row < section.rows; ++row)
        for (int column = 0; column < section.columns; ++column)
            for (int k = -far; k <= far; ++k) {
                const double up = section.half_height - section.up(row);
                share += volume * static_cast<double>(
                                      spline_kernel(static_cast<Real>(std::hypot(up, section.side(column), k * bead_length)), support));
            }
    return share;
}

} // namespace

std::vector<YarnShape> yarn_shapes(const Scene& scene, std::vector<float>& profiles)
{
    std::vector<YarnShape> shapes;
    float shift = 0;
    for (float s : scene.shift) shift = std::max(shift, std::abs(s));
    for (const ContactShape& shape : scene.shapes) {
        float width = static_cast<float>(shape.half_width);
        for (std::size_t k = 3; k < shape.profiles.size(); k += 4) width = std::max(width, shape.profiles[k]); // see ContactShape
        shapes.push_back({static_cast<Real>(shape.half_height), static_cast<Real>(shape.half_width), static_cast<Real>(width + shift),
                          static_cast<int>(profiles.size())});
        profiles.insert(profiles.end(), shape.profiles.begin(), shape.profiles.end());
    }
    return shapes;
}

HostCloth::HostCloth(const Scene& scene) : shift_(scene.shift), shapes_(yarn_shapes(scene, profiles_))
{
    if (shift_.empty()) shift_.assign(static_cast<std::size_t>(scene.segments()), 0.0f);
    static_cast<Yarns&>(shape_) = {scene.ends,        scene.picks,        scene.warp_types,      scene.weft_types(),
                                   scene.type.data(), scene.yarns.data(), scene.crossing.data(), {}};
    shape_.half_thickness = static_cast<Real>(scene.half_thickness);
    shape_.warp_pitch = static_cast<Real>(scene.warp_pitch);
    shape_.weft_pitch = static_cast<Real>(scene.weft_pitch);
    shape_.samples = scene.profile_samples;
    shape_.shapes = shapes_.data();
    shape_.profiles = profiles_.data();
    shape_.warp_up = scene.warp_up.data();
    shape_.shift = shift_.data();
}

HostBeads make_beads(const Scene& scene, double spacing, double support, double reach)
{
    constexpr double variance_of_kernel = 0.075; // along one axis, over the square of its support: cubic spline
    constexpr int most_rows = 3, most_columns = 9, most_along = 16;
    int rows = 1, columns = 1;
    double thinnest = scene.shapes[0].half_height;
    for (const ContactShape& shape : scene.shapes) {
        rows = std::max(rows, bounded(shape.half_height / (0.8 * spacing), most_rows));
        thinnest = std::min(thinnest, shape.half_height);
    }
    for (const ContactShape& shape : scene.shapes)
        columns = std::max(columns, bounded(rows * shape.half_width / shape.half_height - 0.5, most_columns));
    const double longest = std::max(scene.warp_pitch, scene.weft_pitch);
    int along = bounded(longest / std::hypot(1.1 * spacing, thinnest / rows), most_along);
    constexpr double most_beads = 1e7; // 160 MB; on a large cloth a small drop's particles meet coarser beads
    while (rows * columns * along > 1 && static_cast<double>(scene.segments()) * rows * columns * along > most_beads)
        --(along >= columns ? along : columns >= rows ? columns : rows);

    HostBeads result;
    result.view.per_segment = rows * columns * along;
    for (std::size_t k = 0; k < scene.shapes.size(); ++k) {
        const CutSection section{scene.shapes[k].half_height, scene.shapes[k].half_width, rows, columns};
        const auto widened = [&](double kernel) {
            return static_cast<Real>(std::sqrt(kernel * kernel + section.variance() / variance_of_kernel));
        };
        const Real wetting = static_cast<Real>(scene.yarns[k].adhesion / scene.climate.surface_tension - 1.0);
        BeadType type{widened(support), widened(reach), wall_share(wetting), 0};
        // Of the energy along a skin only what lies outside the yarn acts on anything: half of it on a flat one.
        const double outside = std::clamp(1.0 - share_of_own_yarn(section, longest / along, type.reach), 0.5, 1.0);
        type.pull = static_cast<Real>(static_cast<double>(wall_attraction(wetting)) * scene.climate.surface_tension / outside *
                                      section.outline() / section.area());
        result.view.widest = std::max(result.view.widest, type.reach);
        result.types.push_back(type);
    }

    const HostCloth cloth(scene);
    const TextileShape& t = cloth.shape();
    result.beads.resize(static_cast<std::size_t>(scene.segments()) * static_cast<std::size_t>(result.view.per_segment) + lanes);
    for (bool is_warp : {true, false})
        for (int end = 0; end < scene.ends; ++end)
            for (int pick = 0; pick < scene.picks; ++pick) {
                Quad* bead = result.beads.data() + std::int64_t{t.segment(is_warp, end, pick)} * result.view.per_segment;
                const double pitch = is_warp ? scene.weft_pitch : scene.warp_pitch;
                const double x = (end - 0.5 * (scene.ends - 1)) * scene.warp_pitch, y = (pick - 0.5 * (scene.picks - 1)) * scene.weft_pitch;
                for (int k = 0; k < along; ++k) {
                    const double part = (k + 0.5) / along - 0.5;
                    const YarnPlace at = yarn_place(t, is_warp, end, pick, static_cast<Real>(part));
                    const CutSection section{static_cast<double>(at.half_height), static_cast<double>(at.half_width), rows, columns};
                    const double slope = static_cast<double>(at.slope), cosine = 1.0 / std::sqrt(1.0 + slope * slope);
                    const double volume = section.area() * pitch / (cosine * result.view.per_segment);
                    for (int row = 0; row < rows; ++row)
                        for (int column = 0; column < columns; ++column) {
                            const double up = section.up(row), side = static_cast<double>(at.side) + section.side(column);
                            const double forth = part * pitch - up * slope * cosine;
                            const double z = static_cast<double>(at.height) + up * cosine;
                            result.view.top = std::max(result.view.top, static_cast<Real>(std::abs(z)));
                            *bead++ = {static_cast<Real>(x + (is_warp ? side : forth)), static_cast<Real>(y + (is_warp ? forth : side)),
                                       static_cast<Real>(z), static_cast<Real>(volume)};
                        }
                }
            }
    return result;
}

} // namespace hygroloom::inline HL_PRECISION
