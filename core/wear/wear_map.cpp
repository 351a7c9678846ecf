// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/wear_map.h"

#include "core/analysis/cairo_image.h"
#include "core/base/error.h"
#include "core/base/round_up.h"
#include "core/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

namespace hygroloom {
namespace {

constexpr double pixels_per_metre = 1000, most_pixels = 4096;

/// A panel's cells by their end and pick.
class CellsOfPanel {
public:
    CellsOfPanel(const WearLayout& layout, std::size_t panel) : grid_(layout.panels[panel].grid)
    {
        for (std::size_t i = 0; i < layout.cells.size(); ++i)
            if (static_cast<std::size_t>(layout.cells[i].panel) == panel) cells_[key(layout.cells[i].end, layout.cells[i].pick)] = i;
    }
    /// The cell there, or next to there; none: nothing is near.
    std::optional<std::size_t> at(const FlatPlace& place) const
    {
        const std::array<int, 2> middle = grid_.cell_at(place);
        for (int far = 0; far <= 1; ++far)
            for (int end = -far; end <= far; ++end)
                for (int pick = -far; pick <= far; ++pick)
                    if (const auto found = cells_.find(key(middle[0] + end, middle[1] + pick)); found != cells_.end()) return found->second;
        return std::nullopt;
    }

private:
    static std::int64_t key(int end, int pick) { return (std::int64_t{end} << 32) + pick; }
    const PanelGrid& grid_;
    std::unordered_map<std::int64_t, std::size_t> cells_;
};

double scale_of(const FlatBox& box) { return std::min(pixels_per_metre, most_pixels / std::max({1e-6, box.width(), box.height()})); }

Colour colour_of_step(std::size_t step)
{
    const std::array<std::uint8_t, 3> colour = step_colour(step);
    return {static_cast<double>(colour[0]), static_cast<double>(colour[1]), static_cast<double>(colour[2])};
}

/// An arrow along the warp, about a place; half its length in pixels, the grain in radian.
void draw_grain(cairo_t* cairo, double x, double y, double half, double grain)
{
    const double tip_x = x - half * std::sin(grain), tip_y = y - half * std::cos(grain);
    cairo_move_to(cairo, x + half * std::sin(grain), y + half * std::cos(grain));
    cairo_line_to(cairo, tip_x, tip_y);
    for (double side : {-0.5, 0.5}) {
        cairo_move_to(cairo, tip_x, tip_y);
        cairo_line_to(cairo, tip_x + 10 * std::sin(grain + side), tip_y + 10 * std::cos(grain + side));
    }
    cairo_set_source_rgb(cairo, 0.77, 0.12, 0.23);
    cairo_stroke(cairo);
}

void draw_legend(Canvas& canvas, const WearMap& map, int x, int y)
{
    constexpr int side = 24;
    canvas.text(x, y - Canvas::letter_height, map.scale == WearScale::same ? "water, g/m²" : "share of capacity");
    for (std::size_t step = map.steps.size(); step-- > 0;) {
        const int top = y + 12 + side * static_cast<int>(map.steps.size() - 1 - step);
        canvas.box(x, top, side, side, colour_of_step(step));
        canvas.frame(x, top, side, side + 1, Canvas::ink);
        const double from = step > 0 ? map.steps[step - 1] : 0, to = map.steps[step];
        canvas.text(x + 30, top + 4,
                    map.scale == WearScale::same ? fmt::format("{:.4g} to {:.4g}", from, to)
                                                 : fmt::format("{:.4g} to {:.4g} %", 100 * from, 100 * to));
    }
}

} // namespace

WearSteps even_steps(double most)
{
    WearSteps steps;
    for (std::size_t k = 0; k < steps.size(); ++k) steps[k] = most * static_cast<double>(k + 1) / static_cast<double>(steps.size());
    return steps;
}

void require_ascending(const WearSteps& steps)
{
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const double below = k > 0 ? steps[k - 1] : 0;
        if (!(steps[k] > below) || !std::isfinite(steps[k]))
            throw Error(fmt::format("Step {} ends at {:.6g}; it must end above {:.6g}.", k + 1, steps[k], below));
    }
}

std::size_t step_of(const WearSteps& steps, double value)
{
    return static_cast<std::size_t>(std::upper_bound(steps.begin(), steps.end() - 1, value) - steps.begin());
}

