// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// glTF 2.0, as one .glb or as .gltf with .bin files: metres, y out of the top face. The JSON comes first in the file but holds each yarn's
// extremes, known last: its place is kept free and it is written at the end, each number in a fixed width.
#include "core/base/error.h"
#include "core/project/export_private.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace hygroloom {
namespace {

std::size_t stride_of(const ExportJob& job) { return (job.lines() ? 12u : 32u) + (job.wet() ? 8u : 0u); }

std::uint64_t vertex_bytes(const ExportJob& job, const GltfLayout::Yarn& yarn) { return stride_of(job) * yarn.size.vertices; }

/// Percent-encoded, as a URI wants it.
std::string uri_of(const std::string& name)
{
    std::string uri;
    for (char c : name) {
        const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_' || c == '.';
        uri += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    }
    return uri;
}

/// Always as wide; a float read back is the same.
std::string extremes(const std::array<float, 3>& v) { return fmt::format("[{: .8e},{: .8e},{: .8e}]", v[0], v[1], v[2]); }

std::string joined(const std::vector<std::string>& parts)
{
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : ",\n") + part;
    return text;
}

/// Fills one buffer after the other.
class Bins {
public:
    Bins(const ExportJob& job, const GltfLayout& layout, std::vector<OutputFile*> files, std::uint64_t begin)
        : job_(job), files_(std::move(files)), begin_(begin), yarns_(layout.yarns), vertices_(*files_[0], begin),
          indices_(*files_[0], begin)
    {
    }

    void write()
    {
        for_each_piece(job_, [this](const YarnMesh& piece) { add(piece); });
        vertices_.flush();
        indices_.flush();
    }
    /// With the extremes that were found.
    std::vector<GltfLayout::Yarn> yarns() && { return std::move(yarns_); }

private:
    void begin_next()
    {
        if (started_) ++current_;
        started_ = true;
        first_ = 0;
        GltfLayout::Yarn& yarn = yarns_[current_];
        yarn.low.fill(std::numeric_limits<float>::max());
        yarn.high.fill(std::numeric_limits<float>::lowest());
        vertices_.flush();
        indices_.flush();
        vertices_ = OutputRun(*files_[yarn.buffer], begin_ + yarn.vertices_at);
        indices_ = OutputRun(*files_[yarn.buffer], begin_ + yarn.indices_at);
    }

    void add(const YarnMesh& piece)
    {
        const MeshGroup& group = piece.groups[0];
        if (!started_ || yarns_[current_].kind != group.kind || yarns_[current_].yarn != group.yarn) begin_next();
        GltfLayout::Yarn& yarn = yarns_[current_];
        char* out = vertices_.room(stride_of(job_) * group.vertices);
        for (std::size_t i = 0; i < group.vertices; ++i) {
            const float* p = &piece.positions[3 * i];
            const std::array<float, 3> position{p[0], p[2], -p[1]};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                yarn.low[axis] = std::min(yarn.low[axis], position[axis]);
                yarn.high[axis] = std::max(yarn.high[axis], position[axis]);
            }
            std::memcpy(out, position.data(), 12);
            out += 12;
            if (!job_.lines()) {
                const float* n = &piece.normals[3 * i];
                const std::array<float, 3> normal{n[0], n[2], -n[1]};
                std::memcpy(out, normal.data(), 12);
                std::memcpy(out + 12, &piece.uvs[2 * i], 8);
                out += 20;
            }
            if (job_.wet()) {
                const Color color = job_.color(group.kind, group.yarn, piece.segment_of_vertex[i]);
                const std::array<std::uint16_t, 4> linear{linear_[color.red], linear_[color.green], linear_[color.blue], 65535};
                std::memcpy(out, linear.data(), 8);
                out += 8;
            }
        }
        char* index = indices_.room(4 * piece.indices.size());
        for (std::size_t i = 0; i < piece.indices.size(); ++i, index += 4) {
            const std::uint32_t corner = first_ + piece.indices[i];
            std::memcpy(index, &corner, 4);
        }
        first_ += static_cast<std::uint32_t>(group.vertices);
    }

    static std::array<std::uint16_t, 256> linear_table()
    {
        std::array<std::uint16_t, 256> table{};
        for (unsigned i = 0; i < 256; ++i)
            table[i] = static_cast<std::uint16_t>(std::lround(65535 * linear_light(static_cast<std::uint8_t>(i))));
        return table;
    }

    const ExportJob& job_;
    std::vector<OutputFile*> files_;
    std::uint64_t begin_;
    std::vector<GltfLayout::Yarn> yarns_;
    OutputRun vertices_, indices_;
    std::array<std::uint16_t, 256> linear_ = linear_table();
    std::size_t current_ = 0;
    std::uint32_t first_ = 0;
    bool started_ = false;
};

} // namespace

