// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// FBX and Collada through Assimp's exporters, which want the whole scene in memory and copy it. Assimp 5.2.5's binary FBX needs mending: it
// lacks the records that end a list of nodes.
#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "core/project/export_private.h"

#include <assimp/Exporter.hpp>
#include <assimp/scene.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace hygroloom {
namespace {

/// From the textile's axes, in m, to the format's, with y up and FBX in cm.
aiVector3D turned(const float* v) { return {v[0], v[2], -v[1]}; }
float scale_of(MeshFormat format) { return format == MeshFormat::fbx ? 100 : 1; }

/// A yarn's mesh while its pieces come in.
struct YarnPart {
    std::unique_ptr<aiMesh> mesh;
    std::size_t vertices = 0, faces = 0; ///< filled
};

YarnPart new_part(const ExportJob& job, const MeshGroup& group)
{
    const MeshSize size = job.size_of(group.kind, group.yarn);
    YarnPart part;
    part.mesh = std::make_unique<aiMesh>();
    aiMesh& mesh = *part.mesh;
    mesh.mName = group.name;
    mesh.mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    mesh.mMaterialIndex = static_cast<unsigned>(job.material(group.kind, group.yarn));
    mesh.mNumVertices = static_cast<unsigned>(size.vertices);
    mesh.mVertices = new aiVector3D[size.vertices];
    mesh.mNormals = new aiVector3D[size.vertices];
    mesh.mTextureCoords[0] = new aiVector3D[size.vertices];
    mesh.mNumUVComponents[0] = 2;
    if (job.wet()) mesh.mColors[0] = new aiColor4D[size.vertices];
    mesh.mNumFaces = static_cast<unsigned>(size.triangles);
    mesh.mFaces = new aiFace[size.triangles];
    return part;
}

void fill(const ExportJob& job, const YarnMesh& piece, YarnPart& part)
{
    aiMesh& mesh = *part.mesh;
    const MeshGroup& group = piece.groups[0];
    for (std::size_t i = 0; i < group.vertices; ++i) {
        const std::size_t v = part.vertices + i;
        mesh.mVertices[v] = scale_of(job.format) * turned(&piece.positions[3 * i]);
        mesh.mNormals[v] = turned(&piece.normals[3 * i]);
        mesh.mTextureCoords[0][v] = {piece.uvs[2 * i], piece.uvs[2 * i + 1], 0};
        if (!job.wet()) continue;
        const Color color = job.color(group.kind, group.yarn, piece.segment_of_vertex[i]);
        mesh.mColors[0][v] = {static_cast<float>(color.red) / 255, static_cast<float>(color.green) / 255,
                              static_cast<float>(color.blue) / 255, 1};
    }
    for (std::size_t i = 0; i < piece.indices.size(); i += 3) {
        aiFace& face = mesh.mFaces[part.faces++];
        face.mNumIndices = 3;
        face.mIndices = new unsigned[3];
        for (std::size_t corner = 0; corner < 3; ++corner)
            face.mIndices[corner] = static_cast<unsigned>(part.vertices) + piece.indices[i + corner];
    }
    part.vertices += group.vertices;
}

/// The scene owns everything in it.
void fill_scene(const ExportJob& job, aiScene& scene, std::vector<YarnPart>& parts)
{
    scene.mNumMaterials = static_cast<unsigned>(job.materials.size());
    scene.mMaterials = new aiMaterial*[job.materials.size()];
    for (std::size_t i = 0; i < job.materials.size(); ++i) {
        const aiString name(job.materials[i].name);
        const Color color = job.materials[i].color;
        const aiColor4D diffuse(static_cast<float>(color.red) / 255, static_cast<float>(color.green) / 255,
                                static_cast<float>(color.blue) / 255, 1);
        scene.mMaterials[i] = new aiMaterial;
        scene.mMaterials[i]->AddProperty(&name, AI_MATKEY_NAME);
        scene.mMaterials[i]->AddProperty(&diffuse, 1, AI_MATKEY_COLOR_DIFFUSE);
    }
    const auto count = static_cast<unsigned>(parts.size());
    scene.mNumMeshes = count;
    scene.mMeshes = new aiMesh*[count];
    scene.mRootNode = new aiNode("textile");
    scene.mRootNode->mNumChildren = count;
    scene.mRootNode->mChildren = new aiNode*[count];
    for (unsigned i = 0; i < count; ++i) {
        scene.mMeshes[i] = parts[i].mesh.release();
        auto* node = new aiNode(scene.mMeshes[i]->mName.C_Str());
        node->mParent = scene.mRootNode;
        node->mNumMeshes = 1;
        node->mMeshes = new unsigned[1]{i};
        scene.mRootNode->mChildren[i] = node;
    }
}

/// A binary FBX of version 7.5 with a record of zeros after each list of nodes, as readers expect it.
class MendedFbx {
public:
    explicit MendedFbx(const std::string& given) : given_(given)
    {
        std::size_t place = 27; // after the magic word and the version
        mended_.assign(given, 0, place);
        while (number(place) > place && number(place) <= given.size()) place = node(place);
        // The foot: an identity, zeros to a multiple of 16, version, 120 zeros and a magic word.
        mended_.append(record, '\0');
        mended_.append(given, place, 16);
        mended_.append(4, '\0');
        mended_.append(16 - mended_.size() % 16, '\0');
        mended_.append(given, given.size() - 140, 140);
    }
    const std::string& bytes() const { return mended_; }

private:
    static constexpr std::size_t record = 25;

