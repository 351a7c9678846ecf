// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Error against time as a picture that scales (SVG), both axes logarithmic.
#include "core/analysis/svg.h"
#include "core/analysis/tradeoff.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

constexpr double width = 900, height = 560, left = 80, right = 870, top = 60, bottom = 490;
constexpr double least_error = 1e-5;

/// Powers of ten that a range lies between.
struct LogAxis {
    int low = 0, high = 1;
    double from = 0, to = 1; // of the picture
    double at(double value) const { return from + (std::log10(value) - low) / (high - low) * (to - from); }
};

LogAxis axis_of(double least, double most, double from, double to)
{
    const int low = static_cast<int>(std::floor(std::log10(least))), high = static_cast<int>(std::ceil(std::log10(most)));
    return {low, std::max(high, low + 1), from, to};
}

std::string axes(const LogAxis& time, const LogAxis& error)
{
    std::string svg;
    for (int power = time.low; power <= time.high; ++power) {
        const double x = time.at(std::pow(10.0, power));
        svg += svg_line(x, top, x, bottom, "#ddd") + svg_text(x, bottom + 20, "middle", fmt::format("{:g} s", std::pow(10.0, power)));
    }
    for (int power = error.low; power <= error.high; ++power) {
        const double y = error.at(std::pow(10.0, power));
        svg += svg_line(left, y, right, y, "#ddd") + svg_text(left - 8, y + 4, "end", fmt::format("{:g} %", 100 * std::pow(10.0, power)));
    }
    svg += svg_line(left, bottom, right, bottom, "#333") + svg_line(left, top, left, bottom, "#333");
    svg += svg_text(0.5 * (left + right), bottom + 44, "middle", "wall time, median");
    return svg + svg_text(left, top - 12, "start", "largest error against the reference (the reference itself: on the lower edge)");
}

double shown_error(const TradeoffPoint& point) { return std::max(least_error, point.errors->largest); }

} // namespace

std::string tradeoff_svg(const Tradeoff& t)
{
    std::vector<const TradeoffPoint*> points;
    for (const TradeoffPoint& p : t.points)
        if (p.errors && p.wall() > 0) points.push_back(&p);
    std::string svg = svg_begin(width, height);
    svg += svg_text(left, 24, "start", fmt::format("{}, {} ({}, {}, {})", t.fabric, t.experiment, t.backend, t.device, t.date));
    if (points.empty()) return svg + svg_text(left, top + 40, "start", "No variant has both a time and an error yet.") + "</svg>\n";
    std::sort(points.begin(), points.end(), [](const auto* a, const auto* b) { return a->wall() < b->wall(); });

    double most_error = least_error;
    for (const TradeoffPoint* p : points) most_error = std::max(most_error, shown_error(*p));
    const LogAxis time = axis_of(points.front()->wall(), points.back()->wall(), left, right);
    const LogAxis error = axis_of(least_error, most_error, bottom, top);
    svg += axes(time, error);
    std::string front;
    for (const TradeoffPoint* p : points)
        if (p->pareto) front += fmt::format("{:.1f},{:.1f} ", time.at(p->wall()), error.at(shown_error(*p)));
    svg += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"#1565c0\" stroke-width=\"2\"/>\n", front);
    for (const TradeoffPoint* p : points) {
        const double x = time.at(p->wall()), y = error.at(shown_error(*p));
        const bool rung = p->variant.name == name_of(p->variant.fidelity);
        svg +=
            fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"/>\n", x, y, rung ? 6 : 4, p->pareto ? "#1565c0" : "#999");
        if (rung || p->pareto) svg += svg_text(x > 0.8 * right ? x - 9 : x + 9, y - 7, x > 0.8 * right ? "end" : "start", p->variant.name);
    }
    svg += svg_text(left, height - 8, "start",
                    "Blue: the Pareto front. Large: the ladder of fidelities. Small: one knob a step from standard.");
    return svg + "</svg>\n";
}

} // namespace hygroloom
