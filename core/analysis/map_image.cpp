// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/map_image.h"

#include "core/analysis/small_font.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/project/atomic_file.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

using Colour = std::array<double, 3>;

constexpr Colour paper{255, 255, 255}, ink{40, 44, 52}, dry{233, 228, 218}, ring{196, 30, 58};
constexpr int letter_size = 2; ///< pixels per dot
constexpr int line_height = 10 * letter_size;
constexpr int margin = 16;
constexpr int bar_width = 18;

/// 0 light .. 1 deep blue.
Colour blue(double share)
{
    constexpr Colour stops[] = {{240, 247, 253}, {181, 212, 238}, {104, 165, 217}, {40, 106, 182}, {8, 42, 108}};
    const double at = std::clamp(share, 0.0, 1.0) * 4;
    const auto low = std::min(static_cast<std::size_t>(at), std::size_t(3));
    Colour mixed;
    for (std::size_t i = 0; i < 3; ++i) mixed[i] = stops[low][i] + (stops[low + 1][i] - stops[low][i]) * (at - static_cast<double>(low));
    return mixed;
}

class Canvas {
public:
    Canvas(int width, int height)
        : image_{width, height, std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255)}
    {
    }

    /// Laid over what is there; outside the picture nothing happens.
    void dot(int x, int y, const Colour& colour, double opacity = 1)
    {
        if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return;
        std::uint8_t* pixel =
            &image_.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(x))];
        for (std::size_t i = 0; i < 3; ++i) pixel[i] = static_cast<std::uint8_t>(std::lround(pixel[i] + opacity * (colour[i] - pixel[i])));
    }

    void box(int x, int y, int width, int height, const Colour& colour)
    {
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) dot(x + i, y + j, colour);
    }

    void frame(int x, int y, int width, int height, const Colour& colour)
    {
        box(x, y, width, 1, colour);
        box(x, y + height - 1, width, 1, colour);
        box(x, y, 1, height, colour);
        box(x + width - 1, y, 1, height, colour);
    }

    void text(int x, int y, const std::string& words)
    {
        for (char letter : words) {
            for (const SmallLetter& known : small_font) {
                if (known.letter != letter) continue;
                for (int row = 0; row < 7; ++row)
                    for (int column = 0; column < 5; ++column)
                        if (known.rows[static_cast<std::size_t>(row)] >> (4 - column) & 1)
                            box(x + column * letter_size, y + row * letter_size, letter_size, letter_size, ink);
            }
            x += 6 * letter_size;
        }
    }

    Image take() { return std::move(image_); }

private:
    Image image_;
};

int text_width(const std::string& words) { return 6 * letter_size * static_cast<int>(words.size()); }

/// 1, 2 or 5 times a power of ten, at most a given length.
double round_length(double most)
{
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (double factor : {5.0, 2.0})
        if (factor * power <= most) return factor * power;
    return power;
}

void draw_circle(Canvas& canvas, double x, double y, double radius, int left, int top, int right, int bottom)
{
    // Soft-edged ring of two pixels' width, within the map only.
    for (int j = std::max(top, static_cast<int>(y - radius) - 2); j <= std::min(bottom - 1, static_cast<int>(y + radius) + 2); ++j)
        for (int i = std::max(left, static_cast<int>(x - radius) - 2); i <= std::min(right - 1, static_cast<int>(x + radius) + 2); ++i) {
            const double off = std::abs(std::hypot(i + 0.5 - x, j + 0.5 - y) - radius);
            if (off < 1.5) canvas.dot(i, j, ring, std::min(1.0, 1.5 - off));
        }
}

void draw_bar(Canvas& canvas, int x, int y, int height, double most)
{
    const int length = height - 2 * line_height;
    for (int j = 0; j < length; ++j) canvas.box(x, y + j, bar_width, 1, blue(1 - (j + 0.5) / length));
    canvas.frame(x, y, bar_width, length, ink);
    const int beside = x + bar_width + 6;
    canvas.text(beside, y, fmt::format("{:.3g}", 1e3 * most));
    canvas.text(beside, y + 12 * letter_size, "g/m2");
    canvas.text(beside, y + length - 7 * letter_size, "0");
    canvas.box(x, y + height - 8 * letter_size, bar_width, 8 * letter_size, dry);
    canvas.frame(x, y + height - 8 * letter_size, bar_width, 8 * letter_size, ink);
    canvas.text(beside, y + height - 8 * letter_size + 1, "dry");
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
    Canvas canvas(std::max(bar_left + bar_width + 6 + 8 * 6 * letter_size, caption_width + 2 * margin),
                  top + down + margin + 2 * line_height);

    for (std::size_t line = 0; line < options.captions.size(); ++line)
        canvas.text(margin, margin + static_cast<int>(line) * line_height, options.captions[line]);
    const double most = options.most > 0 ? options.most : map.maximum();
    for (int j = 0; j < down; ++j)
        for (int i = 0; i < across; ++i) {
            const double x = (i + 0.5) / scale, y = height - (j + 0.5) * height / down; // the first row lies at the bottom
            const int column = std::min(static_cast<int>(x / map.cell_width), map.columns - 1);
            const int row = std::clamp(static_cast<int>(y / map.cell_height), 0, map.rows - 1);
            const double water = map.at(column, row);
            canvas.dot(margin + i, top + j, most > 0 && water >= 0.01 * most ? blue(water / most) : dry);
        }
    canvas.frame(margin - 1, top - 1, across + 2, down + 2, ink);
    if (options.circle && options.circle->radius > 0)
        draw_circle(canvas, margin + (options.circle->x + 0.5 * width) * scale, top + (0.5 * height - options.circle->y) * scale,
                    options.circle->radius * scale, margin, top, margin + across, top + down);

    const double length = round_length(width / 3);
    const int bar = static_cast<int>(std::lround(length * scale)), bar_top = top + down + margin;
    canvas.box(margin, bar_top, bar, 4, ink);
    canvas.text(margin, bar_top + 8, fmt::format("{:.3g} mm", mm_from_metre(length)));
    draw_bar(canvas, bar_left, top, down, most);
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