GltfLayout gltf_layout(const ExportJob& job)
{
    GltfLayout layout;
    layout.buffers.push_back(0);
    for_each_yarn(job.textile, [&](YarnKind kind, int number) {
        GltfLayout::Yarn yarn{kind, number, 0, 0, 0, job.size_of(kind, number), {}, {}};
        const std::uint64_t vertices = vertex_bytes(job, yarn), all = vertices + 12 * yarn.size.triangles;
        if (job.format == MeshFormat::gltf) {
            const std::uint64_t largest = job.options.largest_buffer;
            if (layout.buffers.back() > 0 && layout.buffers.back() + all > largest) layout.buffers.push_back(0);
            if (all > largest) layout.yarn_too_large = true;
        }
        yarn.buffer = layout.buffers.size() - 1;
        yarn.vertices_at = layout.buffers.back();
        yarn.indices_at = yarn.vertices_at + vertices;
        layout.buffers.back() += all;
        layout.yarns.push_back(yarn);
    });
    return layout;
}

std::string gltf_json(const ExportJob& job, const GltfLayout& layout, const std::vector<std::string>& buffer_names)
{
    std::vector<std::string> roots, nodes, meshes, materials, accessors, views, buffers;
    for (const YarnMaterial& material : job.materials)
        materials.push_back(fmt::format(
            R"({{"name":"{}","pbrMetallicRoughness":{{"baseColorFactor":[{:.6f},{:.6f},{:.6f},1],"metallicFactor":0,"roughnessFactor":0.9}}{}}})",
            material.name, linear_light(material.color.red), linear_light(material.color.green), linear_light(material.color.blue),
            job.options.mesh.capped ? "" : R"(,"doubleSided":true)"));
    for (std::size_t i = 0; i < layout.buffers.size(); ++i)
        buffers.push_back(buffer_names.empty()
                              ? fmt::format(R"({{"byteLength":{}}})", layout.buffers[i])
                              : fmt::format(R"({{"byteLength":{},"uri":"{}"}})", layout.buffers[i], uri_of(buffer_names[i])));
    const std::size_t stride = stride_of(job);
    for (const GltfLayout::Yarn& yarn : layout.yarns) {
        const std::string name = yarn_name(yarn.kind, yarn.yarn);
        roots.push_back(std::to_string(nodes.size() + 1));
        nodes.push_back(fmt::format(R"({{"name":"{}","mesh":{}}})", name, meshes.size()));
        const std::size_t view = views.size();
        views.push_back(fmt::format(R"({{"buffer":{},"byteOffset":{},"byteLength":{},"byteStride":{},"target":34962}})", yarn.buffer,
                                    yarn.vertices_at, vertex_bytes(job, yarn), stride));
        std::string attributes;
        const auto attribute = [&](const char* key, const char* type, int component, std::size_t offset, const std::string& rest) {
            attributes += fmt::format(R"({}"{}":{})", attributes.empty() ? "" : ",", key, accessors.size());
            accessors.push_back(fmt::format(R"({{"bufferView":{},"byteOffset":{},"componentType":{},"count":{},"type":"{}"{}}})", view,
                                            offset, component, yarn.size.vertices, type, rest));
        };
        attribute("POSITION", "VEC3", 5126, 0, fmt::format(R"(,"min":{},"max":{})", extremes(yarn.low), extremes(yarn.high)));
        if (!job.lines()) {
            attribute("NORMAL", "VEC3", 5126, 12, "");
            attribute("TEXCOORD_0", "VEC2", 5126, 24, "");
        }
        if (job.wet()) attribute("COLOR_0", "VEC4", 5123, stride - 8, R"(,"normalized":true)");
        const int material = job.material(yarn.kind, yarn.yarn);
        if (job.lines()) {
            meshes.push_back(fmt::format(R"({{"name":"{}","primitives":[{{"attributes":{{{}}},"material":{},"mode":3}}]}})", name,
                                         attributes, material));
            continue;
        }
        meshes.push_back(fmt::format(R"({{"name":"{}","primitives":[{{"attributes":{{{}}},"indices":{},"material":{}}}]}})", name,
                                     attributes, accessors.size(), material));
        accessors.push_back(
            fmt::format(R"({{"bufferView":{},"componentType":5125,"count":{},"type":"SCALAR"}})", views.size(), 3 * yarn.size.triangles));
        views.push_back(fmt::format(R"({{"buffer":{},"byteOffset":{},"byteLength":{},"target":34963}})", yarn.buffer, yarn.indices_at,
                                    12 * yarn.size.triangles));
    }
    std::string children;
    for (const std::string& root : roots) children += (children.empty() ? "" : ",") + root;
    return fmt::format("{{\"asset\":{{\"version\":\"2.0\",\"generator\":\"Hygroloom\"}},\"scene\":0,\"scenes\":[{{\"nodes\":[0]}}],\n"
                       "\"nodes\":[{{\"name\":\"textile\",\"children\":[{}]}},\n{}],\n\"meshes\":[{}],\n\"materials\":[{}],\n"
                       "\"accessors\":[{}],\n\"bufferViews\":[{}],\n\"buffers\":[{}]}}\n",
                       children, joined(nodes), joined(meshes), joined(materials), joined(accessors), joined(views), joined(buffers));
}

