// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/metrics.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

/// Calls visit(segment, x, y, on_top) for every wet segment.
template <typename Visit> void each_wet_segment(const Textile& textile, const Frame& frame, const Visit& visit)
{
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (int end = 0; end < textile.ends(); ++end)
            for (int pick = 0; pick < textile.picks(); ++pick) {
                const int i = textile.segment(kind, end, pick);
                if (frame.saturation[static_cast<std::size_t>(i)] >= wet_saturation)
                    visit(i, textile.x_of_end(end), textile.y_of_pick(pick), textile.warp_up(end, pick) == (kind == YarnKind::warp));
            }
}

/// Semi-axes of the ellipse with the wet points' second moments: a filled ellipse's are twice their standard deviations.
std::array<double, 2> wetted_ellipse(const Textile& textile, const Frame& frame)
{
    double n = 0, sx = 0, sy = 0, sxx = 0, syy = 0;
    each_wet_segment(textile, frame, [&](int, double x, double y, bool on_top) {
        if (!on_top) return;
        n += 1;
        sx += x;
        sy += y;
        sxx += x * x;
        syy += y * y;
    });
    if (n < 1) return {0, 0};
    const auto semi_axis = [&](double sum, double squares) { return 2.0 * std::sqrt(std::max(0.0, squares / n - sum * sum / (n * n))); };
    return {semi_axis(sx, sxx), semi_axis(sy, syy)};
}

} // namespace

Circle wetted_circle(const Textile& textile, const Frame& frame, Face face)
{
    std::vector<std::array<double, 2>> points;
    each_wet_segment(textile, frame, [&](int, double x, double y, bool on_top) {
        if (on_top == (face == Face::top)) points.push_back({x, y});
    });
    return smallest_enclosing_circle(points);
}

void MetricsCollector::start(const RunRecord& run)
{
    textile_ = run.textile;
    metrics_ = {};
    had_free_water_ = false;
}

void MetricsCollector::add(const Frame& frame)
{
    Series& s = metrics_.series;
    const double top = std::max(0.0, wetted_circle(textile_, frame, Face::top).radius);
    const double bottom = std::max(0.0, wetted_circle(textile_, frame, Face::bottom).radius);
    s.time.push_back(frame.time);
    s.radius_top.push_back(top);
    s.radius_bottom.push_back(bottom);
    s.water_top.push_back(frame.water_top);
    s.water_bottom.push_back(frame.water_bottom);
    s.free_water.push_back(frame.ledger.water_free);
    s.yarn_water.push_back(frame.ledger.water_liquid);
    s.bound_water.push_back(frame.ledger.water_bound);
    s.evaporated.push_back(frame.ledger.water_evaporated);
    s.dripped.push_back(frame.ledger.water_dripped);
    const auto [coldest, hottest] = std::minmax_element(frame.temperature.begin(), frame.temperature.end());
    double temperature = 0, regain = 0;
    for (float t : frame.temperature) temperature += t;
    for (float r : frame.regain) regain += r;
    const double n = static_cast<double>(frame.temperature.size());
    s.temperature_mean.push_back(temperature / n);
    s.temperature_min.push_back(*coldest);
    s.temperature_max.push_back(*hottest);
    s.regain_mean.push_back(regain / n);

    metrics_.maximum_wetted_radius_top = std::max(metrics_.maximum_wetted_radius_top, top);
    metrics_.maximum_wetted_radius_bottom = std::max(metrics_.maximum_wetted_radius_bottom, bottom);
    const std::array<double, 2> axes = wetted_ellipse(textile_, frame);
    metrics_.wetted_area_ellipse_weft = axes[0];
    metrics_.wetted_area_ellipse_warp = axes[1];
    metrics_.ledger = frame.ledger;

    // Absorbency: the first moment with no free liquid after which none ever comes, so a later drop starts it anew.
    const bool free_water = frame.ledger.water_free > 0;
    had_free_water_ = had_free_water_ || frame.ledger.water_delivered > 0;
    if (free_water) metrics_.absorbency_time.reset();
    else if (had_free_water_ && !metrics_.absorbency_time) metrics_.absorbency_time = frame.time;
}

} // namespace hygroloom
