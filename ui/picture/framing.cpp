// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/framing.h"

#include "core/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hygroloom {

namespace {

constexpr int edge_yarns = 10; ///< shown of an edge

struct Box {
    QVector3D low, high;

    bool holds(const QVector3D& point) const
    {
        for (int axis = 0; axis < 3; ++axis) {
            if (point[axis] < low[axis] || point[axis] > high[axis]) { return false; }
        }
        return true;
    }

    QVector3D clamped(QVector3D point) const
    {
        for (int axis = 0; axis < 3; ++axis) { point[axis] = std::clamp(point[axis], low[axis], std::max(low[axis], high[axis])); }
        return point;
    }
};

/// What a cut leaves of the fabric.
Box box_of(const PreviewFabric& fabric, const std::optional<CutPlane>& cut)
{
    Box box{fabric.low(), fabric.high()};
    if (!cut) { return box; }
    const std::array<double, 3> normal{cut->normal.x, cut->normal.y, cut->normal.z};
    const auto at = static_cast<float>(mm_from_metre(cut->offset));
    for (int axis = 0; axis < 3; ++axis) {
        if (normal[static_cast<std::size_t>(axis)] > 0.5) { box.high[axis] = std::min(box.high[axis], at); }
        if (normal[static_cast<std::size_t>(axis)] < -0.5) { box.low[axis] = std::max(box.low[axis], -at); }
    }
    return box;
}

/// Where a ray comes into the box from outside.
std::optional<QVector3D> entry(const Box& box, const Ray& ray)
{
    float first = 0, last = std::numeric_limits<float>::max();
    for (int axis = 0; axis < 3; ++axis) {
        const float from = ray.from[axis], along = ray.direction[axis];
        if (std::abs(along) < 1e-9F) {
            if (from < box.low[axis] || from > box.high[axis]) { return std::nullopt; }
            continue;
        }
        const float a = (box.low[axis] - from) / along, b = (box.high[axis] - from) / along;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return first < last ? std::optional(ray.from + first * ray.direction) : std::nullopt;
}

/// The point of the box that is nearest to the ray, by projecting from one onto the other and back.
QVector3D nearest(const Box& box, const Ray& ray)
{
    QVector3D point = 0.5F * (box.low + box.high);
    for (int turn = 0; turn < 64; ++turn) {
        const float along = std::max(0.0F, QVector3D::dotProduct(point - ray.from, ray.direction));
        point = box.clamped(ray.from + along * ray.direction);
    }
    return point;
}

int edge_axis(const QVector3D& towards) { return std::abs(towards.x()) > std::abs(towards.y()) ? 0 : 1; }

/// The few yarns in the middle of the edge that is looked at.
TextileRegion edge_of(const PreviewFabric& fabric, const QVector3D& towards)
{
    TextileRegion part = fabric.first_look();
    const auto few = [](int& first, int& count) {
        first += std::max(0, count - edge_yarns) / 2;
        count = std::min(count, edge_yarns);
    };
    few(part.first_end, part.ends);
    few(part.first_pick, part.picks);
    const bool far = towards[edge_axis(towards)] > 0;
    if (edge_axis(towards) == 0) {
        part.first_end = far ? fabric.textile.ends() - 1 : 0;
        part.ends = 1;
    } else {
        part.first_pick = far ? fabric.textile.picks() - 1 : 0;
        part.picks = 1;
    }
    return part;
}

} // namespace

Camera framed(Camera camera, const PreviewFabric& fabric, Framing framing, const QSizeF& size)
{
    camera.setReach(2.0 * (fabric.high() - fabric.low()).length());
    if (framing == Framing::as_it_is) { return camera; }
    if (camera.looksAlong()) {
        const TextileRegion part = edge_of(fabric, camera.direction());
        camera.fit(fabric.low(part), fabric.high(part), size);
    } else if (framing == Framing::few_repeats) {
        const TextileRegion part = fabric.first_look();
        camera.fit(fabric.low(part), fabric.high(part), size);
    } else {
        camera.fit(fabric.low(), fabric.high(), size);
    }
    return camera;
}

Camera looking_from(Camera camera, const PreviewFabric& fabric, double turn, double lift, const QSizeF& size)
{
    const Box box{fabric.low(), fabric.high()};
    const auto middle = entry(box, camera.ray({0.5 * size.width(), 0.5 * size.height()}, size));
    if (middle && !box.holds(camera.eye())) { camera.aimAt(*middle); }
    camera.lookFrom(turn, lift);
    const QVector3D towards = camera.direction();
    QVector3D target = box.clamped(camera.target());
    // On the side that is looked at: the eye is then outside, however near it is.
    const int side = camera.looksAlong() ? edge_axis(towards) : 2;
    target[side] = towards[side] > 0 ? box.high[side] : box.low[side];
    camera.centreOn(target);
    return camera;
}

Camera zoomed_to_cloth(Camera camera, const PreviewFabric& fabric, const std::optional<CutPlane>& cut, double factor, const QPointF& at,
                       const QSizeF& size)
{
    const Box box = box_of(fabric, cut);
    const Ray ray = camera.ray(at, size);
    const QVector3D from_low = entry(box, ray).value_or(nearest(box, ray)) - fabric.low();
    const Textile& textile = fabric.textile;
    const int end = std::clamp(static_cast<int>(from_low.x() / fabric.pitch().x()), 0, textile.ends() - 1);
    const int pick = std::clamp(static_cast<int>(from_low.y() / fabric.pitch().y()), 0, textile.picks() - 1);
    // Where two yarns cross there is cloth, right under the face that is seen.
    const QVector3D crossing(static_cast<float>(mm_from_metre(textile.x_of_end(end))),
                             static_cast<float>(mm_from_metre(textile.y_of_pick(pick))),
                             camera.direction().z() >= 0 ? box.high.z() : box.low.z());
    camera.zoomInSight(factor, box.clamped(crossing), size);
    return camera;
}

std::optional<double> millimetre_per_pixel(const Camera& camera, const PreviewFabric& fabric, const std::optional<CutPlane>& cut,
                                           const QSizeF& size)
{
    constexpr int samples = 12; // each way
    const Box box = box_of(fabric, cut);
    if (!camera.parallel() && box.holds(camera.eye())) { return std::nullopt; }
    double middle = 0, nearest = std::numeric_limits<double>::max(), least = nearest, most = 0;
    for (int row = 0; row <= samples; ++row) {
        for (int column = 0; column <= samples; ++column) {
            const QPointF at(size.width() * column / samples, size.height() * row / samples);
            const auto point = entry(box, camera.ray(at, size));
            if (!point) { continue; }
            const double depth = camera.depth(*point);
            const double away = std::hypot(at.x() - 0.5 * size.width(), at.y() - 0.5 * size.height());
            least = std::min(least, depth);
            most = std::max(most, depth);
            if (away < nearest) {
                nearest = away;
                middle = depth;
            }
        }
    }
    if (most <= 0 || middle <= 0 || most > scale_holds_within * middle || middle > scale_holds_within * least) { return std::nullopt; }
    return 1 / camera.pixelsPerMillimetre(middle, size);
}

} // namespace hygroloom