void write_glb(const ExportJob& job, const std::filesystem::path& path)
{
    GltfLayout layout = gltf_layout(job);
    const std::size_t json_bytes = (gltf_json(job, layout, {}).size() + 3) / 4 * 4;
    OutputFile file(path, job.shown);
    Bins bins(job, layout, {&file}, glb_overhead + json_bytes);
    bins.write();
    layout.yarns = std::move(bins).yarns();
    std::string json = gltf_json(job, layout, {});
    json.resize(json_bytes, ' ');
    const auto bin = static_cast<std::uint32_t>(layout.buffers[0]);
    OutputRun run(file, 0);
    run.add("glTF");
    run.put(std::uint32_t(2));
    run.put(static_cast<std::uint32_t>(glb_overhead + json_bytes + bin));
    run.put(static_cast<std::uint32_t>(json_bytes));
    run.add("JSON");
    run.add(json);
    run.put(bin);
    run.add(std::string_view("BIN\0", 4));
    run.flush();
    file.close();
}

void write_gltf(const ExportJob& job, const std::filesystem::path& path, const std::vector<std::filesystem::path>& buffers,
                const std::vector<std::string>& buffer_names)
{
    GltfLayout layout = gltf_layout(job);
    std::vector<std::unique_ptr<OutputFile>> files;
    std::vector<OutputFile*> places;
    for (const auto& buffer : buffers) {
        files.push_back(std::make_unique<OutputFile>(buffer, job.shown));
        places.push_back(files.back().get());
    }
    Bins bins(job, layout, places, 0);
    bins.write();
    for (const auto& bin : files) bin->close();
    layout.yarns = std::move(bins).yarns();
    const std::string json = gltf_json(job, layout, buffer_names);
    OutputFile file(path, job.shown);
    file.write_at(0, json.data(), json.size());
    file.close();
}

} // namespace hygroloom
