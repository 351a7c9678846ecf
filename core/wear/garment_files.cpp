// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A garment's shape with its maps as textures, for other programs: OBJ with MTL, and GLB.
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/project/atomic_file.h"
#include "core/wear/wear_map.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <map>
#include <set>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

/// The vertices and triangles of one panel. Texture coordinates from the lower left corner of its outline's box.
struct PanelMesh {
    std::vector<std::array<float, 3>> places;
    std::vector<std::array<float, 2>> texture;
    std::vector<std::uint32_t> corners;
};

PanelMesh mesh_of(const WearLayout& layout, std::size_t panel)
{
    const FlatBox box = layout.panels[panel].box();
    PanelMesh mesh;
    std::map<int, std::uint32_t> known;
    const GarmentShape& shape = layout.shape;
    for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
        if (static_cast<std::size_t>(shape.panel[t]) != panel) continue;
        for (int vertex : shape.triangles[t]) {
            const auto [at, is_new] = known.try_emplace(vertex, static_cast<std::uint32_t>(mesh.places.size()));
            mesh.corners.push_back(at->second);
            if (!is_new) continue;
            const Vec3d& place = shape.places[static_cast<std::size_t>(vertex)];
            const FlatPlace& flat = shape.flat[static_cast<std::size_t>(vertex)];
            mesh.places.push_back({static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z)});
            mesh.texture.push_back(
                {static_cast<float>((flat[0] - box.left) / box.width()), static_cast<float>((flat[1] - box.low) / box.height())});
        }
    }
    return mesh;
}

constexpr const char* texture_ending = "_texture";

/// Panels' names as names of files: no two alike, nor one like the name of another's texture.
std::vector<std::string> file_names(const WearLayout& layout)
{
    std::vector<std::string> names;
    std::set<std::string> taken{"cells", "garment"};
    for (const WearPanel& panel : layout.panels) {
        std::string name;
        for (char letter : panel.name) {
            const auto byte = static_cast<unsigned char>(letter);
            name += byte < 0x80 && !std::isalnum(byte) && letter != '-' ? '_' : letter;
        }
        name = name.empty() ? "panel" : cut_text(name, 100);
        std::string free = name;
        for (int k = 2; taken.contains(free) || taken.contains(free + texture_ending); ++k) free = fmt::format("{}_{}", name, k);
        taken.insert({free, free + texture_ending});
        names.push_back(free);
    }
    return names;
}

struct Glb {
    Json json{{"asset", {{"version", "2.0"}, {"generator", "Hygroloom"}}}, {"scene", 0}};
    std::string bytes;

