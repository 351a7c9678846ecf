// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/cairo_image.h"

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/base/utf8.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <numbers>

namespace hygroloom {
namespace {

/// 1, 2 or 5 times a power of ten, at most a given length.
double round_length(double most)
{
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (double factor : {5.0, 2.0})
        if (factor * power <= most) return factor * power;
    return power;
}

} // namespace

Canvas::Canvas(int width, int height)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), cairo_surface_destroy),
      cairo_(cairo_create(surface_.get()), cairo_destroy)
{
    if (cairo_status(cairo_.get()) != CAIRO_STATUS_SUCCESS) throw Error("The picture cannot be made: there is not enough memory.");
    cairo_select_font_face(cairo_.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_.get(), letter_height);
    box(0, 0, width, height, paper);
}

void Canvas::use(const Colour& colour) { cairo_set_source_rgb(cairo_.get(), colour[0] / 255, colour[1] / 255, colour[2] / 255); }

void Canvas::box(int x, int y, int width, int height, const Colour& colour)
{
    use(colour);
    cairo_rectangle(cairo_.get(), x, y, width, height);
    cairo_fill(cairo_.get());
}

void Canvas::frame(int x, int y, int width, int height, const Colour& colour)
{
    use(colour);
    cairo_set_line_width(cairo_.get(), 1);
    cairo_rectangle(cairo_.get(), x + 0.5, y + 0.5, width - 1, height - 1);
    cairo_stroke(cairo_.get());
}

void Canvas::circle(double x, double y, double radius, const Rectangle& within, const Colour& colour)
{
    cairo_save(cairo_.get());
    cairo_rectangle(cairo_.get(), within.x, within.y, within.width, within.height);
    cairo_clip(cairo_.get());
    use(colour);
    cairo_set_line_width(cairo_.get(), 2);
    cairo_arc(cairo_.get(), x, y, radius, 0, 2 * std::numbers::pi);
    cairo_stroke(cairo_.get());
    cairo_restore(cairo_.get());
}

void Canvas::text(int x, int y, const std::string& words)
{
    use(ink);
    cairo_move_to(cairo_.get(), x, y + letter_height - 2);
    cairo_show_text(cairo_.get(), printable(words).c_str());
}

void Canvas::scale_bar(int x, int y, double widest, double scale, const ReaderUnits& units)
{
    const ReaderUnit unit = reader_unit(units, "mm");
    const double length = round_length(unit.of(mm_from_metre(widest)));
    box(x, y, static_cast<int>(std::lround(metre_from_mm(length / unit.per_one) * scale)), 4, ink);
    text(x, y + 8, fmt::format("{:.3g} {}", length, unit.unit));
}

int Canvas::width_of(const std::string& words)
{
    Canvas none(1, 1);
    cairo_text_extents_t extents{};
    cairo_text_extents(none.cairo(), printable(words).c_str(), &extents);
    return static_cast<int>(std::ceil(extents.x_advance));
}

Image Canvas::take()
{
    cairo_surface_t* const surface = surface_.get();
    cairo_surface_flush(surface);
    if (const cairo_status_t status = cairo_status(cairo_.get()); status != CAIRO_STATUS_SUCCESS)
        throw Error(fmt::format("The picture was not drawn: {}.", cairo_status_to_string(status)));
    const int width = cairo_image_surface_get_width(surface), height = cairo_image_surface_get_height(surface);
    Image image{width, height, {}};
    image.rgb.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int j = 0; j < height; ++j) {
        const unsigned char* row = cairo_image_surface_get_data(surface) +
                                   static_cast<std::size_t>(j) * static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
        for (int i = 0; i < width; ++i) {
            std::uint32_t pixel = 0;
            std::memcpy(&pixel, row + 4 * static_cast<std::size_t>(i), sizeof pixel);
            for (const int shift : {16, 8, 0}) image.rgb.push_back(static_cast<std::uint8_t>(pixel >> shift & 0xffU));
        }
    }
    return image;
}

} // namespace hygroloom
