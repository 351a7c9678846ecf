// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The garments that this program draws, on surfaces that unroll without stretch, so that lengths on the body are lengths of cloth. The
// trunk is a straight tube whose section has flat front and back and half circles at the sides; towards the shoulders front and back
// bend over a quarter of a cylinder until they meet. Arms and legs are cones. Shares of the girth are assumptions.
#include "core/base/units.h"
#include "core/garment/body.h"
#include "core/garment/fill.h"
#include "core/garment/outline.h"
#include "core/garment/readers.h"

#include <algorithm>

namespace hygroloom {

namespace {

/// A tube about the body's axis. Flat x = 0 is its front's or its back's middle, flat y its height over the bottom.
struct Trunk {
    double half_girth = 0; ///< m, of the tube; each of front and back
    double radius = 0;     ///< of its sides
    double bottom = 0;     ///< m over the floor
    double bend = 1e300;   ///< flat height from which it bends over the shoulders

    Vec3d place(const FlatPlace& flat, bool behind) const
    {
        const double side = behind ? -1 : 1, straight = 0.5 * half_girth - 0.5 * pi * radius;
        double across = std::abs(flat[0]), depth = radius;
        if (across > straight) {
            const double angle = (across - straight) / radius;
            across = straight + radius * std::sin(angle);
            depth = radius * std::cos(angle);
        }
        double height = flat[1];
        if (flat[1] > bend) {
            const double angle = (flat[1] - bend) / radius;
            height = bend + radius * std::sin(angle);
            depth = radius * std::cos(angle);
        }
        return {side * std::copysign(across, flat[0]), bottom + height, side * depth};
    }
};

/// A cone that gets narrower downwards. Flat (0, 0) is its tip; flat y runs from there along the middle of the panel.
struct Limb {
    double wide = 0, narrow = 0, length = 0; ///< m: girths, and the distance between them along the cloth
    Vec3d begin{}, along{}, middle{};        ///< the wide end's middle; unit vectors: down the limb, towards the panel's middle

