// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Meshes that Assimp reads.
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/utf8.h"
#include "core/garment/flat_mesh.h"
#include "core/garment/readers.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace hygroloom {

namespace {

constexpr int deepest_node = 200;

/// What the mesh's file names, such as the buffers of glTF, is opened in its own folder only, as regular files, and all of them together
/// may be as large as one may be.
class OwnFolder : public Assimp::DefaultIOSystem {
public:
    explicit OwnFolder(const std::filesystem::path& file)
    {
        std::error_code failure; // then nothing lies within
        folder_ = std::filesystem::weakly_canonical(file, failure).parent_path();
    }
    bool Exists(const char* file) const override { return is_within(file) && DefaultIOSystem::Exists(file); }
    Assimp::IOStream* Open(const char* file, const char* mode) override
    {
        std::error_code failure;
        if (!is_within(file) || !std::filesystem::is_regular_file(file, failure)) return nullptr;
        opened_ += std::filesystem::file_size(file, failure);
        return failure || opened_ > 2 * largest_mesh_bytes ? nullptr : DefaultIOSystem::Open(file, mode); // some are opened twice
    }

private:
    bool is_within(const char* file) const
    {
        std::error_code failure;
        const std::filesystem::path inside = std::filesystem::weakly_canonical(file, failure).lexically_relative(folder_);
        return !failure && !inside.empty() && *inside.begin() != "..";
    }

    std::filesystem::path folder_;
    std::uintmax_t opened_ = 0;
};

class SceneReader {
public:
    SceneReader(const aiScene& scene, const std::string& name) : scene_(scene), name_(name) {}
    FlatMesh read(double metre)
    {
        mesh_.metre = metre;
        visit(*scene_.mRootNode, aiMatrix4x4(), 0);
        if (mesh_.triangles.empty())
            throw FileError(without_uv_ > 0 ? name_ + ": The mesh has no flat coordinates (UV); without them its panels are not known."
                                            : name_ + ": The file has no faces.");
        if (without_uv_ > 0) mesh_.issues.push_back(fmt::format("{} faces have no flat coordinates and were left out.", without_uv_));
        label();
        return std::move(mesh_);
    }

private:
    void visit(const aiNode& node, const aiMatrix4x4& above, int depth)
    {
        if (depth > deepest_node)
            throw FileError(fmt::format("{}: The file's nodes are nested deeper than {} levels.", name_, deepest_node));
        const aiMatrix4x4 own = above * node.mTransformation;
        for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], own, node.mName);
        for (unsigned i = 0; i < node.mNumChildren; ++i) visit(*node.mChildren[i], own, depth + 1);
    }

    void add(const aiMesh& mesh, const aiMatrix4x4& own, const aiString& node)
    {
        if (!mesh.HasTextureCoords(0)) {
            without_uv_ += mesh.mNumFaces;
            return;
        }
        if (mesh_.places.size() + mesh.mNumVertices > most_mesh_places || mesh_.triangles.size() + mesh.mNumFaces > most_mesh_triangles)
            throw FileError(fmt::format("{}: A mesh has up to {} places and {} triangles; this one has more.", name_, most_mesh_places,
                                        most_mesh_triangles));
        const int first = static_cast<int>(mesh_.places.size());
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            const aiVector3D p = own * mesh.mVertices[i], &uv = mesh.mTextureCoords[0][i];
            for (const float number : {p.x, p.y, p.z, uv.x, uv.y})
                if (!(std::abs(number) < 1e12f)) throw FileError(name_ + ": A place of the mesh is no number, or beyond 1e12.");
            mesh_.places.push_back({p.x, p.y, p.z});
            mesh_.uv.push_back({uv.x, uv.y});
        }
        const int part = static_cast<int>(parts_.size());
        const aiMaterial* material = mesh.mMaterialIndex < scene_.mNumMaterials ? scene_.mMaterials[mesh.mMaterialIndex] : nullptr;
        parts_.push_back({text_of(node), text_of(mesh.mName), material ? text_of(material->GetName()) : std::string()});
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices != 3) continue;
            std::array<int, 3> triangle{};
            for (unsigned k = 0; k < 3; ++k) {
                if (face.mIndices[k] >= mesh.mNumVertices) throw FileError(name_ + ": A face names a vertex that is not there.");
                triangle[k] = first + static_cast<int>(face.mIndices[k]);
            }
            mesh_.triangles.push_back(triangle);
            mesh_.uv_triangles.push_back(triangle);
            mesh_.label.push_back(part);
        }
    }

    static std::string text_of(const aiString& text) { return in_whole_utf8(cut_text(std::string_view(text.C_Str()), 100)); }

    /// Names panels by the first of nodes, meshes and materials that has several names.
    void label()
    {
        std::size_t kind = 0;
        for (; kind < 3; ++kind) {
            std::map<std::string, int> names;
            for (const auto& part : parts_) names[part[kind]] = 1;
            if (names.size() > 1) break;
        }
        for (const auto& part : parts_) mesh_.labels.push_back(part[kind % 3]);
    }

    const aiScene& scene_;
    const std::string& name_;
    FlatMesh mesh_;
    std::vector<std::array<std::string, 3>> parts_; ///< node, mesh, material
    std::size_t without_uv_ = 0;
};

} // namespace

FlatMesh mesh_from_file(const std::filesystem::path& path)
{
    const std::string name = path.string();
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char letter) { return std::tolower(letter); });
    const std::vector<std::string> known{".glb", ".gltf", ".fbx", ".ply", ".dae"};
    if (std::find(known.begin(), known.end(), ending) == known.end())
        throw FileError(
            fmt::format("{}: A garment is read from .json, .obj, .glb, .gltf, .fbx, .ply or .dae; given is \"{}\".", name, ending));
    std::error_code failure;
    const auto size = std::filesystem::file_size(path, failure);
    if (failure) throw FileError(fmt::format("{}: The file cannot be read: {}.", name, failure.message()));
    if (size == 0) throw FileError(name + ": The file is empty.");
    if (size > largest_mesh_bytes)
        throw FileError(fmt::format("{}: The file has {}; up to 537 MB are read.", name, bytes_text(static_cast<double>(size))));
    Assimp::Importer importer;
    importer.SetIOHandler(new OwnFolder(path)); // which the importer deletes
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = nullptr;
    try {
        scene = importer.ReadFile(name, aiProcess_Triangulate | aiProcess_SortByPType);
    } catch (const std::exception& error) {
        throw FileError(fmt::format("{}: The file cannot be read: {}", name, error.what()));
    }
    if (scene == nullptr || scene->mRootNode == nullptr)
        throw FileError(fmt::format("{}: The file cannot be read: {}", name, in_whole_utf8(cut_text(importer.GetErrorString(), 200))));
    return SceneReader(*scene, name).read(ending == ".glb" || ending == ".gltf" ? 1 : 0);
}

} // namespace hygroloom
