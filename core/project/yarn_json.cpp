// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Reads a yarn: its fibres, its core, its size or count, its twist.
#include "core/design/yarn_count.h"
#include "core/project/color_text.h"
#include "core/project/field_json.h"
#include "core/project/project_json.h"

#include <fmt/format.h>

namespace hygroloom {
namespace {

std::vector<MaterialShare> read_blend(const ProjectJson& value, const std::string& file, const std::string& path)
{
    if (value.is_string()) return {{value.get<std::string>(), 1.0}};
    if (!value.is_array())
        throw FileError(
            fmt::format("{}: {}: This must be the name of a material or a list of shares; given is {}.", file, path, in_words(value)));
    std::vector<MaterialShare> shares;
    for (std::size_t i = 0; i < value.size(); ++i) {
        ObjectReader object(value[i], file, fmt::format("{}[{}]", path, i));
        MaterialShare share;
        object.read("name", share.name);
        object.read("share", share.share);
        object.finish({"name", "share"});
        shares.push_back(share);
    }
    return shares;
}

std::optional<Color> read_color(ObjectReader& object)
{
    std::string text;
    if (!object.find("color")) return {};
    object.read("color", text);
    const std::optional<Color> color = color_of(text);
    if (!color) object.refuse("color", fmt::format("This must be a colour as \"#rrggbb\"; given is {}.", in_words(text)));
    return color;
}

/// A count as the trade writes it stands for the linear density, the plies and, where it names them, the filaments.
void read_count(ObjectReader& object, Yarn& yarn)
{
    const ProjectJson* given = object.find("count");
    if (!given) return;
    if (!given->is_string())
        object.refuse("count", fmt::format("This must be a text with its unit, such as {}; given is {}.", count_forms, in_words(*given)));
    const auto count = [&] {
        try {
            return read_yarn_count(given->get<std::string>());
        } catch (const Error& error) {
            object.refuse("count", error.what());
        }
    }();
    for (const char* other : {"linear_density_tex", "plies", "filament_count"})
        if (object.find(other) && (*other != 'f' || count.filaments))
            object.refuse(other, fmt::format("The count {} says this already; leave one of them out.", in_words(*given)));
    const std::optional<double> diameter = yarn.diameter_mm;
    set_count(yarn, count);
    yarn.diameter_mm = diameter;
}

} // namespace

Yarn yarn_from_json(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    Yarn yarn;
    if (const ProjectJson* material = object.find("material")) yarn.material = read_blend(*material, file, object.path_of("material"));
    if (const ProjectJson* given = object.find("core")) {
        ObjectReader core(*given, file, object.path_of("core"));
        core.read("material", yarn.core.emplace().material);
        read_fields(core, *yarn.core);
        core.finish({"material", "share"});
    }
    read_fields(object, yarn);
    read_count(object, yarn);
    yarn.color = read_color(object);
    object.read("library_yarn", yarn.library_yarn);
    object.finish({"material"});
    return yarn;
}

} // namespace hygroloom
