// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/scene/liquid_points.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

/// On a cubic lattice in a ball, or in what of it lies over the face.
void fill_cap(const FrameCap& cap, double wanted, std::vector<std::array<float, 3>>& points)
{
    const bool falls = cap.base <= 0;
    const double ball = falls ? std::cbrt(3.0 * cap.volume / (4.0 * pi)) : 0.5 * (cap.base * cap.base / cap.height + cap.height);
    constexpr double most = 30;                                                       // spacings in a ball, whatever a file says
    const double spacing = std::max(wanted, ball / most), middle = cap.height - ball; // over the face
    const double bottom = falls ? middle - ball : 0.0;
    const int reach = static_cast<int>(ball / spacing) + 1;
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j)
            for (int k = 0; k < 2 * reach; ++k) {
                const double x = i * spacing, y = j * spacing, z = bottom + (k + 0.5) * spacing, up = z - middle;
                if (z >= cap.height || x * x + y * y + up * up > ball * ball) continue;
                points.push_back({static_cast<float>(cap.x + x), static_cast<float>(cap.y + y), static_cast<float>(cap.face + z)});
            }
}

} // namespace

std::vector<std::array<float, 3>> liquid_points(const Frame& frame)
{
    if (frame.caps.empty()) return frame.positions;
    constexpr double wanted = 2000;
    constexpr std::size_t most = 200000; // whatever a file says
    double volume = 0;
    for (const FrameCap& cap : frame.caps) volume += cap.volume;
    std::vector<std::array<float, 3>> points;
    for (const FrameCap& cap : frame.caps)
        if (cap.height > 0 && cap.volume > 0 && points.size() < most) fill_cap(cap, std::cbrt(volume / wanted), points);
    return points;
}

} // namespace hygroloom
