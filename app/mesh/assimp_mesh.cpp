// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/mesh/assimp_mesh.h"

#include "core/base/text.h"
#include "core/base/utf8.h"
#include "core/garment/mesh_builder.h"

#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <exception>
#include <new>

namespace hygroloom {

namespace {

constexpr int deepest_node = 200;

/// How MeshBuilder counts names.
enum : std::size_t { of_node, of_mesh, of_material };

/// No file but the one that was handed over.
class NoFiles : public Assimp::IOSystem {
public:
    bool Exists(const char*) const override { return false; }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
    void Close(Assimp::IOStream*) override {}
};

class SceneReader {
public:
    SceneReader(const aiScene& scene, const std::string& name) : scene_(scene), mesh_(name) {}
    FlatMesh read()
    {
        visit(*scene_.mRootNode, aiMatrix4x4(), 0);
        return mesh_.finish(0);
    }

private:
    void visit(const aiNode& node, const aiMatrix4x4& above, int depth)
    {
        if (depth > deepest_node) mesh_.refuse(fmt::format("The file's nodes are nested deeper than {} levels.", deepest_node));
        const aiMatrix4x4 own = above * node.mTransformation;
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            if (node.mMeshes[i] >= scene_.mNumMeshes) mesh_.refuse("A node names a mesh that is not there.");
            add(*scene_.mMeshes[node.mMeshes[i]], own, node.mName);
        }
        for (unsigned i = 0; i < node.mNumChildren; ++i) visit(*node.mChildren[i], own, depth + 1);
    }

    void add(const aiMesh& mesh, const aiMatrix4x4& own, const aiString& node)
    {
        if (!mesh.HasTextureCoords(0)) {
            for (unsigned f = 0; f < mesh.mNumFaces; ++f) mesh_.add_face_without_flat();
            return;
        }
        mesh_.name(of_node, text_of(node));
        mesh_.name(of_mesh, text_of(mesh.mName));
        mesh_.name(of_material,
                   mesh.mMaterialIndex < scene_.mNumMaterials ? text_of(scene_.mMaterials[mesh.mMaterialIndex]->GetName()) : "");
        const auto first = static_cast<unsigned>(mesh_.places());
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            const aiVector3D p = own * mesh.mVertices[i], &uv = mesh.mTextureCoords[0][i];
            mesh_.add_place({p.x, p.y, p.z});
            mesh_.add_flat({uv.x, uv.y});
        }
        const bool is_mirrored = aiMatrix3x3(own).Determinant() < 0; // then faces go round the other way
        std::vector<MeshBuilder::Corner> corners;
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            corners.clear();
            for (unsigned k = 0; k < face.mNumIndices; ++k) {
                const unsigned at = face.mIndices[is_mirrored ? face.mNumIndices - 1 - k : k];
                if (at >= mesh.mNumVertices) mesh_.refuse("A face names a vertex that is not there.");
                corners.push_back({static_cast<int>(first + at), static_cast<int>(first + at)});
            }
            mesh_.add_face(corners);
        }
    }

    static std::string text_of(const aiString& text) { return {text.C_Str(), text.length}; }

    const aiScene& scene_;
    MeshBuilder mesh_;
};

} // namespace

FlatMesh mesh_by_assimp(std::string_view bytes, const std::string& format, const std::string& name)
{
    const MeshBuilder empty(name);
    const auto refuse = [&empty](const char* why) {
        std::string text = in_one_line(cut_text(why, 200));
        if (text.find("bad_alloc") != std::string::npos) throw std::bad_alloc(); // which the library catches
        while (text.ends_with('.') || text.ends_with(' ')) text.pop_back();
        empty.refuse(fmt::format("The file cannot be read: {}.", text));
    };
    Assimp::Importer importer;
    importer.SetIOHandler(new NoFiles); // which the importer deletes
    // Others would be tried where the file does not begin as its format does.
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;)
        if (std::string_view(importer.GetImporterInfo(i)->mFileExtensions).find(format) == std::string_view::npos)
            importer.UnregisterLoader(importer.GetImporter(i));
    const aiScene* scene = nullptr;
    try {
        scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_ValidateDataStructure, format.c_str());
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        refuse(error.what());
    }
    if (scene == nullptr || scene->mRootNode == nullptr) refuse(importer.GetErrorString());
    return SceneReader(*scene, name).read();
}

} // namespace hygroloom
