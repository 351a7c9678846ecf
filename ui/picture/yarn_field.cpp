// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Shade follows Evans, "Fast approximations for global illumination on dynamic scenes" (2006): a few steps along the normal,
// each of which should be as far from all skins as it is long.
#include "ui/picture/yarn_field.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr int samples = 8; // slices per crossing
constexpr double nothing_near = 1;

struct Axes {
    double pitch;       // from yarn to yarn
    double step;        // from crossing to crossing along the yarn
    double first_yarn;  // coordinate of yarn 0
    double first_along; // coordinate of crossing 0
    int yarns;
    int crossings;
};

Axes axes_of(const Textile& textile, YarnKind kind)
{
    const double x = textile.x_of_end(0), y = textile.y_of_pick(0);
    const double dx = textile.x_of_end(1) - x, dy = textile.y_of_pick(1) - y;
    return kind == YarnKind::warp ? Axes{dx, dy, x, y, textile.ends(), textile.picks()}
                                  : Axes{dy, dx, y, x, textile.picks(), textile.ends()};
}

YarnSlice slice_of(const Textile& textile, YarnKind kind, int yarn, int at, double offset)
{
    const YarnPoint p = yarn_point(textile, kind, yarn, at, offset);
    const double along = kind == YarnKind::warp ? p.tangent.y : p.tangent.x;
    return {static_cast<float>(kind == YarnKind::warp ? p.centre.x : p.centre.y), static_cast<float>(p.centre.z),
            static_cast<float>(p.half_width), static_cast<float>(p.half_height), static_cast<float>(along > 0 ? p.tangent.z / along : 0)};
}

double distance_to(const YarnSlice& slice, double across, double height)
{
    const double flat = std::max(0.0F, slice.half_width - slice.half_height);
    const double side = std::max(std::abs(across - slice.across) - flat, 0.0);
    // A leaning yarn is nearer than straight up.
    const double lean = 1 / std::sqrt(1.0 + slice.slope * slice.slope);
    const double up = (height - slice.height) * lean;
    return std::sqrt(side * side + up * up) - slice.half_height;
}

/// Of yarns whose slices a function gives, the nearest to a point.
template <typename SliceAt> double nearest(const Textile& textile, const Vec3d& point, const SliceAt& slice_at, YarnPlace* place)
{
    double best = nothing_near;
    for (const YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        const Axes axes = axes_of(textile, kind);
        const double across = kind == YarnKind::warp ? point.x : point.y;
        const double along = ((kind == YarnKind::warp ? point.y : point.x) - axes.first_along) / axes.step;
        if (along < -0.5 || along > axes.crossings - 0.5) { continue; }
        const int middle = static_cast<int>(std::lround((across - axes.first_yarn) / axes.pitch));
        for (int yarn = std::max(0, middle - 1); yarn <= std::min(axes.yarns - 1, middle + 1); ++yarn) {
            const double d = distance_to(slice_at(kind, yarn, along), across, point.z);
            if (d < best) {
                best = d;
                if (place) {
                    const int at = std::clamp(static_cast<int>(std::lround(along)), 0, axes.crossings - 1);
                    *place = {kind, yarn, at, std::clamp(along - at, -0.5, 0.5)};
                }
            }
        }
    }
    return best;
}

} // namespace

YarnField::YarnField(const Textile& textile, const TextileRegion& region) : textile_(textile)
{
    constexpr int margin = 2;
    first_end_ = std::max(0, region.first_end - margin);
    first_pick_ = std::max(0, region.first_pick - margin);
    ends_ = std::min(textile.ends(), region.first_end + region.ends + margin) - first_end_;
    picks_ = std::min(textile.picks(), region.first_pick + region.picks + margin) - first_pick_;
    for (const YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        auto& slices = slices_[kind == YarnKind::warp ? 0 : 1];
        const int along = count(kind == YarnKind::warp ? YarnKind::weft : YarnKind::warp);
        const int start = first(kind == YarnKind::warp ? YarnKind::weft : YarnKind::warp);
        slices.reserve(static_cast<std::size_t>(count(kind) * (along * samples + 1)));
        for (int yarn = first(kind); yarn < first(kind) + count(kind); ++yarn) {
            for (int i = 0; i <= along * samples; ++i) {
                const int at = std::min(i / samples, along - 1);
                slices.push_back(slice_of(textile, kind, yarn, start + at, static_cast<double>(i) / samples - at - 0.5));
            }
        }
    }
}

