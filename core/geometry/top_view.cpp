// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/geometry/top_view.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

/// Of a yarn's path, in the order of its crossings.
YarnPoint along(const Textile& textile, YarnKind kind, int yarn, int crossings, double share)
{
    const double place = share * crossings;
    const int at = std::clamp(static_cast<int>(place), 0, crossings - 1);
    return yarn_point(textile, kind, yarn, at, place - at - 0.5);
}

} // namespace

TopView::TopView(const Textile& textile, int columns, int rows)
    : textile_(textile), columns_(columns), rows_(rows), width_(textile.ends() * textile.warp.pitch),
      height_(textile.picks() * textile.weft.pitch)
{
    for (int end = -1; end <= textile.ends(); ++end)
        for (int row = 0; row < rows; ++row) warp_.push_back(along(textile, YarnKind::warp, end, textile.picks(), 1 - (row + 0.5) / rows));
    for (int pick = -1; pick <= textile.picks(); ++pick)
        for (int column = 0; column < columns; ++column)
            weft_.push_back(along(textile, YarnKind::weft, pick, textile.ends(), (column + 0.5) / columns));
}

/// Takes the yarn where it lies over what was seen before. The section is two half ellipses with a flat between them, as section_point()
/// has it; across a slope it is cut upright.
void TopView::look(TopPoint& seen, YarnKind kind, int yarn, const YarnPoint& tube, double x, double y) const
{
    const bool is_warp = kind == YarnKind::warp;
    const double across = is_warp ? x - tube.centre.x : y - tube.centre.y;
    if (std::abs(across) >= tube.half_width) return;
    const double flat = std::max(0.0, tube.half_width - tube.half_height);
    const double sine = std::copysign(std::max(0.0, std::abs(across) - flat) / (tube.half_width - flat), across);
    const double cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
    const Vec3d& t = tube.tangent;
    const double height = tube.centre.z + tube.half_height * cosine / (is_warp ? t.y : t.x);
    if (!seen.open && height <= seen.height) return;
    const Vec3d aside = is_warp ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d beside = aside - dot(aside, t) * t;
    Vec3d up = is_warp ? cross(beside, t) : cross(t, beside);
    up = (1 / length(up)) * up;
    const Vec3d normal = (sine / length(beside)) * beside + cosine * up;
    seen = {false, kind, yarn, height, (1 / length(normal)) * normal};
}

TopPoint TopView::at(int column, int row) const
{
    const double across = (column + 0.5) / columns_, upwards = 1 - (row + 0.5) / rows_;
    const double x = (across - 0.5) * width_, y = (upwards - 0.5) * height_;
    const int end = std::min(static_cast<int>(across * textile_.ends()), textile_.ends() - 1),
              pick = std::min(static_cast<int>(upwards * textile_.picks()), textile_.picks() - 1);
    TopPoint seen;
    for (int beside = -1; beside <= 1; ++beside) {
        const auto warp = static_cast<std::size_t>(end + beside + 1) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(row);
        const auto weft =
            static_cast<std::size_t>(pick + beside + 1) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
        look(seen, YarnKind::warp, end + beside, warp_[warp], x, y);
        look(seen, YarnKind::weft, pick + beside, weft_[weft], x, y);
    }
    return seen;
}

} // namespace hygroloom
