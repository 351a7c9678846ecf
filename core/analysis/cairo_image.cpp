// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/cairo_image.h"

#include "core/base/error.h"

#include <fmt/format.h>

#include <cstring>

namespace hygroloom {

Image image_from(cairo_t* cairo)
{
    cairo_surface_t* const surface = cairo_get_target(cairo);
    cairo_surface_flush(surface);
    if (const cairo_status_t status = cairo_status(cairo); status != CAIRO_STATUS_SUCCESS)
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
