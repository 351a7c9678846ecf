// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// OBJ, PLY and STL, in mm with z out of the top face.
#include "core/project/export_private.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

namespace hygroloom {
namespace {

constexpr const char* axes = "x along the weft, y along the warp, z out of the top face";

std::string ply_header(const ExportJob& job, const ExportEstimate& size)
{
    std::string text = fmt::format("ply\nformat binary_little_endian 1.0\ncomment Hygroloom. Lengths in mm; {}.\nelement vertex {}\n", axes,
                                   size.vertices);
    for (const char* name : {"x", "y", "z"}) text += fmt::format("property float {}\n", name);
    if (!job.lines())
        for (const char* name : {"nx", "ny", "nz", "s", "t"}) text += fmt::format("property float {}\n", name);
    for (const char* name : {"red", "green", "blue"}) text += fmt::format("property uchar {}\n", name);
    if (job.wet()) text += "property float saturation\n";
    if (job.lines())
        text += fmt::format("element edge {}\nproperty int vertex1\nproperty int vertex2\n", size.vertices - size.curves);
    else
        text += fmt::format("element face {}\nproperty list uchar int vertex_indices\n", size.triangles);
    return text + "end_header\n";
}

std::size_t ply_vertex_bytes(const ExportJob& job) { return (job.lines() ? 12u : 32u) + 3u + (job.wet() ? 4u : 0u); }

ExportEstimate counts(const ExportJob& job)
{
    ExportEstimate size;
    const MeshSize mesh = stream_size(job.textile, job.options.mesh);
    size.vertices = mesh.vertices;
    size.triangles = mesh.triangles;
    if (job.lines()) size.curves = static_cast<std::size_t>(job.textile.ends() + job.textile.picks());
    return size;
}

void append_vector(std::string& text, const char* key, const float* values, int count, double scale, int decimals)
{
    text += key;
    for (int i = 0; i < count; ++i) {
        text += ' ';
        append_decimal(text, scale * static_cast<double>(values[i]), decimals);
    }
}

void append_color(std::string& text, const Color& color)
{
    for (std::uint8_t value : {color.red, color.green, color.blue}) {
        text += ' ';
        append_decimal(text, value / 255.0, 4);
    }
}

void write_materials(const ExportJob& job, const std::filesystem::path& path)
{
    std::string text = "# Hygroloom\n";
    for (const YarnMaterial& material : job.materials) {
        text += "newmtl " + material.name + "\nKd";
        append_color(text, material.color);
        text += "\nKs 0 0 0\nillum 1\n\n";
    }
    OutputFile file(path, job.shown);
    file.write_at(0, text.data(), text.size());
    file.close();
}

/// The lines of an OBJ, piece after piece.
class ObjText {
public:
    ObjText(const ExportJob& job, OutputRun& run) : job_(job), run_(run) {}

    void add(const YarnMesh& piece)
    {
        const MeshGroup& group = piece.groups[0];
        if (group.name != name_) begin(group);
        add_vertices(piece, group);
        if (job_.lines()) add_line(group);
        add_faces(piece);
        spill(1);
        first_ += group.vertices;
    }

private:
    void begin(const MeshGroup& group)
    {
        name_ = group.name;
        text_ += "g " + name_ + "\n";
        if (!job_.wet()) text_ += "usemtl " + job_.materials[static_cast<std::size_t>(job_.material(group.kind, group.yarn))].name + "\n";
    }
    void add_vertices(const YarnMesh& piece, const MeshGroup& group)
    {
        for (std::size_t i = 0; i < group.vertices; ++i) {
            append_vector(text_, "v", &piece.positions[3 * i], 3, 1000, 5);
            if (job_.wet()) append_color(text_, job_.color(group.kind, group.yarn, piece.segment_of_vertex[i]));
            text_ += '\n';
            spill(1 << 20);
            if (job_.lines()) continue;
            append_vector(text_, "vt", &piece.uvs[2 * i], 2, 1, 4);
            append_vector(text_, "\nvn", &piece.normals[3 * i], 3, 1, 4);
            text_ += '\n';
        }
    }
    void add_line(const MeshGroup& group)
    {
        text_ += 'l';
        for (std::size_t i = 0; i < group.vertices; ++i) {
            text_ += ' ';
            append_whole(text_, first_ + i);
        }
        text_ += '\n';
    }
    void add_faces(const YarnMesh& piece)
    {
        for (std::size_t i = 0; i < piece.indices.size(); i += 3) {
            text_ += 'f';
            for (std::size_t corner = i; corner < i + 3; ++corner) {
                const std::uint64_t number = first_ + piece.indices[corner];
                for (char separator : {' ', '/', '/'}) {
                    text_ += separator;
                    append_whole(text_, number);
                }
            }
            text_ += '\n';
            spill(1 << 20);
        }
    }
    void spill(std::size_t most)
    {
        if (text_.size() < most) return;
        run_.add(text_);
        text_.clear();
    }

