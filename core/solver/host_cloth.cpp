// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/solver/host_cloth.h"

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

/// Half the width of a yarn where it is widest.
float widest_half(const ContactShape& shape)
{
    float widest = static_cast<float>(shape.half_width);
    for (std::size_t k = 3; k < shape.profiles.size(); k += 4) widest = std::max(widest, shape.profiles[k]); // see ContactShape
    return widest;
}

TextileShape numbers_of(const Scene& scene)
{
    TextileShape t;
    static_cast<Yarns&>(t) = {
        scene.cloth.ends, scene.cloth.picks, scene.cloth.warp_types, scene.cloth.weft_types(), nullptr, nullptr, nullptr, {}, {}};
    t.half_thickness = static_cast<Real>(scene.cloth.half_thickness);
    t.warp_pitch = static_cast<Real>(scene.cloth.warp_pitch);
    t.weft_pitch = static_cast<Real>(scene.cloth.weft_pitch);
    t.per_warp_pitch = Real(1) / t.warp_pitch;
    t.per_weft_pitch = Real(1) / t.weft_pitch;
    t.samples = scene.cloth.profile_samples;
    t.has_rooms = scene.cloth.by_suction;
    float shift = 0;
    for (float s : scene.cloth.shift) shift = std::max(shift, std::abs(s));
    for (std::size_t type = 0; type < scene.cloth.shapes.size(); ++type) {
        Real& widest = type < static_cast<std::size_t>(scene.cloth.warp_types) ? t.widest_warp : t.widest_weft;
        widest = std::max(widest, static_cast<Real>(widest_half(scene.cloth.shapes[type]) + shift));
    }
    return t;
}

/// Puts the profiles of all types of yarn one after the other, each in the order of ContactShape.
class ProfileTable {
public:
    ProfileTable(const Scene& scene, std::vector<Quad>& profiles)
        : scene_(scene), samples_(static_cast<std::size_t>(scene.cloth.profile_samples))
    {
        for (std::size_t type = 0; type < scene.cloth.shapes.size(); ++type) {
            first_.push_back(static_cast<int>(profiles.size() / samples_));
            const std::vector<float>& values = scene.cloth.shapes[type].profiles;
            for (std::size_t k = 0; k + 3 < values.size(); k += 4)
                profiles.push_back({Real(values[k]), Real(values[k + 1]), Real(values[k + 2]), Real(values[k + 3])});
            for (int crossed = 0; crossed < crossed_types(type); ++crossed) level(type, crossed, profiles);
        }
    }
    /// From over a yarn of one type to over or under the next; the other system's types count from 0.
    int number(std::size_t own, int before, int after, bool changes) const
    {
        return first_[own] + 2 * (before * crossed_types(own) + after) + (changes ? 1 : 0);
    }

private:
    bool is_warp(std::size_t type) const { return type < static_cast<std::size_t>(scene_.cloth.warp_types); }
    int crossed_types(std::size_t type) const { return is_warp(type) ? scene_.cloth.weft_types() : scene_.cloth.warp_types; }
    /// Between yarns of one type, on the same side of both, a yarn keeps the section that it has at crossings.
    void level(std::size_t own, int crossed, std::vector<Quad>& profiles) const
    {
        const ContactShape& shape = scene_.cloth.shapes[own];
        const int warp = is_warp(own) ? static_cast<int>(own) : crossed;
        const int weft = is_warp(own) ? crossed : static_cast<int>(own) - scene_.cloth.warp_types;
        const CrossingParameters& crossing = scene_.cloth.crossing[static_cast<std::size_t>(warp * scene_.cloth.weft_types() + weft)];
        const Quad section{Real(is_warp(own) ? crossing.warp_rise : crossing.weft_rise), 0, Real(shape.half_height),
                           Real(shape.half_width)};
        const std::size_t begin = static_cast<std::size_t>(number(own, crossed, crossed, false)) * samples_;
        std::fill_n(profiles.begin() + static_cast<std::ptrdiff_t>(begin), samples_, section);
    }

    const Scene& scene_;
    std::size_t samples_;
    std::vector<int> first_; ///< of each type
};

