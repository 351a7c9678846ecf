// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/map_image.h"

#include "core/analysis/cairo_image.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/project/atomic_file.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

constexpr Colour dry{233, 228, 218}, ring{196, 30, 58};
constexpr int line_height = 20;
constexpr int margin = 16;
constexpr int bar_width = 18;

/// 0 light .. 1 deep blue, or of temperatures deep red.
Colour colour_of(ShownQuantity quantity, double share)
{
    constexpr Colour blues[] = {{240, 247, 253}, {181, 212, 238}, {104, 165, 217}, {40, 106, 182}, {8, 42, 108}};
    constexpr Colour reds[] = {{255, 243, 205}, {253, 200, 125}, {240, 128, 70}, {190, 52, 48}, {98, 8, 38}};
    const Colour* stops = quantity == ShownQuantity::temperature ? reds : blues;
    const double at = std::clamp(share, 0.0, 1.0) * 4;
    const auto low = std::min(static_cast<std::size_t>(at), std::size_t(3));
    Colour mixed;
    for (std::size_t i = 0; i < 3; ++i) mixed[i] = stops[low][i] + (stops[low + 1][i] - stops[low][i]) * (at - static_cast<double>(low));
    return mixed;
}

constexpr int swatch = 16;

/// What the colours of a map say.
struct Scale {
    ShownQuantity quantity;
    ValueRange range;
    Colour of(double value) const
    {
        if (quantity == ShownQuantity::water && (range.high <= 0 || value < 0.01 * range.high)) return dry;
        return colour_of(quantity, (value - range.low) / (range.high - range.low));
    }
    ReaderUnit degrees; ///< of temperatures
    std::string unit() const
    {
        return quantity == ShownQuantity::water ? "g/m²" : quantity == ShownQuantity::temperature ? degrees.unit : "%";
    }
    std::string number(double value) const
    {
        if (quantity == ShownQuantity::temperature) return fmt::format("{:.1f}", degrees.of(celsius_from_kelvin(value)));
        return fmt::format("{:.3g}", (quantity == ShownQuantity::humidity ? 100 : 1e3) * value);
    }
};

Scale scale_of(const CellMap& map, const MapImageOptions& options)
{
    const ReaderUnit degrees = reader_unit(options.units, "°C");
    if (map.quantity != ShownQuantity::water) return {map.quantity, options.range, degrees};
    return {map.quantity, {0, options.most > 0 ? options.most : map.maximum()}, degrees};
}

void draw_bar(Canvas& canvas, int x, int y, int height, const Scale& scale)
{
    const int length = height - 2 * line_height;
    for (int j = 0; j < length; ++j) canvas.box(x, y + j, bar_width, 1, colour_of(scale.quantity, 1 - (j + 0.5) / length));
    canvas.frame(x, y, bar_width, length, Canvas::ink);
    const int beside = x + bar_width + 6;
    canvas.text(beside, y, scale.number(scale.range.high));
    canvas.text(beside, y + line_height, scale.unit());
    canvas.text(beside, y + length - swatch, scale.number(scale.range.low));
    if (scale.quantity != ShownQuantity::water) return;
    canvas.box(x, y + height - swatch, bar_width, swatch, dry);
    canvas.frame(x, y + height - swatch, bar_width, swatch, Canvas::ink);
    canvas.text(beside, y + height - swatch, "dry");
}

/// The cells, a pixel at a time.
void draw_cells(Canvas& canvas, const CellMap& map, double height, int top, int across, int down, double scale, const Scale& colours)
{
    for (int j = 0; j < down; ++j) {
        const double y = height - (j + 0.5) * height / down; // the first row lies at the bottom
        const int row = std::clamp(static_cast<int>(y / map.cell_height), 0, map.rows - 1);
        const auto column_at = [&](int i) { return std::min(static_cast<int>((i + 0.5) / scale / map.cell_width), map.columns - 1); };
        for (int i = 0, next = 0; i < across; i = next) {
            const int column = column_at(i);
            while (next < across && column_at(next) == column) ++next;
            canvas.box(margin + i, top + j, next - i, 1, colours.of(map.at(column, row)));
        }
    }
}

} // namespace

Image draw_map(const CellMap& map, double width, double height, const MapImageOptions& options)
{
    const int cells = std::max(map.columns, map.rows);
    const int longest = std::clamp(cells * 8, 480, 1600);
    const double scale = longest / std::max(width, height); // pixels per metre
    const int across = std::max(1, static_cast<int>(std::lround(scale * width))),
              down = std::max(4 * line_height, static_cast<int>(std::lround(scale * height)));
    int caption_width = 0;
    for (const std::string& line : options.captions) caption_width = std::max(caption_width, Canvas::width_of(line));
    const int top = margin + line_height * static_cast<int>(options.captions.size()) + (options.captions.empty() ? 0 : 6);
    const int bar_left = margin + across + margin;
    Canvas canvas(std::max(bar_left + bar_width + 6 + 80, caption_width + 2 * margin), top + down + margin + 2 * line_height);

    for (std::size_t line = 0; line < options.captions.size(); ++line)
        canvas.text(margin, margin + static_cast<int>(line) * line_height, options.captions[line]);
    const Scale colours = scale_of(map, options);
    draw_cells(canvas, map, height, top, across, down, scale, colours);
    canvas.frame(margin - 1, top - 1, across + 2, down + 2, Canvas::ink);
    if (options.circle && options.circle->radius > 0)
        canvas.circle(margin + (options.circle->x + 0.5 * width) * scale, top + (0.5 * height - options.circle->y) * scale,
                      options.circle->radius * scale, {margin, top, across, down}, ring);

    canvas.scale_bar(margin, top + down + margin, width / 3, scale, options.units);
    draw_bar(canvas, bar_left, top, down, colours);
    return canvas.take();
}

std::string png_bytes(const Image& image)
{
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = 0;
    std::string bytes;
    bool made = png_image_write_to_memory(&png, nullptr, &size, 0, image.rgb.data(), 0, nullptr) != 0;
    if (made) {
        bytes.resize(size);
        made = png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) != 0;
        bytes.resize(size);
    }
    if (!made) throw Error(std::string("The picture cannot be made: ") + png.message);
    return bytes;
}

void write_png(const Image& image, const std::filesystem::path& path) { write_file(path, png_bytes(image)); }

} // namespace hygroloom
