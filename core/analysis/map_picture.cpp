// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/map_picture.h"

#include "core/analysis/cell_map.h"
#include "core/base/error.h"
#include "core/base/units.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {

namespace {

MapPicture captioned(const RunRecord& run, const Frame& frame, CellMap map, const std::string& what)
{
    MapPicture picture;
    picture.width = run.textile.ends() * run.textile.warp.pitch;
    picture.height = run.textile.picks() * run.textile.weft.pitch;
    picture.image.captions = {
        fmt::format("{}, {}", run.fabric, run.experiment),
        fmt::format("{} after {:.4g} s, cells of {} × {}", what, frame.time, map.crossings_per_cell, map.crossings_per_cell)};
    picture.map = std::move(map);
    return picture;
}

} // namespace

MapPicture quantity_picture(const RunRecord& run, const Frame& frame, ShownQuantity quantity, MapSide side, int crossings_per_cell)
{
    if (const std::string why = why_not_shown(run.plan, quantity); !why.empty()) throw Error(why);
    const char* what = quantity == ShownQuantity::temperature ? "temperature" : "relative humidity in the yarns";
    const char* where = side == MapSide::top ? "top face, " : side == MapSide::bottom ? "bottom face, " : "";
    MapPicture picture =
        captioned(run, frame, quantity_map(run.textile, frame, quantity, side, crossings_per_cell), fmt::format("{}{}", where, what));
    picture.image.range = range_of_values(frame, quantity);
    return picture;
}

MapPicture map_picture(const RunRecord& run, const Frame& frame, const Frame& start, MapSide side, int crossings_per_cell,
                       const ReaderUnits& units)
{
    const Textile& t = run.textile;
    const char* what = side == MapSide::top ? "top face" : side == MapSide::bottom ? "bottom face" : "water";
    MapPicture picture = captioned(run, frame, cell_map(t, frame, start, side, crossings_per_cell), what);
    picture.image.units = units;
    if (side == MapSide::total) return picture;
    const Circle circle = wetted_circle(t, frame, side == MapSide::top ? Face::top : Face::bottom);
    if (circle.radius > 0) {
        picture.image.circle = circle;
        const ReaderUnit own = reader_unit(units, "mm");
        picture.image.captions.push_back(fmt::format("wetted radius {:.3g} {}", own.of(mm_from_metre(circle.radius)), own.unit));
    }
    return picture;
}

void write_picture(const MapPicture& picture, const std::filesystem::path& path)
{
    write_png(draw_map(picture.map, picture.width, picture.height, picture.image), path);
}

void share_scale(const std::vector<MapPicture*>& pictures)
{
    double most = 0;
    for (const MapPicture* picture : pictures) most = std::max(most, picture->map.maximum());
    for (MapPicture* picture : pictures) picture->image.most = most;
}

std::vector<ReportPicture> pictures_on_one_scale(std::vector<std::pair<std::string, MapPicture>> maps)
{
    std::vector<MapPicture*> all;
    all.reserve(maps.size());
    for (std::pair<std::string, MapPicture>& each : maps) all.push_back(&each.second);
    share_scale(all);
    std::vector<ReportPicture> pictures;
    pictures.reserve(maps.size());
    for (const auto& [caption, map] : maps) pictures.push_back({caption, draw_map(map.map, map.width, map.height, map.image)});
    return pictures;
}

std::vector<ReportPicture> pictures_of_faces(const RunRecord& run, const Frame& frame, const Frame& start, int crossings_per_cell,
                                             const ReaderUnits& units)
{
    const auto picture = [&](MapSide side) { return map_picture(run, frame, start, side, crossings_per_cell, units); };
    return pictures_on_one_scale({{fmt::format("Top face after {:.4g} s", frame.time), picture(MapSide::top)},
                                  {fmt::format("Bottom face after {:.4g} s", frame.time), picture(MapSide::bottom)}});
}

} // namespace hygroloom
