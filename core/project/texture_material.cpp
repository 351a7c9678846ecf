// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The files of a fabric's textures: pictures, materials as glTF and as MTL, a plane that carries them, and what they are in words.
#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "core/project/texture_files.h"
#include "core/project/wet_look.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <png.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

constexpr double least_solid = 0.999; ///< opacity of a cloth that renderers need not look through
constexpr double plane_mm = 50;       ///< a side of the plane, about

std::string png_of(png_uint_32 format, const TexturePixels& pixels, const std::vector<std::uint8_t>& bytes)
{
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(pixels.columns);
    png.height = static_cast<png_uint_32>(pixels.rows);
    png.format = format;
    png_alloc_size_t size = 0;
    std::string file;
    bool made = png_image_write_to_memory(&png, nullptr, &size, 0, bytes.data(), 0, nullptr) != 0;
    if (made) {
        file.resize(size);
        made = png_image_write_to_memory(&png, file.data(), &size, 0, bytes.data(), 0, nullptr) != 0;
        file.resize(size);
    }
    if (!made) throw Error(std::string("The picture cannot be made: ") + png.message);
    return file;
}

bool has_holes(const TexturePixels& pixels) { return 1 - pixels.open_share < least_solid; }

Json material_json(const std::string& name, int colour, int roughness, bool holes)
{
    Json material{{"name", name},
                  {"doubleSided", true},
                  {"alphaMode", holes ? "MASK" : "OPAQUE"},
                  {"pbrMetallicRoughness",
                   {{"baseColorTexture", {{"index", colour}}},
                    {"metallicRoughnessTexture", {{"index", roughness}}},
                    {"metallicFactor", 0},
                    {"roughnessFactor", 1}}},
                  {"normalTexture", {{"index", 1}, {"scale", 1}}}};
    if (holes) material["alphaCutoff"] = 0.5;
    return material;
}

Json materials_json(const Fabric& fabric, const TextureSize& size, const TextureRequest& request, const TexturePixels& pixels)
{
    Json json{{"asset", {{"version", "2.0"}, {"generator", "Hygroloom"}}}};
    json["samplers"] = Json::array({{{"wrapS", 10497}, {"wrapT", 10497}}}); // repeat
    int number = 0;
    for (const char* picture : {"colour.png", "normal.png", "roughness.png", "colour_wet.png", "roughness_wet.png"}) {
        json["images"].push_back({{"uri", picture}});
        json["textures"].push_back({{"source", number++}, {"sampler", 0}});
    }
    const bool holes = has_holes(pixels);
    json["materials"] = {material_json(fabric.name, 0, 2, holes), material_json(fabric.name + ", wet", 3, 4, holes)};
    json["extras"] = {{"width_mm", size.width_mm},
                      {"height_mm", size.height_mm},
                      {"open_share", pixels.open_share},
                      {"wet_share", request.wet_share},
                      {"opacity", "opacity.png"}};
    return json;
}

