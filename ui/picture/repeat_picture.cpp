// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/repeat_picture.h"

#include "core/base/units.h"
#include "ui/picture/cloth_light.h"
#include "ui/picture/yarn_field.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace hygroloom {

namespace {

constexpr unsigned most_texels = 1024; // each way
constexpr unsigned texels_per_crossing = 16;
constexpr int rays_per_look = 128;
constexpr double steepest = 0.97; // from the side: x and y of a direction are not farther out

double reach_of(const YarnField& field, const Vec3d& point, const Vec3d& normal, int side)
{
    return shade_of(field.openness(point, normal)) * cloth_light::light_at_depth(side * point.z / field.textile().half_thickness());
}

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

/// The repeat whose picture is made, endlessly repeated.
struct Repeated {
    const YarnField& field;
    double x, y;                ///< m, of its corner
    double width, height;       ///< m
    double half_thickness;      ///< m
    std::array<float, 2> wound; ///< see RepeatPicture

    Vec3d folded(const Vec3d& point) const
    {
        return {point.x - width * std::floor((point.x - x) / width), point.y - height * std::floor((point.y - y) / height), point.z};
    }
};

/// A skin, and how far away it is.
struct Skin {
    double away = 1; ///< m
    YarnKind kind = YarnKind::warp;
    Vec3d normal;
};

/// Unlike YarnField::distance() it measures across the yarn where that bends, as tubes have their sections.
Skin skin_of(const YarnField& field, YarnKind kind, int yarn, const Vec3d& point)
{
    const Textile& textile = field.textile();
    const bool is_warp = kind == YarnKind::warp;
    const double first = is_warp ? textile.y_of_pick(0) : textile.x_of_end(0);
    const double step = (is_warp ? textile.y_of_pick(1) : textile.x_of_end(1)) - first;
    const double from_first = (is_warp ? point.y : point.x) - first;
    double along = from_first;
    YarnSlice at = field.slice(kind, yarn, along / step);
    for (int round = 0; round < 3; ++round) {
        const double ahead = (from_first - along + (point.z - at.height) * at.slope) / (1.0 + at.slope * at.slope);
        along += std::clamp(ahead, -0.3 * step, 0.3 * step);
        at = field.slice(kind, yarn, along / step);
    }
    const double lean = 1 / std::sqrt(1.0 + at.slope * at.slope), off = (is_warp ? point.x : point.y) - at.across;
    const double side = std::copysign(std::max(std::abs(off) - std::max(0.0F, at.half_width - at.half_height), 0.0), off);
    const double up = (point.z - at.height - (from_first - along) * at.slope) * lean;
    const double middle = std::max(std::hypot(side, up), 1e-30), forwards = -up * at.slope * lean;
    return {middle - at.half_height, kind, (1 / middle) * (is_warp ? Vec3d{side, forwards, up * lean} : Vec3d{forwards, side, up * lean})};
}

Skin nearest_skin(const YarnField& field, const Vec3d& point)
{
    const Textile& textile = field.textile();
    Skin nearest;
    for (const YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        const bool is_warp = kind == YarnKind::warp;
        const double first = is_warp ? textile.x_of_end(0) : textile.y_of_pick(0);
        const double pitch = (is_warp ? textile.x_of_end(1) : textile.y_of_pick(1)) - first;
        const int middle = static_cast<int>(std::lround(((is_warp ? point.x : point.y) - first) / pitch));
        const int last = (is_warp ? textile.ends() : textile.picks()) - 1;
        for (int yarn = std::max(0, middle - 1); yarn <= std::min(last, middle + 1); ++yarn) {
            if (const Skin skin = skin_of(field, kind, yarn, point); skin.away < nearest.away) { nearest = skin; }
        }
    }
    return nearest;
}

/// Where a line of sight from outside meets a skin, if it meets one.
std::optional<Seen> first_seen(const Repeated& cloth, Vec3d point, const Vec3d& along)
{
    for (int step = 0; step < 100 && std::abs(point.z) <= 1.02 * cloth.half_thickness; ++step) {
        const Vec3d here = cloth.folded(point);
        const Skin skin = nearest_skin(cloth.field, here);
        if (skin.away < 0.01 * cloth.half_thickness) { return Seen{skin.kind, here, skin.normal}; }
        point = point + std::min(0.8 * skin.away, 0.5 * cloth.half_thickness) * along;
    }
    return std::nullopt;
}

/// towards: unit, to the eye.
void look_from(const Repeated& cloth, const Vec3d& towards, MeanLook& look, MeanShine& shine)
{
    const int side = towards.z > 0 ? 1 : -1;
    const Vec3d lamp = cloth_light::lamp_from(towards, side);
    for (int ray = 0; ray < rays_per_look; ++ray) {
        // An even spread: multiples of the powers of 1 / 1.3247..., whose cube is itself and one.
        const double u = ray * 0.7548776662466927 + 0.5, v = ray * 0.5698402909980532 + 0.5;
        const Vec3d from{cloth.x + cloth.width * (u - std::floor(u)), cloth.y + cloth.height * (v - std::floor(v)),
                         1.01 * side * cloth.half_thickness};
        const auto seen = first_seen(cloth, from, -1.0 * towards);
        if (!seen) { continue; }
        const double reach = reach_of(cloth.field, seen->point, seen->normal, side) / rays_per_look;
        const bool is_warp = seen->kind == YarnKind::warp;
        const Vec3d fibres = cloth_light::fibre_direction(seen->normal, is_warp ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0},
                                                          static_cast<double>(cloth.wound[is_warp ? 0 : 1]));
        (is_warp ? look.warp : look.weft) += static_cast<float>(reach * cloth_light::matt_light(seen->normal, fibres, lamp, towards, side));
        shine.fibres += static_cast<float>(reach * cloth_light::fibre_shine(seen->normal, fibres, lamp, towards));
        shine.film += static_cast<float>(reach * cloth_light::film_shine(seen->normal, lamp, towards, side));
        look.covered += 1.0F / rays_per_look;
    }
}