std::array<std::uint8_t, 3> step_colour(std::size_t step)
{
    constexpr std::array<std::array<std::uint8_t, 3>, std::tuple_size_v<WearSteps>> colours{{{255, 255, 255},
                                                                                             {222, 235, 247},
                                                                                             {198, 219, 239},
                                                                                             {158, 202, 225},
                                                                                             {107, 174, 214},
                                                                                             {66, 146, 198},
                                                                                             {33, 113, 181},
                                                                                             {8, 48, 107}}};
    return colours[step];
}

WearMap wear_map(const WearLayout& layout, const WearFrame& frame, const WearMapOptions& options)
{
    const auto group_of = [&](const WearPanel& panel) {
        return std::max(1, static_cast<int>(std::lround(static_cast<double>(options.crossings) / panel.crossings_per_cell)));
    };
    struct Sum {
        double water = 0, area = 0, capacity = 0;
    };
    std::map<std::array<int, 3>, Sum> sums;
    const auto key = [&](const GarmentCell& cell) {
        const int group = group_of(layout.panels[static_cast<std::size_t>(cell.panel)]);
        return std::array{cell.panel, cell.end / group, cell.pick / group};
    };
    for (std::size_t i = 0; i < layout.cells.size(); ++i) {
        Sum& sum = sums[key(layout.cells[i])];
        sum.water += frame.water(i);
        sum.area += layout.cells[i].area;
        sum.capacity += layout.cells[i].capacity;
    }
    WearMap map;
    map.scale = options.scale;
    map.units = options.units;
    double most = 0;
    for (const GarmentCell& cell : layout.cells) {
        const Sum& sum = sums.at(key(cell));
        map.values.push_back(options.scale == WearScale::same ? 1e3 * sum.water / sum.area : sum.water / sum.capacity);
        most = std::max(most, map.values.back());
    }
    map.steps = options.steps ? *options.steps : even_steps(options.most > 0 ? options.most : rounded_up(most));
    require_ascending(map.steps);
    std::set<int> sides; // crossings
    for (const WearPanel& panel : layout.panels) sides.insert(group_of(panel) * panel.crossings_per_cell);
    for (int side : sides) map.cells += fmt::format("{0}{1} x {1}", map.cells.empty() ? "by " : " or ", side);
    map.cells += " crossings";
    return map;
}

Image panel_texture(const WearLayout& layout, const WearMap& map, std::size_t panel)
{
    const FlatBox box = layout.panels[panel].box();
    const double scale = scale_of(box);
    const CellsOfPanel cells(layout, panel);
    Image image{std::max(1, static_cast<int>(std::lround(scale * box.width()))),
                std::max(1, static_cast<int>(std::lround(scale * box.height()))),
                {}};
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const FlatPlace at{box.left + (column + 0.5) / image.width * box.width(), box.high - (row + 0.5) / image.height * box.height()};
            const std::optional<std::size_t> cell = cells.at(at);
            const std::array<std::uint8_t, 3> colour = step_colour(cell ? step_of(map.steps, map.values[*cell]) : 0);
            image.rgb.insert(image.rgb.end(), colour.begin(), colour.end());
        }
    return image;
}

