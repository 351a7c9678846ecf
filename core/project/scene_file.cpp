// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// FBX, 3MF, Collada and X3D through Assimp's exporters, which want the whole scene in memory and copy it. Assimp 5.2.5 needs mending:
// its binary FBX lacks the records that end a list of nodes, and its X3D has six decimals whatever the unit.
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

bool z_up(MeshFormat format) { return format == MeshFormat::three_mf; }

/// Of the numbers in the file, per metre.
float scale_of(MeshFormat format)
{
    switch (format) {
    case MeshFormat::three_mf:
    case MeshFormat::x3d: return 1000; // X3D is in metres: a scale stands over the yarns
    case MeshFormat::fbx: return 100;
    default: return 1;
    }
}

const char* exporter_of(MeshFormat format)
{
    switch (format) {
    case MeshFormat::fbx: return "fbx";
    case MeshFormat::three_mf: return "3mf";
    case MeshFormat::collada: return "collada";
    default: return "x3d";
    }
}

/// From the textile's axes to the format's.
aiVector3D turned(MeshFormat format, const float* v) { return z_up(format) ? aiVector3D(v[0], v[1], v[2]) : aiVector3D(v[0], v[2], -v[1]); }

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
        mesh.mVertices[v] = scale_of(job.format) * turned(job.format, &piece.positions[3 * i]);
        mesh.mNormals[v] = turned(job.format, &piece.normals[3 * i]);
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
        // Assimp 5.2.5 writes every colour of a 3MF as black but white.
        const Color color = job.format == MeshFormat::three_mf ? Color{255, 255, 255} : job.materials[i].color;
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
    if (job.format == MeshFormat::x3d) aiMatrix4x4::Scaling(aiVector3D(0.001f), scene.mRootNode->mTransformation);
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
        if (exporter.Export(&scene, exporter_of(job.format), path.string()) != aiReturn_SUCCESS)
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
    switch (job.format) {
    case MeshFormat::fbx: return 1e4 + 2000 * yarns + 40 * v + 96 * t + water * 96 * t;
    case MeshFormat::three_mf: return 1e3 + 9 * v + 4.5 * t;
    case MeshFormat::collada: return 1e3 + 1500 * yarns + 80 * v + 20 * t + water * 30 * v;
    default: return 1e3 + 500 * yarns + 80 * v + 25 * t + water * 30 * v;
    }
}

double scene_memory(const ExportJob& job, const ExportEstimate& size)
{
    // The scene and Assimp's copy of it, and so often the text it puts together; measured at 0.25 to 1 million vertices.
    const auto v = static_cast<double>(size.vertices), t = static_cast<double>(size.triangles);
    const double scenes = 2 * ((36 + (job.wet() ? 16 : 0)) * v + 48 * t);
    double text = scene_bytes(job, size);
    switch (job.format) {
    case MeshFormat::three_mf: text = 2.5 * (41 * v + 45 * t); break; // before it is packed
    case MeshFormat::x3d: text *= 0.3; break;
    default: text *= 2.1;
    }
    return 20e6 + scenes + text;
}

} // namespace hygroloom