/// The paths of one yarn's segments, to the crossing before and to the one after.
void add_paths(const Scene& scene, const std::vector<float>& shift, const ProfileTable& profiles, bool is_warp, int line,
               std::vector<Quad>& paths)
{
    const int crossings = is_warp ? scene.cloth.picks : scene.cloth.ends;
    const auto type = [&](int any_line) { return scene.cloth.type[static_cast<std::size_t>(any_line)]; };
    const auto crossed = [&](int k) { return is_warp ? type(scene.cloth.ends + k) - scene.cloth.warp_types : type(k); };
    const auto is_up = [&](int k) {
        const int end = is_warp ? line : k, pick = is_warp ? k : line;
        return (scene.cloth.warp_up[static_cast<std::size_t>(end * scene.cloth.picks + pick)] != 0) == is_warp;
    };
    const auto shift_at = [&](int k) {
        return Real(shift[static_cast<std::size_t>(is_warp ? line * scene.cloth.picks + k
                                                           : scene.cloth.ends * scene.cloth.picks + line * scene.cloth.ends + k)]);
    };
    const std::size_t own = type(is_warp ? line : scene.cloth.ends + line);
    for (int k = 0; k < crossings; ++k)
        for (int next : {k - 1, k + 1}) {
            const bool has_next = next >= 0 && next < crossings, changes = has_next && is_up(next) != is_up(k);
            const int profile = profiles.number(own, crossed(k), has_next ? crossed(next) : crossed(k), changes);
            paths.push_back({Real(profile * scene.cloth.profile_samples), Real(is_up(k) ? 1 : -1), shift_at(k),
                             has_next ? shift_at(next) - shift_at(k) : Real(0)});
        }
}

/// How many beads a segment is cut into: rows and columns of its section, and pieces along it.
struct BeadGrid {
    int rows = 1, columns = 1, along = 1;
    double length = 0; ///< m, of a piece, at most

    int per_segment() const { return rows * columns * along; }
};

BeadGrid bead_grid(const Cloth& cloth, double spacing)
{
    constexpr int most_rows = 3, most_columns = 9, most_along = 16;
    BeadGrid g;
    double thinnest = cloth.shapes[0].half_height;
    for (const ContactShape& shape : cloth.shapes) {
        g.rows = std::max(g.rows, bounded(shape.half_height / (0.8 * spacing), most_rows));
        thinnest = std::min(thinnest, shape.half_height);
    }
    for (const ContactShape& shape : cloth.shapes)
        g.columns = std::max(g.columns, bounded(g.rows * shape.half_width / shape.half_height - 0.5, most_columns));
    const double longest = std::max(cloth.warp_pitch, cloth.weft_pitch);
    g.along = bounded(longest / std::hypot(1.1 * spacing, thinnest / g.rows), most_along);
    constexpr double most_beads = 1e7; // 160 MB; on a large cloth a small drop's particles meet coarser beads
    while (g.per_segment() > 1 && static_cast<double>(cloth.segments()) * g.rows * g.columns * g.along > most_beads)
        --(g.along >= g.columns ? g.along : g.columns >= g.rows ? g.columns : g.rows);
    g.length = longest / g.along;
    return g;
}

BeadType bead_type(const Scene& scene, std::size_t type, const BeadGrid& grid, double support, double reach)
{
    constexpr double variance_of_kernel = 0.075; // along one axis, over the square of its support: cubic spline
    const ContactShape& shape = scene.cloth.shapes[type];
    const CutSection section{shape.half_height, shape.half_width, grid.rows, grid.columns};
    const auto widened = [&](double kernel) {
        return static_cast<Real>(std::sqrt(kernel * kernel + section.variance() / variance_of_kernel));
    };
    const Real wetting = static_cast<Real>(scene.cloth.yarns[type].adhesion / scene.climate.surface_tension - 1.0);
    BeadType result{widened(support), widened(reach), bead_share(wetting), 0};
    // Of the energy along a skin only what lies outside the yarn acts on anything: half of it on a flat one.
    const double outside = std::clamp(1.0 - share_of_own_yarn(section, grid.length, result.reach), 0.5, 1.0);
    result.pull = static_cast<Real>(static_cast<double>(bead_attraction(wetting)) * scene.climate.surface_tension / outside *
                                    section.outline() / section.area());
    return result;
}