/// Two planes side by side, dry and wet, each of as many tiles as make about 50 mm. Places, normals, texture coordinates, then corners.
std::string add_planes(Json& json, const TextureSize& size)
{
    const auto tiles = [](double mm) { return std::max(1.0, std::round(plane_mm / mm)); };
    const double across = tiles(size.width_mm), along = tiles(size.height_mm);
    const auto width = static_cast<float>(1e-3 * across * size.width_mm), height = static_cast<float>(1e-3 * along * size.height_mm);
    const auto u = static_cast<float>(across), v = static_cast<float>(along);
    const std::array<float, 12> places{0, 0, 0, width, 0, 0, width, height, 0, 0, height, 0};
    const std::array<float, 12> normals{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
    const std::array<float, 8> uvs{0, v, u, v, u, 0, 0, 0};
    const std::array<std::uint16_t, 6> corners{0, 1, 2, 0, 2, 3};
    std::string bytes;
    const auto add = [&](const auto& values, int component, std::size_t count, const char* type, int target) {
        const std::size_t length = sizeof values;
        json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", length}, {"target", target}});
        json["accessors"].push_back(
            {{"bufferView", json["bufferViews"].size() - 1}, {"componentType", component}, {"count", count}, {"type", type}});
        bytes.append(reinterpret_cast<const char*>(values.data()), length);
    };
    constexpr int is_float = 5126, is_short = 5123, array_buffer = 34962, element_buffer = 34963;
    add(places, is_float, 4, "VEC3", array_buffer);
    json["accessors"][0]["min"] = {0, 0, 0};
    json["accessors"][0]["max"] = {width, height, 0};
    add(normals, is_float, 4, "VEC3", array_buffer);
    add(uvs, is_float, 4, "VEC2", array_buffer);
    add(corners, is_short, 6, "SCALAR", element_buffer);
    json["buffers"] = Json::array({{{"uri", "plane.bin"}, {"byteLength", bytes.size()}}});
    for (int material = 0; material < 2; ++material) {
        const Json attributes{{"POSITION", 0}, {"NORMAL", 1}, {"TEXCOORD_0", 2}};
        json["meshes"].push_back({{"primitives", Json::array({{{"attributes", attributes}, {"indices", 3}, {"material", material}}})}});
        json["nodes"].push_back({{"name", material == 0 ? "dry" : "wet"}, {"mesh", material}});
    }
    json["nodes"][1]["translation"] = {1.1 * static_cast<double>(width), 0, 0};
    json["scenes"] = Json::array({{{"nodes", {0, 1}}}});
    json["scene"] = 0;
    return bytes;
}

std::string mtl_of(const TexturePixels& pixels)
{
    std::string text = "# Hygroloom. norm, map_Pr and Pm are of the usual extension for physically based rendering\n";
    for (const auto& [name, colour, roughness] :
         {std::array{"dry", "colour.png", "roughness.png"}, std::array{"wet", "colour_wet.png", "roughness_wet.png"}}) {
        text += fmt::format("newmtl {}\nKd 1 1 1\nmap_Kd {}\nnorm normal.png\nmap_Pr {}\nPm 0\n", name, colour, roughness);
        if (has_holes(pixels)) text += "map_d opacity.png\n";
    }
    return text;
}

std::string readme_of(const Fabric& fabric, const TextureSize& size, const TextureRequest& request, const TexturePixels& pixels)
{
    return fmt::format(
        "{}: {} x {} repeats of its weave and of its yarns' order, seen from the top face. The warp runs upwards.\n\n"
        "The pictures show {:.4f} x {:.4f} mm in {} x {} pixels (asked for {:g} dpi) and go on in themselves on all sides.\n"
        "In a program that takes textures by size, give these millimetres; in one that takes repeats, one repeat is one picture.\n"
        "{:.2f} % of the area are open.\n\n"
        "colour.png         base colour (sRGB), opacity as alpha. Yarns have their colours from the project, evenly lit\n"
        "normal.png         normals of the yarns' skins, y upwards (as glTF and OpenGL have it; for DirectX turn green over)\n"
        "roughness.png      0.9 for dry cloth: an assumption\n"
        "opacity.png        share of each pixel that yarns cover\n"
        "colour_wet.png     the same where {:.0f} % of the surface is wet: Lekner and Dorf 1988, doi 10.1364/AO.27.001278. A film of "
        "water\n"
        "                   (refractive index {}) throws {:.1f} % of the light that leaves the cloth back onto it\n"
        "roughness_wet.png  {:.2f}: {} for wet cloth is an assumption\n"
        "material.json      both as materials of glTF 2.0; plane.gltf shows them; material.mtl has them for OBJ\n\n"
        "Yarns are drawn as smooth tubes: fibres, loops and hairs are not in the pictures.\n",
        fabric.name, request.across, request.along, size.width_mm, size.height_mm, size.columns, size.rows, request.dpi,
        100 * pixels.open_share, 100 * request.wet_share, water_index, 100 * inner_reflection(water_index), roughness_at(request.wet_share),
        wet_roughness);
}

} // namespace

std::vector<std::string> write_textures(const Textile& textile, const Fabric& fabric, const TextureRequest& request,
                                        const std::filesystem::path& folder, const ExportProgress& progress)
{
    const TextureSize size = texture_size(textile, request.dpi);
    const TexturePixels pixels = texture_pixels(textile, fabric, size, request.wet_share, progress);
    std::vector<std::string> files;
    const auto write = [&](const char* name, const std::string& bytes) {
        write_file(folder / name, bytes);
        files.emplace_back(name);
    };
    write("colour.png", png_of(PNG_FORMAT_RGBA, pixels, pixels.colour));
    write("normal.png", png_of(PNG_FORMAT_RGB, pixels, pixels.normal));
    write("roughness.png", png_of(PNG_FORMAT_GRAY, pixels, pixels.roughness));
    write("opacity.png", png_of(PNG_FORMAT_GRAY, pixels, pixels.opacity));
    write("colour_wet.png", png_of(PNG_FORMAT_RGBA, pixels, pixels.wet));
    write("roughness_wet.png", png_of(PNG_FORMAT_GRAY, pixels, pixels.wet_roughness));
    Json json = materials_json(fabric, size, request, pixels);
    const auto text = [](const Json& of) { return of.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; };
    write("material.json", text(json));
    write("material.mtl", mtl_of(pixels));
    write("plane.bin", add_planes(json, size));
    write("plane.gltf", text(json));
    write("README.txt", readme_of(fabric, size, request, pixels));
    return files;
}

} // namespace hygroloom
