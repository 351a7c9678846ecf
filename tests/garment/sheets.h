// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Flat sheets of cloth as meshes in OBJ, GLB and PLY, of which a test knows every area.
#pragma once

#include "core/garment/pattern.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <string>

namespace hygroloom {

/// A sheet that hangs in space, divided into squares; its flat coordinates are its own metres, from a corner.
struct Sheet {
    std::string name;
    std::vector<Vec3d> places;
    std::vector<FlatPlace> uv;
    std::vector<std::array<int, 3>> triangles;
    int across = 0, along = 0;

    int at(int i, int k) const { return k * (across + 1) + i; }
};

inline Sheet sheet(const std::string& name, double left, double width, double height, int across, int along)
{
    Sheet made{name, {}, {}, {}, across, along};
    for (int k = 0; k <= along; ++k)
        for (int i = 0; i <= across; ++i) {
            const double x = width * i / across, y = height * k / along;
            made.places.push_back({left + x, 1 + y, 0.12});
            made.uv.push_back({left + x, y});
            if (i == across || k == along) continue;
            const int a = made.at(i, k), b = made.at(i + 1, k), c = made.at(i + 1, k + 1), d = made.at(i, k + 1);
            made.triangles.push_back({a, b, c});
            made.triangles.push_back({a, c, d});
        }
    return made;
}

/// Two sheets beside each other, 0.2 m2 each.
inline std::vector<Sheet> two_sheets(int across = 8, int along = 8)
{
    return {sheet("left", -0.5, 0.4, 0.5, across, along), sheet("right", 0.1, 0.4, 0.5, across, along)};
}

inline std::string obj_of(const std::vector<Sheet>& sheets)
{
    std::string text;
    int first = 1;
    for (const Sheet& one : sheets) {
        text += "g " + one.name + "\n";
        for (const Vec3d& p : one.places) text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
        for (const FlatPlace& p : one.uv) text += fmt::format("vt {:.9g} {:.9g}\n", p[0], p[1]);
        for (const auto& [a, b, c] : one.triangles) text += fmt::format("f {0}/{0} {1}/{1} {2}/{2}\n", first + a, first + b, first + c);
        first += static_cast<int>(one.places.size());
    }
    return text;
}

template <typename T> void append(std::string& bytes, T value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); }

/// How a GLB has its numbers.
struct GlbForm {
    int uv_type = 5126;     ///< float; 5120 byte, 5121 unsigned byte, 5122 short, 5123 unsigned short, all normalized
    bool quantized = false; ///< places in unsigned shorts, put right by the node
    std::vector<std::string> nodes = {};
    std::size_t roots = 0;  ///< of these nodes; 0: all
    std::string extra = {}; ///< keys of the file
};

inline void append_uv(std::string& bytes, const FlatPlace& uv, int type)
{
    for (const double number : {uv[0], 1 - uv[1]}) { // downwards
        switch (type) {
        case 5120: append(bytes, static_cast<std::int8_t>(std::lround(127 * number))); break;
        case 5121: append(bytes, static_cast<std::uint8_t>(std::lround(255 * number))); break;
        case 5122: append(bytes, static_cast<std::int16_t>(std::lround(32767 * number))); break;
        case 5123: append(bytes, static_cast<std::uint16_t>(std::lround(65535 * number))); break;
        default: append(bytes, static_cast<float>(number));
        }
    }
}

