// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/garment/pattern.h"

#include "core/base/error.h"
#include "core/garment/fill.h"
#include "core/garment/odd_shapes.h"
#include "core/garment/readers.h"
#include "core/project/atomic_file.h"

#include <fmt/format.h>

namespace hygroloom {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_segmentation_bytes = 64u << 20;

/// A name without the endings that pattern programs give.
std::string stem_of(const fs::path& path)
{
    std::string stem = path.stem().string();
    for (const char* ending : {"_specification", "_sim"})
        if (stem.ends_with(ending)) stem.erase(stem.size() - std::string(ending).size());
    return stem;
}

bool is_file(const fs::path& path)
{
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

/// A pattern with its drape beside it, or flat.
GarmentPattern with_drape(const fs::path& json, const fs::path& obj, const fs::path& segmentation, UvUnit unit)
{
    GarmentPattern pattern = pattern_from_json(read_file(json, largest_pattern_bytes), json.string());
    if (is_file(obj) && is_file(segmentation)) {
        take_drape(pattern, read_file(obj, largest_mesh_bytes), read_file(segmentation, largest_segmentation_bytes), obj.string());
        pattern.issues.push_back(fmt::format("The draped shape was taken from {}.", obj.filename().string()));
        if (unit != UvUnit::from_lengths) pattern.issues.emplace_back("uv_unit was not used: the scale of a drape comes from its pattern.");
    } else {
        make_flat_shape(pattern);
    }
    find_body(pattern);
    tell_odd_shapes(pattern);
    return pattern;
}

} // namespace

GarmentPattern read_pattern(const Garment& garment, const fs::path& base, const Asked& cancelled)
{
    if (garment.is_built_in()) return built_in_pattern(garment.built_in);
    const fs::path path = base / garment.source;
    const std::string stem = stem_of(path);
    const fs::path obj = path.parent_path() / (stem + "_sim.obj"), segmentation = path.parent_path() / (stem + "_sim_segmentation.txt");
    if (garment.is_pattern()) return with_drape(path, obj, segmentation, garment.uv_unit);
    if (path.filename() == obj.filename() && is_file(segmentation))
        for (const char* ending : {"_specification.json", ".json"})
            if (const fs::path json = path.parent_path() / (stem + ending); is_file(json))
                return with_drape(json, obj, segmentation, garment.uv_unit);
    return pattern_from_mesh(path, garment.uv_unit, cancelled);
}

} // namespace hygroloom