Image panel_picture(const WearLayout& layout, const WearMap& map, std::size_t panel, double time)
{
    const WearPanel& of = layout.panels[panel];
    const FlatBox box = of.box();
    constexpr int margin = 24, head = 64, legend = 170, foot = 56;
    constexpr double most_side = 1000, least_height = 260;
    const double scale = most_side / std::max(box.width(), box.height());
    const double map_height = std::max(least_height, scale * box.height());
    const auto width = static_cast<int>(2 * margin + scale * box.width() + legend), height = static_cast<int>(head + map_height + foot);
    const auto x_of = [&](double x) { return margin + scale * (x - box.left); };
    const auto y_of = [&](double y) { return head + scale * (box.high - y); };
    Canvas canvas(width, height);
    cairo_t* const cairo = canvas.cairo();
    canvas.text(margin, 11, fmt::format("{}, {} of {}, at {:.4g} s", layout.garment, of.name, of.fabric, time));
    canvas.text(margin, 33, map.cells);
    const auto outline = [&] {
        cairo_new_path(cairo);
        for (const FlatPlace& place : of.outline) cairo_line_to(cairo, x_of(place[0]), y_of(place[1]));
        cairo_close_path(cairo);
    };
    cairo_save(cairo);
    outline();
    cairo_clip(cairo);
    cairo_set_antialias(cairo, CAIRO_ANTIALIAS_NONE);
    const FlatPlace &across = of.grid.across, &along = of.grid.along;
    for (double half : {1.0, 0.5}) // cells at the edge reach to the outline
        for (std::size_t i = 0; i < layout.cells.size(); ++i) {
            const GarmentCell& cell = layout.cells[i];
            if (static_cast<std::size_t>(cell.panel) != panel) continue;
            cairo_new_path(cairo);
            for (const auto& [a, b] : {std::pair{-half, -half}, {half, -half}, {half, half}, {-half, half}})
                cairo_line_to(cairo, x_of(cell.flat[0] + a * across[0] + b * along[0]), y_of(cell.flat[1] + a * across[1] + b * along[1]));
            cairo_close_path(cairo);
            canvas.use(colour_of_step(step_of(map.steps, map.values[i])));
            cairo_fill(cairo);
        }
    cairo_restore(cairo);
    outline();
    canvas.use(Canvas::ink);
    cairo_set_line_width(cairo, 1.5);
    cairo_stroke(cairo);
    draw_grain(cairo, x_of(0.5 * (box.left + box.right)), y_of(0.5 * (box.low + box.high)),
               0.2 * scale * std::min(box.width(), box.height()), of.grain);
    canvas.scale_bar(margin, static_cast<int>(head + map_height + 20), 0.5 * box.width(), scale, map.units);
    draw_legend(canvas, map, static_cast<int>(2 * margin + scale * box.width()), head + 12);
    return canvas.take();
}

const std::vector<CellNumber>& cell_numbers()
{
    using Cell = const GarmentCell&;
    using Frame = const WearFrame&;
    static const std::vector<CellNumber> table{
        {"area_mm2", [](Cell cell, Frame, std::size_t) { return 1e6 * cell.area; }, 4},
        {"water_g_m2", [](Cell cell, Frame frame, std::size_t i) { return 1e3 * frame.water(i) / cell.area; }},
        {"inside_g_m2", [](Cell cell, Frame frame, std::size_t i) { return 1e3 * frame.inside[i] / cell.area; }},
        {"outside_g_m2", [](Cell cell, Frame frame, std::size_t i) { return 1e3 * frame.outside[i] / cell.area; }},
        {"share_of_capacity", [](Cell cell, Frame frame, std::size_t i) { return frame.water(i) / cell.capacity; }},
        {"temperature_c", [](Cell, Frame frame, std::size_t i) { return static_cast<double>(frame.temperature[i]) - zero_celsius; }, 4},
        {"evaporated_g_m2", [](Cell cell, Frame frame, std::size_t i) { return 1e3 * frame.evaporated[i] / cell.area; }},
        {"on_skin_g_m2", [](Cell cell, Frame frame, std::size_t i) { return 1e3 * frame.on_skin[i] / cell.area; }}};
    return table;
}

std::string wear_csv(const WearLayout& layout, const WearFrame& frame)
{
    std::string text = "panel,end,pick,flat_x_mm,flat_y_mm,x_mm,y_mm,z_mm,zone";
    for (const CellNumber& number : cell_numbers()) text += std::string(",") + number.name;
    text += "\n";
    const std::vector<std::string> zones = layout.zone_names();
    for (std::size_t i = 0; i < layout.cells.size(); ++i) {
        const GarmentCell& c = layout.cells[i];
        text +=
            fmt::format("{},{},{},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{}", csv_field(layout.panels[static_cast<std::size_t>(c.panel)].name),
                        c.end, c.pick, 1e3 * c.flat[0], 1e3 * c.flat[1], 1e3 * c.place.x, 1e3 * c.place.y, 1e3 * c.place.z,
                        csv_field(zones[static_cast<std::size_t>(c.zone)]));
        for (const CellNumber& number : cell_numbers()) {
            const double value = number.of(c, frame, i);
            text += number.decimals ? fmt::format(",{:.{}f}", value, *number.decimals) : fmt::format(",{:.6g}", value);
        }
        text += "\n";
    }
    return text;
}

} // namespace hygroloom