    const ExportJob& job_;
    OutputRun& run_;
    std::string text_, name_;
    std::uint64_t first_ = 1; // vertices are numbered from 1
};

} // namespace

double obj_bytes(const ExportJob& job, const ExportEstimate& size)
{
    // A vertex: "v -12.34567 -12.34567 -0.12345", "vt 123.125 0.9167", "vn -0.1234 -0.1234 -0.1234"; a corner: " 123456/123456/123456".
    const auto vertices = static_cast<double>(size.vertices), triangles = static_cast<double>(size.triangles);
    const double digits = std::ceil(std::log10(std::max(10.0, 0.7 * vertices)));
    const double water = job.wet() ? 19 * vertices : 0;
    if (job.lines()) return (24 + digits + 1) * vertices + water;
    return (25 + 14 + 23) * vertices + water + (2 + 3 * (3 * digits + 3)) * triangles;
}

void write_obj(const ExportJob& job, const std::filesystem::path& path, const std::filesystem::path& materials,
               const std::string& materials_name)
{
    if (!job.wet()) write_materials(job, materials);
    OutputFile file(path, job.shown);
    OutputRun run(file, 0);
    run.add(fmt::format("# Hygroloom. Lengths in mm; {}.\n", axes));
    if (!job.wet()) run.add("mtllib " + materials_name + "\n");
    ObjText text(job, run);
    for_each_piece(job, [&](const YarnMesh& piece) { text.add(piece); });
    run.flush();
    file.close();
}

double ply_bytes(const ExportJob& job, const ExportEstimate& size)
{
    const std::size_t faces = job.lines() ? 8 * (size.vertices - size.curves) : 13 * size.triangles;
    return static_cast<double>(ply_header(job, size).size() + ply_vertex_bytes(job) * size.vertices + faces);
}

void write_ply(const ExportJob& job, const std::filesystem::path& path)
{
    const ExportEstimate size = counts(job);
    const std::string header = ply_header(job, size);
    const std::size_t stride = ply_vertex_bytes(job);
    OutputFile file(path, job.shown);
    OutputRun vertices(file, 0), faces(file, header.size() + stride * size.vertices);
    vertices.add(header);
    std::size_t first = 0;
    for_each_piece(job, [&](const YarnMesh& piece) {
        const MeshGroup& group = piece.groups[0];
        char* out = vertices.room(stride * group.vertices);
        for (std::size_t i = 0; i < group.vertices; ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const float mm = 1000 * piece.positions[3 * i + axis];
                std::memcpy(out + 4 * axis, &mm, 4);
            }
            out += 12;
            if (!job.lines()) {
                std::memcpy(out, &piece.normals[3 * i], 12);
                std::memcpy(out + 12, &piece.uvs[2 * i], 8);
                out += 20;
            }
            const Color color = job.color(group.kind, group.yarn, piece.segment_of_vertex[i]);
            *out++ = static_cast<char>(color.red);
            *out++ = static_cast<char>(color.green);
            *out++ = static_cast<char>(color.blue);
            if (job.wet()) {
                std::memcpy(out, &job.options.saturation[piece.segment_of_vertex[i]], 4);
                out += 4;
            }
        }
        if (job.lines()) {
            for (std::size_t i = 0; i + 1 < group.vertices; ++i)
                for (std::size_t end : {i, i + 1}) faces.put(static_cast<std::int32_t>(first + end));
        } else {
            const std::size_t triangles = piece.indices.size() / 3;
            char* face = faces.room(13 * triangles);
            for (std::size_t i = 0; i < triangles; ++i) {
                *face++ = 3;
                for (std::size_t corner = 0; corner < 3; ++corner, face += 4) {
                    const auto index = static_cast<std::int32_t>(first + piece.indices[3 * i + corner]);
                    std::memcpy(face, &index, 4);
                }
            }
        }
        first += group.vertices;
    });
    vertices.flush();
    faces.flush();
    file.close();
}

double stl_bytes(const ExportEstimate& size) { return 84 + 50.0 * static_cast<double>(size.triangles); }

void write_stl(const ExportJob& job, const std::filesystem::path& path)
{
    OutputFile file(path, job.shown);
    OutputRun run(file, 0);
    std::string header = "Hygroloom. Lengths in mm; z out of the top face."; // never "solid": readers take that for text
    header.resize(80, ' ');
    run.add(header);
    run.put(static_cast<std::uint32_t>(counts(job).triangles));
    for_each_piece(job, [&](const YarnMesh& piece) {
        const std::size_t triangles = piece.indices.size() / 3;
        char* out = run.room(50 * triangles);
        for (std::size_t i = 0; i < triangles; ++i, out += 50) {
            Vec3T<float> corners[3];
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const float* p = &piece.positions[3 * std::size_t(piece.indices[3 * i + corner])];
                corners[corner] = {1000 * p[0], 1000 * p[1], 1000 * p[2]};
            }
            Vec3T<float> normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
            normal = (1 / std::max(length(normal), 1e-30f)) * normal;
            std::memcpy(out, &normal, 12);
            std::memcpy(out + 12, corners, 36);
            out[48] = out[49] = 0;
        }
    });
    run.flush();
    file.close();
}

} // namespace hygroloom