    std::uint64_t number(std::size_t place) const
    {
        std::uint64_t value = 0;
        if (place + sizeof value <= given_.size()) std::memcpy(&value, &given_[place], sizeof value);
        return value;
    }

    /// Copies a node: its end, the number and the bytes of its properties, its name, the properties, nodes inside. Returns its end.
    std::size_t node(std::size_t place)
    {
        const std::size_t begin = mended_.size();
        const auto end = static_cast<std::size_t>(number(place));
        const std::size_t head = record + static_cast<unsigned char>(given_[place + 24]) + static_cast<std::size_t>(number(place + 16));
        mended_.append(given_, place, head);
        place += head;
        if (place < end) {
            while (place < end) place = node(place);
            mended_.append(record, '\0');
        }
        const std::uint64_t new_end = mended_.size();
        std::memcpy(&mended_[begin], &new_end, sizeof new_end);
        return end;
    }

    const std::string& given_;
    std::string mended_;
};

} // namespace

void write_scene(const ExportJob& job, const std::filesystem::path& path)
{
    {
        aiScene scene;
        std::vector<YarnPart> parts;
        for_each_piece(job, [&](const YarnMesh& piece) {
            const MeshGroup& group = piece.groups[0];
            if (parts.empty() || group.name != parts.back().mesh->mName.C_Str()) parts.push_back(new_part(job, group));
            fill(job, piece, parts.back());
        });
        fill_scene(job, scene, parts);
        Assimp::Exporter exporter;
        if (exporter.Export(&scene, job.format == MeshFormat::fbx ? "fbx" : "collada", path.string()) != aiReturn_SUCCESS)
            throw FileError(job.shown + ": The file cannot be made: " + exporter.GetErrorString());
    }
    if (job.format != MeshFormat::fbx) return;
    const std::string given = read_file(path, std::numeric_limits<std::size_t>::max());
    const MendedFbx mended(given);
    OutputFile file(path, job.shown);
    file.write_at(0, mended.bytes().data(), mended.bytes().size());
    file.close();
}

double scene_bytes(const ExportJob& job, const ExportEstimate& size)
{
    const auto v = static_cast<double>(size.vertices), t = static_cast<double>(size.triangles), yarns = static_cast<double>(size.yarns);
    const double water = job.wet() ? 1 : 0;
    return job.format == MeshFormat::fbx ? 1e4 + 2000 * yarns + 40 * v + 96 * t + water * 96 * t
                                         : 1e3 + 1500 * yarns + 80 * v + 20 * t + water * 30 * v;
}

double scene_memory(const ExportJob& job, const ExportEstimate& size)
{
    // The scene and Assimp's copy of it, and so often the text it puts together; measured at 0.25 to 1 million vertices.
    const auto v = static_cast<double>(size.vertices), t = static_cast<double>(size.triangles);
    return 20e6 + 2 * ((36 + (job.wet() ? 16 : 0)) * v + 48 * t) + 2.1 * scene_bytes(job, size);
}

} // namespace hygroloom