void add_looks(RepeatPicture& picture, const Repeated& cloth)
{
    constexpr int n = RepeatPicture::looks_each_way;
    for (int node = 0; node < 2 * n * n; ++node) {
        double x = 2.0 * (node % n) / (n - 1) - 1, y = 2.0 * (node / n % n) / (n - 1) - 1;
        if (const double out = std::hypot(x, y); out > steepest) {
            x *= steepest / out;
            y *= steepest / out;
        }
        const double z = std::sqrt(1 - x * x - y * y);
        const auto at = static_cast<std::size_t>(node);
        look_from(cloth, {x, y, node < n * n ? z : -z}, picture.looks.seen[at], picture.looks.shine[at]);
    }
}

} // namespace

double perimeter_of(const Textile& textile, YarnKind kind)
{
    const YarnPoint point = yarn_point(textile, kind, 0, 0, 0);
    return pi * (point.half_width + point.half_height);
}

RepeatPicture picture_of_repeat(const PreviewFabric& fabric)
{
    const Textile& textile = fabric.textile;
    RepeatPicture picture;
    picture.ends = std::min(fabric.period_ends, textile.ends());
    picture.picks = std::min(fabric.period_picks, textile.picks());
    const auto texels_for = [](int crossings) {
        return static_cast<int>(std::min(most_texels, std::bit_ceil(texels_per_crossing * static_cast<unsigned>(crossings))));
    };
    const auto wound = [&](const Yarn& yarn, YarnKind kind) {
        return static_cast<float>(yarn.twist_per_m * (yarn.twist_direction == TwistDirection::z ? 1 : -1) * perimeter_of(textile, kind));
    };
    picture.wound = {wound(*fabric.end_yarns.front(), YarnKind::warp), wound(*fabric.pick_yarns.front(), YarnKind::weft)};
    picture.width = texels_for(picture.ends);
    picture.height = texels_for(picture.picks);
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
                const double open = reach_of(field, seen->point, seen->normal, side);
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
    add_looks(picture, {field, x0, y0, dx * picture.width, dy * picture.height, textile.half_thickness(), picture.wound});
    return picture;
}

} // namespace hygroloom