/// A mesh and a node for each sheet; form.nodes replaces the nodes.
inline std::string glb_of(const std::vector<Sheet>& sheets, const GlbForm& form = {})
{
    std::string bin, views, accessors, meshes, nodes;
    int number = 0;
    const auto end = [&](std::size_t first, std::size_t stride, int type, std::size_t count, const char* kind, bool normalized) {
        views += fmt::format("{}{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{}{}}}", number > 0 ? "," : "", first, bin.size() - first,
                             stride > 0 ? fmt::format(",\"byteStride\":{}", stride) : "");
        accessors += fmt::format("{}{{\"bufferView\":{},\"componentType\":{},\"count\":{},\"type\":\"{}\"{}}}", number > 0 ? "," : "",
                                 number, type, count, kind, normalized ? ",\"normalized\":true" : "");
        while (bin.size() % 4 != 0) bin += '\0';
        ++number;
    };
    for (std::size_t s = 0; s < sheets.size(); ++s) {
        const Sheet& one = sheets[s];
        std::size_t first = bin.size();
        for (const Vec3d& p : one.places)
            for (const double value : {p.x, p.y, p.z})
                if (form.quantized)
                    append(bin, static_cast<std::uint16_t>(std::lround((value + 1) * 20000)));
                else
                    append(bin, static_cast<float>(value));
        end(first, 0, form.quantized ? 5123 : 5126, one.places.size(), "VEC3", false);
        first = bin.size();
        for (const FlatPlace& uv : one.uv) append_uv(bin, uv, form.uv_type);
        end(first, 0, form.uv_type, one.uv.size(), "VEC2", form.uv_type != 5126);
        first = bin.size();
        for (const auto& triangle : one.triangles)
            for (const int corner : triangle) append(bin, static_cast<std::uint16_t>(corner));
        end(first, 0, 5123, 3 * one.triangles.size(), "SCALAR", false);
        meshes += fmt::format("{}{{\"primitives\":[{{\"attributes\":{{\"POSITION\":{},\"TEXCOORD_0\":{}}},\"indices\":{}}}]}}",
                              s > 0 ? "," : "", number - 3, number - 2, number - 1);
        const char* const placed = form.quantized ? ",\"scale\":[5e-5,5e-5,5e-5],\"translation\":[-1,-1,-1]" : "";
        nodes += fmt::format("{}{{\"mesh\":{},\"name\":\"{}\"{}}}", s > 0 ? "," : "", s, one.name, placed);
    }
    if (!form.nodes.empty()) nodes = fmt::format("{}", fmt::join(form.nodes, ","));
    const std::size_t count = form.roots > 0 ? form.roots : form.nodes.empty() ? sheets.size() : form.nodes.size();
    std::string roots;
    for (std::size_t i = 0; i < count; ++i) roots += (i > 0 ? "," : "") + std::to_string(i);
    std::string json = fmt::format("{{\"asset\":{{\"version\":\"2.0\"}},\"scene\":0,\"scenes\":[{{\"nodes\":[{}]}}],\"nodes\":[{}],"
                                   "\"meshes\":[{}],\"buffers\":[{{\"byteLength\":{}}}],\"bufferViews\":[{}],\"accessors\":[{}]{}}}",
                                   roots, nodes, meshes, bin.size(), views, accessors, form.extra);
    while (json.size() % 4 != 0) json += ' ';
    std::string glb = "glTF";
    append(glb, std::uint32_t{2});
    append(glb, static_cast<std::uint32_t>(28 + json.size() + bin.size()));
    append(glb, static_cast<std::uint32_t>(json.size()));
    append(glb, std::uint32_t{0x4E4F534A});
    glb += json;
    append(glb, static_cast<std::uint32_t>(bin.size()));
    append(glb, std::uint32_t{0x004E4942});
    return glb + bin;
}

enum class PlyForm { text, little, big };

/// Flat coordinates with the vertices.
inline std::string ply_of(const std::vector<Sheet>& sheets, PlyForm form)
{
    std::size_t places = 0, faces = 0;
    for (const Sheet& one : sheets) {
        places += one.places.size();
        faces += one.triangles.size();
    }
    constexpr const char* forms[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    std::string bytes =
        fmt::format("ply\nformat {} 1.0\ncomment a sheet\nelement vertex {}\nproperty float x\nproperty float y\nproperty float "
                    "z\nproperty float s\nproperty double t\nproperty uchar red\nelement face {}\nproperty list uchar int "
                    "vertex_indices\nend_header\n",
                    forms[static_cast<int>(form)], places, faces);
    const auto put = [&](auto value) {
        if (form == PlyForm::text) {
            bytes += fmt::format("{} ", value);
            return;
        }
        std::string own;
        append(own, value);
        if (form == PlyForm::big) own = {own.rbegin(), own.rend()};
        bytes += own;
    };
    for (const Sheet& one : sheets)
        for (std::size_t i = 0; i < one.places.size(); ++i) {
            const Vec3d& p = one.places[i];
            for (const double value : {p.x, p.y, p.z, one.uv[i][0]}) put(static_cast<float>(value));
            put(one.uv[i][1]);
            put(std::uint8_t{200});
            if (form == PlyForm::text) bytes += '\n';
        }
    int first = 0;
    for (const Sheet& one : sheets) {
        for (const auto& triangle : one.triangles) {
            put(std::uint8_t{3});
            for (const int corner : triangle) put(first + corner);
            if (form == PlyForm::text) bytes += '\n';
        }
        first += static_cast<int>(one.places.size());
    }
    return bytes;
}

} // namespace hygroloom
