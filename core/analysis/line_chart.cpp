// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/line_chart.h"

#include "core/analysis/svg.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hygroloom {
namespace {

constexpr double width = 460, height = 280, left = 64, right = 448, top = 34, bottom = 216;

/// From one round number to another.
struct Axis {
    double low, high, step;
    double from, to; ///< of the picture
    double at(double value) const { return from + (value - low) / (high - low) * (to - from); }
    int steps() const { return static_cast<int>(std::lround((high - low) / step)); }
    /// Without what rounding leaves of 0.
    double tick(int k) const { return std::abs(low + k * step) < 1e-9 * step ? 0 : low + k * step; }
};

Axis axis_of(double least, double most, double from, double to)
{
    if (!(most - least > 1e-4 * std::max(std::abs(most), std::abs(least)))) { // all the same, within rounding
        const double half = most == 0 ? 1 : 0.1 * std::abs(most);
        least -= half;
        most += half;
    }
    const double rough = (most - least) / 5, power = std::pow(10.0, std::floor(std::log10(rough))), share = rough / power;
    const double step = power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
    return {std::floor(least / step + 1e-9) * step, std::ceil(most / step - 1e-9) * step, step, from, to};
}

std::string axes(const LineChart& chart, const Axis& x, const Axis& y)
{
    std::string svg;
    for (int k = 0; k <= x.steps(); ++k) {
        const double place = x.at(x.tick(k));
        svg += svg_line(place, top, place, bottom, "#ddd") + svg_text(place, bottom + 16, "middle", fmt::format("{:.6g}", x.tick(k)));
    }
    for (int k = 0; k <= y.steps(); ++k) {
        const double place = y.at(y.tick(k));
        svg += svg_line(left, place, right, place, "#ddd") + svg_text(left - 6, place + 4, "end", fmt::format("{:.6g}", y.tick(k)));
    }
    svg += svg_line(left, bottom, right, bottom, "#333") + svg_line(left, top, left, bottom, "#333");
    return svg + svg_text(right, bottom + 34, "end", chart.x_label) + svg_text(left - 56, 16, "start", chart.title + ", " + chart.y_label);
}

struct Stroke {
    const char* colour;
    const char* dashes;
};
constexpr std::array<Stroke, 5> strokes{
    {{"#1565c0", "none"}, {"#c2410c", "8 3"}, {"#15803d", "2 3"}, {"#6d28d9", "10 3 2 3"}, {"#525252", "5 5"}}};

std::string svg_circle(double x, double y, const char* colour)
{
    return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3.5\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", x, y, colour);
}

std::string curve_of(const LineChart& chart, const LineChart::Curve& shape, const Axis& x, const Axis& y, const Stroke& stroke)
{
    const std::vector<double>& values = shape.values;
    std::string path;
    bool drawing = false;
    if (shape.points) {
        for (std::size_t i = 0; i < std::min(chart.x.size(), values.size()); ++i)
            if (std::isfinite(values[i])) path += svg_circle(x.at(chart.x[i]), y.at(values[i]), stroke.colour);
        return path;
    }
    for (std::size_t i = 0; i < std::min(chart.x.size(), values.size()); ++i) {
        if (std::isfinite(values[i])) path += fmt::format("{}{:.2f} {:.2f}", drawing ? 'L' : 'M', x.at(chart.x[i]), y.at(values[i]));
        drawing = std::isfinite(values[i]);
    }
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" stroke-dasharray=\"{}\"/>\n", path, stroke.colour,
                       stroke.dashes);
}

/// From the high values to the right and back along the low ones.
std::string band_of(const LineChart& chart, const LineChart::Curve& shape, const Axis& x, const Axis& y, const Stroke& stroke)
{
    const std::size_t count = std::min({chart.x.size(), shape.low.size(), shape.high.size()});
    std::string path;
    const auto add = [&](double across, double value) {
        if (std::isfinite(value)) path += fmt::format("{}{:.2f} {:.2f}", path.empty() ? 'M' : 'L', x.at(across), y.at(value));
    };
    for (std::size_t i = 0; i < count; ++i) add(chart.x[i], shape.high[i]);
    for (std::size_t i = count; i-- > 0;) add(chart.x[i], shape.low[i]);
    return path.empty() ? path : fmt::format("<path d=\"{}Z\" fill=\"{}\" fill-opacity=\"0.18\" stroke=\"none\"/>\n", path, stroke.colour);
}

} // namespace

std::string svg_of(const LineChart& chart)
{
    double least = 0, most = 0;
    bool any = false;
    for (const LineChart::Curve& curve : chart.curves)
        for (const auto* values : {&curve.values, &curve.low, &curve.high})
            for (const double value : *values) {
                if (!std::isfinite(value)) continue;
                least = any ? std::min(least, value) : value;
                most = any ? std::max(most, value) : value;
                any = true;
            }
    const Axis x = axis_of(chart.x.front(), chart.x.back(), left, right), y = axis_of(least, most, bottom, top);
    std::string svg = svg_begin(width, height) + axes(chart, x, y);
    for (std::size_t i = 0; i < chart.curves.size(); ++i) svg += band_of(chart, chart.curves[i], x, y, strokes[i % strokes.size()]);
    double legend = 36;
    for (std::size_t i = 0; i < chart.curves.size(); ++i) {
        const Stroke& stroke = strokes[i % strokes.size()];
        svg += curve_of(chart, chart.curves[i], x, y, stroke);
        if (chart.curves[i].points)
            svg += svg_circle(legend + 11, height - 16, stroke.colour);
        else
            svg += fmt::format("<line x1=\"{0:.1f}\" y1=\"{2:.1f}\" x2=\"{1:.1f}\" y2=\"{2:.1f}\" stroke=\"{3}\" stroke-width=\"2\" "
                               "stroke-dasharray=\"{4}\"/>\n",
                               legend, legend + 22, height - 16, stroke.colour, stroke.dashes);
        svg += svg_text(legend + 26, height - 12, "start", chart.curves[i].name);
        constexpr double letter = 6;
        legend += 36 + letter * static_cast<double>(chart.curves[i].name.size());
    }
    return svg + "</svg>";
}

} // namespace hygroloom