    /// The number of the view.
    std::size_t add(const void* data, std::size_t size, int target)
    {
        while (bytes.size() % 4 != 0) bytes += '\0';
        Json view{{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}};
        if (target != 0) view["target"] = target;
        bytes.append(static_cast<const char*>(data), size);
        json["bufferViews"].push_back(std::move(view));
        return json["bufferViews"].size() - 1;
    }
    std::size_t access(std::size_t view, int component, std::size_t count, const char* type)
    {
        json["accessors"].push_back({{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
        return json["accessors"].size() - 1;
    }
    std::string file()
    {
        json["buffers"] = Json::array({{{"byteLength", bytes.size()}}});
        std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
        while (text.size() % 4 != 0) text += ' ';
        while (bytes.size() % 4 != 0) bytes += '\0';
        std::string made;
        const auto put = [&](std::size_t value) {
            const auto number = static_cast<std::uint32_t>(value);
            made.append(reinterpret_cast<const char*>(&number), sizeof number);
        };
        put(0x46546C67);
        put(2);
        put(12 + 8 + text.size() + 8 + bytes.size());
        put(text.size());
        put(0x4E4F534A);
        made += text;
        put(bytes.size());
        put(0x004E4942);
        return made + bytes;
    }
};

void add_panel(Glb& glb, const WearPanel& panel, const PanelMesh& mesh, const std::string& png)
{
    constexpr int array_buffer = 34962, element_buffer = 34963, is_float = 5126, is_uint = 5125;
    std::vector<std::array<float, 2>> texture = mesh.texture;
    std::array<float, 3> low = mesh.places.front(), high = low;
    for (std::array<float, 2>& uv : texture) uv[1] = 1 - uv[1]; // there they count from above
    for (const std::array<float, 3>& place : mesh.places)
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], place[k]);
            high[k] = std::max(high[k], place[k]);
        }
    const std::size_t places =
        glb.access(glb.add(mesh.places.data(), 12 * mesh.places.size(), array_buffer), is_float, mesh.places.size(), "VEC3");
    glb.json["accessors"][places]["min"] = low;
    glb.json["accessors"][places]["max"] = high;
    const std::size_t uv = glb.access(glb.add(texture.data(), 8 * texture.size(), array_buffer), is_float, texture.size(), "VEC2");
    const std::size_t corners =
        glb.access(glb.add(mesh.corners.data(), 4 * mesh.corners.size(), element_buffer), is_uint, mesh.corners.size(), "SCALAR");
    const std::size_t image = glb.add(png.data(), png.size(), 0), number = glb.json["images"].size();
    glb.json["images"].push_back({{"bufferView", image}, {"mimeType", "image/png"}, {"name", panel.name}});
    glb.json["textures"].push_back({{"source", number}});
    glb.json["materials"].push_back(
        {{"name", panel.name},
         {"doubleSided", true},
         {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", number}}}, {"metallicFactor", 0}, {"roughnessFactor", 0.9}}}});
    glb.json["meshes"].push_back(
        {{"name", panel.name},
         {"primitives",
          Json::array({{{"attributes", {{"POSITION", places}, {"TEXCOORD_0", uv}}}, {"indices", corners}, {"material", number}}})}});
    glb.json["nodes"].push_back({{"name", panel.name}, {"mesh", number}});
    glb.json["scenes"][0]["nodes"].push_back(number);
}

} // namespace

std::vector<std::string> write_wear_map(const WearLayout& layout, const WearFrame& frame, const WearMap& map,
                                        const std::filesystem::path& folder)
{
    std::vector<std::string> files;
    const auto write = [&](const std::string& name, const std::string& bytes) {
        write_file(folder / name, bytes);
        files.push_back(name);
    };
    const std::vector<std::string> names = file_names(layout);
    std::string obj = "# Hygroloom: lengths in m\nmtllib garment.mtl\n", mtl;
    Glb glb;
    std::size_t first = 1;
    for (std::size_t panel = 0; panel < layout.panels.size(); ++panel) {
        const std::string texture = png_bytes(panel_texture(layout, map, panel));
        write(names[panel] + ".png", png_bytes(panel_picture(layout, map, panel, frame.time)));
        write(names[panel] + texture_ending + ".png", texture);
        const PanelMesh mesh = mesh_of(layout, panel);
        if (mesh.places.empty()) continue;
        mtl += fmt::format("newmtl {0}\nKd 1 1 1\nmap_Kd {0}{1}.png\n", names[panel], texture_ending);
        obj += fmt::format("o {0}\nusemtl {0}\n", names[panel]);
        for (const std::array<float, 3>& at : mesh.places) obj += fmt::format("v {:.6f} {:.6f} {:.6f}\n", at[0], at[1], at[2]);
        for (const std::array<float, 2>& at : mesh.texture) obj += fmt::format("vt {:.6f} {:.6f}\n", at[0], at[1]);
        for (std::size_t t = 0; t + 2 < mesh.corners.size(); t += 3)
            obj += fmt::format("f {0}/{0} {1}/{1} {2}/{2}\n", first + mesh.corners[t], first + mesh.corners[t + 1],
                               first + mesh.corners[t + 2]);
        first += mesh.places.size();
        add_panel(glb, layout.panels[panel], mesh, texture);
    }
    write("cells.csv", wear_csv(layout, frame));
    write_cells_vtk(layout, frame, folder / "cells.vtp");
    files.emplace_back("cells.vtp");
    write("garment.obj", obj);
    write("garment.mtl", mtl);
    write("garment.glb", glb.file());
    return files;
}

} // namespace hygroloom
