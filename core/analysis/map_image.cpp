// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/map_image.h"

#include "core/analysis/cairo_image.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/base/utf8.h"
#include "core/project/atomic_file.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace hygroloom {
namespace {

using Colour = std::array<double, 3>; ///< 0 .. 255

constexpr Colour paper{255, 255, 255}, ink{40, 44, 52}, dry{233, 228, 218}, ring{196, 30, 58};
constexpr double letter_height = 15; ///< pixels
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

/// A picture that Cairo draws into.
class Canvas {
public:
    Canvas(int width, int height)
        : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), cairo_surface_destroy),
          cairo_(cairo_create(surface_.get()), cairo_destroy)
    {
        if (cairo_status(cairo_.get()) != CAIRO_STATUS_SUCCESS) throw Error("The picture cannot be made: there is not enough memory.");
        cairo_select_font_face(cairo_.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(cairo_.get(), letter_height);
        box(0, 0, width, height, paper);
    }

    void box(int x, int y, int width, int height, const Colour& colour)
    {
        use(colour);
        cairo_rectangle(cairo_.get(), x, y, width, height);
        cairo_fill(cairo_.get());
    }

    /// One pixel wide.
    void frame(int x, int y, int width, int height, const Colour& colour)
    {
        use(colour);
        cairo_set_line_width(cairo_.get(), 1);
        cairo_rectangle(cairo_.get(), x + 0.5, y + 0.5, width - 1, height - 1);
        cairo_stroke(cairo_.get());
    }

    /// Two pixels wide, within the rectangle only.
    void circle(double x, double y, double radius, int left, int top, int right, int bottom)
    {
        cairo_save(cairo_.get());
        cairo_rectangle(cairo_.get(), left, top, right - left, bottom - top);
        cairo_clip(cairo_.get());
        use(ring);
        cairo_set_line_width(cairo_.get(), 2);
        cairo_arc(cairo_.get(), x, y, radius, 0, 2 * std::numbers::pi);
        cairo_stroke(cairo_.get());
        cairo_restore(cairo_.get());
    }

    /// y: of the top of the letters.
    void text(int x, int y, const std::string& words)
    {
        use(ink);
        cairo_move_to(cairo_.get(), x, y + letter_height - 2);
        cairo_show_text(cairo_.get(), printable(words).c_str());
    }

    /// Throws Error where something could not be drawn.
    Image take() { return image_from(cairo_.get()); }

private:
    void use(const Colour& colour) { cairo_set_source_rgb(cairo_.get(), colour[0] / 255, colour[1] / 255, colour[2] / 255); }

    std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
    std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo_;
};

/// Pixels.
int text_width(const std::string& words)
{
    const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> none(cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1, 1),
                                                                                  cairo_surface_destroy);
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(none.get()), cairo_destroy);
    cairo_select_font_face(cairo.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo.get(), letter_height);
    cairo_text_extents_t extents{};
    cairo_text_extents(cairo.get(), printable(words).c_str(), &extents);
    return static_cast<int>(std::ceil(extents.x_advance));
}

/// 1, 2 or 5 times a power of ten, at most a given length.
double round_length(double most)
{
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (double factor : {5.0, 2.0})
        if (factor * power <= most) return factor * power;
    return power;
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
    canvas.frame(x, y, bar_width, length, ink);
    const int beside = x + bar_width + 6;
    canvas.text(beside, y, scale.number(scale.range.high));
    canvas.text(beside, y + line_height, scale.unit());
    canvas.text(beside, y + length - swatch, scale.number(scale.range.low));
    if (scale.quantity != ShownQuantity::water) return;
    canvas.box(x, y + height - swatch, bar_width, swatch, dry);
    canvas.frame(x, y + height - swatch, bar_width, swatch, ink);
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
    for (const std::string& line : options.captions) caption_width = std::max(caption_width, text_width(line));
    const int top = margin + line_height * static_cast<int>(options.captions.size()) + (options.captions.empty() ? 0 : 6);
    const int bar_left = margin + across + margin;
    Canvas canvas(std::max(bar_left + bar_width + 6 + 80, caption_width + 2 * margin), top + down + margin + 2 * line_height);

    for (std::size_t line = 0; line < options.captions.size(); ++line)
        canvas.text(margin, margin + static_cast<int>(line) * line_height, options.captions[line]);
    const Scale colours = scale_of(map, options);
    draw_cells(canvas, map, height, top, across, down, scale, colours);
    canvas.frame(margin - 1, top - 1, across + 2, down + 2, ink);
    if (options.circle && options.circle->radius > 0)
        canvas.circle(margin + (options.circle->x + 0.5 * width) * scale, top + (0.5 * height - options.circle->y) * scale,
                      options.circle->radius * scale, margin, top, margin + across, top + down);

    const ReaderUnit unit = reader_unit(options.units, "mm");
    const double length = round_length(unit.of(mm_from_metre(width / 3)));
    const int bar = static_cast<int>(std::lround(metre_from_mm(length / unit.per_one) * scale)), bar_top = top + down + margin;
    canvas.box(margin, bar_top, bar, 4, ink);
    canvas.text(margin, bar_top + 8, fmt::format("{:.3g} {}", length, unit.unit));
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
