// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/project/mesh_file.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"

#include <assimp/Exporter.hpp>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {
namespace {

/// From the textile's metres and axes to the format's.
aiVector3D turned(MeshFormat format, const float* v)
{
    return format == MeshFormat::glb ? aiVector3D(v[0], v[2], -v[1]) : aiVector3D(v[0], v[1], v[2]);
}

float scale_of(MeshFormat format) { return format == MeshFormat::glb ? 1.0f : 1000.0f; }

aiMesh* new_mesh(const std::string& name, std::size_t vertices, std::size_t faces, bool lines)
{
    auto* mesh = new aiMesh;
    mesh->mName = name;
    mesh->mPrimitiveTypes = lines ? aiPrimitiveType_LINE : aiPrimitiveType_TRIANGLE;
    mesh->mNumVertices = static_cast<unsigned>(vertices);
    mesh->mVertices = new aiVector3D[vertices];
    mesh->mNumFaces = static_cast<unsigned>(faces);
    mesh->mFaces = new aiFace[faces];
    return mesh;
}

void set_face(aiFace& face, std::initializer_list<unsigned> corners)
{
    face.mNumIndices = static_cast<unsigned>(corners.size());
    face.mIndices = new unsigned[corners.size()];
    std::copy(corners.begin(), corners.end(), face.mIndices);
}

std::vector<aiMesh*> yarn_meshes(const Textile& textile, const MeshOptions& options, MeshFormat format)
{
    const YarnMesh yarns = mesh_yarns(textile, options.samples_per_crossing, options.sides);
    std::vector<aiMesh*> meshes;
    for (const MeshGroup& group : yarns.groups) {
        aiMesh* mesh = new_mesh(group.name, group.vertices, group.indices / 3, false);
        mesh->mNormals = new aiVector3D[group.vertices];
        mesh->mTextureCoords[0] = new aiVector3D[group.vertices];
        mesh->mNumUVComponents[0] = 2;
        for (std::size_t i = 0; i < group.vertices; ++i) {
            const std::size_t v = group.first_vertex + i;
            mesh->mVertices[i] = scale_of(format) * turned(format, &yarns.positions[3 * v]);
            mesh->mNormals[i] = turned(format, &yarns.normals[3 * v]);
            mesh->mTextureCoords[0][i] = {yarns.uvs[2 * v], yarns.uvs[2 * v + 1], 0};
        }
        const auto first = static_cast<unsigned>(group.first_vertex);
        for (std::size_t i = 0; i < group.indices; i += 3) {
            const std::uint32_t* corner = &yarns.indices[group.first_index + i];
            set_face(mesh->mFaces[i / 3], {corner[0] - first, corner[1] - first, corner[2] - first});
        }
        meshes.push_back(mesh);
    }
    return meshes;
}

std::vector<aiMesh*> line_meshes(const Textile& textile, const MeshOptions& options, MeshFormat format)
{
    std::vector<aiMesh*> meshes;
    for (const YarnLine& line : yarn_lines(textile, options.samples_per_crossing)) {
        const std::size_t points = line.positions.size() / 3;
        aiMesh* mesh = new_mesh(line.name, points, points - 1, true);
        for (std::size_t i = 0; i < points; ++i) mesh->mVertices[i] = scale_of(format) * turned(format, &line.positions[3 * i]);
        for (unsigned i = 0; i + 1 < points; ++i) set_face(mesh->mFaces[i], {i, i + 1});
        meshes.push_back(mesh);
    }
    return meshes;
}

/// The scene owns everything in it.
void fill_scene(aiScene& scene, const std::vector<aiMesh*>& meshes)
{
    scene.mNumMaterials = 1;
    scene.mMaterials = new aiMaterial* [1] { new aiMaterial };
    const aiString name("yarn");
    scene.mMaterials[0]->AddProperty(&name, AI_MATKEY_NAME);
    scene.mNumMeshes = static_cast<unsigned>(meshes.size());
    scene.mMeshes = new aiMesh*[meshes.size()];
    std::copy(meshes.begin(), meshes.end(), scene.mMeshes);
    scene.mRootNode = new aiNode("textile");
    scene.mRootNode->mNumChildren = scene.mNumMeshes;
    scene.mRootNode->mChildren = new aiNode*[meshes.size()];
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        auto* node = new aiNode(meshes[i]->mName.C_Str());
        node->mParent = scene.mRootNode;
        node->mNumMeshes = 1;
        node->mMeshes = new unsigned[1]{i};
        scene.mRootNode->mChildren[i] = node;
    }
}