/// Those of one segment, along the yarn.
void put_beads(const Cloth& cloth, const TextileShape& t, const BeadGrid& grid, bool is_warp, int end, int pick, Quad* bead)
{
    const double pitch = is_warp ? cloth.weft_pitch : cloth.warp_pitch;
    const double x = (end - 0.5 * (cloth.ends - 1)) * cloth.warp_pitch, y = (pick - 0.5 * (cloth.picks - 1)) * cloth.weft_pitch;
    for (int k = 0; k < grid.along; ++k) {
        const double part = (k + 0.5) / grid.along - 0.5;
        const YarnPlace<Real> at = yarn_place(t, t.segment(is_warp, end, pick), AlongYarn<Real>(t, static_cast<Real>(part)));
        const CutSection section{static_cast<double>(at.half_height), static_cast<double>(at.half_width), grid.rows, grid.columns};
        const double slope = static_cast<double>(at.slope), cosine = 1.0 / std::sqrt(1.0 + slope * slope);
        const double volume = section.area() * pitch / (cosine * grid.per_segment());
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column) {
                const double up = section.up(row), side = static_cast<double>(at.side) + section.side(column);
                const double forth = part * pitch - up * slope * cosine;
                const double z = static_cast<double>(at.height) + up * cosine;
                *bead++ = {static_cast<Real>(x + (is_warp ? side : forth)), static_cast<Real>(y + (is_warp ? forth : side)),
                           static_cast<Real>(z), static_cast<Real>(volume)};
            }
    }
}

} // namespace

ClothShape::ClothShape(const Scene& scene) : numbers(numbers_of(scene)), shift(scene.cloth.shift)
{
    for (const ContactShape& shape : scene.cloth.shapes) shapes.push_back({Real(shape.half_height), Real(shape.half_width)});
    const ProfileTable table(scene, profiles);
    paths.reserve(2 * static_cast<std::size_t>(scene.cloth.segments()));
    if (shift.empty()) shift.assign(static_cast<std::size_t>(scene.cloth.segments()), 0.0f);
    for (int end = 0; end < scene.cloth.ends; ++end) add_paths(scene, shift, table, true, end, paths);
    for (int pick = 0; pick < scene.cloth.picks; ++pick) add_paths(scene, shift, table, false, pick, paths);
}

HostCloth::HostCloth(const Scene& scene) : cloth_(scene), shape_(cloth_.numbers)
{
    shape_.type = scene.cloth.type.data();
    shape_.parameters = scene.cloth.yarns.data();
    shape_.crossing = scene.cloth.crossing.data();
    shape_.shapes = cloth_.shapes.data();
    shape_.profiles = cloth_.profiles.data();
    shape_.paths = cloth_.paths.data();
    shape_.warp_up = scene.cloth.warp_up.data();
    shape_.shift = cloth_.shift.data();
}

HostBeads make_beads(const Scene& scene, double spacing, double support, double reach)
{
    const BeadGrid grid = bead_grid(scene.cloth, spacing);
    HostBeads result;
    result.view.per_segment = grid.per_segment();
    for (std::size_t k = 0; k < scene.cloth.shapes.size(); ++k) {
        result.types.push_back(bead_type(scene, k, grid, support, reach));
        result.view.widest = std::max(result.view.widest, result.types.back().reach);
    }
    const HostCloth cloth(scene);
    const TextileShape& t = cloth.shape();
    result.beads.resize(static_cast<std::size_t>(scene.cloth.segments()) * static_cast<std::size_t>(result.view.per_segment) + lanes);
    for (bool is_warp : {true, false})
        for (int end = 0; end < scene.cloth.ends; ++end)
            for (int pick = 0; pick < scene.cloth.picks; ++pick) {
                Quad* bead = result.beads.data() + std::int64_t{t.segment(is_warp, end, pick)} * result.view.per_segment;
                put_beads(scene.cloth, t, grid, is_warp, end, pick, bead);
            }
    for (const Quad& bead : result.beads) result.view.top = std::max(result.view.top, std::abs(bead.z));
    return result;
}

} // namespace hygroloom::inline HL_PRECISION
