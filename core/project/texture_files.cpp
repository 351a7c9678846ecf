// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/project/texture_files.h"

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/geometry/top_view.h"
#include "core/project/export_private.h"
#include "core/project/mesh_file.h"
#include "core/project/wet_look.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

constexpr int finer = 3; ///< points a pixel, each way
constexpr double mm_per_inch = 25.4;

using Light = std::array<double, 3>; ///< linear, 0 .. 1

Light light_of(const Fabric& fabric, const Textile& textile, YarnKind kind, int yarn)
{
    const Color color = yarn_in(fabric, kind == YarnKind::warp, textile.yarn_number(kind, yarn)).color.value_or(undyed);
    return {linear_light(color.red), linear_light(color.green), linear_light(color.blue)};
}

/// As sRGB has it (IEC 61966-2-1).
std::uint8_t encoded(double linear)
{
    const double value = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}
std::uint8_t in_byte(double share) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0))); }

/// Of every yarn, those beside the region first and last.
struct Colours {
    std::vector<Light> warp, weft;
    Light mean{}; ///< of holes, that no other colour shines in at their edges

    Colours(const Fabric& fabric, const Textile& textile)
    {
        for (int end = -1; end <= textile.ends(); ++end) warp.push_back(light_of(fabric, textile, YarnKind::warp, end));
        for (int pick = -1; pick <= textile.picks(); ++pick) weft.push_back(light_of(fabric, textile, YarnKind::weft, pick));
        for (const std::vector<Light>* system : {&warp, &weft})
            for (const Light& light : *system)
                for (std::size_t k = 0; k < 3; ++k) mean[k] += 0.5 * light[k] / static_cast<double>(system->size());
    }
    const Light& of(const TopPoint& seen) const { return (seen.kind == YarnKind::warp ? warp : weft)[seen.yarn + 1]; }
};

/// One pixel, the mean of its points; writes to its own place in each picture. Returns how many points are open.
int fill_pixel(const TopView& view, const Colours& colours, double wet_share, int column, int row, TexturePixels& made)
{
    Light light{};
    Vec3d normal;
    int covered = 0;
    for (int i = 0; i < finer; ++i)
        for (int j = 0; j < finer; ++j) {
            const TopPoint seen = view.at(finer * column + i, finer * row + j);
            if (seen.open) continue;
            ++covered;
            normal += seen.normal;
            for (std::size_t k = 0; k < 3; ++k) light[k] += colours.of(seen)[k];
        }
    for (std::size_t k = 0; k < 3; ++k) light[k] = covered > 0 ? light[k] / covered : colours.mean[k];
    normal = covered > 0 && length(normal) > 0 ? (1 / length(normal)) * normal : Vec3d{0, 0, 1};
    const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(made.columns) + static_cast<std::size_t>(column);
    made.opacity[at] = in_byte(static_cast<double>(covered) / (finer * finer));
    made.colour[4 * at + 3] = made.wet[4 * at + 3] = made.opacity[at];
    const std::array<double, 3> direction{normal.x, normal.y, normal.z};
    for (std::size_t k = 0; k < 3; ++k) {
        made.colour[4 * at + k] = encoded(light[k]);
        made.wet[4 * at + k] = encoded(reflectance_at(light[k], wet_share));
        made.normal[3 * at + k] = in_byte(0.5 + 0.5 * direction[k]);
    }
    return finer * finer - covered;
}

} // namespace

TextureSize texture_size(const Textile& textile, double dpi)
{
    TextureSize size;
    size.width_mm = mm_from_metre(textile.ends() * textile.warp.pitch);
    size.height_mm = mm_from_metre(textile.picks() * textile.weft.pitch);
    const double columns = std::round(size.width_mm / mm_per_inch * dpi), rows = std::round(size.height_mm / mm_per_inch * dpi);
    if (!(columns <= largest_texture && rows <= largest_texture))
        throw Error(fmt::format("At {:g} dpi {:.4g} x {:.4g} mm are {:.0f} x {:.0f} pixels; at most {} a side are written. Take fewer dpi "
                                "or repeats.",
                                dpi, size.width_mm, size.height_mm, columns, rows, largest_texture));
    size.columns = std::max(1, static_cast<int>(columns));
    size.rows = std::max(1, static_cast<int>(rows));
    return size;
}

TexturePixels texture_pixels(const Textile& textile, const Fabric& fabric, const TextureSize& size, double wet_share,
                             const ExportProgress& progress)
{
    const TopView view(textile, finer * size.columns, finer * size.rows);
    const Colours colours(fabric, textile);
    TexturePixels made;
    made.columns = size.columns;
    made.rows = size.rows;
    const std::size_t pixels = static_cast<std::size_t>(size.columns) * static_cast<std::size_t>(size.rows);
    made.colour.resize(4 * pixels);
    made.wet.resize(4 * pixels);
    made.normal.resize(3 * pixels);
    made.opacity.resize(pixels);
    made.roughness.assign(pixels, in_byte(dry_roughness));
    made.wet_roughness.assign(pixels, in_byte(roughness_at(wet_share)));
    std::vector<std::int64_t> open(static_cast<std::size_t>(size.rows), 0);
    constexpr int rows_at_once = 64;
    for (int first = 0; first < size.rows; first += rows_at_once) {
        if (progress && !progress(static_cast<double>(first) / size.rows)) throw Cancelled();
        tbb::parallel_for(first, std::min(first + rows_at_once, size.rows), [&](int row) {
            for (int column = 0; column < size.columns; ++column) open[row] += fill_pixel(view, colours, wet_share, column, row, made);
        });
    }
    for (const std::int64_t points : open) made.open_share += static_cast<double>(points) / (finer * finer * static_cast<double>(pixels));
    return made;
}

} // namespace hygroloom