const char* exporter_of(MeshFormat format)
{
    switch (format) {
    case MeshFormat::obj: return "objnomtl";
    case MeshFormat::ply: return "plyb";
    case MeshFormat::stl: return "stlb";
    default: return "glb2"; // Assimp's "glb" is version 1
    }
}

} // namespace

MeshFormat mesh_format_of(const std::filesystem::path& path)
{
    const std::string ending = path.extension().string();
    if (ending == ".obj") return MeshFormat::obj;
    if (ending == ".ply") return MeshFormat::ply;
    if (ending == ".stl") return MeshFormat::stl;
    if (ending == ".glb") return MeshFormat::glb;
    throw Error("A mesh is written as .obj, .ply, .stl or .glb; \"" + path.filename().string() + "\" ends otherwise.");
}

MeshFileSize mesh_file_size(const Textile& textile, MeshFormat format, const MeshOptions& options)
{
    MeshFileSize size;
    size.yarns = static_cast<std::size_t>(textile.ends() + textile.picks());
    if (options.detail == MeshDetail::centreline) {
        const auto pieces = static_cast<std::size_t>(textile.segments()) * static_cast<std::size_t>(options.samples_per_crossing);
        size.vertices = pieces + size.yarns;
        size.triangles = pieces;
        size.bytes = 800.0 * static_cast<double>(size.yarns) + (format == MeshFormat::obj ? 45.0 : 20.0) * static_cast<double>(pieces);
        return size;
    }
    const MeshSize mesh = mesh_size(textile, options.samples_per_crossing, options.sides);
    size.vertices = mesh.vertices;
    size.triangles = mesh.triangles;
    const auto v = static_cast<double>(mesh.vertices), t = static_cast<double>(mesh.triangles);
    switch (format) {
    case MeshFormat::obj: size.bytes = 55 * v + 40 * t; break;
    case MeshFormat::ply: size.bytes = 32 * v + 13 * t; break;
    case MeshFormat::stl: size.bytes = 50 * t + 84; break;
    case MeshFormat::glb: size.bytes = 32 * v + 12 * t + 1500.0 * static_cast<double>(size.yarns); break;
    }
    return size;
}

void write_mesh(const Textile& textile, const MeshOptions& options, const std::filesystem::path& path)
{
    const MeshFormat format = mesh_format_of(path);
    if (format == MeshFormat::stl && options.detail == MeshDetail::centreline)
        throw Error("STL holds triangles only; write centrelines as .obj, .ply or .glb.");
    const MeshFileSize size = mesh_file_size(textile, format, options);
    if (size.bytes > largest_mesh_bytes)
        throw Error(fmt::format("The file would have about {:.1f} GB; at most {:.0f} GB are written. Take a smaller piece.",
                                1e-9 * size.bytes, 1e-9 * largest_mesh_bytes));
    aiScene scene;
    fill_scene(scene, options.detail == MeshDetail::yarn ? yarn_meshes(textile, options, format) : line_meshes(textile, options, format));
    Assimp::Exporter exporter;
    const aiExportDataBlob* blob = exporter.ExportToBlob(&scene, exporter_of(format));
    if (!blob) throw FileError(path.string() + ": The mesh cannot be made: " + exporter.GetErrorString());
    std::string bytes;
    if (format == MeshFormat::obj) bytes = "# Hygroloom. Lengths in mm; x along the weft, y along the warp, z out of the top face.\n";
    bytes.append(static_cast<const char*>(blob->data), blob->size);
    write_file(path, bytes);
}

} // namespace hygroloom
