// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A picture that Cairo draws into: boxes, texts and scale bars of maps.
#pragma once

#include "core/analysis/image.h"
#include "core/analysis/reader_units.h"

#include <cairo.h>

#include <array>
#include <memory>
#include <string>

namespace hygroloom {

using Colour = std::array<double, 3>; ///< red, green, blue, 0 to 255

class Canvas {
public:
    static constexpr Colour paper{255, 255, 255}, ink{40, 44, 52};
    static constexpr int letter_height = 15; ///< pixels

    /// Pixels. Throws Error where there is no memory for it.
    Canvas(int width, int height);

    /// For lines of other kinds.
    cairo_t* cairo() { return cairo_.get(); }
    void use(const Colour& colour);
    void box(int x, int y, int width, int height, const Colour& colour);
    /// One pixel wide.
    void frame(int x, int y, int width, int height, const Colour& colour);
    struct Rectangle {
        int x = 0, y = 0, width = 0, height = 0;
    };
    /// Two pixels wide, within the rectangle only.
    void circle(double x, double y, double radius, const Rectangle& within, const Colour& colour);
    /// y: of the top of the letters.
    void text(int x, int y, const std::string& words);
    /// A round length in the reader's unit, at most the widest (m), with its number below. scale: pixels of a metre.
    void scale_bar(int x, int y, double widest, double scale, const ReaderUnits& units);
    /// Of a text, pixels.
    static int width_of(const std::string& words);
    /// Throws Error where something could not be drawn: Cairo keeps its first failure to the end.
    Image take();

private:
    std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
    std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo_;
};

} // namespace hygroloom