    double from_tip() const { return length * wide / (wide - narrow); } ///< of the wide end
    double angle() const { return wide / from_tip(); }                  ///< of the flat panel
    FlatPlace flat(double down, double share) const
    {
        const double r = from_tip() - down, a = angle() * (share - 0.5);
        return {r * std::sin(a), r * std::cos(a)};
    }
    Vec3d place(const FlatPlace& flat) const
    {
        const double r = std::hypot(flat[0], flat[1]), slope = angle() / (2 * pi); // radius of the cone over the way from its tip
        const double turn = std::atan2(flat[0], flat[1]) / slope, down = (from_tip() - r) * std::sqrt(1 - slope * slope);
        const Vec3d right = cross(-along, middle);
        return begin + down * along + (r * slope * std::cos(turn)) * middle + (r * slope * std::sin(turn)) * right;
    }
};

class Drawing {
public:
    int add(const std::string& name, std::vector<PanelEdge> edges, std::function<Vec3d(const FlatPlace&)> surface)
    {
        PatternPanel panel;
        panel.name = name;
        panel.edges = std::move(edges);
        const FlatPlace middle = middle_of(panel);
        constexpr double small = 1e-4; // m: the panel stands as its middle does on the body
        const Vec3d at = surface(middle);
        const Vec3d x = (1 / small) * (surface({middle[0] + small, middle[1]}) - at),
                    y = (1 / small) * (surface({middle[0], middle[1] + small}) - at);
        panel.placed = {at - middle[0] * x - middle[1] * y, x, y};
        pattern_.panels.push_back(std::move(panel));
        surfaces_.push_back(std::move(surface));
        return static_cast<int>(pattern_.panels.size()) - 1;
    }
    void sew(int panel, int edge, int other, int other_edge) { pattern_.seams.push_back({panel, edge, other, other_edge, true}); }
    GarmentPattern finish() &&
    {
        make_shape(pattern_, [this](int panel, const FlatPlace& flat) { return surfaces_[panel](flat); });
        pattern_.is_draped = true;
        pattern_.uv_scale = 1e-3; // flat coordinates are millimetres of cloth
        find_body(pattern_);
        return std::move(pattern_);
    }

private:
    static FlatPlace middle_of(const PatternPanel& panel)
    {
        FlatPlace least{1e300, 1e300}, most{-1e300, -1e300};
        for (const FlatPlace& place : outline_of(panel))
            for (std::size_t axis = 0; axis < 2; ++axis) {
                least[axis] = std::min(least[axis], place[axis]);
                most[axis] = std::max(most[axis], place[axis]);
            }
        return {0.5 * (least[0] + most[0]), 0.5 * (least[1] + most[1])};
    }
    GarmentPattern pattern_;
    std::vector<std::function<Vec3d(const FlatPlace&)>> surfaces_;
};

PanelEdge straight(const FlatPlace& from, const FlatPlace& to) { return {{from, to}}; }

/// A part of an ellipse with its axes along x and y, between two angles.
PanelEdge ellipse(const FlatPlace& middle, double wide, double high, double from, double to)
{
    return {flattened([=](double t) {
        const double a = from + t * (to - from);
        return FlatPlace{middle[0] + wide * std::cos(a), middle[1] + high * std::sin(a)};
    })};
}

PanelEdge joined(PanelEdge one, const PanelEdge& other)
{
    one.places.insert(one.places.end(), other.places.begin() + 1, other.places.end());
    return one;
}

/// Sizes of a front or a back, m.
struct Bodice {
    double half = 0, length = 0;                    ///< width below the armholes, height
    double shoulders = 0, armhole = 0;              ///< width over the shoulders, depth of the armhole
    double round = 0;                               ///< height of the armhole's round bottom
    double neck = 0, front_neck = 0, back_neck = 0; ///< half width, depths
};

enum BodiceEdge { hem, left_side, left_armhole, left_shoulder, neckline, right_shoulder, right_armhole, right_side };

/// left: on the panel's right as seen from outside, which is the wearer's left of a front, and right of a back.
std::vector<PanelEdge> bodice_edges(const Bodice& size, double neck_depth)
{
    const double w = 0.5 * size.half, s = 0.5 * size.shoulders, under = size.length - size.armhole, l = size.length;
    const PanelEdge arm =
        joined(ellipse({w, under + size.round}, w - s, size.round, 1.5 * pi, pi), straight({s, under + size.round}, {s, l}));
    PanelEdge other;
    for (auto place = arm.places.rbegin(); place != arm.places.rend(); ++place) other.places.push_back({-(*place)[0], (*place)[1]});
    std::vector<PanelEdge> edges{straight({-w, 0}, {w, 0}),
                                 straight({w, 0}, {w, under}),
                                 arm,
                                 straight({s, l}, {size.neck, l}),
                                 ellipse({0, l}, size.neck, neck_depth, 0, -pi),
                                 straight({-size.neck, l}, {-s, l}),
                                 other,
                                 straight({-w, under}, {-w, 0})};
    for (std::size_t i = 0; i < edges.size(); ++i) // the very same corners
        edges[i].places.back() = edges[(i + 1) % edges.size()].places.front();
    return edges;
}

/// The cone's panel: half of the wide end, the other half, one straight side, the narrow end, the other side.
enum LimbEdge { wide_right, wide_left, side_left, narrow_end, side_right };

std::vector<PanelEdge> limb_edges(const Limb& limb)
{
    const auto arc = [&limb](double down, double from, double to) {
        return PanelEdge{flattened([=, &limb](double t) { return limb.flat(down, from + t * (to - from)); })};
    };
    return {arc(0, 1, 0.5), arc(0, 0.5, 0), straight(limb.flat(0, 0), limb.flat(limb.length, 0)), arc(limb.length, 0, 1),
            straight(limb.flat(limb.length, 1), limb.flat(0, 1))};
}

Bodice bodice_of(const BuiltInGarment& garment)
{
    const double chest = metre_from_mm(garment.chest_mm);
    const bool tee = garment.kind == "tee";
    Bodice size;
    size.half = 0.5 * (chest + metre_from_mm(garment.ease_mm));
    size.length = metre_from_mm(garment.length_mm);
    size.shoulders = (tee ? 0.36 : 0.28) * chest;
    size.armhole = std::min((tee ? 0.20 : 0.23) * chest, 0.6 * size.length);
    size.round = 0.25 * size.armhole;
    size.neck = 0.09 * chest;
    size.front_neck = std::min((tee ? 0.09 : 0.14) * chest, 0.5 * size.length);
    size.back_neck = std::min((tee ? 0.02 : 0.06) * chest, 0.3 * size.length);
    return size;
}

Trunk trunk_of(const Bodice& size, double chest)
{
    Trunk trunk;
    trunk.half_girth = size.half;
    // As deep as the girth lets it be beside shoulders of the body's width, and so that the bend ends over the armholes' round bottoms.
    trunk.radius = std::min((size.half - 0.36 * chest) / pi, 0.95 * (size.armhole - size.round) / (0.5 * pi));
    trunk.bend = size.length - 0.5 * pi * trunk.radius;
    trunk.bottom = body::shoulder - trunk.bend - trunk.radius;
    return trunk;
}

void add_sleeve(Drawing& drawing, const Bodice& size, const Trunk& trunk, const std::vector<PanelEdge>& front, double length, bool left,
                int f, int b)
{
    const double slope = std::sqrt(0.5), side = left ? 1 : -1; // arms hang away from the trunk by 45 degrees
    Limb arm;
    arm.wide = 2 * length_of(front[left_armhole]);
    arm.narrow = 0.85 * arm.wide;
    arm.length = length;
    arm.along = {side * slope, -slope, 0};
    arm.middle = {side * slope, slope, 0};
    const double radius = arm.wide / (2 * pi);
    arm.begin = Vec3d{side * 0.5 * size.shoulders, trunk.bottom + trunk.bend + trunk.radius, 0} - radius * arm.middle;
    const int sleeve =
        drawing.add(left ? "left sleeve" : "right sleeve", limb_edges(arm), [arm](const FlatPlace& flat) { return arm.place(flat); });
    // Seen from outside, a left sleeve has the back on its right, a right one the front.
    drawing.sew(f, left ? left_armhole : right_armhole, sleeve, left ? wide_left : wide_right);
    drawing.sew(b, left ? right_armhole : left_armhole, sleeve, left ? wide_right : wide_left);
    drawing.sew(sleeve, side_left, sleeve, side_right);
}

GarmentPattern bodice(const BuiltInGarment& garment)
{
    const Bodice size = bodice_of(garment);
    const Trunk trunk = trunk_of(size, metre_from_mm(garment.chest_mm));
    Drawing drawing;
    const std::vector<PanelEdge> front = bodice_edges(size, size.front_neck);
    const int f = drawing.add("front", front, [trunk](const FlatPlace& flat) { return trunk.place(flat, false); });
    const int b =
        drawing.add("back", bodice_edges(size, size.back_neck), [trunk](const FlatPlace& flat) { return trunk.place(flat, true); });
    drawing.sew(f, left_side, b, right_side);
    drawing.sew(f, right_side, b, left_side);
    drawing.sew(f, left_shoulder, b, right_shoulder);
    drawing.sew(f, right_shoulder, b, left_shoulder);
    if (garment.kind == "tee")
        for (const bool left : {true, false}) add_sleeve(drawing, size, trunk, front, metre_from_mm(garment.sleeve_mm), left, f, b);
    return std::move(drawing).finish();
}

enum HipEdge { hip_right, hip_left, hip_left_side, hip_waist, hip_right_side };

GarmentPattern leggings(const BuiltInGarment& garment)
{
    const double hip = metre_from_mm(garment.chest_mm), girth = hip + metre_from_mm(garment.ease_mm);
    const double rise = body::waist - body::crotch, w = 0.25 * girth;
    Trunk trunk;
    trunk.half_girth = 0.5 * girth;
    trunk.radius = 0.1 * girth;
    trunk.bottom = body::crotch;
    // From the front's right half round: its lower edge has two halves, one for each leg.
    const std::vector<PanelEdge> edges{straight({-w, 0}, {0, 0}), straight({0, 0}, {w, 0}), straight({w, 0}, {w, rise}),
                                       straight({w, rise}, {-w, rise}), straight({-w, rise}, {-w, 0})};
    Drawing drawing;
    const int f = drawing.add("front", edges, [trunk](const FlatPlace& flat) { return trunk.place(flat, false); });
    const int b = drawing.add("back", edges, [trunk](const FlatPlace& flat) { return trunk.place(flat, true); });
    drawing.sew(f, hip_left_side, b, hip_right_side);
    drawing.sew(f, hip_right_side, b, hip_left_side);
    for (const bool left : {true, false}) {
        Limb limb;
        limb.wide = 0.5 * girth;
        limb.narrow = 0.24 * hip;
        limb.length = metre_from_mm(garment.length_mm) - rise;
        limb.along = {0, -1, 0};
        limb.middle = {left ? 1.0 : -1.0, 0, 0};
        limb.begin = {left ? limb.wide / (2 * pi) : -limb.wide / (2 * pi), body::crotch, 0};
        const int leg =
            drawing.add(left ? "left leg" : "right leg", limb_edges(limb), [limb](const FlatPlace& flat) { return limb.place(flat); });
        // Seen from outside, a left leg has the back on its right, a right one the front.
        drawing.sew(f, left ? hip_left : hip_right, leg, left ? wide_left : wide_right);
        drawing.sew(b, left ? hip_right : hip_left, leg, left ? wide_right : wide_left);
        drawing.sew(leg, side_left, leg, side_right);
    }
    return std::move(drawing).finish();
}

} // namespace

GarmentPattern built_in_pattern(const BuiltInGarment& garment) { return garment.kind == "leggings" ? leggings(garment) : bodice(garment); }

} // namespace hygroloom
