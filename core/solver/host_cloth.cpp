// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/solver/host_cloth.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hygroloom::inline HL_PRECISION {
namespace {

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

/// As stages see it; the scene and the shape must outlive it.
TextileShape shape_on_host(const Scene& scene, const ClothShape& cloth)
{
    TextileShape t = cloth.numbers;
    t.type = scene.cloth.type.data();
    t.parameters = scene.cloth.yarns.data();
    t.crossing = scene.cloth.crossing.data();
    t.shapes = cloth.shapes.data();
    t.profiles = cloth.profiles.data();
    t.paths = cloth.paths.data();
    t.warp_up = scene.cloth.warp_up.data();
    t.shift = cloth.shift.data();
    return t;
}

/// Height of the highest place on any yarn over the middle plane, or of the lowest under it.
Real highest_place(const ClothShape& cloth)
{
    Real highest = 0;
    for (const Quad& sample : cloth.profiles) highest = std::max(highest, std::abs(sample.x) + sample.z); // see TextileShape::profiles
    return highest;
}

/// A part of the cloth, m.
struct Patch {
    double x0, x1, y0, y1;
};

/// Where drops may spread when they fall, and where liquid is from the start.
std::vector<Patch> patches_under_liquid(const Scene& scene)
{
    constexpr double radii = 6, beyond = 2e-3; // m; changes what is kept in memory, not what particles meet
    std::vector<Patch> patches;
    for (const SceneDroplet& drop : scene.supply.droplets) {
        const double far = radii * std::cbrt(drop.volume * 3.0 / (4.0 * pi)) + beyond;
        patches.push_back({drop.centre.x - far, drop.centre.x + far, drop.centre.y - far, drop.centre.y + far});
    }
    if (scene.liquid.places.empty()) return patches;
    Patch standing{1, -1, 1, -1};
    for (const Vec3d& place : scene.liquid.places) {
        standing = {std::min(standing.x0, place.x - beyond), std::max(standing.x1, place.x + beyond),
                    std::min(standing.y0, place.y - beyond), std::max(standing.y1, place.y + beyond)};
    }
    patches.push_back(standing);
    return patches;
}

/// The tiles that yarns with places between from and to belong to; behind the last of them.
std::pair<int, int> tiles_between(double from, double to, double pitch, int yarns)
{
    const auto tile_at = [&](double place) {
        return static_cast<int>(std::clamp(place / pitch + 0.5 * (yarns - 1), 0.0, double(yarns - 1))) / Beads::tile;
    };
    return {tile_at(from), tile_at(to) + 1};
}

/// Gives the tiles under liquid places in memory, one after the other, as many as there is room for; returns how many beads there are.
int place_tiles(const Scene& scene, const Beads& beads, std::vector<int>& first)
{
    constexpr std::int64_t most_beads = 10'000'000; // 160 MB
    const Cloth& cloth = scene.cloth;
    const int across = Beads::tiles(cloth.picks);
    first.assign(static_cast<std::size_t>(Beads::tiles(cloth.ends) * across), -1);
    std::int64_t count = 0;
    for (const Patch& patch : patches_under_liquid(scene)) {
        const auto [left, right] = tiles_between(patch.x0, patch.x1, cloth.warp_pitch, cloth.ends);
        const auto [low, high] = tiles_between(patch.y0, patch.y1, cloth.weft_pitch, cloth.picks);
        for (int u = left; u < right; ++u)
            for (int v = low; v < high; ++v) {
                int& of_tile = first[static_cast<std::size_t>(u * across + v)];
                const std::int64_t wanted =
                    std::int64_t{2} * Beads::yarns_in(u, cloth.ends) * Beads::yarns_in(v, cloth.picks) * beads.grid.per_segment();
                if (of_tile >= 0 || count + wanted > most_beads) continue;
                of_tile = static_cast<int>(count);
                count += wanted;
            }
    }
    return static_cast<int>(count);
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

HostCloth::HostCloth(const Scene& scene) : cloth_(scene), shape_(shape_on_host(scene, cloth_)) {}

HostBeads make_beads(const Scene& scene, const ClothShape& shape, double spacing, double support, double reach)
{
    HostBeads result;
    Beads& view = result.view;
    view.grid = bead_grid(scene.cloth, spacing);
    view.warp_pitch = scene.cloth.warp_pitch;
    view.weft_pitch = scene.cloth.weft_pitch;
    view.top = highest_place(shape);
    for (std::size_t k = 0; k < scene.cloth.shapes.size(); ++k) {
        result.types.push_back(bead_type(scene, k, view.grid, support, reach));
        view.widest = std::max(view.widest, result.types.back().reach);
    }
    result.beads.resize(static_cast<std::size_t>(place_tiles(scene, view, result.first)) + lanes);
    const TextileShape t = shape_on_host(scene, shape);
    const int per_segment = view.grid.per_segment(), across = Beads::tiles(scene.cloth.picks);
    for (std::size_t tile = 0; tile < result.first.size(); ++tile) {
        if (result.first[tile] < 0) continue;
        const int end0 = static_cast<int>(tile) / across * Beads::tile, pick0 = static_cast<int>(tile) % across * Beads::tile;
        for (bool is_warp : {true, false})
            for (int end = end0; end < std::min(end0 + Beads::tile, t.ends); ++end)
                for (int pick = pick0; pick < std::min(pick0 + Beads::tile, t.picks); ++pick) {
                    Quad* bead = result.beads.data() + result.first[tile] + view.place(t, is_warp, end, pick);
                    for (int k = 0; k < per_segment; ++k) bead[k] = view.cut(t, is_warp, end, pick, k);
                }
    }
    return result;
}

} // namespace hygroloom::inline HL_PRECISION