YarnSlice YarnField::slice(YarnKind kind, int yarn, double along) const
{
    const YarnKind other = kind == YarnKind::warp ? YarnKind::weft : YarnKind::warp;
    const int row = std::clamp(yarn - first(kind), 0, count(kind) - 1);
    const int last = count(other) * samples;
    const double position = std::clamp((along - first(other) + 0.5) * samples, 0.0, static_cast<double>(last));
    const int low = std::min(static_cast<int>(position), last - 1);
    const auto share = static_cast<float>(position - low);
    const YarnSlice* at = &slices_[kind == YarnKind::warp ? 0 : 1][static_cast<std::size_t>(row * (last + 1) + low)];
    const auto mix = [share](float a, float b) { return a + share * (b - a); };
    return {mix(at[0].across, at[1].across), mix(at[0].height, at[1].height), mix(at[0].half_width, at[1].half_width),
            mix(at[0].half_height, at[1].half_height), mix(at[0].slope, at[1].slope)};
}

double YarnField::distance(const Vec3d& point) const
{
    return nearest(
        textile_, point, [this](YarnKind kind, int yarn, double along) { return slice(kind, yarn, along); }, nullptr);
}

double YarnField::openness(const Vec3d& point, const Vec3d& normal) const
{
    constexpr double steps[] = {0.1, 0.22, 0.45, 0.85}; // of half the fabric's thickness
    constexpr double weights[] = {0.25, 0.3, 0.25, 0.2};
    double hidden = 0;
    for (int i = 0; i < 4; ++i) {
        const double step = steps[i] * textile_.half_thickness();
        hidden += weights[i] * std::clamp((step - distance(point + step * normal)) / step, 0.0, 1.0);
    }
    return 1 - hidden;
}

// A root is near what white yarns send each other over many reflections (Jimenez et al. 2016 for a reflectance of 0.75: of an openness of
// 0.3 stays 0.59, of 0.6 0.85); what they show of light through yarns is an assumption.
double shade_of(double openness) { return 0.45 + 0.55 * std::sqrt(openness); }

std::optional<YarnHit> first_skin(const Textile& textile, const Vec3d& from, const Vec3d& direction, const std::optional<CutPlane>& cut)
{
    const double half = 1.02 * textile.half_thickness();
    const Axes x = axes_of(textile, YarnKind::warp), y = axes_of(textile, YarnKind::weft);
    double start = 0, end = 1e9;
    const auto between = [&](double position, double slope, double low, double high) {
        if (std::abs(slope) < 1e-12) {
            end = position < low || position > high ? -1 : end;
            return;
        }
        const double a = (low - position) / slope, b = (high - position) / slope;
        start = std::max(start, std::min(a, b));
        end = std::min(end, std::max(a, b));
    };
    between(from.x, direction.x, x.first_yarn - 0.5 * x.pitch, x.first_yarn + (x.yarns - 0.5) * x.pitch);
    between(from.y, direction.y, y.first_yarn - 0.5 * y.pitch, y.first_yarn + (y.yarns - 0.5) * y.pitch);
    between(from.z, direction.z, -half, half);
    if (cut) { between(dot(cut->normal, from), dot(cut->normal, direction), -1e9, cut->offset); }
    const auto slice_at = [&textile](YarnKind kind, int yarn, double along) {
        const Axes axes = axes_of(textile, kind);
        const int at = std::clamp(static_cast<int>(std::lround(along)), 0, axes.crossings - 1);
        return slice_of(textile, kind, yarn, at, std::clamp(along - at, -0.5, 0.5));
    };
    double along = start;
    for (int step = 0; step < 4000 && along <= end; ++step) {
        YarnHit hit;
        hit.point = from + along * direction;
        const double d = nearest(textile, hit.point, slice_at, &hit.place);
        if (d < 0.002 * half) { return hit; }
        along += std::min(0.8 * d, 0.5 * half); // the yarns lean and other yarns come near: less than the whole way
    }
    return std::nullopt;
}

Vec3d axis_point(const Textile& textile, const YarnPlace& place)
{
    return yarn_point(textile, place.kind, place.yarn, place.at, place.offset).centre;
}

} // namespace hygroloom
